# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""Blocks in colours of their own."""

import pyvista as pv

whole = pv.Wavelet()
halves = pv.MultiBlock()
halves["left"] = whole.extract_subset((-10, 0, -10, 10, -10, 10))
halves["right"] = whole.extract_subset((0, 10, -10, 10, -10, 10))
plotter = pv.Plotter(off_screen=True)
plotter.add_volume(halves, multi_colors=True, opacity=[0.0, 0.1, 0.6], show_scalar_bar=False)
plotter.show(screenshot="multi_block.png")
