# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""Tests that open pages in Chromium: one browser for all tests of a class, and a folder for its files."""

import pathlib
import tempfile
import unittest

from chromium import Chromium


class PageTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        cls.browser = Chromium(downloads=cls.folder)
        cls.addClassCleanup(cls.browser.quit)

    def open(self, scene, **settings):
        """Write a page of a scene, and open it."""
        self.browser.open(scene.write(self.folder / "view.html", **settings))

    def assert_no_complaints(self):
        self.assertEqual(self.browser.complaints(), [])
