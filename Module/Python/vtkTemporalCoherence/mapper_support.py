# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""Mappers for data, and in place of other volume mappers."""

from __future__ import annotations

from typing import Iterable

from vtkmodules.vtkCommonDataModel import vtkDataObject
from vtkmodules.vtkRenderingCore import vtkVolume
from vtkmodules.vtkRenderingVolume import vtkVolumeMapper

from .vtkTemporalCoherence import vtkTemporalCoherenceVolumeMapper


def replace_mapper(
    volume: vtkVolume, isovalues: Iterable[float] | None = None
) -> vtkTemporalCoherenceVolumeMapper:
    """Have a volume drawn by a new vtkTemporalCoherenceVolumeMapper, and return that mapper.

    volume     its mapper is another vtkVolumeMapper, for example PyVista's. The new mapper takes
               over its input, choice of scalars, cropping, clipping planes and mask
    isovalues  in the unit of the scalars that the mapper has as input, which other libraries may
               have scaled. None: those that the volume's property has

    Raises TypeError if there is no such mapper or these are no numbers; the volume is then left
    as it is.
    """
    old = volume.GetMapper() if isinstance(volume, vtkVolume) else None
    if not isinstance(old, vtkVolumeMapper):
        raise TypeError(
            "The mapper of a vtkVolume can be replaced where it has one that is a vtkVolumeMapper: "
            "set one with volume.SetMapper().")
    if isovalues is not None:
        try:
            isovalues = [float(isovalue) for isovalue in isovalues]
        except (TypeError, ValueError):
            raise TypeError(
                f"Isovalues must be numbers in a list, not {isovalues!r}: give for example [150.0]."
            ) from None
    mapper = vtkTemporalCoherenceVolumeMapper()
    if old.GetNumberOfInputConnections(0) > 0:
        mapper.SetInputConnection(old.GetInputConnection(0, 0))
    _copy_scalar_choice(old, mapper)
    mapper.SetCropping(old.GetCropping())
    mapper.SetCroppingRegionPlanes(old.GetCroppingRegionPlanes())
    mapper.SetCroppingRegionFlags(old.GetCroppingRegionFlags())
    if old.GetClippingPlanes():
        mapper.SetClippingPlanes(old.GetClippingPlanes())
    # A vtkSmartVolumeMapper or vtkFixedPointVolumeRayCastMapper has no mask.
    if hasattr(old, "GetMaskInput"):
        mapper.SetMaskInput(old.GetMaskInput())
        mapper.SetMaskType(old.GetMaskType())
        mapper.SetMaskBlendFactor(old.GetMaskBlendFactor())
    volume.SetMapper(mapper)

    if isovalues is not None:
        contours = volume.GetProperty().GetIsoSurfaceValues()
        contours.SetNumberOfContours(0)
        for index, isovalue in enumerate(isovalues):
            contours.SetValue(index, isovalue)
    return mapper


def _copy_scalar_choice(old: vtkVolumeMapper, new: vtkTemporalCoherenceVolumeMapper) -> None:
    getattr(new, "SetScalarModeTo" + old.GetScalarModeAsString())()
    name = old.GetArrayName()
    new.SelectScalarArray(old.GetArrayId() if name is None else name)
    new.SetArrayAccessMode(old.GetArrayAccessMode())
    # vtkSmartVolumeMapper has these by the same names and values.
    if hasattr(old, "GetVectorMode"):
        new.SetVectorMode(old.GetVectorMode())
        new.SetVectorComponent(old.GetVectorComponent())


def mapper_of(data: vtkDataObject, name: str | None, place: str) -> vtkTemporalCoherenceVolumeMapper:
    """A mapper that draws an array of some data.

    name, place  what chosen_array() gives
    """
    mapper = vtkTemporalCoherenceVolumeMapper()
    mapper.SetInputDataObject(data)
    if name is None:
        getattr(mapper, f"SetScalarModeToUse{place.capitalize()}Data")()
    else:
        getattr(mapper, f"SetScalarModeToUse{place.capitalize()}FieldData")()
        mapper.SelectScalarArray(name)
    return mapper
