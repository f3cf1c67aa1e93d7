# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""Cinema databases are what the specification of Cinema says, by a reader that knows nothing else. Depths and
normals of their images are those of the view file."""

import math
import pathlib
import tempfile
import unittest

import needed  # noqa: F401
import numpy
from cinema_images import STEPS, depths_of, normals_of
from read_cinema import WrongDatabase, read_database
from scenes import Scene, ball, noise, stretched, waves
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkTemporalCoherence import vtkTemporalCoherenceView, vtkTemporalCoherenceViewWriter


def look_up(views, number, isovalue):
    """Depths and normals of a view file."""
    image = vtkImageData()
    if not views.LookUp(number, isovalue, image):
        raise AssertionError(f"{isovalue} is not looked up")
    width, height, _ = image.GetDimensions()
    arrays = image.GetPointData()
    return (vtk_to_numpy(arrays.GetArray("Depth")).reshape(height, width).astype(float),
            vtk_to_numpy(arrays.GetArray("Normals")).reshape(height, width, 3).copy())


class Cinema(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def write(self, scene, **settings):
        return scene.write(self.folder / "views.cdb", **settings)

    def check_images(self, rows):
        """Images have what the view file has."""
        views = vtkTemporalCoherenceView()
        self.assertTrue(views.Read(str(rows[0]["FILE_view"])))
        names = [views.GetViewName(view) for view in range(views.GetNumberOfViews())]
        hits = 0
        for row in rows:
            depth, normal = look_up(views, names.index(row["view"]), row["isovalue"])
            found = depths_of(row)
            numpy.testing.assert_array_equal(numpy.isfinite(found), numpy.isfinite(depth))
            is_hit = numpy.isfinite(depth)
            hits += is_hit.sum()
            allowed = 0.5001 * (row["depth_max"] - row["depth_min"]) / STEPS + 1e-6 * row["depth_max"]
            self.assertLess(numpy.abs(found[is_hit] - depth[is_hit]).max(initial=0.0), allowed)
            self.assertLessEqual(numpy.abs(normals_of(row) - normal).max(), 0.51 / 127.0)
        self.assertGreater(hits, 1000)

    def test_waves(self):
        rows = read_database(self.write(Scene(waves(), 1.5, (128, 96)), views=2))
        self.assertEqual(len(rows), 32)
        self.assertEqual([row["view"] for row in rows], 16 * ["View 1"] + 16 * ["View 2"])
        isovalues = [row["isovalue"] for row in rows[:16]]
        numpy.testing.assert_allclose(numpy.diff(isovalues), (isovalues[-1] - isovalues[0]) / 15.0)
        self.check_images(rows)

    def test_noise(self):
        self.check_images(read_database(self.write(Scene(noise(), 400, (128, 128)))))

    def test_long_voxels(self):
        self.check_images(read_database(self.write(Scene(stretched(), 120.5, (96, 128)))))

    def test_whole_numbers(self):
        """Where some isovalues are whole numbers, and others are not, all are floats. So are depths."""
        for low, high in ((0, 150), (100, 400), (0.0, 2.5)):
            rows = read_database(self.write(Scene(noise(), 400, (64, 64)), range=(low, high)))
            for name in ("isovalue", "depth_min", "depth_max"):
                self.assertEqual({type(row[name]) for row in rows}, {float})
            self.assertEqual((rows[0]["isovalue"], rows[-1]["isovalue"]), (low, high))

    def test_names(self):
        """Any name of a view is a string that reads back."""
        scene = Scene(ball(), 0.3, (48, 48))
        names = ['He said "a, b"', "Größe, ½ 断面", " blanks ", "<b>", "a,b\n\tc", "FILE", "=1+1"]
        rows = read_database(self.write(scene, views={name: scene.renderer.GetActiveCamera() for name in names}))
        self.assertEqual([row["view"] for row in rows[::16]], [name.replace("\n", " ") for name in names])

    def test_number_of_isovalues(self):
        scene = Scene(ball(), 0.3, (64, 64))
        writer = vtkTemporalCoherenceViewWriter()
        writer.SetSize(64, 64)
        writer.SetNumberOfIsovalues(5)
        path = str(self.folder / "five.cdb")
        self.assertTrue(writer.WriteView(path, scene.renderer, scene.volume))
        rows = read_database(path)
        self.assertEqual(len(rows), 5)
        self.check_images(rows)

    def test_again(self):
        """A database is replaced; a folder of another kind is not touched."""
        self.write(Scene(waves(), 1.5, (64, 64)))
        rows = read_database(self.write(Scene(ball(), 0.3, (48, 48))))
        self.assertEqual(depths_of(rows[0]).shape, (48, 48))
        self.check_images(rows)
        other = self.folder / "other.cdb"
        other.mkdir()
        (other / "note.txt").write_text("mine")
        with self.assertRaises(ValueError):
            Scene(ball(), 0.3, (48, 48)).write(other)
        self.assertEqual([path.name for path in other.iterdir()], ["note.txt"])


class WrongDatabases(unittest.TestCase):
    """The reader finds what the specification does not allow."""

    def refuse(self, table, files=()):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name) / "a.cdb"
            folder.mkdir()
            (folder / "data.csv").write_bytes(table)
            for file in files:
                (folder / file).touch()
            with self.assertRaises(WrongDatabase):
                read_database(folder)

    def test_refused(self):
        for table in (
                b"", b"a,b\n", b"a,a\n1,2\n", b",b\n1,2\n", b"a,b\n1\n", b"a,b\n1,2,3\n", b"a\n1\n1.5\n",
                b"a\n1.5\n1\n", b"a\nx\n1\n", b"FILE,a\nb.png,1\n", b"a,FILE\n1,missing.png\n", b'a\n"open\n',
                b'a\nb"c"\n', b'a\n"b"c\n', b"a\n\xff\n"):
            self.refuse(table, ["b.png"])

    def test_read(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name) / "a.cdb"
            folder.mkdir()
            (folder / "b.png").touch()
            (folder / "data.csv").write_bytes(
                b'n,x,"t ""q"", u",FILE,FILE_2\r\n1,1.5,"a\r\nb",b.png,b.png\r\n,nan,"",b.png,\n')
            first, second = read_database(folder)
            self.assertEqual(list(first.values()), [1, 1.5, "a\r\nb", folder / "b.png", folder / "b.png"])
            self.assertIsNone(second["n"])
            self.assertTrue(math.isnan(second["x"]))
            self.assertEqual((second['t "q", u'], second["FILE_2"]), ("", None))


if __name__ == "__main__":
    unittest.main()
