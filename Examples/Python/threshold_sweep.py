#!/usr/bin/python3
# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""A sweep of isovalues over a volume, saved as an animation. No display is needed.

The view stays the same, so that the mapper looks most isosurfaces up instead of casting all rays
again: the table has the route and the milliseconds of each frame.
"""

from __future__ import annotations

import argparse
import contextlib
import os
import statistics
from typing import Iterator

from mistakes import Arguments, UserError, printable, quoted, run
# Before other packages, as it tells what is missing.
from volumes import add_volume_arguments, check_isovalue, number_from, size_of, volume_of

import numpy
from scene import Scene
from vtkmodules.vtkIOOggTheora import vtkOggTheoraWriter
from vtkTemporalCoherence import numpy_to_image, write_png


class Folder:
    """A series of PNGs."""

    def __init__(self, path: str, _rate: int) -> None:
        self._path = path
        self._count = 0
        os.makedirs(path, exist_ok=True)

    def add(self, color: numpy.ndarray) -> None:
        write_png(os.path.join(self._path, f"frame-{self._count:04}.png"), color)
        self._count += 1

    def close(self) -> None:
        pass


class Theora:
    """An Ogg Theora video, by VTK's own writer."""

    def __init__(self, path: str, rate: int) -> None:
        open(path, "wb").close()  # an error now, not after the sweep
        self._writer = vtkOggTheoraWriter()
        self._writer.SetFileName(path)
        self._writer.SetRate(rate)
        self._is_started = False

    def add(self, color: numpy.ndarray) -> None:
        # An image of one slice, on black: colours are multiplied by alpha already.
        self._writer.SetInputData(numpy_to_image(color[None, ..., :3]))
        if not self._is_started:
            self._writer.Start()
            self._is_started = True
        self._writer.Write()

    def close(self) -> None:
        self._writer.End()


class Gif:
    """An animated GIF, by Pillow."""

    def __init__(self, path: str, rate: int) -> None:
        try:
            from PIL import Image
        except ImportError as error:
            raise UserError(
                "GIFs are written by Pillow, which is missing: install it (Debian: python3-pil) or "
                "name a file .ogv or a folder.") from error
        open(path, "wb").close()
        self._from_array = Image.fromarray
        self._path = path
        self._milliseconds = 1000 // rate
        self._pictures: list[Image.Image] = []

    def add(self, color: numpy.ndarray) -> None:
        # Pillow's first row is the top one.
        self._pictures.append(self._from_array(color[::-1, :, :3]).quantize())

    def close(self) -> None:
        self._pictures[0].save(
            self._path, save_all=True, append_images=self._pictures[1:],
            duration=self._milliseconds, loop=0)


@contextlib.contextmanager
def writing(path: str) -> Iterator[None]:
    """Tells what goes wrong meanwhile as a mistake in --output."""
    try:
        yield
    except OSError as error:
        raise UserError(
            f"{quoted(path)} cannot be written ({error.strerror}): choose another --output.") from error


def animation(path: str, rate: int) -> Folder | Theora | Gif:
    kinds = {".ogv": Theora, ".gif": Gif, "": Folder}
    suffix = os.path.splitext(path)[1].lower()
    if suffix not in kinds:
        raise UserError(
            f"Animations {quoted(suffix)} are not written here: name a file .ogv or .gif, or a folder.")
    with writing(path):
        return kinds[suffix](path, rate)


def parse() -> argparse.Namespace:
    arguments = Arguments(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    add_volume_arguments(arguments)
    arguments.add_argument(
        "--from", dest="first", type=float, metavar="VALUE",
        help="the first isovalue; default: a tenth above the least value")
    arguments.add_argument(
        "--to", dest="last", type=float, metavar="VALUE",
        help="the last one; default: a tenth below the greatest value")
    arguments.add_argument("--frames", type=number_from(2), default=60, help="default: 60")
    arguments.add_argument(
        "--size", type=size_of, default=(512, 512), metavar="WxH", help="pixels; default: 512x512")
    arguments.add_argument(
        "--azimuth", type=float, default=30.0, help="degrees around the z axis; default: 30")
    arguments.add_argument(
        "--rate", type=number_from(1, 100), default=15, help="frames per second; default: 15")
    arguments.add_argument(
        "--output", default="threshold_sweep.ogv",
        help="a file .ogv (written by VTK) or .gif (by Pillow), or a folder for PNGs; "
        "default: threshold_sweep.ogv")
    return arguments.parse_args()


def main() -> None:
    given = parse()
    scene = Scene(volume_of(given))
    low, high = scene.limits
    first = low + 0.1 * (high - low) if given.first is None else given.first
    last = high - 0.1 * (high - low) if given.last is None else given.last
    for isovalue in (first, last):
        check_isovalue(isovalue, scene.limits)

    # What will be looked up is known ahead: the second frame builds the isomap of all isovalues.
    scene.mapper.SetIsomapRange(min(first, last), max(first, last))

    output = animation(given.output, given.rate)
    milliseconds: dict[str, list[float]] = {}
    print("frame  isovalue  route              ms")
    for frame, isovalue in enumerate(numpy.linspace(first, last, given.frames)):
        picture = scene.picture(isovalue, given.azimuth, given.size)
        with writing(given.output):
            output.add(picture.color)
        route, taken = scene.how()
        milliseconds.setdefault(route, []).append(taken)
        print(f"{frame:5}  {isovalue:8.6g}  {route:14}  {taken:5.1f}")
    with writing(given.output):
        output.close()

    for route, taken in milliseconds.items():
        print(f"{route:14}  {len(taken):4} frames, median {statistics.median(taken):6.1f} ms")
    print(f"saved as {printable(given.output)}")


if __name__ == "__main__":
    run(main)
