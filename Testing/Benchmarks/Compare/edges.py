#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""What antialiasing costs, and how much of the error of one ray a pixel it takes away.

Prints a table in Markdown. The truth is the mean of 64 pictures, each shifted by a part of a pixel.
Errors are mean differences of all channels where the truth shows anything, in steps of a byte.
Times are CPU times of all threads: medians of views that differ by a degree.

usage: edges.py [VOLUME:ISOVALUE]...   with the package vtkTemporalCoherence in PYTHONPATH
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
from vtkmodules.vtkRenderingCore import vtkColorTransferFunction, vtkRenderer, vtkVolume
from vtkTemporalCoherence import vtkTemporalCoherenceVolumeMapper

VOLUMES = ("engine.vti:70", "brain.vti:40", "cthead.vti:600", "aneurism.vti:60")
SIZE = 1024
TURNS = 7
SHIFTS = 8  # of the truth, along each axis of a pixel


class Picture:
    """A shaded isosurface, in frames as a window would show them."""

    def __init__(self, image: vtkImageData, isovalue: float):
        self.mapper = vtkTemporalCoherenceVolumeMapper()
        self.mapper.SetInputData(image)
        self.mapper.SetBlendModeToIsoSurface()
        self.mapper.ProgressiveImagesOn()
        self.volume = vtkVolume()
        self.volume.SetMapper(self.mapper)
        look = self.volume.GetProperty()
        look.GetIsoSurfaceValues().SetValue(0, isovalue)
        look.SetInterpolationTypeToLinear()
        look.ShadeOn()
        color = vtkColorTransferFunction()
        color.AddRGBPoint(0.0, 1.0, 0.9, 0.8)
        look.SetColor(color)
        self.colors = vtkImageData()

    def make(self, renderer: vtkRenderer) -> float:
        """Make a frame; milliseconds of CPU time."""
        begin = time.process_time()
        self.mapper.MakeImage(renderer, self.volume, SIZE, SIZE, self.colors, None)
        return 1e3 * (time.process_time() - begin)

    def rays(self) -> int:
        return self.mapper.GetStatistics().GetNumberOfTracedRays()

    def pixels(self) -> numpy.ndarray:
        return vtk_to_numpy(self.colors.GetPointData().GetScalars()).astype(numpy.int32)


def truth_of(picture: Picture, renderer: vtkRenderer) -> numpy.ndarray:
    """The mean of pictures that are shifted by parts of a pixel, rounded."""
    camera = renderer.GetActiveCamera()
    picture.mapper.SetAntialiasingToOff()
    total = numpy.zeros((SIZE * SIZE, 4), numpy.int32)
    for shift in range(SHIFTS * SHIFTS):
        x, y = (((2 * i + 1) / (2 * SHIFTS) - 0.5) * 2.0 / SIZE for i in divmod(shift, SHIFTS))
        camera.SetWindowCenter(x, y)
        picture.make(renderer)
        total += picture.pixels()
    camera.SetWindowCenter(0.0, 0.0)
    picture.mapper.SetAntialiasingToWhenStill()
    return (2 * total + SHIFTS * SHIFTS) // (2 * SHIFTS * SHIFTS)


def measure(name: str, isovalue: float, view: str) -> str:
    image = volumes.load(name)
    if image is None:
        return f"| {name} | SKIPPED: no such file |"
    picture = Picture(image, isovalue)
    renderer = vtkRenderer()
    camera = renderer.GetActiveCamera()
    look_at(renderer, picture.volume.GetBounds(), view)
    picture.make(renderer)
    cold, smooth, share = [], [], []
    for _ in range(TURNS):
        camera.Azimuth(1)
        cold.append(picture.make(renderer))
        first = picture.pixels()
        smooth.append(picture.make(renderer))
        hits = (first[:, 3] > 0).sum()
        share.append(picture.rays() / hits)
    last = picture.pixels()
    truth = truth_of(picture, renderer)
    shown = truth[:, 3] > 0
    one, many = numpy.abs(first - truth)[shown], numpy.abs(last - truth)[shown]
    base = statistics.median(cold)
    return (
        f"| {name}, {isovalue:g}, {view} | {hits / 1e6:.2f} | {base:.0f} "
        f"| {statistics.median(smooth) / base:.2f} | {statistics.median(share):.2f} "
        f"| {one.mean():.2f} | {many.mean():.2f} | {many.mean() / one.mean():.2f} "
        f"| {one.max()} | {many.max()} |")


def main() -> None:
    print("| volume, isovalue, view | hits, million | cold, ms | antialiasing / cold | rays / hit "
          "| error: one ray | antialiased | ratio | worst: one ray | antialiased |")
    print("|---|---|---|---|---|---|---|---|---|---|")
    print_rows(sys.argv[1:] or VOLUMES, measure)


if __name__ == "__main__":
    main()
