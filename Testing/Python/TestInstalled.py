# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""What is installed works wherever the prefix is moved to.

environment: CMAKE, the program; BUILD and CONFIGURATION, the build to install;
PYTHON_DIRECTORY, where the package lies below the prefix.
"""

import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

DROP_IN = pathlib.Path(__file__).resolve().parents[2] / "Examples" / "Python" / "drop_in.py"


class Installed(unittest.TestCase):
    def test_drop_in_of_a_moved_prefix(self):
        with tempfile.TemporaryDirectory() as folder:
            prefix, moved = os.path.join(folder, "prefix"), os.path.join(folder, "moved")
            for component in ("runtime", "python"):
                subprocess.run(
                    [os.environ["CMAKE"], "--install", os.environ["BUILD"], "--prefix", prefix,
                     "--config", os.environ["CONFIGURATION"], "--component", component],
                    check=True, capture_output=True)
            shutil.move(prefix, moved)

            packages = os.path.join(moved, os.environ["PYTHON_DIRECTORY"])
            paths = [packages, *os.environ["PYTHONPATH"].split(os.pathsep)[1:]]
            environment = {**os.environ, "PYTHONPATH": os.pathsep.join(paths)}
            where = subprocess.run(
                [sys.executable, "-c",
                 "import vtkTemporalCoherence; print(vtkTemporalCoherence.__file__)"],
                env=environment, check=True, capture_output=True, text=True).stdout
            self.assertTrue(where.startswith(moved), where)
            libraries = subprocess.run(
                [sys.executable, "-c",
                 "import vtkTemporalCoherence; print(open('/proc/self/maps').read())"],
                env=environment, check=True, capture_output=True, text=True).stdout
            self.assertIn(moved + "/lib", libraries)
            self.assertNotIn(os.environ["BUILD"] + "/", libraries)
            subprocess.run(
                [sys.executable, str(DROP_IN)], cwd=folder, env=environment, check=True)
            self.assertGreater(os.path.getsize(os.path.join(folder, "drop_in.png")), 10000)


if __name__ == "__main__":
    unittest.main()
