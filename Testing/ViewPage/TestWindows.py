# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""A page fits into small and large windows, in light and dark schemes, and fills the screen. All controls can
be reached, also with a finger."""

import os
import pathlib
import unittest

import needed  # noqa: F401
import numpy
from browser import read_png
from pages import PageTest
from scenes import Scene, waves

#: Where screenshots are left to be looked at; empty: nowhere.
SCREENSHOTS = os.environ.get("TEMPORAL_COHERENCE_SCREENSHOTS", "")

TITLE = "A title that is longer than a small window, with_an_unbroken_word_that_is_longer_than_all_of_the_others_are"

_OUTSIDE = """
const width = document.documentElement.clientWidth, outside = [];
for (const element of document.querySelectorAll("body *")) {
  const box = element.getBoundingClientRect();
  if (box.width > 0 && box.height > 0 && (box.left < -0.5 || box.right > width + 0.5)) {
    outside.push(element.id || element.tagName);
  }
}
return outside;
"""

_CONTRAST = """
const partsOf = (color) => color.match(/[\\d.]+/g).slice(0, 3).map(Number);
const light = (color) => {
  const [r, g, b] = partsOf(color).map((part) => {
    const share = part / 255;
    return share <= 0.04045 ? share / 12.92 : ((share + 0.055) / 1.055) ** 2.4;
  });
  return 0.2126 * r + 0.7152 * g + 0.0722 * b;
};
const style = getComputedStyle(document.body), [a, b] = [light(style.color), light(style.backgroundColor)];
return (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
"""


class Windows(PageTest):
    def setUp(self):
        self.scene = Scene(waves(), 1.5, (512, 512))
        self.open(self.scene, title=TITLE, caption="A caption.\n" + 30 * "More words. ", citation=60 * "x", views=2,
                  units="K")
        self.addCleanup(self.browser.reset_window)
        self.addCleanup(self.browser.set_scheme, "")

    def keep(self, name):
        if SCREENSHOTS:
            (pathlib.Path(SCREENSHOTS) / f"{name}.png").write_bytes(self.browser.screenshot())

    def assert_fits(self):
        self.browser.settle()
        self.assertLessEqual(*self.browser.run(
            "const {scrollWidth, clientWidth} = document.documentElement; return [scrollWidth, clientWidth];"))
        self.assertEqual(self.browser.run(_OUTSIDE), [])

    def controls(self):
        """Those that show: not those of a look that is closed."""
        return self.browser.run("return [...document.querySelectorAll('#figure button, #figure input, #figure select')]"
                                ".filter((each) => each.checkVisibility()).map((each) => each.id);")

    def assert_reachable(self):
        """What is at the middle of each control is the control."""
        for name in ("picture", "slider", *self.controls()):
            x, y = self.browser.place_in(name, 0.5, 0.5)
            found = self.browser.run("""
                const element = document.elementFromPoint(arguments[0], arguments[1]);
                return element && (element.id === "histogram" ? "slider" : element.id);""", x, y)
            self.assertEqual(found, name)

    def test_sizes(self):
        for width, height, scale in ((320, 568, 2.0), (568, 320, 2.0), (768, 1024, 1.0), (1280, 800, 1.0),
                                     (1280, 400, 1.5), (3840, 2160, 1.0)):
            self.browser.set_window(width, height, scale)
            self.browser.run("document.getElementById('look').open = false; scrollTo(0, 0);")
            self.assert_fits()
            self.keep(f"window-{width}x{height}")
            self.browser.run("document.getElementById('look').open = true;")
            self.assert_fits()
            self.assert_reachable()
            _, _, wide, high = self.browser.box("picture")
            self.assertAlmostEqual(wide / high, 1.0, delta=0.02)
            self.assertLessEqual(high, height)
            self.assertGreaterEqual(wide, min(512, 0.5 * min(width, height)))
            # The histogram has a pixel for each of the screen.
            self.browser.wait_until(lambda: self.browser.run(
                "const {width, clientWidth} = document.getElementById('histogram'); "
                "return Math.abs(width - clientWidth * devicePixelRatio) <= 1;"), "the histogram is drawn again")
        self.assert_no_complaints()

    def test_schemes(self):
        backgrounds = {}
        for scheme in ("light", "dark"):
            self.browser.set_scheme(scheme)
            self.browser.settle()
            self.browser.run("document.getElementById('look').open = true; scrollTo(0, 0);")
            self.keep(f"scheme-{scheme}")
            self.assertGreater(self.browser.run(_CONTRAST), 7.0)
            shown = read_png(self.browser.screenshot())
            backgrounds[scheme] = shown[5, 2, :3].mean()
            left, top, width, height = map(round, self.browser.box("slider"))
            bars = read_png(self.browser.screenshot())[::-1][top:top + height, left:left + width, :3].astype(int)
            self.assertGreater(numpy.abs(bars - bars[2, 2]).max(axis=2).max(), 60)
        self.assertGreater(backgrounds["light"], 230)
        self.assertLess(backgrounds["dark"], 40)

    def test_full_screen(self):
        for switch in (lambda: self.browser.click("full"), lambda: self.browser.press("f")):
            switch()
            self.browser.wait_until(
                lambda: self.browser.run("return document.fullscreenElement?.id === 'figure';"), "the screen is full")
            self.browser.settle()
            self.keep("full-screen")
            for name in ("picture", "slider", *self.controls()):
                left, top, right, bottom, width, height = self.browser.run(
                    "const {left, top, right, bottom} = document.getElementById(arguments[0]).getBoundingClientRect();"
                    " return [left, top, right, bottom, innerWidth, innerHeight];", name)
                self.assertGreaterEqual(min(left, top), 0)
                self.assertLessEqual(right, width)
                self.assertLessEqual(bottom, height, name)
                if name == "picture":
                    self.assertGreater(bottom - top, 0.5 * min(width, height))
            # A click means what is seen.
            row, column = 256, 256
            self.scene.show(self.browser.isovalue())
            planes = self.scene.planes()
            self.browser.click("picture")
            depth = float(self.browser.text("told").partition("depth ")[2].partition(",")[0])
            near = planes.depth[row - 3:row + 4, column - 3:column + 4]
            self.assertTrue(near.min() - 0.02 <= depth <= near.max() + 0.02)
            self.browser.click("full")
            self.browser.wait_until(
                lambda: self.browser.run("return document.fullscreenElement === null;"), "the window is back")
        self.assert_no_complaints()

    def test_touch(self):
        self.browser.set_window(360, 640, 2.0, is_mobile=True)
        low, high = self.browser.view()["range"]
        before = self.browser.pixels()
        self.browser.drag("slider", (0.3, 0.5), (0.4, 0.5), (0.6, 0.2), (0.8, 0.9), pointer="touch")
        self.assertAlmostEqual(self.browser.isovalue(), low + 0.8 * (high - low), delta=0.01 * (high - low))
        self.assertTrue((self.browser.pixels() != before).any())
        # The page does not scroll under a finger in the picture.
        _, top, _, _ = self.browser.box("picture")
        before = self.browser.pixels()
        place = [round(part) for part in self.browser.place_in("picture", 0.5, 0.5)]
        self.browser.drag_in_window(place, (place[0] + 20, place[1] + 5), (place[0] + 60, place[1] - 60),
                                    pointer="touch")
        self.assertTrue((self.browser.pixels() != before).any())
        self.assertEqual(
            self.browser.run("return document.getElementById('picture').getBoundingClientRect().top;"), top)
        self.browser.drag("picture", (0.5, 0.5), pointer="touch")
        self.assertIn("depth", self.browser.text("told"))
        self.assert_no_complaints()


if __name__ == "__main__":
    unittest.main()
