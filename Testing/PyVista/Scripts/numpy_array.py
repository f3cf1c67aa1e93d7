# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""The brightest value along each ray through a NumPy array whose voxels are no cubes."""

import numpy as np
import pyvista as pv

x, y, z = np.mgrid[-1:1:40j, -1:1:50j, -1:1:20j]
array = np.exp(-4 * (x ** 2 + y ** 2 + z ** 2)) * (2 + np.sin(9 * x) * np.cos(8 * y))
plotter = pv.Plotter(off_screen=True)
plotter.add_volume(array, resolution=[1.0, 1.0, 2.0], cmap="bone", blending="maximum")
plotter.camera_position = "xz"
plotter.show(screenshot="numpy_array.png")
