# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""What a page shows at an isovalue of a Cinema database is what the database's images have: depths, and light
by normals."""

import unittest

import needed  # noqa: F401
import numpy
from cinema_images import STEPS, depths_of, normals_of
from pages import PageTest
from read_cinema import read_database
from scenes import Scene, waves


class CinemaInPage(PageTest):
    def test_images(self):
        scene = Scene(waves(), 1.5, (128, 96))
        rows = read_database(scene.write(self.folder / "views.cdb"))
        self.open(scene)
        for row in (rows[0], rows[5], rows[10], rows[15]):
            self.browser.type_over("isovalue", repr(row["isovalue"]))
            self.assertEqual(self.browser.isovalue(), row["isovalue"])
            shown, stored = self.browser.depths(), depths_of(row)
            self.assertLessEqual((numpy.isfinite(shown) != numpy.isfinite(stored)).sum(), 1)
            both = numpy.isfinite(shown) & numpy.isfinite(stored)
            self.assertGreater(both.sum(), 500)
            allowed = 0.51 * (row["depth_max"] - row["depth_min"]) / STEPS + 1e-6 * row["depth_max"]
            self.assertLess(numpy.abs(shown[both] - stored[both]).max(), allowed)
        # Colours of a surface without shine are those of its normals, by the light of the camera.
        light = numpy.array(self.browser.run(
            "return (isosurfaceView.view.lights ?? isosurfaceView.header.lights)[0].direction;"))
        cosine = numpy.clip(-(normals_of(row) @ light), 0.0, 1.0)
        color = 255.0 * numpy.array(self.browser.surfaces()[0]["color"]) * cosine[..., None]
        differences = numpy.abs(self.browser.pixels() - color).max(axis=2)[both]
        self.assertLess(numpy.percentile(differences, 95), 4.0)


if __name__ == "__main__":
    unittest.main()
