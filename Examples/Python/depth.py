#!/usr/bin/python3
# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""A window with an isosurface under ambient occlusion, which refines while nothing is done.

Turn it with the mouse: the picture turns at once, and gets better when it rests. Without a display,
--output saves the final picture and opens no window.
"""

from __future__ import annotations

import argparse

from mistakes import Arguments, UserError, printable, quoted, run
# Before other packages, as it tells what is missing.
from volumes import (
    add_volume_arguments, check_isovalue, name_of, size_of, value_range, volume_of)

import vtkmodules.vtkInteractionStyle  # noqa: F401  what the mouse does
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkRenderWindow, vtkRenderWindowInteractor
from vtkTemporalCoherence import isosurface, render, vtkTemporalCoherenceRefiner, write_png

TITLE = "Depth"


def parse() -> argparse.Namespace:
    arguments = Arguments(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    add_volume_arguments(arguments)
    arguments.add_argument(
        "--isovalue", type=float, help="default: the middle of the values")
    arguments.add_argument(
        "--size", type=size_of, default=(512, 512), metavar="WxH", help="pixels; default: 512x512")
    arguments.add_argument("--output", metavar="FILE", help="save the final picture (PNG) and end")
    return arguments.parse_args()


def show(renderer: vtkRenderer, size: tuple[int, int]) -> None:
    window = vtkRenderWindow()
    window.SetSize(size)
    window.SetMultiSamples(0)
    window.AddRenderer(renderer)
    interactor = vtkRenderWindowInteractor()
    interactor.SetRenderWindow(window)
    interactor.GetInteractorStyle().SetCurrentStyleToTrackballCamera()
    interactor.Initialize()

    # These two lines are all that a program needs.
    refiner = vtkTemporalCoherenceRefiner()
    refiner.SetInteractor(interactor)

    def tell(_refiner: vtkTemporalCoherenceRefiner, _event: str) -> None:
        window.SetWindowName(f"{TITLE}: {100.0 * refiner.GetProgress():.0f} %")
    refiner.AddObserver("ProgressEvent", tell)
    window.Render()
    interactor.Start()


def main() -> None:
    given = parse()
    data = volume_of(given)
    low, high = value_range(data, name_of(given))
    isovalue = (low + high) / 2.0 if given.isovalue is None else given.isovalue
    check_isovalue(isovalue, (low, high))
    surface = isosurface(
        data, isovalue, color="tan", ambient=0.3, diffuse=0.7, ambient_occlusion=True)
    renderer = vtkRenderer()
    renderer.AddVolume(surface)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(0.5, -1.0, 0.5)
    camera.SetViewUp(0.0, 0.0, 1.0)
    camera.SetFocalPoint(0.0, 0.0, 0.0)
    renderer.ResetCamera(surface.GetBounds())
    camera.Zoom(1.4)
    if given.output is None:
        show(renderer, given.size)
        return
    picture = render(surface, renderer, given.size)  # its light is final
    try:
        write_png(given.output, picture.color)
    except (OSError, ValueError) as error:  # ValueError: it does not end with .png
        reason = getattr(error, "strerror", None) or "it does not end with .png"
        raise UserError(
            f"{quoted(given.output)} cannot be written ({reason}): choose another "
            f"--output.") from error
    print(f"saved as {printable(given.output)}")


if __name__ == "__main__":
    run(main)
