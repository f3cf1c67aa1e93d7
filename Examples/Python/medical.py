# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""What files of scanners tell and VTK's readers do not apply: what values the samples stand for, and
where they lie."""

from __future__ import annotations

import math
import re

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkMetaImageReader, vtkNIFTIImageReader

from mistakes import UserError, quoted

MOST_HEADER = 1 << 16  # bytes of a header of MetaImage
#: VTK's reader takes a long, which has 4 bytes there, for one of 8, and others for none.
META_TYPES = {
    "MET_CHAR", "MET_UCHAR", "MET_SHORT", "MET_USHORT", "MET_INT", "MET_UINT", "MET_FLOAT", "MET_DOUBLE",
    "MET_CHAR_ARRAY", "MET_UCHAR_ARRAY", "MET_SHORT_ARRAY", "MET_USHORT_ARRAY", "MET_INT_ARRAY",
    "MET_UINT_ARRAY"}
MOST_WHOLE = 1 << 24  # up to which floats hold all whole numbers
FLOAT_STEPS = 1 << 22  # from 0, which floats tell apart
NIFTI_COLORS = (128, 2304)  # types of RGB and RGBA


def meta_fields(path: str) -> dict[str, str]:
    """The fields of a header of MetaImage, up to the one that names the samples."""
    with open(path, "rb") as file:
        head = file.read(MOST_HEADER).decode("latin-1")
    fields: dict[str, str] = {}
    for line in head.split("\n"):
        # MetaIO takes ":" for "=", too.
        key, *rest = re.split("[=:]", line, maxsplit=1)
        fields[key.strip()] = rest[0].strip("=: \t\r") if rest else ""
        if "ElementDataFile" in fields:
            break
    return fields


def require_known_type(path: str) -> None:
    """Refuse a MetaImage whose samples VTK does not read."""
    kind = meta_fields(path).get("ElementType", "")
    if kind not in META_TYPES:
        raise UserError(
            f"{quoted(path)} could not be read as an image: VTK does not read samples of the type "
            f"{quoted(kind)}; save them as MET_INT, MET_FLOAT or MET_DOUBLE.")


def choose_time_step(reader, path: str, image: vtkImageData, time_step: int) -> None:
    """Keep one of the volumes that NIfTI's reader hands over as components; other files have one."""
    steps = max(1, reader.GetTimeDimension()) if isinstance(reader, vtkNIFTIImageReader) else 1
    if time_step > steps:
        raise UserError(
            f"{quoted(path)} has {steps} time steps: choose one of these instead of {time_step}.")
    if time_step > 1:
        scalars = image.GetPointData().GetScalars()
        samples = vtk_to_numpy(scalars).reshape(image.GetNumberOfPoints(), steps, -1)
        _set_samples(image, samples[:, time_step - 1])


def apply_header(reader, path: str, image: vtkImageData) -> None:
    """Samples become the values that they stand for, and lie where the header says."""
    if isinstance(reader, vtkMetaImageReader):
        _rescale(image, reader.GetRescaleSlope(), reader.GetRescaleOffset())
        fields = meta_fields(path)
        text = next(
            (fields[key] for key in ("TransformMatrix", "Rotation", "Orientation") if key in fields), None)
        if text is not None and reader.GetFileDimensionality() == 3:
            _set_direction(path, text, image)
    elif isinstance(reader, vtkNIFTIImageReader):
        header = reader.GetNIFTIHeader()
        if header is None or header.GetDataType() not in NIFTI_COLORS:
            _rescale(image, reader.GetRescaleSlope(), reader.GetRescaleIntercept())
        # Among the patient's axes: the scanner's (q) or, first, those of another image (s).
        matrix = next((matrix for matrix in (reader.GetSFormMatrix(), reader.GetQFormMatrix())
                       if matrix and abs(matrix.Determinant()) > 0.0), None)
        if matrix:
            image.SetDirectionMatrix([matrix.GetElement(i, j) for i in range(3) for j in range(3)])
            image.SetOrigin([matrix.GetElement(i, 3) for i in range(3)])


def _rescale(image: vtkImageData, slope: float, offset: float) -> None:
    scalars = image.GetPointData().GetScalars()
    is_none = slope == 0.0 or (slope, offset) == (1.0, 0.0)
    if is_none or not scalars or not (math.isfinite(slope) and math.isfinite(offset)):
        return
    samples = vtk_to_numpy(scalars)
    with numpy.errstate(all="ignore"):
        values = samples.astype(numpy.float64) * slope + offset
    is_whole = float(slope).is_integer() and float(offset).is_integer()
    most = MOST_WHOLE if is_whole else FLOAT_STEPS * abs(slope)
    if samples.dtype.kind != "f" and abs(values).max(initial=0.0) <= most:
        values = values.astype(numpy.float32)
    _set_samples(image, values)


def _set_samples(image: vtkImageData, values: numpy.ndarray) -> None:
    array = numpy_to_vtk(values, deep=1)
    array.SetName(image.GetPointData().GetScalars().GetName())
    image.GetPointData().SetScalars(array)


def _set_direction(path: str, text: str, image: vtkImageData) -> None:
    """A row of TransformMatrix tells where an axis of the image points to."""
    try:
        numbers = [float(word) for word in text.split()]
    except ValueError:
        numbers = []
    if len(numbers) != 9:
        raise UserError(
            f"{quoted(path)} could not be read as an image: its TransformMatrix has not 9 numbers; "
            f"correct it.")
    image.SetDirectionMatrix([numbers[3 * axis + i] for i in range(3) for axis in range(3)])
