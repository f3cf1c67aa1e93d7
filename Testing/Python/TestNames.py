# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""The names that other people's code uses are there, do what they say and are explained."""

import ast
import pathlib
import re
import subprocess
import sys
import unittest

import vtkTemporalCoherence
from vtkmodules.util.misc import calldata_type
from vtkmodules.util.vtkConstants import VTK_STRING
from vtkmodules.vtkRenderingVolume import vtkVolumeMapper
from vtkTemporalCoherence import (
    vtkTemporalCoherenceDropInMapper, vtkTemporalCoherenceGPUVolumeRayCastMapper,
    vtkTemporalCoherenceObjectFactory, vtkTemporalCoherencePaperMapper, vtkTemporalCoherencePicker,
    vtkTemporalCoherencePresets, vtkTemporalCoherenceRefiner, vtkTemporalCoherenceStatistics,
    vtkTemporalCoherenceView, vtkTemporalCoherenceViewWriter, vtkTemporalCoherenceVolume,
    vtkTemporalCoherenceVolumeMapper)

CLASSES = (
    vtkTemporalCoherenceDropInMapper, vtkTemporalCoherenceGPUVolumeRayCastMapper,
    vtkTemporalCoherenceObjectFactory, vtkTemporalCoherencePaperMapper, vtkTemporalCoherencePicker,
    vtkTemporalCoherencePresets, vtkTemporalCoherenceRefiner, vtkTemporalCoherenceStatistics,
    vtkTemporalCoherenceView, vtkTemporalCoherenceViewWriter, vtkTemporalCoherenceVolume,
    vtkTemporalCoherenceVolumeMapper)

# Set...To..., the value that Get... returns then, and the constant of that value.
CHOICES = {
    "SurfaceMode": {"Crossing": "CROSSING", "Threshold": "THRESHOLD", "Labels": "LABELS"},
    "VectorMode": {"Disabled": "DISABLED", "Magnitude": "MAGNITUDE", "Component": "COMPONENT"},
    "ReuseAccuracy": {"Exact": "EXACT", "Paper": "PAPER"},
    "ImageCachePolicy": {"Latest": "LATEST", "KeyImage": "KEY_IMAGE"},
    "ImageCacheShading": {"Reshade": "RESHADE", "Interpolate": "INTERPOLATE"},
    "IsomapShading": {"Reshade": "RESHADE", "Interpolate": "INTERPOLATE"},
    "Antialiasing": {"WhenStill": "ANTIALIASING_WHEN_STILL", "Off": "ANTIALIASING_OFF", "Always": "ANTIALIASING_ALWAYS"},
}
CONSTANTS = {
    "CROSSING": 0, "THRESHOLD": 1, "LABELS": 2, "DISABLED": -1, "MAGNITUDE": 0, "COMPONENT": 1, "BOUNDED": 0,
    "EXACT": 1, "PAPER": 2, "LATEST": 0, "KEY_IMAGE": 1, "RESHADE": 0, "INTERPOLATE": 1, "ROUTE_COLD": 0, "ROUTE_REDISPLAY": 1,
    "ROUTE_RESHADE": 2, "ROUTE_ISOMAP_LOOKUP": 3, "ROUTE_ISOMAP_BUILD": 4,
    "ROUTE_IMAGE_CACHE": 6, "ROUTE_TIME_STEP": 7, "ROUTE_RECOMPOSITE": 8, "ROUTE_KEEP_VALUES": 10,
    "ROUTE_ANTIALIAS": 11, "ROUTE_FEWER_RAYS": 12, "ROUTE_REFINE": 13,
    "ANTIALIASING_OFF": 0, "ANTIALIASING_WHEN_STILL": 1, "ANTIALIASING_ALWAYS": 2,
    "FRAME_COLOR": 1, "FRAME_DEPTH": 2, "FRAME_NORMALS": 4, "FRAME_ISOVALUE_INDEX": 8, "FRAME_ANSWER": 16,
    "FRAME_ALL": 31, "FrameProgressEvent": 5301,
}
SWITCHES = {
    "ReuseFrames": 1, "SmoothMeshNormals": 0, "Isomap": 1, "SpaceLeaping": 1, "RefineWhenStill": 1, "ColorByAnswer": 0,
    "AutoAdjustSampleDistances": 1, "FixedStepSampling": 0, "WarnOfIsovalues": 1,
    "AmbientOcclusion": 0, "ProgressiveImages": 0,
}
NUMBERS = {
    "KeyImageInterval": (7, 3), "NumberOfCachedImages": (1, 4), "IsomapTolerance": (0.0, 0.25),
    "IsomapMemoryLimit": (256, 64), "IsomapRange": ((1.0, 0.0), (10.0, 20.0)),
    "LabelRadius": (0.0, 2.5), "OutsideLabel": (0, 3), "VectorComponent": (0, 2), "ImageSampleDistance": (1.0, 2.0),
    "MinimumImageSampleDistance": (1.0, 2.0), "MaximumImageSampleDistance": (10.0, 4.0),
}
STATISTICS = (
    "Route", "NumberOfRays", "NumberOfDefiniteHits", "NumberOfDefiniteMisses",
    "NumberOfPossibleHits", "NumberOfTracedRays", "NumberOfFieldSamples", "NumberOfLayers",
    "NumberOfMergedLayers", "IsomapMemory", "NumberOfIsomapKnots", "FrameTime", "TraceTime",
    "QueryTime", "IsomapBuildTime", "ShadeTime", "PresentTime", "MeshSetUp",
    "MeshSetUpTime", "MeshMemory", "MeshPointError", "MeshValueError",
)
ACTIONS = (
    "BuildIsomap", "GetLastFrame", "GetVisibleSurface", "IntersectWithLine", "PickPixel",
    "ClearCache", "MakeImage", "IsOpaque",
)


def explanation(name, member):
    """The text of a docstring below the signatures."""
    text = member.__doc__ or ""
    return " ".join(
        line for line in text.splitlines()
        if name + "(" not in line and not line.strip().startswith("->")).strip()


class Names(unittest.TestCase):
    def setUp(self):
        self.mapper = vtkTemporalCoherenceVolumeMapper()

    def test_is_a_volume_mapper_of_isosurfaces(self):
        self.assertIsInstance(self.mapper, vtkVolumeMapper)
        self.assertEqual(self.mapper.GetBlendMode(), vtkVolumeMapper.ISOSURFACE_BLEND)

    def test_constants(self):
        for name, value in CONSTANTS.items():
            self.assertEqual(getattr(vtkTemporalCoherenceVolumeMapper, name), value, name)

    def test_choices(self):
        for setting, choices in CHOICES.items():
            get = getattr(self.mapper, "Get" + setting)
            self.assertEqual(get(), CONSTANTS[next(iter(choices.values()))], setting)
            for choice, constant in reversed(choices.items()):
                getattr(self.mapper, f"Set{setting}To{choice}")()
                self.assertEqual(get(), CONSTANTS[constant], setting)

    def test_what_is_no_choice(self):
        @calldata_type(VTK_STRING)
        def hear(_mapper, _event, text):
            heard.append(text)

        self.mapper.AddObserver("ErrorEvent", hear)
        for setting, choices in CHOICES.items():
            heard = []
            getattr(self.mapper, f"Set{setting}")(99)
            get = getattr(self.mapper, "Get" + setting)
            self.assertEqual(get(), CONSTANTS[next(iter(choices.values()))], setting)
            self.assertEqual(len(heard), 1, setting)
            self.assertRegex(heard[0], f"{setting} must be .*, not 99; it stays")
            for constant in choices.values():
                self.assertIn(f"{constant} ({CONSTANTS[constant]})", heard[0])

    def test_switches(self):
        for setting, default in SWITCHES.items():
            get = getattr(self.mapper, "Get" + setting)
            self.assertEqual(get(), default, setting)
            getattr(self.mapper, setting + "Off")()
            self.assertEqual(get(), 0, setting)
            getattr(self.mapper, setting + "On")()
            self.assertEqual(get(), 1, setting)
            getattr(self.mapper, "Set" + setting)(0)
            self.assertEqual(get(), 0, setting)

    def test_numbers(self):
        for setting, (default, other) in NUMBERS.items():
            get = getattr(self.mapper, "Get" + setting)
            self.assertEqual(get(), default, setting)
            values = other if isinstance(other, tuple) else (other,)
            getattr(self.mapper, "Set" + setting)(*values)
            self.assertEqual(get(), other, setting)

    def test_names_of_0_2_still_work(self):
        for new, old in (("ReuseFrames", "ImageCache"), ("SmoothMeshNormals", "AveragedGradients")):
            for value in (0, 1):
                getattr(self.mapper, "Set" + old)(value)
                self.assertEqual(getattr(self.mapper, "Get" + new)(), value, old)
                self.assertEqual(getattr(self.mapper, "Get" + old)(), value, old)
            getattr(self.mapper, old + "Off")()
            self.assertEqual(getattr(self.mapper, "Get" + new)(), 0, old)
            getattr(self.mapper, old + "On")()
            self.assertEqual(getattr(self.mapper, "Get" + new)(), 1, old)
        self.mapper.ReleaseReuse()
        self.assertTrue(callable(self.mapper.RenderToImage))

    def test_statistics_before_the_first_frame(self):
        for name in STATISTICS:
            self.assertEqual(getattr(self.mapper.GetStatistics(), "Get" + name)(), 0, name)
            self.assertEqual(getattr(self.mapper, "Get" + name)(), 0, "of 0.2: " + name)
        self.assertEqual(self.mapper.GetStatistics().GetRouteAsString(), "Cold")

    def test_actions_are_wrapped(self):
        for name in ACTIONS:
            self.assertTrue(callable(getattr(self.mapper, name)), name)

    def test_every_method_is_explained(self):
        for wrapped in CLASSES:
            self.assertGreater(len(explanation(wrapped.__name__, wrapped)), 200)
            for name, member in vars(wrapped).items():
                # These two come with vtkTypeMacro, which has no text in VTK's classes either.
                if name.startswith("_") or isinstance(member, (int, type)) or name in (
                        "NewInstance", "SafeDownCast"):
                    continue
                # Since VTK 9.4 wrappers make attributes of Set... and Get..., which name these.
                if not callable(member):
                    continue
                self.assertGreater(
                    len(explanation(name, member)), 30,
                    f"{wrapped.__name__}.{name}: a group of methods begins with //@{{, as VTK's "
                    f"wrappers do not know ///@{{")

    def test_pages_that_are_named_are_there(self):
        named, folder = set(), pathlib.Path(vtkTemporalCoherence.__file__).parent
        for each in (vtkTemporalCoherence, *CLASSES,
                     *(getattr(vtkTemporalCoherence, name) for name in vtkTemporalCoherence.__all__)):
            for text in (each.__doc__, *(member.__doc__ for member in getattr(each, "__dict__", {}).values())):
                named.update(re.findall(r"Documentation/[\w.]*\w", text or ""))
        self.assertIn("Documentation/Mapper.md", named)
        for page in named:
            self.assertIn("# ", (folder / page).read_text(encoding="utf-8"))

    def test_every_function_is_explained(self):
        for name in vtkTemporalCoherence.__all__:
            self.assertGreater(len(getattr(vtkTemporalCoherence, name).__doc__), 100, name)
            self.assertIn(name, dir(vtkTemporalCoherence))
        with self.assertRaisesRegex(AttributeError, "no attribute 'rendr'"):
            vtkTemporalCoherence.rendr


class Types(unittest.TestCase):
    """What editors and checkers of types read."""

    def test_stub_names_all_classes(self):
        folder = pathlib.Path(vtkTemporalCoherence.__file__).parent
        self.assertTrue((folder / "py.typed").exists())
        stub = folder / "vtkTemporalCoherence.pyi"
        if not stub.exists():
            self.skipTest("This VTK has no generator of stubs.")
        named = {
            node.name for node in ast.parse(stub.read_text()).body if isinstance(node, ast.ClassDef)}
        self.assertEqual(named, {wrapped.__name__ for wrapped in CLASSES})


class Imports(unittest.TestCase):
    def run_alone(self, *lines):
        """Lines of a program of its own, which imports nothing but what they do."""
        done = subprocess.run(
            [sys.executable, "-c", "\n".join(lines)], capture_output=True, text=True, check=False)
        self.assertEqual(done.stderr, "")
        return done.stdout.strip()

    def test_renderers_are_those_of_opengl(self):
        self.assertEqual(self.run_alone(
            "from vtkTemporalCoherence import *",
            "from vtkmodules.vtkRenderingCore import vtkRenderer, vtkVolume",
            "print(vtkRenderer().GetClassName(),"
            " type(vtkVolume().GetProperty().GetIsoSurfaceValues()).__name__)"),
            "vtkOpenGLRenderer vtkContourValues")

    def test_without_numpy(self):
        self.assertEqual(self.run_alone(
            "import sys",
            "sys.modules['numpy'] = None",
            "import vtkTemporalCoherence",
            "print(vtkTemporalCoherence.vtkTemporalCoherenceVolumeMapper().GetStatistics().GetRoute())",
            "try: vtkTemporalCoherence.render",
            "except ImportError as error: print(error)"),
            "0\nNumPy is missing: install it (Debian: python3-numpy).")


if __name__ == "__main__":
    unittest.main()
