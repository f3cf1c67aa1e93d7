#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""How wrong the normals of smooth labels are, beside those of vtkSurfaceNets3D (since VTK 9.3).

usage: labelNormals.py [--radii R...] [--iterations N...] [--shapes N] [--edge N]

Shapes whose normals are known, with middles and directions at random, become labels of EDGE^3 samples
(default 64). The same rays meet our surface and the triangles of the same samples. Prints a table in
Markdown: for each shape the median error in degrees, and behind a comma what 95 of 100 errors are less
than. Ours: for each LabelRadius. SurfaceNets: with its own smoothing, 16 iterations, or with as many as
--iterations says. *Facets* are the normals of its triangles, which are seen where nothing follows it;
*smooth* are those of vtkPolyDataNormals without splitting, interpolated in a triangle. All face the
viewer, as with light on both sides.
"""

from __future__ import annotations

import argparse
import math
import sys
from collections.abc import Callable, Iterator

import numpy
import vtkmodules.vtkFiltersCore as core
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import mutable, vtkLogger, vtkLookupTable
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData, vtkStaticCellLocator
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkVolume
from vtkTemporalCoherence import vtkTemporalCoherenceVolumeMapper

PIXELS = 48
VIEWS = 3
RADII = (1.0, 1.5, 2.0, 2.5, 4.0)
ITERATIONS = (16, 50)

#: For points, as rows: how far each is out of the shape, and its normal there.
Shape = Callable[[numpy.ndarray], tuple[numpy.ndarray, numpy.ndarray]]


def unit(vectors: numpy.ndarray) -> numpy.ndarray:
    return vectors / numpy.maximum(numpy.linalg.norm(vectors, axis=-1, keepdims=True), 1e-30)


def ball(middle: numpy.ndarray, radius: float) -> Shape:
    return lambda points: (numpy.linalg.norm(points - middle, axis=1) - radius, unit(points - middle))


def rod(middle: numpy.ndarray, axis: numpy.ndarray, radius: float) -> Shape:
    def at(points):
        across = points - middle - numpy.outer((points - middle) @ axis, axis)
        return numpy.linalg.norm(across, axis=1) - radius, unit(across)
    return at


def plane(middle: numpy.ndarray, axis: numpy.ndarray) -> Shape:
    return lambda points: ((points - middle) @ axis, numpy.broadcast_to(axis, points.shape))


def ring(middle: numpy.ndarray, axis: numpy.ndarray, radius: float, tube: float) -> Shape:
    def at(points):
        across = points - middle - numpy.outer((points - middle) @ axis, axis)
        return ball(numpy.zeros(3), tube)(points - middle - radius * unit(across))
    return at


def shapes(count: int, edge: int) -> Iterator[tuple[str, list[Shape]]]:
    """Kinds of shapes, each with its name."""
    random = numpy.random.default_rng(5)

    def middle() -> numpy.ndarray:
        return 0.5 * (edge - 1) + random.uniform(-0.5, 0.5, 3)

    def any_axis() -> numpy.ndarray:
        return unit(random.normal(size=3))

    def near_axis(degrees: float) -> numpy.ndarray:
        """So far from an axis of the samples, to any side."""
        tangent, turn = math.tan(math.radians(degrees)), random.uniform(0.0, 2.0 * math.pi)
        axis = unit(numpy.array([1.0, tangent * math.cos(turn), tangent * math.sin(turn)]))
        return numpy.roll(axis, random.integers(3))

    for radius in (4.0, 6.0, 9.0, 14.0):
        yield f"balls, radius {radius:g}", [ball(middle(), radius) for _ in range(count)]
    for radius in (4.0, 9.0, 14.0):
        yield f"rods, radius {radius:g}", [rod(middle(), any_axis(), radius) for _ in range(count)]
    for degrees in (0.0, 3.0):
        yield (f"rods, radius 9, {degrees:g} degrees from an axis",
               [rod(middle(), near_axis(degrees), 9.0) for _ in range(count)])
    yield "planes", [plane(middle(), any_axis()) for _ in range(count)]
    for degrees in (1.0, 3.0, 10.0):
        yield (f"planes, {degrees:g} degrees from an axis",
               [plane(middle(), near_axis(degrees)) for _ in range(count)])
    for tube in (4.0, 6.0):
        yield (f"rings, radius 9, tube {tube:g}",
               [ring(middle(), any_axis(), 9.0, tube) for _ in range(count)])


def label_map(shape: Shape, edge: int) -> vtkImageData:
    along = numpy.arange(edge, dtype=float)
    z, y, x = numpy.meshgrid(along, along, along, indexing="ij")
    out, _ = shape(numpy.stack([x.ravel(), y.ravel(), z.ravel()], axis=1))
    image = vtkImageData()
    image.SetDimensions(edge, edge, edge)
    image.GetPointData().SetScalars(numpy_to_vtk((out < 0.0).astype(numpy.uint8), deep=True))
    return image


class Ours:
    def __init__(self, image: vtkImageData):
        self.mapper = vtkTemporalCoherenceVolumeMapper()
        self.mapper.SetInputData(image)
        self.mapper.SetSurfaceModeToLabels()
        self.mapper.SetAntialiasingToOff()
        table = vtkLookupTable()
        table.SetNumberOfTableValues(2)
        table.SetTableRange(0, 1)
        for label in range(2):
            table.SetTableValue(label, 1.0, 1.0, 1.0, float(label))
        self.mapper.SetLabelTable(table)
        self.volume = vtkVolume()
        self.volume.SetMapper(self.mapper)

    def see(self, renderer: vtkRenderer, radius: float) -> tuple[numpy.ndarray, numpy.ndarray]:
        """Points and normals, one for each pixel with a surface."""
        self.mapper.SetLabelRadius(radius)
        seen = vtkPolyData()
        if not self.mapper.MakeImage(renderer, self.volume, PIXELS, PIXELS, vtkImageData()):
            sys.exit("The mapper made no frame.")
        self.mapper.GetVisibleSurface(seen)
        if not seen.GetNumberOfPoints():
            return numpy.zeros((0, 3)), numpy.zeros((0, 3))
        return vtk_to_numpy(seen.GetPoints().GetData()), vtk_to_numpy(seen.GetPointData().GetNormals())


class Nets:
    """Triangles of label 1 and their normals."""

    def __init__(self, image: vtkImageData, iterations: int):
        nets = core.vtkSurfaceNets3D()
        nets.SetInputData(image)
        nets.SetValue(0, 1)
        nets.SetOutputMeshTypeToTriangles()  # as by default
        nets.SetNumberOfIterations(iterations)
        smooth = core.vtkPolyDataNormals()
        smooth.SetInputConnection(nets.GetOutputPort())
        smooth.SplittingOff()
        smooth.Update()
        self.mesh = smooth.GetOutput()
        self.points = vtk_to_numpy(self.mesh.GetPoints().GetData()).astype(float)
        self.corners = vtk_to_numpy(self.mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3)
        self.normals = vtk_to_numpy(self.mesh.GetPointData().GetNormals()).astype(float)
        self.locator = vtkStaticCellLocator()
        self.locator.SetDataSet(self.mesh)
        self.locator.BuildLocator()

    def meet(self, begins: numpy.ndarray, way: numpy.ndarray) -> tuple[numpy.ndarray, numpy.ndarray]:
        """The triangle that each ray meets first, -1 where it meets none, and where."""
        cells, places = numpy.full(len(begins), -1), numpy.zeros((len(begins), 3))
        t, place, inside, part, cell = mutable(0.0), [0.0] * 3, [0.0] * 3, mutable(0), mutable(0)
        for ray, begin in enumerate(begins):
            if self.locator.IntersectWithLine(begin, begin + way, 1e-9, t, place, inside, part, cell):
                cells[ray], places[ray] = int(cell), place
        return cells, places

    def normals_at(self, cells: numpy.ndarray, places: numpy.ndarray) -> tuple[numpy.ndarray, numpy.ndarray]:
        """Of facets, and smooth ones."""
        corners = self.corners[cells]
        a, b, c = (self.points[corners[:, corner]] for corner in range(3))
        facets = numpy.cross(b - a, c - a)
        area = numpy.einsum("ij,ij->i", facets, facets)
        shares = [numpy.einsum("ij,ij->i", numpy.cross(q - p, places - p), facets) / area
                  for p, q in ((b, c), (c, a), (a, b))]
        smooth = sum(share[:, None] * self.normals[corners[:, corner]] for corner, share in enumerate(shares))
        return unit(facets), unit(smooth)


def look(image: vtkImageData, direction: numpy.ndarray) -> vtkRenderer:
    """Parallel rays along a direction."""
    renderer = vtkRenderer()
    camera = renderer.GetActiveCamera()
    middle = numpy.array(image.GetCenter())
    camera.SetFocalPoint(*middle)
    camera.SetPosition(*(middle - direction))
    camera.SetViewUp(*numpy.roll(direction, 1))
    camera.ParallelProjectionOn()
    renderer.ResetCamera(image.GetBounds())
    camera.SetParallelScale(0.25 * (image.GetDimensions()[0] - 1))
    return renderer


def facing(normals: numpy.ndarray, direction: numpy.ndarray) -> numpy.ndarray:
    return numpy.where((normals @ direction > 0.0)[:, None], -normals, normals)


def errors(normals: numpy.ndarray, truth: numpy.ndarray) -> numpy.ndarray:
    return numpy.degrees(numpy.arccos(numpy.clip(numpy.einsum("ij,ij->i", normals, truth), -1.0, 1.0)))


class Table:
    """Errors in columns, as rays find them."""

    def __init__(self, radii: list[float], iterations: list[int], edge: int):
        self.radii, self.iterations, self.edge = radii, iterations, edge
        self.random = numpy.random.default_rng(11)

    def names(self) -> list[str]:
        nets = [f"SurfaceNets {kind}, {count}" for count in self.iterations for kind in ("facets", "smooth")]
        return [f"ours, {radius:g}" for radius in self.radii] + nets

    def within(self, points: numpy.ndarray) -> numpy.ndarray:
        """Points that are no cuts of the image, and not near one."""
        margin = 0.25 * (self.edge - 1)
        return ((points > margin) & (points < self.edge - 1 - margin)).all(axis=1)

    def measure(self, shape: Shape) -> list[numpy.ndarray]:
        """Errors of one shape, of each column."""
        image = label_map(shape, self.edge)
        ours = Ours(image)
        nets = [Nets(image, count) for count in self.iterations]
        found: list[list[numpy.ndarray]] = [[] for _ in self.names()]
        for _ in range(VIEWS):
            direction = unit(self.random.normal(size=3))
            renderer = look(image, direction)
            seen = [ours.see(renderer, radius) for radius in self.radii]
            for column, (points, normals) in enumerate(seen):
                kept = self.within(points)
                found[column].append(errors(normals[kept], shape(points[kept])[1]))
            points = seen[-1][0]
            rays = points[self.within(points)] - 2.0 * self.edge * direction
            for turn, net in enumerate(nets):
                cells, places = net.meet(rays, 4.0 * self.edge * direction)
                kept = (cells >= 0) & self.within(places)
                truth = shape(places[kept])[1]
                for kind, normals in enumerate(net.normals_at(cells[kept], places[kept])):
                    found[len(self.radii) + 2 * turn + kind].append(
                        errors(facing(normals, direction), truth))
        return [numpy.concatenate(column) for column in found]

    def row(self, name: str, kind: list[Shape]) -> str:
        columns = [numpy.concatenate(column) for column in zip(*(self.measure(shape) for shape in kind))]
        texts = [f"{numpy.median(column):.2f}, {numpy.percentile(column, 95):.1f}" for column in columns]
        return f"| {name} | {len(columns[0])} | " + " | ".join(texts) + " |"


def main() -> None:
    parser = argparse.ArgumentParser(usage=__doc__.split("usage: ")[1].split("\n")[0])
    parser.add_argument("--radii", type=float, nargs="+", default=RADII)
    parser.add_argument("--iterations", type=int, nargs="+", default=ITERATIONS)
    parser.add_argument("--shapes", type=int, default=12)
    parser.add_argument("--edge", type=int, default=64)
    asked = parser.parse_args()
    vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_WARNING)  # VTK 9.3 tells of each step
    iterations = list(asked.iterations)
    if not hasattr(core, "vtkSurfaceNets3D"):
        print("This VTK has no vtkSurfaceNets3D, which VTK has since 9.3: only our normals are measured.\n")
        iterations = []
    table = Table(list(asked.radii), iterations, asked.edge)
    print("| shapes | rays | " + " | ".join(table.names()) + " |")
    print("|---" * (2 + len(table.names())) + "|")
    for name, kind in shapes(asked.shapes, asked.edge):
        print(table.row(name, kind), flush=True)


if __name__ == "__main__":
    main()
