# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures in one line: they are those of the long way, and mistakes are sentences."""

import importlib.metadata
import ctypes
import io
import math
import os
import pathlib
import re
import tempfile
import unittest
import warnings
from unittest import mock

import numpy
import vtkTemporalCoherence
from example import read_png
from spheres import STEP, distances, image_of
from vtkmodules.vtkCommonCore import vtkBitArray, vtkStringArray
from vtkmodules.vtkCommonDataModel import (
    vtkMultiBlockDataSet, vtkPolyData, vtkRectilinearGrid, vtkUnstructuredGrid)
from vtkmodules.vtkRenderingCore import vtkColorTransferFunction, vtkRenderer, vtkVolume
from vtkTemporalCoherence import (
    composite, isosurface, maximum, render, vtkTemporalCoherenceVolumeMapper, write_png)

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]
VALUE = 0.5
PLACE = {"spacing": (STEP, STEP, STEP), "origin": (-1.0, -1.0, -1.0)}


def ramp():
    """Values that differ along each axis, so that a flipped or turned picture is another one."""
    z, y, x = numpy.meshgrid(*map(numpy.arange, (9, 12, 15)), indexing="ij")
    return (x + 2.0 * y + 4.0 * z).astype(numpy.float32)


def from_top(data):
    """The pixels of a PNG, row 0 at the top."""
    return read_png(data)[::-1]


def without_points():
    """An image whose numbers are those of cells; words are at the points."""
    image = image_of(distances())
    words, cells = vtkStringArray(), image.GetPointData().GetScalars()
    cells.SetName("cells")
    cells.SetNumberOfTuples(image.GetNumberOfCells())
    image.GetCellData().AddArray(cells)
    image.GetPointData().Initialize()
    words.SetName("words")
    words.SetNumberOfValues(image.GetNumberOfPoints())
    image.GetPointData().AddArray(words)
    return image


class LabeledArray:
    """What the package knows of an xarray.DataArray."""

    def __init__(self, values, name=None, **coords):
        self.values, self.name, self.coords = values, name, coords
        self.dims = tuple(coords)[:values.ndim]

    @property
    def shape(self):
        return self.values.shape

    def __array__(self, dtype=None, copy=None):
        return numpy.asarray(self.values, dtype)


class Pictures(unittest.TestCase):
    def test_one_line_is_the_long_way(self):
        mapper = vtkTemporalCoherenceVolumeMapper()
        mapper.SetInputData(image_of(distances()))
        volume = vtkVolume()
        volume.SetMapper(mapper)
        look = volume.GetProperty()
        look.GetIsoSurfaceValues().SetValue(0, VALUE)
        color = vtkColorTransferFunction()
        color.AddRGBPoint(VALUE, 1.0, 0.0, 0.0)
        look.SetColor(color)
        look.SetInterpolationTypeToLinear()
        look.ShadeOn()
        look.SetAmbient(0.0)
        look.SetDiffuse(1.0)
        look.SetSpecular(0.0)
        renderer = vtkRenderer()
        camera = renderer.GetActiveCamera()
        camera.SetPosition(1.0, 1.0, 1.0)
        camera.SetFocalPoint(0.0, 0.0, 0.0)
        camera.SetViewUp(0.0, 0.0, 1.0)
        renderer.ResetCamera(volume.GetBounds())
        expected = render(volume, renderer, (120, 100))

        picture = isosurface(distances(), VALUE, color="red", **PLACE).picture((120, 100))
        self.assertTrue(numpy.array_equal(picture.planes.color, expected.color))
        self.assertTrue(numpy.array_equal(picture.depth, expected.depth[::-1]))
        self.assertTrue(numpy.array_equal(picture.normals, expected.normals[::-1]))
        self.assertTrue(numpy.array_equal(picture.isovalue_index, expected.isovalue_index[::-1]))
        self.assertEqual(picture.size, (120, 100))
        self.assertEqual(repr(picture), "<Picture of 120 x 100 pixels>")

    def test_the_first_row_is_the_top_one(self):
        above = distances((0.0, 0.0, 0.6))
        volume = isosurface(above, 0.7, **PLACE)
        volume.look_from("xz")
        rows = (volume.picture((64, 64)).color[..., 3] > 0).any(axis=1)
        self.assertTrue(rows[:32].any())
        self.assertFalse(rows[32:].any(), "z is up")

    def test_colors_are_not_multiplied(self):
        picture = isosurface(
            distances(), VALUE, color=(1.0, 0.5, 0.0), opacity=0.3, lighting=False, **PLACE
        ).picture((80, 80))
        half = picture.color[picture.color[..., 3] > 70].astype(int)
        self.assertLess(half[:, 3].max(), 140)
        self.assertGreater(len(half), 100)
        self.assertLessEqual(numpy.abs(half[:, :3] - (255, 127.5, 0)).max(), 3)

    def test_files(self):
        volume = isosurface(distances(), VALUE, **PLACE)
        picture = volume.picture((60, 40))
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "sphere.PNG"
            picture.save(path)
            found = from_top(path.read_bytes())
            self.assertTrue(numpy.array_equal(found, picture.color), "transparent")
            picture.save(path, background=(1.0, 1.0, 1.0))
            white = from_top(path.read_bytes())
            self.assertEqual(white.shape, (40, 60, 3))
            self.assertTrue((white[0, 0] == 255).all())
            volume.save(str(path), (30, 20))
            self.assertEqual(from_top(path.read_bytes()).shape, (20, 30, 4))
            for name in ("sphere.jpg", "sphere", "png"):
                path_of_another = os.path.join(folder, name)
                for write in (picture.save, volume.save,
                              lambda path: write_png(path, picture.planes.color)):
                    for other in (path_of_another, pathlib.Path(path_of_another),
                                  path_of_another.encode()):
                        with self.assertRaisesRegex(ValueError, rf"ends in \.png, not '.*{name}'"):
                            write(other)
                self.assertFalse(os.path.exists(path_of_another))
            for write in (picture.save, volume.save):
                with self.assertRaisesRegex(TypeError, "a path or .*, not to int"):
                    write(1)
            with self.assertRaisesRegex(ValueError, "background"):
                picture.save(path, background=(2, 0, 0))
        stream = io.BytesIO()
        picture.save(stream)
        self.assertEqual(stream.getvalue(), picture._repr_png_())

    def test_notebooks(self):
        for volume in (isosurface(ramp(), 40.0), composite(ramp()), maximum(ramp())):
            data = volume._repr_png_()
            self.assertTrue(data.startswith(b"\x89PNG"))
            self.assertEqual(from_top(data).shape, (512, 512, 4))

    def test_views(self):
        volume = isosurface(distances((0.5, 0.0, 0.0)), 0.7, **PLACE)

        def middle(view):
            volume.look_from(view)
            y, x = numpy.nonzero(volume.picture((64, 64)).color[..., 3])
            return x.mean() - 31.5, y.mean() - 31.5

        for view, sign in (("xy", 1), ("xz", 1), ("zx", 0), ((0, 0, -5), -1)):
            across, down = middle(view)
            expected = sign if view != "zx" else 0
            if view == "zx":
                self.assertGreater(abs(across) + abs(down), 5.0)
            else:
                self.assertGreater(expected * across, 5.0, view)
                self.assertLess(abs(down), 2.0, view)
        for wrong in ("top", (0, 0, 0), (1, 2), 7, (math.nan, 0, 1), None):
            with self.assertRaisesRegex(ValueError, "view"):
                volume.look_from(wrong)

    def test_frames_are_kept(self):
        volume = isosurface(distances(), VALUE, **PLACE)
        volume.picture((40, 40))
        volume.picture((40, 40))
        mapper = volume.GetMapper()
        self.assertEqual(
            mapper.GetStatistics().GetRoute(), vtkTemporalCoherenceVolumeMapper.ROUTE_REDISPLAY)

    def test_nothing_is_cut(self):
        volume = isosurface(distances(), VALUE, **PLACE)
        near = (volume.picture((64, 64)).color[..., 3] > 0).sum()
        for factor, least in ((3.0, 3.0 * near), (1.0 / 15.0, 10)):
            volume.renderer.GetActiveCamera().Dolly(factor)
            self.assertGreater((volume.picture((64, 64)).color[..., 3] > 0).sum(), least)
        wide = isosurface(distances(), 0.05, **PLACE)
        wide.look_from("xy")
        for size in ((40, 160), (160, 40)):
            alpha = wide.picture(size).color[..., 3]
            self.assertTrue(alpha.any())
            self.assertFalse(
                alpha[0].any() or alpha[-1].any() or alpha[:, 0].any() or alpha[:, -1].any(), size)

    def test_nearly_along_z(self):
        volume = isosurface(distances((0.5, 0.0, 0.0)), 0.7, **PLACE)
        volume.look_from((0.001, 0.0, 1.0))
        x = numpy.nonzero(volume.picture((64, 64)).color[..., 3])[1]
        self.assertGreater(x.mean(), 36.0, "y is up, as seen along z")

    def test_numbers_that_are_written(self):
        array = distances()
        volume = isosurface(array, VALUE, **PLACE)
        before = volume.picture((40, 40)).color
        array[:] = distances((0.3, 0.0, 0.0))
        volume.data_changed()
        after = volume.picture((40, 40)).color
        self.assertFalse(numpy.array_equal(before, after))
        anew = isosurface(array, VALUE, **PLACE).picture((40, 40)).color
        self.assertTrue(numpy.array_equal(after, anew))
        blocks = vtkMultiBlockDataSet()
        blocks.SetBlock(0, image_of(array))
        volume = isosurface(blocks, VALUE)
        volume.picture((40, 40))
        array[:] = distances()
        volume.data_changed()
        self.assertTrue(numpy.array_equal(volume.picture((40, 40)).color, before))

    def test_warnings(self):
        with self.assertWarnsRegex(UserWarning, "^Isovalue 99 separates no samples.*set an isovalue"):
            isosurface(distances(), 99.0).picture((20, 20))

    def test_repr(self):
        self.assertEqual(
            repr(isosurface(ramp(), 40.0)), "<IsosurfaceVolume from (0, 0, 0) to (14, 11, 8)>")

    def test_no_display(self):
        self.assertNotIn("DISPLAY", os.environ)
        with self.assertRaisesRegex(RuntimeError, "no display"):
            isosurface(ramp(), 40.0).show()

    def test_display_that_does_not_answer(self):
        try:
            ctypes.CDLL("libX11.so.6")
        except OSError:
            self.skipTest("There is no X here.")
        with mock.patch.dict(os.environ, {"DISPLAY": ":98765"}), \
                self.assertRaisesRegex(RuntimeError, "No display answers at DISPLAY=':98765'"):
            isosurface(ramp(), 40.0).show()


class Data(unittest.TestCase):
    def test_labeled_arrays(self):
        axis = numpy.linspace(-1.0, 1.0, distances().shape[0])
        expected = isosurface(distances(), VALUE, **PLACE).picture((64, 64))
        labeled = LabeledArray(distances((0.0, 0.2, 0.1)), "distance", z=axis, y=axis, x=axis)
        given = isosurface(distances((0.0, 0.2, 0.1)), VALUE, **PLACE).picture((64, 64))
        self.assertFalse(numpy.array_equal(given.color, expected.color))
        found = isosurface(labeled, VALUE, "distance").picture((64, 64))
        self.assertLess(numpy.abs(
            found.planes.color.astype(int) - given.planes.color).mean(), 0.1)
        falling = LabeledArray(labeled.values[::-1, :, ::-1], z=axis[::-1], y=axis, x=axis[::-1])
        again = isosurface(falling, VALUE).picture((64, 64))
        self.assertTrue(numpy.array_equal(found.planes.color, again.planes.color))

    def test_uneven_coordinates(self):
        axis = numpy.array([0.0, 1.0, 3.0, 4.0])
        labeled = LabeledArray(numpy.arange(64.0).reshape(4, 4, 4), a=axis, b=axis, c=axis)
        volume = isosurface(labeled, 20.0)
        self.assertIsInstance(volume.GetMapper().GetInputDataObject(0, 0), vtkRectilinearGrid)
        self.assertEqual(volume.GetBounds(), (0.0, 4.0) * 3)
        self.assertTrue((volume.picture((32, 32)).color[..., 3] > 0).any())

    def test_what_is_no_volume(self):
        axis = numpy.arange(9.0)
        cube = numpy.zeros((9, 9, 9))
        for data, error, text in (
                (vtkPolyData(), TypeError, "polygons"),
                ([[[1.0]]], TypeError, "data set"),
                ("volume.vti", OSError, "not there"),
                (None, TypeError, "data set"),
                (numpy.zeros((3, 3)), ValueError, "shape"),
                (numpy.zeros((3, 3, 3), complex), TypeError, "real numbers"),
                (numpy.ma.masked_array(cube), TypeError, "masked"),
                (cube[:1], ValueError, "two samples or more"),
                (LabeledArray(cube[:, :0], z=axis, y=axis[:0], x=axis), ValueError, "with samples"),
                (LabeledArray(cube[0], y=axis, x=axis), ValueError, "three dimensions"),
                (LabeledArray(cube, z=axis.astype("M8[s]"), y=axis, x=axis), ValueError, "numbers"),
                (LabeledArray(cube, z=numpy.zeros((9, 9)), y=axis, x=axis), ValueError, "numbers"),
                (LabeledArray(numpy.zeros((2, 9, 9, 9)), t=axis[:2], z=axis, y=axis, x=axis),
                 ValueError, "three dimensions"),
                (LabeledArray(cube, z=axis[::-1] ** 2 % 5, y=axis, x=axis), ValueError, "sortby"),
                (LabeledArray(cube, z=["a"] * 9, y=axis, x=axis), ValueError, "numbers")):
            for make in (lambda data: isosurface(data, 0.5), composite, maximum):
                with self.assertRaisesRegex(error, text):
                    make(data)

    def test_what_only_looks_like_a_labeled_array(self):
        class Dataset:  # such as those of h5py
            dims, shape = ("", "", ""), distances().shape

            def __array__(self, dtype=None, copy=None):
                return distances()

        volume = isosurface(Dataset(), VALUE, **PLACE)
        expected = isosurface(distances(), VALUE, **PLACE)
        self.assertTrue(numpy.array_equal(
            volume.picture((30, 30)).color, expected.picture((30, 30)).color))

    def test_places_of_arrays(self):
        for make in (lambda **place: isosurface(ramp(), 40.0, **place),
                     lambda **place: composite(ramp(), **place),
                     lambda **place: maximum(ramp(), **place)):
            volume = make(spacing=(1, 2, 0.5), origin=(5, 6, 7))
            self.assertEqual(volume.GetBounds(), (5.0, 19.0, 6.0, 28.0, 7.0, 11.0))
            for wrong in ({"spacing": (1, 2)}, {"spacing": (1, 0, 1)}, {"spacing": 2.0},
                          {"spacing": (1, -1, 1)}, {"origin": (math.nan, 0, 0)},
                          {"origin": "here"}):
                with self.assertRaisesRegex(ValueError, "three"):
                    make(**wrong)
        with self.assertRaisesRegex(ValueError, "those of the data"):
            isosurface(image_of(distances()), VALUE, spacing=(1, 1, 1))


class Blended(unittest.TestCase):
    def test_maxima(self):
        array = numpy.zeros((20, 20, 20), numpy.uint8)
        array[5:15, 5:15, 5:15] = 100
        array[9:11, 9:11, 9:11] = 200
        volume = maximum(array, window=200, level=100)
        volume.look_from("xy")
        picture = volume.picture((101, 101))
        self.assertEqual(tuple(picture.color[50, 50]), (255, 255, 255, 255))
        self.assertLess(abs(int(picture.color[50, 38, 0]) - 127), 4)
        self.assertEqual(tuple(picture.color[0, 0]), (0, 0, 0, 0))
        darker = maximum(array, window=400, level=200)
        darker.look_from("xy")
        self.assertLess(abs(int(darker.picture((101, 101)).color[50, 50, 0]) - 127), 4)

    def test_values_at_the_ends(self):
        ball = distances() > VALUE
        for data in (ball, 255 * ball.astype(numpy.uint8), 1e20 * ball):
            middle = maximum(data, **PLACE).picture((32, 32)).color[16, 16]
            self.assertEqual(tuple(middle), (255, 255, 255, 255))
            self.assertGreater(composite(data, **PLACE).picture((32, 32)).color[16, 16, 3], 200)
        for value in (0.0, 7.0, -3.0, 1e20):
            constant = numpy.full((5, 5, 5), value)
            self.assertEqual(tuple(maximum(constant).picture((32, 32)).color[16, 16]), (0, 0, 0, 255))
        # Rows as long as a step between every so many samples.
        long = numpy.zeros((1000, 1000, 8), numpy.uint8)
        long[300:700, 300:700, 2:6] = 100
        volume = maximum(long)
        volume.look_from("yz")
        picture = volume.picture((32, 32))
        self.assertEqual(tuple(picture.color[16, 16]), (255, 255, 255, 255))
        self.assertLess(picture.color[3, 16, 0], 10)

    def test_presets_and_shift(self):
        hounsfield = numpy.where(distances() > VALUE, 700.0, -1000.0).astype(numpy.float32)
        presets = vtkTemporalCoherence.vtkTemporalCoherencePresets
        units = filter(presets.GetPresetIsInHounsfieldUnits, vtkTemporalCoherence.blended.PRESETS)
        for preset in units:
            with self.subTest(preset):
                shown = composite(hounsfield, preset, **PLACE).picture((64, 64))
                self.assertGreater(shown.color[32, 32, 3], 200)
                shifted = composite(hounsfield + 1024, preset, shift=1024, **PLACE)
                difference = shifted.picture((64, 64)).planes.color.astype(int)
                self.assertLess(numpy.abs(difference - shown.planes.color).max(), 4)
        nothing = composite(hounsfield, "ct bone", shift=2000.0, **PLACE).picture((64, 64))
        self.assertFalse(nothing.color.any())

    def test_opacity_and_steps_do_not_depend_on_the_unit(self):
        alpha = []
        for unit in (1e-3, 1.0, 1e3):
            volume = composite(distances(), spacing=(unit,) * 3)
            alpha.append(volume.picture((64, 64)).color[..., 3].astype(int))
        self.assertGreater(alpha[0].max(), 100)
        for other in alpha[1:]:
            self.assertLess(numpy.abs(other - alpha[0]).mean(), 1.0)
        faint = composite(distances(), opacity=0.2, **PLACE).picture((64, 64))
        self.assertLess(faint.color[..., 3].mean(), 0.9 * alpha[1].mean())

    def test_bits(self):
        ball = distances() > VALUE
        expected = image_of(ball.astype(numpy.uint8))
        bits = vtkBitArray()
        bits.SetName("bits")
        bits.SetNumberOfValues(ball.size)
        for index, bit in enumerate(ball.ravel()):
            bits.SetValue(index, int(bit))
        image = image_of(ball.astype(numpy.uint8))
        image.GetPointData().SetScalars(bits)
        for make in (composite, maximum, lambda data: isosurface(data, 0.5, cmap=["red", "blue"])):
            shown = make(image).picture((48, 48)).color
            self.assertGreater(shown[24, 24, 3], 100)
            self.assertTrue(numpy.array_equal(shown, make(expected).picture((48, 48)).color))

    def test_constant_and_infinite_values(self):
        for array in (numpy.full((5, 5, 5), 7.0), numpy.full((5, 5, 5), math.nan),
                      numpy.where(ramp() > 30.0, math.inf, 1.0)):
            for make in (composite, maximum):
                with warnings.catch_warnings():
                    warnings.simplefilter("ignore")  # some of them show nothing
                    make(array).picture((16, 16))

    def test_mistakes(self):
        for arguments, text in (
                ({"preset": "bone"}, "only ct bone"), ({"scalars": "pressure"}, "choose of"),
                ({"opacity": 0.0}, "opacity"), ({"opacity": "much"}, "opacity"),
                ({"shift": math.inf}, "shift")):
            with self.assertRaisesRegex(ValueError, text):
                composite(image_of(distances()), **arguments)
        for arguments, text in (
                ({"window": 0.0}, "window"), ({"level": "high"}, "level"),
                ({"window": math.nan}, "window")):
            with self.assertRaisesRegex(ValueError, text):
                maximum(ramp(), **arguments)
        for make in (composite, maximum):
            with self.assertRaisesRegex(TypeError, "name of an array, not ndarray"):
                make(ramp(), scalars=ramp())
            for arguments, text in (
                    ({"scalars": "cells"}, "no array 'cells' at the points: .* vtkCellDataToPointData"),
                    ({"scalars": "words"}, "no array 'words' at the points: the data have no arrays"),
                    ({}, "no array of numbers at the points: add one, .*vtkCellDataToPointData")):
                with self.assertRaisesRegex(ValueError, text):
                    make(without_points(), **arguments)
            with self.assertRaisesRegex(TypeError, "vtkResampleToImage"):
                make(vtkUnstructuredGrid())
            with self.assertRaisesRegex(ValueError, "components"):
                make(numpy.zeros((4, 4, 4, 3)))


class Pages(unittest.TestCase):
    def test_the_code_of_the_page_runs(self):
        page = (REPOSITORY / "Documentation" / "Python.md").read_text(encoding="utf-8")
        code = "".join(re.findall(r"```python\n(.*?)```", page, re.DOTALL))
        self.assertIn("composite(array", code)
        # No window, and no Matplotlib.
        code = code.replace(".show()", ".picture()").replace("matplotlib.pyplot.imshow", "len")
        before = os.getcwd()
        with tempfile.TemporaryDirectory() as folder:
            os.chdir(folder)
            try:
                labels = (distances() < 0.7).astype(numpy.uint8)
                labels[:, :, labels.shape[2] // 2:] *= 2
                exec(code, {
                    "array": (200.0 * distances()).astype(numpy.float32), "labels": labels,
                    "temperatures": 280.0 + 40.0 * distances(), "numpy": numpy,
                    "segmentation": vtkTemporalCoherence.segmentation})
            finally:
                os.chdir(before)
            for name in ("surfaces.png", "bone.png"):
                self.assertGreater(os.path.getsize(os.path.join(folder, name)), 1000)

    def test_version(self):
        project = (REPOSITORY / "CMakeLists.txt").read_text(encoding="utf-8")
        version = re.search(r"VERSION (\d+\.\d+\.\d+)", project)[1]
        self.assertEqual(vtkTemporalCoherence.__version__, version)
        self.assertEqual(importlib.metadata.version("vtkTemporalCoherence"), version)


if __name__ == "__main__":
    unittest.main()
