#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""Measure pages of volumes: sizes, times in Chromium on one core, and differences from the mapper's pictures.

Prints a table in Markdown. Pages have 1024 x 1024 pixels, the isovalues from the 5 % to the 95 % of the surfaces, and a
tolerance of 0.1 voxels. Times to the first picture and to the page that answers count from when it is opened. A drag
has 120 steps. Shares of pixels are the means and the largest ones of five isovalues: of those whose depth is beyond the
tolerance, or where only one picture has a surface; and of those whose colours differ by more than 4 of 255.

usage: measure.py VOLUME...    .vti, .nii, .nii.gz, .mha or .nrrd; with the package vtkTemporalCoherence in PYTHONPATH
"""

import os
import pathlib
import statistics
import sys
import tempfile
import time

import needed  # noqa: F401
from chromium import Chromium
from scenes import Scene, share_of_other_colors, share_of_other_depths
from vtkmodules.vtkIOImage import vtkMetaImageReader, vtkNIFTIImageReader, vtkNrrdReader
from vtkmodules.vtkIOXML import vtkXMLImageDataReader

SIZE = (1024, 1024)
SHARES = (0.1, 0.3, 0.5, 0.7, 0.9)
STEPS = 120
#: Milliseconds between steps of a drag.
PAUSE = 40

READERS = {".vti": vtkXMLImageDataReader, ".nii": vtkNIFTIImageReader, ".nii.gz": vtkNIFTIImageReader,
           ".mha": vtkMetaImageReader, ".nrrd": vtkNrrdReader}

HEAD = ("| volume | .html, MB | .tcview, MB | written in | first picture | answers | step, median | step, 95 % "
        "| depths beyond, mean (most) | colours beyond, mean (most) |\n|---|" + 9 * "---:|")

_WATCH = """
new MutationObserver(() => { globalThis.readyAt ??= performance.now(); })
  .observe(document, {subtree: true, attributes: true, attributeFilter: ["data-state"]});
"""


def read(path):
    for ending, reader in READERS.items():
        if path.name.endswith(ending):
            reader = reader()
            reader.SetFileName(str(path))
            reader.Update()
            return reader.GetOutput()
    raise SystemExit(f"measure.py: {path} is none of {', '.join(READERS)}.")


def on_one_core():
    """Chromium with one core; this process keeps all."""
    cores = os.sched_getaffinity(0)
    os.sched_setaffinity(0, {min(cores)})
    try:
        return Chromium(size=(1300, 1300))
    finally:
        os.sched_setaffinity(0, cores)


def drag(browser):
    """Half to the right, half back; returns the milliseconds of pictures."""
    left, top, width, height = browser.box("slider")
    way = [0.25 + 0.5 * abs(1.0 - abs(2.0 * step / STEPS - 1.0)) for step in range(STEPS + 1)]
    actions = []
    for place in way:
        actions.append({"type": "pointerMove", "duration": 0, "x": int(left + place * width),
                        "y": int(top + height / 2.0), "origin": "viewport"})
        actions.append({"type": "pause", "duration": PAUSE})
    actions.insert(1, {"type": "pointerDown", "button": 0})
    actions.append({"type": "pointerUp", "button": 0})
    browser.perform({"type": "pointer", "id": "mouse", "parameters": {"pointerType": "mouse"}, "actions": actions})
    browser.settle()
    return browser.run("return isosurfaceView.steps;")


def differences(browser, scene):
    """Of each isovalue, the shares of pixels with other depths, and with other colours."""
    view = browser.view()
    for share in SHARES:
        browser.drag("slider", (share, 0.5))
        scene.show(browser.isovalue())
        planes = scene.planes()
        allowed = view["tolerance"] * view["voxel"]
        yield (share_of_other_depths(browser.depths(), planes.depth.astype(float), allowed),
               share_of_other_colors(browser.pixels(), scene.colors(planes)))


def percents(shares):
    return f"{100.0 * statistics.mean(shares):.3f} % ({100.0 * max(shares):.3f} %)"


def measure(browser, path, folder):
    """A row of the table."""
    image = read(path)
    low, high = image.GetScalarRange()
    scene = Scene(image, 0.5 * (low + high), SIZE)
    page, file = folder / "view.html", folder / "view.tcview"
    begin = time.perf_counter()
    scene.write(page)
    written = time.perf_counter() - begin
    scene.write(file)
    browser.open(page)
    browser.settle()
    first, ready = browser.run("""
        const paints = performance.getEntriesByName("first-contentful-paint");
        return [paints.length ? paints[0].startTime : NaN, globalThis.readyAt];""")
    steps = drag(browser)
    depths, colors = zip(*differences(browser, scene))
    return (f"| {path.name} | {page.stat().st_size / 1e6:.1f} | {file.stat().st_size / 1e6:.1f} | {written:.1f} s "
            f"| {first / 1e3:.2f} s | {ready / 1e3:.2f} s | {statistics.median(steps):.1f} ms "
            f"| {statistics.quantiles(steps, n=20)[-1]:.1f} ms | {percents(depths)} | {percents(colors)} |")


def main():
    if len(sys.argv) < 2 or sys.argv[1].startswith("-"):
        print(__doc__.strip())
        return 2
    print(HEAD, flush=True)
    with tempfile.TemporaryDirectory() as folder:
        for name in sys.argv[1:]:
            browser = on_one_core()
            try:
                browser.before_scripts(_WATCH)
                print(measure(browser, pathlib.Path(name), pathlib.Path(folder)), flush=True)
            finally:
                browser.quit()
    return 0


if __name__ == "__main__":
    sys.exit(main())
