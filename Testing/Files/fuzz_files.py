# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""Opens broken files and expects a picture, or one sentence that names the file, from each.

Small volumes are written and broken; see originals.py and mutations.py. Seeds, broken files that
were once found, come first.
"""

from __future__ import annotations

import argparse
import os
import pathlib
import shlex
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unicodedata

from mutations import Mutator
from originals import NOT_OF_PYTHON, ORIGINALS, Original

MOST_GROWTH = 1.5  # of memory, beside the whole file
MOST_KIB = 256 * 1024  # and beyond that
MOST_CHARACTERS = 1500
SEEDS = pathlib.Path(__file__).parent / "seeds.txt"


class Opener:
    """A program that opens files, each in a process of its own."""

    def __init__(self, command: list[str], ways: list[str], scratch: pathlib.Path) -> None:
        self.ways = ways
        self._said = scratch / "said"
        self._process = subprocess.Popen(
            command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, cwd=scratch)

    def open(self, way: str, path: pathlib.Path, layout: str) -> tuple[int, int, str]:
        """The status that wait() gave, memory in KiB, and what was printed."""
        self._process.stdin.write("\t".join((way, str(path), str(self._said), layout)) + "\n")
        self._process.stdin.flush()
        answer = self._process.stdout.readline().split()
        if len(answer) != 2:
            sys.exit("The program that opens files has ended.")
        return int(answer[0]), int(answer[1]), self._said.read_bytes().decode("utf-8", "replace")

    def close(self) -> None:
        self._process.stdin.close()
        self._process.wait()


def write(original: Original, folder: pathlib.Path) -> pathlib.Path:
    """The files of a volume, in an empty folder; what is to be opened."""
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    for name, data in original.files.items():
        (folder / name).write_bytes(data)
    return folder / original.main if original.main else folder


def original_of(path: str) -> Original:
    """A volume's file as it is, and, of a header, the file of its samples."""
    main = pathlib.Path(path)
    files = {main.name: main.read_bytes()}
    samples = main.with_suffix(".raw")
    if main.suffix == ".mhd" and samples.exists():
        files[samples.name] = samples.read_bytes()
    return Original(main.name, files)


def broken(kind: str, number: int) -> Original:
    """Number 0 is whole."""
    if kind not in ORIGINALS:
        original = original_of(kind)
        if number:
            Mutator(number, kind).break_files(original)
        return original
    if number == 0:
        return ORIGINALS[kind](lambda value: value)
    mutator = Mutator(number, kind)
    original = ORIGINALS[kind](mutator.twist)
    mutator.break_files(original)
    return original


def is_harmless(text: str) -> bool:
    """No terminal obeys anything of it."""
    return not any(unicodedata.category(c) in ("Cc", "Cs", "Zl", "Zp") or
                   unicodedata.bidirectional(c) in ("LRE", "RLE", "LRO", "RLO", "PDF", "LRI", "RLI",
                                                    "FSI", "PDI") for c in text)


def what_is_wrong(status: int, said: str, names: list[str]) -> str:
    """Why an answer is not what it should be; empty where all is well."""
    if os.WIFSIGNALED(status):
        number = os.WTERMSIG(status)
        return "it hangs" if number == signal.SIGALRM else f"it ends by {signal.Signals(number).name}"
    code = os.WEXITSTATUS(status)
    if code == 0:
        return "it draws, and says something" if said else ""
    if code != 1:
        return f"it ends with status {code}"
    sentence = said[:-1]
    if not said.endswith(".\n") or "\n" in sentence:
        return "it says no single sentence"
    if not is_harmless(sentence) or len(sentence) > MOST_CHARACTERS:
        return "the sentence cannot be printed"
    if not any(name in sentence for name in names):
        return "the sentence names no file"
    if any(word in sentence for word in ("bad_alloc", "std::", "mapper refused", "Traceback")):
        return "the sentence is that of a program"
    return ""


class Campaign:
    """Broken files of all kinds, in all ways in which an opener opens them."""

    def __init__(self, opener: Opener, scratch: pathlib.Path) -> None:
        self._opener = opener
        self._folder = scratch / "files"
        self._kept = scratch / "found"
        self._needed: dict[tuple[str, str], int] = {}
        self.opened = self.pictures = self.found = 0

    def open(self, kind: str, number: int) -> None:
        """Open a file, and tell of what is wrong with the answer."""
        original = broken(kind, number)
        path = write(original, self._folder)
        # A broken session may name any file as its volume: that is the one to be told of.
        names = ["'"] if original.way == "session" else [*original.files, self._folder.name]
        for way in [original.way] if original.way else self._opener.ways:
            status, memory, said = self._opener.open(way, path, original.layout)
            self.opened += 1
            self.pictures += status == 0
            wrong = what_is_wrong(status, said, [original.main, "--raw takes"] if original.layout else names)
            if number == 0:
                self._needed[kind, way] = memory
                may_refuse = "grid" in kind or (way == "python" and kind in NOT_OF_PYTHON) or "built without" in said
                wrong = wrong or ("the whole file is refused" if status and not may_refuse else "")
            # GDCM makes room for what an element says to hold, within what the trial allows.
            elif memory > self._needed.get((kind, way), 0) * MOST_GROWTH + MOST_KIB * (
                    3 if kind.startswith("dicom") else 1):
                wrong = wrong or f"it takes {memory >> 10} MiB"
            if wrong:
                self._tell(kind, number, way, wrong, said)

    def _tell(self, kind: str, number: int, way: str, wrong: str, said: str) -> None:
        self.found += 1
        kept = self._kept / f"{kind.replace(os.sep, '_')}-{number}"
        shutil.copytree(self._folder, kept, dirs_exist_ok=True)
        last = said.strip().replace("\n", " | ")[:300]
        print(f"FAILED: {kind} {number}, opened as {way}: {wrong} [{last}] ({kept})", flush=True)


def seeds(kinds: list[str]) -> list[tuple[str, int]]:
    lines = SEEDS.read_text(encoding="utf-8").splitlines() if SEEDS.exists() else []
    pairs = [line.split() for line in lines if line and not line.startswith("#")]
    return [(kind, int(number)) for kind, number, *_ in pairs if kind in kinds]


def main() -> None:
    arguments = argparse.ArgumentParser(description=__doc__)
    arguments.add_argument("--opener", required=True, help="the program's command line")
    arguments.add_argument(
        "--ways", default="explorer,orbit", help="in which it opens volumes; default: explorer,orbit")
    arguments.add_argument("--count", type=int, default=20, help="broken files of each kind")
    arguments.add_argument("--first", type=int, default=1, help="the number of the first of them")
    arguments.add_argument(
        "--kinds", default="", help=f"of {', '.join(ORIGINALS)}; default: what the ways can open")
    arguments.add_argument(
        "--files", nargs="*", default=[], help="break these, instead of the small ones")
    arguments.add_argument("--scratch", help="a folder to write in; what is found stays there")
    given = arguments.parse_args()

    ways = given.ways.split(",")
    unknown = {"npy"} if "python" not in ways else {
        kind for kind in ORIGINALS if kind in ("session", "raw") or kind.startswith("dicom")}
    kinds = given.kinds.split(",") if given.kinds else [k for k in ORIGINALS if k not in unknown]
    kinds = given.files or kinds
    scratch = pathlib.Path(given.scratch or tempfile.mkdtemp()).resolve()
    scratch.mkdir(parents=True, exist_ok=True)
    opener = Opener(shlex.split(given.opener), ways, scratch)
    campaign = Campaign(opener, scratch)
    begin = time.monotonic()
    numbers = [0, *range(given.first, given.first + given.count)]
    for kind, number in [*((kind, 0) for kind in kinds), *seeds(kinds)]:
        campaign.open(kind, number)
    for number in numbers[1:]:
        for kind in kinds:
            campaign.open(kind, number)
    opener.close()
    print(
        f"[files] {'FAILED' if campaign.found else 'PASSED'}: {campaign.opened} times opened, "
        f"{campaign.pictures} pictures, {campaign.found} answers wrong, in "
        f"{time.monotonic() - begin:.0f} s")
    sys.exit(1 if campaign.found else 0)


main()
