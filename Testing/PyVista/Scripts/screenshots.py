# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""Four windows in one, with polygons inside of volumes, before nothing."""

import numpy as np
import pyvista as pv

grid = pv.Wavelet()
plotter = pv.Plotter(off_screen=True, shape=(2, 2), window_size=(600, 600))
for index, blending in enumerate(("composite", "average", "minimum", "additive")):
    plotter.subplot(index // 2, index % 2)
    opacity = {"additive": [0.0, 0.03], "composite": [0.0, 0.3]}.get(blending, "linear")
    plotter.add_volume(grid, cmap="hot", opacity=opacity, blending=blending, show_scalar_bar=False)
    plotter.add_mesh(pv.Sphere(radius=4.0, center=(6.0, 0.0, 0.0)), color="tan")
    plotter.add_mesh(grid.outline(), color="black")
    plotter.enable_parallel_projection()
plotter.show(auto_close=False)
pixels = plotter.screenshot("screenshots.png", transparent_background=True, return_img=True)
assert isinstance(pixels, np.ndarray) and pixels.shape == (600, 600, 4)
plotter.close()
