# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""Isosurfaces of VTK images and grids, ray cast on the CPU, re-using earlier frames.

    from vtkTemporalCoherence import vtkTemporalCoherenceVolumeMapper
    mapper = vtkTemporalCoherenceVolumeMapper()    # was: vtkGPUVolumeRayCastMapper()

The mapper goes into a vtkVolume as any other. It draws the isosurfaces of
volume.GetProperty().GetIsoSurfaceValues(). help(vtkTemporalCoherenceVolumeMapper) tells the rest.

    isosurface             isosurfaces of any grid or array: a picture, or an actor for plotters
    composite, maximum     half transparent volumes and maxima, in the same way
    segmentation           surfaces of labels, with names and colours
    use_everywhere         let it draw the isosurfaces of VTK's own mappers, made from now on
    replace_mapper         put it into a vtkVolume that has another mapper
    save_view              a picture for every isovalue, as one page for browsers
    numpy_to_image         a volume from a NumPy array
    render                 a picture as NumPy arrays, without a window or display
    planes, Planes         the arrays of the last frame: colour, depth, normals and more
    write_png              a picture into a file

The last four are those of vtkTemporalCoherence.numpy_support. They need NumPy, and so do arrays,
pictures, blended volumes and segmentations. What the first four make is a PicturedVolume, and its
picture a Picture.

Pages that are named here, such as Documentation/Mapper.md, lie in the folder of this package.

Arguments that the wrapped methods fill are lists, but for t, which is a reference:

    position, normal, index = [0.0] * 3, [0.0] * 3, [-1]
    if mapper.PickPixel(x, y, position, normal, index): ...
    block = [0]  # or None
    cell = mapper.PickCell(x, y, block)
    t = vtkmodules.vtkCommonCore.reference(0.0)
    if mapper.IntersectWithLine(volume, p1, p2, t, position, normal, index): ...
"""

from typing import TYPE_CHECKING

# What the wrapped classes take and return, and what makes vtkRenderer a renderer. No display is
# needed for that.
import vtkmodules.vtkCommonDataModel  # noqa: F401
import vtkmodules.vtkCommonMisc  # noqa: F401
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401

from .blended import BlendedVolume, composite, maximum
from .everywhere import use_everywhere
from .isosurfaces import IsosurfaceVolume, isosurface
from .large_volumes import open_volume
from .mapper_support import replace_mapper
from .pictures import Picture, PicturedVolume
from .saved_views import save_view
from .segmentations import SegmentationVolume, segmentation
from .version import __version__
from .vtkTemporalCoherence import (
    vtkTemporalCoherenceBrickSource,
    vtkTemporalCoherenceDropInMapper,
    vtkTemporalCoherenceGPUVolumeRayCastMapper,
    vtkTemporalCoherenceObjectFactory,
    vtkTemporalCoherencePaperMapper,
    vtkTemporalCoherencePicker,
    vtkTemporalCoherencePresets,
    vtkTemporalCoherenceRefiner,
    vtkTemporalCoherenceStatistics,
    vtkTemporalCoherenceView,
    vtkTemporalCoherenceViewWriter,
    vtkTemporalCoherenceVolume,
    vtkTemporalCoherenceVolumeMapper,
)

if TYPE_CHECKING:  # types, without NumPy
    from .numpy_support import Planes, numpy_to_image, planes, render, write_png

_OF_NUMPY_SUPPORT = ("Planes", "numpy_to_image", "planes", "render", "write_png")

__all__ = [
    "BlendedVolume",
    "IsosurfaceVolume",
    "Picture",
    "PicturedVolume",
    "SegmentationVolume",
    "__version__",
    "composite",
    "isosurface",
    "maximum",
    "open_volume",
    "replace_mapper",
    "save_view",
    "segmentation",
    "use_everywhere",
    "vtkTemporalCoherenceBrickSource",
    "vtkTemporalCoherenceDropInMapper",
    "vtkTemporalCoherenceGPUVolumeRayCastMapper",
    "vtkTemporalCoherenceObjectFactory",
    "vtkTemporalCoherencePaperMapper",
    "vtkTemporalCoherencePicker",
    "vtkTemporalCoherencePresets",
    "vtkTemporalCoherenceRefiner",
    "vtkTemporalCoherenceStatistics",
    "vtkTemporalCoherenceView",
    "vtkTemporalCoherenceViewWriter",
    "vtkTemporalCoherenceVolume",
    "vtkTemporalCoherenceVolumeMapper",
    *_OF_NUMPY_SUPPORT,
]


def __getattr__(name):
    if name not in _OF_NUMPY_SUPPORT:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    from . import numpy_support
    return getattr(numpy_support, name)


def __dir__():
    return sorted({*globals(), *__all__})
