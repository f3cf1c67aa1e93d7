# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""Looks at the headers of volume files before VTK's readers do.

These believe what a header says: some take memory for it, some write where there is none, some
never end. So what a header tells must be possible, and must fit what the file has.
"""

from __future__ import annotations

import base64
import gzip
import math
import mmap
import pathlib
import re
import stat
import struct
import zlib

from mistakes import UserError, quoted

MOST_BY_DEFLATION = 1032  # zlib: "Maximum Compression Factor"
MOST_BYTES = 1 << 24  # of a file that are searched for a header
MOST_SIZES = 1 << 18  # bytes of the sizes that precede an array
MOST_VALUE = 200  # characters of a text that MetaIO copies into 255
MOST_LINE = 400  # characters of any value that MetaIO knows; it reads them into 500
LEAST_SHARE = 4096  # of an extent that pieces of a .vti hold, as 1 in so many
MOST_UNKNOWN = 32000  # characters of other values, which MetaIO keeps in 32768

COMPRESSORS = {
    None: 1, "vtkZLibDataCompressor": MOST_BY_DEFLATION, "vtkLZ4DataCompressor": 256,
    "vtkLZMADataCompressor": 100000}
XML_TYPES = {
    "Int8": 1, "UInt8": 1, "Int16": 2, "UInt16": 2, "Int32": 4, "UInt32": 4, "Int64": 8, "UInt64": 8,
    "Float32": 4, "Float64": 8, "Bit": 0.125, "String": 0}
META_TYPES = {
    "MET_CHAR": 1, "MET_UCHAR": 1, "MET_SHORT": 2, "MET_USHORT": 2, "MET_INT": 4, "MET_UINT": 4,
    "MET_LONG": 4, "MET_ULONG": 4, "MET_LONG_LONG": 8, "MET_ULONG_LONG": 8, "MET_FLOAT": 4,
    "MET_DOUBLE": 8}
# The fields that MetaIO knows.
META_TEXTS = {
    "AcquisitionDate", "AnatomicalOrientation", "BinaryData", "BinaryDataByteOrderMSB", "Comment",
    "CompressedData", "DistanceUnits", "ElementByteOrderMSB", "ElementDataFile", "ElementType",
    "Modality", "Name", "ObjectSubType", "ObjectType"}
META_NUMBERS = {
    "CenterOfRotation", "Color", "CompressedDataSize", "DimSize", "ElementDirection", "ElementMax",
    "ElementMin", "ElementNBits", "ElementNumberOfChannels", "ElementOrigin", "ElementSize",
    "ElementSpacing", "ElementToIntensityFunctionOffset", "ElementToIntensityFunctionSlope",
    "FileFormatVersion", "HeaderSize", "ID", "ImagePosition", "NDims", "Offset", "Orientation",
    "Origin", "ParentID", "Position", "Rotation", "SequenceID", "TransformMatrix"}
NIFTI_TYPES = {
    2: 1, 4: 2, 8: 4, 16: 4, 32: 8, 64: 8, 128: 3, 256: 1, 512: 2, 768: 4, 1024: 8, 1280: 8, 1792: 16,
    2304: 4}


class Damage(Exception):
    """What is wrong with a file."""


def check_header(path: str) -> None:
    """Refuse a file that its reader should not get; UserError then."""
    name = path.lower()
    checks = {
        ".vti": _check_vti, ".vtk": _check_vtk, ".mhd": _check_meta, ".mha": _check_meta,
        ".nii": _check_nifti, ".nii.gz": _check_nifti, ".slc": _check_slc}
    check = next(check for suffix, check in checks.items() if name.endswith(suffix))
    try:
        check(pathlib.Path(path))
    except (Damage, OSError, ValueError) as damage:
        raise UserError(
            f"{quoted(path)} could not be read as an image: {_sentence_of(damage)}; check that it is "
            f"a whole file of the format that its suffix tells.") from damage


def _sentence_of(damage: Exception) -> str:
    return getattr(damage, "strerror", None) or str(damage)


def _whole(text: str, least: int, most: int = 2**31 - 1) -> int:
    if not re.fullmatch(r"[-+]?[0-9]{1,18}", text) or not least <= int(text) <= most:
        raise Damage(f"its header has {quoted(text)} where a number from {least} on should be")
    return int(text)


def _size_of(path: pathlib.Path) -> int:
    status = path.stat()
    if not stat.S_ISREG(status.st_mode):
        raise Damage(f"{quoted(str(path))} is no regular file")  # others may never end
    return status.st_size


def _bytes_of(path: pathlib.Path, most: int = MOST_BYTES) -> bytes:
    _size_of(path)
    with open(path, "rb") as file:
        return file.read(most)


def _require(wanted: float, there: float) -> None:
    if wanted > there:
        raise Damage(f"its header tells of {wanted:.0f} bytes of samples, for which it is too small")


# --- VTK's XML ----------------------------------------------------------------------------------

class _Array:
    """What precedes the bytes of an array in a file of VTK's XML."""

    def __init__(self, text: bytes, at: int, is_raw: bool, code: str) -> None:
        size = struct.calcsize(code)
        if is_raw:
            data = text[at:at + MOST_SIZES]
        else:
            word = re.match(rb"\s*[A-Za-z0-9+/]*", text[at:at + MOST_SIZES])[0]
            digits = re.sub(rb"[\s=].*", b"", word.lstrip(), flags=re.S)
            data = base64.b64decode(digits[:len(digits) // 4 * 4])
        count = len(data) // size
        self.numbers = struct.unpack(code[0] + str(count) + code[1], data[:count * size])

    def bytes(self, is_compressed: bool) -> float:
        """Of the whole array; nan if what precedes it makes no sense."""
        if not is_compressed:
            return self.numbers[0] if self.numbers else math.nan
        if len(self.numbers) < 3:
            return math.nan
        blocks, size, last = self.numbers[:3]
        if blocks < 1 or size < 1 or last > size:
            return math.nan
        return (blocks - 1) * size + last if last else blocks * size

    def bytes_of_blocks(self) -> int:
        """Of those that precede the blocks: all of them."""
        return sum(self.numbers[3:3 + self.numbers[0]])


def _points_of(extent: str | None) -> tuple[int, int]:
    ends = [_whole(word, -2**30, 2**30) for word in (extent or "").split()]
    if len(ends) != 6:
        raise Damage(f"it has the extent {quoted(extent or '')}")
    steps = [last - first for first, last in zip(ends[::2], ends[1::2])]
    return math.prod(max(n + 1, 0) for n in steps), math.prod(max(n, 1) for n in steps)


def _check_vti(path: pathlib.Path) -> None:
    size = _size_of(path)
    text = _bytes_of(path)
    appended = re.search(rb"<AppendedData([^>]*)>\s*_", text)
    markup = text[:appended.start()] if appended else text
    compressor, code, place = None, "<I", ""
    points = cells = whole = pieces = 0
    for element in re.finditer(rb"<(\w+)((?:[^<>\"']|\"[^\"]*\"|'[^']*')*)>", markup):
        name = element[1].decode()
        attributes = {
            key.decode(): value.decode("utf-8", "replace")
            for key, _, value in re.findall(rb"([\w:]+)\s*=\s*([\"'])(.*?)\2", element[2], re.S)}
        if name == "VTKFile":
            compressor = attributes.get("compressor")
            header = attributes.get("header_type", "UInt32")
            order = attributes.get("byte_order", "LittleEndian")
            if compressor not in COMPRESSORS or header not in ("UInt32", "UInt64") or order not in (
                    "LittleEndian", "BigEndian") or attributes.get("type") != "ImageData":
                raise Damage("its element VTKFile is not that of an image")
            code = (">" if order == "BigEndian" else "<") + ("Q" if header == "UInt64" else "I")
        elif name in ("ImageData", "Piece"):
            points, cells = _points_of(
                attributes.get("WholeExtent" if name == "ImageData" else "Extent"))
            whole, pieces = (points, pieces) if name == "ImageData" else (whole, pieces + points)
            _require(points / 8, size * COMPRESSORS[compressor])
        elif name in ("PointData", "CellData", "FieldData"):
            place = name
        elif name in ("DataArray", "Array"):
            if attributes.get("type") not in XML_TYPES:
                raise Damage(f"it has an array of {quoted(attributes.get('type', ''))}")
            values = _whole(attributes.get("NumberOfComponents", "1"), 1, 1000) * {
                "CellData": cells, "FieldData": _whole(attributes.get("NumberOfTuples", "0"), 0)}.get(
                    place, points)
            wanted = math.ceil(values * XML_TYPES[attributes["type"]])
            # As VTK's reader has it: what is neither appended nor binary is text.
            is_appended = attributes.get("format") == "appended" or "offset" in attributes
            is_text = not is_appended and attributes.get("format") != "binary"
            _require(
                values if is_text else wanted, size * (1 if is_text else COMPRESSORS[compressor]))
            if is_text or attributes["type"] == "String" or not wanted:
                continue
            begin, is_raw = element.end(), False
            if is_appended:
                offset = _whole(attributes.get("offset", "0"), 0, size)
                if not appended:
                    raise Damage("its appended data are not there")
                begin, is_raw = appended.end() + offset, b"raw" in appended[1]
            elif space := re.compile(rb"\s+").match(text, begin):
                begin = space.end()
            # Three sizes of 64 bits, in base 64, have 32 characters.
            if begin + 32 > len(text) and len(text) < size:
                continue  # behind what is looked at
            array = _Array(text, begin, is_raw, code)
            if array.bytes(compressor is not None) != wanted:
                raise Damage(f"an array of it does not have the {wanted} bytes that it should")
            if compressor and array.bytes_of_blocks() > size:
                raise Damage("its compressed blocks are larger than it is")
    # Of a part of a distributed image it may be little.
    if whole > LEAST_SHARE * pieces:
        raise Damage("its pieces hold next to nothing of its extent")


# --- Others -------------------------------------------------------------------------------------

def _check_vtk(path: pathlib.Path) -> None:
    words = _bytes_of(path, 4096).split(b"\n", 2)
    if len(words) < 3 or not words[0].startswith(b"# vtk DataFile") or max(map(len, words[:2])) > 255:
        raise Damage("it does not begin as VTK's files do")
    header = words[2].decode("latin-1").split()
    if len(header) < 3 or header[1].upper() != "DATASET" or \
            header[2].upper() != "STRUCTURED_POINTS":
        raise Damage(
            f"it holds {quoted(' '.join(header[1:3]))}, not DATASET STRUCTURED_POINTS: resample it "
            f"with vtkResampleToImage and save it as .vti")
    _check_counts(path, header[0].upper() == "BINARY")
    for at, word in enumerate(header):
        if word.upper() in ("POINT_DATA", "CELL_DATA"):
            break
        if word.upper() == "DIMENSIONS":
            sizes = [_whole(size, 1) for size in header[at + 1:at + 4]]
            _require(math.prod(sizes) / 8, _size_of(path))


def _check_counts(path: pathlib.Path, is_binary: bool) -> None:
    """Numbers by which VTK's reader takes memory, or begins anew so often."""
    size = _size_of(path)
    sizes = {
        b"bit": 0.125, b"unsigned_char": 1, b"char": 1, b"short": 2, b"unsigned_short": 2, b"int": 4,
        b"unsigned_int": 4, b"float": 4, b"signed_char": 1, b"long": 8, b"unsigned_long": 8, b"vtkidtype": 8,
        b"double": 8, b"vtktypeint64": 8, b"vtktypeuint64": 8}
    with open(path, "rb") as file, mmap.mmap(file.fileno(), 0, access=mmap.ACCESS_READ) as text:
        for found in re.finditer(
                rb"(FIELD\s+\S{1,255}|INFORMATION|LOOKUP_TABLE\s+\S{1,255}|\bSCALARS\s+\S{1,255}\s+\S{1,255}|"
                rb"(?:COLOR_SCALARS|TEXTURE_COORDINATES)\s+\S{1,255})\s+(\d{1,40})", text):
            # The table's name may belong to SCALARS: samples follow it, not the size of a table.
            before = text[max(found.start() - 600, 0):found.start()].lower().split()[-4:]
            is_of_scalars = found[1].startswith(b"LOOKUP") and b"scalars" in before[:-2]
            if int(found[2]) > size / 4 and not is_of_scalars:
                raise Damage(f"it tells of {int(found[2])} entries")
        title_end = text.find(b"\n", text.find(b"\n") + 1)
        if re.compile(rb"\nFIELD\s+\S{1,255}\s+[^\s\d]").search(text, title_end):
            raise Damage("it tells of no number of arrays in FIELD")
        for found in re.finditer(rb"FIELD\s+\S{1,255}\s+([1-9]\d{0,17})\s+", text):
            _check_field(text, found.end(), int(found[1]), sizes, is_binary)


def _check_field(
        text: mmap.mmap, at: int, arrays: int, sizes: dict[bytes, float], is_binary: bool) -> None:
    """The arrays of FIELD, whose sizes VTK's reader takes as they are."""
    word = re.compile(rb"\s*(\S{1,255})")
    for _ in range(arrays):
        metadata = re.compile(rb"\s*METADATA[^\n]*\n(?:[^\n]+\n)*\n?").match(text, at)
        at = metadata.end() if metadata else at
        if null := re.compile(rb"\s*NULL_ARRAY(?=\s)").match(text, at):
            at = null.end()
            continue
        found = re.compile(
            rb"\s*\S{1,255}\s+(\d{1,6})\s+(\d{1,18})\s+([A-Za-z]\S{0,254})").match(text, at)
        values = int(found[1]) * int(found[2]) if found else math.inf
        if values > 8 * len(text):
            raise Damage("it tells of no sizes of an array in FIELD")
        each = sizes.get(found[3].lower())
        if not each:
            return  # of strings only the reader knows how many bytes they have
        at = found.end()
        if is_binary:
            at = text.find(b"\n", at) + 1 + math.ceil(values * each)
            _require(at, len(text))
        for _ in range(0 if is_binary else values):
            value = word.match(text, at)
            if not value:
                raise Damage("it ends within an array in FIELD")
            at = value.end()


def _check_meta(path: pathlib.Path) -> None:
    head = _bytes_of(path, 1 << 16)
    fields: dict[str, str] = {}
    end = 0
    while "ElementDataFile" not in fields:
        line, newline, _ = head[end:].partition(b"\n")
        end += len(line) + len(newline)
        # MetaIO takes ":" for "=", too.
        key, *rest = (part.strip() for part in re.split("[=:]", line.decode("latin-1"), maxsplit=1))
        value = rest[0].lstrip("=: \t") if rest else ""
        most = MOST_VALUE if key in META_TEXTS and re.search(r"[^-+0-9.eE \t]", value) else \
            MOST_LINE if key in META_TEXTS | META_NUMBERS else MOST_UNKNOWN
        if line.strip() and not (rest and key.isprintable()) or len(key) > MOST_VALUE or \
                len(value) > most or key in fields and key in META_TEXTS | META_NUMBERS:
            raise Damage(f"its header has the line {quoted(line.decode('latin-1'))}")
        if key:
            fields[key] = value
        if not newline:
            break
    axes = _whole(fields.get("NDims", ""), 2, 3)
    sizes = [_whole(size, 1) for size in fields.get("DimSize", "").split()]
    kind = fields.get("ElementType", "").removesuffix("_ARRAY")
    if len(sizes) != axes or kind not in META_TYPES:
        raise Damage("its header does not tell of samples along each axis, or not of their type")
    channels = _whole(fields.get("ElementNumberOfChannels") or "1", 1, 1000)
    there = _bytes_of_samples(path, fields.get("ElementDataFile", ""), head, end)
    for key in ("HeaderSize", "CompressedDataSize"):
        _whole(fields.get(key) or "0", -1, there)
    is_compressed = fields.get("CompressedData", "")[:1] in ("T", "t", "1")
    is_text = fields.get("BinaryData", "")[:1] in ("F", "f", "0")
    wanted = math.prod(sizes) * channels * (1 if is_text else META_TYPES[kind])
    _require(wanted, there * (MOST_BY_DEFLATION if is_compressed else 1))


def _bytes_of_samples(path: pathlib.Path, file: str, head: bytes, end: int) -> int:
    """Bytes of the files that a header of MetaImage names."""
    words = file.split()
    if not words:
        raise Damage("its header has no line ElementDataFile that names a file")
    if words[0] in ("LOCAL", "Local", "local"):
        return _size_of(path) - end
    if words[0].startswith("LIST"):
        rest = _bytes_of(path, _size_of(path))[end:]
        names = [line.strip() for line in rest.decode("latin-1").split("\n")]
    elif "%" in file:
        # The pattern goes to printf.
        if len(words) != 4 or not re.fullmatch(r"[^%]*%0?[0-9]{0,2}d[^%]*", words[0]):
            raise Damage("its line ElementDataFile tells of no row of files")
        first, last, step = (_whole(word, 0, 999999) for word in words[1:])
        names = [words[0] % number for number in range(first, last + 1, max(step, 1))]
    else:
        names = [file]
    return sum(_size_of(path.parent / name) for name in names if name)


def _check_nifti(path: pathlib.Path) -> None:
    size = _size_of(path)
    head = _bytes_of(path, 540)
    is_zipped = head[:2] == b"\x1f\x8b"
    if is_zipped:
        try:
            with gzip.open(path) as file:
                head = file.read(540)
        except (EOFError, zlib.error) as error:
            raise Damage("its compressed data are damaged") from error
    head = head.ljust(540, b"\0")
    order = next((o for o in "<>" if struct.unpack_from(o + "i", head)[0] in (348, 540)), None)
    if order is None:
        raise Damage("it does not begin with a header of NIfTI")
    if struct.unpack_from(order + "i", head)[0] == 348:
        dims = struct.unpack_from(order + "8h", head, 40)
        kind, = struct.unpack_from(order + "h", head, 70)
        begin, = struct.unpack_from(order + "f", head, 108)
    else:
        dims = struct.unpack_from(order + "8q", head, 16)
        kind, = struct.unpack_from(order + "h", head, 12)
        begin, = struct.unpack_from(order + "q", head, 168)
    # VTK tells the order of bytes by the number of axes.
    sizes = dims[1:dims[0] + 1] if 1 <= dims[0] <= 7 else ()
    if kind not in NIFTI_TYPES or not sizes or not all(0 < n < 2**31 for n in sizes):
        raise Damage("its header tells of no samples, or of no type that they have")
    there = size * (MOST_BY_DEFLATION if is_zipped else 1)
    if not 0 <= begin <= there:
        raise Damage("its header tells that the samples begin where the file has ended")
    # Of several times the first is read.
    samples = math.prod(sizes[:3] + sizes[4:])
    _require(samples * NIFTI_TYPES[kind] + (0 if is_zipped else begin), there)


def _check_slc(path: pathlib.Path) -> None:
    data = _bytes_of(path, _size_of(path))
    head = re.match(rb"\s*11111" + 13 * rb"\s+(\S+)" + rb"\s*X", data)
    if not head:
        raise Damage("it does not begin with a header of SLC")
    fields = [word.decode("latin-1") for word in head.groups()]
    nx, ny, nz = (_whole(field, 1) for field in fields[:3])
    for field in (fields[3], *fields[7:10]):
        _whole(field, -2**31)
    is_compressed = _whole(fields[10], 0, 1)
    icon = _whole(fields[11], 1, 65535) * _whole(fields[12], 1, 65535)
    at = head.end() + 3 * icon
    if max(icon, nx * ny) > 2**31 - 1:
        raise Damage("its slices or its icon are too large")
    if not is_compressed:
        _require(at + nx * ny * nz, len(data))
        return
    for number in range(nz):
        size = re.compile(rb"\s*(\d{1,9})\s*X").match(data, at)
        if not size or size.end() + int(size[1]) > len(data):
            raise Damage(f"slice {number} is not there")
        at = size.end() + int(size[1])
        if _decoded(data[size.end():at]) != nx * ny:
            raise Damage(f"slice {number} has other samples than it should")


def _decoded(runs: bytes) -> int:
    """How many bytes runs become; -1 where the last one has no end.

    A run is its length, with the highest bit set if its bytes follow, else with the one byte that is
    repeated. 0 ends them.
    """
    count = at = 0
    while at < len(runs):
        length = runs[at] & 0x7f
        if not length:
            return count
        count += length
        at += 1 + (length if runs[at] & 0x80 else 1)
    return -1
