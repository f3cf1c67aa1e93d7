# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""Opens files as the examples in Python do, each in a process of its own, as OpenFiles does in C++.

A request is a line WAY<tab>FILE<tab>SAID on the standard input, with the way "python"; the answer is
a line with the status that wait() gave and the most memory that the process had, in KiB.
"""

import os
import pathlib
import resource
import shutil
import signal
import sys
import tempfile
import traceback

MOST_SECONDS = 20
MOST_BYTES = 1 << 30  # beyond what the program has at first

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "Examples" / "Python"))

import render_server
from mistakes import run


def limit() -> None:
    signal.alarm(MOST_SECONDS)
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    if "asan" not in os.environ.get("LD_PRELOAD", ""):
        pages = int(pathlib.Path("/proc/self/statm").read_text(encoding="ascii").split()[0])
        resource.setrlimit(
            resource.RLIMIT_AS, (4096 * pages + MOST_BYTES, resource.RLIM_INFINITY))


def open_file(path: str, said: str) -> int:
    """In the process that is there for this alone: the exit status."""
    output = os.open(said, os.O_WRONLY | os.O_CREAT | os.O_TRUNC, 0o600)
    for stream in (1, 2):
        os.dup2(output, stream)
    sys.stdout = open(os.devnull, "w", encoding="utf-8")  # it tells of each picture
    pictures = tempfile.mkdtemp()
    sys.argv = ["render_server.py", path, "--size", "40", "--output", pictures]
    limit()
    try:
        run(render_server.main)
    except SystemExit as end:
        if isinstance(end.code, str):
            print(end.code, file=sys.stderr)
        return 1
    except BaseException:  # pylint: disable=broad-except # of all kinds, as it is told of here
        traceback.print_exc()
        return 2
    finally:
        signal.alarm(0)
        sys.stderr.flush()
        shutil.rmtree(pictures, ignore_errors=True)
    return 0


def main() -> None:
    for line in sys.stdin:
        _, path, said, *_ = line.rstrip("\n").split("\t")
        child = os.fork()
        if child == 0:
            os._exit(open_file(path, said))
        _, status, used = os.wait4(child, 0)
        print(status, used.ru_maxrss, flush=True)


main()
