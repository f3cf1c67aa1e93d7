# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures and what is known of their pixels, without a window: right, re-used, and errors told."""

import contextlib
import io
import os
import tempfile
import unittest

import numpy
from spheres import (
    DEPTH_TOLERANCE, STEP, distances, image_of, renderer_at, sphere_depth, volume_of)
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import reference
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData
from vtkmodules.vtkIOImage import vtkPNGReader
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkVolume
from vtkTemporalCoherence import (
    Planes, planes, render, vtkTemporalCoherenceVolume, vtkTemporalCoherenceVolumeMapper,
    write_png)

DISTANCE = 5.0
SIZE = (200, 160)


def scene(*isovalues):
    return volume_of(image_of(distances()), *isovalues), renderer_at(DISTANCE)


class SpherePlanes(unittest.TestCase):
    def setUp(self):
        self.volume, self.renderer = scene(0.5)
        self.planes = render(self.volume, self.renderer, SIZE)
        self.truth = sphere_depth(0.5, DISTANCE, *SIZE)

    def test_shapes_and_types(self):
        self.assertEqual(
            [(plane.shape, plane.dtype.name) for plane in self.planes],
            [((160, 200, 4), "uint8"), ((160, 200), "float32"), ((160, 200, 3), "float32"),
             ((160, 200), "int32"), ((160, 200), "uint8")])

    def test_depth_is_that_of_the_sphere(self):
        is_hit = numpy.isfinite(self.planes.depth)
        is_sphere = numpy.isfinite(self.truth)
        # Only rays that graze the sphere may differ.
        grazing = sphere_depth(0.5 + STEP / 8.0, DISTANCE, *SIZE) < numpy.inf
        grazing &= ~(sphere_depth(0.5 - STEP / 8.0, DISTANCE, *SIZE) < numpy.inf)
        self.assertFalse(numpy.any((is_hit != is_sphere) & ~grazing))
        self.assertGreater(is_hit.sum(), 2000)
        inner = is_hit & is_sphere & ~grazing
        # Along the normal: a ray that hardly meets the sphere goes far until it does.
        error = self.planes.depth[inner] - self.truth[inner]
        error *= self.planes.normals[inner][:, 2]
        self.assertLess(numpy.abs(error).max(), DEPTH_TOLERANCE)

    def test_normals_are_those_of_the_sphere(self):
        y, x = numpy.nonzero(self.planes.isovalue_index == 0)
        position, normal, index = [0.0] * 3, [0.0] * 3, [7]
        for row, column in list(zip(y, x))[::97]:
            row, column = int(row), int(column)
            self.assertTrue(self.volume.GetMapper().PickPixel(column, row, position, normal, index))
            numpy.testing.assert_allclose(
                normal, numpy.divide(position, numpy.linalg.norm(position)), atol=0.03)
            numpy.testing.assert_allclose(normal, self.planes.normals[row, column], atol=1e-6)
            self.assertAlmostEqual(numpy.linalg.norm(position), 0.5, delta=DEPTH_TOLERANCE)
            self.assertEqual(index, [0])

    def test_planes_agree_where_nothing_is_hit(self):
        is_hit = numpy.isfinite(self.planes.depth)
        numpy.testing.assert_array_equal(self.planes.color[..., 3] == 255, is_hit)
        numpy.testing.assert_array_equal(self.planes.color.any(axis=2), is_hit)
        numpy.testing.assert_array_equal(self.planes.normals.any(axis=2), is_hit)
        numpy.testing.assert_array_equal(self.planes.isovalue_index, numpy.where(is_hit, 0, -1))
        self.assertTrue((self.planes.answer[is_hit] > 0).all())

    def test_row_0_is_the_bottom_row(self):
        upper = volume_of(image_of(distances((0.4, 0.45, 0.0))), 0.7)
        y, x = numpy.nonzero(numpy.isfinite(render(upper, self.renderer, SIZE).depth))
        self.assertGreater(y.min(), 80)
        self.assertGreater(x.min(), 100)

    def test_are_those_of_the_mapper(self):
        color, depth = vtkImageData(), vtkImageData()
        mapper = vtkTemporalCoherenceVolumeMapper()
        mapper.SetInputData(self.volume.GetMapper().GetDataSetInput())
        mapper.SetAntialiasingToOff()
        self.assertTrue(mapper.MakeImage(self.renderer, self.volume, *SIZE, color, depth))
        for image, plane in ((color, self.planes.color), (depth, self.planes.depth)):
            self.assertEqual(image.GetDimensions(), (*SIZE, 1))
            numpy.testing.assert_array_equal(
                vtk_to_numpy(image.GetPointData().GetScalars()).ravel(), plane.ravel())
        frame = vtkImageData()
        self.assertTrue(mapper.MakeImage(self.renderer, self.volume, *SIZE, frame))
        data = frame.GetPointData()
        self.assertEqual(
            [data.GetArrayName(index) for index in range(data.GetNumberOfArrays())],
            ["Color", "Depth", "Normals", "IsovalueIndex", "Answer"])
        for index, plane in enumerate(self.planes):
            numpy.testing.assert_array_equal(
                vtk_to_numpy(data.GetArray(index)).ravel(), plane.ravel())
        self.assertTrue(mapper.GetLastFrame(frame, mapper.FRAME_DEPTH + mapper.FRAME_ANSWER))
        self.assertEqual(frame.GetPointData().GetNumberOfArrays(), 2)
        self.assertEqual(frame.GetPointData().GetScalars().GetName(), "Depth")

    def test_only_those_asked_for(self):
        some = planes(self.volume.GetMapper(), ["depth", "answer"])
        self.assertEqual(
            [name for name in Planes._fields if getattr(some, name) is not None],
            ["depth", "answer"])
        numpy.testing.assert_array_equal(some.depth, self.planes.depth)

    def test_isovalues_have_positions(self):
        # The inner sphere is seen through a hole that cropping leaves in the outer one.
        self.volume.GetProperty().GetIsoSurfaceValues().SetValue(1, 0.2)
        mapper = self.volume.GetMapper()
        mapper.CroppingOn()
        mapper.SetCroppingRegionPlanes(-1.0, 1.0, -1.0, 1.0, -1.0, 0.6)
        index = render(self.volume, self.renderer, SIZE).isovalue_index
        self.assertEqual(index[80, 100], 0)
        self.assertEqual(set(numpy.unique(index)), {-1, 0, 1})

    def test_any_volume_and_any_numbers_for_the_size(self):
        volume = vtkTemporalCoherenceVolume()
        volume.SetMapper(self.volume.GetMapper())
        volume.SetProperty(self.volume.GetProperty())
        self.assertTrue(volume.GetMapper().IsOpaque(volume))
        again = render(volume, self.renderer, numpy.array(SIZE))
        numpy.testing.assert_array_equal(again.color, self.planes.color)

    def test_a_renderer_without_a_camera_looks_at_the_volume(self):
        for renderer in (None, vtkRenderer()):
            is_hit = numpy.isfinite(render(self.volume, renderer, (100, 100)).depth)
            self.assertTrue(is_hit[50, 50])
            self.assertFalse(is_hit[0].any() or is_hit[-1].any())

    def test_lines_and_points(self):
        mapper = self.volume.GetMapper()
        share, position, normal, index = reference(0.0), [0.0] * 3, [0.0] * 3, [7]
        self.assertTrue(mapper.IntersectWithLine(
            self.volume, (0.0, 0.0, 2.0), (0.0, 0.0, -2.0), share, position, normal, index))
        self.assertAlmostEqual(share.get(), 0.375, delta=DEPTH_TOLERANCE)
        self.assertAlmostEqual(position[2], 0.5, delta=DEPTH_TOLERANCE)
        self.assertEqual(index, [0])
        points = vtkPolyData()
        self.assertTrue(mapper.GetVisibleSurface(points))
        self.assertEqual(points.GetNumberOfPoints(), numpy.isfinite(self.planes.depth).sum())


class Reuse(unittest.TestCase):
    def setUp(self):
        self.volume, self.renderer = scene(0.5)
        self.mapper = self.volume.GetMapper()

    def picture(self, isovalue=None):
        if isovalue is not None:
            self.volume.GetProperty().GetIsoSurfaceValues().SetValue(0, isovalue)
        return render(self.volume, self.renderer, SIZE), self.mapper.GetStatistics().GetRouteAsString()

    def test_routes(self):
        self.assertEqual(self.picture()[1], "Cold")
        self.assertEqual(self.picture()[1], "Redisplay")
        self.volume.GetProperty().SetAmbient(0.3)
        self.assertEqual(self.picture()[1], "Reshade")
        self.renderer.GetActiveCamera().Azimuth(2.0)
        self.assertEqual(self.picture()[1], "Cold")
        self.mapper.SetReuseAccuracyToPaper()
        for route in ("Cold", "ImageCache"):
            self.renderer.GetActiveCamera().Azimuth(2.0)
            self.assertEqual(self.picture()[1], route)
        self.mapper.ClearCache()
        self.assertEqual(self.picture()[1], "Cold")
        self.mapper.IsomapOff()
        self.assertEqual(self.picture(0.51)[1], "Cold")

    def test_sweep_is_looked_up_and_the_same_as_cold(self):
        self.mapper.SetIsomapRange(0.3, 0.7)
        isovalues = numpy.linspace(0.3, 0.7, 9)
        routes = []
        for isovalue in isovalues:
            swept, route = self.picture(isovalue)
            routes.append(route)
            cold = render(scene(isovalue)[0], renderer_at(DISTANCE), SIZE)
            for name in ("color", "depth", "normals", "isovalue_index"):
                numpy.testing.assert_array_equal(getattr(swept, name), getattr(cold, name), name)
        self.assertEqual(routes, ["Cold", "IsomapBuild"] + 7 * ["IsomapLookup"])
        self.assertGreater(self.mapper.GetStatistics().GetIsomapMemory(), 0)
        self.assertGreater(self.mapper.GetStatistics().GetFrameTime(), 0.0)

    def test_isomap_ahead_of_the_first_change(self):
        self.picture()
        self.mapper.SetIsomapRange(0.3, 0.7)
        self.assertTrue(self.mapper.BuildIsomap(self.renderer, self.volume))
        self.assertEqual(self.picture(0.6)[1], "IsomapLookup")


class Mistakes(unittest.TestCase):
    def setUp(self):
        self.volume, self.renderer = scene(0.5)

    def test_of_the_mapper_are_raised_each_time_and_the_last_picture_stays(self):
        before = render(self.volume, self.renderer, SIZE)
        mapper = self.volume.GetMapper()
        mapper.SetScalarModeToUsePointFieldData()
        mapper.SelectScalarArray("pressure")
        said = io.StringIO()
        with contextlib.redirect_stderr(said):
            for _ in range(3):
                with self.assertRaisesRegex(ValueError, "no array .*'pressure'.*choose"):
                    render(self.volume, self.renderer, SIZE)
        self.assertEqual(said.getvalue(), "")
        numpy.testing.assert_array_equal(planes(mapper).color, before.color)
        mapper.SelectScalarArray("scalars")
        render(self.volume, self.renderer, SIZE)

    def test_a_stopped_picture_is_not_blamed_on_an_earlier_mistake(self):
        mapper = self.volume.GetMapper()
        with self.assertRaisesRegex(ValueError, "at least 1"):
            render(self.volume, self.renderer, (0, 0))
        render(self.volume, self.renderer, SIZE)
        self.renderer.GetActiveCamera().Azimuth(40.0)
        observer = mapper.AddObserver(
            "VolumeMapperRenderProgressEvent", lambda *_: mapper.SetAbortExecute(1))
        with self.assertRaisesRegex(ValueError, "was stopped before it was complete: call"):
            render(self.volume, self.renderer, SIZE)
        mapper.RemoveObserver(observer)
        render(self.volume, self.renderer, SIZE)

    def test_no_frame(self):
        with self.assertRaisesRegex(ValueError, r"no frame yet: call render\(\)"):
            planes(self.volume.GetMapper())

    def test_no_input(self):
        volume = vtkVolume()
        volume.SetMapper(vtkTemporalCoherenceVolumeMapper())
        with self.assertRaisesRegex(ValueError, "There is no input; give"):
            render(volume)

    def test_no_such_mapper(self):
        for wrong in (vtkVolume(), None, 3):
            with self.assertRaisesRegex(TypeError, "render.. draws a vtkVolume|must be a vtkTemp"):
                render(wrong)
            with self.assertRaisesRegex(TypeError, r"set one with volume.SetMapper"):
                planes(wrong)

    def test_no_such_plane(self):
        with self.assertRaisesRegex(ValueError, "no plane 'colour', only color, depth"):
            render(self.volume, names=["colour"])
        with self.assertRaisesRegex(TypeError, "by their names, not by None"):
            render(self.volume, names=None)

    def test_one_plane_by_its_name(self):
        only = render(self.volume, self.renderer, (20, 10), names="depth")
        self.assertEqual(only.depth.shape, (10, 20))
        self.assertIsNone(only.color)

    def test_no_renderer(self):
        with self.assertRaisesRegex(TypeError, "from a vtkRenderer, not str: give one, or None"):
            render(self.volume, "renderer")

    def test_sizes(self):
        for wrong in ((0, 100), (100, -1)):
            with self.assertRaisesRegex(ValueError, "give a width and a height of at least 1"):
                render(self.volume, self.renderer, wrong)
        for wrong in ((100000, 100000), (2**40, 1)):
            with self.assertRaisesRegex(ValueError, "too large"):
                render(self.volume, self.renderer, wrong)
        for wrong in (100, (100,), (100, 100, 100), (1.5, 100), "ab"):
            with self.assertRaisesRegex(TypeError, "two whole numbers"):
                render(self.volume, self.renderer, wrong)


class Png(unittest.TestCase):
    def setUp(self):
        self.color = numpy.zeros((3, 5, 4), numpy.uint8)
        self.color[0, 1] = (200, 100, 50, 255)
        self.color[2, 4] = (64, 32, 0, 128)

    def read(self, path):
        reader = vtkPNGReader()
        reader.SetFileName(path)
        reader.Update()
        return vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).reshape(3, 5, 3)

    def test_is_laid_over_the_background(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "a.png")
            write_png(path, self.color)
            numpy.testing.assert_array_equal(self.read(path), self.color[..., :3])
            write_png(path, self.color, background=(1.0, 1.0, 0.5))
            pixels = self.read(path)
            self.assertEqual(pixels[0, 1].tolist(), [200, 100, 50])
            self.assertEqual(pixels[2, 4].tolist(), [191, 159, 64])
            self.assertEqual(pixels[1, 1].tolist(), [255, 255, 128])

            file = io.BytesIO()
            write_png(file, self.color, background=(1.0, 1.0, 0.5))
            with open(path, "rb") as written:
                self.assertEqual(file.getvalue(), written.read())

    def test_mistakes(self):
        with self.assertRaises(FileNotFoundError):
            write_png("/nowhere/a.png", self.color)
        for wrong in (self.color[0], self.color[..., :3], self.color.astype(float)):
            with self.assertRaisesRegex(TypeError, "give the plane color"):
                write_png(io.BytesIO(), wrong)
        with self.assertRaisesRegex(TypeError, "must be a NumPy array, not NoneType"):
            write_png(io.BytesIO(), None)
        with self.assertRaisesRegex(ValueError, "has no pixels"):
            write_png(io.BytesIO(), self.color[:0])
        for wrong in ("red", (1.0, 1.0), (5.0, 0.0, 0.0), 1.0):
            with self.assertRaisesRegex(ValueError, "three numbers from 0 to 1"):
                write_png(io.BytesIO(), self.color, background=wrong)


if __name__ == "__main__":
    unittest.main()
