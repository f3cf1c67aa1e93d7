# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""show() opens a window with the volume in it, and leaves it usable."""

import unittest

import numpy
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  makes windows
from spheres import STEP, distances
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkRenderingCore import vtkRenderWindowInteractor, vtkWindowToImageFilter
from vtkTemporalCoherence import isosurface, pictures


class ClosedAtOnce(vtkRenderWindowInteractor):
    """An interactor that takes a picture of its window instead of waiting for the user."""

    colors = None

    def Start(self):  # noqa: N802  VTK's name
        taken = vtkWindowToImageFilter()
        taken.SetInput(self.GetRenderWindow())
        taken.ReadFrontBufferOff()
        taken.Update()
        image = taken.GetOutput()
        width, height, _ = image.GetDimensions()
        scalars = vtk_to_numpy(image.GetPointData().GetScalars())
        ClosedAtOnce.colors = scalars.reshape(height, width, -1)[..., :3].copy()


class Show(unittest.TestCase):
    def test_window(self):
        volume = isosurface(distances(), 0.5, color="red", spacing=(STEP,) * 3)
        before = volume.picture((64, 64)).planes.color
        old, pictures.vtkRenderWindowInteractor = pictures.vtkRenderWindowInteractor, ClosedAtOnce
        try:
            volume.show((200, 200))
        finally:
            pictures.vtkRenderWindowInteractor = old
        colors = ClosedAtOnce.colors.astype(int)
        self.assertTrue((colors[5, 5] == 255).all(), "the background")
        red, green, blue = colors[100, 100]
        self.assertTrue(red > 100 and green < 50 and blue < 50, (red, green, blue))
        self.assertTrue(numpy.array_equal(volume.picture((64, 64)).planes.color, before))


if __name__ == "__main__":
    unittest.main()
