# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""An orbit and a sweep of the isovalue: what was used again, by counters; the pictures, by cold ones."""

from Stage import (Render, check, count_different, look_from, make_view, make_wavelet,
                   route_counts, show, statistic, take_final_picture)

VIEWS = 20


def cold_picture(view, display, name):
    """What is shown, made from nothing."""
    display.ReuseFrames = display.Isomap = 0
    camera = view.GetActiveCamera()
    camera.Azimuth(90.0)
    Render(view)
    camera.Azimuth(-90.0)
    picture = take_final_picture(view, name)
    display.ReuseFrames = display.Isomap = 1
    return picture


def test_orbit(view, display):
    """Moved views are exact; with "Paper" they start from the last picture, until the view repeats."""
    view.GetActiveCamera().Azimuth(2.0)
    Render(view)
    check(statistic(display, "Route") == "Cold", "orbit: a new view is exact", statistic(display, "Route"))
    display.ReuseAccuracy = "Paper"
    view.GetActiveCamera().Azimuth(2.0)
    Render(view)
    display.RefineWhenStill = 0
    before = route_counts(display)
    traced, slowest_rays = [], 0
    for _ in range(VIEWS):
        view.GetActiveCamera().Azimuth(2.0)
        Render(view)
        traced.append(statistic(display, "NumberOfTracedRays"))
        slowest_rays = max(slowest_rays, statistic(display, "NumberOfRays"))
    cached = route_counts(display)["ImageCache"] - before["ImageCache"]
    check(cached == VIEWS, "orbit: each view starts from the one before",
          f"{cached} of {VIEWS} frames of the route ImageCache")
    share = max(traced) / slowest_rays
    check(share < 0.6, "orbit: fewer rays are traced", f"at most {100 * share:.0f} %")

    take_final_picture(view, "orbit")
    display.RefineWhenStill = 1
    Render(view)
    check(statistic(display, "Route") == "Cold", "orbit: the repeated view is completed",
          statistic(display, "Route"))
    refined = take_final_picture(view, "orbit-refined")
    cold = cold_picture(view, display, "orbit-cold")
    check(count_different(refined, cold) == 0, "orbit: the completed picture is the cold one")
    display.ReuseAccuracy = "Exact"


def test_sweep(view, display):
    """New isovalues are looked up, and the pictures are the cold ones."""
    look_from(view)
    isovalues = [140.0 + 0.5 * i for i in range(41)]
    display.Isovalues, display.IsomapRange = isovalues[:1], [140, 160]
    Render(view)
    before = route_counts(display)
    traced = 0
    for isovalue in isovalues[1:]:
        display.Isovalues = [isovalue]
        Render(view)
        if statistic(display, "Route") == "IsomapLookup":
            traced += statistic(display, "NumberOfTracedRays")
    after = route_counts(display)
    looked_up = after["IsomapLookup"] - before["IsomapLookup"]
    built = after["IsomapBuild"] - before["IsomapBuild"]
    check(looked_up + built == len(isovalues) - 1 and looked_up > built,
          "sweep: isovalues are looked up in isomaps", f"{looked_up} looked up, {built} built")
    rays = statistic(display, "NumberOfRays")
    check(traced < 0.01 * rays * looked_up, "sweep: what is looked up is not traced",
          f"{traced} rays in {looked_up} frames")
    check(statistic(display, "IsomapMemory") > 0, "sweep: the isomap's memory is told",
          f"{statistic(display, 'IsomapMemory')} bytes")
    reused = take_final_picture(view, "sweep")
    different = count_different(reused, cold_picture(view, display, "sweep-cold"))
    check(different == 0, "sweep: the last picture is the cold one, byte for byte")


def main():
    """Both, on one display."""
    view = make_view()
    display = show(make_wavelet(), view, [150.0])
    look_from(view)
    Render(view)
    test_orbit(view, display)
    test_sweep(view, display)
    display.DiffuseColor = [1.0, 0.5, 0.0]
    Render(view)
    check(statistic(display, "Route") == "Reshade", "colour: a new one is put on what is known",
          statistic(display, "Route"))


main()
