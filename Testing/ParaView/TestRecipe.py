# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""The recipe for ParaView of Documentation/Recipes.md runs as it stands there, and shows a surface."""

import os
import pathlib
import re

from Stage import Hide, Render, SaveScreenshot, check, count_different, read_picture, statistic

PAGE = pathlib.Path(__file__).resolve().parents[2] / "Documentation" / "Recipes.md"


def main():
    """Run the recipe, then look at its picture with and without the surface."""
    section = PAGE.read_text(encoding="utf-8").split("\n## Use ParaView\n", 1)[1]
    code = re.search(r"```python\n(.*?)```", section, re.DOTALL)[1]
    os.chdir(os.environ["TEMPORAL_ISOSURFACE_OUTPUT"])
    names = {}
    exec(code.replace("TemporalIsosurface.so", os.environ["TEMPORAL_ISOSURFACE_PLUGIN"]), names)
    display = names["display"]
    check(statistic(display, "ShownIsovalues") == 180.0, "recipe: the isovalue is shown")
    shown = read_picture("paraview.png")
    Hide()
    Render()
    SaveScreenshot("paraview-hidden.png")
    different = count_different(shown, read_picture("paraview-hidden.png"))
    check(different > 1000, "recipe: a surface is seen", f"{different} pixels")


main()
