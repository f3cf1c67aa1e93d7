# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""The recipe for ParaView of Documentation/Recipes.md runs as it stands there, and shows a surface."""

import os
import pathlib
import re

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

PAGE = pathlib.Path(__file__).resolve().parents[2] / "Documentation" / "Recipes.md"


def check(is_right, what):
    """Print a line that run.sh counts."""
    print(f"{'passed' if is_right else 'FAILED'}: {what}", flush=True)


def read_picture(path):
    """The pixels of a PNG, as integers."""
    reader = vtkPNGReader()
    reader.SetFileName(path)
    reader.Update()
    return vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).astype(int)


def main():
    """Run the recipe, which loads the plugin itself; then look at its picture without the surface."""
    section = PAGE.read_text(encoding="utf-8").split("\n## Use ParaView\n", 1)[1]
    code = re.search(r"```python\n(.*?)```", section, re.DOTALL)[1]
    os.chdir(os.environ["TEMPORAL_ISOSURFACE_OUTPUT"])
    names = {}
    exec(code.replace("TemporalIsosurface.so", os.environ["TEMPORAL_ISOSURFACE_PLUGIN"]), names)
    display = names["display"]
    display.UpdatePropertyInformation()
    check(display.GetPropertyValue("ShownIsovalues") == 180.0, "recipe: the isovalue is shown")
    shown = read_picture("paraview.png")
    display.Visibility = 0
    names["Render"]()
    names["SaveScreenshot"]("paraview-hidden.png")
    different = (shown != read_picture("paraview-hidden.png")).any(axis=1).sum()
    check(different > 1000, f"recipe: a surface is seen ({different} pixels)")


main()
