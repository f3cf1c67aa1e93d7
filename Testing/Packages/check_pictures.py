# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""usage: check_pictures.py COUNT FILES...   Fails unless there are COUNT PNGs, each of many colours."""

import sys

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

FEWEST_COLORS = 20

count, *paths = sys.argv[1:]
if len(paths) != int(count):
    sys.exit(f"There are {len(paths)} pictures instead of {count}: {paths}")
for path in paths:
    reader = vtkPNGReader()
    reader.SetFileName(path)
    reader.Update()
    pixels = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())
    colors = numpy.unique(pixels, axis=0)
    if len(colors) < FEWEST_COLORS:
        sys.exit(f"{path} has {len(colors)} colours: it shows nothing.")
