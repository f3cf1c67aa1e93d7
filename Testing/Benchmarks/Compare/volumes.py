# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""Volumes by name: those of Testing/Common/Volumes, made by the same formulas, and files."""

from __future__ import annotations

import os
import pathlib
import re

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkRectilinearGrid
from vtkmodules.vtkIOXML import vtkXMLImageDataReader
from vtkTemporalCoherence import numpy_to_image


def _from_formula(size: int, formula) -> vtkImageData:
    """size^3 samples of a formula on [-1, 1]^3, as bytes with spacing 1."""
    axis = -1.0 + 2.0 / (size - 1) * numpy.arange(size)
    samples = numpy.empty((size, size, size), numpy.uint8)
    for slab, z in zip(samples, axis):
        slab[:] = formula(axis, axis[:, None], z)
    return numpy_to_image(samples)


def _four_spheres(x, y, z):
    centres = ((-0.4, -0.4, -0.2), (0.45, -0.3, 0.3), (-0.3, 0.45, 0.35), (0.35, 0.4, -0.4))
    values = (1.0 - numpy.sqrt((x - a) ** 2 + (y - b) ** 2 + (z - c) ** 2) / 0.6
              for a, b, c in centres)
    return 255.0 * numpy.maximum.reduce([0.0 * (x + y), *values])


def _marschner_lobb(x, y, z):
    rho = numpy.cos(12.0 * numpy.pi * numpy.cos(0.5 * numpy.pi * numpy.hypot(x, y)))
    return 255.0 * ((1.0 - numpy.sin(0.5 * numpy.pi * z)) + 0.25 * (1.0 + rho)) / 2.5


_FORMULAS = {"spheres": _four_spheres, "marschner-lobb": _marschner_lobb}


def load(name: str) -> vtkImageData | None:
    """The volume of that name; None if it is a file that is not there."""
    made = re.fullmatch(f"({'|'.join(_FORMULAS)})([0-9]+)", name)
    if made:
        return _from_formula(int(made[2]), _FORMULAS[made[1]])
    path = pathlib.Path(os.environ.get("TEMPORAL_COHERENCE_DATA", ""), name)
    if not path.is_file():
        return None
    reader = vtkXMLImageDataReader()
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


def with_type(image: vtkImageData, sample_type: str) -> vtkImageData:
    """The same samples as another type of NumPy."""
    nx, ny, nz = image.GetDimensions()
    samples = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(nz, ny, nx)
    return numpy_to_image(samples.astype(sample_type), image.GetSpacing(), image.GetOrigin())


def on_grid(image: vtkImageData) -> vtkRectilinearGrid:
    """The same samples on a grid whose steps swell and shrink by 6 %."""
    grid = vtkRectilinearGrid()
    grid.SetDimensions(image.GetDimensions())
    setters = (grid.SetXCoordinates, grid.SetYCoordinates, grid.SetZCoordinates)
    for set_coordinates, count, spacing in zip(setters, image.GetDimensions(), image.GetSpacing()):
        number = numpy.arange(count, dtype=float)
        set_coordinates(numpy_to_vtk(spacing * (number + 0.3 * numpy.sin(0.2 * number)), deep=True))
    grid.GetPointData().SetScalars(image.GetPointData().GetScalars())
    return grid
