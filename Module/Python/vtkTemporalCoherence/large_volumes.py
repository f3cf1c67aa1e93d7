# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""Volumes whose samples are read when they are needed: larger than memory, or slow to read as a whole."""

from __future__ import annotations

import os
from typing import Any, Sequence

from vtkmodules.util.misc import calldata_type
from vtkmodules.util.vtkConstants import VTK_STRING
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm

from .vtkTemporalCoherence import vtkTemporalCoherenceBrickSource

#: VTK's numbers of the types of raw samples, by NumPy's names.
_TYPES = {"int8": 15, "uint8": 3, "int16": 4, "uint16": 5, "int32": 6, "uint32": 7, "int64": 16,
          "uint64": 17, "float32": 10, "float64": 11}

#: NumPy's short names, without the byte order.
_OF_LETTERS = {"i1": "int8", "u1": "uint8", "i2": "int16", "u2": "uint16", "i4": "int32", "u4": "uint32",
               "i8": "int64", "u8": "uint64", "f4": "float32", "f8": "float64"}


def open_volume(
    path: str | os.PathLike | None = None, *, reader: vtkAlgorithm | None = None, level: int = 0,
    channel: int = 0, time_point: int = 0, array: str = "", shape: Sequence[int] | None = None,
    dtype: Any = "uint8", big_endian: bool = False, header_size: int = 0,
    spacing: Sequence[float] = (1.0, 1.0, 1.0), memory_limit: int | None = None,
    ranges_folder: str | os.PathLike | None = None,
) -> vtkImageData:
    """Open a volume without reading it. The image reads samples when a mapper needs them.

    path           a folder of OME-Zarr, an HDF5 file of Imaris or BigDataViewer, a .mhd, .nrrd or .vti
                   with raw data, or raw samples
    reader         instead, a reader of VTK that gives parts of its image
    level          of resolution; 0 is the finest
    channel, time_point, array   which volume of a file with several
    shape, dtype, big_endian, header_size, spacing   of raw samples: shape is (z, y, x), spacing (x, y, z)
    memory_limit   bytes that samples may take; None: 1.5 GiB
    ranges_folder  of the file with value ranges; None: beside the volume, else a folder for caches

    The first opening reads the volume once. Raises OSError if the volume cannot be opened.
    """
    if level < 0 or channel < 0 or time_point < 0:
        raise ValueError("level, channel and time_point count from 0.")
    if memory_limit is not None and memory_limit <= 0:
        raise ValueError(f"memory_limit must be a positive number of bytes, not {memory_limit}.")
    source = vtkTemporalCoherenceBrickSource()
    if path is not None:
        source.SetFileName(os.fspath(path))
    source.SetReader(reader)
    source.SetLevel(level)
    source.SetChannel(channel)
    source.SetTimePoint(time_point)
    source.SetArrayName(array)
    if shape is not None:
        text = getattr(dtype, "__name__", str(dtype))
        name = _OF_LETTERS.get(text.lstrip("<>=|"), text)
        if name not in _TYPES:
            raise ValueError(f"Samples may be of the types {', '.join(_TYPES)}, not {text}.")
        big_endian = big_endian or text.startswith(">")
        if len(shape) != 3 or not all(float(n).is_integer() for n in shape):
            raise ValueError(f"shape must be three whole numbers (z, y, x), not {tuple(shape)}.")
        z, y, x = map(int, shape)
        source.SetRawLayout(x, y, z, _TYPES[name], header_size, big_endian)
        source.SetRawSpacing(*spacing)
    if memory_limit is not None:
        source.SetMemoryLimit(memory_limit)
    if ranges_folder is not None:
        source.SetRangesFolder(os.fspath(ranges_folder))
    errors: list[str] = []

    @calldata_type(VTK_STRING)
    def on_error(_caller, _event, text):
        errors.append(text)

    for teller in (source, source.GetExecutive()):
        teller.AddObserver("ErrorEvent", on_error)
    source.Update()
    if errors:
        raise OSError(_sentence_of(errors[0]))
    return source.GetOutput()


def _sentence_of(text: str) -> str:
    """What an error of VTK says, without the place in the code."""
    return text.partition("): ")[2].strip() or text.strip()
