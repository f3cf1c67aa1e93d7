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

WITHOUT_VALUE = vtkDataSetAttributes.HIDDENCELL | vtkDataSetAttributes.REFINEDCELL
HIDDEN = WITHOUT_VALUE | vtkDataSetAttributes.DUPLICATECELL


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
        if self._are_all:
            return
        count = data.GetNumberOfCells()
        self._have_values = numpy.ones(count, bool)
        if isinstance(data, vtkUnstructuredGrid):
            types = numpy.fromiter((data.GetCellType(cell) for cell in range(count)), numpy.uint8, count)
            drawn = [kind for kind in range(VTK_NUMBER_OF_CELL_TYPES) if has_volume(kind)]
            self._have_values &= numpy.isin(types, drawn)
        self._cells = self._have_values.copy()
        if ghosts[0] is not None:
            self._have_values &= ghosts[0] & WITHOUT_VALUE == 0
            self._cells &= ghosts[0] & HIDDEN == 0
        if ghosts[1] is not None:
            self._cells &= ~_touch(data, ghosts[1] & vtkDataSetAttributes.HIDDENPOINT != 0)
        self._points = _sums(data, self._cells.astype(numpy.uint8)) > 0

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
        """The means of the cells around each drawn point, as the mapper draws cells of meshes."""
        values = _first_component(array)
        are_used = ~numpy.isnan(values)
        if not self._are_all:
            are_used &= self._have_values
        counts = _sums(self._data, are_used.astype(numpy.uint8))
        sums = _sums(self._data, numpy.where(are_used, values, 0))
        are_means = counts > 0 if self._are_all else (counts > 0) & self._points
        return sums[are_means] / counts[are_means]


def _ghosts(attributes: vtkDataSetAttributes) -> numpy.ndarray | None:
    marks = attributes.GetArray(vtkDataSetAttributes.GhostArrayName())
    return vtk_to_numpy(marks) if marks else None


def _first_component(array: vtkDataArray) -> numpy.ndarray:
    values = vtkDoubleArray()
    values.SetNumberOfTuples(array.GetNumberOfTuples())
    values.CopyComponent(0, array, 0)
    return vtk_to_numpy(values)


def _dimensions(data: vtkDataSet) -> list[int]:
    """Of an image or a grid. In VTK 9.6 only this form works for both."""
    dimensions = [0, 0, 0]
    data.GetDimensions(dimensions)
    return dimensions


def _sums(data: vtkDataSet, of_cells: numpy.ndarray) -> numpy.ndarray:
    """Of each point, the sum over the cells around it."""
    if isinstance(data, vtkUnstructuredGrid):
        owners, points = _owners_and_points(data)
        return numpy.bincount(points, of_cells[owners], data.GetNumberOfPoints())
    nx, ny, nz = _dimensions(data)
    sums = numpy.zeros((nz, ny, nx), of_cells.dtype)
    for corner in _corners(nx, ny, nz):
        sums[corner] += of_cells.reshape(nz - 1, ny - 1, nx - 1)
    return sums.ravel()


def _touch(data: vtkDataSet, points: numpy.ndarray) -> numpy.ndarray:
    """Whether each cell has one of the points."""
    if isinstance(data, vtkUnstructuredGrid):
        owners, corners = _owners_and_points(data)
        return numpy.bincount(owners, points[corners], data.GetNumberOfCells()) > 0
    nx, ny, nz = _dimensions(data)
    touch = numpy.zeros(data.GetNumberOfCells(), bool)
    for corner in _corners(nx, ny, nz):
        touch |= points.reshape(nz, ny, nx)[corner].ravel()
    return touch


def _corners(nx: int, ny: int, nz: int) -> list:
    """Where the points are that are the first, ... eighth of each cell; none where cells are flat."""
    return [numpy.s_[k:nz - 1 + k, j:ny - 1 + j, i:nx - 1 + i]
            for k in (0, 1) for j in (0, 1) for i in (0, 1) if min(nx, ny, nz) > 1]


def _owners_and_points(data: vtkUnstructuredGrid) -> tuple[numpy.ndarray, numpy.ndarray]:
    """Of each corner of a cell the cell and the point."""
    offsets, points = vtkIdTypeArray(), vtkIdTypeArray()
    # Some are made by VTK when they are asked for.
    offsets.DeepCopy(data.GetCells().GetOffsetsArray())
    points.DeepCopy(data.GetCells().GetConnectivityArray())
    sizes = numpy.diff(vtk_to_numpy(offsets))
    return numpy.repeat(numpy.arange(len(sizes)), sizes), vtk_to_numpy(points)
