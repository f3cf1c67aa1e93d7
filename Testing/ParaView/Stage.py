# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""What tests of the plugin share: a view, checks that print a line each, pictures as arrays."""

import os

import numpy as np
from paraview import servermanager
from paraview.simple import *  # noqa: F401,F403 as ParaView's own scripts do
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

LoadPlugin(os.environ["TEMPORAL_ISOSURFACE_PLUGIN"], remote=False, ns=globals())

# The numbers of routes.
ROUTES = {"Cold": 0, "Redisplay": 1, "Reshade": 2, "IsomapLookup": 3, "IsomapBuild": 4,
          "ImageCache": 6, "TimeStep": 7, "Recomposite": 8, "KeepValues": 10,
          "Antialias": 11, "FewerRays": 12, "Refine": 13, "KeepLabels": 14}


def check(is_right, what, found=""):
    """Print a line that run.sh counts."""
    print(f"{'passed' if is_right else 'FAILED'}: {what}{f' ({found})' if found != '' else ''}",
          flush=True)


def make_view(size=(400, 400)):
    """A black view without anything that smooths or decorates the picture."""
    view = CreateView("RenderView")
    view.ViewSize = list(size)
    view.OrientationAxesVisibility = 0
    view.UseFXAA = 0
    view.UseColorPaletteForBackground = 0
    view.BackgroundColorMode = "Single Color"
    view.Background = [0.0, 0.0, 0.0]
    return view


def make_wavelet(last=20):
    """ParaView's analytic image, with 2 * last + 1 points along each axis."""
    return Wavelet(WholeExtent=[-last, last] * 3)


def make_labels(source):
    """Labels 1 to 5, shells of a wavelet, cut open; 0 is around them."""
    return Calculator(Input=source, Function="if(coordsZ>1, 0, floor(max(RTData-130,0)/27))",
                      ResultArrayName="Parts", ResultArrayType="Int")


def show(source, view, isovalues, array=None):
    """Show a source as a Temporal Isosurface in white, of an array or of the first one."""
    display = Show(source, view)
    display.Representation = "Temporal Isosurface"
    display.ColorArrayName = list(array) if array else [None, ""]
    display.LookupTable = None
    display.DiffuseColor = [1.0, 1.0, 1.0]
    display.Isovalues = isovalues
    return display


def samples_of(source, array):
    """Samples [i, j, k] of a source's image, its origin and its spacing."""
    image = servermanager.Fetch(source)
    samples = vtk_to_numpy(image.GetPointData().GetArray(array))
    samples = samples.reshape(image.GetDimensions()[::-1]).transpose(2, 1, 0)
    spacing = np.array(image.GetSpacing())
    return samples, np.array(image.GetOrigin()) + spacing * image.GetExtent()[::2], spacing


def look_from(view, azimuth=30.0, elevation=25.0, zoom=1.4):
    """Look at all that is shown."""
    camera = view.GetActiveCamera()
    camera.SetPosition(0.0, 0.0, 1.0)
    camera.SetFocalPoint(0.0, 0.0, 0.0)
    camera.SetViewUp(0.0, 1.0, 0.0)
    camera.Azimuth(azimuth)
    camera.Elevation(elevation)
    view.ResetCamera()
    camera.Zoom(zoom)


def statistic(display, name):
    """A property that tells of the last frame."""
    display.UpdatePropertyInformation()
    return display.GetPropertyValue(name)


def route_counts(display):
    """How many frames took each route so far."""
    counts = statistic(display, "RouteCounts")
    return {route: counts[number] for route, number in ROUTES.items()}


def read_picture(path):
    """Rows from the bottom, columns, red green blue, as integers."""
    reader = vtkPNGReader()
    reader.SetFileName(path)
    reader.Update()
    image = reader.GetOutput()
    width, height, _ = image.GetDimensions()
    colors = vtk_to_numpy(image.GetPointData().GetScalars())
    return colors.reshape(height, width, -1)[:, :, :3].astype(int)


def take_picture(view, name):
    """Save what the view shows, and give it back."""
    path = os.path.join(os.environ["TEMPORAL_ISOSURFACE_OUTPUT"], name + ".png")
    SaveScreenshot(path, view, ImageResolution=list(view.ViewSize))
    return read_picture(path)


def take_final_picture(view, name):
    """A picture whose edges are smooth, as they become in a view that stands still."""
    for _ in range(3):
        Render(view)
    return take_picture(view, name)


def count_different(a, b, tolerance=0):
    """Pixels in which two pictures differ by more than a tolerance in any colour."""
    return int((np.abs(a - b).max(axis=2) > tolerance).sum())


def check_same(what, pictures, others):
    """No pixel differs."""
    different = sum(count_different(a, b) for a, b in zip(pictures, others))
    check(different == 0, what, f"{different} pixels differ")
