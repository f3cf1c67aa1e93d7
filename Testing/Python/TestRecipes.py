# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""Each recipe in Python of Documentation/Recipes.md runs as it stands there, and gives what it promises:
a picture that shows something, a hit, a second volume, a route."""

import os
import pathlib
import re
import tempfile
import unittest

from example import read_png
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkRenderingCore import vtkWindowToImageFilter

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]
PAGE = REPOSITORY / "Documentation" / "Recipes.md"
CHECKS = REPOSITORY / "Testing" / "Cxx" / "Recipes" / "Checks.md"
BEGINNING = "How each recipe begins"
OF_PARAVIEW = "Use ParaView"  # Testing/ParaView/TestRecipe.py runs it


def sections(page):
    """The title, first line and text of each section of a page."""
    text = page.read_text(encoding="utf-8")
    for match in re.finditer(r"^## (.*)\n((?:(?!^## ).*\n)*)", text, re.MULTILINE):
        yield match[1], text.count("\n", 0, match.start(2)) + 1, match[2]


def compiled(page):
    """The code of each section, whose lines are named as those of the page."""
    for title, line, text in sections(page):
        for match in re.finditer(r"```python\n(.*?)```", text, re.DOTALL):
            first = line + text.count("\n", 0, match.start(1))
            yield title, compile("\n" * (first - 1) + match[1], str(page), "exec")


def expect(is_there, what):
    if not is_there:
        raise AssertionError(f"expected {what}")


def pixels_of(window):
    """The pixels of a window, row 0 at the bottom."""
    reader = vtkWindowToImageFilter()
    reader.SetInput(window)
    reader.Update()
    width, height, _ = reader.GetOutput().GetDimensions()
    pixels = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())
    return pixels.reshape(height, width, -1).astype(int)


class Recipes(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(folder.name)

    def run_recipe(self, title):
        names = {"expect": expect, "os": os, "pixels_of": pixels_of, "read_png": read_png}
        codes, checks = dict(compiled(PAGE)), dict(compiled(CHECKS))
        self.assertIn(title, checks, "a recipe that is not checked")
        for code in (codes[BEGINNING], codes[title], checks[title]):
            exec(code, names)

    def test_each_recipe_is_here(self):
        titles = [title for title, _ in compiled(PAGE)]
        self.assertEqual(len(titles), len(set(titles)), "one piece of code a recipe")
        self.assertEqual(titles[0], BEGINNING)
        self.assertEqual(titles[1:], [title for title, _ in compiled(CHECKS)] + [OF_PARAVIEW])
        self.assertGreater(len(titles), 10)


def add_tests():
    for title, _, text in sections(PAGE):
        if title in (BEGINNING, OF_PARAVIEW):
            continue

        def test(self, title=title, text=text):
            needs = re.search(r"\*Needs (a display|VTK's module (\w+))", text)
            if needs and needs[1] == "a display" and "DISPLAY" not in os.environ:
                self.skipTest("there is no display")
            if needs and needs[2]:
                try:
                    __import__(f"vtkmodules.vtk{needs[2]}")
                except ImportError:
                    self.skipTest(f"this VTK has no module {needs[2]}")
            self.run_recipe(title)

        setattr(Recipes, "test_" + re.sub(r"\W", "_", title.lower()), test)


add_tests()

if __name__ == "__main__":
    unittest.main()
