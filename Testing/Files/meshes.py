# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""Small meshes in formats that the examples open: hexahedra with a value at each point."""

from __future__ import annotations

import math
import struct
from typing import Callable

SIZE = (5, 4, 4)
HEXAHEDRON = 12

WORDS = [
    b"UnstructuredGrid", b"StructuredGrid", b"ImageData", b"PolyData", b"Points", b"Cells", b"types",
    b"connectivity", b"offsets", b"faces", b"faceoffsets", b"Float64", b"Float32", b"Int32", b"UInt8",
    b"String", b"PointData", b"CellData", b"DataArray", b"Piece", b"NumberOfCells", b"Scalars",
    b"UNSTRUCTURED_GRID", b"STRUCTURED_GRID", b"CELLS", b"CELL_TYPES", b"OFFSETS", b"CONNECTIVITY",
    b"POINTS", b"POINT_DATA", b"SCALARS", b"double", b"vtktypeint64", b"bit", b"10", b"42", b"71"]


def points() -> list[tuple[int, int, int]]:
    nx, ny, nz = SIZE
    return [(i, j, k) for k in range(nz) for j in range(ny) for i in range(nx)]


def values() -> list[float]:
    middle = [(n - 1) / 2 for n in SIZE]
    return [max(0.0, 200.0 - 80.0 * math.dist(point, middle)) for point in points()]


def cells() -> list[list[int]]:
    nx, ny, nz = SIZE
    corners = (0, 1, nx + 1, nx)
    first = [i + nx * (j + ny * k)
             for k in range(nz - 1) for j in range(ny - 1) for i in range(nx - 1)]
    return [[at + up + corner for up in (0, nx * ny) for corner in corners] for at in first]


def text_of(numbers, twist) -> str:
    return " ".join(str(twist(number)) for number in numbers)


def array(name: str, kind: str, numbers, twist, components: int = 1) -> str:
    return f'<DataArray type="{kind}" Name="{name}" NumberOfComponents="{twist(components)}" ' \
        f'format="ascii">{text_of(numbers, twist)}</DataArray>\n'


def xml(kind: str, piece: str, content: str, attributes: str = "") -> bytes:
    return f"""<?xml version="1.0"?>
<VTKFile type="{kind}" version="0.1" byte_order="LittleEndian">
<{kind}{attributes}>
<Piece {piece}>
{content}</Piece>
</{kind}>
</VTKFile>
""".encode()


def coordinates() -> list[float]:
    return [coordinate for point in points() for coordinate in point]


def vtu(twist) -> bytes:
    t, rarely = twist, rarer(twist)
    ids = [number for cell in cells() for number in cell]
    content = '<PointData Scalars="ball">\n' + array("ball", "Float32", values(), rarely) + \
        "</PointData>\n<Points>\n" + array("Points", "Float32", coordinates(), rarely, 3) + \
        "</Points>\n<Cells>\n" + array("connectivity", "Int64", ids, rarely) + \
        array("offsets", "Int64", range(8, len(ids) + 1, 8), rarely) + \
        array("types", "UInt8", len(cells()) * [HEXAHEDRON], rarely) + "</Cells>\n"
    return xml("UnstructuredGrid",
               f'NumberOfPoints="{t(len(points()))}" NumberOfCells="{t(len(cells()))}"', content)


def vts(twist, data: str = "") -> bytes:
    rarely = rarer(twist)
    extent = " ".join(f"0 {twist(n - 1)}" for n in SIZE)
    data = data or '<PointData Scalars="ball">\n' + array("ball", "Float32", values(), rarely) + "</PointData>\n"
    content = data + "<Points>\n" + array("Points", "Float32", coordinates(), rarely, 3) + "</Points>\n"
    return xml("StructuredGrid", f'Extent="{extent}"', content, f' WholeExtent="{extent}"')


def vts_vectors(twist) -> bytes:
    """Three components at the points, and no scalars."""
    return vts(twist, "<PointData>\n" + array(
        "places", "Float32", coordinates(), rarer(twist), 3) + "</PointData>\n")


def vts_cell_vectors(twist) -> bytes:
    """Three components of the cells."""
    corners = [coordinates()[3 * cell[0]:3 * cell[0] + 3] for cell in cells()]
    numbers = [number for corner in corners for number in corner]
    return vts(twist, "<CellData>\n" + array(
        "corners", "Float32", numbers, rarer(twist), 3) + "</CellData>\n")


def vtm(twist) -> dict[str, bytes]:
    """Pieces of a block: a list of files."""
    t = twist
    text = f"""<VTKFile type="vtkMultiBlockDataSet" version="1.0" byte_order="LittleEndian">
<vtkMultiBlockDataSet>
<Block index="{t(0)}"><DataSet index="{t(0)}" file="b.vtu"/></Block>
<Piece index="{t(1)}"><DataSet index="{t(0)}" file="c.vts"/><DataSet index="{t(1)}" file="b.vtu"/></Piece>
</vtkMultiBlockDataSet>
</VTKFile>
"""
    return {"a.vtm": text.encode(), "b.vtu": vtu(rarer(twist)), "c.vts": vts(rarer(twist))}


def pvtu(twist) -> dict[str, bytes]:
    """A parallel file, whose parts are others."""
    text = f"""<VTKFile type="PUnstructuredGrid" version="0.1" byte_order="LittleEndian">
<PUnstructuredGrid GhostLevel="{twist(0)}">
<PPointData Scalars="ball"><PDataArray type="Float32" Name="ball" NumberOfComponents="{twist(1)}"/></PPointData>
<PPoints><PDataArray type="Float32" Name="Points" NumberOfComponents="{twist(3)}"/></PPoints>
<Piece Source="b.vtu"/>
</PUnstructuredGrid>
</VTKFile>
"""
    return {"a.pvtu": text.encode(), "b.vtu": vtu(rarer(twist))}


def vthb(twist) -> dict[str, bytes]:
    """An adaptive grid of two levels."""
    t = twist
    files = {}
    blocks = ""
    for level, spacing in enumerate((1, 0.5)):
        box = f"{t(0)} {t(3)} {t(0)} {t(3)} {t(0)} {t(3)}"
        blocks += f'<Block level="{t(level)}" spacing="{t(spacing)} {t(spacing)} {t(spacing)}">' \
            f'<DataSet index="{t(0)}" amr_box="{box}" file="{level}.vti"/></Block>\n'
        content = "<CellData>\n" + array("ball", "Float32", range(64), rarer(twist)) + "</CellData>\n"
        files[f"{level}.vti"] = xml(
            "ImageData", 'Extent="0 4 0 4 0 4"', content,
            f' WholeExtent="0 4 0 4 0 4" Origin="0 0 0" Spacing="{spacing} {spacing} {spacing}"')
    files["a.vthb"] = f"""<VTKFile type="vtkOverlappingAMR" version="1.1" byte_order="LittleEndian">
<vtkOverlappingAMR origin="{t(0)} {t(0)} {t(0)}" grid_description="XYZ">
{blocks}</vtkOverlappingAMR>
</VTKFile>
""".encode()
    return files


def legacy(twist) -> bytes:
    t, rarely = twist, rarer(twist)
    listed = [number for cell in cells() for number in (8, *cell)]
    return f"""# vtk DataFile Version {t(3)}.0
a ball
ASCII
DATASET UNSTRUCTURED_GRID
POINTS {t(len(points()))} float
{text_of(coordinates(), rarely)}
CELLS {t(len(cells()))} {t(len(listed))}
{text_of(listed, rarely)}
CELL_TYPES {t(len(cells()))}
{text_of(len(cells()) * [HEXAHEDRON], rarely)}
POINT_DATA {t(len(points()))}
SCALARS ball float {t(1)}
LOOKUP_TABLE default
{text_of(values(), rarely)}
""".encode()


def pieces(extents, whole: str = "0 7 0 4 0 4", has_cells: bool = False) -> bytes:
    """An image in pieces, with values of 100 and more at its points."""
    text = ""
    for extent in extents:
        ends = list(map(int, extent.split()))
        of_points, of_cells = (
            range(100, 100 + math.prod(b - a + more for a, b in zip(ends[::2], ends[1::2]))) for more in (1, 0))
        text += f'<Piece Extent="{extent}"><PointData>' + array("ball", "Float32", of_points, str) + "</PointData>"
        text += "<CellData>" + array("more", "Float32", of_cells, str) + "</CellData>" if has_cells else ""
        text += "</Piece>"
    return f"""<VTKFile type="ImageData" version="1.0" byte_order="LittleEndian"><ImageData WholeExtent="{whole}"
Origin="0 0 0" Spacing="1 1 1">{text}</ImageData></VTKFile>""".encode()


def hexahedra_and_quad(where: str) -> bytes:
    """Two hexahedra between values of 0 and 1, and a quad between values of 100, in PointData or CellData."""
    places = [(x, y, z) for x in range(3) for z in (0, 1) for y in (0, 1)] + [
        (9, 0, 0), (9, 1, 0), (9, 1, 1), (9, 0, 1)]
    numbers = [place[0] / 2 if place[0] < 9 else 100 for place in places] if where == "PointData" else [0, 1, 100]
    corners = [(0, 4, 5, 1, 2, 6, 7, 3), (4, 8, 9, 5, 6, 10, 11, 7), (12, 13, 14, 15)]
    content = f"<{where}>" + array("value", "Float32", numbers, str) + f"</{where}><Points>" + array(
        "Points", "Float32", [x for place in places for x in place], str, 3) + "</Points><Cells>" + \
        array("connectivity", "Int64", [p for cell in corners for p in cell], str) + \
        array("offsets", "Int64", (8, 16, 20), str) + array("types", "UInt8", (12, 12, 9), str) + "</Cells>"
    return xml("UnstructuredGrid", f'NumberOfPoints="{len(places)}" NumberOfCells="3"', content)


def netcdf(dimensions: dict[str, int], variables: dict[str, tuple], texts: dict[str, object]) -> bytes:
    """A file in netCDF's classic format: Unidata, "NetCDF Classic Format Specification".

    A dimension of 0 is that of records, of which there is one. Variables are (dimensions, type, values,
    attributes); types "c", "i" and "d" are those of struct.
    """
    types = {"c": (2, 1), "i": (4, 4), "d": (6, 8)}

    def number(value):
        return struct.pack(">i", value)

    def name(text):
        return number(len(text)) + padded(text.encode())

    def padded(data):
        return data + bytes(-len(data) % 4)

    def listed(tag, items):
        return (number(tag) if items else number(0)) + number(len(items)) + b"".join(items)

    def attributes(of):
        return listed(12, [
            name(key) + (number(2) + name(value) if isinstance(value, str) else
                         number(4) + number(1) + number(value) if isinstance(value, int) else
                         number(5) + number(1) + struct.pack(">f", value)) for key, value in of.items()])

    names = list(dimensions)
    contents = {}
    for key, (axes, code, values, _) in variables.items():
        data = values.encode().ljust(math.prod(dimensions[a] or 1 for a in axes), b"\0") if code == "c" \
            else struct.pack(f">{len(values)}{code}", *values)
        contents[key] = padded(data)
    order = sorted(variables, key=lambda key: any(dimensions[axis] == 0 for axis in variables[key][0]))

    def head(begins):
        return b"CDF\1" + number(1) + listed(
            10, [name(key) + number(size) for key, size in dimensions.items()]) + attributes(texts) + listed(
                11, [name(key) + number(len(variables[key][0])) +
                     b"".join(number(names.index(axis)) for axis in variables[key][0]) +
                     attributes(variables[key][3]) + number(types[variables[key][1]][0]) +
                     number(len(contents[key])) + number(begins.get(key, 0)) for key in variables])

    begins, at = {}, len(head({}))
    for key in order:
        begins[key] = at
        at += len(contents[key])
    return head(begins) + b"".join(contents[key] for key in order)


def exodus() -> bytes:
    """Hexahedra with a value at each node, at one time."""
    count, ids = len(points()), [number + 1 for cell in cells() for number in cell]
    return netcdf(
        {"len_string": 33, "time_step": 0, "num_dim": 3, "num_nodes": count, "num_elem": len(cells()),
         "num_el_blk": 1, "num_el_in_blk1": len(cells()), "num_nod_per_el1": 8, "num_nod_var": 1},
        {"time_whole": (("time_step",), "d", [0.0], {}),
         "eb_status": (("num_el_blk",), "i", [1], {}),
         "eb_prop1": (("num_el_blk",), "i", [1], {"name": "ID"}),
         **{f"coord{axis}": (("num_nodes",), "d", [point[i] for point in points()], {})
            for i, axis in enumerate("xyz")},
         "connect1": (("num_el_in_blk1", "num_nod_per_el1"), "i", ids, {"elem_type": "HEX8"}),
         "name_nod_var": (("num_nod_var", "len_string"), "c", "ball", {}),
         "vals_nod_var1": (("time_step", "num_nodes"), "d", values(), {})},
        {"api_version": 5.0, "version": 5.0, "floating_point_word_size": 8, "file_size": 1, "title": "a ball"})


def rarer(twist) -> Callable[[object], object]:
    """Of many numbers only a few are made others."""
    count = 0

    def made(number):
        nonlocal count
        count += 1
        return twist(number) if count % 16 == 1 else number
    return made
