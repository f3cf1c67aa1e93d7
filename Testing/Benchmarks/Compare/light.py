#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""Time and error of ambient occlusion: the first frame, turning frames, and a still view.

Prints a table in Markdown. Frames without occlusion are made in turns with the others, in the same
views. Errors are mean differences from the final picture, in steps of a byte.

usage: light.py [VOLUME:ISOVALUE]...    with the package vtkTemporalCoherence in PYTHONPATH
"""

from __future__ import annotations

import statistics
import sys
import time

import numpy
import volumes
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkRenderingCore import vtkColorTransferFunction, vtkRenderer, vtkVolume
from vtkTemporalCoherence import vtkTemporalCoherenceVolumeMapper

VOLUMES = ("engine.vti:70", "bonsai.vti:40", "brain.vti:40", "cthead.vti:600", "aneurism.vti:60")
SIZE = 1024
TURNS = 30
VIEWS = {"whole": 1.3, "close": 2.2}


class Picture:
    """A volume with ambient light alone, so that pixels are what occlusion leaves of white."""

    def __init__(self, image: vtkImageData, isovalue: float, is_occluded: bool):
        self.mapper = vtkTemporalCoherenceVolumeMapper()
        self.mapper.SetInputData(image)
        self.mapper.SetBlendModeToIsoSurface()
        self.mapper.SetAmbientOcclusion(is_occluded)
        self.volume = vtkVolume()
        self.volume.SetMapper(self.mapper)
        look = self.volume.GetProperty()
        look.GetIsoSurfaceValues().SetValue(0, isovalue)
        look.SetInterpolationTypeToLinear()
        look.ShadeOn()
        look.SetAmbient(1.0)
        look.SetDiffuse(0.0)
        look.SetSpecular(0.0)
        white = vtkColorTransferFunction()
        white.AddRGBPoint(0.0, 1.0, 1.0, 1.0)
        look.SetColor(white)
        self.colors = vtkImageData()

    def make(self, renderer: vtkRenderer) -> float:
        """Make a frame; milliseconds."""
        begin = time.perf_counter()
        self.mapper.MakeImage(renderer, self.volume, SIZE, SIZE, self.colors, None)
        return 1e3 * (time.perf_counter() - begin)

    def pixels(self) -> numpy.ndarray:
        """Red, or -1 where nothing is hit."""
        rgba = vtk_to_numpy(self.colors.GetPointData().GetScalars()).astype(int)
        return numpy.where(rgba[:, 3] > 0, rgba[:, 0], -1)


def final_of(picture: Picture, renderer: vtkRenderer) -> tuple[numpy.ndarray, int]:
    """The final picture, and the number of frames that it took."""
    frames = 0
    while not picture.mapper.GetFrameIsFinal():
        picture.make(renderer)
        frames += 1
    return picture.pixels(), frames


def error(pixels: numpy.ndarray, final: numpy.ndarray) -> float:
    return float(numpy.abs(pixels - final)[final >= 0].mean())


def measure(name: str, isovalue: float, view: str) -> str:
    image = volumes.load(name)
    if image is None:
        return f"| {name} | SKIPPED: no such file |"
    plain, lit = Picture(image, isovalue, False), Picture(image, isovalue, True)
    renderer = vtkRenderer()
    camera = renderer.GetActiveCamera()
    renderer.ResetCamera(lit.volume.GetBounds())
    camera.Azimuth(30)
    camera.Elevation(20)
    camera.Zoom(VIEWS[view])
    renderer.ResetCameraClippingRange(lit.volume.GetBounds())
    plain.make(renderer)
    cold, turning, errors = [], [], {}
    for turn in range(TURNS):
        cold.append(plain.make(renderer))
        turning.append(lit.make(renderer))
        if turn in (0, 10, TURNS - 1):
            pixels = lit.pixels()
            truth = Picture(image, isovalue, True)
            truth.make(renderer)
            errors[turn] = error(pixels, final_of(truth, renderer)[0])
        camera.Azimuth(1)
    still = [lit.make(renderer) for _ in range(3)][1:]
    _, frames = final_of(lit, renderer)
    base = statistics.median(cold)
    hits = int((lit.pixels() >= 0).sum())
    return (
        f"| {name}, {isovalue:g}, {view} | {hits / 1e6:.2f} | {base:.0f} | {turning[0] / base:.1f} "
        f"| {statistics.median(turning[10:]) / base:.1f} | {statistics.median(still):.0f} "
        f"| {frames + 3} | {errors[0]:.1f} | {errors[10]:.1f} | {errors[TURNS - 1]:.1f} |")


def main() -> None:
    print("| volume, isovalue, view | hits, million | cold, ms | first / cold | turning / cold "
          "| still, ms | still frames | error: first | after 10 | after 30 |")
    print("|---|---|---|---|---|---|---|---|---|---|")
    for asked in sys.argv[1:] or VOLUMES:
        name, isovalue = asked.rsplit(":", 1)
        for view in VIEWS:
            print(measure(name, float(isovalue), view), flush=True)


if __name__ == "__main__":
    main()
