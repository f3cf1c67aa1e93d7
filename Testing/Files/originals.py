# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""Small volumes in all formats that the examples open, written without VTK, the same everywhere.

Each writer takes a twist: a function through which each number of a header goes on its way into the
file, and which makes it another one where a broken file is wanted.
"""

from __future__ import annotations

import base64
import lzma
import math
import struct
import zlib
from dataclasses import dataclass, field
from typing import Callable

import meshes
import pictures

SIZE = (9, 8, 7)
Twist = Callable[[object], object]


@dataclass
class Original:
    """Files of one volume: main is the one that is opened, or "" for the folder of all."""
    main: str
    files: dict[str, bytes]
    layout: str = ""  # what --raw takes
    way: str = ""  # "session": opened as a session
    words: list[bytes] = field(default_factory=list)  # that mean something in this format


def ball() -> list[float]:
    """Values from 0 to about 200, highest in the middle."""
    nx, ny, nz = SIZE
    return [
        max(0.0, 200.0 - 50.0 * math.dist((i, j, k), ((nx - 1) / 2, (ny - 1) / 2, (nz - 1) / 2)))
        for k in range(nz) for j in range(ny) for i in range(nx)]


def packed(code: str) -> bytes:
    values = ball()
    return struct.pack(
        f"{code[0]}{len(values)}{code[1]}",
        *(values if code[1] in "fd" else [round(value) for value in values]))


def whole(value: object, bits: int, is_signed: bool = False) -> int:
    """What a field of so many bits makes of a number."""
    number = int(value) if isinstance(value, (int, float)) and math.isfinite(value) else 0
    number &= (1 << bits) - 1
    return number - (1 << bits) if is_signed and number >> (bits - 1) else number


# --- VTK's XML ----------------------------------------------------------------------------------

def stored_lz4(data: bytes) -> bytes:
    """An LZ4 block that holds all bytes as they are."""
    block = bytearray([min(len(data), 15) << 4])
    rest = len(data) - 15
    while rest >= 0:
        block.append(min(rest, 255))
        rest -= 255
    return bytes(block) + data


COMPRESSORS = {
    "vtkZLibDataCompressor": zlib.compress,
    "vtkLZ4DataCompressor": stored_lz4,
    "vtkLZMADataCompressor": lambda data: lzma.compress(data, check=lzma.CHECK_CRC32),
}


def with_header(data: bytes, compressor: str, code: str, twist: Twist) -> tuple[bytes, bytes]:
    """Header and data of an array as VTK's XML files have them."""
    bits = 8 * struct.calcsize(code)

    def numbers(*values):
        return b"".join(struct.pack("<" + code, whole(twist(value), bits)) for value in values)

    if not compressor:
        return numbers(len(data)), data
    size = 200
    blocks = [COMPRESSORS[compressor](data[at:at + size]) for at in range(0, len(data), size)]
    header = numbers(len(blocks), size, len(data) % size, *map(len, blocks))
    return header, b"".join(blocks)


def vti(kind: str, compressor: str = "", code: str = "<B", name: str = "UInt8",
        header: str = "UInt32") -> Callable[[Twist], Original]:
    def write(twist: Twist) -> Original:
        nx, ny, nz = SIZE
        t = twist
        data = packed(code)
        head, body = with_header(data, compressor, "I" if header == "UInt32" else "Q", t)
        extent = f"0 {t(nx - 1)} 0 {t(ny - 1)} 0 {t(nz - 1)}"
        array, appended = "", b""
        if kind == "ascii":
            content = " ".join(map(str, struct.unpack(f"{code[0]}{nx * ny * nz}{code[1]}", data)))
            array = f'format="ascii">{content}</DataArray>'
        elif kind == "binary":
            content = base64.b64encode(head).decode() + base64.b64encode(body).decode() \
                if compressor else base64.b64encode(head + body).decode()
            array = f'format="binary">{content}</DataArray>'
        else:
            array = f'format="appended" offset="{t(0)}"/>'
            raw = kind == "raw"
            appended = head + body if raw else base64.b64encode(head) + base64.b64encode(body) \
                if compressor else base64.b64encode(head + body)
            appended = b'<AppendedData encoding="%s">_' % (b"raw" if raw else b"base64") + \
                appended + b"</AppendedData>\n"
        text = f"""<?xml version="1.0"?>
<VTKFile type="ImageData" version="{t(1)}.0" byte_order="LittleEndian" header_type="{header}"\
{f' compressor="{compressor}"' if compressor else ""}>
<ImageData WholeExtent="{extent}" Origin="{t(1.5)} {t(0)} {t(-2)}" Spacing="{t(1)} {t(0.5)} {t(2)}" \
Direction="{t(1)} {t(0)} {t(0)} {t(0)} {t(1)} {t(0)} {t(0)} {t(0)} {t(1)}">
<Piece Extent="{extent}">
<PointData Scalars="ball">
<DataArray type="{name}" Name="ball" NumberOfComponents="{t(1)}" RangeMin="{t(0)}" \
RangeMax="{t(200)}" {array}
</PointData>
<CellData>
</CellData>
</Piece>
</ImageData>
""".encode() + appended + b"</VTKFile>\n"
        return Original("a.vti", {"a.vti": text}, words=[
            b"UInt8", b"Int64", b"Float64", b"String", b"Bit", b"ascii", b"binary", b"appended",
            b"raw", b"base64", b"ImageData", b"PolyData", b"UInt64", b"UInt32", b"BigEndian",
            b"LittleEndian", b"vtkZLibDataCompressor", b"vtkLZ4DataCompressor",
            b"vtkLZMADataCompressor", b"CellData", b"PointData", b"FieldData", b"DataArray", b"Piece",
            b"InformationKey", b"Scalars"])
    return write


def vti_without_format(twist: Twist) -> Original:
    """Text, which is what VTK takes then."""
    original = vti("ascii")(twist)
    original.files["a.vti"] = original.files["a.vti"].replace(b' format="ascii"', b"", 1)
    return original


# --- VTK's legacy format ------------------------------------------------------------------------

def legacy(binary: bool, dataset: str = "STRUCTURED_POINTS") -> Callable[[Twist], Original]:
    def write(twist: Twist) -> Original:
        nx, ny, nz = SIZE
        t = twist
        data = packed(">h") if binary else " ".join(
            map(str, struct.unpack(f">{nx * ny * nz}h", packed(">h")))).encode()
        text = f"# vtk DataFile Version {t(3)}.0\na ball\n{'BINARY' if binary else 'ASCII'}\n" \
            f"DATASET {dataset}\nDIMENSIONS {t(nx)} {t(ny)} {t(nz)}\n".encode()
        if dataset == "STRUCTURED_POINTS":
            text += f"SPACING {t(1)} {t(0.5)} {t(2)}\nORIGIN {t(1.5)} {t(0)} {t(-2)}\n".encode()
        else:
            for axis, count in zip("XYZ", SIZE):
                text += f"{axis}_COORDINATES {t(count)} float\n".encode()
                text += struct.pack(f">{count}f", *range(count)) if binary else \
                    " ".join(map(str, range(count))).encode()
                text += b"\n"
        text += f"POINT_DATA {t(nx * ny * nz)}\nSCALARS ball short {t(1)}\nLOOKUP_TABLE default\n" \
            .encode() + data + b"\nMETADATA\nINFORMATION 0\n\n"
        text += f"FIELD FieldData {t(1)}\nmore {t(1)} {t(2)} int\n".encode()
        text += struct.pack(">2i", 3, 4) if binary else b"3 4"
        return Original("a.vtk", {"a.vtk": text + b"\n"}, words=[
            b"STRUCTURED_POINTS", b"RECTILINEAR_GRID", b"UNSTRUCTURED_GRID", b"POLYDATA", b"FIELD",
            b"STRUCTURED_GRID", b"BINARY", b"ASCII", b"SCALARS", b"VECTORS", b"TENSORS", b"LOOKUP_TABLE",
            b"COLOR_SCALARS", b"POINT_DATA", b"CELL_DATA", b"DIMENSIONS", b"METADATA", b"INFORMATION",
            b"short", b"double", b"bit", b"char", b"string", b"vtkIdType", b"NORMALS", b"GLOBAL_IDS",
            b"TEXTURE_COORDINATES", b"NAME", b"LOCATION", b"DATA", b"COMPONENT_NAMES", b"EXTENT"])
    return write


def legacy_large(twist: Twist) -> Original:
    """Numbers that are no counts, though they are larger than the file, and two arrays."""
    t = twist
    values = " ".join(str(1000000 + 100 * round(value)) for value in ball())
    text = f"# vtk DataFile Version {t(3)}.0\na ball\nASCII\nDATASET STRUCTURED_POINTS\n" \
        f"DIMENSIONS {' '.join(str(t(n)) for n in SIZE)}\nORIGIN 0 0 0\n" \
        f"SPACING {t(1000)} {t(1000)} {t(1000)}\nPOINT_DATA {t(math.prod(SIZE))}\n" \
        f"SCALARS ball int {t(1)}\nLOOKUP_TABLE default\n{values}\n" \
        f"SCALARS more int\nLOOKUP_TABLE default\n{values}\n" \
        f"VECTORS steps int\n{' '.join(3 * [values])}\n"
    return Original("a.vtk", {"a.vtk": text.encode()}, words=[
        b"SCALARS", b"VECTORS", b"LOOKUP_TABLE", b"POINT_DATA", b"FIELD", b"SPACING"])


# --- MetaImage ----------------------------------------------------------------------------------

def meta(local: bool, compressed: bool = False) -> Callable[[Twist], Original]:
    def write(twist: Twist) -> Original:
        nx, ny, nz = SIZE
        t = twist
        data = packed("<h")
        stored = zlib.compress(data) if compressed else data
        text = f"""ObjectType = Image
NDims = {t(3)}
BinaryData = True
BinaryDataByteOrderMSB = False
CompressedData = {compressed}
""" + (f"CompressedDataSize = {t(len(stored))}\n" if compressed else "") + f"""\
TransformMatrix = {t(1)} {t(0)} {t(0)} {t(0)} {t(1)} {t(0)} {t(0)} {t(0)} {t(1)}
Offset = {t(1.5)} {t(0)} {t(-2)}
CenterOfRotation = {t(0)} 0 0
AnatomicalOrientation = RAI
ElementSpacing = {t(1)} {t(0.5)} {t(2)}
HeaderSize = {t(-1 if local and not compressed else 0)}
ElementNumberOfChannels = {t(1)}
DimSize = {t(nx)} {t(ny)} {t(nz)}
ElementType = MET_SHORT
ElementDataFile = {"LOCAL" if local else "a.raw"}
"""
        words = [
            b"MET_UCHAR", b"MET_DOUBLE", b"MET_STRING", b"MET_OTHER", b"MET_LONG_LONG",
            b"MET_USHORT_ARRAY", b"MET_FLOAT_MATRIX", b"True", b"False", b"LOCAL", b"Local", b"LIST",
            b"LIST 2", b"a%02d.raw 1 3 1", b"a.raw", b"/dev/zero", b".", b"Image", b"Scene", b"Tube",
            b"ObjectSubType", b"ElementToIntensityFunctionSlope", b"ElementMin", b"ElementSize",
            b"DimSize", b"NDims", b"ElementSpacing", b"Position", b"Orientation", b"Modality",
            b"SequenceID", b"ElementNumberOfChannels"]
        if local:
            return Original("a.mha", {"a.mha": text.encode() + stored}, words=words)
        return Original("a.mhd", {"a.mhd": text.encode(), "a.raw": stored}, words=words)
    return write


#: What makes meta(True) contradict itself: what is replaced, by what, and a word of the refusal.
META_CONTRADICTIONS = (
    (b"DimSize = 9 8 7", b"DimSize = 9 8", ""),
    (b"DimSize = 9 8 7", b"DimSize = 9 8 0", "fewer samples"), (b"Channels = 1", b"Channels = 0", "fewer samples"),
    (b"Channels = 1", b"Channels = 2", "fewer samples"), (b"MET_SHORT", b"MET_FLOAT", "fewer samples"),
    (b"HeaderSize = -1", b"HeaderSize = 20", "fewer samples"),
    (b"HeaderSize = -1", b"HeaderSize = 9000", "fewer samples"), (b"BinaryData = True", b"BinaryData = False", ""),
    (b"CompressedData = False", b"CompressedData = True", ""), (b"= LOCAL", b"= b.raw", "b.raw"),
    (b"ElementDataFile = LOCAL", b"", ""), (b"DimSize = 9 8 7", b"", ""))


def meta_wordy(twist: Twist) -> Original:
    """What MetaIO reads, though it seldom writes it."""
    original = meta(True)(twist)
    text = original.files["a.mha"]
    for old, new in (
            (b"NDims = ", b"NDims : "), (b"MET_SHORT\n", b"MET_SHORT_ARRAY\n"),
            (b"ElementDataFile", b"0008|2111 = " + 40 * b"a comment " + b"\nElementDataFile")):
        text = text.replace(old, new, 1)
    original.files["a.mha"] = text
    return original


def meta_list(twist: Twist) -> Original:
    """A slice is a file; the list of their names is longer than a header may be."""
    nx, ny, nz = SIZE
    head, _ = meta(True)(twist).files["a.mha"].split(b"HeaderSize", 1)
    head += f"DimSize = {nx} {ny} {twist(nz)}\nElementType = MET_SHORT\n".encode()
    data, files = packed("<h"), {}
    for k in range(nz):
        files[f"{k}.raw"] = data[2 * k * nx * ny:2 * (k + 1) * nx * ny]
    names = b"".join(name.encode() + b" " * 12000 + b"\n" for name in files)
    files["a.mhd"] = head + b"ElementDataFile = LIST\n" + names
    return Original("a.mhd", files, words=[b"LIST", b"LIST 2", b"0.raw", b"DimSize"])


# --- NIfTI --------------------------------------------------------------------------------------

def nifti(zipped: bool, version: int = 1) -> Callable[[Twist], Original]:
    def write(twist: Twist) -> Original:
        t = twist

        def i(bits, *values):
            code = {16: "h", 32: "i", 64: "q"}[bits]
            return b"".join(
                struct.pack("<" + code, whole(t(value), bits, True)) for value in values)

        def r(code, *values):
            made = b""
            for value in values:
                try:
                    made += struct.pack("<" + code, float(t(value)))
                except (OverflowError, ValueError):
                    made += struct.pack("<" + code, math.inf)
            return made

        dims = (3, *SIZE, 1, 1, 1, 1)
        if version == 1:
            head = i(32, 348) + bytes(36) + i(16, *dims) + r("f", 0, 0, 0) + i(16, 0, 4, 16, 0)
            head += r("f", 1, 1, 0.5, 2, 0, 0, 0, 0) + r("f", 352, 1, 0) + i(16, 0) + b"\0\2"
            head += r("f", 0, 0, 0, 0) + bytes(8 + 80 + 24) + i(16, 1, 1)
            head += r("f", 0, 0, 0, 1.5, 0, -2) + r("f", 1, 0, 0, 1.5, 0, .5, 0, 0, 0, 0, 2, -2)
            head += bytes(16) + b"n+1\0" + bytes(4)
        else:
            head = i(32, 540) + b"n+2\0\r\n\032\n" + i(16, 4, 16) + i(64, *dims) + r("d", 0, 0, 0)
            head += r("d", 1, 1, 0.5, 2, 0, 0, 0, 0) + i(64, 544) + r("d", 1, 0, 0, 0, 0, 0)
            head += i(64, 0, 0) + bytes(80 + 24) + i(32, 1, 1) + r("d", 0, 0, 0, 1.5, 0, -2)
            head += r("d", 1, 0, 0, 1.5, 0, .5, 0, 0, 0, 0, 2, -2) + i(32, 0, 2, 0, 0, 0)
            head += bytes(540 - len(head)) + bytes(4)
        data = head + packed("<h")
        name = "a.nii.gz" if zipped else "a.nii"
        return Original(name, {name: zlib.compress(data, wbits=31) if zipped else data})
    return write


# --- NRRD ---------------------------------------------------------------------------------------

def nrrd(detached: bool, encoding: str = "raw", code: str = "<h") -> Callable[[Twist], Original]:
    def write(twist: Twist) -> Original:
        t = twist
        nx, ny, nz = SIZE
        data = packed(code)
        if encoding == "gzip":
            data = zlib.compress(data, wbits=31)
        elif encoding == "text":
            data = " ".join(map(str, struct.unpack(f"{code[0]}{nx * ny * nz}{code[1]}", data))).encode()
        text = f"""NRRD0004
# a ball
type: {"short" if code[1] == "h" else "float"}
dimension: {t(3)}
space: left-posterior-superior
sizes: {t(nx)} {t(ny)} {t(nz)}
space directions: ({t(1)},{t(0)},{t(0)}) ({t(0)},{t(0.5)},{t(0)}) ({t(0)},{t(0)},{t(2)})
kinds: domain domain domain
endian: {"big" if code[0] == ">" else "little"}
encoding: {encoding}
space origin: ({t(1.5)},{t(0)},{t(-2)})
key:=value
""" + (f"byte skip: {t(0)}\ndata file: a.raw\n" if detached else "\n")
        words = [
            b"raw", b"gzip", b"text", b"hex", b"bzip2", b"uchar", b"double", b"block", b"int64", b"LIST", b"LIST 2",
            b"a%02d.raw 1 3 1", b"a.raw", b"a.nhdr", b"/dev/zero", b".", b"none", b"nan", b"list", b"time", b"vector",
            b"RGB-color", b"space", b"spacings", b"sizes", b"dimension", b"line skip", b"byte skip", b"-1", b"LAS",
            b"3D-left-handed", b"endian", b"little", b"big", b"data file", b"kinds"]
        if detached:
            return Original("a.nhdr", {"a.nhdr": text.encode(), "a.raw": data}, words=words)
        return Original("a.nrrd", {"a.nrrd": text.encode() + data}, words=words)
    return write


# --- SLC ----------------------------------------------------------------------------------------

def slc(compressed: bool) -> Callable[[Twist], Original]:
    def write(twist: Twist) -> Original:
        t = twist
        nx, ny, nz = SIZE
        data = packed("<B")
        text = f"{t(11111)}\n{t(nx)} {t(ny)} {t(nz)} {t(8)}\n{t(1)} {t(0.5)} {t(2)}\n" \
            f"{t(0)} {t(0)} {t(0)}\n{t(1 if compressed else 0)}\n{t(4)} {t(3)} X".encode() + bytes(36)
        for k in range(nz):
            plane = data[k * nx * ny:(k + 1) * nx * ny]
            if compressed:
                # Runs that are copied (0x80 + length), and repeated (length).
                coded = bytes([0x80 + 40]) + plane[:40]
                coded += b"".join(bytes([1, value]) for value in plane[40:]) + b"\0"
                plane = f"{t(len(coded))} X".encode() + coded
            text += plane
        return Original("a.slc", {"a.slc": text}, words=[b"X", b" ", b"\n"])
    return write


# --- DICOM --------------------------------------------------------------------------------------

#: Transfer syntaxes. All but the first write kinds of values; the last one, as others, compresses pixels.
IMPLICIT, EXPLICIT, BIG_ENDIAN, RLE = (
    "1.2.840.10008.1.2", "1.2.840.10008.1.2.1", "1.2.840.10008.1.2.2", "1.2.840.10008.1.2.5")
LONG_KINDS = ("OB", "OW", "SQ", "UN")


def dicom_element(tag: tuple[int, int], kind: str, value: object, syntax: str, twist: Twist) -> bytes:
    """A value is text, bytes, whole numbers of 16 bits, or, of a sequence, the elements of its items."""
    order = ">" if syntax == BIG_ENDIAN else "<"
    length = None
    if kind == "SQ":
        def item(element: int, size: int, content: bytes = b"") -> bytes:
            return struct.pack(order + "HHI", 0xfffe, element, size) + content
        value = b"".join(
            item(0xe000, 0xffffffff, dicom_elements(elements, syntax, twist)) + item(0xe00d, 0)
            for elements in value) + item(0xe0dd, 0)
        length = 0xffffffff
    elif isinstance(value, (list, tuple)):
        value = struct.pack(f"{order}{len(value)}H", *(whole(twist(number), 16) for number in value))
    elif not isinstance(value, bytes):
        value = str(value).encode()
    if kind == "OB" and syntax not in (IMPLICIT, EXPLICIT, BIG_ENDIAN):
        length = 0xffffffff  # of fragments
    value += b"\0" * (len(value) % 2)
    length = whole(twist(len(value) if length is None else length), 32)
    head = struct.pack(order + "HH", *tag)
    if syntax == IMPLICIT:
        return head + struct.pack("<I", length) + value
    if kind in LONG_KINDS:
        return head + kind.encode() + bytes(2) + struct.pack(order + "I", length) + value
    return head + kind.encode() + struct.pack(order + "H", whole(length, 16)) + value


def dicom_elements(elements: dict, syntax: str, twist: Twist) -> bytes:
    return b"".join(
        dicom_element(tag, *elements[tag], syntax, twist) for tag in sorted(elements) if elements[tag])


def run_lengths(pixels: bytes) -> bytes:
    """Fragments of one frame of 16 bits as RLE has them: upper bytes, then lower ones, all copied."""
    parts = [b"".join(bytes([len(part) - 1]) + part for part in (
        half[at:at + 128] for at in range(0, len(half), 128))) for half in (pixels[1::2], pixels[::2])]
    parts = [part + b"\x80" * (len(part) % 2) for part in parts]
    frame = struct.pack("<16I", 2, 64, 64 + len(parts[0]), *13 * [0]) + b"".join(parts)
    return struct.pack("<HHI", 0xfffe, 0xe000, 0) + struct.pack("<HHI", 0xfffe, 0xe000, len(frame)) + \
        frame + struct.pack("<HHI", 0xfffe, 0xe0dd, 0)


def dicom(syntax: str = EXPLICIT, change: Callable[[int], dict] = lambda k: {}) -> Callable[[Twist], Original]:
    """Slices. Of each, elements may be changed: tags that go with a kind and a value, or with None."""
    def write(twist: Twist) -> Original:
        t = twist
        nx, ny, nz = SIZE
        files = {}
        for k in range(nz):
            elements = {
                (0x08, 0x60): ("CS", "MR"), (0x10, 0x10): ("PN", "ball"), (0x18, 0x50): ("DS", t(2)),
                (0x20, 0x0d): ("UI", "1.2.3"), (0x20, 0x0e): ("UI", "1.2.3.4"), (0x20, 0x13): ("IS", t(k + 1)),
                (0x20, 0x32): ("DS", f"{t(0)}\\{t(0)}\\{t(2 * k)}"),
                (0x20, 0x37): ("DS", f"{t(1)}\\{t(0)}\\{t(0)}\\{t(0)}\\{t(1)}\\{t(0)}"),
                (0x28, 0x02): ("US", [1]), (0x28, 0x04): ("CS", "MONOCHROME2"), (0x28, 0x10): ("US", [ny]),
                (0x28, 0x11): ("US", [nx]), (0x28, 0x30): ("DS", f"{t(1)}\\{t(0.5)}"),
                (0x28, 0x100): ("US", [16]), (0x28, 0x101): ("US", [16]), (0x28, 0x102): ("US", [15]),
                (0x28, 0x103): ("US", [0]), (0x28, 0x1052): ("DS", t(0)), (0x28, 0x1053): ("DS", t(1)),
                (0x7fe0, 0x10): ("OW", [round(value) for value in ball()[k * nx * ny:(k + 1) * nx * ny]]),
                **change(k)}
            if syntax == RLE:
                pixels = elements[0x7fe0, 0x10][1]
                pixels = pixels if isinstance(pixels, bytes) else struct.pack(f"<{len(pixels)}H", *pixels)
                elements[0x7fe0, 0x10] = ("OB", run_lengths(pixels))
            meta_group = dicom_elements(
                {(2, 0x10): ("UI", syntax), (2, 0x12): ("UI", "1.2.3")}, EXPLICIT, t)
            files[f"{k}.dcm"] = bytes(128) + b"DICM" + dicom_element(
                (2, 0), "UL", struct.pack("<I", whole(t(len(meta_group)), 32)), EXPLICIT, t) + \
                meta_group + dicom_elements(elements, syntax, t)
        return Original("", files, words=[
            b"US", b"OW", b"SQ", b"UN", b"DS", IMPLICIT.encode(), BIG_ENDIAN.encode(), RLE.encode(),
            b"1.2.840.10008.1.2.4.50", struct.pack("<HHI", 0xfffe, 0xe000, 0xffffffff)])
    return write


#: A small picture of the slice, before its own pixels.
ICON = {(0x88, 0x200): ("SQ", [{
    (0x28, 0x02): ("US", [1]), (0x28, 0x04): ("CS", "MONOCHROME2"), (0x28, 0x10): ("US", [2]),
    (0x28, 0x11): ("US", [3]), (0x28, 0x100): ("US", [8]), (0x28, 0x101): ("US", [8]),
    (0x28, 0x102): ("US", [7]), (0x28, 0x103): ("US", [0]), (0x7fe0, 0x10): ("OW", bytes(range(200, 206)))}])}


def dicom_with_report(twist: Twist) -> Original:
    """A file of another series, which has no pixels, among the slices."""
    original = dicom()(twist)
    report = dicom()(lambda value: value).files["0.dcm"]
    at = report.index(struct.pack("<HH", 0x28, 2))
    original.files["9.dcm"] = report[:at].replace(b"1.2.3.4\0", b"1.2.3.9\0")
    return original


# --- Meshes -------------------------------------------------------------------------------------

def mesh(name: str, make: Callable[[Twist], bytes]) -> Callable[[Twist], Original]:
    return lambda twist: Original(name, {name: make(twist)}, words=meshes.WORDS)


def meshes_of(main: str, make: Callable[[Twist], dict[str, bytes]]) -> Callable[[Twist], Original]:
    return lambda twist: Original(main, make(twist), words=meshes.WORDS + [
        b"b.vtu", b"c.vts", b"0.vti", b"1.vti", b"vtkMultiBlockDataSet", b"Block", b"DataSet", b"spacing",
        b"amr_box", b"file", b"Source", b"XY", b"vtkHierarchicalBoxDataSet", b"refinement_ratio"])


# --- Stacks of pictures -------------------------------------------------------------------------

def slices(code: str) -> list[bytes]:
    data = packed(code)
    size = len(data) // SIZE[2]
    return [data[at:at + size] for at in range(0, len(data), size)]


def tiff_pages(**how) -> Callable[[Twist], Original]:
    def write(twist: Twist) -> Original:
        order = how.get("order", "<")
        return Original("a.tif", {"a.tif": pictures.tiff(slices(order + "H"), SIZE[0], SIZE[1], twist, tags={
            282: (pictures.RATIO, 2.0), 283: (pictures.RATIO, 2.0), 296: (pictures.SHORT, twist(1)),
            270: (pictures.TEXT, f"ImageJ=1.5\nimages={twist(7)}\nspacing={twist(2)}\n".encode())}, **how)}, words=[
                b"II*\0", b"MM\0*", b"ImageJ", b"images=", b"spacing="])
    return write


def numbered(suffix: str, in_folder: bool = False) -> Callable[[Twist], Original]:
    """Numbers without zeros before them, from 4 to 10."""
    def write(twist: Twist) -> Original:
        nx, ny, _ = SIZE
        files = {f"s{k + 4}.{suffix}": pictures.png(data, nx, ny, twist) if suffix == "png" else pictures.tiff(
            [data], nx, ny, twist, 8) for k, data in enumerate(slices("<B"))}
        return Original("" if in_folder else f"s10.{suffix}", files, words=[b"IHDR", b"IDAT", b"IEND", b"II*\0"])
    return write


# --- Lists of time steps ------------------------------------------------------------------------

def series(suffix: str, part: str) -> Callable[[Twist], Original]:
    """The last one of the list is the first time."""
    def write(twist: Twist) -> Original:
        t = twist
        data = meshes.vtu(t) if part == "vtu" else meta(True)(t).files["a.mha"]
        files = {f"{k}.{part}": data for k in range(3)}
        if suffix == "pvd":
            sets = "".join(f'<DataSet timestep="{t(9 - k)}" group="" part="{t(0)}" file="{name}"/>\n'
                           for k, name in enumerate(files))
            text = f"""<?xml version="1.0"?>
<VTKFile type="Collection" version="0.1" byte_order="LittleEndian">
<Collection>
{sets}</Collection>
</VTKFile>
"""
        else:
            sets = ", ".join(f'{{"name": "{name}", "time": {t(9 - k)}}}' for k, name in enumerate(files))
            text = f'{{"file-series-version": "1.0", "files": [{sets}]}}\n'
        files["a." + suffix] = text.encode()
        return Original("a." + suffix, files, words=[
            b"Collection", b"DataSet", b"timestep", b"file", b"name", b"time", b"files", b"0." + part.encode(),
            b"a." + suffix.encode(), b".", b"/dev/zero", b"null", b"true", b"[", b"]", b"{", b"}", b"/*", b"<!--"])
    return write


# --- Others -------------------------------------------------------------------------------------

def raw(twist: Twist) -> Original:
    t = twist
    nx, ny, nz = SIZE
    return Original(
        "a.raw", {"a.raw": packed("<h")},
        f"{t(nx)},{t(ny)},{t(nz)},short,{t(1)},{t(0.5)},{t(2)}")


def session(twist: Twist) -> Original:
    t = twist
    text = f"""# vtkTemporalCoherence Explorer session 1
volume = files/a.mha
isovalue = {t(120)}
camera-position = {t(20)} {t(-30)} {t(15)}
camera-focal-point = {t(4)} {t(3)} {t(3)}
camera-view-up = {t(0)} {t(0)} {t(1)}
camera-view-angle = {t(30)}
palette = tissue
material = satin
light = studio
surface = crossing
accuracy = paper
image-cache = on
isomap = on
leaping = on
drawing = composite
surfaces = {t(120)} {t(0.5)} {t(1)} {t(0.1)} {t(0.2)} {t(0.3)} ; {t(90)} {t(1)} {t(1)}
opacity = {t(0)} {t(0)} ; {t(200)} {t(0.5)} {t(1)} {t(0)} {t(0)}
density = {t(2)}
clip = {t(4)} {t(3)} {t(3)} {t(1)} {t(0)} {t(0)}
crop = {t(1)} {t(7)} {t(1)} {t(6)} {t(1)} {t(5)}
shading = {t(0.1)} {t(0.8)} {t(0.2)} {t(20)}
"""
    files = {"a.session": text.encode(), "a.mha": meta(True)(lambda value: value).files["a.mha"]}
    return Original("a.session", files, way="session", words=[
        b"spheres", b"raw", b"9,8,7,short", b"volume", b"on", b"off", b"solid", b"exact", b"/",
        b"isovalue", b"camera-position", b"camera-view-up", b"big-endian", b"surfaces", b"maximum",
        b"additive", b"component", b"clip", b"crop"])


def npy(twist: Twist) -> Original:
    t = twist
    nx, ny, nz = SIZE
    head = f"{{'descr': '<i{t(2)}', 'fortran_order': False, 'shape': ({t(nz)}, {t(ny)}, {t(nx)}), }}"
    head = head.ljust(117) + "\n"
    data = b"\x93NUMPY\1\0" + struct.pack("<H", whole(t(len(head)), 16)) + head.encode()
    return Original("a.npy", {"a.npy": data + packed("<h")}, words=[
        b"<f4", b">f8", b"|O", b"<U9", b"<M8[s]", b"True", b"False", b"shape", b"()", b"|b1", b"<c8"])


#: What the examples in Python do not open.
NOT_OF_PYTHON = (
    "vtu", "vts", "vts-vectors", "vts-cell-vectors", "vtk-mesh", "vtm", "pvtu", "vthb", "nrrd", "nrrd-gzip", "nrrd-text",
    "nhdr", "nhdr-gzip", "tiff-pages", "tiff-pages-zlib", "tiff-pages-tiles", "tiff-slices", "png-slices", "png-folder",
    "pvd", "series")

ORIGINALS: dict[str, Callable[[Twist], Original]] = {
    "vti-ascii": vti("ascii"),
    "vti-no-format": vti_without_format,
    "vti-binary": vti("binary", code="<h", name="Int16"),
    "vti-binary-zlib": vti("binary", "vtkZLibDataCompressor", "<f", "Float32"),
    "vti-base64": vti("base64", header="UInt64"),
    "vti-base64-zlib": vti("base64", "vtkZLibDataCompressor", header="UInt64"),
    "vti-raw": vti("raw", code="<d", name="Float64"),
    "vti-raw-zlib": vti("raw", "vtkZLibDataCompressor", "<H", "UInt16"),
    "vti-raw-lz4": vti("raw", "vtkLZ4DataCompressor"),
    "vti-raw-lzma": vti("raw", "vtkLZMADataCompressor", header="UInt64"),
    "vtk-ascii": legacy(False),
    "vtk-binary": legacy(True),
    "vtk-large": legacy_large,
    "vtk-grid-ascii": legacy(False, "RECTILINEAR_GRID"),
    "vtk-grid-binary": legacy(True, "RECTILINEAR_GRID"),
    "mhd": meta(False),
    "mhd-zlib": meta(False, True),
    "mha": meta(True),
    "mha-zlib": meta(True, True),
    "mha-wordy": meta_wordy,
    "mhd-list": meta_list,
    "nii": nifti(False),
    "nii-2": nifti(False, 2),
    "nii-gz": nifti(True),
    "nrrd": nrrd(False),
    "nrrd-gzip": nrrd(False, "gzip", ">h"),
    "nrrd-text": nrrd(False, "text"),
    "nhdr": nrrd(True, "raw", ">f"),
    "nhdr-gzip": nrrd(True, "gzip"),
    "tiff-pages": tiff_pages(),
    "tiff-pages-zlib": tiff_pages(order=">", compress=True),
    "tiff-pages-tiles": tiff_pages(tile=16),
    "tiff-slices": numbered("tif"),
    "png-slices": numbered("png"),
    "png-folder": numbered("png", True),
    "pvd": series("pvd", "vtu"),
    "series": series("series", "mha"),
    "slc": slc(False),
    "slc-runs": slc(True),
    "dicom": dicom(),
    "dicom-implicit": dicom(IMPLICIT, lambda k: ICON),
    "dicom-big-endian": dicom(BIG_ENDIAN, lambda k: ICON),
    "dicom-rle": dicom(RLE, lambda k: ICON),
    "dicom-report": dicom_with_report,
    "vtu": mesh("a.vtu", meshes.vtu),
    "vts": mesh("a.vts", meshes.vts),
    "vts-vectors": mesh("a.vts", meshes.vts_vectors),
    "vts-cell-vectors": mesh("a.vts", meshes.vts_cell_vectors),
    "vtm": meshes_of("a.vtm", meshes.vtm),
    "pvtu": meshes_of("a.pvtu", meshes.pvtu),
    "vthb": meshes_of("a.vthb", meshes.vthb),
    "vtk-mesh": mesh("a.vtk", meshes.legacy),
    "raw": raw,
    "session": session,
    "npy": npy,
}
