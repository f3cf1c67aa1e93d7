# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures for every isovalue, written as a page, a file or a Cinema database."""

from __future__ import annotations

import os
from typing import Any, Callable, Mapping, Sequence

from vtkmodules.util.misc import calldata_type
from vtkmodules.util.vtkConstants import VTK_DOUBLE, VTK_STRING
from vtkmodules.vtkCommonCore import vtkCommand
from vtkmodules.vtkRenderingCore import vtkCamera, vtkRenderer, vtkVolume

from .pictures import PicturedVolume
from .vtkTemporalCoherence import vtkTemporalCoherenceViewWriter


def save_view(
    volume: vtkVolume,
    path: str | os.PathLike,
    *,
    renderer: vtkRenderer | None = None,
    views: int | Mapping[str, vtkCamera] = 1,
    range: Sequence[float] | None = None,
    tolerance: float = 0.1,
    size: tuple[int, int] = (1024, 1024),
    title: str = "",
    caption: str = "",
    citation: str = "",
    units: str = "",
    progress: Callable[[float], Any] | None = None,
) -> bool:
    """Write a picture of a volume for every isovalue. To show it, no volume is needed.

        save_view(isosurface(array, 150), "finding.html", title="Finding", units="HU")

    volume     what isosurface() made, or a vtkVolume with a vtkTemporalCoherenceVolumeMapper. Its
               data are an image or a rectilinear grid
    path       ends in .html (one page for browsers, without a network), .tcview (a view file), or
               .cdb (a Cinema database, a folder)
    renderer   has the camera, the lights and the background. None: that of the volume's pictures
    views      how many views around the volume, or cameras by their names
    range      lowest and highest isovalue. None: those of most surfaces
    tolerance  largest error of distances, in voxels; a larger one makes a smaller file
    size       width and height in pixels
    title, caption, citation, units  what people read
    progress   called with numbers from 0 to 1; if it returns False, writing stops

    Returns True, or False if it was stopped. Raises ValueError with the reason if the volume cannot
    be written, TypeError for what is no volume.
    """
    if renderer is None:
        if not isinstance(volume, PicturedVolume):
            raise TypeError("Give a renderer, or a volume that isosurface() made.")
        renderer = volume.renderer
        renderer.ResetCameraClippingRange(volume.GetBounds())
    writer = vtkTemporalCoherenceViewWriter()
    if range is not None:
        writer.SetRange(*range)
    writer.SetTolerance(tolerance)
    writer.SetSize(*size)
    writer.SetTitle(title)
    writer.SetCaption(caption)
    writer.SetCitation(citation)
    writer.SetUnits(units)
    errors = []

    @calldata_type(VTK_STRING)
    def hear_error(_writer, _event, text):
        errors.append(text.partition("): ")[2].strip() or text.strip())

    @calldata_type(VTK_DOUBLE)
    def hear_progress(_writer, _event, done):
        if progress(done) is False:
            writer.AbortExecuteOn()

    writer.AddObserver(vtkCommand.ErrorEvent, hear_error)
    if progress is not None:
        writer.AddObserver(vtkCommand.ProgressEvent, hear_progress)
    if isinstance(views, Mapping):
        for name, camera in views.items():
            writer.AddView(name, camera)
    elif views != 1:
        writer.AddOrbit(views, renderer)
    is_written = not errors and writer.WriteView(os.fspath(path), renderer, volume)
    if errors:
        raise ValueError(errors[0])
    return is_written
