# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""Firefox shows a page as the mapper shows the volume, and obeys the same mouse, keys and fingers as
Chromium."""

import pathlib
import tempfile
import unittest

import needed  # noqa: F401
import numpy
from browser import read_png
from firefox import Firefox
from scenes import Scene, noise, share_of_other_colors, share_of_other_depths, waves


class InFirefox(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        cls.browser = Firefox()
        cls.addClassCleanup(cls.browser.quit)

    def open(self, scene, **settings):
        self.browser.open(scene.write(self.folder / "view.html", **settings))

    def assert_shows(self, scene):
        scene.show(self.browser.isovalue())
        planes, view = scene.planes(), self.browser.view()
        self.assertLessEqual(share_of_other_colors(self.browser.pixels(), scene.colors(planes)), 0.01)
        self.assertLessEqual(share_of_other_depths(
            self.browser.depths(), planes.depth, view["tolerance"] * view["voxel"] + 1e-5), 0.001)

    def test_drag(self):
        scene = Scene(waves(), 1.5, (320, 240))
        self.open(scene)
        self.assert_shows(scene)
        low, high = self.browser.view()["range"]
        for pointer, share in (("mouse", 0.3), ("touch", 0.8)):
            self.browser.drag("slider", (0.5, 0.5), (0.6, 0.5), (share, 0.4), pointer=pointer)
            self.assertAlmostEqual(
                self.browser.isovalue(), low + share * (high - low), delta=0.01 * (high - low))
            self.assert_shows(scene)

    def test_noise(self):
        scene = Scene(noise(), 400, (200, 200))
        self.open(scene, tolerance=0.02)
        self.assert_shows(scene)

    def test_keys(self):
        scene = Scene(waves(), 1.5, (200, 200))
        self.open(scene, views=2, units="K")
        low, high = self.browser.view()["range"]
        self.browser.focus("slider")
        self.browser.press("End", "PageDown", "ArrowLeft")
        self.assertAlmostEqual(self.browser.isovalue(), high - 17.0 * (high - low) / 256.0, delta=1e-9)
        self.assert_shows(scene)
        self.browser.type_over("isovalue", "1.25")
        self.assertEqual(self.browser.isovalue(), 1.25)
        self.assert_shows(scene)
        self.browser.click("picture")
        self.assertRegex(self.browser.text("told"), r"^Isovalue 1\.25 K, depth [\d.]+, at \(.*\)$")
        before = self.browser.pixels()
        self.browser.drag("picture", (0.5, 0.5), (0.7, 0.5), (0.9, 0.5))
        self.assertGreater(share_of_other_colors(self.browser.pixels(), before), 0.05)
        self.browser.focus("slider")
        self.browser.press("n")
        self.browser.wait_until(lambda: self.browser.text("told") == "View 2", "the next view is shown")

    def test_window(self):
        """What is in the window is the picture's canvas."""
        scene = Scene(waves(), 1.5, (200, 160))
        self.open(scene)
        pixels = self.browser.pixels()
        left, top, _, _ = map(round, self.browser.box("picture"))
        shown = read_png(self.browser.screenshot())[::-1][top:top + 160, left:left + 200, :3][::-1]
        self.assertLess(numpy.abs(shown.astype(int) - pixels).mean(), 1.0)
        self.assertFalse(self.browser.run(
            "return document.documentElement.scrollWidth > document.documentElement.clientWidth;"))


if __name__ == "__main__":
    unittest.main()
