# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""Several surfaces in a page, opaque and translucent, are composited of the mapper's pictures of each, and
are the mapper's picture where rays meet no surface twice. Surfaces can be added, chosen, moved and
removed."""

import unittest

import needed  # noqa: F401
import numpy
from pages import PageTest
from scenes import Scene, ball, noise, share_of_other_colors, waves


class SeveralSurfaces(PageTest):
    def assert_shows(self, scene, most=0.01):
        """The page shows the first hits of its surfaces, as the mapper finds and lights them."""
        colors = scene.first_layers(self.browser.surfaces())
        self.assertLessEqual(share_of_other_colors(self.browser.pixels(), colors), most)

    def test_two_translucent(self):
        scene = Scene(waves(), [1.0, 1.8], (320, 240), [0.3, 0.6])
        self.open(scene)
        self.assert_shows(scene)
        self.browser.drag("slider", (0.2, 0.5), (0.35, 0.5))
        self.assert_shows(scene)

    def test_mapper(self):
        """Rays to the ball inside meet the outer one once, so pages show what the mapper shows."""
        scene = Scene(ball(), [0.1, 0.4], (240, 240), [0.4, 1.0])
        self.open(scene)
        planes = scene.planes()
        pixels, colors = self.browser.pixels(), scene.colors(planes)
        scene.show(0.4)
        is_inside = numpy.isfinite(scene.planes().depth)
        self.assertGreater(is_inside.mean(), 0.02)
        differences = numpy.abs(pixels - colors).max(axis=2)
        self.assertLessEqual((differences[is_inside] > 4.0).mean(), 0.01)
        # Beside it the mapper shows the far side, too, and its opacity counts twice.
        is_beside = numpy.isfinite(planes.depth) & ~is_inside
        self.assertGreater((differences[is_beside] > 4.0).mean(), 0.5)
        self.assert_shows(scene)

    def test_opaque_in_translucent(self):
        scene = Scene(waves(), [1.0, 1.8], (240, 240), [0.4, 1.0], specular=0.3, specular_power=30.0)
        self.open(scene)
        self.assert_shows(scene)
        # The one inside is moved.
        self.browser.run("const list = document.getElementById('surface'); list.selectedIndex = 1; "
                         "list.dispatchEvent(new Event('change'));")
        self.browser.settle()
        self.browser.drag("slider", (0.9, 0.5), (0.7, 0.5))
        low, high = self.browser.view()["range"]
        self.assertAlmostEqual(self.browser.surfaces()[1]["isovalue"], low + 0.7 * (high - low), delta=0.01)
        self.assert_shows(scene)

    def test_opaque_before_all(self):
        scene = Scene(waves(), [1.0, 1.8], (200, 200), [1.0, 0.5])
        self.open(scene)
        self.assert_shows(scene)

    def test_noise(self):
        scene = Scene(noise(), [250, 450], (200, 200), [0.5, 0.8])
        self.open(scene, tolerance=0.02)
        self.assert_shows(scene, 0.03)

    def test_three(self):
        scene = Scene(waves(), [0.6, 1.2, 1.9], (200, 200), [0.2, 0.3, 0.9])
        self.open(scene, range=(0.5, 2.0))
        self.assert_shows(scene)

    def test_adding_and_removing(self):
        scene = Scene(waves(), 1.2, (240, 200))
        self.open(scene)
        before = self.browser.pixels()
        self.assertTrue(self.browser.run("return document.getElementById('remove').disabled;"))
        self.browser.click("add")
        first, second = self.browser.surfaces()
        self.assertLess(first["isovalue"], second["isovalue"])
        self.assertLess(first["opacity"], 1.0)
        self.assertEqual(self.browser.run("return document.getElementById('surface').selectedIndex;"), 1)
        self.assert_shows(scene)
        self.browser.type_over("isovalue", "1.7")
        self.assertEqual([surface["isovalue"] for surface in self.browser.surfaces()], [first["isovalue"], 1.7])
        self.assert_shows(scene)
        # A click reads the nearest one.
        self.browser.click("picture", 0.5, 0.5)
        self.assertIn(f"Isovalue {first['isovalue']:.6g},", self.browser.text("told"))
        for _ in range(10):
            if not self.browser.run("return document.getElementById('add').disabled;"):
                self.browser.click("add")
        self.assertEqual(len(self.browser.surfaces()), 8)
        self.assert_shows(scene, 0.02)
        for _ in range(10):
            if not self.browser.run("return document.getElementById('remove').disabled;"):
                self.browser.click("remove")
        self.assertEqual(len(self.browser.surfaces()), 1)
        self.browser.run("document.getElementById('look').open = true;")
        self.browser.click("reset")
        numpy.testing.assert_array_equal(self.browser.pixels(), before)
        self.assert_no_complaints()


if __name__ == "__main__":
    unittest.main()
