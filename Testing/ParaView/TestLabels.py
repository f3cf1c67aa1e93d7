# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""Labels in ParaView have the colours and opacities that the panel and colour maps give them, by brute force."""

import numpy as np

from BruteForce import LabelMap, rays_of
from Stage import (ColorBy, GetColorTransferFunction, GetOpacityTransferFunction, Render, Show, check,
                   check_same, count_different, look_from, make_labels, make_view, make_wavelet, samples_of,
                   statistic, take_final_picture, take_picture)

SIZE = 160
MOST_WRONG = 0.0005  # of the pixels: rays along faces of voxels may see either label
COLORS = {1: (1.0, 0.0, 0.0), 2: (0.0, 1.0, 0.0), 3: (0.0, 0.0, 1.0), 4: (1.0, 1.0, 0.0)}
NAN_COLOR = (1.0, 0.0, 1.0)  # of the label 5, which is no category


def show_labels(source, view):
    """Labels in the colours of categories, without shades."""
    display = Show(source, view)
    display.Representation = "Temporal Isosurface"
    display.SurfaceMode = "Labels"
    ColorBy(display, ("POINTS", "Parts"))
    table = GetColorTransferFunction("Parts")
    table.InterpretValuesAsCategories = 1
    table.AnnotationsInitialized = 1
    table.Annotations = [text for label in COLORS for text in (str(label), f"part {label}")]
    table.IndexedColors = [number for color in COLORS.values() for number in color]
    table.NanColor = NAN_COLOR
    look_from(view)
    Render(view)  # sets the clipping range
    display.Ambient, display.Diffuse = 1.0, 0.0
    return display, table


def opaque_looks():
    """The look of each label while nothing is said of opacities."""
    return {label: (*color, 1.0) for label, color in {**COLORS, 5: NAN_COLOR}.items()}


class Comparison:
    """Compares pictures of a view with brute force."""

    def __init__(self, view, labels):
        self.view = view
        self.labels = labels
        self.rays = rays_of(view.GetActiveCamera(), SIZE, SIZE)

    def check(self, what, looks):
        """Each pixel has the colour that looks give it."""
        picture = take_picture(self.view, what.replace(":", "").replace(" ", "-"))
        wanted = 255.0 * self.labels.composite(*self.rays, looks).reshape(SIZE, SIZE, 3)
        wrong = count_different(picture, wanted, 2)
        seen = int((wanted > 0).any(axis=2).sum())
        check(wrong <= MOST_WRONG * SIZE * SIZE and seen > 0.05 * SIZE * SIZE, what,
              f"{wrong} of {SIZE * SIZE} pixels differ, {seen} show labels")
        return picture


def test_opacities(compared, display, table):
    """Single labels, categories, and the opacity function; what is more special counts first."""
    looks = opaque_looks()
    everything = compared.check("labels: colours of categories, and the NaN colour", looks)
    display.LabelOpacities = [4.0, 0.0]
    hidden = {label: look for label, look in looks.items() if label != 4}
    changed = count_different(compared.check("labels: a hidden one", hidden), everything)
    check(changed > 100, "labels: hiding one shows others", f"{changed} pixels")
    display.LabelOpacities = [4.0, 0.4, 3.0, 0.0]
    looks[4] = (*COLORS[4], 0.4)
    del looks[3]
    compared.check("labels: a translucent one and a hidden one", looks)
    table.EnableOpacityMapping = 1
    table.IndexedOpacities = [1.0, 0.0, 1.0, 1.0]
    del looks[2]
    compared.check("labels: opacities of categories, behind those of single labels", looks)
    display.LabelOpacities = []
    looks = opaque_looks()
    del looks[2]
    compared.check("labels: opacities of categories", looks)
    table.EnableOpacityMapping = 0
    display.Opacity = 0.5
    compared.check("labels: one opacity of all",
                   {label: (*look[:3], 0.5) for label, look in opaque_looks().items()})
    display.Opacity, display.UseOpacityFunction = 1.0, 1
    GetOpacityTransferFunction("Parts").Points = [0.0, 0.0, 0.5, 0.0, 3.4, 0.0, 0.5, 0.0,
                                                  3.6, 1.0, 0.5, 0.0, 5.0, 1.0, 0.5, 0.0]
    compared.check("labels: opacities of the opacity function",
                   {label: look for label, look in opaque_looks().items() if label > 3})
    display.UseOpacityFunction = 0
    check_same("labels: and as before", [compared.check("labels: opaque again", opaque_looks())], [everything])


def test_outside_label(compared, display):
    """What is outside is not drawn."""
    display.OutsideLabel = 4
    compared.check("labels: another one is outside", {
        0: (*NAN_COLOR, 1.0), **{label: look for label, look in opaque_looks().items() if label != 4}})
    display.OutsideLabel = 0


def test_continuous_map(compared, display, table):
    """Without categories, a label has the colour at its value."""
    table.InterpretValuesAsCategories = 0
    table.ColorSpace = "RGB"
    table.Discretize = 0
    table.RGBPoints = [0.0, 0.0, 0.0, 0.0, 5.0, 1.0, 0.5, 0.0]
    compared.check("labels: colours of a map without categories",
                   {label: (label / 5.0, label / 10.0, 0.0, 1.0) for label in range(1, 6)})
    ColorBy(display, None)
    display.SurfaceArrayName = ["POINTS", "Parts"]
    display.DiffuseColor = [0.0, 1.0, 1.0]
    compared.check("labels: a solid colour", {label: (0.0, 1.0, 1.0, 1.0) for label in range(1, 6)})
    display.SurfaceArrayName = ["POINTS", "None"]
    ColorBy(display, ("POINTS", "Parts"))
    table.InterpretValuesAsCategories = 1


def test_radius(view, display):
    """Faces of voxels have few shades, smooth surfaces many, and both cover nearly the same pixels."""
    display.Ambient, display.Diffuse = 0.0, 1.0
    display.LabelOpacities = [label for own in ((4.0, 0.0), (5.0, 0.0)) for label in own]
    shades, shapes = [], []
    for radius in (0.0, 2.5):
        display.LabelRadius = radius
        picture = take_picture(view, f"labels-radius-{radius}")
        shades.append(len(np.unique(picture.reshape(-1, 3), axis=0)))
        shapes.append((picture > 0).any(axis=2))
    check(shades[0] < 30 and shades[1] > 10 * shades[0], "labels: a radius gives smooth surfaces",
          f"{shades[0]} and {shades[1]} colours")
    moved = int((shapes[0] != shapes[1]).sum())
    check(0 < moved < 0.1 * shapes[0].sum(), "labels: they stay where the labels are",
          f"{moved} of {int(shapes[0].sum())} pixels")
    display.LabelRadius, display.LabelOpacities = 0.0, []
    display.Ambient, display.Diffuse = 1.0, 0.0


def test_reuse(view, display):
    """A still picture is shown again, and isovalues belong to other modes."""
    display.Isovalues = [2.5]
    take_final_picture(view, "labels-still")
    check(statistic(display, "Route") == "Redisplay", "labels: a still picture is shown again",
          statistic(display, "Route"))
    check(not statistic(display, "ShownIsovalues"), "labels: no isovalues are drawn",
          statistic(display, "ShownIsovalues"))
    display.SurfaceMode = "Crossing"
    Render(view)
    check(statistic(display, "ShownIsovalues") == 2.5, "labels: isovalues are there for other modes",
          statistic(display, "ShownIsovalues"))


def main():
    """All of it."""
    view = make_view((SIZE, SIZE))
    source = make_labels(make_wavelet(15))
    source.UpdatePipeline()
    display, table = show_labels(source, view)
    compared = Comparison(view, LabelMap(*samples_of(source, "Parts")))
    test_opacities(compared, display, table)
    test_outside_label(compared, display)
    test_continuous_map(compared, display, table)
    test_radius(view, display)
    test_reuse(view, display)


main()
