# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""What tests of the examples in Python share."""

import math
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import numpy
from spheres import SAMPLES, distances
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

EXAMPLES = pathlib.Path(__file__).resolve().parents[2] / "Examples" / "Python"
PROGRAMS = ("threshold_sweep.py", "render_server.py")


def read_png(data=None, path=None):
    """The pixels of a PNG, row 0 at the bottom."""
    reader = vtkPNGReader()
    if data is not None:
        reader.SetMemoryBuffer(data)
        reader.SetMemoryBufferLength(len(data))
    else:
        reader.SetFileName(str(path))
    reader.Update()
    width, height, _ = reader.GetOutput().GetDimensions()
    return vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).reshape(height, width, -1)


class Example(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.assertNotIn("DISPLAY", os.environ)

    def command(self, program, *arguments):
        return [sys.executable, str(EXAMPLES / program), *map(str, arguments)]

    def run_example(self, program, *arguments, **environment):
        return subprocess.run(
            self.command(program, *arguments), cwd=self.folder, capture_output=True, text=True,
            env={**os.environ, **environment}, check=False)

    def run_well(self, program, *arguments):
        done = self.run_example(program, *arguments)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return done.stdout

    def assert_refused(self, words, program, *arguments, **environment):
        done = self.run_example(program, *arguments, **environment)
        self.assertEqual(done.returncode, 1, done)
        self.assertRegex(done.stderr, words)
        self.assertTrue(done.stderr.startswith(program + ": "), done.stderr)
        self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
        self.assertTrue(done.stderr.endswith(".\n"), done.stderr)
        # A terminal obeys nothing of it, and it can be read.
        self.assertTrue(done.stderr[:-1].isprintable(), done.stderr)
        self.assertLess(len(done.stderr), 1500)

    def save_sphere(self, centre=(0.0, 0.0, 0.0)):
        """A sphere as a .npy file; with spacing 1 its radius is (1 - isovalue) * 32."""
        path = self.folder / "sphere.npy"
        numpy.save(path, distances(centre))
        return path

    def write(self, writer, data, name):
        writer.SetInputData(data)
        writer.SetFileName(str(self.folder / name))
        writer.Write()

    def assert_shows_sphere(self, pixels, isovalue):
        """The example's camera sees the volume's own sphere at its view angle of 30 degrees."""
        radius = (1.0 - isovalue) * (SAMPLES - 1) / 2.0
        distance = math.sqrt(3.0) * (SAMPLES - 1) / 2.0 / math.sin(math.radians(15.0))
        sine = radius / distance
        tangent = sine / math.sqrt(1.0 - sine * sine) / math.tan(math.radians(15.0))
        height, width, _ = pixels.shape
        expected = tangent * height / 2.0
        y, x = numpy.nonzero(pixels.any(axis=2))
        self.assertAlmostEqual(math.sqrt(len(x) / math.pi), expected, delta=0.5)
        self.assertAlmostEqual(x.mean(), (width - 1) / 2.0, delta=0.5)
        self.assertAlmostEqual(y.mean(), (height - 1) / 2.0, delta=0.5)
