#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""Time and error of ambient occlusion (the first frame, turning frames, a still view), and the time
of hard shadows of one light (turning frames, new colours of a still view).

Prints a table in Markdown. Frames without both are made in turns with the others, in the same
views. Errors are mean differences from the final picture, in steps of a byte.

usage: light.py [VOLUME:ISOVALUE]...   with the package vtkTemporalCoherence in PYTHONPATH
"""

from __future__ import annotations

import statistics
import sys
import time

import numpy
import volumes
from views import look_at, print_rows
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkRenderingCore import vtkColorTransferFunction, vtkLight, vtkRenderer, vtkVolume
from vtkTemporalCoherence import vtkTemporalCoherenceVolumeMapper

VOLUMES = ("engine.vti:70", "bonsai.vti:40", "brain.vti:40", "cthead.vti:600")
SIZE = 1024
TURNS = 21


class Picture:
    """A volume with ambient light alone, so that pixels are what occlusion leaves of white."""

    def __init__(self, image: vtkImageData, isovalue: float, is_occluded: bool):
        self.mapper = vtkTemporalCoherenceVolumeMapper()
        self.mapper.SetInputData(image)
        self.mapper.SetBlendModeToIsoSurface()
        self.mapper.ProgressiveImagesOn()
        self.mapper.SetAntialiasingToOff()
        self.is_occluded = is_occluded
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

    def set_up(self, renderer: vtkRenderer) -> None:
        """Make frames without occlusion, which build all that cold frames need."""
        for _ in range(3):
            renderer.GetActiveCamera().Azimuth(1)
            self.make(renderer)
        self.mapper.SetAmbientOcclusion(self.is_occluded)

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


def first_frames(image: vtkImageData, isovalue: float, renderer: vtkRenderer) -> float:
    """The first frame of a new mapper with occlusion, by one without. The data are known before."""
    ratios = []
    for _ in range(4):
        times = []
        for is_occluded in (False, True):
            picture = Picture(image, isovalue, is_occluded)
            picture.mapper.SetAmbientOcclusion(is_occluded)
            times.append(picture.make(renderer))
        ratios.append(times[1] / times[0])
    return statistics.median(ratios[1:])


def measure(name: str, isovalue: float, view: str) -> str:
    image = volumes.load(name)
    if image is None:
        return f"| {name} | SKIPPED: no such file |"
    plain, lit = Picture(image, isovalue, False), Picture(image, isovalue, True)
    shadowed = Picture(image, isovalue, False)
    renderer = vtkRenderer()
    light = vtkLight()
    light.SetLightTypeToSceneLight()
    light.SetPosition(1.0, -0.6, 1.4)
    renderer.AddLight(light)
    camera = renderer.GetActiveCamera()
    look_at(renderer, lit.volume.GetBounds(), view)
    for picture in (plain, lit, shadowed):
        picture.set_up(renderer)
    shadowed.mapper.ShadowsOn()
    first = first_frames(image, isovalue, renderer)
    camera.Azimuth(1)
    cold, turning, shadows = [], [], []
    for turn in range(TURNS):
        cold.append(plain.make(renderer))
        turning.append(lit.make(renderer))
        shadows.append(shadowed.make(renderer))
        if turn == 0:
            truth = Picture(image, isovalue, True)
            truth.set_up(renderer)
            truth.make(renderer)
            first_error = error(lit.pixels(), final_of(truth, renderer)[0])
        if turn < TURNS - 1:
            camera.Azimuth(1)
    recolored = []
    for step in range(TURNS):
        shadowed.volume.GetProperty().SetAmbient(0.5 + 0.01 * step)
        recolored.append(shadowed.make(renderer))
    last = lit.pixels()
    begin = time.perf_counter()
    final, frames = final_of(lit, renderer)
    still = 1e3 * (time.perf_counter() - begin) / frames
    base = statistics.median(cold)
    return (
        f"| {name}, {isovalue:g}, {view} | {(final >= 0).sum() / 1e6:.2f} | {base:.0f} "
        f"| {first:.1f} | {turning[0] / base:.1f} | {statistics.median(turning[TURNS // 2:]) / base:.1f} "
        f"| {still:.0f} | {frames} | {first_error:.1f} | {error(last, final):.1f} "
        f"| {statistics.median(shadows) / base:.1f} | {statistics.median(recolored) / base:.2f} |")


def main() -> None:
    print("| volume, isovalue, view | hits, million | cold, ms | first / cold | switched on / cold "
          f"| turning / cold | still, ms | still frames | error: first frame | after {TURNS - 1} turns "
          "| hard shadows / cold | new colours / cold |")
    print("|---|---|---|---|---|---|---|---|---|---|---|---|")
    print_rows(sys.argv[1:] or VOLUMES, measure)


if __name__ == "__main__":
    main()
