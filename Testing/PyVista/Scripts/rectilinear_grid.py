# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""A rectilinear grid whose cells are finer in the middle, without and with shading."""

import numpy as np
import pyvista as pv

axis = np.linspace(-1, 1, 41) ** 3
grid = pv.RectilinearGrid(axis, axis, axis)
grid["distance"] = np.linalg.norm(grid.points, axis=1)
for shade in (False, True):
    plotter = pv.Plotter(off_screen=True)
    volume = plotter.add_volume(
        grid, cmap="viridis", opacity=[0.9, 0.3, 0.05, 0.0, 0.0], shade=shade, ambient=0.2)
    volume.prop.interpolation_type = "linear"
    plotter.show(screenshot="rectilinear_shaded.png" if shade else "rectilinear_grid.png")
