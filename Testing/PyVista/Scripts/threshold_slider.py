# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""A slider that hides all below its value."""

import numpy as np
import pyvista as pv

plotter = pv.Plotter(off_screen=True)
volume = plotter.add_volume(pv.Wavelet(), cmap="magma", opacity="linear", show_scalar_bar=False)
low, high = volume.mapper.scalar_range


def hide_below(value):
    share = (value - low) / (high - low)
    opacity = np.where(np.linspace(0, 1, 256) < share, 0.0, 80.0)
    volume.mapper.lookup_table.apply_opacity(opacity)
    volume.prop.apply_lookup_table(volume.mapper.lookup_table)


slider = plotter.add_slider_widget(hide_below, (low, high), value=low, title="Threshold")
plotter.show(auto_close=False)
for value in (120.0, 160.0, 200.0):
    slider.GetRepresentation().SetValue(value)
    slider.InvokeEvent("InteractionEvent")
    hide_below(value)
    plotter.render()
    plotter.screenshot(f"threshold_{value:.0f}.png")
plotter.close()
