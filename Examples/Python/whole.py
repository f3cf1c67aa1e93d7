# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""Refuses files that are cut short, of which some of VTK's readers draw what is missing as zeros or as
what memory held before, without a word."""

from __future__ import annotations

import contextlib
import math
import os

from vtkmodules.vtkCommonCore import vtkDataArray
from vtkmodules.vtkCommonExecutionModel import vtkExtentSplitter
from vtkmodules.vtkIOXMLParser import vtkXMLDataParser

from medical import meta_fields
from mistakes import quoted
from trial import damaged


def require_whole(path: str, reader) -> str:
    """An error if a file is not whole. A sentence if it has more than its header tells, or if that cannot
    be known; else none."""
    if path.lower().endswith((".mhd", ".mha")):
        return _require_whole_meta(path, reader)
    if path.lower().endswith((".vti", ".vtu", ".vts")):
        _require_whole_xml(path)
    return ""


def _require_whole_xml(path: str) -> None:
    with open(path, "rb") as file:
        file.seek(-min(os.path.getsize(path), 1024), os.SEEK_END)
        has_end = b"</VTKFile" in file.read()
    parser = vtkXMLDataParser()
    parser.SetFileName(path)
    if not has_end or not parser.Parse():
        raise damaged(path, "it does not end as XML of VTK does")
    for grid in _nested(parser.GetRootElement()):
        _require_covered(path, grid)


def _nested(element) -> list:
    return [element.GetNestedElement(index) for index in range(element.GetNumberOfNestedElements())]


def _require_covered(path: str, grid) -> None:
    """VTK's reader leaves what no piece has as it was in memory."""
    extent, splitter, has_cells = 6 * [0], vtkExtentSplitter(), False
    for index, piece in enumerate(_nested(grid)):
        if piece.GetVectorAttribute("Extent", 6, extent) == 6:
            splitter.AddExtentSource(index, 0, extent)
        cells = piece.FindNestedElementWithName("CellData")
        has_cells = has_cells or bool(cells and cells.GetNumberOfNestedElements())
    splitter.SetPointMode(not has_cells)
    if grid.GetVectorAttribute("WholeExtent", 6, extent) == 6 and extent != 3 * [0, -1]:
        splitter.AddExtent(extent)
    if not splitter.ComputeSubExtents():
        raise damaged(path, "it has pieces that do not cover its WholeExtent")


def _require_whole_meta(path: str, reader) -> str:
    reader.UpdateInformation()
    fields, ends = meta_fields(path), reader.GetDataExtent()
    size = [end - begin + 1 for begin, end in zip(ends[::2], ends[1::2])]
    name = fields.get("ElementDataFile", "")
    if name.startswith("LIST") or "%" in name:
        if _slices(path, name) < size[2]:
            raise damaged(path, "it names fewer slices than its DimSize tells of")
        return ""  # MetaIO tells of those that are missing or short
    is_local = name.lower() == "local"
    file = path if is_local else _file_of_samples(path, name)
    is_zipped = not is_local and not file.endswith(name)
    is_text = not is_zipped and fields.get("BinaryData", "T")[:1] not in "Tt1"
    is_compressed = is_zipped or (not is_text and fields.get("CompressedData", "F")[:1] in "Tt1")
    channels = reader.GetNumberOfScalarComponents()
    of_number = vtkDataArray.GetDataTypeSize(reader.GetDataScalarType())
    first = _end_of_header(path) if is_local else 0  # of the places where samples may begin
    is_at_end = reader.GetHeaderSize() >= 1 << 31  # which stands for -1
    begin = first if is_at_end else reader.GetHeaderSize() or first
    with open(file, "rb") as samples:
        samples.seek(begin)
        there = of_number * len(_numbers(samples.read().split())) if is_text else os.path.getsize(file) - begin
    more = there - of_number * channels * math.prod(size)
    if there == more or begin < first or (not is_compressed and more < 0):
        raise damaged(path, f"{quoted(file)} has fewer samples than the header tells of")
    if is_text and channels > 1:
        raise damaged(path, "VTK does not read several channels as text")
    if is_compressed and not any(_numbers([fields.get("CompressedDataSize", "")])):
        return f"{quoted(path)} has no CompressedDataSize, by which one would see whether it is whole: add that."
    if more > 0 and not is_compressed and not is_text and not is_at_end:
        return f"{quoted(file)} has {more} bytes more than its header tells of, which are not drawn: check DimSize " \
            "and ElementType."
    return ""


def _numbers(words: list) -> list[float]:
    """What words stand for, up to one that is no number."""
    numbers: list[float] = []
    with contextlib.suppress(ValueError):
        for word in words:
            numbers.append(float(word))
    return numbers


def _end_of_header(path: str) -> int:
    with open(path, "rb") as file:
        next((line for line in file if line.lstrip().startswith(b"ElementDataFile")), None)
        return file.tell()


def _slices(path: str, words: str) -> float:
    """How many files of slices a header lists, or tells of by a pattern; infinite where it tells no end, or
    where a file has several slices."""
    pattern, *numbers = words.split()
    first, last, step = (_numbers(numbers) + 3 * [math.nan])[:3]
    if pattern != "LIST" or first > 2:
        return math.inf if math.isnan(last) else (last - first) // (math.floor(step) if step >= 1 else 1) + 1
    with open(path, "rb") as file:
        file.seek(_end_of_header(path))
        return sum(line.endswith(b"\n") and len(line) > 1 for line in file)  # as MetaIO counts them


def _file_of_samples(path: str, name: str) -> str:
    file = os.path.join(os.path.dirname(path), name)
    for suffix in ("", ".gz", ".Z"):
        if os.path.isfile(file + suffix):
            return file + suffix
    raise damaged(path, f"it names {quoted(file)}, which is not there")
