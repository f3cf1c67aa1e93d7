# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""Views that `save_view()` shares: what one asks for is in the file, a stop leaves none, and mistakes
get one sentence. The code in Python of Documentation/Sharing.md runs as it stands there, and the
gallery's page can be read."""

import base64
import os
import pathlib
import re
import sys
import tempfile
import unittest

import numpy
from spheres import distances, image_of, renderer_at, volume_of
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkDataSetAttributes, vtkImageData
from vtkmodules.vtkRenderingCore import vtkCamera, vtkVolume
from vtkTemporalCoherence import composite, isosurface, save_view, segmentation, vtkTemporalCoherenceView

PAGE = pathlib.Path(__file__).resolve().parents[2] / "Documentation" / "Sharing.md"
SIZE = (48, 40)


def read(path):
    """The views of a file, or of a page."""
    path = pathlib.Path(path)
    if path.suffix == ".html":
        coded = re.search(rb'id="view-file">([^<]*)<', path.read_bytes())[1]
        path = pathlib.Path(path.stem + ".tcview")
        path.write_bytes(base64.b64decode(coded))
    views = vtkTemporalCoherenceView()
    if not views.Read(str(path)):
        raise AssertionError(f"{path} cannot be read")
    return views


def range_of(views, view=0):
    band = [0.0, 0.0]
    views.GetRange(view, band)
    return band


class Sharing(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(folder.name)
        self.volume = isosurface(distances(), 0.5)

    def files(self):
        return sorted(os.listdir())

    def test_what_was_asked_for(self):
        for path in ("a.tcview", "a.html"):
            self.assertTrue(save_view(
                self.volume, path, range=(0.4, 0.6), tolerance=0.25, size=SIZE, title="A <b> & \u00fc",
                caption="c", citation="d", units="mm"))
            views = read(path)
            self.assertEqual(views.GetNumberOfViews(), 1)
            self.assertEqual(
                (views.GetTitle(), views.GetCaption(), views.GetCitation(), views.GetUnits()),
                ("A <b> & \u00fc", "c", "d", "mm"))
            numpy.testing.assert_allclose(range_of(views), (0.4, 0.6), atol=1e-6)
            self.assertEqual(views.GetTolerance(0), 0.25)
            image = vtkImageData()
            self.assertTrue(views.LookUp(0, 0.5, image))
            self.assertEqual(image.GetDimensions(), (*SIZE, 1))

    def test_views(self):
        save_view(self.volume, pathlib.Path("orbit.tcview"), views=3, size=SIZE)
        self.assertEqual(read("orbit.tcview").GetNumberOfViews(), 3)
        camera = vtkCamera()
        camera.DeepCopy(self.volume.renderer.GetActiveCamera())
        save_view(self.volume, "named.tcview", views={"front": camera, "again": camera}, size=SIZE)
        views = read("named.tcview")
        self.assertEqual([views.GetViewName(view) for view in range(2)], ["front", "again"])

    def test_depths(self):
        volume = volume_of(image_of(distances()), 0.5)
        save_view(volume, "sphere.tcview", renderer=renderer_at(4.0), size=(40, 40), range=(0.2, 0.7))
        views, image = read("sphere.tcview"), vtkImageData()
        for isovalue in (0.3, 0.5, 0.65):
            self.assertTrue(views.LookUp(0, isovalue, image))
            depth = vtk_to_numpy(image.GetPointData().GetArray("Depth")).reshape(40, 40)
            self.assertAlmostEqual(float(depth[20, 20]), 4.0 - (1.0 - isovalue), delta=0.02)
            self.assertEqual(depth[0, 0], float("inf"))

    def test_database(self):
        self.assertTrue(save_view(self.volume, "a.cdb", size=SIZE))
        self.assertIn("data.csv", os.listdir("a.cdb"))
        self.assertTrue(any(name.endswith(".tcview") for name in os.listdir("a.cdb")))

    def test_progress(self):
        told = []
        self.assertTrue(save_view(self.volume, "a.html", size=SIZE, progress=told.append))
        self.assertEqual(told, sorted(told))
        self.assertEqual(told[-1], 1.0)

    def test_a_stop_leaves_nothing(self):
        for path in ("a.html", "a.tcview", "a.cdb"):
            self.assertFalse(save_view(self.volume, path, size=SIZE, progress=lambda done: False))
        self.assertEqual(self.files(), [])

    def test_mistakes(self):
        nearest = isosurface(distances(), 0.5)
        nearest.GetProperty().SetInterpolationTypeToNearest()
        no_number = distances()
        no_number[20, 30, 32] = numpy.nan
        labels = segmentation((distances() > 0.5).astype(numpy.uint8), {1: "ball"})
        hidden = image_of(distances())
        hidden.AllocateCellGhostArray().SetValue(5, vtkDataSetAttributes.HIDDENCELL)
        for words, volume, path, settings in (
                ("path that ends in .html", self.volume, "a.png", {}),
                ("cannot be written", self.volume, "nowhere/a.html", {}),
                ("set another range", self.volume, "a.html", {"range": (900, 901)}),
                ("is blended", composite(distances()), "a.html", {}),
                ("linear interpolation", nearest, "a.html", {}),
                ("no numbers", isosurface(no_number, 0.5), "a.html", {}),
                ("hidden cells", isosurface(hidden, 0.5), "a.html", {}),
                ("not labels", labels, "a.html", {}),
                ("1 to 64 views", self.volume, "a.html", {"views": 65}),
                ("1 to 64 views", self.volume, "a.html", {"views": 0})):
            with self.subTest(words), self.assertRaisesRegex(ValueError, words):
                save_view(volume, path, size=SIZE, **settings)
        with self.assertRaisesRegex(TypeError, "Give a renderer"):
            save_view(vtkVolume(), "a.html")
        self.assertEqual(self.files(), [])

    def test_a_page_is_replaced_when_all_is_written(self):
        save_view(self.volume, "a.html", size=SIZE)
        before = pathlib.Path("a.html").read_bytes()
        save_view(self.volume, "a.html", size=SIZE, title="B", progress=lambda done: False)
        self.assertEqual(pathlib.Path("a.html").read_bytes(), before)
        save_view(self.volume, "a.html", size=SIZE, title="B")
        self.assertEqual(read("a.html").GetTitle(), "B")

    def test_documentation(self):
        if not PAGE.exists():
            self.skipTest("The documentation is not there.")
        codes = re.findall(r"```python\n(.*?)```", PAGE.read_text(encoding="utf-8"), re.DOTALL)
        self.assertEqual(len(codes), 1)
        shared = {"array": 300.0 * distances().astype(numpy.float32)}
        exec(compile(codes[0], str(PAGE), "exec"), shared)
        self.assertEqual(self.files(), ["finding.html", "orbit.html"])
        self.assertEqual(read("finding.html").GetTitle(), "Finding")
        views = read("orbit.html")
        self.assertEqual(views.GetNumberOfViews(), 8)
        numpy.testing.assert_allclose(range_of(views, 7), (100.0, 200.0), rtol=1e-6)

    def test_page_of_the_gallery(self):
        page = PAGE.parent / "Pictures" / "view.html"
        if not page.exists():
            self.skipTest("The documentation is not there.")
        self.assertLessEqual(page.stat().st_size, 500000)
        views = read(page)  # Documentation/gallery.sh --view makes it again
        self.assertEqual(views.GetTitle(), "A head in MR")
        numpy.testing.assert_allclose(range_of(views), (30.0, 100.0), rtol=1e-6)


if __name__ == "__main__":
    try:
        with tempfile.TemporaryDirectory() as folder:
            save_view(isosurface(distances(), 0.5), pathlib.Path(folder, "a.tcview"), size=(8, 8))
    except ValueError as error:
        if "made without" not in str(error):
            raise
        print(f"SKIPPED: {error}")
        sys.exit(0)
    unittest.main()
