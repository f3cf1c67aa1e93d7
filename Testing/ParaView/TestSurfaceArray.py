# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""Surfaces of one array in the colours of another, and the slider of the first, by brute force in ParaView."""

import numpy as np
from vtkmodules.vtkCommonCore import reference

from BruteForce import Field, rays_of
from Stage import (Calculator, ColorBy, GetColorTransferFunction, GetScalarBar, PointDatatoCellData, Render,
                   Show, check, count_different, look_from, make_view, make_wavelet, samples_of, statistic,
                   take_picture)

SIZE = 160
MOST_WRONG = 0.0005  # of the pixels: the truth may overlook two crossings close together
ISOVALUE = 150.0
LAST = 15


def make_source():
    """An image with the wavelet's values, the third coordinate, and all places."""
    source = Calculator(Input=make_wavelet(LAST), Function="coordsZ", ResultArrayName="Height")
    return Calculator(Input=source, Function="coordsX*iHat+coordsY*jHat+coordsZ*kHat",
                      ResultArrayName="Places")


def show_surface(source, view, array):
    """A surface of the wavelet without shades."""
    display = Show(source, view)
    display.Representation = "Temporal Isosurface"
    display.SurfaceArrayName = ["POINTS", "RTData"]
    display.Isovalues = [ISOVALUE]
    color_by(display, array)
    look_from(view)
    Render(view)  # sets the clipping range
    display.Ambient, display.Diffuse = 1.0, 0.0
    return display


def color_by(display, array):
    """Colours from blue to red and green over the box."""
    ColorBy(display, array)
    table = GetColorTransferFunction(array[1])
    table.ColorSpace, table.Discretize = "RGB", 0
    table.RGBPoints = [-LAST, 0.0, 0.0, 1.0, LAST, 1.0, 0.5, 0.0]
    return table


def check_colors(what, view, is_hit, values):
    """Each pixel of the surface has the colour of a value."""
    picture = take_picture(view, what.replace(":", "").replace(" ", "-"))
    share = np.clip((values + LAST) / (2.0 * LAST), 0.0, 1.0)
    wanted = 255.0 * np.stack([share, 0.5 * share, 1.0 - share], axis=-1) * is_hit[:, None]
    wrong = count_different(picture, wanted.reshape(SIZE, SIZE, 3), 2)
    check(wrong <= MOST_WRONG * SIZE * SIZE and is_hit.mean() > 0.1, what,
          f"{wrong} of {SIZE * SIZE} pixels differ, {int(is_hit.sum())} are hits")


def range_of_slider(display):
    """The range that the panel gives the slider of the isovalue."""
    domain, exists = display.SMProxy.GetProperty("Isovalue").GetDomain("scalar_range"), reference(0)
    return domain.GetMinimum(0, exists), domain.GetMaximum(0, exists)


def test_colors(view, display, field):
    """Colours of points, components, lengths, and cells, at the places where rays meet the surface."""
    origins, directions = rays_of(view.GetActiveCamera(), SIZE, SIZE)
    distances, _ = field.trace(origins, directions, ISOVALUE)
    is_hit = np.isfinite(distances)
    hits = origins + np.where(is_hit, distances, 0.0)[:, None] * directions
    check_colors("second array: of points", view, is_hit, hits[:, 2])
    table = color_by(display, ("POINTS", "Places", "Y"))
    check_colors("second array: a component", view, is_hit, hits[:, 1])
    table.VectorMode = "Magnitude"
    check_colors("second array: the length", view, is_hit, np.linalg.norm(hits, axis=1))
    table.VectorMode, table.VectorComponent = "Component", 0
    display.SurfaceLooks = [1.0, 1.0, 1.0, 0.0]
    check(take_picture(view, "second-array-hidden").max() == 0,
          "second array: opacities belong to surfaces")
    display.SurfaceLooks = []
    check_colors("second array: again", view, is_hit, hits[:, 0])
    Render(view)
    traced = statistic(display, "NumberOfTracedRays")
    table.RGBPoints = [-LAST, 1.0, 1.0, 1.0, LAST, 1.0, 1.0, 1.0]
    Render(view)
    check(statistic(display, "Route") == "Reshade", "second array: new colours trace no rays",
          f"{statistic(display, 'Route')} after {traced} rays")


def test_panel(view, display):
    """The slider follows the array of the surfaces, the colour bar that of the colours."""
    color_by(display, ("POINTS", "Height"))
    lowest, highest = range_of_slider(display)
    check(lowest > 0.0 and highest > 200.0, "second array: the slider has the range of the surface's array",
          f"{lowest} to {highest}")
    display.SurfaceArrayName = ["POINTS", "Places"]
    display.SurfaceArrayComponent = 2
    display.Isovalues = []
    display.Isovalue = 3.0
    Render(view)
    check(np.allclose(range_of_slider(display), (-LAST, LAST)),
          "second array: the slider has the range of the component", range_of_slider(display))
    check(np.isclose(statistic(display, "ShownIsovalues"), 3.0), "second array: a component has surfaces",
          statistic(display, "ShownIsovalues"))
    display.SetScalarBarVisibility(view, True)
    bar = GetScalarBar(GetColorTransferFunction("Height"), view)
    check(bar.Visibility == 1 and bar.Title == "Height", "second array: the colour bar shows it", bar.Title)
    display.SetScalarBarVisibility(view, False)
    display.SurfaceArrayName = ["POINTS", "None"]
    check(np.allclose(range_of_slider(display), (-LAST, LAST)), "second array: without one, the slider "
          "has the range of Coloring", range_of_slider(display))
    Render(view)
    check(np.allclose(statistic(display, "ScalarRange"), (-LAST, LAST)),
          "second array: without one, surfaces are those of Coloring", statistic(display, "ScalarRange"))


def test_cells(view, source):
    """Cells have one colour each."""
    cells = PointDatatoCellData(Input=source, PassPointData=1)
    display = show_surface(cells, view, ("CELLS", "Height"))
    picture = take_picture(view, "second-array-of-cells")
    colors = np.unique(picture.reshape(-1, 3), axis=0)
    check(10 < len(colors) <= 2 * LAST + 1, "second array: of cells", f"{len(colors)} colours")
    return display


def main():
    """All of it."""
    view = make_view((SIZE, SIZE))
    source = make_source()
    field = Field(*samples_of(source, "RTData"))
    display = show_surface(source, view, ("POINTS", "Height"))
    test_colors(view, display, field)
    test_panel(view, display)
    display.Visibility = 0
    test_cells(view, source)


main()
