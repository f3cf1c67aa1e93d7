# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""Keys and clicks of a page do what its help says: they change the isovalue and the view, turn the light,
save the picture, and read depths that are the mapper's."""

import re
import unittest

import needed  # noqa: F401
import numpy
from browser import read_png
from pages import PageTest
from scenes import Scene, share_of_other_colors, share_of_other_depths, stretched, waves
from vtkmodules.vtkRenderingCore import vtkCamera

NUMBER = r"(-?[\d.]+(?:e[-+]?\d+)?)"
TOLD = re.compile(rf"Isovalue {NUMBER} K, depth {NUMBER}, at \({NUMBER}, {NUMBER}, {NUMBER}\)")


def middle_of(colors, depths):
    """Column and row of the middle of what is light on a surface."""
    light = numpy.where(numpy.isfinite(depths), colors.sum(axis=2), 0.0)
    rows, columns = numpy.indices(light.shape)
    return numpy.array([(light * columns).sum(), (light * rows).sum()]) / light.sum()


def pixels_inside(depths, count=6):
    """Pixels of a surface, as columns and rows. Their neighbours have a surface, too."""
    is_hit = numpy.isfinite(depths)
    is_inside = numpy.logical_and.reduce([numpy.roll(is_hit, turn, axis) for axis in (0, 1) for turn in (-3, 0, 3)])
    rows, columns = numpy.nonzero(is_inside)
    return [(int(columns[i]), int(rows[i])) for i in numpy.linspace(0, len(rows) - 1, count).astype(int)]


class Keys(PageTest):
    def setUp(self):
        self.scene = Scene(waves(), 1.5, (320, 240))
        self.open(self.scene, views=3, units="K")
        self.low, self.high = self.browser.view()["range"]
        self.step = (self.high - self.low) / 256.0

    def test_slider(self):
        self.browser.focus("slider")
        begin = self.browser.isovalue()
        for keys, expected in (
                (["ArrowRight"], begin + self.step), (["ArrowUp"] * 3, begin + 4 * self.step),
                (["ArrowLeft", "ArrowDown"], begin + 2 * self.step), (["PageUp"], begin + 18 * self.step),
                (["PageDown", "PageDown"], begin - 14 * self.step), (["Home"], self.low),
                (["ArrowLeft"], self.low), (["End"], self.high), (["PageUp"], self.high)):
            before = self.browser.pixels()
            self.browser.press(*keys)
            self.assertAlmostEqual(self.browser.isovalue(), expected, delta=1e-9)
            changes = expected not in (self.low, self.high) or keys[0] in ("Home", "End")
            self.assertEqual(bool((self.browser.pixels() != before).any()), changes, keys)
        self.assertEqual(self.browser.focused(), "slider")
        self.assert_no_complaints()

    def test_typed_isovalue(self):
        middle = (self.low + self.high) / 2.0
        for text, expected in (("1.25", 1.25), (f"{middle:.4f}", round(middle, 4)), ("-1e30", self.low),
                               ("1e30", self.high)):
            self.browser.type_over("isovalue", text)
            self.assertEqual(self.browser.isovalue(), expected)
            self.assertAlmostEqual(float(self.browser.value("isovalue")), expected, delta=1e-5)
        self.browser.type_over("isovalue", "1.4")
        self.scene.show(1.4)
        self.assertLessEqual(
            share_of_other_colors(self.browser.pixels(), self.scene.colors(self.scene.planes())), 0.01)
        # What is no number changes nothing, and letters in an input are no commands.
        self.browser.type_over("isovalue", "ns")
        self.assertEqual((self.browser.isovalue(), self.browser.view()["name"]), (1.4, "View 1"))

    def camera(self, turn):
        """That of a view of the orbit."""
        camera = vtkCamera()
        camera.DeepCopy(self.scene.renderer.GetActiveCamera())
        camera.Azimuth(120.0 * turn)
        return camera

    def test_next_view(self):
        self.browser.focus("slider")
        for turn, name in ((1, "View 2"), (2, "View 3"), (0, "View 1"), (1, "View 2")):
            self.browser.press("n")
            self.browser.wait_until(
                lambda: self.browser.run("return Boolean(isosurfaceView.pictures[isosurfaceView.number]);"),
                "the view is unpacked")
            self.assertEqual(self.browser.text("told"), name)
            view = self.browser.view()
            self.assertEqual(view["name"], name)
            planes = self.scene.planes(self.camera(turn))
            self.assertLessEqual(share_of_other_colors(self.browser.pixels(), self.scene.colors(planes)), 0.01)
            self.assertLessEqual(share_of_other_depths(
                self.browser.depths(), planes.depth, view["tolerance"] * view["voxel"] + 1e-5), 0.001)
        self.browser.click("next")
        self.assertEqual(self.browser.view()["name"], "View 3")
        self.assert_no_complaints()

    def test_save(self):
        self.browser.drag("slider", (0.4, 0.5))
        for count, save in enumerate((lambda: self.browser.press("s"), lambda: self.browser.click("save")), 1):
            save()
            found = []

            def is_there():
                found[:] = sorted(self.folder.glob("isosurface*.png"))
                return len(found) == count and all(path.stat().st_size for path in found)

            self.browser.wait_until(is_there, "the picture is saved")
            newest = max(found, key=lambda path: path.stat().st_mtime_ns)
            numpy.testing.assert_array_equal(read_png(newest.read_bytes())[..., :3], self.browser.pixels())
        self.assert_no_complaints()

    def test_light(self):
        """Turned by the mouse or by keys: depths stay. Turned back, the picture is what it was."""
        before, depths = self.browser.pixels(), self.browser.depths()
        self.browser.drag("picture", (0.5, 0.5), (0.6, 0.5), (0.8, 0.4))
        turned = self.browser.pixels()
        self.assertGreater(share_of_other_colors(turned, before), 0.1)
        numpy.testing.assert_array_equal(self.browser.depths(), depths)
        # What is light moves with the mouse: to the right, and up.
        self.assertTrue(numpy.all(middle_of(turned, depths) > middle_of(before, depths) + 1.0))
        self.browser.drag("picture", (0.5, 0.5), (0.4, 0.6), (0.2, 0.6))
        self.assertLess(numpy.abs(self.browser.pixels() - before).max(), 2)
        self.browser.focus("picture")
        self.browser.press("ArrowRight", "ArrowUp", "ArrowRight", "ArrowUp")
        turned = self.browser.pixels()
        self.assertTrue(numpy.all(middle_of(turned, depths) > middle_of(before, depths) + 1.0))
        self.browser.press("ArrowLeft", "ArrowDown", "ArrowLeft", "ArrowDown")
        self.assertLess(numpy.abs(self.browser.pixels() - before).max(), 2)
        self.browser.press("ArrowRight")
        self.browser.run("document.getElementById('look').open = true;")
        self.browser.click("reset")
        numpy.testing.assert_array_equal(self.browser.pixels(), before)

    def told_at(self, column, row):
        """What a click at a pixel reads, row 0 at the bottom: isovalue, depth and place; None beside the surface."""
        width, height = self.scene.size
        self.browser.click("picture", (column + 0.5) / width, (height - row - 0.5) / height)
        text = self.browser.text("told")
        if text == "No surface there.":
            return None
        return [float(number) for number in TOLD.fullmatch(text).groups()]

    def check_clicks(self):
        planes, view = self.scene.planes(), self.browser.view()
        mapper = self.scene.volume.GetMapper()
        width, height = self.scene.size
        for column, row in [*pixels_inside(planes.depth), (3, 3), (width - 3, height // 2)]:
            told = self.told_at(column, row)
            position = [0.0, 0.0, 0.0]
            is_hit = mapper.PickPixel(column, row, position, [0.0, 0.0, 0.0], [0])
            self.assertEqual(told is not None, is_hit, (column, row))
            if is_hit:
                isovalue, depth, *place = told
                # Numbers are told with six digits.
                allowed = view["tolerance"] * view["voxel"] + 1e-5 * max(map(abs, (depth, *place)))
                self.assertAlmostEqual(isovalue, self.browser.isovalue(), delta=1e-5 * isovalue)
                self.assertAlmostEqual(depth, planes.depth[row, column], delta=allowed)
                self.assertLess(numpy.abs(numpy.subtract(place, position)).max(), allowed)

    def test_clicks(self):
        self.check_clicks()

    def test_clicks_on_long_voxels(self):
        self.scene = Scene(stretched(), 150, (300, 300))
        self.open(self.scene, units="K")
        self.check_clicks()
        # Enter reads the middle.
        self.browser.focus("picture")
        self.browser.press("Enter")
        column, row = self.scene.size[0] // 2, self.scene.size[1] // 2
        self.assertAlmostEqual(float(TOLD.fullmatch(self.browser.text("told"))[2]),
                               self.scene.planes().depth[row - 1, column], delta=1.0)

    def test_click_on_a_small_picture(self):
        """Where the window makes the picture smaller than its pixels, a click means what is seen there."""
        self.addCleanup(self.browser.reset_window)
        self.browser.set_window(250, 400)
        self.assertLess(self.browser.box("picture")[2], 250)
        depths = self.scene.planes().depth
        for column, row in pixels_inside(depths):
            told = self.told_at(column, row)
            self.assertIsNotNone(told)
            near = depths[row - 2:row + 3, column - 2:column + 3]
            self.assertTrue(near.min() - 0.02 <= told[1] <= near.max() + 0.02, (told, near))


if __name__ == "__main__":
    unittest.main()
