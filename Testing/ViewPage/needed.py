# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""Ends a test as skipped where something is missing that it needs. Import it before all else."""

import shutil
import sys

#: What ctest counts as skipped.
SKIPPED = 77


def skip(why):
    """End this process: the test cannot run here."""
    print(f"SKIPPED: {why}")
    sys.exit(SKIPPED)


def program(*names, package):
    """The path of a program, the first that is there."""
    for name in names:
        path = shutil.which(name)
        if path:
            return path
    return skip(f"there is no {names[0]} here (Debian: {package})")


try:
    import numpy  # noqa: F401
except ImportError as error:
    skip(f"there is no NumPy here (Debian: python3-numpy): {error}")
