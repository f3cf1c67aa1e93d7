# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""A notebook that ends its cells with volumes and pictures has them in it, once Jupyter's nbconvert has
run it. Skipped where there is no Jupyter."""

import base64
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

try:
    import ipykernel  # noqa: F401
    import nbconvert  # noqa: F401
    import nbformat
except ImportError as error:
    print(f"SKIPPED: there is no Jupyter here (Debian: python3-nbconvert, python3-ipykernel): {error}")
    sys.exit()

from example import read_png

DATA = """\
import numpy
from vtkTemporalCoherence import composite, isosurface, maximum
z, y, x = numpy.mgrid[-1:1:33j, -1:1:33j, -1:1:33j]
array = (1.0 - numpy.sqrt(x * x + y * y + z * z)).astype(numpy.float32)
"""

#: What the last line of each cell is, and the size of its picture.
CELLS = {
    "isosurface(array, 0.5)": (512, 512),
    "composite(array)": (512, 512),
    "maximum(array)": (512, 512),
    "isosurface(array, 0.5).picture((60, 40))": (60, 40),
}


class Notebook(unittest.TestCase):
    def test_pictures_are_in_it(self):
        with tempfile.TemporaryDirectory() as folder:
            given, done = pathlib.Path(folder, "given.ipynb"), pathlib.Path(folder, "done.ipynb")
            cells = [nbformat.v4.new_code_cell(code) for code in (DATA, *CELLS)]
            nbformat.write(nbformat.v4.new_notebook(cells=cells), given)
            run = subprocess.run(
                [sys.executable, "-m", "nbconvert", "--to", "notebook", "--execute",
                 "--ExecutePreprocessor.kernel_name=python3", "--output", done.name, str(given)],
                cwd=folder, capture_output=True, text=True, check=False,
                env={**os.environ, "HOME": folder, "IPYTHONDIR": folder,
                     "JUPYTER_RUNTIME_DIR": folder})
            self.assertEqual(run.returncode, 0, run.stderr)
            first, *others = nbformat.read(done, as_version=4).cells
        self.assertEqual(first.outputs, [])
        for cell, (code, (width, height)) in zip(others, CELLS.items()):
            with self.subTest(code):
                output, = cell.outputs
                pixels = read_png(base64.b64decode(output.data["image/png"]))
                self.assertEqual(pixels.shape, (height, width, 4))
                self.assertGreater(pixels[height // 2, width // 2, 3], 100)
                # The kernel could show this instead.
                self.assertTrue(output.data["text/plain"].startswith("<"), output.data)


if __name__ == "__main__":
    unittest.main()
