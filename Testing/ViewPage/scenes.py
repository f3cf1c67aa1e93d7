# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""Small volumes, pages of them, and what the mapper shows of them."""

import base64
import re

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPiecewiseFunction
from vtkmodules.vtkRenderingCore import vtkColorTransferFunction
from vtkTemporalCoherence import isosurface, numpy_to_image, render, save_view

#: Dark blue, yellow, and what is between them: by shares of the values' range.
COLORS = ((0.0, (0.1, 0.2, 0.7)), (0.5, (0.8, 0.3, 0.5)), (1.0, (0.95, 0.9, 0.3)))


def _axes(shape):
    return numpy.meshgrid(*(numpy.linspace(-1.0, 1.0, count) for count in shape), indexing="ij")


def waves():
    """A smooth field: blobs, and hollows in them. Float."""
    z, y, x = _axes((40, 44, 48))
    values = 2.0 - x * x - y * y - z * z + 0.4 * numpy.sin(6.0 * x) * numpy.cos(5.0 * y + 2.0 * z)
    return numpy_to_image(values.astype(numpy.float32), (0.1, 0.1, 0.1), (-2.0, 1.0, 5.0))


def noise():
    """A ball in noise, which many rays meet in jumps. Short."""
    z, y, x = _axes((32, 32, 32))
    random = numpy.random.default_rng(7)
    values = 900.0 * numpy.exp(-3.0 * (x * x + y * y + z * z)) + random.normal(0.0, 60.0, x.shape)
    return numpy_to_image(values.astype(numpy.int16))


def ball():
    """Isosurfaces are balls in one another. Double."""
    z, y, x = _axes((28, 28, 28))
    return numpy_to_image(1.0 - numpy.sqrt(x * x + y * y + z * z))


def stretched():
    """Long voxels, far from the world's origin. Unsigned bytes."""
    z, y, x = _axes((24, 40, 56))
    values = 120.0 + 90.0 * numpy.cos(2.5 * x + y) * numpy.cos(2.0 * y) * numpy.cos(1.5 * z - x)
    return numpy_to_image(values.astype(numpy.uint8), (0.5, 0.8, 2.5), (100.0, -40.0, 7.0))


class Scene:
    """A volume, where it is seen from, and the size of its pictures."""

    def __init__(self, image, isovalues, size=(256, 256), opacities=None, direction=(1.0, 0.7, 0.4), **how):
        self.size = size
        self.range = image.GetScalarRange()
        self.volume = isosurface(image, isovalues, **how)
        self.volume.GetMapper().SetAntialiasingToOff()
        self.volume.look_from(direction)
        self.renderer = self.volume.renderer
        self.renderer.SetBackground(0.15, 0.25, 0.35)
        self.set_colors(COLORS)
        self.show(isovalues, opacities)

    def set_colors(self, colors):
        """Colours by isovalue: shares of the values' range, and colours."""
        low, high = self.range
        function = vtkColorTransferFunction()
        for share, color in colors:
            function.AddRGBPoint(low + share * (high - low), *color)
        self.volume.GetProperty().SetColor(function)

    def set_inside_out(self):
        """Change the sign of all values, so that rays meet the insides of surfaces."""
        scalars = self.volume.GetMapper().GetInput().GetPointData().GetScalars()
        values = vtk_to_numpy(scalars)
        values *= -1
        scalars.Modified()
        self.range = (-self.range[1], -self.range[0])
        contours = self.volume.GetProperty().GetIsoSurfaceValues()
        self.set_colors(COLORS)
        self.show([-contours.GetValue(i) for i in range(contours.GetNumberOfContours())])

    def show(self, isovalues, opacities=None):
        """Draw other surfaces."""
        isovalues = numpy.atleast_1d(isovalues)
        contours = self.volume.GetProperty().GetIsoSurfaceValues()
        contours.SetNumberOfContours(len(isovalues))
        opacity = vtkPiecewiseFunction()
        for index, isovalue in enumerate(isovalues):
            contours.SetValue(index, isovalue)
            opacity.AddPoint(isovalue, 1.0 if opacities is None else opacities[index])
        self.volume.GetProperty().SetScalarOpacity(opacity)

    def write(self, path, **settings):
        """Write the views of this volume."""
        if not save_view(self.volume, path, size=self.size, **settings):
            raise AssertionError(f"{path} was not written")
        return path

    def planes(self, camera=None):
        """What the mapper shows: all that render() tells of the pixels."""
        own = self.renderer.GetActiveCamera()
        self.renderer.SetActiveCamera(camera or own)
        self.renderer.ResetCameraClippingRange(self.volume.GetBounds())
        try:
            return render(self.volume, self.renderer, self.size)
        finally:
            self.renderer.SetActiveCamera(own)

    def background(self):
        """The colours behind the volume, (height, 1, 3) of 0 to 255."""
        bottom = numpy.array(self.renderer.GetBackground())
        top = numpy.array(self.renderer.GetBackground2()) if self.renderer.GetGradientBackground() else bottom
        share = numpy.linspace(0.0, 1.0, self.size[1])[:, None, None]
        return 255.0 * (bottom + share * (top - bottom))

    def colors(self, planes):
        """The picture over the background, (height, width, 3) of 0 to 255."""
        color = planes.color.astype(float)
        return color[..., :3] + (1.0 - color[..., 3:] / 255.0) * self.background()

    def first_layers(self, surfaces):
        """What pages show of surfaces: on each ray the first hit of each isovalue, from the back to the front. The
        mapper shows all hits; hits and colours of one opaque surface are its."""
        layers = []
        for surface in surfaces:
            self.show(surface["isovalue"])
            planes = self.planes()
            layers.append((planes.depth, planes.color[..., :3].astype(float), surface["opacity"]))
        order = numpy.argsort([-depth for depth, _, _ in layers], axis=0, kind="stable")
        colors = numpy.broadcast_to(self.background(), layers[0][1].shape).copy()
        for place in range(len(layers)):
            for index, (depth, color, opacity) in enumerate(layers):
                is_next = (order[place] == index) & numpy.isfinite(depth)
                colors[is_next] += opacity * (color - colors)[is_next]
        return colors


def share_of_other_colors(colors, others, most=4.0):
    """The share of the pixels that differ by more than that of 255 in a channel."""
    return float((numpy.abs(colors - others).max(axis=2) > most).mean())


def share_of_other_depths(depths, others, most):
    """The share of the pixels whose depths differ by more than that, or where only one has a surface."""
    is_hit, is_hit_there = numpy.isfinite(depths), numpy.isfinite(others)
    both = is_hit & is_hit_there
    far = numpy.abs(numpy.where(both, depths, 0.0) - numpy.where(both, others, 0.0)) > most
    return float(((is_hit != is_hit_there) | far).mean())


def file_of(page):
    """The view file in the text of a page."""
    return base64.b64decode(_DATA.search(page)[2])


def with_file(page, file):
    """A page with another view file."""
    return _DATA.sub(lambda match: match[1] + base64.b64encode(file).decode() + match[3], page)


_DATA = re.compile(r'(<script type="application/octet-stream" id="view-file">)([^<]*)(</script>)')
