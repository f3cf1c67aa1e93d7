#!/usr/bin/python3
# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of a NumPy array or a volume file, made by a machine that has no display and no OpenGL.

Without --serve it writes a PNG for each isovalue and azimuth. With --serve it answers HTTP:
  /             a page with sliders
  /picture.png  ?isovalue=VALUE&azimuth=DEGREES&size=PIXELS, each of which may be left out
The header Server-Timing tells by which route a picture was made and how many milliseconds it took:
one mapper makes them all, and uses again what it knows of the last one.
"""

from __future__ import annotations

import argparse
import http.server
import io
import os
import threading
import urllib.parse

from mistakes import Arguments, UserError, printable, quoted, run
# Before other packages, as it tells what is missing.
from volumes import add_volume_arguments, check_isovalue, number_from, volume_of

from scene import Scene
from vtkTemporalCoherence import write_png

LARGEST_SIZE = 2048

PAGE = """\
<!DOCTYPE html>
<html lang="en"><meta charset="utf-8"><title>vtkTemporalCoherence</title>
<style>body {{ font: 15px sans-serif; background: #222; color: #ddd; text-align: center }}
input {{ width: 400px; vertical-align: middle }}
output {{ display: inline-block; width: 5em }}</style>
<img id="picture" width="{size}" height="{size}" alt="the isosurface">
<p>isovalue
<input id="isovalue" type="range" min="{low}" max="{high}" step="any" value="{isovalue}">
<output id="isovalueText"></output>
<p>azimuth
<input id="azimuth" type="range" min="-180" max="180" value="{azimuth}">
<output id="azimuthText"></output>
<p id="how"></p>
<script>
const element = id => document.getElementById(id);
let isBusy = false, isAskedAgain = false;
async function ask() {{
  // One request at a time: the last position of a slider is what counts.
  if (isBusy) {{ isAskedAgain = true; return; }}
  isBusy = true;
  for (const name of ["isovalue", "azimuth"])
    element(name + "Text").value = Number(element(name).value).toPrecision(4);
  const answer = await fetch(`picture.png?isovalue=${{element("isovalue").value}}` +
    `&azimuth=${{element("azimuth").value}}&size={size}`);
  if (answer.ok) {{
    URL.revokeObjectURL(element("picture").src);
    element("picture").src = URL.createObjectURL(await answer.blob());
    element("how").textContent = answer.headers.get("Server-Timing").replace(";dur=", ": ") + " ms";
  }} else
    element("how").textContent = await answer.text();
  isBusy = false;
  if (isAskedAgain) {{ isAskedAgain = false; ask(); }}
}}
element("isovalue").oninput = element("azimuth").oninput = ask;
ask();
</script>
"""


def check_size(size: int) -> None:
    if not 1 <= size <= LARGEST_SIZE:
        raise UserError(f"Size {size} is not possible: choose one from 1 to {LARGEST_SIZE} pixels.")


class Pictures:
    """PNGs of one scene, for one caller at a time."""

    def __init__(self, scene: Scene, isovalue: float, azimuth: float, size: int) -> None:
        self._scene = scene
        self._defaults = {"isovalue": isovalue, "azimuth": azimuth, "size": size}
        self._lock = threading.Lock()

    def page(self) -> bytes:
        low, high = self._scene.limits
        return PAGE.format(low=low, high=high, **self._defaults).encode()

    def picture(self, isovalue: float, azimuth: float, size: int) -> tuple[bytes, str, float]:
        """A PNG, its route, and the milliseconds that it took."""
        with self._lock:
            color = self._scene.picture(isovalue, azimuth, (size, size)).color
            route, milliseconds = self._scene.how()
        file = io.BytesIO()
        write_png(file, color)
        return file.getvalue(), route, milliseconds

    def asked_for(self, query: str) -> tuple[bytes, str, float]:
        """The picture that an address asks for; UserError if it makes no sense."""
        wanted = dict(self._defaults)
        for name, text in urllib.parse.parse_qsl(query, keep_blank_values=True):
            if name not in wanted:
                raise UserError(f"There is no parameter {quoted(name)}: give {', '.join(wanted)}.")
            try:
                wanted[name] = int(text) if name == "size" else float(text)
            except ValueError:
                raise UserError(f"The {name} {quoted(text)} is no number: give one.") from None
        check_size(wanted["size"])
        return self.picture(**wanted)


def handler_of(pictures: Pictures) -> type[http.server.BaseHTTPRequestHandler]:
    class Handler(http.server.BaseHTTPRequestHandler):
        timeout = 60.0
        error_content_type = "text/plain; charset=utf-8"
        error_message_format = "%(message)s.\n"

        def do_GET(self):
            path, _, query = self.path.partition("?")
            try:
                if path == "/":
                    self._answer(200, "text/html; charset=utf-8", pictures.page())
                elif path == "/picture.png":
                    png, route, milliseconds = pictures.asked_for(query)
                    self._answer(200, "image/png", png, f"{route};dur={milliseconds:.1f}")
                else:
                    self._complain(404, "There is nothing here: ask for / or /picture.png.")
            except (UserError, ValueError) as error:
                self._complain(400, str(error))

        def log_message(self, *_):
            pass

        def _complain(self, status, sentence):
            self._answer(status, "text/plain; charset=utf-8", sentence.encode() + b"\n")

        def _answer(self, status, content_type, body, timing=None):
            self.send_response(status)
            self.send_header("Content-Type", content_type)
            self.send_header("Content-Length", str(len(body)))
            self.send_header("Cache-Control", "no-store")
            if timing:
                self.send_header("Server-Timing", timing)
            try:
                self.end_headers()
                self.wfile.write(body)
            except ConnectionError:
                self.close_connection = True  # nobody waits for it any more

    return Handler


def serve(pictures: Pictures, host: str, port: int) -> None:
    try:
        # A thread for each connection, as browsers open some that they do not use.
        server = http.server.ThreadingHTTPServer((host, port), handler_of(pictures))
    except (OSError, OverflowError, UnicodeError) as error:
        raise UserError(
            f"Port {port} of {quoted(host)} cannot be listened at ({error}): choose another.") from error
    with server:
        print(f"Serving http://{host}:{server.server_port}/ until Ctrl+C", flush=True)
        server.serve_forever()


def write(
    pictures: Pictures, given: argparse.Namespace, isovalues: list[float], azimuths: list[float]
) -> None:
    try:
        os.makedirs(given.output, exist_ok=True)
        for azimuth in azimuths:
            for isovalue in isovalues:
                png, route, milliseconds = pictures.picture(isovalue, azimuth, given.size)
                path = os.path.join(
                    given.output, f"isovalue{isovalue:.12g}_azimuth{azimuth:.12g}.png")
                with open(path, "wb") as file:
                    file.write(png)
                print(f"{printable(path)}  {route}, {milliseconds:.1f} ms")
    except OSError as error:
        raise UserError(
            f"{quoted(given.output)} cannot be written ({error.strerror}): choose another --output."
        ) from error


def parse() -> argparse.Namespace:
    arguments = Arguments(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    add_volume_arguments(arguments)
    arguments.add_argument(
        "--isovalue", type=float, action="append",
        help="may be repeated; default: half way between the least and the greatest value")
    arguments.add_argument(
        "--azimuth", type=float, action="append",
        help="degrees around the z axis, which points up; may be repeated; default: 30")
    arguments.add_argument(
        "--size", type=number_from(1), default=512, help="pixels of a side; default: 512")
    arguments.add_argument("--output", default="pictures", help="a folder; default: pictures")
    arguments.add_argument(
        "--serve", type=number_from(0), metavar="PORT",
        help="answer HTTP at this port (0: a free one) instead of writing files")
    arguments.add_argument(
        "--host", default="127.0.0.1",
        help="the address to serve at; default: 127.0.0.1, this machine alone; 0.0.0.0: all")
    return arguments.parse_args()


def main() -> None:
    given = parse()
    check_size(given.size)
    scene = Scene(volume_of(given))
    isovalues = given.isovalue or [sum(scene.limits) / 2.0]
    azimuths = given.azimuth or [30.0]
    for isovalue in isovalues:
        check_isovalue(isovalue, scene.limits)
    pictures = Pictures(scene, isovalues[0], azimuths[0], given.size)
    if given.serve is None:
        write(pictures, given, isovalues, azimuths)
    else:
        serve(pictures, given.host, given.serve)


if __name__ == "__main__":
    run(main)
