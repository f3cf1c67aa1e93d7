# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""The pictures of the documentation: run with mpirun -np 4 pvbatch --sym, for the parts' colours.

paraview-parts.png: what each of the processes draws has a colour of its own. paraview-surfaces.png: one
surface seen through another, with ParaView's Outline. Of engine.vti where it is, else of the wavelet.
"""

import os

from vtkmodules.vtkParallelCore import vtkMultiProcessController

from Stage import (ColorBy, GetColorTransferFunction, GetOpacityTransferFunction, Outline,
                   Render, SaveScreenshot, Show, XMLImageDataReader, look_from, make_view,
                   make_wavelet, show)

COLORS = [(0.85, 0.55, 0.2), (0.3, 0.6, 0.85), (0.5, 0.75, 0.35), (0.75, 0.45, 0.7)]


def save(view, name):
    """Into the directory of the documentation."""
    Render(view)
    SaveScreenshot(os.path.join(os.environ["TEMPORAL_ISOSURFACE_DOCUMENTATION"], name), view,
                   ImageResolution=list(view.ViewSize))


def main():
    """Both pictures."""
    rank = vtkMultiProcessController.GetGlobalController().GetLocalProcessId()
    real = os.path.join(os.environ.get("TEMPORAL_COHERENCE_DATA", ""), "engine.vti")
    is_real = os.path.exists(real)
    source = XMLImageDataReader(FileName=[real]) if is_real else make_wavelet(32)
    outer, inner = (80.0, 180.0) if is_real else (120.0, 200.0)
    view = make_view((640, 480))
    view.Background = [1.0, 1.0, 1.0]
    view.UseFXAA = 1
    display = show(source, view, [outer])
    display.DiffuseColor = COLORS[rank % len(COLORS)]
    display.Specular = 0.2
    look_from(view, 210.0, 25.0, 1.3)
    save(view, "paraview-parts.png")

    array = "RTData" if not is_real else source.PointData.GetArray(0).GetName()
    ColorBy(display, ("POINTS", array))
    GetColorTransferFunction(array).RGBPoints = [outer, 0.75, 0.8, 0.85, inner, 0.9, 0.45, 0.15]
    GetOpacityTransferFunction(array).Points = [outer, 0.3, 0.5, 0.0, inner, 1.0, 0.5, 0.0]
    display.Isovalues = [outer, inner]
    display.UseOpacityFunction = 1
    view.UseFXAA = 0
    outline = Outline(Input=source)
    outline_display = Show(outline, view)
    outline_display.DiffuseColor = outline_display.AmbientColor = [0.2, 0.2, 0.2]
    save(view, "paraview-surfaces.png")


main()
