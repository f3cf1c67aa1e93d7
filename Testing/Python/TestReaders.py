# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""Meshes as VTK's readers hand them over are drawn as plain copies of them are, byte for byte."""

import pathlib
import tempfile
import unittest

import numpy
from spheres import distances, renderer_at
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkIdList, vtkPoints
from vtkmodules.vtkCommonDataModel import (
    VTK_HEXAHEDRON, VTK_TETRA, vtkCellArray, vtkMultiBlockDataSet, vtkUnstructuredGrid)
from vtkmodules.vtkFiltersCore import vtkAppendFilter
from vtkmodules.vtkFiltersGeneral import vtkDataSetTriangleFilter
from vtkTemporalCoherence import isosurface, numpy_to_image, render

try:
    from vtkmodules.vtkIOExodus import vtkExodusIIWriter
    from vtkmodules.vtkIOIOSS import vtkIOSSReader
except ImportError:
    vtkIOSSReader = None

SIZE = (120, 100)
VALUE = 0.5
STEP = 2.0 / 16  # between samples


def mesh(cell_type):
    """A sphere, the radius 1 - v for the isovalue v, in cells of one type."""
    if cell_type == VTK_TETRA:
        cells = vtkDataSetTriangleFilter()
    else:
        cells = vtkAppendFilter()
    image = numpy_to_image(distances()[::4, ::4, ::4], (STEP,) * 3, (-1.0,) * 3)
    image.GetPointData().GetScalars().SetName("distance")
    cells.SetInputDataObject(image)
    cells.Update()
    return cells.GetOutput()


def plain(grid):
    """A copy whose arrays hold their numbers one behind the other."""
    copy = vtkUnstructuredGrid()
    points = vtkPoints()
    points.SetData(numpy_to_vtk(
        numpy.array([grid.GetPoint(i) for i in range(grid.GetNumberOfPoints())]), deep=1))
    copy.SetPoints(points)
    cells, ids = vtkCellArray(), vtkIdList()
    for cell in range(grid.GetNumberOfCells()):
        grid.GetCellPoints(cell, ids)
        cells.InsertNextCell(ids)
    copy.SetCells([grid.GetCellType(cell) for cell in range(grid.GetNumberOfCells())], cells)
    for of_copy, of_grid in ((copy.GetPointData(), grid.GetPointData()),
                             (copy.GetCellData(), grid.GetCellData())):
        for i in range(of_grid.GetNumberOfArrays()):
            values = of_grid.GetArray(i)
            tuples = numpy.array([values.GetTuple(j) for j in range(values.GetNumberOfTuples())])
            array = numpy_to_vtk(tuples, deep=1, array_type=values.GetDataType())
            array.SetName(values.GetName())
            of_copy.AddArray(array)
    return copy


def leaves(data):
    iterator = data.NewIterator()
    iterator.InitTraversal()
    while not iterator.IsDoneWithTraversal():
        yield iterator.GetCurrentDataObject()
        iterator.GoToNextItem()


def picture(data):
    return render(isosurface(data, [VALUE], scalars="distance"), renderer_at(4.0), SIZE)


class Readers(unittest.TestCase):
    def assert_same_pictures(self, data, expected):
        one, other = picture(data), picture(expected)
        self.assertGreater((other.isovalue_index >= 0).sum(), 1000)
        for name, a, b in zip(one._fields, one, other):
            self.assertEqual(a.tobytes(), b.tobytes(), name)

    @unittest.skipIf(vtkIOSSReader is None, "this VTK has no reader of Exodus files by IOSS")
    def test_exodus_by_ioss(self):
        with tempfile.TemporaryDirectory() as directory:
            for cell_type in (VTK_TETRA, VTK_HEXAHEDRON):
                path = str(pathlib.Path(directory) / f"{cell_type}.exo")
                writer = vtkExodusIIWriter()
                writer.SetFileName(path)
                writer.SetInputDataObject(mesh(cell_type))
                writer.WriteAllTimeStepsOn()  # or no values are written
                writer.Write()
                reader = vtkIOSSReader()
                reader.SetFileName(path)
                reader.Update()
                data = reader.GetOutputDataObject(0)
                copies = vtkMultiBlockDataSet()
                for i, leaf in enumerate(leaves(data)):
                    copies.SetBlock(i, plain(leaf))
                self.assert_same_pictures(data, copies)

    def test_cells_of_one_type(self):
        for cell_type in (VTK_TETRA, VTK_HEXAHEDRON):
            grid = mesh(cell_type)
            grid.SetCells(cell_type, grid.GetCells())
            self.assert_same_pictures(grid, plain(grid))


if __name__ == "__main__":
    unittest.main()
