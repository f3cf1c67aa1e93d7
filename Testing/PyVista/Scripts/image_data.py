# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""A volume of an image, as the first lines of PyVista's documentation draw it."""

import pyvista as pv

grid = pv.Wavelet()
plotter = pv.Plotter(off_screen=True)
plotter.add_volume(grid, cmap="coolwarm", opacity="sigmoid")
plotter.show(screenshot="image_data.png")
