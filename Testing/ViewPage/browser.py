# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""A browser that shows pages of views: mouse, keys and touch go in, pixels and depths come out."""

import base64
import math
import pathlib
import time

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

#: Keys by their names in WebDriver.
KEYS = {
    "Tab": "\ue004", "Enter": "\ue007", "Shift": "\ue008", "Control": "\ue009", "Escape": "\ue00c",
    "PageUp": "\ue00e", "PageDown": "\ue00f", "End": "\ue010", "Home": "\ue011", "ArrowLeft": "\ue012",
    "ArrowUp": "\ue013", "ArrowRight": "\ue014", "ArrowDown": "\ue015"}

#: Seconds until a page counts as stuck. No test waits so long unless it fails.
PATIENCE = 60.0

_DEPTHS = """
const [width, height] = isosurfaceView.view.size, told = document.getElementById("told");
const text = told.textContent, depths = new Float64Array(width * height).fill(Infinity);
for (let y = 0; y < height; ++y) {
  for (let x = 0; x < width; ++x) {
    const hit = isosurfaceView.pick(x + 0.5, height - y - 0.5);
    if (hit) {
      depths[y * width + x] = hit.depth;
    }
  }
}
told.textContent = text;
const bytes = new Uint8Array(depths.buffer);
let characters = "";
for (let at = 0; at < bytes.length; at += 4096) {
  characters += String.fromCharCode(...bytes.subarray(at, at + 4096));
}
return btoa(characters);
"""

_SETTLED = """
const done = arguments[arguments.length - 1];
requestAnimationFrame(() => requestAnimationFrame(() => done(true)));
"""


def read_png(data):
    """The pixels of a PNG's bytes, row 0 at the bottom."""
    reader = vtkPNGReader()
    reader.SetMemoryBuffer(data)
    reader.SetMemoryBufferLength(len(data))
    reader.Update()
    width, height, _ = reader.GetOutput().GetDimensions()
    return vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).reshape(height, width, -1).copy()


class Browser:
    """What browsers have in common. Each has run(), wait_for_call(), go_to(), perform(), screenshot()."""

    def open(self, path, state="ready"):
        """Open a page from a file, until it is in a state: "ready" or "failed"."""
        self.go_to(pathlib.Path(path).resolve().as_uri())
        self.wait_until(lambda: self.state() is not None, "the page shows its picture")
        if self.state() != state:
            raise AssertionError(f"the page is {self.state()}: {self.text('message')}")

    def wait_until(self, is_true, what):
        """Until a function returns true."""
        end = time.monotonic() + PATIENCE
        while not is_true():
            if time.monotonic() > end:
                raise AssertionError(f"in vain: {what}")
            time.sleep(0.02)

    def settle(self):
        """Until what was asked for is drawn."""
        self.wait_for_call(_SETTLED)

    def state(self):
        return self.run("return document.documentElement.dataset.state ?? null;")

    def text(self, name):
        """The text of an element, by its id."""
        return self.run("return document.getElementById(arguments[0]).textContent;", name)

    def value(self, name):
        return self.run("return document.getElementById(arguments[0]).value;", name)

    def attribute(self, name, attribute):
        return self.run("return document.getElementById(arguments[0]).getAttribute(arguments[1]);", name, attribute)

    def focused(self):
        """The id of the element that has the focus."""
        return self.run("return document.activeElement.id || document.activeElement.tagName;")

    def focus(self, name):
        self.run("document.getElementById(arguments[0]).focus();", name)

    def surfaces(self):
        """The surfaces that are shown: isovalue, color, opacity."""
        return self.run("return isosurfaceView.surfaces.map(({isovalue, color, opacity}) => "
                        "({isovalue, color: [...color], opacity}));")

    def isovalue(self):
        return self.run("return isosurfaceView.surface().isovalue;")

    def view(self):
        """What the file says of the view that is shown, without its sections."""
        return self.run("const {chunks, ...view} = isosurfaceView.view; return view;")

    def pixels(self):
        """The colours of the picture, (height, width, 3) of 0 to 255. Row 0 is the bottom row."""
        self.settle()
        address = self.run("return document.getElementById('picture').toDataURL('image/png');")
        return read_png(base64.b64decode(address.partition(",")[2]))[..., :3].astype(int)

    def depths(self):
        """The depths that a click reads, at all pixels; infinity without a surface. Row 0 is the bottom row."""
        self.settle()
        width, height = self.view()["size"]
        return numpy.frombuffer(base64.b64decode(self.run(_DEPTHS)), numpy.float64).reshape(height, width)

    def box(self, name):
        """Left, top, width and height of an element in the window, which shows it."""
        return self.run("""
            const element = document.getElementById(arguments[0]);
            element.scrollIntoView({block: "center"});
            const box = element.getBoundingClientRect();
            return [box.left, box.top, box.width, box.height];""", name)

    def place_in(self, name, x, y):
        """The point of the window at shares of an element's width and height, from its upper left."""
        left, top, width, height = self.box(name)
        return math.floor(left + x * width), math.floor(top + y * height)

    def drag(self, name, *places, pointer="mouse"):
        """Press at the first place of an element, move to the others, let go. Places are as in place_in()."""
        points = [self.place_in(name, *place) for place in places]
        self.drag_in_window(*points, pointer=pointer)

    def drag_in_window(self, *points, pointer="mouse"):
        """The same, of points of the window in pixels."""
        moves = [{"type": "pointerMove", "duration": 0, "x": x, "y": y, "origin": "viewport"} for x, y in points]
        down, up = ({"type": kind, "button": 0} for kind in ("pointerDown", "pointerUp"))
        self.perform({
            "type": "pointer", "id": pointer, "parameters": {"pointerType": pointer},
            "actions": [moves[0], down, *moves[1:], up]})
        self.settle()

    def click(self, name, x=0.5, y=0.5):
        self.drag(name, (x, y))

    def press(self, *keys):
        """Press keys, one after the other: names of KEYS, or characters."""
        actions = []
        for key in keys:
            for kind in ("keyDown", "keyUp"):
                actions.append({"type": kind, "value": KEYS.get(key, key)})
        self.perform({"type": "key", "id": "keys", "actions": actions})
        self.settle()

    def type_over(self, name, text):
        """Type a text in the place of what an input has, and Enter."""
        self.click(name)
        self.run("document.getElementById(arguments[0]).select();", name)
        self.press(*text, "Enter")
