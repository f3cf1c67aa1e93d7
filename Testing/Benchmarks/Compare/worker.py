# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws cold frames of one scene by one build, when compare.py asks for them.

usage: worker.py SCENE, with the build's module on PYTHONPATH

SCENE is JSON: the members of scenes.Scene, "size" and "avx512". Then each line of the standard
input is a request, answered by a line of JSON: the name of a view by the share of pixels hit there
in percent (null, once, if the volume is not there), "turn" by the least milliseconds of a few cold
frames as [CPU time of all threads, wall time], "layers" by the layers of the last frame (null if
the build does not tell).
"""

from __future__ import annotations

import ctypes
import json
import re
import sys
import time

import numpy
import vtkTemporalCoherence
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkVolume

import scenes
import volumes

FRAMES_A_TURN = 5  # the first of them finds the caches as the other build has left them


def switch_off_avx512() -> None:
    """Tell Highway, which all our builds are linked with, that the machine has AVX2 at most."""
    with open("/proc/self/maps", encoding="utf-8") as maps:
        libraries = re.findall(r"/\S*libhwy\.so\S*", maps.read())
    if not libraries:
        sys.exit("AVX-512 cannot be switched off: this build has no shared library of Highway.")
    # hwy::DisableTargets; better targets are lower bits, and AVX2 is bit 9.
    disable = getattr(ctypes.CDLL(libraries[0]), "_ZN3hwy14DisableTargetsEl")
    disable.argtypes = [ctypes.c_int64]
    disable.restype = None
    disable((1 << 9) - 1)


class Stage:
    """A scene before a camera that trembles, so that no frame can use the last one."""

    def __init__(self, scene: scenes.Scene, image, size: int) -> None:
        self.size = size
        self.frames = 0
        self.mapper = vtkTemporalCoherence.vtkTemporalCoherenceVolumeMapper()
        self.mapper.SetInputData(image)
        self.mapper.ReuseFramesOff()
        self.mapper.SetAntialiasingToOff()
        self.mapper.IsomapOff()
        if scene.is_threshold:
            self.mapper.SetSurfaceModeToThreshold()
        self.volume = vtkVolume()
        self.volume.SetMapper(self.mapper)
        look = self.volume.GetProperty()
        look.SetInterpolationTypeToLinear()
        look.ShadeOn()
        for index, isovalue in enumerate(scene.isovalues):
            look.GetIsoSurfaceValues().SetValue(index, isovalue)
            look.GetRGBTransferFunction().AddRGBPoint(isovalue, 0.9, 0.8 - 0.2 * index, 0.7)
            if scene.opacity < 1.0:
                look.GetScalarOpacity().AddPoint(isovalue, scene.opacity)
        self.renderer = vtkRenderer()
        self.color, self.depth = vtkImageData(), vtkImageData()

    def look(self, view: str) -> float:
        """Turn to a view; percent of the pixels that are hit there."""
        self.renderer = vtkRenderer()
        self.renderer.AddVolume(self.volume)
        self.renderer.ResetCamera()
        camera = self.renderer.GetActiveCamera()
        camera.Azimuth(30.0)
        camera.Elevation(20.0)
        camera.Zoom(scenes.VIEWS[view])
        self.renderer.ResetCameraClippingRange()
        self.turn()
        return 100.0 * float(numpy.mean(numpy.isfinite(vtk_to_numpy(
            self.depth.GetPointData().GetScalars()))))

    def frame(self) -> tuple[float, float]:
        """Draw a cold frame; milliseconds of CPU time and of wall time."""
        self.frames += 1
        self.renderer.GetActiveCamera().Azimuth(1e-3 if self.frames % 2 else -1e-3)
        cpu, wall = time.process_time(), time.perf_counter()
        is_drawn = self.mapper.MakeImage(
            self.renderer, self.volume, self.size, self.size, self.color, self.depth)
        times = 1e3 * (time.process_time() - cpu), 1e3 * (time.perf_counter() - wall)
        if not is_drawn or self.mapper.GetStatistics().GetRouteAsString() != "Cold":
            sys.exit("This frame should have been a cold one: mend Stage.frame().")
        return times

    def turn(self) -> list[float]:
        """Draw a few frames; the least of each time."""
        return [min(times) for times in zip(*(self.frame() for _ in range(FRAMES_A_TURN)))]

    def layers(self) -> int | None:
        """Layers of the last frame; None if the build does not tell."""
        count = getattr(self.mapper, "GetNumberOfLayers", None)
        return count() if count else None


def main() -> None:
    asked = json.loads(sys.argv[1])
    size, has_avx512 = asked.pop("size"), asked.pop("avx512")
    if not has_avx512:
        switch_off_avx512()
    scene = scenes.Scene(**asked)
    image = volumes.load(scene.volume)
    if image is None:
        print("null", flush=True)
        return
    if scene.sample_type:
        image = volumes.with_type(image, scene.sample_type)
    if scene.is_rectilinear:
        image = volumes.on_grid(image)
    stage = Stage(scene, image, size)
    for request in map(str.strip, sys.stdin):
        if request == "turn":
            answer = stage.turn()
        elif request == "layers":
            answer = stage.layers()
        else:
            answer = stage.look(request)
        print(json.dumps(answer), flush=True)


if __name__ == "__main__":
    main()
