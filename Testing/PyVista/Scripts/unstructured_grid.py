# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""A cloud of tetrahedra, and hexahedra that PyVista divides into some."""

import pyvista as pv

image = pv.Wavelet(extent=(-6, 6, -6, 6, -6, 6))
for name, grid in (
        ("tetrahedra", image.to_tetrahedra()),
        ("hexahedra", image.cast_to_unstructured_grid())):
    grid = grid.point_data_to_cell_data().cell_data_to_point_data()
    plotter = pv.Plotter(off_screen=True)
    plotter.add_volume(grid, scalars="RTData", opacity="linear", opacity_unit_distance=2.0)
    plotter.show(screenshot=f"unstructured_{name}.png")
