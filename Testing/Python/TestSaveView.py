# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""Views are written by one call, with options that are kept, and read from Python. Mistakes raise
what they are, with the reason."""

import json
import pathlib
import tempfile
import unittest

from spheres import distances, image_of, renderer_at, volume_of
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkRenderingCore import vtkCamera
from vtkTemporalCoherence import isosurface, save_view, vtkTemporalCoherenceView

TEXTS = {"title": "Größe & \"more\"", "caption": "</script>", "citation": "Doe 2024", "units": "cm"}


class SaveView(unittest.TestCase):
    def setUp(self):
        self.scratch = tempfile.TemporaryDirectory()
        self.addCleanup(self.scratch.cleanup)
        self.folder = pathlib.Path(self.scratch.name)
        self.surface = isosurface(image_of(distances()), 0.5)

    def read(self, path):
        view = vtkTemporalCoherenceView()
        self.assertTrue(view.Read(str(path)))
        return view

    def header(self, path):
        return json.loads(self.read(path).GetHeader())

    def test_options_are_kept(self):
        path = self.folder / "view.tcview"
        self.assertIs(save_view(
            self.surface, path, size=(24, 16), range=(0.2, 0.7), tolerance=0.5, views=3, **TEXTS), True)
        header = self.header(path)
        for name, text in TEXTS.items():
            self.assertEqual(header[name], text)
        self.assertEqual(len(header["views"]), 3)
        for view in header["views"]:
            self.assertEqual((view["size"], view["range"], view["tolerance"]), ([24, 16], [0.2, 0.7], 0.5))
        page = self.folder / "view.html"
        self.assertTrue(save_view(self.surface, str(page), size=(24, 16), **TEXTS))
        self.assertEqual(self.read(page).GetTitle(), TEXTS["title"])
        self.assertTrue(save_view(self.surface, self.folder / "view.cdb", size=(24, 16)))
        self.assertTrue((self.folder / "view.cdb" / "data.csv").exists())

    def test_cameras_have_names(self):
        front = vtkCamera()
        front.SetPosition(0.0, 0.0, 5.0)
        path = self.folder / "named.tcview"
        save_view(self.surface, path, size=(24, 16), views={"front": front, "ä": vtkCamera()})
        view = self.read(path)
        self.assertEqual([view.GetViewName(i) for i in range(2)], ["front", "ä"])
        self.assertEqual(view.GetViewName(2), "")

    def test_look_up(self):
        path = self.folder / "sphere.tcview"
        volume = volume_of(image_of(distances()), 0.5)
        self.assertTrue(save_view(volume, path, renderer=renderer_at(4.0), size=(40, 40), range=(0.2, 0.7)))
        view, image = self.read(path), vtkImageData()
        self.assertEqual(view.GetNumberOfViews(), 1)
        size, low_high = [0, 0], [0.0, 0.0]
        view.GetSize(0, size)
        view.GetRange(0, low_high)
        self.assertEqual((size, low_high), ([40, 40], [0.2, 0.7]))
        for isovalue in (0.3, 0.5, 0.65):
            self.assertTrue(view.LookUp(0, isovalue, image))
            depth = vtk_to_numpy(image.GetPointData().GetArray("Depth")).reshape(40, 40)
            self.assertAlmostEqual(float(depth[20, 20]), 4.0 - (1.0 - isovalue), delta=0.02)
            self.assertEqual(depth[0, 0], float("inf"))

    def test_progress_tells_and_stops(self):
        path, told = self.folder / "stopped.html", []
        self.assertIs(save_view(self.surface, path, size=(24, 16), progress=told.append), True)
        self.assertEqual(told, sorted(told))
        self.assertEqual(told[-1], 1.0)
        path.unlink()
        self.assertIs(save_view(self.surface, path, size=(24, 16), progress=lambda done: done < 0.3), False)
        self.assertEqual(list(self.folder.iterdir()), [])

    def test_mistakes_are_told(self):
        path = self.folder / "none.html"
        for wrong, error, reason in (
            (lambda: save_view(volume_of(image_of(distances()), 0.5), path), TypeError, "Give a renderer"),
            (lambda: save_view(self.surface, self.folder / "none.png"), ValueError, "ends in .html"),
            (lambda: save_view(self.surface, self.folder / "no" / "none.html", size=(9, 9)), ValueError,
             "cannot be written"),
            (lambda: save_view(self.surface, path, range=(5.0, 6.0)), ValueError, "samples lie from"),
            (lambda: save_view(self.surface, path, views=0), ValueError, "1 to 64"),
            (lambda: save_view(self.surface, path, views=65), ValueError, "1 to 64"),
            (lambda: save_view(self.surface, 5), TypeError, ""),
            (lambda: save_view(self.surface, path, size=5), TypeError, ""),
        ):
            with self.assertRaisesRegex(error, reason):
                wrong()
        self.assertEqual(list(self.folder.iterdir()), [])


if __name__ == "__main__":
    unittest.main()
