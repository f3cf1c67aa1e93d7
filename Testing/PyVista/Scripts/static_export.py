# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""What a notebook shows where nothing can be turned, and a document of vectors."""

import pyvista as pv

plotter = pv.Plotter(off_screen=True, notebook=True, window_size=(400, 300))
volume = plotter.add_volume(pv.Wavelet(), cmap="coolwarm", opacity="linear", shade=True)
volume.prop.interpolation_type = "linear"
plotter.add_axes()
image = plotter.show(jupyter_backend="static", auto_close=False, return_viewer=True)
image.save("static_notebook.png")
plotter.save_graphic("static_export.pdf")
plotter.close()
