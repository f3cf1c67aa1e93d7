# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures as TIFF and PNG, written without a library, the same everywhere."""

from __future__ import annotations

import math
import struct
import zlib
from typing import Callable

Twist = Callable[[object], object]

SHORT, LONG, TEXT, RATIO = 3, 4, 2, 5


def whole(value: object, bits: int) -> int:
    number = int(value) if isinstance(value, (int, float)) and math.isfinite(value) else 0
    return number & ((1 << bits) - 1)


def tiff(pages: list[bytes], width: int, height: int, twist: Twist = lambda value: value, bits: int = 16,
         tags: dict | None = None, order: str = "<", compress: bool = False, tile: int = 0) -> bytes:
    """A header for each page, behind its samples. Tags are others: number: (type, value), or None to leave it out."""
    t = twist
    data = struct.pack(order + "2sHI", b"II" if order == "<" else b"MM", 42, 0)
    link = 4
    for samples in pages:
        size = max(bits // 8, 1)
        if tile:
            strips = []
            for y in range(0, height, tile):
                for x in range(0, width, tile):
                    rows = [samples[(j * width + x) * size:(j * width + min(x + tile, width)) * size].ljust(
                        tile * size, b"\0") for j in range(y, min(y + tile, height))]
                    strips.append(b"".join(rows).ljust(tile * tile * size, b"\0"))
        else:
            strips = [samples]
        strips = [zlib.compress(strip) if compress else strip for strip in strips]
        places, counts = [], []
        for strip in strips:
            places.append(t(len(data)))
            counts.append(t(len(strip)))
            data += strip + b"\0" * (len(strip) % 2)
        entries: dict = {
            256: (LONG, t(width)), 257: (LONG, t(height)), 258: (SHORT, t(bits)), 259: (SHORT, t(8 if compress else 1)),
            262: (SHORT, t(1)), 277: (SHORT, t(1)), 339: (SHORT, t(1))}
        entries.update({322: (SHORT, t(tile)), 323: (SHORT, t(tile)), 324: (LONG, places), 325: (LONG, counts)}
                       if tile else {273: (LONG, places), 278: (LONG, t(height)), 279: (LONG, counts)})
        entries.update(tags or {})
        entries = {tag: entry for tag, entry in entries.items() if entry}
        more = b""
        rest = len(data) + 2 + 12 * len(entries) + 4
        head = struct.pack(order + "H", len(entries))
        for tag in sorted(entries):
            kind, value = entries[tag]
            if kind == TEXT:
                content, count = value + b"\0", len(value) + 1
            elif kind == RATIO:
                content, count = struct.pack(order + "2I", whole(t(round(1000 * value)), 32), 1000), 1
            else:
                values = value if isinstance(value, list) else [value]
                content, count = b"".join(
                    struct.pack(order + ("H" if kind == SHORT else "I"), whole(one, 16 if kind == SHORT else 32))
                    for one in values), len(values)
            if len(content) > 4:
                place = rest + len(more)
                more += content + b"\0" * (len(content) % 2)
                content = struct.pack(order + "I", place)
            head += struct.pack(order + "HHI", tag, kind, count) + content.ljust(4, b"\0")
        data = data[:link] + struct.pack(order + "I", whole(t(len(data)), 32)) + data[link + 4:]
        link = len(data) + len(head)
        data += head + struct.pack(order + "I", 0) + more
    return data


def png(samples: bytes, width: int, height: int, twist: Twist = lambda value: value, bits: int = 8, color: int = 0,
        colors: bytes = b"") -> bytes:
    """Samples have the order of bytes of PNG, the larger first."""
    def chunk(kind: bytes, content: bytes) -> bytes:
        return struct.pack(">I", len(content)) + kind + content + struct.pack(">I", zlib.crc32(kind + content))

    t = twist
    row = len(samples) // height
    lines = b"".join(b"\0" + samples[row * j:row * (j + 1)] for j in range(height))
    header = b"".join(struct.pack(code, whole(t(value), n)) for code, value, n in (
        (">I", width, 32), (">I", height, 32), ("B", bits, 8), ("B", color, 8), ("B", 0, 8), ("B", 0, 8), ("B", 0, 8)))
    palette = chunk(b"PLTE", colors) if colors else b""
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + palette + chunk(b"IDAT", zlib.compress(lines)) + \
        chunk(b"IEND", b"")
