# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""Whatever isovalue the mouse drags to, a page shows what the mapper shows of the volume: depths within the
tolerance, and colours. This is so for smooth fields, for noise, and for long voxels, of several types."""

import unittest

import needed  # noqa: F401
import numpy
from pages import PageTest
from scenes import Scene, noise, share_of_other_colors, share_of_other_depths, stretched, waves

#: The share of the pixels whose colours may differ by more than 4 of 255.
OTHER_COLORS = 0.01
#: The same in noise, whose normals turn within the tolerance of depths.
OTHER_COLORS_IN_NOISE = 0.05
#: The share of the pixels whose depths may be wrong: where a ray grazes a surface.
OTHER_DEPTHS = 0.001


class Drag(PageTest):
    def assert_shows(self, scene, other_colors=OTHER_COLORS):
        """The page shows what the mapper shows of its isovalue."""
        scene.show(self.browser.isovalue())
        planes, view = scene.planes(), self.browser.view()
        self.assertGreater(numpy.isfinite(planes.depth).mean(), 0.02)
        colors = share_of_other_colors(self.browser.pixels(), scene.colors(planes))
        # The mapper's depths are floats.
        allowed = view["tolerance"] * view["voxel"] + 1e-6 * planes.depth[numpy.isfinite(planes.depth)].max()
        depths = share_of_other_depths(self.browser.depths(), planes.depth, allowed)
        self.assertLessEqual(colors, other_colors)
        self.assertLessEqual(depths, OTHER_DEPTHS)

    def drag_through(self, scene, other_colors=OTHER_COLORS):
        """Drag to and fro, and compare at some places."""
        self.assert_shows(scene, other_colors)
        low, high = self.browser.view()["range"]
        _, _, width, _ = self.browser.box("slider")
        places = [0.5, 0.3, 0.31, 0.9, 0.05]
        for first, last in zip(places, places[1:]):
            middle = (first + last) / 2.0
            self.browser.drag("slider", (first, 0.5), (middle, 0.2), (last, 0.8))
            expected = low + last * (high - low)
            self.assertAlmostEqual(self.browser.isovalue(), expected, delta=1.01 * (high - low) / width)
            self.assert_shows(scene, other_colors)

    def test_smooth(self):
        scene = Scene(waves(), 1.5, (320, 240))
        self.open(scene)
        self.drag_through(scene)

    def test_noise(self):
        scene = Scene(noise(), 400)
        self.open(scene)
        self.drag_through(scene, OTHER_COLORS_IN_NOISE)

    def test_fine_noise(self):
        scene = Scene(noise(), 400, (200, 200))
        self.open(scene, tolerance=0.02)
        self.drag_through(scene)

    def test_long_voxels(self):
        scene = Scene(stretched(), 100, (240, 300), specular=0.4, specular_power=20.0)
        self.open(scene)
        self.drag_through(scene)

    # Not yet: whole isovalues lie beside the steps of progress.
    @unittest.expectedFailure
    def test_whole_isovalue(self):
        """Where whole samples equal the isovalue, rays jump at it."""
        scene = Scene(stretched(), 120, (240, 200))
        self.open(scene)
        self.assertEqual(self.browser.isovalue(), 120)
        self.assert_shows(scene)

    def test_parallel_from_behind(self):
        scene = Scene(waves(), 1.5, (256, 200), direction=(-1.0, 0.2, -0.5))
        scene.renderer.GetActiveCamera().ParallelProjectionOn()
        self.open(scene, range=(0.5, 2.0))
        self.assertEqual(self.browser.view()["range"], [0.5, 2.0])
        self.drag_through(scene)

    def test_ends(self):
        """Beyond the ends of the histogram are the ends of the range."""
        scene = Scene(waves(), 1.5)
        self.open(scene)
        low, high = self.browser.view()["range"]
        left, top, width, height = self.browser.box("slider")
        middle = round(left + width / 2.0), round(top + height / 2.0)
        for x, end in ((0, low), (round(left + width + left) - 1, high)):
            self.browser.drag_in_window(middle, (x, middle[1]), (x, 2))
            self.assertEqual(self.browser.isovalue(), end)
            self.assert_shows(scene)


if __name__ == "__main__":
    unittest.main()
