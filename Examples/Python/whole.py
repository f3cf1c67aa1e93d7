# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""Refuses files that end before their headers say, of which some of VTK's readers draw what is missing
as zeros or as what memory held before, without a word."""

from __future__ import annotations

import base64
import contextlib
import math
import mmap
import os
import zlib
from typing import Iterator

import numpy
from vtkmodules.vtkIOXMLParser import vtkXMLDataParser

from medical import meta_fields
from mistakes import UserError, quoted

META_BYTES = {"CHAR": 1, "SHORT": 2, "INT": 4, "FLOAT": 4, "DOUBLE": 8}
MOST_PLACES = 1 << 26  # between ends of pieces


def require_whole(path: str) -> str:
    """An error if a file is not whole. A sentence if it has more than its header tells; else none."""
    if path.lower().endswith((".mhd", ".mha")):
        return _require_whole_meta(path)
    if path.lower().endswith((".vti", ".vtu", ".vts")):
        _require_whole_xml(path)
    return ""


def _damaged(path: str, reason: str) -> UserError:
    return UserError(
        f"{quoted(path)} could not be read as an image or a grid: {reason}; check that the file is whole.")


# --- VTK's XML ----------------------------------------------------------------------------------

def _elements(element) -> Iterator:
    yield element
    for index in range(element.GetNumberOfNestedElements()):
        yield from _elements(element.GetNestedElement(index))


def _require_whole_xml(path: str) -> None:
    parser = vtkXMLDataParser()
    parser.SetFileName(path)
    if not parser.Parse() or not parser.GetRootElement():
        return  # of which the reader tells
    root = parser.GetRootElement()
    with open(path, "rb") as file, contextlib.closing(
            mmap.mmap(file.fileno(), 0, access=mmap.ACCESS_READ)) as data:
        for element in _elements(root):
            if element.GetName() in ("DataArray", "Array") and not root.GetAttribute("compressor"):
                _require_array(path, element, parser, data)
    for element in _elements(root):
        if element.GetAttribute("WholeExtent"):
            _require_covered(path, element)


def _require_array(path: str, array, parser: vtkXMLDataParser, data: mmap.mmap) -> None:
    """Of arrays that are not compressed VTK's reader takes as many bytes as there are."""
    root = parser.GetRootElement()
    is_raw = False
    if array.GetAttribute("format") == "appended":
        encoding = root.FindNestedElementWithName("AppendedData")
        is_raw = encoding is not None and encoding.GetAttribute("encoding") == "raw"
        begin = parser.GetAppendedDataPosition() + int(float(array.GetAttribute("offset") or 0))
        # Raw bytes may hold the same text by chance, but not where the file ends.
        end = data.rfind(b"</AppendedData", max(len(data) - 4096, 0))
        end = len(data) if end < 0 else end
    elif array.GetAttribute("format") == "binary":
        begin = data.find(b">", array.GetXMLByteIndex()) + 1
        end = data.find(b"<", begin)
    else:
        return
    size = 8 if root.GetAttribute("header_type") == "UInt64" else 4
    order = "big" if root.GetAttribute("byte_order") == "BigEndian" else "little"
    head = data[begin:min(begin + 256, end)]
    blanks = 0
    if not is_raw:
        blanks = len(head) - len(head.lstrip())
        head = _decoded(head.lstrip()[:12])
    there = size + int.from_bytes(head[:size], order)
    needed = there if is_raw else blanks + 4 * -(-there // 3)
    if len(head) < size or begin + needed > end:
        raise _damaged(path, f"its array {quoted(array.GetAttribute('Name') or '')} ends before its header says")


def _decoded(text: bytes) -> bytes:
    try:
        return base64.b64decode(text[:len(text) // 4 * 4])
    except ValueError:
        return b""


def _extent(element, name: str) -> list[int] | None:
    try:
        numbers = [int(word) for word in (element.GetAttribute(name) or "").split()]
    except ValueError:
        return None
    return numbers if len(numbers) == 6 else None


def _require_covered(path: str, grid) -> None:
    """A reader leaves samples that no piece has as they are in memory."""
    whole = _extent(grid, "WholeExtent")
    nested = [grid.GetNestedElement(index) for index in range(grid.GetNumberOfNestedElements())]
    pieces = [_extent(piece, "Extent") for piece in nested if piece.GetName() == "Piece"]
    pieces = [piece for piece in pieces if piece]
    has_cells = any(element.GetName() == "CellData" and element.GetNumberOfNestedElements()
                    for element in _elements(grid))
    for more, what in ((1, "point"), (0, "cell")):
        hole = _hole_in(whole, pieces, more) if whole and pieces and (more or has_cells) else None
        if hole:
            raise _damaged(path, f"none of its pieces has the {what} {hole} of its extent")


def _hole_in(whole: list[int], boxes: list[list[int]], more: int) -> tuple[int, ...] | None:
    """A place that no box holds. Along an axis, places between neighbouring ends lie in the same ones."""
    ends = [numpy.unique(numpy.clip(
        [whole[2 * axis], whole[2 * axis + 1] + more, *(box[2 * axis] for box in boxes),
         *(box[2 * axis + 1] + more for box in boxes)], whole[2 * axis], whole[2 * axis + 1] + more))
            for axis in range(3)]
    if math.prod(len(places) for places in ends) > MOST_PLACES:
        return None
    is_held = numpy.zeros([len(places) - 1 for places in ends], bool)
    for box in boxes:
        is_held[tuple(
            slice(*numpy.searchsorted(ends[axis], (box[2 * axis], box[2 * axis + 1] + more)))
            for axis in range(3))] = True
    holes = numpy.argwhere(~is_held)
    return tuple(int(ends[axis][holes[0][axis]]) for axis in range(3)) if len(holes) else None


# --- MetaImage ----------------------------------------------------------------------------------

def _numbers(text: str) -> list[float]:
    numbers = []
    for word in text.split():
        try:
            numbers.append(float(word))
        except ValueError:
            break
    return numbers


def _require_whole_meta(path: str) -> str:
    fields = meta_fields(path)

    def number(key, otherwise):
        return next(iter(_numbers(fields.get(key, ""))), otherwise)

    def is_true(key, otherwise):  # as MetaIO reads it
        return fields[key][0] in "Tt1" if fields.get(key) else otherwise

    dimensions = _numbers(fields.get("DimSize", ""))
    channels, header_size = number("ElementNumberOfChannels", 1), number("HeaderSize", 0)
    name = fields.get("ElementDataFile", "")
    is_local, is_binary = name.lower() == "local", is_true("BinaryData", True)
    is_msb = is_true("BinaryDataByteOrderMSB", None)
    end_of_header = _end_of_header(path)
    for is_so, what in (
            (not name, "its header names no file of samples"),
            (not dimensions or number("NDims", 0) != len(dimensions), "NDims is not how many numbers DimSize has"),
            (min([channels, *dimensions]) < 1, "DimSize or ElementNumberOfChannels is less than 1"),
            (header_size < -1 or (is_local and 0 < header_size < end_of_header),
             "HeaderSize is not where its samples begin"),
            (is_msb is not None and is_true("ElementByteOrderMSB", is_msb) != is_msb,
             "ElementByteOrderMSB contradicts BinaryDataByteOrderMSB"),
            (not is_binary and channels > 1, "VTK does not read several channels as text")):
        if is_so:
            raise _damaged(path, what)
    if name.startswith("LIST") or "%" in name:
        _require_slices(path, name, end_of_header, dimensions)
        return ""

    file = path if is_local else _file_of_samples(path, name)
    begin = int(header_size if header_size > 0 else end_of_header if is_local else 0)
    kind = fields["ElementType"].removeprefix("MET_").removeprefix("U").split("_")[0]
    count = int(math.prod(dimensions) * channels)
    needed = count * META_BYTES.get(kind, 1)
    more = os.path.getsize(file) - begin - needed
    compressed = int(number("CompressedDataSize", 0))
    if (is_binary and is_true("CompressedData", False)) or file.endswith((".gz", ".Z")):
        is_whole = (compressed > 0 or not is_local) and _inflated(file, begin, compressed, needed) == needed
        more = 0
    elif is_binary:
        is_whole = more >= 0
    else:
        with open(file, "rb") as text:
            text.seek(begin)
            is_whole = len(_numbers(text.read().decode("latin-1"))) >= count
        more = 0
    if not is_whole:
        raise _damaged(path, f"{quoted(file)} has fewer samples than the header tells of")
    return f"{quoted(file)} has {more} bytes more than its header tells of, which are not drawn: check DimSize " \
        "and ElementType." if more > 0 and header_size >= 0 else ""


def _end_of_header(path: str) -> int:
    with open(path, "rb") as file:
        for line in file:
            if line.startswith(b"ElementDataFile"):
                break
        return file.tell()


def _file_of_samples(path: str, name: str) -> str:
    file = os.path.join(os.path.dirname(path), name)
    for suffix in ("", ".gz", ".Z"):
        if os.path.isfile(file + suffix):
            return file + suffix
    raise UserError(
        f"{quoted(path)} could not be read as an image: it names the file {quoted(file)}, which is not there; "
        "put it there, or correct the name.")


def _inflated(path: str, begin: int, size: int, most: int) -> int:
    """The bytes that come out of a compressed file, up to the most that there should be, and one."""
    inflater, total = zlib.decompressobj(47), 0
    with open(path, "rb") as file:
        file.seek(begin)
        data = file.read(size or -1)
    try:
        while data and total <= most and not inflater.eof:
            total += len(inflater.decompress(data, 1 << 24))
            data = inflater.unconsumed_tail
    except zlib.error:
        return -1
    return total if inflater.eof else -1


def _require_slices(path: str, words: str, end_of_header: int, dimensions: list[float]) -> None:
    """MetaIO reads as many slices as are listed."""
    numbers = _numbers(" ".join(words.split()[1:]))
    wanted = listed = int(dimensions[-1])
    if words.startswith("LIST"):
        of = int(numbers[0]) if numbers and 1 <= numbers[0] <= len(dimensions) else len(dimensions) - 1
        wanted = int(math.prod(dimensions[of:]))
        with open(path, "rb") as file:
            file.seek(end_of_header)
            listed = sum(line.endswith(b"\n") and len(line) > 1 for line in file)
    elif len(numbers) > 1:
        step = max(int(numbers[2]) if len(numbers) > 2 else int((numbers[1] - numbers[0]) / wanted), 1)
        listed = int((numbers[1] - numbers[0]) // step) + 1
    if listed < wanted:
        raise _damaged(path, f"it names {listed} slices, but its DimSize tells of {wanted}")
