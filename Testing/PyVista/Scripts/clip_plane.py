# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""A volume that a widget's plane cuts open, and then another plane."""

import pyvista as pv

plotter = pv.Plotter(off_screen=True)
volume = plotter.add_volume(pv.Wavelet(), cmap="plasma", opacity="sigmoid", show_scalar_bar=False)
volume.prop.interpolation_type = "linear"
plane = plotter.add_volume_clip_plane(volume, normal="-x", interaction_event="always")
plotter.show(auto_close=False)
plotter.screenshot("clip_plane.png")
plane.SetNormal(0.0, -1.0, 0.5)
plane.InvokeEvent("InteractionEvent")
plotter.render()
plotter.screenshot("clip_plane_turned.png")
plotter.close()
