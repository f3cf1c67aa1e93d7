# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""A script for VTK's own mappers, not changed at all, gains where VTK_AUTOLOAD_PATH is set, or, if it
names VTK's OpenGL class itself, LD_PRELOAD.

The scripts know VTK's Python modules and nothing of this project. Where they show isosurfaces, these
have the outlines that VTK's mapper draws, within a pixel; composite pictures are VTK's byte for byte.
They draw into windows; without a display they are left out.

The surface has no thin parts: VTK's mapper goes by steps, and would miss those that a ray only grazes.
"""

import os
import subprocess
import sys
import tempfile
import unittest

import numpy
import vtkmodules.vtkRenderingVolumeOpenGL2  # noqa: F401
from vtkmodules.vtkRenderingVolume import vtkGPUVolumeRayCastMapper
from scripts import SHOW_VOLUME, pixels_of
from vtkTemporalCoherence import use_everywhere

AUTOLOAD_PATH = os.environ["TEMPORAL_COHERENCE_AUTOLOAD"]
VTK_PYTHONPATH = os.environ["TEMPORAL_COHERENCE_VTK_PYTHONPATH"]

BEGINNING = """\
import sys
from vtkmodules.all import *

source = vtkRTAnalyticSource()
source.SetWholeExtent(-20, 20, -20, 20, -20, 20)
source.Update()
"""

SMART = """\
mapper = vtkSmartVolumeMapper()
mapper.SetInputConnection(source.GetOutputPort())
"""

GPU = """\
mapper = vtkGPUVolumeRayCastMapper()
mapper.SetInputConnection(source.GetOutputPort())
mapper.AutoAdjustSampleDistancesOff()
mapper.SetSampleDistance(0.1)
"""

MASKED = GPU + """\
mask = vtkImageData()
mask.SetDimensions(41, 41, 41)
mask.AllocateScalars(VTK_UNSIGNED_CHAR, 1)
for i in range(41 ** 3):
    mask.GetPointData().GetScalars().SetValue(i, 255 if i % 41 >= 20 else 0)
mapper.SetMaskTypeToBinary()
mapper.SetMaskInput(mask)
"""

FINE = GPU + """\
mapper.SetImageSampleDistance(0.5)
"""

BLOCKS = """\
blocks = vtkMultiBlockDataSet()
for index, extent in enumerate(((-20, 0, -20, 20, -20, 20), (0, 20, -20, 20, -20, 20))):
    part = vtkExtractVOI()
    part.SetInputConnection(source.GetOutputPort())
    part.SetVOI(extent)
    part.Update()
    blocks.SetBlock(index, part.GetOutput())
mapper = vtkMultiBlockVolumeMapper()
mapper.SetInputDataObject(blocks)
"""

LOOK = """\
if sys.argv[1] == "isosurface":
    mapper.SetBlendModeToIsoSurface()
volume = vtkVolume()
volume.SetMapper(mapper)
appearance = volume.GetProperty()
appearance.SetInterpolationTypeToLinear()
appearance.ShadeOn()
appearance.GetIsoSurfaceValues().SetValue(0, 180.0)
appearance.GetRGBTransferFunction().AddRGBPoint(37.0, 0.2, 0.4, 0.9)
appearance.GetRGBTransferFunction().AddRGBPoint(276.0, 0.9, 0.7, 0.4)
if sys.argv[1] == "composite":
    appearance.GetScalarOpacity().AddPoint(37.0, 0.0)
    appearance.GetScalarOpacity().AddPoint(276.0, 0.5)
"""

#: A class that is made without asking a factory.
OPENGL = """\
mapper = vtkOpenGLGPUVolumeRayCastMapper()
mapper.SetInputConnection(source.GetOutputPort())
mapper.AutoAdjustSampleDistancesOff()
mapper.SetSampleDistance(0.1)
"""

SCRIPTS = {
    "vtkSmartVolumeMapper": SMART,
    "vtkGPUVolumeRayCastMapper": GPU,
    "vtkMultiBlockVolumeMapper": BLOCKS,
    "vtkOpenGLGPUVolumeRayCastMapper": OPENGL,
}

#: What isosurfaces are drawn with besides.
SETTINGS = {
    "a mask": MASKED,
    "rays finer than pixels": FINE,
}

#: Where the plane between samples that are masked and others is seen from its edge. VTK's mapper
#: cuts half a cell before it, ours a whole one.
CUT = slice(140, 150)


def gain(mapper):
    """The variable of the environment by which a script gains."""
    if mapper != "vtkOpenGLGPUVolumeRayCastMapper":
        return {"VTK_AUTOLOAD_PATH": AUTOLOAD_PATH}
    library = os.path.join(AUTOLOAD_PATH, "vtkTemporalCoherenceAutoload.so")
    # A sanitizer's library may have to be there, too, and first.
    return {"LD_PRELOAD": f"{os.environ.get('LD_PRELOAD', '')}:{library}".lstrip(":")}


def widened(mask):
    """Pixels of a mask and their neighbours."""
    wide = numpy.pad(mask, 1)
    height, width = mask.shape
    return numpy.any(
        [wide[y:y + height, x:x + width] for y in range(3) for x in range(3)], axis=0)


class UnchangedScripts(unittest.TestCase):
    def setUp(self):
        if "DISPLAY" not in os.environ:
            self.skipTest("Windows need a display, for example that of xvfb-run.")
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = os.path.join(folder.name, "picture.png")

    def run_script(self, mapper, blend, **environment):
        """The picture as a file's bytes, and as pixels; and what VTK's log tells."""
        surroundings = {
            name: value for name, value in os.environ.items()
            if not name.startswith(("PYTHONPATH", "VTK_AUTOLOAD_PATH", "VTK_TEMPORAL"))}
        done = subprocess.run(
            [sys.executable, "-c", BEGINNING + {**SCRIPTS, **SETTINGS}[mapper] + LOOK + SHOW_VOLUME,
             blend, self.path],
            env={**surroundings, "PYTHONPATH": VTK_PYTHONPATH, **environment},
            check=True, capture_output=True, text=True)
        with open(self.path, "rb") as file:
            data = file.read()
        return data, pixels_of(self.path), done.stderr

    def test_isosurfaces(self):
        lit = {}
        for mapper in (*SCRIPTS, *SETTINGS):
            with self.subTest(mapper):
                _, before, told_before = self.run_script(mapper, "isosurface")
                _, after, told = self.run_script(
                    mapper, "isosurface", **gain(mapper))
                self.assertNotIn("is drawn by", told_before)
                self.assertEqual(
                    told.count("A volume is drawn by vtkTemporalCoherenceVolumeMapper"), 1, told)
                self.assertNotIn("vtkOpenGLGPUVolumeRayCastMapper", told)
                if mapper == "a mask":
                    before[:, CUT] = after[:, CUT] = 0
                was_hit, is_hit = before.any(axis=2), after.any(axis=2)
                lit[mapper] = is_hit.mean()
                self.assertGreater(is_hit.mean(), 0.05 if mapper == "a mask" else 0.1)
                self.assertFalse((was_hit & ~widened(is_hit)).any())
                self.assertFalse((is_hit & ~widened(was_hit)).any())
                # VTK lights surfaces a little differently before VTK 9.2.
                self.assertLess(
                    numpy.median(numpy.abs(before - after)[was_hit & is_hit]), 24)
                self.assertTrue((before != after).any(), "the same mapper drew both pictures")
        self.assertLess(lit["a mask"], 0.6 * lit["vtkGPUVolumeRayCastMapper"])

    def test_composite_pictures_are_those_of_vtk(self):
        for mapper in SCRIPTS:
            with self.subTest(mapper):
                before, pixels, _ = self.run_script(mapper, "composite")
                after, _, told = self.run_script(
                    mapper, "composite", VTK_TEMPORAL_COHERENCE_BLEND_VOLUMES="NEVER",
                    **gain(mapper))
                self.assertGreater(pixels.any(axis=2).mean(), 0.1)
                self.assertIn("A volume is drawn by vtkOpenGLGPUVolumeRayCastMapper", told)
                self.assertEqual(before, after)

    def test_composite_pictures_on_the_cpu(self):
        _, before, _ = self.run_script("vtkGPUVolumeRayCastMapper", "composite")
        _, after, told = self.run_script(
            "vtkGPUVolumeRayCastMapper", "composite", VTK_AUTOLOAD_PATH=AUTOLOAD_PATH,
            VTK_TEMPORAL_COHERENCE_BLEND_VOLUMES="always")
        self.assertIn(
            "vtkTemporalCoherenceVolumeMapper, since BlendVolumes is BLEND_ALWAYS", told)
        self.assertGreater(after.any(axis=2).mean(), 0.1)
        self.assertLess(numpy.abs(before - after).mean(), 4.0)

    def test_off(self):
        before, _, _ = self.run_script("vtkSmartVolumeMapper", "isosurface")
        after, _, told = self.run_script(
            "vtkSmartVolumeMapper", "isosurface", VTK_AUTOLOAD_PATH=AUTOLOAD_PATH,
            VTK_TEMPORAL_COHERENCE="off")
        self.assertNotIn("is drawn by", told)
        self.assertEqual(before, after)

    def test_nothing_is_told(self):
        before, _, told_before = self.run_script(
            "vtkSmartVolumeMapper", "isosurface", VTK_AUTOLOAD_PATH=AUTOLOAD_PATH)
        after, _, told = self.run_script(
            "vtkSmartVolumeMapper", "isosurface", VTK_AUTOLOAD_PATH=AUTOLOAD_PATH,
            VTK_TEMPORAL_COHERENCE_LOG="off")
        self.assertEqual(told_before.count("is drawn by"), 1, told_before)
        self.assertNotIn("is drawn by", told)
        self.assertEqual(before, after)

    def test_a_rule_that_is_none(self):
        _, _, told = self.run_script(
            "vtkGPUVolumeRayCastMapper", "composite", VTK_AUTOLOAD_PATH=AUTOLOAD_PATH,
            VTK_TEMPORAL_COHERENCE_BLEND_VOLUMES="sometimes")
        self.assertIn("must be NEVER, SOFTWARE or ALWAYS, not SOMETIMES; it counts as SOFTWARE", told)


class Call(unittest.TestCase):
    def test_use_everywhere(self):
        self.addCleanup(use_everywhere, False)
        for use, name in (
                (False, "vtkOpenGLGPUVolumeRayCastMapper"),
                (True, "vtkTemporalCoherenceGPUVolumeRayCastMapper"),
                (False, "vtkOpenGLGPUVolumeRayCastMapper")):
            use_everywhere(use)
            self.assertEqual(vtkGPUVolumeRayCastMapper().GetClassName(), name)


if __name__ == "__main__":
    unittest.main()
