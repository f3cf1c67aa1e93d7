#!/usr/bin/python3
# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""Makes README's moving picture: the isovalue of a brain is dragged, then the brain turns.

It needs Pillow (Debian package python3-pil) and, unless a volume is named, Debian's package
mricron-data. The milliseconds are the mapper's, for a picture larger than what is shown.
"""

from __future__ import annotations

import math
import sys
from pathlib import Path

import numpy
from PIL import Image, ImageDraw, ImageFont

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "Examples" / "Python"))
from mistakes import Arguments, run
from scene import Scene
from volumes import number_from, read_volume

BRAIN = "/usr/share/mricron/templates/ch2bet.nii.gz"
BACKGROUND = (255, 255, 255)
INK = (90, 90, 90)
MILLISECONDS = 70  # of a frame
FINER = 2  # pixels of the mapper for one of the film, along each side
MIDDLE = 0.58  # the share of each picture, along each side, that is shown


def moves(least: float, greatest: float, count: int) -> list[tuple[str, float, float]]:
    """A word, the isovalue and the azimuth of each frame. The last leads to the first."""
    shown = []
    for frame in range(count):
        share = 0.5 - 0.5 * math.cos(2.0 * math.pi * frame / count)
        shown.append(("isovalue", least + share * (greatest - least), 30.0))
    for frame in range(count):
        shown.append(("turn", least, 30.0 + 360.0 * frame / count))
    return shown


def picture(scene: Scene, move: tuple[str, float, float], size: int) -> Image.Image:
    what, isovalue, azimuth = move
    whole = round(FINER * size / MIDDLE)
    planes = scene.picture(isovalue, azimuth, (whole, whole))
    first = (whole - FINER * size) // 2
    middle = slice(first, first + FINER * size)
    drawn = planes.color[::-1][middle, middle]
    # Colours are multiplied by alpha already.
    colors = drawn[..., :3] + (1.0 - drawn[..., 3:] / 255.0) * numpy.array(BACKGROUND)
    image = Image.fromarray(colors.clip(0, 255).astype(numpy.uint8))
    image = image.resize((size, size), Image.LANCZOS)
    said = f"isovalue {isovalue:.3g}" if what == "isovalue" else f"turned to {azimuth % 360:.0f}\u00b0"
    ImageDraw.Draw(image).text(
        (8, 8), f"{said}: {scene.how()[1]:.0f} ms", INK, ImageFont.load_default())
    return image


def main() -> None:
    parser = Arguments(description=__doc__.splitlines()[0])
    parser.add_argument("volume", nargs="?", default=BRAIN, help="an image (%(default)s)")
    parser.add_argument(
        "--from", dest="least", type=float, default=40.0,
        help="the isovalue of the turn, where the drag begins and ends (%(default)s)")
    parser.add_argument(
        "--to", dest="greatest", type=float, default=110.0,
        help="the isovalue in the middle of the drag (%(default)s)")
    parser.add_argument(
        "--output", default=str(Path(__file__).resolve().parent / "Pictures" / "film.webp"),
        help="an animated picture: .webp, .gif or .png (%(default)s)")
    parser.add_argument(
        "--size", type=number_from(1, 10000), default=400, help="pixels along each side (%(default)s)")
    parser.add_argument(
        "--frames", type=number_from(1), default=48, help="of each move (%(default)s)")
    asked = parser.parse_args()
    scene = Scene(read_volume(asked.volume), asked.volume)
    scene.picture(asked.least, 30.0, (64, 64))  # the first frame looks at all samples
    images = [
        picture(scene, move, asked.size)
        for move in moves(asked.least, asked.greatest, asked.frames)
    ]
    images[0].save(
        asked.output, save_all=True, append_images=images[1:], duration=MILLISECONDS, loop=0,
        quality=60, method=6)
    kib = Path(asked.output).stat().st_size / 1024.0
    print(f"PASSED: {asked.output}, {len(images)} frames, {kib:.0f} KiB")


if __name__ == "__main__":
    run(main)
