# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""Reads a file in a process of its own before it is read here.

VTK's readers believe what files say: some files end them, some never end, and some take all memory.
What happens to a copy of this process, within limits of time and memory, is one sentence here. Where
a process cannot be copied (Windows), files are read without a trial.
"""

from __future__ import annotations

import os
import pathlib
import re
import signal
import sys
import time
from typing import Callable

from mistakes import UserError, quoted

try:
    import resource
except ImportError:  # where os.fork is missing, too
    resource = None

#: How many bytes one byte of a file can become. zlib tells 1032 as its maximum, runs of SLC have at
#: most 127; LZMA, which VTK's XML may be compressed by, has no bound.
INFLATIONS = {".gz": 1032, ".mha": 1032, ".mhd": 1032, ".slc": 127, ".vtk": 1, ".nii": 1}
INFLATION_OF_XML = 8192
WIDER = 8  # bytes of a number that a digit of text becomes
COPIES = 2  # of what is read, for a while
LEAST_BYTES = 512 << 20  # of memory
LEAST_SECONDS = 1.5  # of a processor; small files take a hundredth of a second
BYTES_PER_SECOND = 4 << 20  # that a slow machine reads, at least, and
INFLATED_PER_SECOND = 128 << 20  # that it inflates
MOST_WAITING = 8  # times the seconds of a processor: how long a reader may wait for a disk
MOST_OF_LIST = 1 << 20  # bytes that are searched for names of files


def try_reading(path: str, read: Callable[[], None]) -> None:
    """Call a function in a copy of this process; UserError if that does not go well."""
    if not hasattr(os, "fork"):
        return
    seconds, memory = _limits(path)
    receiver, sender = os.pipe()
    sys.stdout.flush()
    child = os.fork()
    if child == 0:
        os.close(receiver)
        _read_and_end(read, sender, seconds, memory)
    os.close(sender)
    status = _wait(child, MOST_WAITING * seconds)
    with open(receiver, encoding="utf-8", errors="replace") as pipe:
        refusal = pipe.read()
    if refusal:
        raise UserError(refusal)
    number = os.WTERMSIG(status) if os.WIFSIGNALED(status) else 0
    if number == signal.SIGXCPU:
        raise damaged(path, "to read it would take too long")
    if number == signal.SIGKILL:
        raise damaged(path, "it takes more time or memory than there is")
    if status:
        raise damaged(path, "its reader fails on it")


def damaged(path: str, reason: str) -> UserError:
    return UserError(
        f"{quoted(path)} could not be read as an image or a grid: {reason}; check that it is a whole "
        f"file of the format that its suffix tells.")


def require_bytes(path: str, there: int) -> None:
    """Refuse a file that cannot hold so many bytes of samples, however they are compressed."""
    if there > (1 << 20) + WIDER * _bytes_with_parts(path) * _inflation(path):
        raise damaged(path, "its header tells of more samples than it can hold")


def _read_and_end(read: Callable[[], None], sender: int, seconds: float, memory: float) -> None:
    """What the copy does."""
    try:
        nowhere = os.open(os.devnull, os.O_RDWR)
        for stream in (0, 1, 2):  # libraries below VTK's readers write on the terminal
            os.dup2(nowhere, stream)
        _limit(resource.RLIMIT_CORE, 0)
        _limit(resource.RLIMIT_CPU, max(round(seconds), 1))
        if sys.platform == "linux" and "asan" not in os.environ.get("LD_PRELOAD", ""):
            pages = int(pathlib.Path("/proc/self/statm").read_text(encoding="ascii").split()[0])
            size = os.sysconf("SC_PAGE_SIZE")
            physical = size * os.sysconf("SC_PHYS_PAGES")
            _limit(resource.RLIMIT_AS, int(pages * size + min(memory, physical)))
        read()
    except UserError as error:
        os.write(sender, str(error).encode("utf-8", "surrogateescape"))
    except BaseException:  # pylint: disable=broad-except # of whatever kind, the copy has to end
        os._exit(1)
    os._exit(0)


def _limit(what: int, most: int) -> None:
    soft, hard = resource.getrlimit(what)
    resource.setrlimit(what, (most if soft == resource.RLIM_INFINITY else min(soft, most), hard))


def _wait(child: int, seconds: float) -> int:
    """The status of a process that is ended where it takes longer than that."""
    end = time.monotonic() + seconds
    pause = 0.0005
    while True:
        done, status = os.waitpid(child, os.WNOHANG)
        if done:
            return status
        if time.monotonic() > end:
            os.kill(child, signal.SIGKILL)
        time.sleep(pause)
        pause = min(2.0 * pause, 0.05)


def _limits(path: str) -> tuple[float, float]:
    """Seconds of a processor, and bytes of memory, that reading may take."""
    there = _bytes_with_parts(path)
    inflated = there * _inflation(path)
    return (LEAST_SECONDS + there / BYTES_PER_SECOND + inflated / INFLATED_PER_SECOND,
            LEAST_BYTES + COPIES * WIDER * inflated)


def _inflation(path: str) -> int:
    return next(
        (most for suffix, most in INFLATIONS.items() if path.lower().endswith(suffix)), INFLATION_OF_XML)


def _bytes_with_parts(path: str) -> int:
    """Bytes of a file, and of those that a header names."""
    file = pathlib.Path(path)
    there = file.stat().st_size
    if not path.lower().endswith(".mhd"):
        return there
    with open(path, "rb") as header:
        words = re.split(rb"[\s=:]+", header.read(MOST_OF_LIST))
    names = [word.decode("utf-8", "surrogateescape") for word in words if 0 < len(word) < 1024]
    if any("%" in name for name in names):  # a pattern stands for several
        names = [part.name for part in file.parent.iterdir()]
    parts = [file.parent / name for name in names if "\0" not in name]
    return there + sum(part.stat().st_size for part in parts if part.is_file())
