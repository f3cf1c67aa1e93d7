# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""The views that pictures are measured in, and tables with a row for each volume and view."""

from __future__ import annotations

from collections.abc import Callable, Iterable

from vtkmodules.vtkRenderingCore import vtkRenderer

#: How near the camera is, by name.
VIEWS = {"whole": 1.3, "close": 2.2}


def look_at(renderer: vtkRenderer, bounds: tuple[float, ...], view: str) -> None:
    """Look at a volume from above and from a side."""
    camera = renderer.GetActiveCamera()
    renderer.ResetCamera(bounds)
    camera.Azimuth(30)
    camera.Elevation(20)
    camera.Zoom(VIEWS[view])
    renderer.ResetCameraClippingRange(bounds)


def print_rows(scenes: Iterable[str], measure: Callable[[str, float, str], str]) -> None:
    """Print what is measured in each view of scenes, which are written VOLUME:ISOVALUE."""
    for scene in scenes:
        name, isovalue = scene.rsplit(":", 1)
        for view in VIEWS:
            print(measure(name, float(isovalue), view), flush=True)
