# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""What files say is what is read of them: values, places, arrays; and what is refused is told why."""

from __future__ import annotations

import os
import pathlib
import shutil
import struct
import subprocess
import sys
import tempfile
import unittest

import meshes
from originals import ORIGINALS, SIZE, Original, dicom, meta, nifti

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

    def tell(self, path: pathlib.Path, array: str = "", way: str = "tell") -> Told:
        said = self.folder / "said"
        request = "\t".join((way, str(path), str(said), array)) + "\n"
        done = subprocess.run([OPENER], input=request, capture_output=True, text=True, check=True)
        return Told(int(done.stdout.split()[0]), said.read_text(encoding="utf-8"))

    def write(self, original: Original) -> pathlib.Path:
        for name, data in original.files.items():
            (self.folder / name).write_bytes(data)
        if original.main:
            return self.folder / original.main
        folder = self.folder / "slices"
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

    def test_place(self) -> None:
        told = self.read(nifti(False)(same))
        self.assert_close(told.places[0], (1.5, 0, -2))
        self.assert_close(told.steps()[1], (0, 0.5, 0))


class Dicom(Files):
    def slices(self, position=lambda k: (0, 0, 2 * k), orientation=lambda k: "1\\0\\0\\0\\1\\0") -> Original:
        """Seven slices; those without a position are left out."""
        original = dicom(False)(same)
        files = {}
        for k in range(SIZE[2]):
            place = position(k)
            if place is None:
                continue
            data = original.files[f"{k}.dcm"]
            for tag, text in ((0x32, "\\".join(f"{x:g}" for x in place)), (0x37, orientation(k))):
                begin = data.index(struct.pack("<HH", 0x20, tag))
                length, = struct.unpack_from("<H", data, begin + 6)
                value = text.encode() + b" " * (len(text) % 2)
                data = data[:begin + 6] + struct.pack("<H", len(value)) + value + data[begin + 8 + length:]
            files[f"{k}.dcm"] = data
        original.files = files
        return original

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
        points = [(x, y, z) for x in range(3) for z in (0, 1) for y in (0, 1)] + [
            (9, 0, 0), (9, 1, 0), (9, 1, 1), (9, 0, 1)]
        values = [point[0] / 2 if point[0] < 9 else 100 for point in points]
        cells = [(0, 4, 5, 1, 2, 6, 7, 3), (4, 8, 9, 5, 6, 10, 11, 7), (12, 13, 14, 15)]
        for where in ("PointData", "CellData"):
            numbers = values if where == "PointData" else [0, 1, 100]
            content = f"<{where}>" + self.array("value", numbers) + f"</{where}><Points>" + meshes.array(
                "Points", "Float32", [x for point in points for x in point], same, 3) + "</Points><Cells>" + \
                meshes.array("connectivity", "Int64", [p for cell in cells for p in cell], same) + \
                meshes.array("offsets", "Int64", (8, 16, 20), same) + \
                meshes.array("types", "UInt8", (12, 12, 9), same) + "</Cells>"
            told = self.read(Original("a.vtu", {"a.vtu": meshes.xml(
                "UnstructuredGrid", f'NumberOfPoints="{len(points)}" NumberOfCells="3"', content)}))
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


class Lists(Files):
    def vtm(self, name: str) -> Original:
        text = f"""<VTKFile type="vtkMultiBlockDataSet" version="1.0"><vtkMultiBlockDataSet>
<Piece index="0"><DataSet index="0" file="{name}"/></Piece></vtkMultiBlockDataSet></VTKFile>"""
        return Original("a.vtm", {"a.vtm": text.encode(), "b.vtu": meshes.vtu(same)})

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
