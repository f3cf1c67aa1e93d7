# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""A film of a camera that goes round."""

import pyvista as pv

plotter = pv.Plotter(off_screen=True, window_size=(320, 240))
plotter.add_volume(pv.Wavelet(), cmap="gray", opacity="sigmoid", show_scalar_bar=False)
plotter.show(auto_close=False)
path = plotter.generate_orbital_path(n_points=8, shift=10.0, factor=2.0)
plotter.open_gif("orbit_film.gif")
plotter.orbit_on_path(path, write_frames=True)
plotter.close()
