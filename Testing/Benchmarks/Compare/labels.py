#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the labels of a segmentation cost, beside an isosurface of its size and VTK's triangles.

usage: python3 labels.py [--radius R] [--rounds N] [--no-triangles] VOLUME...

VOLUME is a .vti of whole numbers, or LABELSxEDGE: so many balls at random in EDGE^3 samples of 16 bits,
such as 117x256. 1024 x 1024 pixels; the whole volume is seen. Prints medians of N times (default 5), in
ms of the wall clock: an isosurface around all labels and all labels, each cold in views turned by 10 degrees;
every second label, and all again, in a view that stays; one label hidden; strokes of 20^3 samples, whose
place is told by ModifiedWithin or not; and triangles of every second label with their first picture in a
window that is there, by vtkSurfaceNets3D (since VTK 9.3) and vtkDiscreteFlyingEdges3D.
"""

from __future__ import annotations

import argparse
import statistics
import time

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkLookupTable
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOXML import vtkXMLImageDataReader
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow, vtkVolume)
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
import vtkmodules.vtkFiltersGeneral as general
import vtkmodules.vtkFiltersCore as core
from vtkTemporalCoherence import vtkTemporalCoherenceVolumeMapper

SIZE = 1024
STROKE = 20


def balls(count: int, edge: int) -> vtkImageData:
    """Balls of labels from 1 on, which may cut into one another, and 0 around them."""
    random = numpy.random.default_rng(7)
    samples = numpy.zeros((edge, edge, edge), numpy.uint16)
    largest = 0.5 * edge * count ** (-1.0 / 3.0)
    for label in range(1, count + 1):
        radius = random.uniform(0.5, 1.0) * largest
        middle = random.uniform(radius, edge - 1 - radius, 3)
        low = numpy.maximum(numpy.floor(middle - radius), 0).astype(int)
        high = numpy.minimum(numpy.ceil(middle + radius), edge - 1).astype(int) + 1
        along = [numpy.arange(low[axis], high[axis]) - middle[axis] for axis in range(3)]
        squares = (along[2][:, None, None] ** 2 + along[1][None, :, None] ** 2 + along[0][None, None, :] ** 2)
        part = samples[low[2]:high[2], low[1]:high[1], low[0]:high[0]]
        part[squares < radius * radius] = label
    image = vtkImageData()
    image.SetDimensions(edge, edge, edge)
    image.GetPointData().SetScalars(numpy_to_vtk(samples.ravel(), deep=True))
    return image


def read(name: str) -> vtkImageData:
    if name.endswith(".vti"):
        reader = vtkXMLImageDataReader()
        reader.SetFileName(name)
        reader.Update()
        return reader.GetOutput()
    count, edge = name.split("x")
    return balls(int(count), int(edge))


def ms(act) -> float:
    begin = time.perf_counter()
    act()
    return 1000.0 * (time.perf_counter() - begin)


class Labels:
    def __init__(self, image: vtkImageData, radius: float):
        self.image = image
        self.array = image.GetPointData().GetScalars()
        self.samples = vtk_to_numpy(self.array)
        self.labels = numpy.unique(self.samples)
        self.labels = self.labels[self.labels != 0]
        self.mapper = vtkTemporalCoherenceVolumeMapper()
        self.mapper.SetInputData(image)
        self.mapper.SetSurfaceModeToLabels()
        self.mapper.SetLabelRadius(radius)
        self.mapper.SetAntialiasingToOff()
        self.volume = vtkVolume()
        self.volume.SetMapper(self.mapper)
        self.volume.GetProperty().SetShade(1)
        self.renderer = vtkRenderer()
        self.renderer.AddVolume(self.volume)
        self.renderer.ResetCamera()
        self.show(self.labels)
        self.picture = vtkImageData()

    def show(self, labels) -> None:
        table = vtkLookupTable()
        most = int(self.labels.max())
        table.SetNumberOfTableValues(most + 1)
        table.SetTableRange(0, most)
        seen = set(int(label) for label in labels)
        for label in range(most + 1):
            color = [(label * step % 97 + 30) / 127.0 for step in (31, 57, 83)]
            table.SetTableValue(label, *color, 1.0 if label in seen else 0.0)
        self.mapper.SetLabelTable(table)

    def frame(self) -> float:
        return ms(lambda: self.mapper.MakeImage(self.renderer, self.volume, SIZE, SIZE, self.picture, None))

    def turned(self, rounds: int) -> float:
        times = []
        for _ in range(rounds + 1):
            self.renderer.GetActiveCamera().Azimuth(10)
            times.append(self.frame())
        return statistics.median(times[1:])

    def changed_sets(self, rounds: int) -> tuple[float, float, float]:
        some, every, one_less = [], [], []
        for turn in range(rounds):
            self.show(self.labels[::2])
            some.append(self.frame())
            self.show(self.labels)
            every.append(self.frame())
            self.show(numpy.delete(self.labels, turn % len(self.labels)))
            one_less.append(self.frame())
            self.show(self.labels)
            self.frame()
        return statistics.median(some), statistics.median(every), statistics.median(one_less)

    def strokes(self, rounds: int, are_told: bool) -> float:
        """Through the labels, each time with another one."""
        depth, height, width = self.image.GetDimensions()[::-1]
        grid = self.samples.reshape(depth, height, width)
        inside = numpy.argwhere(grid[STROKE:-STROKE:7, STROKE:-STROKE:7, STROKE:-STROKE:7] != 0)
        times = []
        for turn in range(rounds + 2):
            low = STROKE + 7 * inside[(turn * 7919) % len(inside)]
            part = grid[low[0]:low[0] + STROKE, low[1]:low[1] + STROKE, low[2]:low[2] + STROKE]
            part[:] = self.labels[turn % len(self.labels)]
            extent = [int(edge) for axis in (2, 1, 0) for edge in (low[axis], low[axis] + STROKE - 1)]
            begin = time.perf_counter()
            if are_told:
                self.mapper.ModifiedWithin(self.image, extent)
            else:
                self.array.Modified()
            self.frame()
            times.append(1000.0 * (time.perf_counter() - begin))
        return statistics.median(times[2:])  # the first one is not told from other changes


def isosurface(labels: Labels, rounds: int) -> float:
    labels.mapper.SetSurfaceModeToCrossing()
    labels.volume.GetProperty().GetIsoSurfaceValues().SetValue(0, 0.5)
    time = labels.turned(rounds)
    labels.mapper.SetSurfaceModeToLabels()
    return time


def ready_window() -> vtkRenderWindow:
    """A window that has drawn triangles. A server without -noreset ends when its last window is closed."""
    sphere = vtkSphereSource()
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(sphere.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    renderer = vtkRenderer()
    renderer.AddActor(actor)
    window = vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetSize(SIZE, SIZE)
    window.AddRenderer(renderer)
    window.Render()
    window.RemoveRenderer(renderer)
    return window


def triangles(window: vtkRenderWindow, filter, image: vtkImageData, labels) -> float:
    """Of a set of labels, and their first picture."""
    filter.SetInputData(image)
    for place, label in enumerate(labels):
        filter.SetValue(place, int(label))
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(filter.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    renderer = vtkRenderer()
    renderer.AddActor(actor)
    window.AddRenderer(renderer)

    def draw():
        filter.Update()
        renderer.ResetCamera(image.GetBounds())
        window.Render()
    taken = ms(draw)
    window.RemoveRenderer(renderer)
    return taken


def main() -> None:
    parser = argparse.ArgumentParser(usage=__doc__.split("usage: ")[1].split("\n")[0])
    parser.add_argument("--radius", type=float, default=0.0)
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--no-triangles", action="store_true")
    parser.add_argument("volumes", nargs="+")
    asked = parser.parse_args()
    window = None if asked.no_triangles else ready_window()
    print("| volume | labels | first | isosurface | all labels | half of them | all again | one less | stroke | told | SurfaceNets | FlyingEdges |")
    print("|---" * 12 + "|")
    for name in asked.volumes:
        labels = Labels(read(name), asked.radius)
        first = labels.frame()
        around = isosurface(labels, asked.rounds)
        labels.frame()
        turned = labels.turned(asked.rounds)
        some, every, one_less = labels.changed_sets(asked.rounds)
        half = labels.labels[::2]
        peers = []
        for module, kind in ((core, "vtkSurfaceNets3D"), (general, "vtkDiscreteFlyingEdges3D")):
            made = getattr(module, kind, None)
            peers.append("-" if not window or not made else f"{triangles(window, made(), labels.image, half):.0f}")
        stroke, told = (labels.strokes(asked.rounds, are_told) for are_told in (False, True))
        size = " x ".join(str(edge) for edge in labels.image.GetDimensions())
        print(f"| {name.split('/')[-1]}, {size} | {len(labels.labels)} | {first:.0f} | {around:.0f} | {turned:.0f} | "
              f"{some:.0f} | {every:.0f} | {one_less:.0f} | {stroke:.0f} | {told:.0f} | {peers[0]} | {peers[1]} |", flush=True)


if __name__ == "__main__":
    main()
