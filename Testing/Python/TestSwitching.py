# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""A script that draws isosurfaces with VTK's own mappers changes two lines, and shows the same.

The scripts draw into windows; without a display the tests of pictures are left out.
"""

import difflib
import os
import subprocess
import sys
import tempfile
import unittest

import numpy
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPlane
from vtkmodules.vtkImagingCore import vtkRTAnalyticSource
from vtkmodules.vtkRenderingCore import vtkVolume
from vtkmodules.vtkRenderingVolume import (
    vtkFixedPointVolumeRayCastMapper,
    vtkGPUVolumeRayCastMapper,
)
from vtkmodules.vtkRenderingVolumeOpenGL2 import vtkSmartVolumeMapper
from scripts import SHOW_VOLUME, pixels_of
from vtkTemporalCoherence import render, replace_mapper, vtkTemporalCoherenceVolumeMapper

PLAIN_VTK = """\
import sys
import vtkmodules.vtkRenderingOpenGL2
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkImagingCore import vtkRTAnalyticSource
from vtkmodules.vtkRenderingCore import (
    vtkRenderer, vtkRenderWindow, vtkVolume, vtkWindowToImageFilter)
from vtkmodules.vtkRenderingVolume import vtkGPUVolumeRayCastMapper
import vtkmodules.vtkRenderingVolumeOpenGL2

source = vtkRTAnalyticSource()
mapper = vtkGPUVolumeRayCastMapper()
mapper.SetInputConnection(source.GetOutputPort())
mapper.SetBlendModeToIsoSurface()
mapper.AutoAdjustSampleDistancesOff()
volume = vtkVolume()
volume.SetMapper(mapper)
appearance = volume.GetProperty()
appearance.SetInterpolationTypeToLinear()
appearance.GetIsoSurfaceValues().SetValue(0, 150.0)
appearance.GetRGBTransferFunction().AddRGBPoint(150.0, 0.9, 0.7, 0.4)
appearance.ShadeOn()
""" + SHOW_VOLUME

PLAIN_VTK_CHANGES = {
    "from vtkmodules.vtkRenderingVolume import vtkGPUVolumeRayCastMapper":
        "from vtkTemporalCoherence import vtkTemporalCoherenceVolumeMapper",
    "mapper = vtkGPUVolumeRayCastMapper()": "mapper = vtkTemporalCoherenceVolumeMapper()",
}

# What PyVista's Plotter looks like to a script that draws a volume: it makes the vtkVolume and its
# mapper. Testing/PyVista has the real one.
PLOTTER = """\
import vtkmodules.vtkRenderingOpenGL2
import vtkmodules.vtkRenderingVolumeOpenGL2
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import (
    vtkRenderer, vtkRenderWindow, vtkVolume, vtkWindowToImageFilter)
from vtkmodules.vtkRenderingVolume import vtkGPUVolumeRayCastMapper


class Plotter:
    def __init__(self, off_screen=False, window_size=(300, 300)):
        self.renderer = vtkRenderer()
        self.window = vtkRenderWindow()
        self.window.SetOffScreenRendering(off_screen)
        self.window.SetMultiSamples(0)
        self.window.SetSize(window_size)
        self.window.AddRenderer(self.renderer)

    def add_volume(self, image, isovalue, shade=True):
        volume = vtkVolume()
        mapper = vtkGPUVolumeRayCastMapper()
        mapper.SetInputData(image)
        mapper.SetBlendModeToIsoSurface()
        mapper.SetSampleDistance(0.02)
        mapper.AutoAdjustSampleDistancesOff()
        volume.SetMapper(mapper)
        volume.GetProperty().SetShade(shade)
        volume.GetProperty().SetInterpolationTypeToLinear()
        volume.GetProperty().GetIsoSurfaceValues().SetValue(0, isovalue)
        volume.GetProperty().GetRGBTransferFunction().AddRGBPoint(0.0, 0.9, 0.7, 0.4)
        self.renderer.AddVolume(volume)
        return volume

    def screenshot(self, path):
        self.window.Render()
        picture = vtkWindowToImageFilter()
        picture.SetInput(self.window)
        writer = vtkPNGWriter()
        writer.SetFileName(path)
        writer.SetInputConnection(picture.GetOutputPort())
        writer.Write()
"""

IN_PYVISTA_STYLE = """\
import sys
from plotter import Plotter
from vtkmodules.vtkImagingCore import vtkRTAnalyticSource

source = vtkRTAnalyticSource()
source.Update()
plotter = Plotter(off_screen=True)
actor = plotter.add_volume(source.GetOutput(), isovalue=150.0)
plotter.screenshot(sys.argv[1])
"""

IN_PYVISTA_STYLE_CHANGES = {
    "from plotter import Plotter":
        "from plotter import Plotter\nfrom vtkTemporalCoherence import replace_mapper",
    "plotter.screenshot(sys.argv[1])": "replace_mapper(actor)\nplotter.screenshot(sys.argv[1])",
}


def changed(script, changes):
    lines = [changes.get(line, line) for line in script.splitlines()]
    return "\n".join(lines) + "\n"


def count_changed_lines(before, after):
    """Lines of the new script that the old one does not have."""
    return sum(
        line.startswith("+ ") for line in difflib.ndiff(before.splitlines(), after.splitlines()))


class Scripts(unittest.TestCase):
    def setUp(self):
        if "DISPLAY" not in os.environ:
            self.skipTest("Windows need a display, for example that of xvfb-run.")
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        with open(os.path.join(self.folder, "plotter.py"), "w", encoding="utf-8") as file:
            file.write(PLOTTER)

    def picture(self, script):
        path = os.path.join(self.folder, "picture.png")
        subprocess.run(
            [sys.executable, "-c", script, path], cwd=self.folder, check=True)
        pixels = pixels_of(path)
        os.remove(path)
        return pixels

    def assert_two_lines_show_the_same(self, script, changes):
        ours = changed(script, changes)
        self.assertEqual(count_changed_lines(script, ours), 2)
        before, after = self.picture(script), self.picture(ours)
        is_hit = after.any(axis=2)
        self.assertGreater(is_hit.mean(), 0.1)
        # VTK's mapper finds surfaces by steps, so that outlines differ here and there, and lights
        # them a little differently before VTK 9.2.
        self.assertLess((before.any(axis=2) != is_hit).mean(), 0.01)
        self.assertLess(numpy.median(numpy.abs(before - after)[is_hit]), 24)
        self.assertTrue((before != after).any(), "the same mapper drew both pictures")

    def test_plain_vtk(self):
        self.assert_two_lines_show_the_same(PLAIN_VTK, PLAIN_VTK_CHANGES)

    def test_in_pyvista_style(self):
        self.assert_two_lines_show_the_same(IN_PYVISTA_STYLE, IN_PYVISTA_STYLE_CHANGES)


class Replacing(unittest.TestCase):
    def volume_with(self, mapper):
        source = vtkRTAnalyticSource()
        mapper.SetInputConnection(source.GetOutputPort())
        volume = vtkVolume()
        volume.SetMapper(mapper)
        volume.GetProperty().GetIsoSurfaceValues().SetValue(0, 100.0)
        volume.GetProperty().GetIsoSurfaceValues().SetValue(1, 200.0)
        return volume

    def isovalues_of(self, volume):
        values = volume.GetProperty().GetIsoSurfaceValues()
        return [values.GetValue(index) for index in range(values.GetNumberOfContours())]

    def test_takes_over_input_and_settings(self):
        old = vtkFixedPointVolumeRayCastMapper()
        volume = self.volume_with(old)
        old.SetScalarModeToUsePointFieldData()
        old.SelectScalarArray("RTData")
        old.CroppingOn()
        old.SetCroppingRegionPlanes(-1.0, 2.0, -3.0, 4.0, -5.0, 6.0)
        old.SetCroppingRegionFlagsToFence()
        plane = vtkPlane()
        old.AddClippingPlane(plane)
        new = replace_mapper(volume)
        self.assertIsInstance(new, vtkTemporalCoherenceVolumeMapper)
        self.assertIs(volume.GetMapper(), new)
        self.assertIs(new.GetInputConnection(0, 0), old.GetInputConnection(0, 0))
        self.assertEqual(new.GetScalarModeAsString(), "UsePointFieldData")
        self.assertEqual(new.GetArrayName(), "RTData")
        self.assertEqual(new.GetArrayAccessMode(), old.GetArrayAccessMode())
        self.assertEqual(new.GetCropping(), 1)
        self.assertEqual(new.GetCroppingRegionPlanes(), (-1.0, 2.0, -3.0, 4.0, -5.0, 6.0))
        self.assertEqual(new.GetCroppingRegionFlags(), old.GetCroppingRegionFlags())
        self.assertIs(new.GetClippingPlanes().GetItem(0), plane)
        self.assertEqual(self.isovalues_of(volume), [100.0, 200.0])
        del old
        self.assertTrue(render(volume).color.any())

    def test_takes_over_a_mask(self):
        old = vtkGPUVolumeRayCastMapper()
        mask = vtkImageData()
        old.SetMaskInput(mask)
        old.SetMaskTypeToBinary()
        old.SetMaskBlendFactor(0.25)
        new = replace_mapper(self.volume_with(old))
        self.assertIs(new.GetMaskInput(), mask)
        self.assertEqual(new.GetMaskType(), old.GetMaskType())
        self.assertEqual(new.GetMaskBlendFactor(), 0.25)

    def test_takes_over_components(self):
        old = vtkSmartVolumeMapper()
        old.SetVectorMode(1)
        old.SetVectorComponent(2)
        new = replace_mapper(self.volume_with(old))
        self.assertEqual(new.GetVectorMode(), new.COMPONENT)
        self.assertEqual(new.GetVectorComponent(), 2)

    def test_isovalues(self):
        volume = self.volume_with(vtkSmartVolumeMapper())
        replace_mapper(volume, [150.0])
        self.assertEqual(self.isovalues_of(volume), [150.0])
        replace_mapper(volume, numpy.array([10.0, 20.0, 30.0]))
        self.assertEqual(self.isovalues_of(volume), [10.0, 20.0, 30.0])

    def test_mistakes(self):
        for wrong in (vtkVolume(), None, vtkSmartVolumeMapper()):
            with self.assertRaisesRegex(TypeError, "set one with volume.SetMapper"):
                replace_mapper(wrong)
        mapper = vtkSmartVolumeMapper()
        volume = self.volume_with(mapper)
        replace_mapper(volume, [20.0])
        volume.SetMapper(mapper)
        for wrong in (5.0, ["a"], "skin", [10.0, None]):
            with self.assertRaisesRegex(TypeError, "must be numbers in a list"):
                replace_mapper(volume, wrong)
            self.assertIs(volume.GetMapper(), mapper)
            self.assertEqual(self.isovalues_of(volume), [20.0])


if __name__ == "__main__":
    unittest.main()
