# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""The examples run without a display, show what they should, and refuse in one sentence."""

import concurrent.futures
import contextlib
import glob
import http.client
import itertools
import math
import os
import pathlib
import re
import signal
import socket
import struct
import subprocess
import sys
import tempfile
import unittest

import numpy
from spheres import SAMPLES, distances, image_of
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkDataSetAttributes, vtkImageData, vtkStructuredGrid
from vtkmodules.vtkIOImage import vtkPNGReader
from vtkmodules.vtkIOXML import vtkXMLImageDataWriter, vtkXMLStructuredGridWriter

EXAMPLES = pathlib.Path(__file__).resolve().parents[2] / "Examples" / "Python"
PROGRAMS = ("threshold_sweep.py", "render_server.py")


def read_png(data=None, path=None):
    """The pixels of a PNG, row 0 at the bottom."""
    reader = vtkPNGReader()
    if data is not None:
        reader.SetMemoryBuffer(data)
        reader.SetMemoryBufferLength(len(data))
    else:
        reader.SetFileName(str(path))
    reader.Update()
    width, height, _ = reader.GetOutput().GetDimensions()
    return vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).reshape(height, width, 3)


class Example(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.assertNotIn("DISPLAY", os.environ)

    def command(self, program, *arguments):
        return [sys.executable, str(EXAMPLES / program), *map(str, arguments)]

    def run_example(self, program, *arguments, **environment):
        return subprocess.run(
            self.command(program, *arguments), cwd=self.folder, capture_output=True, text=True,
            env={**os.environ, **environment}, check=False)

    def run_well(self, program, *arguments):
        done = self.run_example(program, *arguments)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return done.stdout

    def assert_refused(self, words, program, *arguments, **environment):
        done = self.run_example(program, *arguments, **environment)
        self.assertEqual(done.returncode, 1, done)
        self.assertRegex(done.stderr, words)
        self.assertTrue(done.stderr.startswith(program + ": "), done.stderr)
        self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
        self.assertTrue(done.stderr.endswith(".\n"), done.stderr)
        # A terminal obeys nothing of it, and it can be read.
        self.assertTrue(done.stderr[:-1].isprintable(), done.stderr)
        self.assertLess(len(done.stderr), 1500)

    def save_sphere(self, centre=(0.0, 0.0, 0.0)):
        """A sphere as a .npy file; with spacing 1 its radius is (1 - isovalue) * 32."""
        path = self.folder / "sphere.npy"
        numpy.save(path, distances(centre))
        return path

    def assert_shows_sphere(self, pixels, isovalue):
        """The example's camera sees the volume's own sphere at its view angle of 30 degrees."""
        radius = (1.0 - isovalue) * (SAMPLES - 1) / 2.0
        distance = math.sqrt(3.0) * (SAMPLES - 1) / 2.0 / math.sin(math.radians(15.0))
        sine = radius / distance
        tangent = sine / math.sqrt(1.0 - sine * sine) / math.tan(math.radians(15.0))
        height, width, _ = pixels.shape
        expected = tangent * height / 2.0
        y, x = numpy.nonzero(pixels.any(axis=2))
        self.assertAlmostEqual(math.sqrt(len(x) / math.pi), expected, delta=0.5)
        self.assertAlmostEqual(x.mean(), (width - 1) / 2.0, delta=0.5)
        self.assertAlmostEqual(y.mean(), (height - 1) / 2.0, delta=0.5)


def middle(pixels):
    """Where in a picture the surface is, as shares of its width and height."""
    y, x = numpy.nonzero(pixels.any(axis=2))
    return x.mean() / pixels.shape[1], y.mean() / pixels.shape[0]


class DropIn(Example):
    def test_picture(self):
        self.assertEqual(self.run_well("drop_in.py"), "")
        pixels = read_png(path=self.folder / "drop_in.png")
        self.assertEqual(pixels.shape, (512, 512, 3))
        share = pixels.any(axis=2).mean()
        self.assertTrue(0.1 < share < 0.9, share)
        self.assertGreater(len(numpy.unique(pixels)), 50)

    def test_has_12_lines(self):
        lines = (EXAMPLES / "drop_in.py").read_text(encoding="utf-8").splitlines()
        self.assertEqual(len([line for line in lines if line and not line.startswith("#")]), 12)


class Depth(Example):
    def test_picture(self):
        said = self.run_well(
            "depth.py", self.save_sphere(), "--isovalue", 0.5, "--size", "100x80", "--output", "a.png")
        self.assertEqual(said, "saved as a.png\n")
        pixels = read_png(path=self.folder / "a.png")
        self.assertEqual(pixels.shape, (80, 100, 3))
        self.assertTrue(0.05 < pixels.any(axis=2).mean() < 0.5)

    def test_mistakes(self):
        self.assert_refused("another --output", "depth.py", "--output", "missing/a.png", "--size", "9x9")
        self.assert_refused("outside of the volume.s values", "depth.py", "--isovalue", 1e9, "--output", "a.png")


class ThresholdSweep(Example):
    def test_pictures_and_reuse(self):
        said = self.run_well(
            "threshold_sweep.py", self.save_sphere(), "--from", 0.3, "--to", 0.7, "--frames", 5,
            "--size", "300x200", "--output", "frames")
        for frame, isovalue in enumerate((0.3, 0.4, 0.5, 0.6, 0.7)):
            pixels = read_png(path=self.folder / "frames" / f"frame-{frame:04}.png")
            self.assertEqual(pixels.shape, (200, 300, 3))
            self.assert_shows_sphere(pixels, isovalue)
        self.assertEqual(len(glob.glob(str(self.folder / "frames" / "*"))), 5)
        self.assertEqual(
            re.findall(r"^ +\d +(\S+) +(\w+) +[\d.]+$", said, re.MULTILINE),
            [("0.3", "Cold"), ("0.4", "IsomapBuild"), ("0.5", "IsomapLookup"),
             ("0.6", "IsomapLookup"), ("0.7", "IsomapLookup")])
        self.assertRegex(said, r"IsomapLookup +3 frames, median +[\d.]+ ms\nsaved as frames\n$")

    def test_downwards(self):
        said = self.run_well(
            "threshold_sweep.py", "--from", 200, "--to", 100, "--frames", 3, "--size", "64x64",
            "--output", "frames")
        self.assertEqual(
            re.findall(r"Cold|Isomap\w+", said)[:3], ["Cold", "IsomapBuild", "IsomapLookup"])

    def test_theora(self):
        self.run_well("threshold_sweep.py", "--frames", 3, "--size", "101x67", "--output", "a.ogv")
        data = (self.folder / "a.ogv").read_bytes()
        self.assertTrue(data.startswith(b"OggS") and b"theora" in data[:200])
        self.assertGreater(len(data), 2000)

    def test_gif(self):
        try:
            from PIL import Image
        except ImportError:
            self.skipTest("Pillow is not there (Debian: python3-pil).")
        self.run_well(
            "threshold_sweep.py", self.save_sphere(), "--from", 0.3, "--to", 0.7, "--frames", 3,
            "--size", "200x200", "--output", "a.gif")
        with Image.open(self.folder / "a.gif") as animation:
            self.assertEqual(animation.n_frames, 3)
            for frame, isovalue in enumerate((0.3, 0.5, 0.7)):
                animation.seek(frame)
                self.assert_shows_sphere(numpy.asarray(animation.convert("RGB")), isovalue)

        self.run_well(
            "threshold_sweep.py", self.save_sphere((0.0, 0.0, 0.5)), "--frames", 2, "--from", 0.7,
            "--to", 0.8, "--output", "upper.gif")
        with Image.open(self.folder / "upper.gif") as animation:
            # Pillow's row 0 is the top one, and z points up.
            self.assertLess(middle(numpy.asarray(animation.convert("RGB")))[1], 0.45)

    def test_gif_without_pillow(self):
        (self.folder / "PIL.py").write_text("raise ImportError\n", encoding="utf-8")
        self.assert_refused(
            "Pillow, which is missing: install it", "threshold_sweep.py", "--output", "a.gif",
            PYTHONPATH=os.pathsep.join([str(self.folder), os.environ["PYTHONPATH"]]))

    def test_mistakes(self):
        for words, arguments in (
                ("'a.mp4'|'.mp4' are not written here", ["--output", "a.mp4"]),
                ("cannot be written", ["--output", "/nowhere/a.ogv"]),
                ("cannot be written", ["--output", "/proc/nowhere"]),
                ("Isovalue 300 is outside .* from 0 to 2", ["--to", "300"]),
                ("Isovalue nan is outside", ["--from", "nan"]),
                ("--frames: '1' is no whole number from 2 to 1000000", ["--frames", "1"]),
                ("--frames: '9{20}' is no whole number from 2", ["--frames", "9" * 20]),
                ("--rate: '0' is no whole number from 1 to 100", ["--rate", "0"]),
                ("--rate: '101' is no whole number from 1 to 100", ["--rate", "101"]),
                ("--size: '0x10' is no size", ["--size", "0x10"]),
                ("--size: 'big' is no size", ["--size", "big"]),
                ("invalid float value", ["--from", "much"]),
                ("Azimuth inf is no angle: give degrees", ["--azimuth", "inf"]),
                ("unrecognized arguments: --sise", ["--sise", "3"])):
            self.assert_refused(words, "threshold_sweep.py", *arguments)

    def test_a_frame_cannot_be_written(self):
        (self.folder / "frames" / "frame-0000.png").mkdir(parents=True)
        self.assert_refused(
            "'frames' cannot be written .*: choose another --output", "threshold_sweep.py",
            self.save_sphere(), "--output", "frames", "--frames", 2, "--size", "20x10")

    def test_nobody_reads_what_is_printed(self):
        command = self.command(
            "threshold_sweep.py", self.save_sphere(), "--frames", 2, "--size", "20x10")
        reader, writer = os.pipe()
        os.close(reader)
        done = subprocess.run(
            command, cwd=self.folder, stdout=writer, stderr=subprocess.PIPE, text=True, check=False)
        os.close(writer)
        self.assertEqual((done.returncode, done.stderr), (1, ""))


class Film(Example):
    """README's moving picture is made again."""

    def test_drag_and_turn(self):
        try:
            from PIL import Image
        except ImportError:
            self.skipTest("Pillow is not there (Debian: python3-pil).")
        program = EXAMPLES.parents[1] / "Documentation" / "film.py"
        if not program.exists():
            self.skipTest("The documentation is not there.")
        self.run_well(
            program, self.save_sphere(), "--from", 0.3, "--to", 0.7, "--frames", 4, "--size", 80,
            "--output", "film.webp")
        with Image.open(self.folder / "film.webp") as animation:
            self.assertEqual((animation.n_frames, animation.size), (8, (80, 80)))
            drawn = []
            for frame in range(8):
                animation.seek(frame)
                drawn.append(int((numpy.asarray(animation.convert("L"))[20:] < 250).sum()))
        self.assertGreater(drawn[0], 1.5 * drawn[2])  # a smaller sphere
        self.assertGreater(min(drawn), 100)


class MeshSweep(Example):
    def test_scattered_points(self):
        said = self.run_well(
            "mesh_sweep.py", "--points", 400, "--frames", 4, "--size", "120x90", "--output", "a.png")
        pixels = read_png(path=self.folder / "a.png")
        self.assertEqual(pixels.shape, (90, 120, 3))
        self.assertTrue(0.1 < pixels.any(axis=2).mean() < 0.9)
        rows = re.findall(r"^ +\d +\S+ +(\w+) +[\d.]+ +[\d.]+ +(\d+)$", said, re.MULTILINE)
        self.assertEqual([route for route, _ in rows], [
            "Cold", "IsomapBuild", "IsomapLookup", "IsomapLookup"])
        self.assertGreater(int(rows[0][1]), 100)

    def save_sphere_as_grid(self, scalars):
        grid = vtkStructuredGrid()
        grid.SetDimensions(SAMPLES, SAMPLES, SAMPLES)
        axis = numpy.arange(SAMPLES, dtype=float)
        z, y, x = numpy.meshgrid(axis, axis, axis, indexing="ij")
        points = numpy.stack([x.ravel(), y.ravel(), z.ravel()], axis=1)
        grid.SetPoints(vtkPoints())
        grid.GetPoints().SetData(numpy_to_vtk(points, deep=1))
        scalars.SetName("distance")
        grid.GetPointData().AddArray(scalars)
        writer = vtkXMLStructuredGridWriter()
        writer.SetInputData(grid)
        writer.SetFileName(str(self.folder / "sphere.vts"))
        writer.Write()

    def assert_draws_grid(self):
        self.run_well(
            "mesh_sweep.py", "sphere.vts", "--from", 0.4, "--to", 0.5, "--frames", 2, "--azimuth", 0,
            "--size", "200x200", "--output", "a.png")
        self.assert_shows_sphere(read_png(path=self.folder / "a.png"), 0.5)

    def test_files(self):
        self.save_sphere_as_grid(image_of(distances()).GetPointData().GetScalars())
        self.assert_draws_grid()

    def test_vectors(self):
        """Of which vtkContourFilter takes none."""
        values = distances().ravel()
        self.save_sphere_as_grid(
            numpy_to_vtk(numpy.stack([values, 0.0 * values, 1.0 - values], axis=1), deep=1))
        self.assert_draws_grid()

    def test_wrong_cells(self):
        grid = vtkStructuredGrid()
        grid.SetDimensions(3, 3, 3)
        points = vtkPoints()
        for point in range(27):
            points.InsertNextPoint(point % 3, point // 3 % 3, point // 9)
        points.SetPoint(13, float("nan"), 1.0, 1.0)
        grid.SetPoints(points)
        grid.GetPointData().SetScalars(numpy_to_vtk(numpy.arange(27.0), deep=1))
        grid.GetPointData().GetScalars().SetName("number")
        writer = vtkXMLStructuredGridWriter()
        writer.SetInputData(grid)
        writer.SetFileName(str(self.folder / "nowhere.vts"))
        writer.Write()
        self.assert_refused(r"has the point 13 at \(nan, 1, 1\)", "mesh_sweep.py", "nowhere.vts")

    def test_mistakes(self):
        (self.folder / "broken.vtu").write_text("This is no XML.")
        (self.folder / "notes.txt").write_text("This is no mesh.")
        for words, arguments in (
                ("could not be read", ["broken.vtu"]),
                ("could not be read", ["missing.vts"]),
                ("none of .vtu, .vts", ["notes.txt"]),
                ("Isovalue 900 is outside", ["--points", "50", "--from", "900"])):
            self.assert_refused(words, "mesh_sweep.py", *arguments)


class Volumes(Example):
    """Files that both programs read."""

    def test_formats(self):
        image = image_of(distances())
        writer = vtkXMLImageDataWriter()
        writer.SetInputData(image)
        writer.SetFileName(str(self.folder / "sphere.vti"))
        writer.Write()
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
        writer = vtkXMLImageDataWriter()
        writer.SetInputData(image)
        writer.SetFileName(str(self.folder / "two.vti"))
        writer.Write()
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
        writer = vtkXMLImageDataWriter()
        writer.SetInputData(image)
        writer.SetFileName(str(self.folder / "a.vti"))
        writer.Write()
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
        writer = vtkXMLImageDataWriter()
        writer.SetInputData(image)
        writer.SetFileName(str(self.folder / "a.vti"))
        writer.Write()
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


class RenderServer(Example):
    @contextlib.contextmanager
    def server(self, *arguments):
        """A server that runs; its port."""
        # Shells have what they start in the background ignore Ctrl+C.
        process = subprocess.Popen(
            self.command("render_server.py", *arguments, "--serve", 0), cwd=self.folder,
            stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
            preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL))
        try:
            said = process.stdout.readline()
            match = re.fullmatch(r"Serving http://127.0.0.1:(\d+)/ until Ctrl\+C\n", said)
            self.assertTrue(match, said)
            yield int(match[1])
        finally:
            process.send_signal(signal.SIGINT)
            _, complaints = process.communicate(timeout=120)
        self.assertEqual((process.returncode, complaints), (0, ""))

    def get(self, port, address, status=200):
        connection = http.client.HTTPConnection("127.0.0.1", port, timeout=120)
        with contextlib.closing(connection):
            connection.request("GET", address)
            answer = connection.getresponse()
            body = answer.read()
        self.assertEqual(answer.status, status, body[:200])
        route = (answer.getheader("Server-Timing") or "").partition(";dur=")[0]
        return body, answer.getheader("Content-Type"), route

    def test_pictures(self):
        said = self.run_well(
            "render_server.py", "--isovalue", 0.3, "--isovalue", 0.6, "--azimuth", 0, "--azimuth",
            90, "--size", 150, "--output", "a/b", self.save_sphere())
        self.assertEqual(len(said.splitlines()), 4)
        for isovalue in (0.3, 0.6):
            for azimuth in (0, 90):
                path = self.folder / "a" / "b" / f"isovalue{isovalue}_azimuth{azimuth}.png"
                self.assert_shows_sphere(read_png(path=path), isovalue)

    def test_z_is_up_and_azimuth_0_looks_along_y(self):
        self.run_well(
            "render_server.py", self.save_sphere((0.4, 0.0, 0.5)), "--isovalue", 0.7,
            "--azimuth", 0, "--azimuth", 90, "--azimuth", 180)
        for azimuth, side in ((0, 1), (90, 0), (180, -1)):
            x, y = middle(
                read_png(path=self.folder / "pictures" / f"isovalue0.7_azimuth{azimuth}.png"))
            self.assertGreater(y, 0.55)
            self.assertEqual(int(x > 0.55) - int(x < 0.45), side)

    def test_serves_and_reuses(self):
        with self.server(self.save_sphere()) as port:
            page, content_type, _ = self.get(port, "/")
            self.assertTrue(content_type.startswith("text/html"))
            self.assertIn(b'type="range"', page)

            routes = []
            for isovalue in (0.5, 0.5, 0.499, 0.5, 0.499):
                png, content_type, route = self.get(
                    port, f"/picture.png?isovalue={isovalue}&azimuth=0&size=200")
                self.assertEqual(content_type, "image/png")
                self.assert_shows_sphere(read_png(png), isovalue)
                routes.append(route)
            self.assertEqual(routes[:3], ["Cold", "Redisplay", "IsomapBuild"])
            # How soon all of the picture is looked up depends on the speed of the machine.
            self.assertIn(routes[-1], ("IsomapBuild", "IsomapLookup"))
            turned, _, route = self.get(port, "/picture.png?isovalue=0.499&azimuth=2&size=200")
            self.assertEqual(route, "Cold")
            self.assert_shows_sphere(read_png(turned), 0.499)
            self.assertEqual(read_png(self.get(port, "/picture.png")[0]).shape, (512, 512, 3))

    def test_bad_requests(self):
        with self.server() as port:
            for words, query in (
                    ("'much' is no number: give one", "isovalue=much"),
                    ("'' is no number", "isovalue="),
                    ("Isovalue 900 is outside .*: choose one from 0 to", "isovalue=900"),
                    ("Isovalue nan is outside", "isovalue=nan"),
                    ("Azimuth inf is no angle: give degrees", "azimuth=inf"),
                    ("Size 0 .*choose one from 1 to 2048 pixels", "size=0"),
                    ("Size 4096 is not possible", "size=4096"),
                    ("'1e2' is no number", "size=1e2"),
                    ("no parameter 'isovlue': give isovalue", "isovlue=3")):
                body, content_type, _ = self.get(port, "/picture.png?" + query, status=400)
                self.assertRegex(body.decode(), words)
                self.assertEqual(body.count(b"\n"), 1)
                self.assertTrue(content_type.startswith("text/plain"))
            self.get(port, "/secrets", status=404)
            with socket.create_connection(("127.0.0.1", port)) as connection:
                connection.sendall(b"Hello?\r\n\r\n")
                answer = b"".join(iter(lambda: connection.recv(1000), b""))
                self.assertRegex(answer, rb"Bad request .*\.\n$")
            self.assertGreater(len(self.get(port, "/picture.png?size=64")[0]), 500)

    def test_several_callers_at_once(self):
        with self.server(self.save_sphere()) as port:
            # A browser's connection that asks for nothing holds nobody up, and one that does not
            # wait for the answer does no harm.
            idle = socket.create_connection(("127.0.0.1", port))
            for _ in range(3):
                with socket.create_connection(("127.0.0.1", port)) as gone:
                    reset = struct.pack("ii", 1, 0)
                    gone.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, reset)
                    gone.sendall(b"GET /picture.png?size=1000 HTTP/1.0\r\n\r\n")
            isovalues = [0.3, 0.4, 0.5, 0.6] * 3
            with concurrent.futures.ThreadPoolExecutor(4) as callers:
                pictures = callers.map(
                    lambda isovalue: self.get(
                        port, f"/picture.png?isovalue={isovalue}&size=100")[0], isovalues)
                for isovalue, png in zip(isovalues, pictures):
                    self.assert_shows_sphere(read_png(png), isovalue)
            idle.close()

    def test_mistakes(self):
        with self.server() as port:
            self.assert_refused(
                f"Port {port} .*: choose another", "render_server.py", "--serve", port)
        (self.folder / "file").touch()
        for words, arguments in (
                ("Isovalue 900 is outside", ["--isovalue", "30", "--isovalue", "900"]),
                ("Size 4096 is not possible: choose", ["--size", "4096"]),
                ("Azimuth nan is no angle: give degrees", ["--azimuth", "nan"]),
                ("--serve: 'http' is no whole number", ["--serve", "http"]),
                ("cannot be listened at", ["--serve", "70000"]),
                ("cannot be listened at", ["--serve", "0", "--host", "256.0.0.1"]),
                ("'file/a' cannot be written", ["--output", "file/a"])):
            self.assert_refused(words, "render_server.py", *arguments)


class MissingPackages(Example):
    def test_are_named(self):
        paths = os.pathsep.join([str(self.folder), os.environ["PYTHONPATH"]])
        for name, program in itertools.product(("numpy", "vtkTemporalCoherence"), PROGRAMS):
            stub = self.folder / (name + ".py")
            stub.write_text(f"raise ImportError('There is no {name}')\n", encoding="utf-8")
            self.assert_refused(
                f"There is no {name}: install .*python3-numpy .*python3-vtktemporalcoherence",
                program, PYTHONPATH=paths)
            stub.unlink()


class Help(Example):
    def test_tells_of_every_option(self):
        for program in PROGRAMS:
            said = self.run_well(program, "--help")
            for option in ("--array", "--time-step", "--size", "--azimuth", "--output"):
                self.assertIn(option, said)


if __name__ == "__main__":
    unittest.main()
