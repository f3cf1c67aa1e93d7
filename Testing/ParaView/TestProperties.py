# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""Each property of the panel reaches the mapper, and shows."""

import numpy as np

from Stage import (Calculator, ColorBy, Gradient, GetColorTransferFunction, GetOpacityTransferFunction, Render,
                   Show, check, count_different, look_from, make_view, make_wavelet, show,
                   statistic, take_final_picture)

RANGE = (34.01525497436, 286.34109497070)  # of the wavelet's values


def show_by_one_line(source):
    """A view of a source whose representation is all that a script sets."""
    view = make_view()
    display = Show(source, view)
    display.Representation = "Temporal Isosurface"
    look_from(view)
    Render(view)
    return view, display


def test_defaults():
    """One line, and the middle of the values is shown; two, and a script for volumes is switched."""
    source = make_wavelet()
    view, display = show_by_one_line(source)
    check(np.allclose(statistic(display, "ScalarRange"), RANGE), "default: the range is the array's",
          statistic(display, "ScalarRange"))
    check(np.isclose(statistic(display, "ShownIsovalues"), np.mean(RANGE)),
          "default: the isovalue is the middle", statistic(display, "ShownIsovalues"))
    check((take_final_picture(view, "default") > 0).any(), "default: there is a picture without ColorBy")
    check(statistic(display, "NumberOfRays") == 400 * 400, "statistics: a ray a pixel")
    check(statistic(display, "FrameMilliseconds") > 0.0, "statistics: milliseconds",
          f"{statistic(display, 'FrameMilliseconds'):.3f}")

    volume = Show(source, make_view())
    volume.Representation = "Volume"
    volume.BlendMode = "Isosurface"
    volume.IsosurfaceValues = [120.0, 200.0]
    volume.Representation = "Temporal Isosurface"  # the line that switches
    Render()
    check(list(statistic(volume, "ShownIsovalues")) == [120.0, 200.0],
          "drop-in: the isovalues of the representation Volume are shown")


def test_isovalues_left_out():
    """Where no isovalue is given, one is shown that the array has, also after another one is chosen."""
    view, display = show_by_one_line(Gradient(Input=make_wavelet(), ScalarArray=["POINTS", "RTData"]))
    ColorBy(display, ("POINTS", "Gradient", "Magnitude"))
    Render(view)
    range_of_lengths = statistic(display, "ScalarRange")
    check(np.isclose(statistic(display, "ShownIsovalues"), np.mean(range_of_lengths)),
          "default: of another array, the isovalue is the middle of that one",
          f"{statistic(display, 'ShownIsovalues')} of {range_of_lengths}")
    check((take_final_picture(view, "default-gradient") > 0).any(),
          "default: there is a picture of another array")
    display.IsosurfaceValues = [5.0, 10.0]
    Render(view)
    check(list(statistic(display, "ShownIsovalues")) == [5.0, 10.0],
          "drop-in: isovalues that fit the other array are shown")


def test_array_with_the_same_values():
    """The middle of the first array is nobody's choice, also where it lies in the range of another."""
    view = make_view()
    doubled = Calculator(Input=make_wavelet(), Function="2*RTData", ResultArrayName="Doubled")
    display = Show(doubled, view)
    display.Representation = "Temporal Isosurface"
    ColorBy(display, ("POINTS", "RTData"))
    look_from(view)
    Render(view)
    ColorBy(display, ("POINTS", "Doubled"))
    display.IsosurfaceValues = [300.0, 400.0]
    Render(view)
    check(list(statistic(display, "ShownIsovalues")) == [300.0, 400.0],
          "drop-in: isovalues are shown, not the middle of an array before",
          statistic(display, "ShownIsovalues"))


def test_single_isovalue():
    """The slider's isovalue is drawn where it fits the array and no list says otherwise."""
    view, display = show_by_one_line(make_wavelet())
    check(np.isclose(display.Isovalue, np.mean(RANGE)), "slider: it begins in the middle of the range",
          display.Isovalue)
    display.Isovalue = 210.0
    Render(view)
    check(np.isclose(statistic(display, "ShownIsovalues"), 210.0), "slider: its isovalue is shown",
          statistic(display, "ShownIsovalues"))
    display.Isovalue = 215.0
    Render(view)
    check(statistic(display, "Route") in ("IsomapBuild", "IsomapLookup"), "slider: a drag uses the isomap",
          statistic(display, "Route"))
    display.Isovalues = [120.0]
    Render(view)
    check(np.isclose(statistic(display, "ShownIsovalues"), 120.0), "slider: a list of isovalues counts first")
    display.Isovalues = []
    display.Isovalue = 5000.0
    Render(view)
    check(np.isclose(statistic(display, "ShownIsovalues"), np.mean(RANGE)),
          "slider: beyond the range, the middle is shown", statistic(display, "ShownIsovalues"))


def test_looks_of_surfaces():
    """Each row of the table is the colour and the opacity of a surface."""
    view = make_view()
    display = show(make_wavelet(), view, [130.0, 220.0])
    look_from(view)
    display.Ambient, display.Diffuse = 1.0, 0.0
    Render(view)
    check(take_final_picture(view, "looks-none")[:, :, 2].max() > 250, "looks: without rows all are white")
    display.SurfaceLooks = [1.0, 0.0, 0.0, 0.5, 0.0, 1.0, 0.0, 1.0]
    mixed = take_final_picture(view, "looks-two")
    both = ((mixed[:, :, 0] > 100) & (mixed[:, :, 1] > 100)).sum()
    check(both > 100 and mixed[:, :, 2].max() == 0, "looks: the green surface is seen through the red one",
          f"{both} pixels")
    display.SurfaceLooks = [1.0, 0.0, 0.0, 1.0]
    opaque = take_final_picture(view, "looks-one")
    check(((opaque[:, :, 0] > 250) & (opaque[:, :, 1] == 0)).any() and (opaque[:, :, 1] < 255).sum() > 0,
          "looks: a surface without a row keeps the colour of all")
    Render(view)
    check(statistic(display, "Route") == "Redisplay", "looks: they stay, and the picture is used again",
          statistic(display, "Route"))
    display.SurfaceLooks = []
    check(take_final_picture(view, "looks-gone")[:, :, 2].max() > 250, "looks: without rows as before")


def test_looks(view, display):
    """Colours and opacities."""
    solid = take_final_picture(view, "solid-color")
    ColorBy(display, ("POINTS", "RTData"))
    table = GetColorTransferFunction("RTData")
    table.RGBPoints = [0.0, 0.0, 0.0, 1.0, 300.0, 1.0, 0.0, 0.0]
    table.ColorSpace = "RGB"
    display.Ambient, display.Diffuse = 1.0, 0.0
    color = take_final_picture(view, "table-color").max(axis=(0, 1))
    check(abs(color[0] - 127.5) < 2 and color[1] == 0 and abs(color[2] - 127.5) < 2,
          "colour: that of the lookup table at the isovalue", f"{color} at 150 of 300")
    display.Ambient, display.Diffuse = 0.0, 1.0
    display.Opacity = 0.5
    half = take_final_picture(view, "half-opaque")
    check(0.4 * solid.max() < half.max() < 0.95 * solid.max(), "opacity: one for all", half.max())
    display.Opacity = 1.0
    GetOpacityTransferFunction("RTData").Points = [0.0, 0.0, 0.5, 0.0, 300.0, 0.0, 0.5, 0.0]
    display.UseOpacityFunction = 1
    nothing = take_final_picture(view, "opacity-function")
    check(nothing.max() == 0, "opacity: that of the opacity function where it is asked for")
    display.UseOpacityFunction = 0
    ColorBy(display, None)
    check(count_different(take_final_picture(view, "solid-again"), solid) == 0,
          "colour: a solid one without an array")


def test_settings(view, display):
    """What steers the mapper."""
    crossing = take_final_picture(view, "crossing")
    display.SurfaceMode = "Threshold"
    check(count_different(take_final_picture(view, "threshold"), crossing) > 0,
          "SurfaceMode: solids are closed where the volume ends")
    display.SurfaceMode = "Crossing"

    display.UseCropping, display.CroppingScale = 1, [0.5, 1.0, 1.0]
    cropped = (take_final_picture(view, "cropped") > 0).any(axis=2).sum()
    check(0 < cropped < (crossing > 0).any(axis=2).sum(), "UseCropping: a box is left",
          f"{cropped} pixels")
    display.UseCropping, display.CroppingScale = 0, [1.0, 1.0, 1.0]

    def turn():
        view.GetActiveCamera().Azimuth(1.0)

    display.RefineWhenStill, display.ColorByAnswer, display.ReuseAccuracy = 0, 1, "Paper"
    turn()
    Render(view) # from here on a view can start from the last picture
    turn()
    picture = take_final_picture(view, "answers")
    yellow = ((picture[:, :, 0] > 60) & (picture[:, :, 2] == 0)).sum()
    check(yellow > 0, "ColorByAnswer: what the cache did not know is yellow", f"{yellow} pixels")
    display.RefineWhenStill, display.ColorByAnswer, display.ReuseAccuracy = 1, 0, "Exact"

    plain = take_final_picture(view, "without-statistics")
    display.ShowStatistics = 1
    Render(view)
    written = count_different(take_final_picture(view, "with-statistics"), plain)
    check(written > 100, "ShowStatistics: a line is written", f"{written} pixels")
    display.ShowStatistics = 0
    check(count_different(take_final_picture(view, "without-again"), plain) == 0,
          "ShowStatistics: and taken away")

    def route_after(change):
        change()
        Render(view)
        return statistic(display, "Route")

    display.ReuseFrames = 0
    check(route_after(turn) == "Cold", "ReuseFrames: off, a new view is cold")
    display.ReuseFrames, display.ReuseAccuracy = 1, "Exact"
    Render(view)
    turn()
    Render(view)
    traced = statistic(display, "NumberOfTracedRays")
    display.ReuseAccuracy = "Paper"
    turn()
    Render(view)
    turn()
    Render(view)
    check(statistic(display, "NumberOfTracedRays") < traced, "ReuseAccuracy: PAPER traces less than EXACT",
          f"{statistic(display, 'NumberOfTracedRays')} and {traced} rays")
    display.ReuseAccuracy = "Exact"
    display.Isomap = 0
    check(route_after(lambda: setattr(display, "Isovalues", [152.0])) == "Cold",
          "Isomap: off, a new isovalue is cold", statistic(display, "Route"))
    display.Isomap, display.IsomapMemoryLimit = 1, 0
    check(route_after(lambda: setattr(display, "Isovalues", [154.0])) == "Cold",
          "IsomapMemoryLimit: 0 is no isomap", statistic(display, "Route"))
    display.IsomapMemoryLimit, display.IsomapRange, display.IsomapTolerance = 256, [150, 170], 0.1
    check(route_after(lambda: setattr(display, "Isovalues", [156.0])) == "IsomapBuild",
          "IsomapRange: it is built at once", statistic(display, "Route"))
    check(route_after(lambda: setattr(display, "Isovalues", [168.0])) == "IsomapLookup",
          "IsomapRange: and all of it is looked up", statistic(display, "Route"))
    memory = statistic(display, "IsomapMemory")
    display.IsomapTolerance = 0.0
    route_after(lambda: setattr(display, "Isovalues", [157.0]))
    check(statistic(display, "IsomapMemory") != memory, "IsomapTolerance: another one, another map",
          f"{memory} and {statistic(display, 'IsomapMemory')} bytes")


def main():
    """All properties."""
    test_defaults()
    test_isovalues_left_out()
    test_array_with_the_same_values()
    test_single_isovalue()
    test_looks_of_surfaces()
    view = make_view()
    display = show(make_wavelet(), view, [150.0])
    look_from(view)
    Render(view)
    test_looks(view, display)
    test_settings(view, display)
    check(list(statistic(display, "RouteCounts"))[6] > 0, "RouteCounts: frames of each route",
          list(statistic(display, "RouteCounts")))


main()
