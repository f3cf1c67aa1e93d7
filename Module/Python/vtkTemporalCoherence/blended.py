# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""Blended volumes in one call: half transparent ones, and maxima."""

from __future__ import annotations

import math
from typing import Any, Sequence

from vtkmodules.vtkCommonCore import vtkBitArray, vtkDataArray, vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkImageData, vtkRectilinearGrid

from .given_data import arrays_of, chosen_array, data_object, finite_number
from .mapper_support import mapper_of
from .pictures import PicturedVolume
from .vtkTemporalCoherence import vtkTemporalCoherencePresets

#: Names of looks: those of Hounsfield units, and the one that suits data of any unit.
PRESETS = tuple(vtkTemporalCoherencePresets.GetPresetName(index)
                for index in range(vtkTemporalCoherencePresets.GetNumberOfPresets()))
_PLAIN = "mr"

#: Percentiles of the samples at the ends of the look without a preset, and of maxima, which lie among
#: the largest samples.
_ENDS, _ENDS_OF_MAXIMA = (1.0, 99.5), (1.0, 99.95)


class BlendedVolume(PicturedVolume):
    """What composite() and maximum() make: a volume whose mapper blends samples along each ray.

    GetMapper() and GetProperty() lead to all settings.
    """


def composite(
    data: Any,
    preset: str | None = None,
    scalars: str | None = None,
    *,
    shift: float = 0.0,
    opacity: float = 1.0,
    lighting: bool = True,
    spacing: Sequence[float] | None = None,
    origin: Sequence[float] | None = None,
) -> BlendedVolume:
    """Make a half transparent volume, of which colours and opacities are functions of the values.

        composite(array, "ct bone", spacing=(0.5, 0.5, 1.0)).save("bone.png")

    data             an image, rectilinear grid or array: see isosurface()
    preset           "ct bone", "ct soft tissue" or "ct vessels", for values in Hounsfield units; "mr",
                     which is None, too: rarer, larger values are more opaque, whatever their unit
    scalars          name of the array at the points. None: the active scalars, or else the first one
    shift            added to the values of the preset, in their unit
    opacity          factor of all opacities, above 0
    lighting         False: colours without light
    spacing, origin  of a plain array, in the order x, y, z

    Raises TypeError for data of another kind, ValueError for other mistakes.
    """
    if not (preset is None or isinstance(preset, str)):
        raise TypeError(f"A preset is a name, not {type(preset).__name__}: {', '.join(PRESETS)}.")
    if preset is not None and preset not in PRESETS:
        raise ValueError(f"There is no preset {preset!r}, only {', '.join(PRESETS)}.")
    if not 0.0 < finite_number("opacity", opacity) < math.inf:
        raise ValueError(f"The opacity must be a finite factor above 0, not {opacity!r}.")
    shift = finite_number("shift", shift)
    volume, samples = _volume(data, scalars, spacing, origin)
    name = preset or _PLAIN
    low, high = 0.0, 1.0
    if not vtkTemporalCoherencePresets.GetPresetIsInHounsfieldUnits(name):
        low, high = _ends(samples, _ENDS, leaves_out_least=True)
    look = volume.GetProperty()
    vtkTemporalCoherencePresets.Apply(name, look, low + shift, high - low)
    opacities, node = look.GetScalarOpacity(), [0.0] * 4
    for index in range(opacities.GetSize()):
        opacities.GetNodeValue(index, node)
        node[1] = 1.0 - (1.0 - node[1]) ** opacity
        opacities.SetNodeValue(index, node)
    look.SetShade(lighting)
    volume.GetMapper().SetBlendModeToComposite()
    return volume


def maximum(
    data: Any,
    scalars: str | None = None,
    *,
    window: float | None = None,
    level: float | None = None,
    spacing: Sequence[float] | None = None,
    origin: Sequence[float] | None = None,
) -> BlendedVolume:
    """Make a volume that shows the largest value on each ray, from black to white.

    data             an image, rectilinear grid or array: see isosurface()
    scalars          name of the array at the points. None: the active scalars, or else the first one
    window, level    the values from black to white, and the one in their middle. None: so that
                     nearly all samples lie between
    spacing, origin  of a plain array, in the order x, y, z

    Raises TypeError for data of another kind, ValueError for other mistakes.
    """
    if window is not None and not finite_number("window", window) > 0.0:
        raise ValueError(f"The window must be larger than 0, not {window!r}.")
    level = level if level is None else finite_number("level", level)
    volume, samples = _volume(data, scalars, spacing, origin)
    if window is None or level is None:
        low, high = _ends(samples, _ENDS_OF_MAXIMA, leaves_out_least=False)
        window = high - low if window is None else float(window)
        level = 0.5 * (low + high) if level is None else level
    vtkTemporalCoherencePresets.ApplyWindowLevel(volume.GetProperty(), window, level)
    volume.GetMapper().SetBlendModeToMaximumIntensity()
    return volume


def _volume(
    data: Any, scalars: str | None, spacing: Sequence[float] | None, origin: Sequence[float] | None
) -> tuple[BlendedVolume, Any]:
    """A volume of some data, and its samples as a NumPy array."""
    data = data_object(data, spacing, origin)
    if not isinstance(data, (vtkImageData, vtkRectilinearGrid)):
        raise TypeError(
            f"Values are blended in images and rectilinear grids, not in {type(data).__name__}: "
            f"resample it (vtkResampleToImage, or sample() of PyVista), or draw isosurface().")
    name, place = chosen_array(data, scalars, ("point",))
    array = arrays_of(data, name, place)[0]
    if array.GetNumberOfComponents() > 1:
        raise ValueError(
            f"The array {name or 'without a name'!r} has {array.GetNumberOfComponents()} components: "
            f"give an array of one.")
    mapper = mapper_of(data, name, place)
    volume = BlendedVolume()
    volume.SetMapper(mapper)
    look = volume.GetProperty()
    look.SetInterpolationTypeToLinear()
    look.SetScalarOpacityUnitDistance(_unit_distance(data))
    return volume, _as_numpy(array)


def _as_numpy(array: vtkDataArray) -> Any:
    """The numbers of an array; those of bits are copied, as NumPy has no bits."""
    from vtkmodules.util.numpy_support import vtk_to_numpy
    if isinstance(array, vtkBitArray):
        bytes_of_bits = vtkUnsignedCharArray()
        bytes_of_bits.DeepCopy(array)
        array = bytes_of_bits
    return vtk_to_numpy(array)


def _unit_distance(data: vtkDataObject) -> float:
    """The mean distance of samples: opacities are those of a step between samples."""
    if isinstance(data, vtkImageData):
        return sum(data.GetSpacing()) / 3.0
    bounds, dimensions = data.GetBounds(), data.GetDimensions()
    return sum((bounds[2 * axis + 1] - bounds[2 * axis]) / (dimensions[axis] - 1)
               for axis in range(3)) / 3.0


def _ends(
    samples: Any, percentiles: tuple[float, float], leaves_out_least: bool
) -> tuple[float, float]:
    """The values of two percentiles, in order.

    leaves_out_least  samples of the least value do not count, as it is that of air or nothing
    """
    import numpy
    most = 1_000_000
    if len(samples) > most:  # the same ones each time
        samples = samples[numpy.random.default_rng(0).integers(0, len(samples), most)]
    finite = samples[numpy.isfinite(samples)].astype(float)
    if not finite.size:
        return 0.0, 1.0
    least, largest = float(finite.min()), float(finite.max())
    inside = finite[finite > least] if leaves_out_least and largest > least else finite
    low, high = (float(end) for end in numpy.percentile(inside, percentiles))
    if not high > low:
        low, high = least, largest
    return (low, high) if high > low else (low, low + max(abs(low), 1.0))
