# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""ParaView's picture against a brute-force tracer in NumPy: silhouettes and shades."""

import numpy as np

from BruteForce import Field, rays_of
from Stage import (AddLight, Delete, Render, check, look_from, make_view, make_wavelet, samples_of, show,
                   take_picture)

SIZE = 160
MOST_WRONG = 0.0005  # of the pixels: the truth may overlook two crossings close together


def compare(name, view, display, field, is_solid):
    """A picture without light for the silhouette, one in the camera's light for the shades."""
    camera = view.GetActiveCamera()
    Render(view)  # sets the clipping range
    origins, directions = rays_of(camera, SIZE, SIZE)
    distances, normals = field.trace(origins, directions, display.Isovalues[0], is_solid)
    is_hit = np.isfinite(distances).reshape(SIZE, SIZE)

    display.Ambient, display.Diffuse = 1.0, 0.0
    flat = take_picture(view, f"brute-force-{name}-flat").max(axis=2) > 0
    wrong = int((flat != is_hit).sum())
    check(wrong <= MOST_WRONG * SIZE * SIZE and is_hit.mean() > 0.1,
          f"{name}: the silhouette is that of brute force",
          f"{wrong} of {SIZE * SIZE} pixels differ, {int(is_hit.sum())} are hits")
    if is_solid:
        return  # caps have normals of their own

    display.Ambient, display.Diffuse = 0.0, 1.0
    lit = take_picture(view, f"brute-force-{name}-lit")[:, :, 0]
    normals *= -np.sign((normals * directions).sum(axis=1, keepdims=True))  # to the viewer
    to_light = -np.array(camera.GetDirectionOfProjection())
    facing = np.maximum(normals @ to_light, 0.0).reshape(SIZE, SIZE)
    off = np.abs(lit - 255.0 * facing)[flat & is_hit]
    wrong = int((off > 2.0).sum())
    check(wrong <= MOST_WRONG * SIZE * SIZE, f"{name}: shades are those of brute force",
          f"{wrong} pixels are off by more than 2 of 255, the median by {np.median(off):.2f}")


def main():
    """Perspective and parallel views, surfaces and solids."""
    view = make_view((SIZE, SIZE))
    view.UseLight = 0  # no kit of lights: the camera's alone
    AddLight(view).Coords = "Headlight"
    source = make_wavelet(15)
    source.UpdatePipeline()
    field = Field(*samples_of(source, "RTData"))
    for name, isovalue, is_parallel, is_solid in (
            ("perspective", 150.0, 0, False), ("parallel", 180.0, 1, False),
            ("solid", 120.0, 0, True)):
        display = show(source, view, [isovalue])
        display.SurfaceMode = "Threshold" if is_solid else "Crossing"
        view.CameraParallelProjection = is_parallel
        look_from(view)
        compare(name, view, display, field, is_solid)
        Delete(display)


main()
