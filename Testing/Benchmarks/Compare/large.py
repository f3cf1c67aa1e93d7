#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""What a volume larger than memory costs.

usage: python3 large.py [--isovalue V] [--limit MIB] [--frames N] [--memory] VOLUME

VOLUME is anything that vtkTemporalCoherenceBrickSource takes. 1280 x 720 pixels; the volume fills the
height. Prints in ms of the wall clock: opening (value ranges are found anew, then taken from their
file); the first picture; medians of N frames (default 20) turned by one degree each, and of N isovalues
in a still view; and the share of bricks that a turned frame did not have to read. Then the peak of
resident memory, without pages of mapped files. With --memory the samples are also read into memory as a
whole, and the same frames are made of them, in turn with the others.
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


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("volume")
    parser.add_argument("--isovalue", type=float, default=128.0)
    parser.add_argument("--limit", type=int, default=1536)
    parser.add_argument("--frames", type=int, default=20)
    parser.add_argument("--memory", action="store_true")
    options = parser.parse_args()

    def source(folder: str) -> vtkTemporalCoherenceBrickSource:
        made = vtkTemporalCoherenceBrickSource()
        made.SetFileName(options.volume)
        made.SetRangesFolder(folder)
        made.SetMemoryLimit(options.limit << 20)
        return made

    with tempfile.TemporaryDirectory(dir=os.path.dirname(os.path.abspath(options.volume))) as folder:
        print(f"opened, ranges are found   {ms(source(folder).Update):10.0f}")
        paged = source(folder)
        print(f"opened again               {ms(paged.Update):10.1f}")
        assert paged.GetHadRanges()
        views = [View(lambda mapper: mapper.SetBrickSource(paged), options.isovalue)]
        whole = vtkImageData()
        if options.memory:
            whole.DeepCopy(paged.GetOutput())
            views.append(View(lambda mapper: mapper.SetInputData(whole), options.isovalue))
        names = ["read when needed", "in memory"]
        for name, view in zip(names, views):
            print(f"{name}: first picture {ms(view.draw):10.1f}")
        reads = paged.GetNumberOfReads()
        turned = [[] for _ in views]
        for _ in range(options.frames):
            for times, view in zip(turned, views):
                view.turn()
                times.append(ms(view.draw))
        new = (paged.GetNumberOfReads() - reads) / options.frames
        dragged = [[] for _ in views]
        for step in range(options.frames):
            for times, view in zip(dragged, views):
                view.values.SetValue(0, options.isovalue + 0.5 * (step + 1))
                times.append(ms(view.draw))
        for name, turns, drags in zip(names, turned, dragged):
            print(f"{name}: turned {statistics.median(turns):.1f} (most {max(turns):.1f}), "
                  f"dragged {statistics.median(drags):.1f} (most {max(drags):.1f})")
        print(f"mapped: {paged.GetIsMapped()}; bricks read: first {reads}, {new:.1f} a turned frame; "
              f"memory of samples {paged.GetMemoryInUse() >> 20} MiB")
    print(f"resident without pages of files: {memory('RssAnon')} MiB now; peak with them {memory('VmHWM')} MiB")


if __name__ == "__main__":
    main()
