# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""Mistakes; run.sh compares what is said with what it expects. A line before each tells its name."""

import os

from Stage import (ColorBy, Hide, ProgrammableSource, Render, Show, Tetrahedralize,
                   look_from, make_labels, make_view, make_wavelet, show, statistic, take_picture)

NO_ARRAYS = """
self.GetOutputDataObject(0).SetDimensions(5, 5, 5)
"""
NO_ARRAYS_INFORMATION = """
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline
self.GetOutputInformation(0).Set(
    vtkStreamingDemandDrivenPipeline.WHOLE_EXTENT(), 0, 4, 0, 4, 0, 4)
"""
APART = """
from vtkmodules.vtkImagingCore import vtkRTAnalyticSource
output = self.GetOutputDataObject(0)
output.SetNumberOfBlocks(2)
for block in range(2):
    source = vtkRTAnalyticSource()
    source.SetWholeExtent(-5, 5, -5, 5, -5, 5)
    source.Update()
    image = source.GetOutput()
    image.SetOrigin(11.5 * block, 0.0, 0.0)
    output.SetBlock(block, image)
"""


def say(line):
    """Write where ParaView writes its messages, so that the order stays."""
    os.write(2, (line + "\n").encode())


def begin(name):
    """Name what follows."""
    say(f"case: {name}")


def turn(view):
    """Render twice, as a mistake is to be reported once."""
    for azimuth in (1.0, 1.0):
        view.GetActiveCamera().Azimuth(azimuth)
        Render(view)


def wrong_labels(view, display):
    """What cannot be labels, and labels that processes cannot draw together."""
    begin("fractions")
    display.SurfaceMode, display.Opacity = "Labels", 1.0
    turn(view)
    Hide(display.Input, view)

    begin("labels of a mesh")
    parts = make_labels(make_wavelet())
    mesh = show(Tetrahedralize(Input=parts), view, [], ("POINTS", "Parts"))
    mesh.SurfaceMode = "Labels"
    turn(view)
    Hide(mesh.Input, view)

    begin("translucent labels")
    labels = show(parts, view, [], ("POINTS", "Parts"))
    labels.SurfaceMode, labels.LabelOpacities = "Labels", [3.0, 0.5]
    turn(view)
    say(f"labels seen: {bool(take_picture(view, 'labels-seen').max() > 0)}")
    Hide(parts, view)


def wrong_second_array(view, display):
    """An array for surfaces or for colours that is not there."""
    begin("no colours")
    display.SurfaceMode, display.Visibility = "Crossing", 1
    display.SurfaceArrayName = ["POINTS", "RTData"]
    ColorBy(display, ("POINTS", "Nonsense"))
    turn(view)

    begin("no surfaces")
    display.SurfaceArrayName = ["POINTS", "Nonsense"]
    ColorBy(display, ("POINTS", "RTData"))
    turn(view)
    display.SurfaceArrayName = ["POINTS", "None"]


def main():
    """Each mistake twice, as it is to be reported once."""
    view = make_view()
    display = show(make_wavelet(), view, [150.0])
    look_from(view)
    Render(view)

    begin("isovalue")
    display.Isovalues = [1500.0]
    for azimuth in (1.0, 1.0):
        view.GetActiveCamera().Azimuth(azimuth)
        Render(view)

    begin("no number")
    display.Isovalues = [float("nan"), 150.0, float("inf")]
    for azimuth in (1.0, 1.0):
        view.GetActiveCamera().Azimuth(azimuth)
        Render(view)
    say(f"shown: {statistic(display, 'ShownIsovalues')}")

    begin("flat")
    display.Isovalues, display.Scale = [150.0], [1.0, 0.0, 1.0]
    before = list(statistic(display, "RouteCounts"))
    for azimuth in (1.0, 1.0):
        view.GetActiveCamera().Azimuth(azimuth)
        Render(view)
    say(f"counted: {list(statistic(display, 'RouteCounts')) != before}")
    display.Scale = [1.0, 1.0, 1.0]

    begin("array")
    display.Isovalues = [150.0]
    ColorBy(display, ("POINTS", "Nonsense"))
    for azimuth in (1.0, 1.0):
        view.GetActiveCamera().Azimuth(azimuth)
        Render(view)

    begin("translucent solid")
    ColorBy(display, ("POINTS", "RTData"))
    display.SurfaceMode, display.Opacity = "Threshold", 0.5
    Render(view)
    Render(view)

    wrong_labels(view, display)
    wrong_second_array(view, display)

    begin("well again")
    display.SurfaceMode, display.Opacity = "Crossing", 1.0
    say(f"seen: {bool(take_picture(view, 'well-again').max() > 0)}")
    Hide(display.Input, view)

    begin("no array")
    empty = ProgrammableSource()
    empty.OutputDataSetType = "vtkImageData"
    empty.ScriptRequestInformation = NO_ARRAYS_INFORMATION
    empty.Script = NO_ARRAYS
    empty_display = Show(empty, view)
    empty_display.Representation = "Temporal Isosurface"
    Render(view)
    Render(view)
    Hide(empty, view)

    begin("blocks apart")
    apart = ProgrammableSource()
    apart.OutputDataSetType = "vtkMultiblockDataSet"
    apart.Script = APART
    apart_display = Show(apart, view)
    apart_display.Representation = "Temporal Isosurface"
    view.ResetCamera()
    Render(view)
    Render(view)
    begin("end")


main()
