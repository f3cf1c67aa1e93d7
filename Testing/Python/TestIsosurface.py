# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""isosurface() of VTK's data: what it draws, and what it says of mistakes.

Testing/PyVista has PyVista's data, and compares pictures.
"""

import unittest

import numpy
from spheres import distances, image_of, renderer_at
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkLookupTable, vtkPoints
from vtkmodules.vtkCommonDataModel import (
    vtkImageData, vtkMultiBlockDataSet, vtkPolyData, vtkRectilinearGrid, vtkStructuredGrid, vtkTable)
from vtkmodules.vtkFiltersCore import vtkAppendFilter, vtkPointDataToCellData
from vtkTemporalCoherence import IsosurfaceVolume, isosurface, numpy_to_image, render

#: Of the isovalue v, the sphere has the radius 1 - v.
VALUE = 0.5


def picture(*arguments, **look):
    volume = isosurface(*arguments, **look)
    return render(volume, renderer_at(4.0), (100, 100))


def coordinates():
    axis = numpy.linspace(-1.0, 1.0, distances().shape[0])
    return numpy_to_vtk(axis, deep=1)


def rectilinear():
    grid = vtkRectilinearGrid()
    image = image_of(distances())
    grid.SetDimensions(image.GetDimensions())
    grid.SetXCoordinates(coordinates())
    grid.SetYCoordinates(coordinates())
    grid.SetZCoordinates(coordinates())
    grid.GetPointData().SetScalars(image.GetPointData().GetScalars())
    return grid


def structured():
    axis = vtk_to_numpy(coordinates())
    z, y, x = numpy.meshgrid(axis, axis, axis, indexing="ij")
    points = vtkPoints()
    points.SetData(numpy_to_vtk(numpy.stack([x.ravel(), y.ravel(), z.ravel()], axis=1), deep=1))
    grid = vtkStructuredGrid()
    grid.SetDimensions(image_of(distances()).GetDimensions())
    grid.SetPoints(points)
    grid.GetPointData().SetScalars(image_of(distances()).GetPointData().GetScalars())
    return grid


def unstructured():
    append = vtkAppendFilter()
    append.AddInputData(image_of(distances()))
    append.Update()
    return append.GetOutput()


def blocks(*parts):
    nested = vtkMultiBlockDataSet()
    for index, part in enumerate(parts):
        nested.SetBlock(index, part)
    outer = vtkMultiBlockDataSet()
    outer.SetBlock(1, nested)
    return outer


class Grids(unittest.TestCase):
    def test_kinds(self):
        expected = picture(image_of(distances()), VALUE)
        self.assertGreater(numpy.isfinite(expected.depth).mean(), 0.1)
        for make in (rectilinear, structured, unstructured,
                     lambda: blocks(image_of(distances())), lambda: blocks(None, unstructured())):
            found = picture(make(), VALUE)
            self.assertEqual(
                (numpy.isfinite(found.depth) != numpy.isfinite(expected.depth)).sum(), 0)
            hit = numpy.isfinite(expected.depth)
            self.assertLess(numpy.abs(found.depth[hit] - expected.depth[hit]).max(), 1e-4)

    def test_cells(self):
        convert = vtkPointDataToCellData()
        convert.SetInputData(image_of(distances()))
        convert.Update()
        found = picture(convert.GetOutput(), VALUE)
        self.assertGreater(numpy.isfinite(found.depth).mean(), 0.1)

    def test_the_grid_stays_as_it_is(self):
        image = image_of(distances())
        isosurface(image, VALUE, numpy.zeros(image.GetNumberOfPoints()))
        self.assertEqual(image.GetPointData().GetNumberOfArrays(), 1)


class Scalars(unittest.TestCase):
    def setUp(self):
        self.image = image_of(distances())
        self.expected = picture(self.image, VALUE).depth

    def assert_same(self, found):
        self.assertTrue(numpy.array_equal(found.depth, self.expected))

    def test_by_name(self):
        other = numpy_to_vtk(numpy.zeros(self.image.GetNumberOfPoints()), deep=1)
        other.SetName("other")
        self.image.GetPointData().AddArray(other)
        self.assert_same(picture(self.image, VALUE, "scalars"))
        self.assertFalse(numpy.isfinite(picture(self.image, VALUE, "other").depth).any())

    def test_without_a_name(self):
        self.image.GetPointData().GetScalars().SetName(None)
        self.assert_same(picture(self.image, VALUE))
        self.assert_same(picture(self.image, VALUE, cmap=["r", "g"]))

    def test_arrays(self):
        array = distances().ravel()
        empty = vtkImageData()
        empty.CopyStructure(self.image)
        self.assert_same(picture(empty, VALUE, array))
        self.assert_same(picture(empty, VALUE, numpy.stack([0 * array, array], axis=1), component=1))
        lengths = picture(empty, VALUE, numpy.stack([0.6 * array, 0.8 * array], axis=1).astype("f8"))
        hit = numpy.isfinite(self.expected)
        self.assertLess(numpy.abs(lengths.depth[hit] - self.expected[hit]).max(), 1e-3)
        cells = numpy.zeros(empty.GetNumberOfCells(), bool)
        cells[:len(cells) // 2] = True
        self.assertTrue(numpy.isfinite(picture(empty, VALUE, cells).depth).any())

    def test_preference(self):
        cells = numpy_to_vtk(numpy.zeros(self.image.GetNumberOfCells()), deep=1)
        cells.SetName("scalars")
        self.image.GetCellData().AddArray(cells)
        self.assert_same(picture(self.image, VALUE, "scalars"))
        of_cells = picture(self.image, VALUE, "scalars", preference="cell")
        self.assertFalse(numpy.isfinite(of_cells.depth).any())


class Looks(unittest.TestCase):
    def setUp(self):
        self.image = image_of(distances())

    def color(self, values=VALUE, **look):
        """What is seen in the middle, without light."""
        found = picture(self.image, values, lighting=False, **look)
        return found.color[50, 50].tolist()

    def test_colors(self):
        for color, expected in (
                ("red", [255, 0, 0]), ("k", [0, 0, 0]), ("#102030", [16, 32, 48]),
                ("102030", [16, 32, 48]), ((16, 32, 48), [16, 32, 48]), ([1.0, 0.0, 0.2], [255, 0, 51]),
                (numpy.array([16, 32, 48]), [16, 32, 48]), (numpy.array([1.0, 0.0, 0.2]), [255, 0, 51]),
                (["lime"], [0, 255, 0]), (None, [173, 216, 230])):
            self.assertEqual(self.color(color=color), [*expected, 255], color)

    def test_colors_and_opacities_of_values(self):
        look = {"color": ["red", (0, 0, 255)], "opacity": [1.0, 0.4]}
        self.assertEqual(self.color([0.6, 0.3], **look), [153, 0, 102, 255])
        self.assertEqual(self.color([0.3, 0.6], **look), [255, 0, 0, 255])

    def test_color_maps(self):
        table = vtkLookupTable()
        table.SetNumberOfTableValues(2)
        table.SetTableValue(0, 1.0, 0.0, 0.0)
        table.SetTableValue(1, 0.0, 0.0, 1.0)
        table.SetRange(0.0, 1.0)
        for look in ({"cmap": table}, {"cmap": ["red", "blue"], "clim": (0.0, 1.0)},
                     {"cmap": lambda share: (1.0 - round(share), 0, round(share), 1), "clim": (0, 1)}):
            self.assertEqual(self.color(0.3, **look), [255, 0, 0, 255])
            self.assertEqual(self.color(0.7, **look), [0, 0, 255, 255])

    def test_the_range_of_a_color_map_leaves_out_what_is_no_number(self):
        array = distances()
        array[0, 0, 0] = numpy.nan
        self.image = image_of(array)
        self.assertEqual(self.color(0.9, cmap=["red", "blue"]), [0, 0, 255, 255])

    def test_values_can_be_set(self):
        surface = isosurface(self.image, [0.3, 0.6], color=["red", "blue"])
        self.assertIsInstance(surface, IsosurfaceVolume)
        self.assertEqual(surface.values, (0.3, 0.6))
        surface.values = numpy.array([0.2, 0.7])
        self.assertEqual(surface.values, (0.2, 0.7))
        with self.assertRaisesRegex(ValueError, "2 colours do not fit 3 isovalues"):
            surface.values = [0.1, 0.2, 0.3]
        self.assertEqual(surface.values, (0.2, 0.7))
        one = isosurface(self.image, 0.3)
        one.values = 0.5
        self.assertTrue(numpy.array_equal(
            render(one, renderer_at(4.0), (50, 50)).depth,
            render(isosurface(self.image, 0.5), renderer_at(4.0), (50, 50)).depth))

    def test_solid(self):
        surface = isosurface(self.image, VALUE, solid=True)
        self.assertEqual(surface.GetMapper().GetSurfaceMode(), surface.GetMapper().THRESHOLD)

    def test_ambient_occlusion(self):
        look = {"color": "white", "ambient": 1.0, "diffuse": 0.0}
        near = {"ambient_occlusion": True, "occlusion_radius": 10.0, **look}
        mapper = isosurface(self.image, VALUE, **near).GetMapper()
        self.assertEqual(
            (mapper.GetAmbientOcclusion(), mapper.GetAmbientOcclusionStrength(),
             mapper.GetAmbientOcclusionRadius()), (1, 1.0, 10.0))
        convex = picture(self.image, VALUE, **near).color
        self.assertTrue((convex[convex[..., 3] == 255, 0] > 250).all())  # nothing is in the way
        half = isosurface(self.image, VALUE, ambient_occlusion=0.5).GetMapper()
        self.assertEqual(
            (half.GetAmbientOcclusionStrength(), half.GetAmbientOcclusionRadius()), (0.5, 0.0))
        self.assertEqual(isosurface(self.image, VALUE).GetMapper().GetAmbientOcclusion(), 0)


class ColorsByArray(unittest.TestCase):
    """The height above the middle of a ball gives its colours."""

    def colors(self, grid, *arguments, **look):
        surface = isosurface(
            grid, VALUE, "scalars", color_by="height", lighting=False, clim=(-1.0, 1.0), **look)
        return surface, render(surface, renderer_at(4.0), (100, 100)).color[..., :3].astype(int)

    def setUp(self):
        self.image = image_of(distances())
        axis = numpy.linspace(-1.0, 1.0, distances().shape[0])
        self.height = numpy.broadcast_to(axis[None, :, None], distances().shape).copy()
        array = numpy_to_vtk(self.height.ravel(), deep=1)
        array.SetName("height")
        self.image.GetPointData().AddArray(array)

    def test_table(self):
        red = [(0.0, 0.0, 0.0), (1.0, 0.0, 0.0)]
        surface, colors = self.colors(self.image, cmap=red)
        self.assertEqual(surface.color_table.GetRange(), (-1.0, 1.0))
        rows = [row for row in range(100) if colors[row, 50].any()]
        self.assertTrue(rows and min(rows) > 40, "the upper half alone is red")
        table = vtkLookupTable()
        table.SetTableRange(-1.0, 1.0)
        table.SetNumberOfTableValues(2)
        table.SetTableValue(0, 0.0, 0.0, 1.0, 1.0)
        table.SetTableValue(1, 1.0, 1.0, 0.0, 1.0)
        surface, colors = self.colors(self.image, cmap=table)
        self.assertIs(surface.color_table, table)
        self.assertEqual(colors[52, 50].tolist(), [255, 255, 0])
        self.assertEqual(colors[47, 50].tolist(), [0, 0, 255])

    def test_default_and_vectors(self):
        _, colors = self.colors(self.image)
        self.assertGreater(colors[65, 50, 0], colors[65, 50, 2])  # red above
        self.assertLess(colors[35, 50, 0], colors[35, 50, 2])  # blue below
        vectors = numpy.stack([self.height.ravel(), numpy.zeros(self.height.size)], axis=1)
        surface = isosurface(self.image, VALUE, "scalars", color_by=vectors)
        self.assertEqual(surface.GetMapper().GetColorArrayComponent(), -1)
        self.assertEqual(surface.color_table.GetRange()[0], 0.0)

    def test_arrays(self):
        by_name = picture(self.image, VALUE, "scalars", color_by="height").color
        for height in self.height, self.height.ravel():
            by_array = picture(distances(), VALUE, spacing=self.image.GetSpacing(),
                               origin=self.image.GetOrigin(), color_by=height).color
            numpy.testing.assert_array_equal(by_array, by_name)
        cells = vtkPointDataToCellData()
        cells.SetInputData(self.image)
        cells.PassPointDataOn()
        cells.Update()
        surface = isosurface(cells.GetOutput(), VALUE, "scalars", color_by="height")
        self.assertFalse(surface.GetMapper().GetColorArrayOnCells())

    def test_mistakes(self):
        for sentence, look in (
                ("no array 'depth'", {"color_by": "depth"}),
                ("color or color_by", {"color_by": "height", "color": "r"}),
                ("does not fit the grid", {"color_by": [1.0, 2.0]})):
            with self.subTest(sentence), self.assertRaisesRegex(ValueError, sentence):
                isosurface(self.image, VALUE, "scalars", **look)


class Mistakes(unittest.TestCase):
    def test_sentences(self):
        image = image_of(distances())
        for error, sentence, arguments, look in (
                (TypeError, "not list", ([[[1.0, 2.0]]], 1), {}),
                (TypeError, "not vtkTable", (vtkTable(), 1), {}),
                (TypeError, "of polygons is no volume", (vtkPolyData(), 1), {}),
                (ValueError, "no array of numbers", (vtkImageData(), 1), {}),
                (ValueError, "no array 'x' at the points or cells: choose of scalars", (image, 1, "x"), {}),
                (ValueError, "does not fit the grid", (image, 1, [1.0, 2.0]), {}),
                (TypeError, "give the name of one", (blocks(image), 1, [1.0]), {}),
                (TypeError, "a number or several", (image, "skin"), {}),
                (ValueError, "finite numbers", (image, []), {}),
                (ValueError, "finite numbers", (image, [1.0, float("nan")]), {}),
                (ValueError, "color or cmap", (image, 1), {"color": "r", "cmap": ["r"]}),
                (ValueError, "no colour 'purplish'", (image, 1), {"color": "purplish"}),
                (ValueError, "no colour", (image, 1), {"color": (2.0, 0.0, 0.0)}),
                (ValueError, "2 colours do not fit 1", (image, 1), {"color": ["r", "g"]}),
                (ValueError, "2 opacities do not fit 1", (image, 1), {"opacity": [1.0, 0.5]}),
                (ValueError, "from 0 to 1", (image, 1), {"opacity": 1.5}),
                (ValueError, "from 0 to 1", (image, 1), {"opacity": "linear"}),
                (ValueError, "ambient must not be negative", (image, 1), {"ambient": -0.1}),
                (ValueError, "diffuse must be a finite number", (image, 1), {"diffuse": "much"}),
                (ValueError, "specular_power must be a", (image, 1), {"specular_power": numpy.nan}),
                (ValueError, "two finite numbers", (image, 1), {"cmap": ["r"], "clim": (1, 1)}),
                (ValueError, "ambient_occlusion must be", (image, 1), {"ambient_occlusion": 1.5}),
                (ValueError, "ambient_occlusion must be", (image, 1),
                 {"ambient_occlusion": True, "occlusion_radius": -1.0}),
                (ValueError, "from 0 to 0", (image, 1), {"component": 1}),
                (ValueError, "'point' or 'cell'", (image, 1), {"preference": "face"})):
            with self.subTest(sentence), self.assertRaisesRegex(error, sentence):
                isosurface(*arguments, **look)

    def test_numbers_that_vtk_has_not(self):
        image = image_of(distances())
        with self.assertRaisesRegex(TypeError, "real numbers"):
            isosurface(image, 1, numpy.zeros(image.GetNumberOfPoints(), complex))
        self.assertEqual(numpy_to_image(distances()).GetNumberOfPoints(), image.GetNumberOfPoints())


if __name__ == "__main__":
    unittest.main()
