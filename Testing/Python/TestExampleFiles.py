# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""The examples read files as these say, draw what is there, and refuse in one sentence what is not."""

import itertools
import math
import struct
import sys
import unittest

import numpy
from example import EXAMPLES, PROGRAMS, Example, read_png
from spheres import SAMPLES, distances, image_of
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkDataSetAttributes, vtkImageData
from vtkmodules.vtkIOXML import vtkXMLImageDataWriter


class Volumes(Example):
    """Files that both programs read."""

    def test_formats(self):
        image = image_of(distances())
        self.write(vtkXMLImageDataWriter(), image, "sphere.vti")
        self.run_well("render_server.py", "sphere.vti", "--isovalue", 0.5, "--azimuth", 0)
        array = self.save_sphere()
        self.run_well(
            "render_server.py", array, "--isovalue", 0.5, "--azimuth", 0, "--output", "other")
        of_image, of_array = (
            read_png(path=self.folder / folder / "isovalue0.5_azimuth0.png")
            for folder in ("pictures", "other"))
        self.assert_shows_sphere(of_array, 0.5)
        # One has another spacing and origin, but is seen from as far away in its own units.
        self.assertLess((of_array.any(axis=2) != of_image.any(axis=2)).sum(), 20)

    def test_arrays_by_name(self):
        image = image_of(distances())
        other = numpy.ascontiguousarray(distances()[::-1] * 100.0)
        scalars = image_of(other).GetPointData().GetScalars()
        scalars.SetName("other")
        image.GetPointData().AddArray(scalars)
        self.write(vtkXMLImageDataWriter(), image, "two.vti")
        self.run_well("render_server.py", "two.vti", "--array", "other", "--isovalue", 50)
        self.assert_refused(
            "'pressure': choose one of scalars, other", "render_server.py", "two.vti", "--array",
            "pressure")

    def test_mistakes(self):
        (self.folder / "broken.vti").write_text("This is no XML.")
        (self.folder / "broken.vtk").write_text("This is no legacy file.")
        (self.folder / "broken.mhd").write_text("ObjectType = Image")
        (self.folder / "broken.nii").write_text("This is no NIfTI.")
        (self.folder / "broken.slc").write_text("This is no SLC.")
        (self.folder / "broken.npy").write_text("This is no array.")
        (self.folder / "notes.txt").write_text("This is no volume.")
        (self.folder / "folder.vti").mkdir()
        numpy.save(self.folder / "flat.npy", numpy.zeros((5, 5)))
        numpy.save(self.folder / "slice.npy", numpy.zeros((1, 5, 5)))
        numpy.save(self.folder / "even.npy", numpy.full((5, 5, 5), 7.0))
        numpy.save(self.folder / "nan.npy", numpy.full((5, 5, 5), numpy.nan))
        numpy.save(self.folder / "complex.npy", numpy.zeros((5, 5, 5), complex))
        numpy.save(self.folder / "objects.npy", numpy.full((5, 5, 5), None))
        for program, (words, arguments) in zip(itertools.cycle(PROGRAMS), (
                ("There is no file 'missing.vti': check the path", ["missing.vti"]),
                ("'broken.vti' could not be read as an image", ["broken.vti"]),
                ("'broken.vtk' could not be read as an image", ["broken.vtk"]),
                ("'broken.mhd' could not be read as an image", ["broken.mhd"]),
                ("'broken.nii' could not be read as an image", ["broken.nii"]),
                ("'broken.slc' could not be read as an image", ["broken.slc"]),
                ("'broken.npy' could not be read as a NumPy volume", ["broken.npy"]),
                ("'folder.vti' could not be read", ["folder.vti"]),
                ("suffix of 'notes.txt' is none of .npy", ["notes.txt"]),
                (r"'flat.npy'.*shape .*, not \(5, 5\): reshape", ["flat.npy"]),
                ("'slice.npy' has 5 x 5 x 1 samples", ["slice.npy"]),
                ("all the same or no numbers.*choose", ["even.npy"]),
                ("all the same or no numbers.*choose", ["nan.npy"]),
                ("real numbers", ["complex.npy"]),
                ("'objects.npy' could not be read", ["objects.npy"]),
                ("has no array 'pressure': choose one of scalars", ["--array", "pressure"]),
                (r"no file '\\x1b\[2J\\xff.vti'", [b"\x1b[2J\xff.vti".decode("utf-8", "surrogateescape")]),
                (r"unrecognized arguments: --\\x1b", ["--\x1b[2J"]),
                (r"no array '\\x1b\[2J", ["--array", "\x1b[2J"]),
                (r"no array 'long.* \.\.\. .*long'", ["--array", 9999 * "long"]))):
            self.assert_refused(words, program, *arguments)


class Files(Example):
    """Files that are read here, by what the examples share."""

    def setUp(self):
        super().setUp()
        for folder in (EXAMPLES, EXAMPLES.parents[1] / "Testing" / "Files"):
            sys.path.insert(0, str(folder))
            self.addCleanup(sys.path.remove, str(folder))

    def read(self, name, data, time_step=1):
        from volumes import read_volume
        path = self.folder / name
        path.write_bytes(data)
        return read_volume(str(path), time_step)


class Headers(Files):
    """What files of scanners say is applied."""

    def place(self, image, index):
        point = [0.0, 0.0, 0.0]
        image.TransformIndexToPhysicalPoint(index, point)
        return point

    def assert_close(self, a, b):
        self.assertLess(max(abs(x - y) for x, y in zip(a, b)), 1e-4, (a, b))

    def test_nifti(self):
        from originals import nifti
        plain = nifti(False)(lambda value: value).files["a.nii"]
        low, high = self.read("plain.nii", plain).GetScalarRange()
        data = bytearray(plain)
        struct.pack_into("<2f", data, 112, 2.5, -1024.0)
        struct.pack_into("<12f", data, 280, -1, 0, 0, 7, 0, 0, 2, 3, 0, 0.5, 0, -2)  # rows of sform
        image = self.read("a.nii", bytes(data))
        self.assert_close(image.GetScalarRange(), (2.5 * low - 1024, 2.5 * high - 1024))
        first = self.place(image, (0, 0, 0))
        steps = [[b - a for a, b in zip(first, self.place(image, index))]
                 for index in ((1, 0, 0), (0, 1, 0), (0, 0, 1))]
        for step, length in zip(steps, (1, 0.5, 2)):
            self.assertAlmostEqual(math.hypot(*step), length, places=4)
        # Right-handed or not, x is mirrored, and y and z have changed places.
        self.assertLess(steps[0][0], 0.0)
        self.assertEqual([[abs(x) > 1e-4 for x in step] for step in steps], [
            [True, False, False], [False, False, True], [False, True, False]])

    def test_nifti_of_scanner_or_template(self):
        from originals import nifti
        plain = nifti(False)(lambda value: value).files["a.nii"]
        by_template, by_scanner = (5, 6, 7), (10, 20, 30)
        sform, nothing = (1, 0, 0, 5, 0, 1, 0, 6, 0, 0, 1, 7), 12 * [0]
        for codes, rows, expected in (((1, 2), sform, by_template), ((0, 2), sform, by_template),
                                      ((1, 0), sform, by_scanner), ((1, 2), nothing, by_scanner)):
            data = bytearray(plain)
            struct.pack_into("<2h6f", data, 252, *codes, 0, 0, 0, *by_scanner)
            struct.pack_into("<12f", data, 280, *rows)
            self.assert_close(self.place(self.read("a.nii", bytes(data)), (0, 0, 0)), expected)
        data = bytearray(plain)
        struct.pack_into("<f", data, 76, -1)  # the scanner's slices lie the other way round
        struct.pack_into("<2h6f", data, 252, 1, 0, 0, 0, 0, *by_scanner)
        image = self.read("a.nii", bytes(data))
        ends = [self.place(image, (0, 0, k)) for k in (0, image.GetDimensions()[2] - 1)]
        self.assert_close(sorted(place[2] for place in ends), (18, 30))

    def test_nifti_of_several_volumes(self):
        from originals import nifti
        data = bytearray(nifti(False)(lambda value: value).files["a.nii"])
        struct.pack_into("<h", data, 40, 4)
        struct.pack_into("<h", data, 48, 3)  # volumes
        first = numpy.frombuffer(bytes(data[352:]), "<i2")
        data += (first + 1000).tobytes() + (first - 1000).tobytes()
        for time, add in ((1, 0), (2, 1000), (3, -1000)):
            scalars = self.read("a.nii", bytes(data), time).GetPointData().GetScalars()
            self.assertTrue((vtk_to_numpy(scalars).ravel() == first + add).all())
        self.assert_refused("'a.nii' has 3 time steps", "render_server.py", "a.nii", "--time-step", "4")

    def test_values_beyond_the_type(self):
        from originals import nifti
        plain = nifti(False)(lambda value: value).files["a.nii"]
        low, high = self.read("plain.nii", plain).GetScalarRange()
        for slope, intercept in ((1, 40000), (1, 1e9), (0.5, 2 ** 24), (-1001, 0), (123457, 1), (0, 5)):
            data = bytearray(plain)
            struct.pack_into("<2f", data, 112, slope, intercept)
            values = (slope * low + intercept, slope * high + intercept) if slope else (low, high)
            self.assertEqual(self.read("a.nii", bytes(data)).GetScalarRange(), tuple(sorted(values)))

    def test_meta_image(self):
        from originals import meta
        plain = meta(True)(lambda value: value).files["a.mha"]
        low, high = self.read("plain.mha", plain).GetScalarRange()
        data = plain.replace(
            b"TransformMatrix = 1 0 0 0 1 0 0 0 1", b"TransformMatrix = 0 1 0 -1 0 0 0 0 -1").replace(
            b"ElementDataFile", b"ElementToIntensityFunctionSlope = 0.5\n"
            b"ElementToIntensityFunctionOffset = -100\nElementDataFile")
        image = self.read("a.mha", data)
        self.assert_close(image.GetScalarRange(), (0.5 * low - 100, 0.5 * high - 100))
        self.assert_close(self.place(image, (0, 0, 0)), (1.5, 0, -2))
        self.assert_close(self.place(image, (1, 0, 0)), (1.5, 1, -2))
        self.assert_close(self.place(image, (0, 1, 0)), (1, 0, -2))
        self.assert_close(self.place(image, (0, 0, 1)), (1.5, 0, -4))
        for kind in (b"MET_LONG", b"MET_ULONG_LONG", b"MET_FLOAT_ARRAY"):
            path = self.folder / "b.mha"
            path.write_bytes(plain.replace(b"MET_SHORT", kind))
            self.assert_refused(f"'b.mha' could not be read .* '{kind.decode()}'", "render_server.py", "b.mha")

    def test_the_first_array_that_varies(self):
        image = image_of(distances())
        for attributes, count in ((image.GetPointData(), SAMPLES ** 3), (image.GetCellData(), 3)):
            nothing = numpy_to_vtk(numpy.zeros(count), deep=1)
            nothing.SetName("nothing" if attributes is image.GetPointData() else "short")
            attributes.AddArray(nothing)
        image.GetPointData().SetActiveScalars("nothing")
        image.GetCellData().RemoveArray("short")
        self.write(vtkXMLImageDataWriter(), image, "a.vti")
        self.run_well("render_server.py", "a.vti", "--isovalue", 0.5, "--azimuth", 0)
        pixels = read_png(path=self.folder / "pictures" / "isovalue0.5_azimuth0.png")
        self.assert_shows_sphere(pixels, 0.5)
        self.assert_refused(r"all the same.*--array \(.*scalars", "render_server.py", "a.vti", "--array", "nothing")

    def test_cells_of_images(self):
        image = vtkImageData()
        image.SetDimensions(SAMPLES + 1, SAMPLES + 1, SAMPLES + 1)
        scalars = numpy_to_vtk(distances().ravel(), deep=1)
        scalars.SetName("distance")
        image.GetCellData().AddArray(scalars)
        self.write(vtkXMLImageDataWriter(), image, "a.vti")
        for arguments in ([], ["--array", "distance"]):
            self.run_well("render_server.py", "a.vti", "--isovalue", 0.5, "--azimuth", 0, *arguments)
            pixels = read_png(path=self.folder / "pictures" / "isovalue0.5_azimuth0.png")
            self.assertGreater(pixels.any(axis=2).mean(), 0.02)


class WholeFiles(Files):
    """What is missing in a file is not drawn as if it were there; Testing/Files tells of it in C++."""

    def read_or_refuse(self, name, data):
        """The samples, or the sentence."""
        from mistakes import UserError
        try:
            return vtk_to_numpy(self.read(name, data).GetPointData().GetArray(0)).tobytes()
        except UserError as error:
            self.assertIn(name, str(error))
            return str(error)

    def test_files_that_are_cut(self):
        from originals import ORIGINALS
        for kind in ("vti-ascii", "vti-binary", "vti-base64", "vti-base64-zlib", "vti-raw", "vti-raw-zlib", "mha",
                     "mha-zlib", "mha-wordy", "mhd-list", "nii", "nii-gz", "slc", "slc-runs", "vtk-large"):
            original = ORIGINALS[kind](lambda value: value)
            for name, data in original.files.items():
                (self.folder / name).write_bytes(data)
            data = original.files[original.main]
            whole = self.read_or_refuse(original.main, data)
            self.assertIsInstance(whole, bytes)
            for size in (len(data) // 3, 2 * len(data) // 3, len(data) - 40, len(data) - 8, len(data) - 1):
                with self.subTest(kind=kind, size=size):
                    read = self.read_or_refuse(original.main, data[:size])
                    self.assertTrue(isinstance(read, str) or read == whole)

    def test_meta_images_that_contradict_themselves(self):
        from originals import META_CONTRADICTIONS, meta
        plain = meta(True)(lambda value: value).files["a.mha"]
        for old, new, words in META_CONTRADICTIONS:
            with self.subTest(new=new):
                self.assertIn(words, self.read_or_refuse("a.mha", plain.replace(old, new, 1)))

    def test_meta_images_with_blanks_before_keys(self):
        from originals import meta
        plain = meta(True)(lambda value: value).files["a.mha"]
        blank = plain.replace(b"ElementDataFile", b"  ElementDataFile")
        self.assertEqual(self.read_or_refuse("a.mha", blank), self.read_or_refuse("a.mha", plain))

    def test_meta_images_of_slices(self):
        from originals import meta
        for k in range(1, 8):
            (self.folder / f"{k}.raw").write_bytes(bytes([k, 0]) * 72)
        header = meta(False)(lambda value: value).files["a.mhd"]
        for names, is_whole in ((b"%d.raw 1 7 1", True), (b"%d.raw 1 6 1", False), (b"%d.raw 1 7 2", False)):
            read = self.read_or_refuse("a.mhd", header.replace(b"a.raw", names))
            self.assertEqual(isinstance(read, bytes), is_whole)

    def test_more_than_the_header_tells(self):
        from originals import meta
        files = meta(False)(lambda value: value).files
        (self.folder / "a.mhd").write_bytes(files["a.mhd"])
        (self.folder / "a.raw").write_bytes(files["a.raw"] + bytes(10))
        self.assertIn("10 bytes more", self.run_well("render_server.py", "a.mhd", "--size", "20"))

    def test_pieces_that_do_not_cover_the_extent(self):
        import meshes
        for extents, has_cells, is_whole in (
                (("0 3 0 4 0 4", "3 7 0 4 0 4"), True, True), (("0 3 0 4 0 4", "4 7 0 4 0 4"), False, True),
                (("0 3 0 4 0 4", "4 7 0 4 0 4"), True, False), (("0 3 0 4 0 4",), False, False),
                (("0 3 0 4 0 4", "3 7 0 4 0 2"), False, False)):
            read = self.read_or_refuse("a.vti", meshes.pieces(extents, has_cells=has_cells))
            self.assertTrue(isinstance(read, bytes) if is_whole else "do not cover" in read, read)

    def test_meshes_that_are_cut(self):
        import meshes
        (self.folder / "a.vtu").write_bytes(meshes.vtu(lambda value: value)[:-20])
        self.assert_refused("'a.vtu' could not be read", "mesh_sweep.py", "a.vtu")

    def test_all_arrays_of_a_legacy_file(self):
        from originals import ORIGINALS
        (self.folder / "a.vtk").write_bytes(ORIGINALS["vtk-large"](lambda value: value).files["a.vtk"])
        for name in ("ball", "more", "steps"):
            self.run_well("render_server.py", "a.vtk", "--array", name, "--size", "20")


class DrawnValues(Files):
    """Isovalues are chosen among values that are drawn."""

    def assert_range(self, low, high, name, data):
        (self.folder / name).write_bytes(data)
        said = self.run_well("mesh_sweep.py", name, "--frames", 2, "--size", "20x20")
        self.assertIn(f" values {low:g} to {high:g}\n", said)

    def test_not_those_of_faces(self):
        import meshes
        for where in ("PointData", "CellData"):
            self.assert_range(0, 1, "a.vtu", meshes.hexahedra_and_quad(where))

    def test_cells_of_meshes_are_averaged(self):
        import meshes
        numbers = [0] * len(meshes.cells())
        numbers[-1] = 8  # at a corner of the grid, where one point is its own
        numbers[17] = 800  # in its middle
        self.assert_range(0, 100, "a.vts", meshes.vts(
            str, "<CellData>" + meshes.array("value", "Float32", numbers, str) + "</CellData>\n"))

    def test_means_without_cells_that_are_nan(self):
        import meshes
        numbers = [0] * len(meshes.cells())
        numbers[16:18] = "nan", 800  # beside each other in the middle
        self.assert_range(0, 800 / 7, "a.vts", meshes.vts(
            str, "<CellData>" + meshes.array("value", "Float32", numbers, str) + "</CellData>\n"))

    def test_not_those_of_hidden_cells(self):
        import meshes
        hidden = [32 if i >= 27 else 0 for i in range(len(meshes.cells()))]
        numbers = [1000 if mark else 5 + i % 2 for i, mark in enumerate(hidden)]
        data = meshes.vts(str, "<CellData>" + meshes.array("value", "Float32", numbers, str) + meshes.array(
            "vtkGhostType", "UInt8", hidden, str) + "</CellData>\n")
        self.assert_range(5, 6, "a.vts", data)

    def test_marks_of_images_take_little_memory(self):
        import tracemalloc
        from drawn import Drawn
        image, marks = vtkImageData(), numpy.zeros(64 ** 3, numpy.uint8)
        image.SetDimensions(64, 64, 64)
        marks[-1] = vtkDataSetAttributes.HIDDENPOINT
        for name, numbers in (("value", numpy.arange(64.0 ** 3)), (vtkDataSetAttributes.GhostArrayName(), marks)):
            array = numpy_to_vtk(numbers, deep=True)
            array.SetName(name)
            image.GetPointData().AddArray(array)
        tracemalloc.start()
        drawn = Drawn(image)
        most = tracemalloc.get_traced_memory()[1]
        tracemalloc.stop()
        self.assertLess(most, 20 * 64 ** 3)
        self.assertEqual(drawn.range(image.GetPointData().GetArray("value"), False), (0, 64 ** 3 - 2))

    def test_ranges_that_are_too_large(self):
        numpy.save(self.folder / "a.npy", numpy.resize((-1.7e308, 1.7e308, 0.0), (4, 4, 4)))
        self.assert_refused("too far apart", "render_server.py", "a.npy")


if __name__ == "__main__":
    unittest.main()
