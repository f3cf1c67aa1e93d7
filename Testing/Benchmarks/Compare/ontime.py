#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""Frames of an interaction at 15 updates a second: their times, their errors, and the work that is
left when the camera rests.

Prints a table in Markdown. Frames are drawn in a window. Errors are mean differences from the exact
picture over a grey background, in steps of a byte. They are compared with those of blocks: frames
with a ray for d x d pixels, with the smallest whole d at which 95 % of the frames take no longer
than 1/15 s. Work is CPU time of all threads.

usage: ontime.py [VOLUME:LOOK]...   with the package vtkTemporalCoherence in PYTHONPATH
LOOK: veil:SOFT:HARD (a composite volume of skin and bone) or layers:ISOVALUE[:ISOVALUE]...
"""

from __future__ import annotations

import statistics
import sys
import time

import numpy
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  makes windows
import volumes
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPiecewiseFunction
from vtkmodules.vtkRenderingCore import (
    vtkColorTransferFunction, vtkRenderer, vtkRenderWindow, vtkVolume, vtkVolumeProperty)
from vtkTemporalCoherence import vtkTemporalCoherenceVolumeMapper

SCENES = ("cthead.vti:veil:600:1500", "engine.vti:veil:70:180", "bonsai.vti:veil:40:150",
          "cthead.vti:layers:600:1500", "engine.vti:layers:70")
SIZE = 1024
FRAMES = 40
STEP = 2.0  # degrees a frame
RATE, STILL = 15.0, 1e-4
GREY = 128.0


def veil(look: vtkVolumeProperty, image: vtkImageData, soft: float, hard: float) -> None:
    low, high = image.GetScalarRange()
    ramp = 0.08 * (high - low)
    dark, skin, bone = (0.4, 0.2, 0.1), (0.85, 0.55, 0.4), (1.0, 0.95, 0.85)
    color, opacity = vtkColorTransferFunction(), vtkPiecewiseFunction()
    for value, rgb, alpha in ((low, dark, 0.0), (soft - 0.5 * ramp, skin, 0.0), (soft, skin, 0.1),
                              (soft + ramp, skin, 0.03), (hard - ramp, skin, 0.03),
                              (hard, bone, 0.6), (high, bone, 0.8)):
        color.AddRGBPoint(value, *rgb)
        opacity.AddPoint(value, alpha)
    look.SetColor(color)
    look.SetScalarOpacity(opacity)


def layers(look: vtkVolumeProperty, *isovalues: float) -> None:
    color, opacity = vtkColorTransferFunction(), vtkPiecewiseFunction()
    for place, isovalue in enumerate(isovalues):
        look.GetIsoSurfaceValues().SetValue(place, isovalue)
        color.AddRGBPoint(isovalue, 0.9, 0.6 + 0.3 * place, 0.4)
        opacity.AddPoint(isovalue, 0.4)
    look.SetColor(color)
    look.SetScalarOpacity(opacity)


class Picture:
    """A scene in a window."""

    def __init__(self, image: vtkImageData, kind: str, values: list[float]):
        self.mapper = vtkTemporalCoherenceVolumeMapper()
        self.mapper.SetAntialiasingToOff()  # pictures of single rays are compared
        self.mapper.SetInputData(image)
        self.volume = vtkVolume()
        self.volume.SetMapper(self.mapper)
        look = self.volume.GetProperty()
        look.SetInterpolationTypeToLinear()
        look.ShadeOn()
        if kind == "veil":
            self.mapper.SetBlendModeToComposite()
            veil(look, image, *values)
        else:
            layers(look, *values)
        self.renderer = vtkRenderer()
        self.renderer.SetBackground(GREY / 255, GREY / 255, GREY / 255)
        self.renderer.AddVolume(self.volume)
        self.window = vtkRenderWindow()
        self.window.SetOffScreenRendering(1)
        self.window.SetMultiSamples(0)
        self.window.SetSize(SIZE, SIZE)
        self.window.AddRenderer(self.renderer)
        self.renderer.ResetCamera()
        camera = self.renderer.GetActiveCamera()
        camera.Azimuth(30)
        camera.Elevation(20)
        camera.Zoom(1.3)
        self.frame = vtkImageData()

    def turn(self, degrees: float) -> None:
        self.renderer.GetActiveCamera().Azimuth(degrees)
        self.renderer.ResetCameraClippingRange()

    def render(self, rate: float) -> tuple[float, float]:
        """Milliseconds, and those of CPU time."""
        self.window.SetDesiredUpdateRate(rate)
        begin, cpu = time.perf_counter(), time.process_time()
        self.window.Render()
        return 1e3 * (time.perf_counter() - begin), 1e3 * (time.process_time() - cpu)

    def rgba(self) -> numpy.ndarray:
        """The last frame, also in blocks, with a value for each pixel."""
        self.mapper.GetLastFrame(self.frame, vtkTemporalCoherenceVolumeMapper.FRAME_COLOR)
        width, height, _ = self.frame.GetDimensions()
        colors = vtk_to_numpy(self.frame.GetPointData().GetScalars()).reshape(height, width, 4)
        rows = ((2 * numpy.arange(SIZE) + 1) * height) // (2 * SIZE)
        columns = ((2 * numpy.arange(SIZE) + 1) * width) // (2 * SIZE)
        return colors[rows][:, columns]


def over_grey(rgba: numpy.ndarray) -> numpy.ndarray:
    rgba = rgba.astype(float)
    return rgba[..., :3] + GREY / 255 * (255 - rgba[..., 3:])


def share(times: list[float]) -> float:
    """The time that 95 % of the frames do not exceed."""
    return sorted(times)[int(0.95 * len(times))]


def blocks_in_time(picture: Picture) -> float:
    """The smallest distance of rays at which blocks are there in time."""
    picture.mapper.AutoAdjustSampleDistancesOff()
    for distance in range(1, 11):
        picture.mapper.SetImageSampleDistance(distance)
        times = []
        for _ in range(7):
            picture.turn(STEP)
            times.append(picture.render(RATE)[0])
        if sorted(times)[-2] <= 1e3 / RATE:
            break
    return distance


def turn(picture: Picture, rate: float) -> tuple[list[float], list[numpy.ndarray]]:
    """Times and pictures of an orbit."""
    times, frames = [], []
    for _ in range(FRAMES):
        picture.turn(STEP)
        times.append(picture.render(rate)[0])
        frames.append(picture.rgba())
    return times, frames


def measure(asked: str) -> str:
    name, kind, *values = asked.split(":")
    image = volumes.load(name)
    if image is None:
        return f"| {name} | SKIPPED: no such file |"
    numbers = [float(value) for value in values]
    truth, blocks, fewer = (Picture(image, kind, numbers) for _ in range(3))
    distance = blocks_in_time(blocks)
    blocks.turn(-STEP * 7 * distance)
    for picture in (truth, fewer):
        picture.render(STILL)
    # One picture after the other, as in an interaction.
    times, frames = turn(fewer, RATE)
    work = fewer.render(STILL)[1]
    of_blocks, frames_of_blocks = turn(blocks, RATE)
    cold, errors, block_errors = [], [], []
    for frame, block in zip(frames, frames_of_blocks):
        truth.turn(STEP)
        cold.append(truth.render(STILL))
        exact = over_grey(truth.rgba())
        errors.append(numpy.abs(over_grey(frame) - exact).mean())
        block_errors.append(numpy.abs(over_grey(block) - exact).mean())
    is_same = bool((fewer.rgba() == truth.rgba()).all()) and fewer.mapper.GetFrameIsFinal()
    error, block_error = statistics.mean(errors), statistics.mean(block_errors)
    return (
        f"| {' '.join((name, kind, *values))} | {statistics.median(time for time, _ in cold):.0f} "
        f"| {statistics.median(times):.0f} | {share(times):.0f} | {max(times):.0f} "
        f"| {distance} | {share(of_blocks):.0f} | {error:.2f} | {block_error:.2f} "
        f"| {error / block_error:.2f} | {work / statistics.median(cpu for _, cpu in cold):.2f} "
        f"| {'yes' if is_same else 'NO'} |")


def main() -> None:
    print("| scene | cold, ms | median, ms | 95 %, ms | worst, ms | blocks of | their 95 %, ms "
          "| error | error of blocks | ratio | work at rest / cold | same bytes |")
    print("|---|---|---|---|---|---|---|---|---|---|---|---|")
    for asked in sys.argv[1:] or SCENES:
        print(measure(asked), flush=True)


if __name__ == "__main__":
    main()
