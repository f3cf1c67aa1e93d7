# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""A page can be used without a mouse and without seeing it: each control has a role and a name, keys reach
all of them in the order in which they show, and what changes is told in words."""

import unittest

import needed  # noqa: F401
from pages import PageTest
from scenes import Scene, waves

#: What is in the order of Tab, if there are two views and one surface. "remove" is disabled.
ORDER = ["picture", "slider", "isovalue", "surface", "add", "next", "full", "save", "look", "help"]
#: The same with an open look.
IN_LOOK = ["color", "opacity", "ambient", "diffuse", "specular", "power", "reset"]

_NAME_OF_FOCUSED = """
const element = document.activeElement;
return element.id || element.parentElement.id || element.tagName;
"""


class Accessibility(PageTest):
    def setUp(self):
        self.open(Scene(waves(), 1.5, (160, 160)), title="Waves", units="K", views=2)

    def tree(self):
        """Role, name and properties of what screen readers get."""
        nodes = self.browser.devtools("Accessibility.getFullAXTree")["nodes"]
        told = []
        for node in nodes:
            if not node.get("ignored"):
                properties = {each["name"]: each["value"].get("value") for each in node.get("properties", [])}
                value = node.get("value", {}).get("value")
                told.append((node["role"]["value"], node.get("name", {}).get("value", ""), value, properties))
        return told

    def of_role(self, *roles):
        return {name: (value, properties) for role, name, value, properties in self.tree() if role in roles}

    def test_roles_and_names(self):
        self.browser.run("document.getElementById('look').open = true;")
        self.browser.settle()
        self.assertEqual(self.browser.run("return document.documentElement.lang;"), "en")
        self.assertEqual(set(self.of_role("heading")), {"Waves"})
        self.assertEqual(self.browser.run("return document.querySelectorAll('main').length;"), 1)
        sliders = self.of_role("slider")
        self.assertEqual(
            set(sliders), {"Isovalue", "Opacity", "Ambient", "Diffuse", "Specular", "Shininess"})
        self.assertEqual(set(self.of_role("button")), {
            "Add surface", "Remove", "Next view", "Full screen", "Save PNG", "Reset look"})
        self.assertIn("Isovalue", self.of_role("spinbutton"))
        self.assertIn("Surface", self.of_role("combobox"))
        self.assertIn("Isosurface", self.of_role("image", "img"))
        for role, name, _, properties in self.tree():
            if properties.get("focusable") and role != "RootWebArea":
                self.assertTrue(name.strip(), role)
        self.assertEqual(self.browser.run(
            "return [...document.querySelectorAll('input, select')].filter((each) => each.labels.length !== 1)"
            ".map((each) => each.id);"), [])

    def test_values(self):
        low, high = self.browser.view()["range"]
        self.browser.focus("slider")
        self.assertEqual(self.browser.text("told"), "")
        told = set()
        for key in ("ArrowRight", "PageDown", "Home", "End"):
            self.browser.press(key)
            isovalue = self.browser.isovalue()
            for attribute, expected in (("valuemin", low), ("valuemax", high), ("valuenow", isovalue)):
                self.assertAlmostEqual(float(self.browser.attribute("slider", f"aria-{attribute}")), expected)
            text = self.browser.attribute("slider", "aria-valuetext")
            self.assertRegex(text, r"^[-\d.]+ K$")
            self.assertAlmostEqual(float(text.split()[0]), isovalue, delta=1e-5)
            # What is read aloud, as it changes.
            self.assertEqual(self.browser.text("told"), f"Isovalue {text}")
            told.add(self.browser.text("told"))
        self.assertEqual(len(told), 4)
        self.assertEqual(self.browser.attribute("told", "aria-live"), "polite")
        self.assertEqual(self.browser.attribute("message", "role"), "status")

    def walk(self, count, *keys):
        """Where Tab leads, one after the other."""
        names = []
        for _ in range(count):
            self.browser.press(*keys)
            names.append(self.browser.run(_NAME_OF_FOCUSED))
        return names

    def test_order(self):
        self.assertEqual(self.walk(len(ORDER), "Tab"), ORDER)
        self.browser.focus("save")
        self.browser.press("Tab", "Enter")
        self.assertTrue(self.browser.run("return document.getElementById('look').open;"))
        self.assertEqual(self.walk(len(IN_LOOK) + 1, "Tab"), [*IN_LOOK, "help"])

    def test_focus_is_seen(self):
        self.browser.run("document.getElementById('look').open = true; document.getElementById('help').open = true;")
        for name in self.walk(len(ORDER) + len(IN_LOOK), "Tab"):
            style, width = self.browser.run(
                "const {outlineStyle, outlineWidth} = getComputedStyle(document.activeElement); "
                "return [outlineStyle, parseFloat(outlineWidth)];")
            self.assertEqual(style, "solid", name)
            self.assertGreaterEqual(width, 2.0, name)

    def test_buttons_by_keys(self):
        self.browser.focus("add")
        self.browser.press("Enter")
        self.assertEqual(len(self.browser.surfaces()), 2)
        self.browser.focus("remove")
        self.browser.press(" ")
        self.assertEqual(len(self.browser.surfaces()), 1)
        self.browser.focus("next")
        self.browser.press("Enter")
        self.browser.wait_until(lambda: self.browser.text("told") == "View 2", "the next view is told")
        # Keys with Ctrl are the browser's.
        self.browser.perform({"type": "key", "id": "keys", "actions": [
            {"type": "keyDown", "value": "\ue009"}, {"type": "keyDown", "value": "s"},
            {"type": "keyUp", "value": "s"}, {"type": "keyUp", "value": "\ue009"}]})
        self.browser.settle()
        self.assertEqual(list(self.folder.glob("isosurface*")), [])
        self.assert_no_complaints()


if __name__ == "__main__":
    unittest.main()
