# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""A volume whose isosurfaces are spheres, and what pictures of it must show."""

from __future__ import annotations

import math

import numpy
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkVolume
from vtkTemporalCoherence import numpy_to_image, vtkTemporalCoherenceVolumeMapper

SAMPLES = 65
STEP = 2.0 / (SAMPLES - 1)

#: A trilinear interpolant of distances is off by less than h^2 / (8 r) along each axis.
DEPTH_TOLERANCE = 3.0 * STEP * STEP / (8.0 * 0.4)


def distances(centre=(0.0, 0.0, 0.0)) -> numpy.ndarray:
    """1 - distance from a centre (x, y, z), in the box from -1 to 1: isovalue v is a sphere of the
    radius 1 - v."""
    axis = numpy.linspace(-1.0, 1.0, SAMPLES, dtype=numpy.float32)
    z, y, x = axis[:, None, None], axis[:, None], axis
    squares = (x - centre[0]) ** 2 + (y - centre[1]) ** 2 + (z - centre[2]) ** 2
    return 1.0 - numpy.sqrt(squares)


def image_of(array: numpy.ndarray):
    return numpy_to_image(array, (STEP, STEP, STEP), (-1.0, -1.0, -1.0))


def volume_of(image, *isovalues: float) -> vtkVolume:
    mapper = vtkTemporalCoherenceVolumeMapper()
    mapper.SetInputData(image)
    mapper.SetAntialiasingToOff()
    volume = vtkVolume()
    volume.SetMapper(mapper)
    appearance = volume.GetProperty()
    for index, isovalue in enumerate(isovalues):
        appearance.GetIsoSurfaceValues().SetValue(index, isovalue)
    appearance.GetRGBTransferFunction().AddRGBPoint(0.0, 0.9, 0.7, 0.4)
    appearance.SetInterpolationTypeToLinear()
    appearance.ShadeOn()
    return volume


def renderer_at(distance: float) -> vtkRenderer:
    """Looks at the origin from a point on the z axis, which is towards the viewer."""
    renderer = vtkRenderer()
    camera = renderer.GetActiveCamera()
    camera.SetPosition(0.0, 0.0, distance)
    camera.SetFocalPoint(0.0, 0.0, 0.0)
    camera.SetViewUp(0.0, 1.0, 0.0)
    camera.SetClippingRange(0.1, 2.0 * distance)
    return renderer


def sphere_depth(radius: float, distance: float, width: int, height: int) -> numpy.ndarray:
    """Depth of a sphere around the origin in the view of renderer_at(); infinity beside it."""
    tangent = math.tan(math.radians(15.0))
    x = ((numpy.arange(width) + 0.5) / width * 2.0 - 1.0) * tangent * width / height
    y = (((numpy.arange(height) + 0.5) / height * 2.0 - 1.0) * tangent)[:, None]
    cosine = 1.0 / numpy.sqrt(1.0 + x * x + y * y)
    discriminant = (distance * cosine) ** 2 - distance ** 2 + radius ** 2
    root = numpy.sqrt(numpy.maximum(discriminant, 0.0))
    return numpy.where(discriminant > 0.0, distance * cosine - root, numpy.inf)


def outline_radius(radius: float, distance: float, height: int) -> float:
    """Pixels from the middle of the sphere's outline to its edge."""
    sine = radius / distance
    return sine / math.sqrt(1.0 - sine * sine) / math.tan(math.radians(15.0)) * height / 2.0
