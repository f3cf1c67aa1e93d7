# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""Files are read as they say: values, places, arrays. A file that is refused gets a sentence with the reason."""

from __future__ import annotations

import atexit
import functools
import math
import os
import pathlib
import shutil
import struct
import subprocess
import sys
import tempfile
import unittest

import meshes
from originals import (
    BIG_ENDIAN, EXPLICIT, ICON, IMPLICIT, META_CONTRADICTIONS, ORIGINALS, RLE, SIZE, Original, dicom, meta, nifti,
    run_lengths)

OPENER = ""


def same(value):
    return value


class Told:
    """What was read of a file."""

    def __init__(self, status: int, said: str) -> None:
        self.status = status
        self.said = said
        lines = [line.partition(" ")[::2] for line in said.splitlines()]
        self.array = next((rest for key, rest in lines if key == "array"), None)
        self.range = next((tuple(map(float, rest.split())) for key, rest in lines if key == "range"), None)
        samples = [list(map(float, rest.split())) for key, rest in lines if key == "sample"]
        self.places = [sample[:3] for sample in samples]
        self.values = [sample[3] for sample in samples]
        self.remark = next((rest for key, rest in lines if key == "remark"), "")

    def steps(self) -> list[list[float]]:
        """From the first sample to its neighbour along each axis."""
        return [[b - a for a, b in zip(self.places[0], place)] for place in self.places[1:4]]


class Files(unittest.TestCase):
    def setUp(self) -> None:
        self.folder = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)

    @staticmethod
    @functools.cache
    def opener() -> subprocess.Popen:
        """The program that opens each file in a process of its own. To start it takes longer than most files."""
        opener = subprocess.Popen([OPENER], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
        atexit.register(opener.communicate)
        return opener

    def tell(self, path: pathlib.Path, array: str = "", way: str = "tell", time_step: int = 1) -> Told:
        said = self.folder / "said"
        opener = self.opener()
        print(way, path, said, array, time_step, sep="\t", file=opener.stdin, flush=True)
        return Told(int(opener.stdout.readline().split()[0]), said.read_text(encoding="utf-8"))

    def write(self, original: Original) -> pathlib.Path:
        for name, data in original.files.items():
            (self.folder / name).write_bytes(data)
        if original.main:
            return self.folder / original.main
        folder = self.folder / "slices"
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir()
        for name in original.files:
            (self.folder / name).rename(folder / name)
        return folder

    def read(self, original: Original, array: str = "") -> Told:
        path = self.write(original)
        told = self.tell(path, array)
        self.assertEqual(told.status, 0, told.said)
        # Of what is read slowly the process that tries it hands the volume over.
        if not path.name.endswith((".vtm", ".vthb")):
            self.assertEqual(self.tell(path, array, "pass").said, told.said)
        return told

    def assert_close(self, numbers, expected) -> None:
        self.assertEqual(len(numbers), len(expected))
        for number, wanted in zip(numbers, expected):
            self.assertAlmostEqual(number, wanted, places=4)

    def assert_refused(self, told: Told, *words: str) -> None:
        self.assertTrue(os.WIFEXITED(told.status) and os.WEXITSTATUS(told.status) == 1, told.status)
        self.assertEqual(told.said.count("\n"), 1, told.said)
        for word in words:
            self.assertIn(word, told.said)


class MetaImages(Files):
    def header(self, **fields: str) -> Original:
        original = meta(True)(same)
        text = original.files["a.mha"]
        for key, value in fields.items():
            line = f"{key} = {value}\n".encode()
            begin = text.find(f"{key} = ".encode())
            if begin >= 0:
                text = text[:begin] + line + text[text.index(b"\n", begin) + 1:]
            else:
                text = text.replace(b"ElementDataFile", line + b"ElementDataFile", 1)
        original.files["a.mha"] = text
        return original

    def test_slope_and_offset(self) -> None:
        plain = self.read(self.header())
        told = self.read(self.header(
            ElementToIntensityFunctionSlope="0.5", ElementToIntensityFunctionOffset="-100"))
        self.assert_close(told.range, [0.5 * value - 100 for value in plain.range])
        told = self.read(self.header(
            ElementToIntensityFunctionSlope="-3", ElementToIntensityFunctionOffset="1000"))
        self.assert_close(told.range, [1000 - 3 * value for value in reversed(plain.range)])

    def test_values_beyond_the_type(self) -> None:
        original = self.header(ElementType="MET_USHORT")
        data = bytearray(original.files["a.mha"])
        struct.pack_into("<3H", data, len(data) - 2 * SIZE[0] * SIZE[1] * SIZE[2], 65535, 1, 0)
        for slope, offset in ((1, -1024), (1000, 0), (0.5, 3), (100000, 1), (-1, 0), (0.0625, 5000)):
            fields = f"ElementToIntensityFunctionSlope = {slope}\nElementToIntensityFunctionOffset = {offset}\n"
            told = self.read(Original("a.mha", {"a.mha": bytes(data).replace(
                b"ElementDataFile", fields.encode() + b"ElementDataFile", 1)}))
            self.assertEqual(told.values[:2], [65535 * slope + offset, slope + offset])

    def test_direction(self) -> None:
        for key in ("TransformMatrix", "Orientation", "Rotation"):
            for rows in ((0, 1, 0, -1, 0, 0, 0, 0, 1), (-1, 0, 0, 0, 1, 0, 0, 0, 1),
                         (0.6, 0.8, 0, -0.8, 0.6, 0, 0, 0, -1), (0, 0, 1, 1, 0, 0, 0, 1, 0)):
                original = self.header(TransformMatrix=" ".join(map(str, rows)))
                text = original.files["a.mha"]
                original.files["a.mha"] = text.replace(b"TransformMatrix", key.encode(), 1)
                told = self.read(original)
                self.assert_close(told.places[0], (1.5, 0, -2))
                for axis, spacing in enumerate((1, 0.5, 2)):
                    self.assert_close(
                        told.steps()[axis], [spacing * cosine for cosine in rows[3 * axis:3 * axis + 3]])

    def test_types_that_are_not_read(self) -> None:
        for kind in ("MET_LONG", "MET_ULONG", "MET_LONG_LONG", "MET_ULONG_LONG", "MET_FLOAT_ARRAY",
                     "MET_DOUBLE_ARRAY", "MET_FLOAT_MATRIX", "MET_STRING"):
            told = self.tell(self.write(self.header(ElementType=kind)))
            self.assert_refused(told, "a.mha", kind, "MET_FLOAT")


class Nifti(Files):
    def header(self, *fields) -> Original:
        """A NIfTI-1 whose samples are i + 10 j + 100 k; of each field, where it is, how, and what."""
        nx, ny, nz = SIZE
        data = bytearray(nifti(False)(same).files["a.nii"])
        for at, code, *numbers in fields:
            struct.pack_into(code, data, at, *numbers)
        samples = [i + 10 * j + 100 * k for k in range(nz) for j in range(ny) for i in range(nx)]
        return Original("a.nii", {"a.nii": bytes(data[:352]) + struct.pack(f"<{len(samples)}h", *samples)})

    def assert_places(self, original: Original, rows) -> None:
        """Each sample lies where the rows of a matrix say, whatever the order of samples in VTK."""
        told = self.read(original)
        for place, value in zip(told.places, told.values):
            index = (value % 10, value // 10 % 10, value // 100, 1)
            self.assert_close(place, [sum(a * b for a, b in zip(row, index)) for row in rows])

    def test_slope_and_intercept(self) -> None:
        plain = self.read(nifti(False)(same))
        for version, at, code in ((1, 112, "<2f"), (2, 176, "<2d")):
            original = nifti(False, version)(same)
            data = bytearray(original.files["a.nii"])
            struct.pack_into(code, data, at, 2.5, -1024.0)
            original.files["a.nii"] = bytes(data)
            told = self.read(original)
            self.assert_close(told.range, [2.5 * value - 1024 for value in plain.range])
            struct.pack_into(code, data, at, 0.0, 17.0)  # no slope: the samples are the values
            original.files["a.nii"] = bytes(data)
            self.assert_close(self.read(original).range, plain.range)

    def test_values_beyond_the_type(self) -> None:
        for slope, intercept in ((1, 40000), (1, 1e9), (0.5, 2 ** 24), (-1000, 0), (0.125, -7), (2 ** 20, 2 ** 30)):
            told = self.read(self.header((112, "<2f", slope, intercept)))
            self.assertEqual(sorted(told.range), sorted([intercept, 678 * slope + intercept]))
            self.assertEqual(told.values[:2], [intercept, slope + intercept])

    def test_floats_beyond_the_type(self) -> None:
        nx, ny, nz = SIZE
        count = nx * ny * nz
        data = bytearray(self.header((70, "<2h", 16, 32), (112, "<2f", 1e30, 0)).files["a.nii"][:352])
        data += struct.pack(f"<{count}f", *(1e20 * i for i in range(count)))
        told = self.read(Original("a.nii", {"a.nii": bytes(data)}))
        self.assertAlmostEqual(told.range[1] / (1e50 * (count - 1)), 1.0, places=6)

    def test_place(self) -> None:
        told = self.read(nifti(False)(same))
        self.assert_close(told.places[0], (1.5, 0, -2))
        self.assert_close(told.steps()[1], (0, 0.5, 0))

    def test_scanner_or_template(self) -> None:
        half = 0.5 ** 0.5
        sform = (280, "<12f", 0, -3, 0, 5, 2, 0, 0, 6, 0, 0, 4, 7)
        mirrored = (280, "<12f", -2, 0, 0, 5, 0, 3, 0, 6, 0, 0, 4, 7)
        nothing = (280, "<12f", *12 * [0])
        turned = (256, "<6f", 0, 0, half, 10, 20, 30)  # by a quarter around z
        pixdim = [1, 1, 0.5, 2]
        by_template = ((0, -3, 0, 5), (2, 0, 0, 6), (0, 0, 4, 7))
        by_mirror = ((-2, 0, 0, 5), (0, 3, 0, 6), (0, 0, 4, 7))
        by_scanner = ((0, -0.5, 0, 10), (1, 0, 0, 20), (0, 0, 2, 30))
        upside_down = ((0, -0.5, 0, 10), (1, 0, 0, 20), (0, 0, -2, 30))
        by_none = ((1, 0, 0, 0), (0, 0.5, 0, 0), (0, 0, 2, 0))
        for codes, qfac, rows, expected in (
                ((1, 2), 1, sform, by_template), ((1, 2), -1, sform, by_template),
                ((0, 2), -1, sform, by_template), ((0, 4), 1, mirrored, by_mirror),
                ((1, 4), 1, mirrored, by_mirror), ((1, 4), -1, mirrored, by_mirror),
                ((1, 0), 1, sform, by_scanner), ((1, 0), -1, sform, upside_down),
                ((1, 0), 0, sform, by_scanner), ((2, 1), 1, nothing, by_scanner),
                ((2, 1), -1, nothing, upside_down), ((0, 0), -1, sform, by_none)):
            self.assert_places(self.header(
                (252, "<2h", *codes), (76, "<4f", qfac, *pixdim[1:]), turned, rows), expected)

    def test_time_steps(self) -> None:
        count = SIZE[0] * SIZE[1] * SIZE[2]
        for last in (3, 1):  # with vectors of two components, too
            vectors = 2 if last == 1 else 1
            data = bytearray(self.header((40, "<6h", 5, *SIZE, 3, vectors)).files["a.nii"][:352])
            for vector in range(vectors):
                for time in range(3):
                    data += struct.pack(f"<{count}h", *(1000 * time + 100 * vector + i % 100 for i in range(count)))
            path = self.write(Original("a.nii", {"a.nii": bytes(data)}))
            for time in range(3):
                told = self.tell(path, time_step=time + 1)
                self.assertEqual((told.status, told.values[:2]), (0, [1000 * time, 1000 * time + 1]), told.said)
            self.assert_refused(self.tell(path, time_step=4), "a.nii", "3 time steps", "instead of 4")


class Dicom(Files):
    def setUp(self) -> None:
        super().setUp()
        told = self.tell(self.write(dicom()(same)))
        shutil.rmtree(self.folder / "slices")
        if "built without" in told.said:
            self.assert_refused(told, "slices", "libgdcm-dev")
            self.skipTest("the programs were built without GDCM")

    def slices(self, position=lambda k: (0, 0, 2 * k), orientation=lambda k: "1\\0\\0\\0\\1\\0") -> Original:
        """Seven slices; those without a position are left out."""
        original = dicom(change=lambda k: {
            (0x20, 0x32): ("DS", "\\".join(f"{x:g}" for x in position(k) or ())),
            (0x20, 0x37): ("DS", orientation(k))})(same)
        original.files = {f"{k}.dcm": original.files[f"{k}.dcm"] for k in range(SIZE[2]) if position(k)}
        return original

    def assert_values(self, told: Told, value, places: int = 9) -> None:
        """The values of slice k, row j and column i: the last slice is the first one, as its rows are."""
        nx, ny, nz = SIZE
        expected = [value(*index) for index in (
            (nz - 1, ny - 1, 0), (nz - 1, ny - 1, 1), (nz - 1, ny - 2, 0), (nz - 2, ny - 1, 0), (0, 0, nx - 1))]
        for number, wanted in zip(told.values, expected):
            self.assertAlmostEqual(number, wanted, places=places)

    def counted(self, sample=lambda k, j, i: i + 10 * j + 100 * k, **fields):
        """Changes: samples by slice, row and column, and others."""
        tags = {"slope": (0x28, 0x1053), "intercept": (0x28, 0x1052), "stored": (0x28, 0x101), "high": (0x28, 0x102),
                "signed": (0x28, 0x103), "kind": (0x28, 0x4), "components": (0x28, 0x2), "planar": (0x28, 0x6),
                "allocated": (0x28, 0x100)}
        numbers = {tags[name]: ("US", [value]) for name, value in fields.items() if isinstance(value, int)}
        texts = {tags[name]: ("DS", value) for name, value in fields.items() if isinstance(value, str)}
        return lambda k: {**numbers, **texts, (0x7fe0, 0x10): (
            "OW", [sample(k, j, i) for j in range(SIZE[1]) for i in range(SIZE[0])])}

    def test_values_beyond_the_type(self) -> None:
        def sample(k, j, i):
            return 65535 if (k, j, i) == (0, 0, 8) else i + 10 * j + 100 * k
        for slope, intercept in ((1, -1024), (0.5, 0), (1000, 0), (-1, 0), (0.5, -0.25), (100000, 1), (0.0625, 5000)):
            told = self.read(dicom(change=self.counted(sample, slope=str(slope), intercept=str(intercept)))(same))
            self.assert_values(told, lambda k, j, i: slope * sample(k, j, i) + intercept)
            self.assertEqual(sorted(told.range), sorted([intercept, 65535 * slope + intercept]))

    def test_slices_with_slopes_of_their_own(self) -> None:
        for factor in (3000, 0.25):
            told = self.read(dicom(change=lambda k: {
                **self.counted()(k), (0x28, 0x1053): ("DS", factor * (k + 1)), (0x28, 0x1052): ("DS", -k)})(same))
            self.assert_values(told, lambda k, j, i: factor * (k + 1) * (i + 10 * j + 100 * k) - k)

    def test_sequences_before_the_pixels(self) -> None:
        size = {(0x28, 0x10): ("US", [3]), (0x28, 0x11): ("US", [2])}
        pixels = {(0x7fe0, 0x10): ("OW", [7, 7, 7, 7, 7, 7])}
        nested = {(0x9, 0x10): ("LO", "SOMEONE"), (0x9, 0x1001): ("SQ", [{
            **size, (0x9, 0x10): ("LO", "SOMEONE"), (0x9, 0x1002): ("SQ", [{**size, **pixels}, {}])}])}
        for syntax in (IMPLICIT, EXPLICIT, BIG_ENDIAN, RLE):
            for more in ({}, ICON, nested, {**ICON, **nested}):
                told = self.read(dicom(syntax, lambda k: {**self.counted()(k), **more})(same))
                self.assert_values(told, lambda k, j, i: i + 10 * j + 100 * k)

    def test_bits(self) -> None:
        def twelve(k, j, i):
            return (100 * k + 10 * j + i) * 5 & 0xfff

        def with_more(k, j, i):
            return twelve(k, j, i) | 0x5000 | (i % 2) << 15
        for syntax in (IMPLICIT, EXPLICIT, BIG_ENDIAN, RLE):
            told = self.read(dicom(syntax, self.counted(with_more, stored=12, high=11))(same))
            self.assert_values(told, twelve)
            told = self.read(dicom(syntax, self.counted(with_more, stored=12, high=11, signed=1))(same))
            self.assert_values(told, lambda k, j, i: (twelve(k, j, i) + 0x800) % 0x1000 - 0x800)
            told = self.read(dicom(syntax, self.counted(lambda k, j, i: 0xffff - 100 * k - j - i, signed=1))(same))
            self.assert_values(told, lambda k, j, i: -1 - 100 * k - j - i)
        padding = {(0x28, 0x120): ("US", [0])}
        told = self.read(dicom(change=lambda k: {**self.counted()(k), **padding})(same))
        self.assert_values(told, lambda k, j, i: i + 10 * j + 100 * k)
        for fields in ({"stored": 12, "high": 15}, {"allocated": 8, "stored": 6, "high": 5}, {"allocated": 64}):
            self.assert_refused(self.tell(self.write(dicom(change=self.counted(**fields))(same))), ".dcm", "bits")

    def test_colors(self) -> None:
        def color(k, j, i, component):
            return 10 * k + j + 64 * component + i
        numbers = [[(j, i, c) for j in range(SIZE[1]) for i in range(SIZE[0]) for c in range(3)],
                   [(j, i, c) for c in range(3) for j in range(SIZE[1]) for i in range(SIZE[0])]]
        for planar in (0, 1):
            told = self.read(dicom(change=lambda k: {
                **self.counted(components=3, kind="RGB", planar=planar, allocated=8, stored=8, high=7)(k),
                (0x7fe0, 0x10): ("OW", bytes(color(k, *index) for index in numbers[planar]))})(same))
            self.assert_values(told, lambda k, j, i: color(k, j, i, 0))
            self.assertEqual(told.range, (0.0, 75.0))
        for kind, components in (("PALETTE COLOR", 1), ("YBR_FULL", 3)):
            told = self.tell(self.write(dicom(change=self.counted(kind=kind, components=components))(same)))
            self.assert_refused(told, ".dcm")

    def test_a_colour_slice_among_grey_ones(self) -> None:
        color = self.counted(components=3, kind="RGB", planar=0, allocated=8, stored=8, high=7)
        pixels = {(0x7fe0, 0x10): ("OW", bytes(3 * SIZE[0] * SIZE[1]))}
        for odd in (0, SIZE[2] - 1):
            told = self.read(dicom(change=lambda k: {**color(k), **pixels} if k == odd else self.counted()(k))(same))
            self.assertIn("1 of 7 slices", told.remark)
            self.assertEqual(told.range[1] - told.range[0], 100 * (SIZE[2] - 2) + 10 * (SIZE[1] - 1) + SIZE[0] - 1)

    def test_what_is_not_read_is_refused(self) -> None:
        for change, word in (
                ({(0x28, 0x3000): ("SQ", [{(0x28, 0x3006): ("US", [1, 2])}])}, "table"),
                ({(0x28, 0x1053): ("DS", "one")}, "'one'"), ({(0x28, 0x1052): ("DS", "1,5")}, "'1,5'"), ({(0x20, 0x32): ("DS", "1\\x\\2")}, "'x'"),
                ({(0x28, 0x10): ("US", [9])}, "not all there")):
            self.assert_refused(self.tell(self.write(dicom(change=lambda k: change)(same))), ".dcm", word)
        fragments = {(0x7fe0, 0x10): ("OB", run_lengths(bytes(2 * SIZE[0] * SIZE[1])))}
        for syntax in ("1.2.840.10008.1.2.4.50", "1.2.840.10008.1.2.4.90", "1.2.840.10008.1.2.4.100", "1.2.3.4"):
            self.assert_refused(self.tell(self.write(dicom(syntax, lambda k: fragments)(same))), "slices")

    def test_images_without_rows_and_what_is_no_file(self) -> None:
        def image(sop_class):
            return dicom(change=lambda k: {
                (0x8, 0x16): ("UI", sop_class), **({(0x28, 0x10): None} if k == 6 else {})})(same)
        self.assert_refused(self.tell(self.write(image("1.2.840.10008.5.1.4.1.1.4"))), "6.dcm", "SOP class")
        folder = self.write(dicom()(same))
        os.mkfifo(folder / "fifo")
        (folder / "link").symlink_to("nowhere")
        self.assertEqual(self.tell(folder).status, 0)

    def frames(self, positions: list | None, slopes=None, more: dict | None = None) -> Original:
        """One file of several frames, with or without groups that tell of each."""
        nx, ny, nz = SIZE
        groups = {} if positions is None else {(0x5200, 0x9229): ("SQ", [{
            (0x20, 0x9116): ("SQ", [{(0x20, 0x37): ("DS", "1\\0\\0\\0\\1\\0")}]),
            (0x28, 0x9110): ("SQ", [{(0x28, 0x30): ("DS", "3\\4")}])}]), (0x5200, 0x9230): ("SQ", [{
                (0x20, 0x9113): ("SQ", [{(0x20, 0x32): ("DS", f"0\\0\\{position}")}]),
                (0x28, 0x9145): ("SQ", [{(0x28, 0x1052): ("DS", 0), (0x28, 0x1053): ("DS", slopes or 1)}])}
                for position in positions])}
        original = dicom(change=lambda k: {
            (0x20, 0x32): None, (0x20, 0x37): None, (0x28, 0x1052): None, (0x28, 0x1053): None,
            (0x28, 0x8): ("IS", nz), (0x28, 0x30): None, **groups, **(more or {}), (0x7fe0, 0x10): ("OW", [
                i + 10 * j + 100 * k for k in range(nz) for j in range(ny) for i in range(nx)])})(same)
        original.files = {"0.dcm": original.files["0.dcm"]}
        return original

    def test_frames(self) -> None:
        told = self.read(self.frames([5 * k for k in range(SIZE[2])], 2000))
        self.assert_values(told, lambda k, j, i: 2000 * (i + 10 * j + 100 * k))
        self.assertEqual(told.steps(), [[4, 0, 0], [0, 3, 0], [0, 0, 5]])
        self.assertEqual(told.remark, "")
        backwards = self.read(self.frames([-5 * k for k in range(SIZE[2])]))
        self.assertEqual(backwards.values[0], 10 * (SIZE[1] - 1))
        uneven = self.read(self.frames([k * k for k in range(SIZE[2])]))
        self.assertIn("unequal distances", uneven.remark)
        told = self.tell(self.write(self.frames([k // 2 for k in range(SIZE[2])])))
        self.assert_refused(told, "frame 5 of", "0.dcm", "at one place")

    def test_slices_without_places(self) -> None:
        for original in (self.frames(None), self.frames(None, more={(0x20, 0x32): ("DS", "1\\2\\3")}),
                         dicom(change=lambda k: {**self.counted()(k), (0x20, 0x32): None, (0x20, 0x13): ("IS", 9 - k)})(same)):
            told = self.read(original)
            self.assertIn("do not say where they lie", told.remark)
            self.assert_close(told.steps()[2], (0, 0, 2))
            first = told.values[0] // 100
            self.assertEqual(told.values[3] // 100 - first, 1 if first == 0 else -1)
        told = self.read(dicom(change=lambda k: {(0x28, 0x30): None})(same))
        self.assertIn("how far their pixels are apart", told.remark)

    def test_even(self) -> None:
        told = self.read(self.slices())
        # Rows are 1 apart and columns 0.5, whatever VTK's reader says.
        self.assert_close(told.steps()[0], (0.5, 0, 0))
        self.assert_close(told.steps()[1], (0, 1, 0))
        self.assert_close(told.steps()[2], (0, 0, 2))
        self.assertEqual(told.remark, "")

    def test_gantry_tilt(self) -> None:
        told = self.read(self.slices(lambda k: (0, 0.5 * k, 2 * k)))
        # Rows are turned, and the first slice is the uppermost, as VTK's reader has it.
        self.assert_close(told.steps()[2], (0, 0.5, 2))
        self.assert_close(told.steps()[1], (0, 1, 0))
        self.assertEqual(told.remark, "")

    def test_missing_slice(self) -> None:
        told = self.read(self.slices(lambda k: None if k == 2 else (0, 0, 2 * k)))
        self.assert_close([told.places[-1][2]], [12])
        self.assertIn("unequal distances", told.remark)

    def test_unequal_slices(self) -> None:
        told = self.read(self.slices(lambda k: (0, 0, k * k)))
        self.assert_close([told.steps()[2][2], told.places[-1][2]], [11, 36])
        self.assertIn("unequal distances", told.remark)

    def test_tilt_and_missing_slice(self) -> None:
        told = self.tell(self.write(self.slices(lambda k: None if k == 2 else (0, 0.5 * k, 2 * k))))
        self.assert_refused(told, "slices", "unequal distances")

    def test_localizers(self) -> None:
        told = self.read(self.slices(
            lambda k: (3 * k, 0, 7) if k == 0 else (0, 0, 2 * k),
            lambda k: "1\\0\\0\\0\\0\\-1" if k == 0 else "1\\0\\0\\0\\1\\0"))
        self.assert_close(told.steps()[2], (0, 0, 2))
        self.assert_close([told.places[-1][2]], [10])
        self.assertIn("1 of 7 slices", told.remark)

    def test_one_place_twice(self) -> None:
        told = self.tell(self.write(self.slices(lambda k: (0, 0, 2 * max(k, 1)))))
        self.assert_refused(told, "at one place", ".dcm")

    def test_a_slice_beside_the_others(self) -> None:
        told = self.tell(self.write(self.slices(lambda k: (9 if k == 3 else 0, 0, 2 * k))))
        self.assert_refused(told, "beside the line", "3.dcm")

    def test_a_larger_series_beside_a_smaller_one(self) -> None:
        original = self.slices()
        for name, data in list(original.files.items())[:2]:
            original.files["other" + name] = data.replace(b"1.2.3.4\0", b"1.2.3.0\0")
        told = self.read(original)
        self.assert_close([told.places[-1][2]], [12])


class Arrays(Files):
    def vts(self, data: str) -> Original:
        return Original("a.vts", {"a.vts": meshes.vts(same, data)})

    def array(self, name: str, numbers) -> str:
        return meshes.array(name, "Float32", numbers, same)

    def test_the_first_that_varies(self) -> None:
        count = len(meshes.points())
        told = self.read(self.vts(
            "<PointData>" + self.array("nothing", count * [0]) + self.array("ball", meshes.values()) +
            "</PointData>\n"))
        self.assertEqual(told.array, "ball")

    def test_of_none_all_are_told(self) -> None:
        count = len(meshes.points())
        told = self.tell(self.write(self.vts(
            "<PointData>" + self.array("nothing", count * [0]) + self.array("ever", count * [3]) +
            "</PointData>\n")))
        self.assert_refused(told, "'nothing'", "--array (ever)")

    def test_all_arrays_of_a_legacy_file(self) -> None:
        for array in ("ball", "more", "steps"):
            self.assertEqual(self.read(ORIGINALS["vtk-large"](same), array).array, array)

    def test_cells_of_images(self) -> None:
        numbers = " ".join(map(str, range(27)))
        text = f"""<VTKFile type="ImageData" version="1.0" byte_order="LittleEndian">
<ImageData WholeExtent="0 3 0 3 0 3" Origin="0 0 0" Spacing="1 1 1"><Piece Extent="0 3 0 3 0 3"><CellData>
<DataArray type="Float32" Name="first" format="ascii">{27 * "5 "}</DataArray>
<DataArray type="Float32" Name="second" format="ascii">{numbers}</DataArray>
</CellData></Piece></ImageData></VTKFile>"""
        for array in ("", "second"):
            told = self.read(Original("a.vti", {"a.vti": text.encode()}), array)
            self.assertEqual((told.array, told.range), ("second of cells", (0.0, 26.0)))

    def test_values_of_faces_are_not_offered(self) -> None:
        """Two hexahedra between values of 0 and 1, and a quad between values of 100."""
        for where in ("PointData", "CellData"):
            told = self.read(Original("a.vtu", {"a.vtu": meshes.hexahedra_and_quad(where)}))
            self.assertEqual(told.range, (0.0, 1.0))

    def test_cells_of_meshes_are_averaged(self) -> None:
        """As they are drawn: a cell among others shows less than its value."""
        numbers = [0] * len(meshes.cells())
        numbers[-1] = 8  # at a corner of the grid, where one point is its own
        numbers[17] = 800  # in its middle
        told = self.read(self.vts("<CellData>" + self.array("value", numbers) + "</CellData>\n"))
        self.assertEqual(told.range, (0.0, 100.0))

    def test_values_of_hidden_cells_are_not_offered(self) -> None:
        hidden = [32 if i >= 27 else 0 for i in range(len(meshes.cells()))]
        numbers = [1000 if mark else i for i, mark in enumerate(hidden)]
        told = self.read(self.vts(
            "<CellData>" + self.array("value", numbers) +
            meshes.array("vtkGhostType", "UInt8", hidden, same) + "</CellData>\n"))
        self.assertEqual(told.range[0], 0.0)
        self.assertTrue(20.0 < told.range[1] <= 26.0, told.range)


class WholeFiles(Files):
    """What is missing in a file is not drawn as if it were there."""

    KINDS = [kind for kind in ORIGINALS if kind not in ("raw", "session", "npy")]

    def assert_whole_or_refused(self, original: Original, cuts) -> None:
        path = self.write(original)
        whole = self.tell(path)
        self.assertEqual(whole.status, 0, whole.said)
        for name, data in original.files.items():
            for size in cuts(len(data)):
                (self.folder / name).write_bytes(data[:size])
                told = self.tell(path)
                if told.said != whole.said:
                    with self.subTest(name=name, size=size):
                        self.assert_refused(told, *([path.name] if len(original.files) == 1 else ["'"]))
            (self.folder / name).write_bytes(data)

    def test_files_that_are_cut(self) -> None:
        for kind in self.KINDS:
            with self.subTest(kind=kind):
                self.assert_whole_or_refused(
                    ORIGINALS[kind](same), lambda n: (n // 3, 2 * n // 3, 9 * n // 10, n - 40, n - 8, n - 1))

    def test_exodus_files_that_are_cut(self) -> None:
        original = Original("a.e", {"a.e": meshes.exodus()})
        if "suffix" in self.tell(self.write(original)).said:
            self.skipTest("This VTK has no reader of Exodus files.")
        self.assertEqual(self.tell(self.folder / "a.e").array, "ball")
        # The values are the last 640 bytes.
        self.assert_whole_or_refused(original, lambda n: (n // 3, n - 700, n - 640, n - 320, n - 8, n - 1))

    def test_pieces_that_do_not_cover_the_extent(self) -> None:
        for extents, has_cells, is_whole in (
                (("0 3 0 4 0 4", "3 7 0 4 0 4"), True, True),
                (("0 5 0 4 0 4", "2 7 0 4 0 4"), True, True),
                (("0 3 0 4 0 4", "4 7 0 4 0 4"), False, True),
                (("0 3 0 4 0 4", "4 7 0 4 0 4"), True, False),
                (("0 3 0 4 0 4",), False, False),
                (("0 7 0 4 0 4",), True, True),
                (("0 3 0 4 0 4", "3 7 0 4 0 2"), False, False)):
            original = Original("a.vti", {"a.vti": meshes.pieces(extents, has_cells=has_cells)})
            if is_whole:
                self.assertEqual(self.read(original).range[0], 100.0)
            else:
                self.assert_refused(self.tell(self.write(original)), "a.vti", "do not cover")

    def test_parallel_images(self) -> None:
        def pvti(pieces) -> bytes:
            return ('<VTKFile type="PImageData" version="1.0"><PImageData WholeExtent="0 7 0 4 0 4" GhostLevel="0" '
                    'Origin="0 0 0" Spacing="1 1 1"><PPointData><PDataArray type="Float32" Name="ball"/></PPointData>' +
                    "".join(f'<Piece Extent="{extent}" Source="{name}"/>' for name, extent in pieces) +
                    "</PImageData></VTKFile>").encode()
        extents = {"b.vti": "0 3 0 4 0 4", "c.vti": "3 7 0 4 0 4"}
        files = {name: meshes.pieces([extent], extent) for name, extent in extents.items()}
        self.assertEqual(self.read(Original("a.pvti", {"a.pvti": pvti(extents.items()), **files})).range[0], 100.0)
        # Some solvers tell the extent of all in each part.
        files = {name: meshes.pieces([extent]) for name, extent in extents.items()}
        self.assertEqual(self.read(Original("a.pvti", {"a.pvti": pvti(extents.items()), **files})).range[0], 100.0)
        told = self.tell(self.write(Original("a.pvti", {"a.pvti": pvti([("b.vti", extents["b.vti"])])})))
        self.assert_refused(told, "a.pvti", "do not cover")
        told = self.tell(self.write(Original("a.pvti", {"a.pvti": pvti([*extents.items(), ("d.vti", "0 3 0 4 0 4")])})))
        self.assert_refused(told, "a.pvti", "d.vti", "not there")
        told = self.tell(self.write(Original("a.pvti", {
            "a.pvti": pvti(extents.items()), **files, "c.vti": meshes.pieces(["4 7 0 4 0 4"])})))
        self.assert_refused(told, "a.pvti", "c.vti", "do not cover")

    def test_meta_images_that_contradict_themselves(self) -> None:
        plain = meta(True)(same).files["a.mha"]
        for old, new, words in META_CONTRADICTIONS:
            told = self.tell(self.write(Original("a.mha", {"a.mha": plain.replace(old, new, 1)})))
            with self.subTest(new=new):
                self.assert_refused(told, "a.mha", words)

    def test_meta_images_with_blanks_before_keys(self) -> None:
        plain = meta(True)(same)
        blank = plain.files["a.mha"].replace(b"ElementDataFile", b"  ElementDataFile")
        self.assertEqual(self.read(Original("a.mha", {"a.mha": blank})).said, self.read(plain).said)

    def test_meta_images_with_more_than_their_header_tells(self) -> None:
        original = meta(False)(same)
        told = self.read(original)
        self.assertEqual(told.remark, "")
        original.files["a.raw"] += bytes(10)
        more = self.read(original)
        self.assertEqual(more.range, told.range)
        self.assertIn("10 bytes more", more.remark)

    def test_meta_images_as_text(self) -> None:
        head, samples = meta(True)(same).files["a.mha"].split(b"LOCAL\n")
        head = head.replace(b"BinaryData = True", b"BinaryData = False").replace(b"Size = -1", b"Size = 0") + b"LOCAL\n"
        text = b" ".join(str(number).encode() for number in struct.unpack("<504h", samples)) + b"\n"
        self.assertEqual(self.read(Original("a.mha", {"a.mha": head + text})).range, self.read(meta(True)(same)).range)
        for data in (head + text[:700], head.replace(b"Channels = 1", b"Channels = 2") + text + text):
            self.assert_refused(self.tell(self.write(Original("a.mha", {"a.mha": data}))), "a.mha")

    def test_compressed_meta_images_that_do_not_tell_their_size(self) -> None:
        files = meta(False, True)(same).files
        lines = files["a.mhd"].splitlines(keepends=True)
        files["a.mhd"] = b"".join(line for line in lines if not line.startswith(b"CompressedDataSize"))
        self.assertIn("CompressedDataSize", self.read(Original("a.mhd", files)).remark)

    def test_meta_images_of_slices(self) -> None:
        slices = {f"{k}.raw": bytes([k, 0]) * 72 for k in range(1, 8)}
        header = meta(False)(same).files["a.mhd"]
        for names, is_whole in ((b"%d.raw 1 7 1", True), (b"%d.raw 1 6 1", False), (b"%d.raw 1 7 2", False),
                                (b"LIST\n" + b"\n".join(map(str.encode, slices)) + b"\n", True),
                                (b"LIST\n1.raw\n2.raw\n", False), (b"LIST\n1.raw\n2.raw", False)):
            original = Original("a.mhd", {"a.mhd": header.replace(b"a.raw", names), **slices})
            if is_whole:
                self.assertEqual(self.read(original).range, (1.0, 7.0))
            else:
                self.assert_refused(self.tell(self.write(original)), "a.mhd", "slices")

    def test_all_levels_of_an_adaptive_grid(self) -> None:
        original = ORIGINALS["vthb"](same)
        fine = original.files["1.vti"]
        at = fine.index(b'format="ascii">') + 15
        original.files["1.vti"] = fine[:at] + b"1000 " * 63 + b"1001" + fine[fine.index(b"</DataArray"):]
        self.assertEqual(self.read(original).range[1], 1001.0)

    def test_adaptive_grids_that_vtk_reads_beyond_its_memory(self) -> None:
        for old, new, words in (
                (b'amr_box="0 3', b'amr_box="0 90', "amr_box"),
                (b'amr_box="0 3', b'amr_box="3 0', "amr_box"), (b'amr_box="0 3 ', b'amr_box="', "amr_box"),
                (b'level="1"', b'level="7"', "level"),
                (b'index="0"', b'index="1"', "index"), (b"DataSet", b"Nothing", "without blocks"),
                (b"index=", b"indEx=", "index"), (b'spacing="0.5 0.5 0.5"', b'spacing="4 4 4"', "spacing"),
                (b'spacing="1 ', b'spacing="0 ', "spacing")):
            original = ORIGINALS["vthb"](same)
            original.files["a.vthb"] = original.files["a.vthb"].replace(old, new, 1)
            with self.subTest(new=new):
                self.assert_refused(self.tell(self.write(original)), "a.vthb", words)


class Values(Files):
    def doubles(self, low: float, high: float) -> Original:
        original = ORIGINALS["vti-raw"](same)
        data = original.files["a.vti"]
        begin, count = data.index(b">_") + 6, math.prod(SIZE)
        values = struct.pack(f"<{count}d", *(high if i % 3 else low for i in range(count)))
        original.files["a.vti"] = data[:begin] + values + data[begin + len(values):]
        return original

    def test_ranges_at_the_ends_of_what_numbers_hold(self) -> None:
        for low, high in ((0.0, 5e-324), (1.0, 1.0 + 2e-16), (-5e-324, 5e-324), (1e16, 1e16 + 2), (0.0, 1.7e308)):
            path = self.write(self.doubles(low, high))
            told = self.tell(path)
            self.assertEqual(told.status, 0, told.said)
            drawn = self.tell(path, way="orbit")
            self.assertTrue(os.WIFEXITED(drawn.status) and drawn.said.count("\n") <= 1, (low, high, drawn.said))
            self.assertNotIn("nan", drawn.said)

    def test_advice_that_fits_the_file(self) -> None:
        for low, high in ((3.0, 3.0), (-1.7e308, 1.7e308)):
            path = self.write(self.doubles(low, high))
            told = self.tell(path)
            self.assert_refused(told, "a.vti")
            self.assertNotIn("--raw", told.said)
        (self.folder / "a.raw").write_bytes(bytes(27))
        self.assert_refused(self.tell(self.folder / "a.raw", "3,3,3,uchar", "orbit"), "a.raw", "--raw")


class Lists(Files):
    def vtm(self, *names: str) -> Original:
        sets = "".join(f'<DataSet index="{i}" file="{name}"/>' for i, name in enumerate(names))
        text = f"""<VTKFile type="vtkMultiBlockDataSet" version="1.0"><vtkMultiBlockDataSet>
<Piece index="0">{sets}</Piece></vtkMultiBlockDataSet></VTKFile>"""
        return Original("a.vtm", {"a.vtm": text.encode(), "b.vtu": meshes.vtu(same)})

    def test_parts_that_cannot_be_read_are_named(self) -> None:
        for name, data in (("c.vtu", meshes.vtu(same)[:1500]), ("c.vtu", b""), ("c.txt", b"no grid"),
                           ("c.vtk", meshes.legacy(same)), ("c.vtp", b"no grid"),
                           ("c.vtu", meshes.vtu(same).replace(b"UnstructuredGrid", b"Nothing"))):
            original = self.vtm("b.vtu", name)
            original.files[name] = data
            self.assert_refused(self.tell(self.write(original)), "a.vtm", name)

    def test_parts_without_cells_are_named(self) -> None:
        original = self.vtm("b.vtu", "c.vtu")
        original.files["c.vtu"] = meshes.xml(
            "UnstructuredGrid", 'NumberOfPoints="0" NumberOfCells="0"', "<Points>" + meshes.array(
                "Points", "Float32", (), same, 3) + "</Points><Cells>" + "".join(meshes.array(
                    name, "Int64", (), same) for name in ("connectivity", "offsets", "types")) + "</Cells>")
        told = self.read(original)
        self.assertEqual(told.array, "ball")
        self.assertIn("c.vtu', which has no cells", told.remark)

    def test_pieces(self) -> None:
        self.assertEqual(self.read(self.vtm("b.vtu")).array, "ball")

    def test_a_part_that_is_missing_is_named(self) -> None:
        self.assert_refused(self.tell(self.write(self.vtm("c.vtu"))), "a.vtm", "c.vtu", "not there")

    def test_adaptive_grid_without_spacing(self) -> None:
        """As old versions of VTK wrote them: the reader of today fails on it."""
        block = '<Block level="{0}" refinement_ratio="2"><DataSet index="0" amr_box="0 3 0 3 0 3" file="x.vti"/></Block>'
        text = '<VTKFile type="vtkHierarchicalBoxDataSet" version="1.0" byte_order="LittleEndian">' \
            f"<vtkHierarchicalBoxDataSet>{block.format(0)}{block.format(1)}</vtkHierarchicalBoxDataSet></VTKFile>"
        image = ORIGINALS["vti-ascii"](same)
        told = self.tell(self.write(Original("a.vthb", {
            "a.vthb": text.encode(), "x.vti": image.files[image.main]})))
        self.assert_refused(told, "a.vthb", "could not be read")


if __name__ == "__main__":
    OPENER = sys.argv.pop(1)
    unittest.main()
