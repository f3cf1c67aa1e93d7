#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""The CPU time of unchanged programs with VTK_AUTOLOAD_PATH, beside the time without.

usage: xvfb-run -a python3 programs.py AUTOLOAD_DIRECTORY VOLUME.vti [ROUNDS]

AUTOLOAD_DIRECTORY is build/lib/vtkTemporalCoherence/autoload, or that of the packages. Each program
is run with and without the variable in turn, ROUNDS times (default 3). Prints medians of the CPU time
of whole programs (all cores, with starting and reading), and what the factory said.
"""

from __future__ import annotations

import os
import resource
import shutil
import statistics
import subprocess
import sys
import tempfile

SCRIPT = """\
import sys
from vtkmodules.all import *

case, path = sys.argv[1:3]
reader = vtkXMLImageDataReader()
reader.SetFileName(path)
reader.Update()
low, high = reader.GetOutput().GetScalarRange()
spacing = reader.GetOutput().GetSpacing()


def value(share):
    return low + share * (high - low)


mapper = vtkGPUVolumeRayCastMapper() if case.startswith("gpu") else vtkSmartVolumeMapper()
mapper.SetInputConnection(reader.GetOutputPort())
volume = vtkVolume()
volume.SetMapper(mapper)
look = volume.GetProperty()
look.SetInterpolationType(0 if "nearest" in case else 1)
look.SetShade("shaded" in case)
look.SetScalarOpacityUnitDistance(sum(spacing) / 3)
colors = look.GetRGBTransferFunction()
opacities = look.GetScalarOpacity()
colors.RemoveAllPoints()
opacities.RemoveAllPoints()
for share, color in ((0, (0.2, 0.3, 0.8)), (0.5, (0.9, 0.8, 0.7)), (1, (0.9, 0.3, 0.2))):
    colors.AddRGBPoint(value(share), *color)
if "bone" in case:
    nodes = ((0.35, 0), (0.4, 0.3), (0.55, 0.9))
elif "skin" in case:
    nodes = ((0.12, 0), (0.16, 0.15), (0.2, 0), (0.35, 0), (0.45, 0.8))
else:
    nodes = ((0, 0), (1, 0.7))
for share, opacity in nodes:
    opacities.AddPoint(value(share), opacity)
if "isosurface" in case:
    mapper.SetBlendModeToIsoSurface()
    look.GetIsoSurfaceValues().SetValue(0, value(0.4))
elif "maximum" in case:
    mapper.SetBlendModeToMaximumIntensity()
elif "average" in case:
    mapper.SetBlendModeToAverageIntensity()
elif "sum" in case:
    mapper.SetBlendModeToAdditive()
if "fine" in case:
    mapper.SetAutoAdjustSampleDistances(0)
    mapper.SetSampleDistance(0.5 * min(spacing))
renderer = vtkRenderer()
renderer.AddVolume(volume)
window = vtkRenderWindow()
window.SetOffScreenRendering(1)
window.SetSize(400, 400)
window.AddRenderer(renderer)
renderer.ResetCamera()
camera = renderer.GetActiveCamera()
camera.Elevation(-70)
camera.Zoom(1.3)
if "drag" in case:
    window.SetDesiredUpdateRate(15)
window.Render()
for _ in range(0 if "picture" in case else 8):
    camera.Azimuth(4)
    window.Render()
window.SetDesiredUpdateRate(0.01)
window.Render()
"""

CASES = (
    "gpu isosurface", "gpu bone shaded", "smart skin shaded", "smart skin shaded picture",
    "gpu ramp", "smart ramp shaded", "gpu bone shaded fine", "gpu ramp fine", "smart maximum",
    "gpu average", "gpu sum", "smart ramp nearest", "gpu skin shaded drag", "gpu ramp drag")


def programs(volume, folder):
    """The programs by their names."""
    found = {case: [sys.executable, "-c", SCRIPT, case, volume] for case in CASES}
    if shutil.which("f3d"):
        picture = os.path.join(folder, "picture.png")
        found["f3d --volume"] = ["f3d", "--dry-run", "--volume", volume, "--output", picture,
                                 "--resolution", "400,400"]
    return found


def run(command, autoload):
    """CPU seconds of a program, and what it said."""
    environment = {name: value for name, value in os.environ.items() if name != "VTK_AUTOLOAD_PATH"}
    if autoload:
        environment["VTK_AUTOLOAD_PATH"] = autoload
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run(command, env=environment, capture_output=True, text=True, check=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return (after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime,
            done.stdout + done.stderr)


def main():
    """Print the table."""
    if len(sys.argv) not in (3, 4) or sys.argv[1] in ("-h", "--help"):
        sys.exit(__doc__)
    autoload, volume = (os.path.abspath(path) for path in sys.argv[1:3])
    rounds = int(sys.argv[3]) if len(sys.argv) > 3 else 3
    print("| program | without, s | with, s | with / without | drawn by |\n|---|---|---|---|---|")
    with tempfile.TemporaryDirectory() as folder:
        for name, command in programs(volume, folder).items():
            times = {False: [], True: []}
            said = ""
            for _ in range(rounds):
                for gains in (False, True):
                    seconds, output = run(command, autoload if gains else None)
                    times[gains].append(seconds)
                    said = output if gains else said
            lines = [line.split("drawn by ", 1)[1].replace("\033[0m", "")
                     for line in said.splitlines() if "drawn by " in line]
            without, with_it = (statistics.median(times[gains]) for gains in (False, True))
            print(f"| {name} | {without:.2f} | {with_it:.2f} | {with_it / without:.2f} "
                  f"| {'; '.join(lines) or '-'} |", flush=True)


if __name__ == "__main__":
    main()
