# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""An isosurface and a camera that goes around it."""

from __future__ import annotations

import math

from vtkmodules.vtkCommonDataModel import vtkDataSet
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkVolume
from vtkTemporalCoherence import Planes, render, vtkTemporalCoherenceVolumeMapper

from mistakes import UserError
from volumes import check_isovalue, value_range

COLOR = (0.95, 0.75, 0.45)


class Scene:
    """Pictures of one volume, made by one mapper, which uses again what it knows of the last one.

    Attributes: mapper; limits, the least and the greatest value of the volume.
    """

    def __init__(self, data: vtkDataSet, what: str = "the volume") -> None:
        self.limits = value_range(data, what)
        self.mapper = vtkTemporalCoherenceVolumeMapper()
        self.mapper.SetInputDataObject(data)
        self._volume = vtkVolume()
        self._volume.SetMapper(self.mapper)
        appearance = self._volume.GetProperty()
        appearance.GetRGBTransferFunction().AddRGBPoint(0.0, *COLOR)
        appearance.SetInterpolationTypeToLinear()
        appearance.ShadeOn()
        self._renderer = vtkRenderer()

    def picture(
        self, isovalue: float, azimuth: float = 0.0, size: tuple[int, int] = (512, 512)
    ) -> Planes:
        """The planes of a picture, seen from azimuth degrees around the z axis, which points up."""
        check_isovalue(isovalue, self.limits)
        if not math.isfinite(azimuth):
            raise UserError(f"Azimuth {azimuth} is no angle: give degrees, for example 30.")
        self._volume.GetProperty().GetIsoSurfaceValues().SetValue(0, isovalue)
        self._place_camera(azimuth, size)
        try:
            return render(self._volume, self._renderer, size)
        except ValueError as error:  # what the mapper says of the data
            raise UserError(str(error)) from error

    def how(self) -> tuple[str, float]:
        """The route by which the last picture was made, and the milliseconds that it took."""
        return self.mapper.GetStatistics().GetRouteAsString(), 1000.0 * self.mapper.GetStatistics().GetFrameTime()

    def _place_camera(self, azimuth: float, size: tuple[int, int]) -> None:
        bounds = self._volume.GetBounds()
        centre = [(bounds[axis] + bounds[axis + 1]) / 2.0 for axis in (0, 2, 4)]
        radius = math.dist(bounds[0::2], bounds[1::2]) / 2.0
        camera = self._renderer.GetActiveCamera()
        distance = radius / math.sin(math.radians(camera.GetViewAngle() / 2.0))
        distance /= min(1.0, size[0] / size[1])
        angle = math.radians(azimuth)
        # Placed, not turned by a step: the same azimuth is the same view, to the last bit.
        camera.SetFocalPoint(centre)
        camera.SetPosition(
            centre[0] + distance * math.sin(angle), centre[1] - distance * math.cos(angle),
            centre[2])
        camera.SetViewUp(0.0, 0.0, 1.0)
        camera.SetClippingRange(distance - radius, distance + radius)
