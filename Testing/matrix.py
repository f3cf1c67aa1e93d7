#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""Write Documentation/Tests.md: what is promised, and which test holds it.

usage: Testing/matrix.py

Each test begins with a comment that says what it protects, in one paragraph behind the licence. The page
is made of these comments alone. .ci/structure fails where one is missing, or the page is not up to date.
"""

import ast
import pathlib
import re
import sys

TESTING = pathlib.Path(__file__).resolve().parent
PAGE = TESTING.parent / "Documentation/Tests.md"

PATTERNS = ["Engine/**/Test*.cxx", "Cxx/**/Test*.cxx", "Explorer/Test*.cxx", "*/Test*.py", "*/run.sh",
            "Files/read_*.py", "InsideVTK/CheckNamespace.cmake", "Run*.cmake"]
#: It measures, and promises nothing.
LEFT_OUT = TESTING / "Benchmarks"
#: The heading of what is in neither Cxx nor Engine.
ELSEWHERE = "Elsewhere"

HEAD = """\
# What is promised, and the test that holds it

`Testing/matrix.py` makes this page of the comments at the heads of the tests: change those, and run it.

* `Testing/run.sh -R NAME` builds and runs the tests whose names contain NAME. In `Cxx`, a test has the name of its file. In
  `Engine` and `Cxx/VolumeFiles`, a test has the name of a suite: it stands in parentheses, or is the file's name without
  `Test`.
* Scripts (`run.sh --help`) take long, or need more than a build. [Robustness](Robustness.md) tells what they found.
* Brute force (`Common/Truth`; for blended volumes `Common/Integral`) shares no code with the engine.
"""


def tests():
    """The files that hold promises."""
    found = {path for pattern in PATTERNS for path in TESTING.glob(pattern)}
    return sorted(path for path in found if LEFT_OUT not in path.parents)


def promise_of(path):
    """The first paragraph of the comment at the head of a file; empty if there is none."""
    text = path.read_text()
    if path.suffix == ".py":
        lines = (ast.get_docstring(ast.parse(text)) or "").splitlines()
    else:
        mark = "//" if path.suffix == ".cxx" else "#"
        behind = iter(text.split("SPDX-License-Identifier: BSD-3-Clause\n", 1)[1].splitlines())
        lines = []
        for line in behind:
            if line.startswith(mark):
                lines.append(line[len(mark):].strip())
            elif line or any(lines):
                break
        while lines and not lines[0]:
            del lines[0]
    paragraph = lines[:lines.index("")] if "" in lines else lines
    return " ".join(paragraph).replace("|", "\\|")


def name_of(path):
    """What a test is called, with its suites where these have other names."""
    if folder_of(path) == ELSEWHERE:
        return f"`{path.relative_to(TESTING)}`"
    found = re.findall(r"^(?:TYPED_)?TEST(?:_F|_P)?\((\w+),", path.read_text(), re.MULTILINE)
    suites = sorted(set(found) - {path.stem.removeprefix("Test")})
    return f"`{path.stem}`" + (f" ({', '.join(f'`{suite}`' for suite in suites)})" if suites else "")


def folder_of(path):
    """The heading that a test stands under."""
    parts = path.relative_to(TESTING).parts[:-1]
    return "/".join(parts[:2]) if parts and parts[0] in ("Cxx", "Engine") else ELSEWHERE


def without_promise():
    """Files of tests that do not say what they protect."""
    return [path for path in tests() if not promise_of(path)]


def page():
    """The text of the page."""
    rows = {}
    for path in tests():
        rows.setdefault(folder_of(path), []).append(f"| {promise_of(path)} | {name_of(path)} |")
    folders = sorted(rows, key=lambda folder: (folder == ELSEWHERE, folder))
    return HEAD + "".join(
        f"\n## {folder}\n\n| promise | test |\n|---|---|\n" + "\n".join(rows[folder]) + "\n" for folder in folders)


def main():
    """Write the page."""
    for path in without_promise():
        print(f"{path.relative_to(TESTING)} begins with no comment that says what it protects")
    PAGE.write_text(page())
    return bool(without_promise())


if __name__ == "__main__":
    sys.exit(main())
