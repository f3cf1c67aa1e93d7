# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the mapper draws of a data set: cells with volume that are not hidden, and their points. Faces,
lines and points that no cell uses have values, too."""

from __future__ import annotations

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDataArray, vtkDoubleArray, vtkIdTypeArray
from vtkmodules.vtkCommonDataModel import (
    VTK_NUMBER_OF_CELL_TYPES, vtkDataSet, vtkDataSetAttributes, vtkGenericCell, vtkImageData, vtkUnstructuredGrid)

HIDDEN = vtkDataSetAttributes.HIDDENCELL | vtkDataSetAttributes.REFINEDCELL | vtkDataSetAttributes.DUPLICATECELL


def has_volume(kind: int) -> bool:
    """Whether cells of a type have three dimensions."""
    cell = vtkGenericCell.InstantiateCell(kind)
    return cell is not None and cell.GetCellDimension() == 3


class Drawn:
    """The values that are drawn of a data set."""

    def __init__(self, data: vtkDataSet) -> None:
        self._data = data
        ghosts = [_ghosts(data.GetCellData()), _ghosts(data.GetPointData())]
        self._are_all = not isinstance(data, vtkUnstructuredGrid) and not any(
            marks is not None for marks in ghosts)
        self._corners: tuple[numpy.ndarray, numpy.ndarray] | None = None
        if self._are_all:
            return
        count = data.GetNumberOfCells()
        self._cells = numpy.ones(count, bool)
        if isinstance(data, vtkUnstructuredGrid):
            types = numpy.fromiter((data.GetCellType(cell) for cell in range(count)), numpy.uint8, count)
            drawn = [kind for kind in range(VTK_NUMBER_OF_CELL_TYPES) if has_volume(kind)]
            self._cells &= numpy.isin(types, drawn)
        if ghosts[0] is not None:
            self._cells &= ghosts[0] & HIDDEN == 0
        owners, points = self._cells_of_points()
        if ghosts[1] is not None:
            is_hidden = ghosts[1] & vtkDataSetAttributes.HIDDENPOINT != 0
            self._cells &= numpy.bincount(owners, is_hidden[points], count) == 0
        self._points = numpy.zeros(data.GetNumberOfPoints(), bool)
        self._points[points[self._cells[owners]]] = True

    def range(self, array: vtkDataArray, is_on_cells: bool) -> tuple[float, float]:
        """The least and the greatest finite first component; the first is larger if there is none."""
        if is_on_cells and not isinstance(self._data, vtkImageData):
            values = self._averages(array)
        elif self._are_all:
            return array.GetFiniteRange(0)
        else:
            values = _first_component(array)[self._cells if is_on_cells else self._points]
        values = values[numpy.isfinite(values)]
        return (float(values.min()), float(values.max())) if len(values) else (numpy.inf, -numpy.inf)

    def _averages(self, array: vtkDataArray) -> numpy.ndarray:
        """The means of the drawn cells around each point, as the mapper draws cells of meshes."""
        owners, points = self._cells_of_points()
        if not self._are_all:
            is_drawn = self._cells[owners]
            owners, points = owners[is_drawn], points[is_drawn]
        counts = numpy.bincount(points)
        sums = numpy.bincount(points, _first_component(array)[owners])
        return sums[counts > 0] / counts[counts > 0]

    def _cells_of_points(self) -> tuple[numpy.ndarray, numpy.ndarray]:
        """Of each corner of a cell the cell and the point."""
        if self._corners is None:
            self._corners = _corners(self._data)
        return self._corners


def _ghosts(attributes: vtkDataSetAttributes) -> numpy.ndarray | None:
    marks = attributes.GetArray(vtkDataSetAttributes.GhostArrayName())
    return vtk_to_numpy(marks) if marks else None


def _first_component(array: vtkDataArray) -> numpy.ndarray:
    values = vtkDoubleArray()
    values.SetNumberOfTuples(array.GetNumberOfTuples())
    values.CopyComponent(0, array, 0)
    return vtk_to_numpy(values)


def _corners(data: vtkDataSet) -> tuple[numpy.ndarray, numpy.ndarray]:
    if isinstance(data, vtkUnstructuredGrid):
        offsets, points = vtkIdTypeArray(), vtkIdTypeArray()
        # Some are made by VTK when they are asked for.
        offsets.DeepCopy(data.GetCells().GetOffsetsArray())
        points.DeepCopy(data.GetCells().GetConnectivityArray())
        sizes = numpy.diff(vtk_to_numpy(offsets))
        return numpy.repeat(numpy.arange(len(sizes)), sizes), vtk_to_numpy(points)
    nx, ny, nz = data.GetDimensions()
    ids = numpy.arange(nx * ny * nz).reshape(nz, ny, nx)
    points = numpy.stack([
        ids[k:nz - 1 + k, j:ny - 1 + j, i:nx - 1 + i].ravel() for k in (0, 1) for j in (0, 1) for i in (0, 1)])
    return numpy.tile(numpy.arange(points.shape[1]), 8), points.ravel()
