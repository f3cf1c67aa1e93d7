# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""NRRDs are read as they say: values, places, time steps. One that is refused gets a sentence with the reason."""

from __future__ import annotations

import struct
import sys
import unittest
import zlib

import read_files
from originals import ORIGINALS, SIZE, Original, ball
from read_files import Files, same

BALL = [round(value) for value in ball()]
COUNT = len(BALL)


def header(kind: str = "nrrd", name: str = "a.nrrd", **fields: str) -> Original:
    """An original whose fields are others; None takes one away, and a new one is added."""
    original = ORIGINALS[kind](same)
    head, end, samples = original.files[name].partition(b"\n\n")
    lines = head.decode().rstrip("\n").split("\n")
    for key, value in fields.items():
        key = key.replace("_", " ")
        lines = [line for line in lines if not line.startswith(key + ": ")]
        if value is not None:
            lines.append(f"{key}: {value}")
    original.files[name] = "\n".join(lines).encode() + (end or b"\n") + samples
    return original


def with_samples(original: Original, samples: bytes) -> Original:
    head = original.files["a.nrrd"].partition(b"\n\n")[0]
    return Original("a.nrrd", {"a.nrrd": head + b"\n\n" + samples})


class Nrrds(Files):
    def test_encodings_and_orders(self) -> None:
        for kind in ("nrrd", "nrrd-gzip", "nrrd-text", "nhdr-gzip"):
            told = self.read(ORIGINALS[kind](same))
            self.assert_close(told.range, [min(BALL), max(BALL)])
            self.assert_close(told.values, [BALL[i] for i in (0, 1, SIZE[0], SIZE[0] * SIZE[1], -1)])
        self.assert_close(self.read(ORIGINALS["nhdr"](same)).range, [min(ball()), max(ball())])

    def test_types(self) -> None:
        for name, code in (("signed char", "b"), ("uint8_t", "B"), ("ushort", "H"), ("int32", "i"),
                           ("unsigned int", "I"), ("long long", "q"), ("uint64", "Q"), ("double", "d")):
            values = [value // 2 for value in BALL]
            told = self.read(with_samples(header(type=name), struct.pack(f"<{COUNT}{code}", *values)))
            self.assert_close(told.range, [min(values), max(values)])

    def test_places(self) -> None:
        told = self.read(header(space_directions="(0,2,0) (-1,0,0) (0,0.5,3)", space_origin="(10,20,30)"))
        self.assert_close(told.places[0], [10, 20, 30])
        for step, wanted in zip(told.steps(), ([0, 2, 0], [-1, 0, 0], [0, 0.5, 3])):
            self.assert_close(step, wanted)
        for space in ("LAS", "left-anterior-superior", "3D-left-handed"):
            told = self.read(header(space=space))
            self.assert_close(told.places[0], [-1.5, 0, -2])
            self.assert_close(told.steps()[0], [-1, 0, 0])
        told = self.read(header(space_directions=None, spacings="1 2 3"))
        self.assert_close([step[i] for i, step in enumerate(told.steps())], [1, 2, 3])

    def test_colors(self) -> None:
        pixels = struct.pack(f"<{3 * COUNT}h", *(n * value for value in BALL for n in (1, 2, 3)))
        for fields in ({"kinds": "RGB-color domain domain domain"}, {"kinds": None}):
            told = self.read(with_samples(header(
                dimension="4", sizes="3 9 8 7", space_directions="none (1,0,0) (0,1,0) (0,0,1)", **fields), pixels))
            self.assert_close(told.values[:1], BALL[:1])
        text = " ".join(map(str, struct.unpack(f"<{3 * COUNT}h", pixels))).encode()
        told = self.read(with_samples(header(
            dimension="4", sizes="3 9 8 7", space_directions=None, kinds=None, encoding="text"), text))
        self.assert_close(told.values[2:3], [BALL[SIZE[0]]])

    def test_time_steps(self) -> None:
        volumes = [[value + 1000 * step for value in BALL] for step in range(5)]
        behind = [value for volume in volumes for value in volume]
        together = [value for values in zip(*volumes) for value in values]
        for samples, fields in (
                (behind, {"kinds": "domain domain domain list", "sizes": "9 8 7 5"}),
                (behind, {"kinds": "domain domain domain time", "sizes": "9 8 7 5"}),
                (behind, {"kinds": None, "sizes": "9 8 7 5"}), (behind, {
                    "kinds": None, "sizes": "9 8 7 5", "spacings": "1 1 1 nan"}),
                (together, {"kinds": "list domain domain domain", "sizes": "5 9 8 7"})):
            for encoding in ("raw", "gzip"):
                data = struct.pack(f"<{len(samples)}h", *samples)
                path = self.write(with_samples(
                    header(dimension="4", space_directions=None, encoding=encoding, **fields),
                    data if encoding == "raw" else zlib.compress(data, wbits=31)))
                for step in (1, 3, 5):
                    told = self.tell(path, time_step=step)
                    self.assert_close(told.values[:1], [BALL[0] + 1000 * (step - 1)])
                self.assert_refused(self.tell(path, time_step=6), "a.nrrd", "5 time steps")

    def test_files_of_samples(self) -> None:
        data = struct.pack(f"<{COUNT}h", *BALL)
        part = len(data) // SIZE[2]
        files = {f"s {k:02}.raw": data[k * part:(k + 1) * part] for k in range(SIZE[2])}
        names = "\n".join(files)
        whole = self.read(ORIGINALS["nrrd"](same))
        for field in (f"LIST\n{names}", f"LIST 2\n{names}"):
            original = header("nhdr", "a.nhdr", type="short", endian="little", data_file=None)
            original.files = {"a.nhdr": original.files["a.nhdr"] + b"data file: " + field.encode() + b"\n", **files}
            self.assertEqual(self.read(original).values, whole.values)
        original = header("nhdr", "a.nhdr", type="short", endian="little", data_file="s%02d.raw 0 6 1")
        original.files.update({name.replace(" ", ""): content for name, content in files.items()})
        self.assertEqual(self.read(original).values, whole.values)
        del original.files["s03.raw"]
        (self.folder / "s03.raw").unlink()
        self.assert_refused(self.tell(self.write(original)), "s03.raw", "not there")

    def test_skipped_bytes(self) -> None:
        whole = self.read(ORIGINALS["nhdr"](same))
        for skip, before in (("20", 20), ("-1", 33)):
            original = header("nhdr", "a.nhdr", byte_skip=skip)
            original.files["a.raw"] = bytes(before) + original.files["a.raw"]
            self.assertEqual(self.read(original).values, whole.values)
        original = header("nhdr", "a.nhdr")
        original.files["a.raw"] += bytes(10)
        self.assertIn("10 bytes more", self.read(original).remark)

    def test_refusals(self) -> None:
        for fields, words in (
                ({"encoding": "bzip2"}, "encoding 'bzip2'"), ({"encoding": "hex"}, "encoding 'hex'"),
                ({"type": "block"}, "type 'block'"), ({"endian": None}, "endian"), ({"line_skip": "2"}, "line skip"),
                ({"sizes": "9 8"}, "2 sizes of 3 axes"), ({"sizes": None}, "no sizes"),
                ({"sizes": "9 8 -7"}, "'-7' as one of its sizes"), ({"sizes": "9 8 99999999"}, "more samples"),
                ({"sizes": "2000000000 2000000000 2000000000"}, "more samples"), ({"sizes": "9 8 8"}, "fewer samples"),
                ({"dimension": "2", "sizes": "72 7", "kinds": None, "space_directions": None}, "three axes"),
                ({"space_directions": "(1,0,0) (0,1,0)"}, "each axis"),
                ({"space_directions": "none (0,1,0) (0,0,1)"}, "each other"),
                ({"space_directions": "(1,0) (0,1) (0,0)"}, "'(1,0)'"),
                ({"space_directions": "(0,0,0) (0,1,0) (0,0,1)"}, "cannot be seen"),
                ({"space_directions": "(1,0,0) (1,0,0) (0,0,1)"}, "cannot be seen"),
                ({"space_origin": "(nan,0,0)"}, "place in space"), ({"data_file": "b.raw"}, "b.raw"),
                ({"data_file": "b%n.raw 1 3 1"}, "pattern"), ({"data_file": "%d.raw 1 999999999 1"}, "files of samples"),
                ({"data_file": "."}, "no file"), ({"data_file": "LIST"}, "0 files")):
            with self.subTest(fields=fields):
                self.assert_refused(self.tell(self.write(header(**fields))), "a.nrrd", words)

    def test_files_that_are_cut_short(self) -> None:
        for kind, most in (("nrrd", 1), ("nrrd-gzip", 1), ("nrrd-text", 3), ("nhdr", 1), ("nhdr-gzip", 1)):
            original = ORIGINALS[kind](same)
            name = "a.raw" if kind.startswith("nhdr") else "a.nrrd"
            data = original.files[name]
            for size in (0, 3, len(data) // 2, len(data) - 9, len(data) - most):
                original.files[name] = data[:size]
                with self.subTest(kind=kind, size=size):
                    self.assert_refused(self.tell(self.write(original)), original.main)

    def test_sums_of_compressed_samples(self) -> None:
        original = ORIGINALS["nrrd-gzip"](same)
        data = bytearray(original.files["a.nrrd"])
        data[-6] ^= 1
        original.files["a.nrrd"] = bytes(data)
        self.assert_refused(self.tell(self.write(original)), "no good end")


if __name__ == "__main__":
    read_files.OPENER = sys.argv.pop(1)
    unittest.main()
