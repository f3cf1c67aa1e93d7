# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""Broken files, made of whole ones: the same number always makes the same file."""

from __future__ import annotations

import random
import re
import struct

from originals import Original

NUMBERS = [
    0, -1, 1, 2, 3, 5, 7, 8, 9, 16, 64, 100, 127, 128, 255, 256, 1000, 4095, 32767, 32768, 65535, 65536,
    99999, 10**6, 10**8, 10**9, 2**31 - 1, 2**31, 2**32 - 1, 2**32, 2**40, 2**62, 2**63 - 1, 2**63,
    2**64 - 1, 10**20, 10**40, -2, -7, -128, -32768, -2**31, -2**31 - 1, -2**63, 0.5, -0.5, 0.1, 1e-3,
    1e-10, 1e-38, 1e-40, 1e-300, 5e-324, 1e10, 1e30, 1e38, 1e39, 1e300, 1.7e308, -1e300, float("nan"),
    float("inf"), float("-inf")]
TEXTS = [
    b"", b" ", b"x", b"nan", b"inf", b"-inf", b"0x10", b"1e", b"--1", b"1 1", b"1e999", b"+5", b"\0",
    b"\xff", b"\n", b"%n%n%s", b"9" * 40, b"a" * 300, b"b" * 5000, b"../..", b"1,5"]


class Mutator:
    """Breaks one original."""

    def __init__(self, number: int, kind: str) -> None:
        self._dice = random.Random(f"{kind} {number}")
        self._odds = self._dice.choice((0.0, 0.0, 0.02, 0.08, 0.3))

    def twist(self, value: object) -> object:
        """A number on its way into a file."""
        if self._dice.random() >= self._odds:
            return value
        if self._dice.random() < 0.4 and isinstance(value, (int, float)):
            return value + self._dice.choice((-1, 1, 2, -2, 10, 1000))
        return self._dice.choice(NUMBERS)

    def break_files(self, original: Original) -> None:
        """Break what is written; not at all where enough numbers are wrong."""
        names = sorted(original.files)
        for _ in range(self._dice.choice((0, 1, 1, 2, 4)) if self._odds else
                       self._dice.choice((1, 1, 1, 2, 3, 6))):
            name = self._dice.choice(names)
            if original.main and self._dice.random() < 0.7:
                name = original.main
            change = self._dice.choice(self._changes())
            original.files[name] = bytes(change(bytearray(original.files[name]), original))

    def _changes(self):
        return [
            self._flip_bits, self._flip_bits, self._write_bytes, self._cut, self._cut, self._lengthen,
            self._number_in_text, self._number_in_text, self._number_in_text, self._integer,
            self._integer, self._integer, self._line, self._line, self._part, self._part, self._word,
            self._word, self._word, self._text]

    def _place(self, data: bytearray) -> int:
        """Somewhere, rather near the beginning, where headers are."""
        most = len(data) if self._dice.random() < 0.4 else min(len(data), 700)
        return self._dice.randrange(max(most, 1))

    def _flip_bits(self, data, _):
        for _ in range(self._dice.choice((1, 1, 2, 5, 30))):
            if data:
                data[self._place(data) % len(data)] ^= 1 << self._dice.randrange(8)
        return data

    def _write_bytes(self, data, _):
        at = self._place(data)
        size = self._dice.choice((1, 2, 4, 8, 40, 300))
        data[at:at + size] = self._dice.choice((
            self._dice.randbytes(size), bytes(size), b"\xff" * size, b"9" * size))
        return data

    def _cut(self, data, _):
        if self._dice.random() < 0.5:
            return data[:self._place(data)]
        return data[:max(len(data) - self._dice.choice((1, 2, 4, 10, 50)), 0)]

    def _lengthen(self, data, _):
        size = self._dice.choice((1, 10, 1000, 20000))
        return data + self._dice.choice((bytes(size), self._dice.randbytes(size), data[:size]))

    def _number_in_text(self, data, _):
        found = list(re.finditer(rb"-?\d+(\.\d+)?", bytes(data[:6000])))
        if not found:
            return data
        at = self._dice.choice(found[:60])
        new = str(self._dice.choice(NUMBERS)).encode() if self._dice.random() < 0.8 else \
            self._dice.choice(TEXTS)
        return data[:at.start()] + new + data[at.end():]

    def _integer(self, data, _):
        code = self._dice.choice(("<B", "<H", "<I", "<Q", ">H", ">I", ">Q", "<f", "<d"))
        size = struct.calcsize(code)
        at = self._place(data) & ~(self._dice.choice((1, 2, 4)) - 1)
        value = self._dice.choice(NUMBERS)
        try:
            made = struct.pack(code, float(value)) if code[1] in "fd" else struct.pack(
                code, int(value) & ((1 << 8 * size) - 1))
        except (OverflowError, ValueError):
            made = b"\x7f" * size
        data[at:at + size] = made
        return data

    def _line(self, data, _):
        lines = bytes(data).split(b"\n")
        a = self._dice.randrange(min(len(lines), 30))
        b = self._dice.randrange(min(len(lines), 30))
        kind = self._dice.randrange(4)
        if kind == 0:
            del lines[a]
        elif kind == 1:
            lines.insert(b, lines[a])
        elif kind == 2:
            lines[a], lines[b] = lines[b], lines[a]
        else:
            lines[a:a + 1] = [lines[a]] * self._dice.choice((2, 50, 3000))
        return b"\n".join(lines)

    def _part(self, data, _):
        size = self._dice.choice((1, 4, 16, 60, 300))
        a, b = self._place(data), self._place(data)
        kind = self._dice.randrange(3)
        if kind == 0:
            del data[a:a + size]
        elif kind == 1:
            data[b:b] = data[a:a + size]
        else:
            data[a:a + size], data[b:b + size] = data[b:b + size], data[a:a + size]
        return data

    def _word(self, data, original):
        if not original.words:
            return self._integer(data, original)
        new = self._dice.choice(original.words)
        found = [at for word in original.words for at in re.finditer(re.escape(word), bytes(data))]
        found += list(re.finditer(rb"[A-Za-z_.]{2,}", bytes(data[:2000])))
        if not found:
            return data
        at = self._dice.choice(found)
        return data[:at.start()] + new + data[at.end():]

    def _text(self, data, _):
        at = self._place(data)
        return data[:at] + self._dice.choice(TEXTS) + data[at + self._dice.choice((0, 1, 5)):]
