#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""What volumes larger than memory cost.

usage: python3 large.py [--isovalue V] [--limit MIB] [--frames N] [--memory] VOLUME...

VOLUMEs are anything that vtkTemporalCoherenceBrickSource takes: the same samples in several formats. 1280 x
720 pixels; the volume fills the height. Prints in ms of the wall clock, of each volume: opening (value
ranges are found anew, then taken from their file); the first picture; medians of N frames (default 20)
turned by one degree each, and of N isovalues in a still view, in turn with the other volumes; bricks that
were read; and bytes that samples take. Then the resident memory without pages of mapped files. With
--memory the samples of the first volume, which should be mapped, are also copied into memory as a whole.
"""

from __future__ import annotations

import argparse
import os
import statistics
import tempfile
import time

from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkRenderingCore import vtkColorTransferFunction, vtkRenderer, vtkVolume
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from vtkTemporalCoherence import vtkTemporalCoherenceBrickSource, vtkTemporalCoherenceVolumeMapper

SIZE = (1280, 720)


def ms(act) -> float:
    begin = time.perf_counter()
    act()
    return 1000.0 * (time.perf_counter() - begin)


def memory(entry: str) -> int:
    """MiB that /proc tells of this process."""
    with open("/proc/self/status") as status:
        for line in status:
            if line.startswith(entry + ":"):
                return int(line.split()[1]) >> 10
    return 0


class View:
    """A mapper and its camera."""

    def __init__(self, connect, isovalue: float):
        self.mapper = vtkTemporalCoherenceVolumeMapper()
        connect(self.mapper)
        self.volume = vtkVolume()
        self.volume.SetMapper(self.mapper)
        values = self.volume.GetProperty().GetIsoSurfaceValues()
        values.SetValue(0, isovalue)
        self.values = values
        colors = vtkColorTransferFunction()
        colors.AddRGBPoint(isovalue, 0.85, 0.75, 0.6)
        self.volume.GetProperty().SetColor(colors)
        self.volume.GetProperty().ShadeOn()
        self.volume.GetProperty().SetInterpolationTypeToLinear()
        self.mapper.SetBlendModeToIsoSurface()
        self.mapper.SetAntialiasingToOff()
        self.renderer = vtkRenderer()
        self.image = vtkImageData()
        bounds = self.volume.GetBounds()
        camera = self.renderer.GetActiveCamera()
        self.renderer.ResetCamera(bounds)
        camera.Elevation(-60)
        camera.SetViewUp(0, 0, 1)
        self.renderer.ResetCamera(bounds)
        camera.Dolly(1.7)
        self.renderer.ResetCameraClippingRange(bounds)

    def draw(self) -> None:
        assert self.mapper.MakeImage(self.renderer, self.volume, *SIZE, self.image)

    def turn(self) -> None:
        self.renderer.GetActiveCamera().Azimuth(1.0)
        self.renderer.ResetCameraClippingRange(self.volume.GetBounds())


class Volume:
    """A volume, and what drawing it took."""

    def __init__(self, name: str, folder: str, options):
        self.name = name
        print(f"{name}: opened, ranges are found {ms(self.source(folder, options).Update):.0f}")
        self.paged = self.source(folder, options)
        print(f"{name}: opened again {ms(self.paged.Update):.1f}")
        assert self.paged.GetHadRanges()
        self.view = View(lambda mapper: mapper.SetBrickSource(self.paged), options.isovalue)
        self.turned, self.dragged, self.reads = [], [], []

    def source(self, folder: str, options) -> vtkTemporalCoherenceBrickSource:
        made = vtkTemporalCoherenceBrickSource()
        made.SetFileName(self.name)
        made.SetRangesFolder(folder)
        made.SetMemoryLimit(options.limit << 20)
        return made

    def draw(self, times: list) -> None:
        before = self.paged.GetNumberOfReads()
        times.append(ms(self.view.draw))
        self.reads.append(self.paged.GetNumberOfReads() - before)


class Copy(Volume):
    """The samples of a volume, all in memory."""

    def __init__(self, of: Volume, options):
        self.name = "in memory"
        self.paged = of.paged
        self.image = vtkImageData()
        self.image.DeepCopy(of.paged.GetOutput())
        self.view = View(lambda mapper: mapper.SetInputData(self.image), options.isovalue)
        self.turned, self.dragged, self.reads = [], [], []


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("volumes", nargs="+")
    parser.add_argument("--isovalue", type=float, default=128.0)
    parser.add_argument("--limit", type=int, default=1536)
    parser.add_argument("--frames", type=int, default=20)
    parser.add_argument("--memory", action="store_true")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory(dir=os.path.dirname(os.path.abspath(options.volumes[0]))) as folder:
        volumes = [Volume(name, folder, options) for name in options.volumes]
        if options.memory:
            volumes.append(Copy(volumes[0], options))
        for volume in volumes:
            first = []
            volume.draw(first)
            print(f"{volume.name}: first picture {first[0]:.1f}, bricks read {volume.reads.pop()}")
        for _ in range(options.frames):
            for volume in volumes:
                volume.view.turn()
                volume.draw(volume.turned)
        for step in range(options.frames):
            for volume in volumes:
                volume.view.values.SetValue(0, options.isovalue + 0.5 * (step + 1))
                volume.draw(volume.dragged)
        for volume in volumes:
            reads = statistics.mean(volume.reads[:options.frames])
            print(f"{volume.name}: turned {statistics.median(volume.turned):.1f} (most {max(volume.turned):.1f}; "
                  f"{reads:.0f} bricks read), dragged {statistics.median(volume.dragged):.1f} (most "
                  f"{max(volume.dragged):.1f}); mapped: {volume.paged.GetIsMapped()}, samples take "
                  f"{volume.paged.GetMemoryInUse() >> 20} MiB")
    print(f"resident without pages of files: {memory('RssAnon')} MiB now; peak with them {memory('VmHWM')} MiB")


if __name__ == "__main__":
    main()
