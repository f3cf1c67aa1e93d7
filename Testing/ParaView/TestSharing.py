# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""A view is written from ParaView as a page and as a view file."""

import json
import os
import struct

from Stage import Render, Show, check, look_from, make_view, make_wavelet

OUTPUT = os.environ["TEMPORAL_ISOSURFACE_OUTPUT"]


def show(source, view):
    """The source as isosurfaces in a view that was rendered."""
    display = Show(source, view)
    display.Representation = "Temporal Isosurface"
    look_from(view)
    Render(view)
    return display


def write(display, view, name):
    """The bytes that are written into a file of this name; none if there is none."""
    path = os.path.join(OUTPUT, name)
    display.ViewFile = path
    Render(view)
    if not os.path.exists(path):
        return b""
    with open(path, "rb") as file:
        return file.read()


def main():
    """Write views of a wavelet."""
    view = make_view((160, 160))
    display = show(make_wavelet(), view)
    display.Isovalues = [150.0]
    Render(view)
    page = write(display, view, "view.html")
    check(page.startswith(b"<!DOCTYPE html>") and b'id="view-file">VENWSUVX' in page,
          "sharing: a page", f"{len(page)} bytes")
    file = write(display, view, "view.tcview")
    header = json.loads(file[24:24 + struct.unpack("<I", file[12:16])[0]]) if file else {}
    check(header.get("views", [{}])[0].get("size") == [160, 160], "sharing: of the view's size")
    check([surface["isovalue"] for surface in header.get("surfaces", [])] == [150.0],
          "sharing: the isovalue is that of the panel")
    position = list(view.CameraPosition)
    written = header.get("views", [{}])[0].get("camera", {}).get("position", [0, 0, 0])
    check(max(abs(a - b) for a, b in zip(position, written)) < 1e-6, "sharing: the camera is that of the view")


main()
