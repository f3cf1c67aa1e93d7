# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""Volumes that are blended: maxima along rays are those of the field, and need no isovalue."""

import unittest

import numpy
from spheres import STEP, distances, image_of, renderer_at, volume_of
from vtkTemporalCoherence import render, vtkTemporalCoherenceVolumeMapper

SIZE = (80, 60)


def scene():
    """The largest value in view is 1 - the distance between a ray and the centre."""
    volume, renderer = volume_of(image_of(distances())), renderer_at(5.0)
    renderer.GetActiveCamera().ParallelProjectionOn()
    renderer.GetActiveCamera().SetParallelScale(0.9)
    volume.GetMapper().SetBlendModeToMaximumIntensity()
    appearance = volume.GetProperty()
    appearance.ShadeOff()
    appearance.GetRGBTransferFunction().RemoveAllPoints()
    appearance.GetRGBTransferFunction().AddRGBPoint(0.0, 0.0, 0.0, 0.0)
    appearance.GetRGBTransferFunction().AddRGBPoint(1.0, 1.0, 0.5, 0.0)
    appearance.GetScalarOpacity().RemoveAllPoints()
    appearance.GetScalarOpacity().AddPoint(0.0, 1.0)
    return volume, renderer


class Maxima(unittest.TestCase):
    def test_maxima_are_those_of_the_field(self):
        volume, renderer = scene()
        planes = render(volume, renderer, SIZE)
        width, height = SIZE
        pixel = 1.8 / height
        x = (numpy.arange(width) + 0.5 - 0.5 * width) * pixel
        y = (numpy.arange(height) + 0.5 - 0.5 * height) * pixel
        away = numpy.hypot(x[None, :], y[:, None])
        is_inside = (abs(x)[None, :] < 1.0) & (away > 2.0 * STEP)
        expected = 255.0 * numpy.clip(1.0 - away, 0.0, 1.0)
        for channel, share in enumerate((1.0, 0.5, 0.0)):
            error = numpy.abs(planes.color[..., channel] - share * expected)[is_inside]
            self.assertLess(error.max(), 1.5, channel)
        self.assertTrue((planes.color[..., 3][is_inside] == 255).all())
        self.assertTrue((planes.isovalue_index == -1).all())
        self.assertFalse(planes.normals.any())
        self.assertTrue(numpy.isfinite(planes.depth[is_inside]).all())
        # A maximum lies where its ray is nearest to the centre.
        self.assertLess(numpy.abs(planes.depth[is_inside] - 5.0).max(), 0.1)

    def test_the_same_picture_is_shown_again(self):
        volume, renderer = scene()
        first = render(volume, renderer, SIZE).color.copy()
        second = render(volume, renderer, SIZE).color
        self.assertEqual(volume.GetMapper().GetStatistics().GetRouteAsString(), "Redisplay")
        numpy.testing.assert_array_equal(first, second)
        volume.GetProperty().GetScalarOpacity().AddPoint(0.0, 0.5)
        self.assertLess(render(volume, renderer, SIZE).color[..., 3].max(), 130)
        self.assertEqual(volume.GetMapper().GetStatistics().GetRouteAsString(), "KeepValues")

    def test_defaults(self):
        mapper = vtkTemporalCoherenceVolumeMapper()
        self.assertEqual(mapper.GetSampleDistance(), 0.0)
        self.assertEqual(mapper.GetBlendMode(), mapper.ISOSURFACE_BLEND)


if __name__ == "__main__":
    unittest.main()
