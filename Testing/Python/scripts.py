# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""Scripts that know VTK alone and leave a picture: how they end, and what is in the picture."""

from __future__ import annotations

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

SIZE = 300

#: Shows `volume` in a window of SIZE x SIZE and writes that to the file of the last argument.
SHOW_VOLUME = """\
renderer = vtkRenderer()
renderer.AddVolume(volume)
window = vtkRenderWindow()
window.SetOffScreenRendering(1)
window.SetMultiSamples(0)
window.SetSize(300, 300)
window.AddRenderer(renderer)
window.Render()
picture = vtkWindowToImageFilter()
picture.SetInput(window)
writer = vtkPNGWriter()
writer.SetFileName(sys.argv[-1])
writer.SetInputConnection(picture.GetOutputPort())
writer.Write()
"""


def pixels_of(path: str) -> numpy.ndarray:
    """RGB of a picture of SIZE x SIZE, as integers that can be subtracted."""
    reader = vtkPNGReader()
    reader.SetFileName(path)
    reader.Update()
    pixels = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())
    return pixels[:, :3].reshape(SIZE, SIZE, 3).astype(int)
