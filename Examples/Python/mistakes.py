# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""How the examples tell what is wrong: one sentence on the terminal, exit status 1."""

from __future__ import annotations

import argparse
import os
import pathlib
import sys
from typing import Callable

MOST_CHARACTERS = 240  # of a text in a message; many paths are long
CHARACTERS_OF_END = 80  # which is where the name of a file is


class UserError(Exception):
    """A mistake of the user: one sentence that says what to do."""


class Arguments(argparse.ArgumentParser):
    """A command line whose mistakes are told in one sentence."""

    def error(self, message):
        raise UserError(f"{shortened(message)}; --help tells what can be given.")


def printable(text: str) -> str:
    r"""A text for one line of a terminal: what could steer it is shown as its bytes, "\x1b"."""
    return "".join(
        character if character.isprintable() else "".join(
            f"\\x{byte:02x}" for byte in character.encode("utf-8", "surrogateescape"))
        for character in text)


def shortened(text: str) -> str:
    """A text without its middle, where it is much too long."""
    if len(text) <= MOST_CHARACTERS:
        return text
    return f"{text[:MOST_CHARACTERS - CHARACTERS_OF_END]} ... {text[-CHARACTERS_OF_END:]}"


def quoted(text: str) -> str:
    """A text of the user's or of a file, for a message."""
    return f"'{printable(shortened(text))}'"


def run(main: Callable[[], None]) -> None:
    """Run a program: exit status 0, or 1 and one line for a mistake of the user."""
    try:
        main()
        sys.stdout.flush()
    except UserError as error:
        _end_with(str(error))
    except MemoryError:
        _end_with("There is not enough memory for this: choose a smaller volume or picture.")
    except KeyboardInterrupt:
        pass
    except BrokenPipeError:
        # Who reads what is printed has gone, as head does; the interpreter is not to print more.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        sys.exit(1)


def _end_with(sentence: str) -> None:
    sys.exit(f"{pathlib.Path(sys.argv[0]).name}: {printable(sentence)}")
