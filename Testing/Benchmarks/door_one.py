#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""What a script for VTK's own mappers gains by VTK_AUTOLOAD_PATH, which is not changed at all.

usage: xvfb-run -a python3 door_one.py AUTOLOAD_DIRECTORY [VOLUME.vti ISOVALUE]...

AUTOLOAD_DIRECTORY is build/lib/vtkTemporalCoherence/autoload, or that of the packages. Without
volumes VTK's wavelet is drawn. Each script runs with and without the variable in turn, three times:
windows of 512 x 512 pixels, isosurfaces, shading, the view that ResetCamera gives, turned and zoomed
(Azimuth 30, Elevation 20, Zoom 1.3); then an orbit of 3 degrees a frame and a drag of the isovalue
by 1 % a frame. Prints a table of medians, wall time and time of all cores together.
"""

from __future__ import annotations

import json
import os
import statistics
import subprocess
import sys

ROUNDS = 3

SCRIPT = """\
import json, sys, time
from vtkmodules.all import *

mapper_name, path, isovalue = sys.argv[1], sys.argv[2], float(sys.argv[3])
if path == "wavelet":
    source = vtkRTAnalyticSource()
    source.SetWholeExtent(-50, 50, -50, 50, -50, 50)
else:
    source = vtkXMLImageDataReader()
    source.SetFileName(path)
source.Update()
mapper = vtkSmartVolumeMapper() if mapper_name == "vtkSmartVolumeMapper" else vtkGPUVolumeRayCastMapper()
mapper.SetInputConnection(source.GetOutputPort())
mapper.SetBlendModeToIsoSurface()
volume = vtkVolume()
volume.SetMapper(mapper)
look = volume.GetProperty()
look.SetInterpolationTypeToLinear()
look.ShadeOn()
low, high = source.GetOutput().GetScalarRange()
look.GetIsoSurfaceValues().SetValue(0, isovalue)
look.GetRGBTransferFunction().AddRGBPoint(low, 0.2, 0.4, 0.9)
look.GetRGBTransferFunction().AddRGBPoint(high, 0.9, 0.7, 0.4)
renderer = vtkRenderer()
renderer.AddVolume(volume)
window = vtkRenderWindow()
window.SetOffScreenRendering(1)
window.SetMultiSamples(0)
window.SetSize(512, 512)
window.AddRenderer(renderer)
pixel = vtkUnsignedCharArray()


def frame():
    wall, cpu = time.perf_counter(), time.process_time()
    window.Render()
    window.GetPixelData(0, 0, 1, 1, 1, pixel, 0)  # which waits until it is drawn
    return time.perf_counter() - wall, time.process_time() - cpu


frame()
camera = renderer.GetActiveCamera()
camera.Azimuth(30)
camera.Elevation(20)
camera.Zoom(1.3)
frame()
orbit, drag = [], []
for _ in range(10):
    camera.Azimuth(3)
    orbit.append(frame())
for step in range(10):
    look.GetIsoSurfaceValues().SetValue(0, isovalue * (1.0 + 0.01 * (step + 1)))
    drag.append(frame())
print(json.dumps({"orbit": orbit, "drag": drag}))
"""


def run(mapper, path, isovalue, autoload):
    environment = {name: value for name, value in os.environ.items() if name != "VTK_AUTOLOAD_PATH"}
    if autoload:
        environment["VTK_AUTOLOAD_PATH"] = autoload
    done = subprocess.run(
        [sys.executable, "-c", SCRIPT, mapper, path, isovalue], env=environment, check=True,
        capture_output=True, text=True)
    return json.loads(done.stdout.splitlines()[-1])


def main():
    if len(sys.argv) < 2 or len(sys.argv) % 2 or sys.argv[1] in ("-h", "--help"):
        sys.exit(__doc__)
    autoload = os.path.abspath(sys.argv[1])
    scenes = list(zip(sys.argv[2::2], sys.argv[3::2])) or [("wavelet", "150")]
    print("| mapper | volume | isovalue | frames | VTK alone, ms (all cores) | with the variable "
          "| gain (all cores) |\n| --- | --- | --- | --- | --- | --- | --- |")
    for path, isovalue in scenes:
        for mapper in ("vtkGPUVolumeRayCastMapper", "vtkSmartVolumeMapper"):
            times = {False: {"orbit": [], "drag": []}, True: {"orbit": [], "drag": []}}
            for _ in range(ROUNDS):
                for gains in (False, True):
                    for kind, frames in run(mapper, path, isovalue, gains and autoload).items():
                        times[gains][kind] += frames
            for kind in ("orbit", "drag"):
                wall, cpu = ([statistics.median(1e3 * frame[i] for frame in times[gains][kind])
                              for gains in (False, True)] for i in (0, 1))
                print(f"| {mapper} | {os.path.basename(path)} | {isovalue} | {kind} "
                      f"| {wall[0]:.0f} ({cpu[0]:.0f}) | {wall[1]:.1f} ({cpu[1]:.1f}) "
                      f"| {wall[0] / wall[1]:.0f} ({cpu[0] / cpu[1]:.0f}) |", flush=True)


if __name__ == "__main__":
    main()
