#!/usr/bin/python3
# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""A dragged isovalue on an irregular grid, drawn without extracting triangles. No display is needed.

Without MESH, points are scattered in a cube and vtkDelaunay3D makes tetrahedra of them. The table
has the route and the milliseconds of each frame, and what vtkContourFilter takes for the triangles.
"""

from __future__ import annotations

import argparse
import os
import statistics
import time

from mistakes import Arguments, UserError, printable, quoted, run
from trial import require_bytes, try_reading
# Before other packages, as it tells what is missing.
from volumes import (
    check_isovalue, choose_scalars, drawn_scalars, errors_of_vtk, number_from, size_of)

import numpy
from scene import Scene
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkDataArray, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkDataSet, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkCellDataToPointData, vtkContourFilter, vtkDelaunay3D
from vtkmodules.vtkIOXML import vtkXMLStructuredGridReader, vtkXMLUnstructuredGridReader
from vtkTemporalCoherence import write_png
from whole import require_whole

READERS = {".vtu": vtkXMLUnstructuredGridReader, ".vts": vtkXMLStructuredGridReader}


def make_mesh(points: int) -> vtkDataSet:
    """Tetrahedra between scattered points, with waves from the middle as scalars."""
    places = numpy.random.default_rng(1).uniform(-1.0, 1.0, (points, 3))
    corners = numpy.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)], float)
    places = numpy.concatenate([corners, places])
    values = numpy.cos(6.0 * numpy.linalg.norm(places, axis=1)) + 0.3 * places[:, 2]
    cloud = vtkPolyData()
    cloud.SetPoints(vtkPoints())
    cloud.GetPoints().SetData(numpy_to_vtk(places, deep=1))
    scalars = numpy_to_vtk(values, deep=1)
    scalars.SetName("waves")
    cloud.GetPointData().SetScalars(scalars)
    delaunay = vtkDelaunay3D()
    delaunay.SetInputData(cloud)
    delaunay.Update()
    return delaunay.GetOutput()


def read_mesh(path: str, array: str | None) -> vtkDataSet:
    """The grid of a file, with the scalars that were asked for, or its first ones."""
    suffix = next((suffix for suffix in READERS if path.lower().endswith(suffix)), None)
    if suffix is None:
        raise UserError(f"The suffix of {quoted(path)} is none of {', '.join(READERS)}: convert it.")
    if not os.path.isfile(path):
        raise UserError(f"{quoted(path)} could not be read: there is no such file.")
    try_reading(path, lambda: _read_untried(path, suffix))
    mesh = _read_untried(path, suffix)
    choose_scalars(mesh, array, quoted(path))
    return mesh


def _read_untried(path: str, suffix: str) -> vtkDataSet:
    """A reader may end the program here."""
    reader = READERS[suffix]()
    reader.SetFileName(path)
    with errors_of_vtk() as errors:
        require_whole(path, reader)
        if reader.CanReadFile(path):
            reader.Update()
    mesh = reader.GetOutput()
    if errors() or mesh.GetNumberOfCells() == 0:
        raise UserError(f"{quoted(path)} could not be read: check that it is a whole file {suffix}.")
    require_bytes(path, 1024 * mesh.GetActualMemorySize())
    return mesh


class Triangles:
    """The same surface by vtkContourFilter, which is given one component: it takes no more."""

    def __init__(self, mesh: vtkDataSet) -> None:
        scalars = drawn_scalars(mesh)
        is_of_points = bool(mesh.GetPointData().GetScalars())
        drawn = vtkDataArray.CreateDataArray(scalars.GetDataType())
        drawn.SetNumberOfTuples(scalars.GetNumberOfTuples())
        drawn.CopyComponent(0, scalars, 0)
        copy = mesh.NewInstance()
        copy.CopyStructure(mesh)
        (copy.GetPointData() if is_of_points else copy.GetCellData()).SetScalars(drawn)
        average = vtkCellDataToPointData()
        average.SetInputData(copy)
        self._contour = vtkContourFilter()
        self._contour.SetInputData(copy)
        if not is_of_points:
            average.Update()
            self._contour.SetInputData(average.GetOutput())

    def extract(self, isovalue: float) -> tuple[float, int]:
        """The milliseconds that it takes, and how many there are."""
        self._contour.SetValue(0, isovalue)
        with errors_of_vtk():  # it tells of each flat cell
            begin = time.perf_counter()
            self._contour.Update()
            taken = 1000.0 * (time.perf_counter() - begin)
        return taken, self._contour.GetOutput().GetNumberOfCells()


def parse() -> argparse.Namespace:
    arguments = Arguments(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument(
        "mesh", nargs="?", help=f"a file {', '.join(READERS)}; default: scattered points")
    arguments.add_argument("--array", help="the array to draw, of points or cells; default: the file's scalars, or its first that varies")
    arguments.add_argument(
        "--points", type=number_from(10), default=20000, help="scattered points; default: 20000")
    arguments.add_argument(
        "--from", dest="first", type=float, metavar="VALUE", help="the first isovalue")
    arguments.add_argument("--to", dest="last", type=float, metavar="VALUE", help="the last one")
    arguments.add_argument("--frames", type=number_from(2), default=20, help="default: 20")
    arguments.add_argument(
        "--size", type=size_of, default=(512, 512), metavar="WxH", help="pixels; default: 512x512")
    arguments.add_argument(
        "--azimuth", type=float, default=30.0, help="degrees around the z axis; default: 30")
    arguments.add_argument(
        "--output", default="mesh_sweep.png", help="the last picture; default: mesh_sweep.png")
    return arguments.parse_args()


def main() -> None:
    given = parse()
    mesh = read_mesh(given.mesh, given.array) if given.mesh else make_mesh(given.points)
    name = quoted(given.mesh) if given.mesh else "The generated mesh"
    scene = Scene(mesh, name)
    triangles = Triangles(mesh)
    low, high = scene.limits
    first = low + 0.4 * (high - low) if given.first is None else given.first
    last = low + 0.6 * (high - low) if given.last is None else given.last
    for isovalue in (first, last):
        check_isovalue(isovalue, scene.limits)

    # What will be looked up is known ahead: the second frame builds the isomap of all isovalues.
    scene.mapper.SetIsomapRange(min(first, last), max(first, last))

    print(f"{name}: {mesh.GetNumberOfCells()} cells, values {low:g} to {high:g}")
    print("frame  isovalue  route              ms  vtkContourFilter ms  triangles")
    milliseconds: dict[str, list[float]] = {}
    for frame, isovalue in enumerate(numpy.linspace(first, last, given.frames)):
        picture = scene.picture(isovalue, given.azimuth, given.size)
        route, taken = scene.how()
        milliseconds.setdefault(route, []).append(taken)
        extracted, count = triangles.extract(isovalue)
        print(f"{frame:5}  {isovalue:8.6g}  {route:14}  {taken:5.1f}  {extracted:19.1f}  {count:9}")
    try:
        write_png(given.output, picture.color)
    except (OSError, ValueError) as error:  # ValueError: it does not end with .png
        reason = getattr(error, "strerror", None) or "it does not end with .png"
        raise UserError(
            f"{quoted(given.output)} cannot be written ({reason}): choose another --output."
        ) from error
    for route, taken in milliseconds.items():
        print(f"{route:14}  {len(taken):4} frames, median {statistics.median(taken):6.1f} ms")
    print(f"saved as {printable(given.output)}")


if __name__ == "__main__":
    run(main)
