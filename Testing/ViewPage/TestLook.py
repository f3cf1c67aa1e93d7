# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""Colours by isovalue, opacity, material, lights and backgrounds look in a page as the mapper shows them, as
they are written and as its controls change them."""

import unittest

import needed  # noqa: F401
from pages import PageTest
from scenes import Scene, share_of_other_colors, stretched, waves
from vtkmodules.vtkRenderingCore import vtkLight


class Look(PageTest):
    def assert_shows(self, scene):
        self.assertLessEqual(share_of_other_colors(self.browser.pixels(), scene.colors(scene.planes())), 0.01)

    def open_look(self):
        self.browser.click("look", 0.1, 0.01)
        self.assertTrue(self.browser.run("return document.getElementById('look').open;"))

    def slide(self, name, value):
        """Move a slider by keys, so that it has a value."""
        self.browser.focus(name)
        low, high, step, now = (float(number) for number in self.browser.run(
            "const {min, max, step, value} = document.getElementById(arguments[0]); return [min, max, step, value];",
            name))
        from_low, from_high, from_now = (round((value - begin) / step) for begin in (low, high, now))
        best = min((from_low, ["Home"]), (from_high, ["End"]), (from_now, []), key=lambda way: abs(way[0]))
        self.browser.press(*best[1], *["ArrowRight" if best[0] > 0 else "ArrowLeft"] * abs(best[0]))
        self.assertAlmostEqual(float(self.browser.value(name)), value, delta=0.5 * step)

    def test_colors_by_isovalue(self):
        scene = Scene(waves(), 1.0, (240, 200))
        self.open(scene)
        for share in (0.1, 0.5, 0.93):
            self.browser.drag("slider", (share, 0.5))
            scene.show(self.browser.isovalue())
            self.assert_shows(scene)
            color = [0.0, 0.0, 0.0]
            scene.volume.GetProperty().GetRGBTransferFunction().GetColor(self.browser.isovalue(), color)
            for channel, expected in zip(self.browser.surfaces()[0]["color"], color):
                self.assertAlmostEqual(channel, expected, delta=0.01)

    def test_own_color(self):
        """A colour that the reader chose stays as the isovalue moves."""
        scene = Scene(waves(), 1.0, (240, 200))
        self.open(scene)
        self.open_look()
        self.browser.run("const input = document.getElementById('color'); input.value = '#20c040'; "
                         "input.dispatchEvent(new Event('input'));")
        self.browser.drag("slider", (0.6, 0.5))
        scene.set_colors([(0.0, (32 / 255.0, 192 / 255.0, 64 / 255.0))])
        scene.show(self.browser.isovalue())
        self.assert_shows(scene)
        self.browser.click("reset")
        scene = Scene(waves(), 1.0, (240, 200))
        self.assert_shows(scene)

    def test_opacity(self):
        scene = Scene(stretched(), 120.4, (240, 200))
        self.open(scene)
        self.open_look()
        self.slide("opacity", 0.5)
        colors = scene.first_layers([{"isovalue": self.browser.isovalue(), "opacity": 0.5}])
        self.assertLessEqual(share_of_other_colors(self.browser.pixels(), colors), 0.01)

    def test_material(self):
        scene = Scene(waves(), 1.3, (240, 200), ambient=0.1, diffuse=0.7, specular=0.2, specular_power=10.0)
        self.open(scene)
        self.assert_shows(scene)
        appearance = scene.volume.GetProperty()
        self.open_look()
        for name, value, change in (
                ("ambient", 0.3, appearance.SetAmbient), ("diffuse", 0.5, appearance.SetDiffuse),
                ("specular", 0.6, appearance.SetSpecular), ("power", 25.0, appearance.SetSpecularPower)):
            self.slide(name, value)
            change(float(self.browser.value(name)))
            self.assert_shows(scene)
        self.browser.click("reset")
        for name, value in (("ambient", 0.1), ("diffuse", 0.7), ("specular", 0.2), ("power", 10.0)):
            self.assertAlmostEqual(float(self.browser.value(name)), value, delta=1e-6)
        self.assert_no_complaints()

    def test_without_shading(self):
        scene = Scene(waves(), 1.3, (200, 200), lighting=False)
        self.open(scene)
        self.assert_shows(scene)

    def test_lights(self):
        scene = Scene(waves(), 1.3, (200, 200), specular=0.4, specular_power=15.0)
        far, near = vtkLight(), vtkLight()
        far.SetLightTypeToSceneLight()
        far.SetPosition(0.0, 10.0, 0.0)
        far.SetFocalPoint(0.0, 0.0, 0.0)
        far.SetColor(1.0, 0.6, 0.3)
        far.SetIntensity(0.7)
        near.SetLightTypeToSceneLight()
        near.PositionalOn()
        near.SetConeAngle(90.0)
        near.SetPosition(6.0, 5.0, 12.0)
        near.SetColor(0.3, 0.5, 1.0)
        scene.renderer.AddLight(far)
        scene.renderer.AddLight(near)
        self.open(scene)
        self.assertEqual(len(self.browser.run("return isosurfaceView.header.lights;")), 2)
        self.assert_shows(scene)

    def test_one_side(self):
        """Where only the outside of surfaces is lit, the inside is dark."""
        scene = Scene(waves(), 1.3, (200, 200))
        scene.set_inside_out()
        scene.renderer.TwoSidedLightingOff()
        self.open(scene)
        self.assert_shows(scene)

    def test_gradient(self):
        scene = Scene(waves(), 1.3, (200, 260))
        scene.renderer.SetBackground(0.0, 0.1, 0.5)
        scene.renderer.SetBackground2(0.9, 0.8, 0.1)
        scene.renderer.GradientBackgroundOn()
        self.open(scene)
        self.assert_shows(scene)
        pixels = self.browser.pixels()
        for row, expected in ((0, (0, 25, 127)), (-1, (229, 204, 25))):
            self.assertLess(abs(pixels[row, 0] - expected).max(), 2)


if __name__ == "__main__":
    unittest.main()
