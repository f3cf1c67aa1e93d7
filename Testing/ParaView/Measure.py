# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""Milliseconds and memory of each process: run with mpirun -np N pvbatch --sym.

With --sym each process runs this script, and reads the statistics of its own part. Each prints the
line: figures PROCESSES RANK MS_COLD MS_ORBIT MS_SWEEP MIB_VOLUME MIB_KEPT MIB_ISOMAP, times by
the clock for the whole frame, with ParaView's compositing.
"""

import os
import statistics
import time

from vtkmodules.vtkParallelCore import vtkMultiProcessController

from Stage import Render, look_from, make_view, make_wavelet, show, statistic

FRAMES = 12
LAST = int(os.environ.get("TEMPORAL_ISOSURFACE_MEASURED", "128"))


def resident():
    """MiB of this process that are in memory."""
    with open("/proc/self/status", encoding="ascii") as status:
        return next(int(line.split()[1]) / 1024 for line in status if line.startswith("VmRSS"))


def time_frames(view, change):
    """The median of some frames, in milliseconds."""
    times = []
    for _ in range(FRAMES):
        change()
        begin = time.perf_counter()
        Render(view)
        times.append(1000.0 * (time.perf_counter() - begin))
    return statistics.median(times)


def main():
    """Cold frames, an orbit, a sweep."""
    view = make_view((1024, 1024))
    small = make_wavelet(4)
    warm_up = show(small, view, [150.0])
    Render(view)
    warm_up.Visibility = 0
    empty = resident()
    source = make_wavelet(LAST)
    source.UpdatePipeline()
    volume = resident() - empty
    display = show(source, view, [150.0])
    look_from(view)

    def turn():
        view.GetActiveCamera().Azimuth(1.0)

    def raise_isovalue():
        display.Isovalues = [display.Isovalues[0] + 0.5]

    display.ReuseFrames = 0
    Render(view)
    cold = time_frames(view, turn)
    display.ReuseFrames = 1
    orbit = time_frames(view, turn)
    kept = resident() - empty - volume
    Render(view)
    sweep = time_frames(view, raise_isovalue)
    controller = vtkMultiProcessController.GetGlobalController()
    print("figures", controller.GetNumberOfProcesses(), controller.GetLocalProcessId(),
          f"{cold:.0f} {orbit:.0f} {sweep:.0f} {volume:.0f} {kept:.0f}",
          f"{statistic(display, 'IsomapMemory') / 2 ** 20:.0f}", flush=True)


main()
