#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""Judge what run_tests.py has made: a line for each test and door, and how often each verdict came.

Doors: "factory", a test as it is with VTK_AUTOLOAD_PATH; "renamed", with the name of the class
changed; "surfaces-factory" and "surfaces-renamed", the same where each volume is made to show an
isosurface.
"""

import argparse
import collections
import json
import pathlib
import re
import sys

from pictures import agreement, is_same, likeness, read_picture

DOORS = ("factory", "renamed", "surfaces-factory", "surfaces-renamed")
# What outlines may differ by from those of VTK's volumes, and from those of polygons: the share of
# the pixels that strays, and the colours. VTK lights volumes a little differently before VTK 9.2.
# Polygons pass by the surface by a part of a voxel, so that a thread or a gap thinner than a pixel may
# come and go, and their normals are not smooth.
FROM_VTK = (0.0, 24)
FROM_POLYGONS = (0.005, 40)
# What blended volumes may differ by from VTK's, of 255: in the mean, and the share of the pixels that
# are far off. VTK takes samples at a distance; ours are in the limit of small steps.
LOOK = (4.0, 0.005)
GOOD = ("same", "look", "outline", "as documented", "SKIPPED")
MESSAGE = re.compile(r"\b(?:ERR|WARN)\| (vtkTemporalCoherence\w* \(0x[0-9a-f]+\)): (.*)")
DRAWN = re.compile(r"A volume is drawn by (\w+), since (.*?)(?:\x1b|$)", re.MULTILINE)


class Unfinished(Exception):
    """A run without a picture: the verdict, and which run it was."""


class Test:
    """What the runs of one test have left."""

    def __init__(self, place, name, result, reasons):
        self.place, self.name, self.result, self.reasons = place, name, result, reasons

    def log(self, run):
        return (self.place / run / f"{self.name}.log").read_text(encoding="utf-8", errors="replace")

    def drawers(self, run):
        """Who drew volumes that the factory made mappers for, and why."""
        return dict(DRAWN.findall(self.log(run)))

    def picture(self, run):
        if run not in self.result["runs"]:
            raise Unfinished("NOT RUN", run)
        status = self.result["runs"][run]["status"]
        if status is None:
            raise Unfinished("TOO SLOW", run)
        if status < 0 or status > 125:
            raise Unfinished("CRASH", f"{run}: status {status}")
        picture = read_picture(self.place / run / f"{self.name}.png")
        if picture is None:
            raise Unfinished("NO PICTURE", run)
        return picture

    def is_same(self, run, other):
        return is_same(self.picture(run), self.picture(other))

    def compare(self, run, reference):
        """Whether two runs show the same outlines, and the numbers."""
        found = agreement(self.picture(run), self.picture(reference), self.picture("hidden"))
        bounds = FROM_POLYGONS if reference.endswith("polygons") else FROM_VTK
        return found.is_within(*bounds), f"{found} (against {reference})"

    def excused(self, door, note, verdict="DIFFERENT"):
        """A verdict that is no mistake if there is a reason for it."""
        reason = self.reasons.get((door, self.name))
        return ("as documented", reason) if reason else (verdict, note)

    def judge_factory(self):
        """Isosurfaces have VTK's outlines; everything else is VTK's picture."""
        if self.is_same("factory", "vtk"):
            return "same", ""
        if "vtkTemporalCoherenceVolumeMapper" not in self.drawers("factory"):
            return self.excused("factory", "not VTK's picture")
        is_good, note = self.compare("factory", "vtk")
        return ("outline", note) if is_good else self.excused("factory", note)

    def judge_renamed(self):
        """Our mapper draws what it is asked for, or tells once why it does not."""
        messages = MESSAGE.findall(self.log("renamed"))
        often = [text for (_, text), count in collections.Counter(messages).items() if count > 1]
        if often:
            return "DIFFERENT", f"told more than once: {often[0]}"
        told = "; ".join(sorted({text.split(";")[0] for _, text in messages}))
        if self.is_same("renamed", "hidden"):
            if messages:
                return "as documented", told
            if self.is_same("vtk", "hidden"):
                return "same", "no volume is seen"
            return self.excused("renamed", "nothing is drawn, and nothing told", "SILENT")
        alike = likeness(*map(self.picture, ("renamed", "vtk", "hidden")))
        if alike.is_within(*LOOK):
            return "look", str(alike)
        is_good, note = self.compare("renamed", "vtk")
        note = f"{note}; {alike}"
        if is_good:
            return "outline", note
        if ("renamed", self.name) in self.reasons:
            return self.excused("renamed", note)
        is_good, note = self.compare("renamed", "polygons")
        if is_good:
            return "as documented", f"isosurfaces, as VTK's mapper is not asked for any; {note}"
        return "DIFFERENT", note

    def judge_surfaces(self, door):
        """The isosurface has the outline of polygons; VTK's own mapper may have drawn it instead."""
        drawers = self.drawers(door)
        why_vtk = drawers.get("vtkOpenGLGPUVolumeRayCastMapper")
        if door == "surfaces-factory" and "vtkTemporalCoherenceVolumeMapper" not in drawers:
            return "VTK draws", why_vtk or "the factory was not asked for the mapper"
        if self.is_same(door, "hidden") and self.is_same("surfaces-polygons", "hidden"):
            return "same", "no surface is seen"
        is_good, note = self.compare(door, "surfaces-polygons")
        if not is_good and why_vtk:
            return "VTK draws", f"some of it: {why_vtk}"
        return ("outline", note) if is_good else self.excused(door, note)

    def judge(self, door):
        if self.result["missing"]:
            return "SKIPPED", f"VTK's data has no {self.result['missing']}"
        try:
            self.picture(door)
            if door == "factory":
                return self.judge_factory()
            return self.judge_renamed() if door == "renamed" else self.judge_surfaces(door)
        except Unfinished as unfinished:
            return unfinished.args


def read_reasons(file):
    """Reasons for differences: lines of door, test and reason."""
    reasons = {}
    for line in file.read_text(encoding="utf-8").splitlines():
        if line and not line.startswith("#"):
            door, name, reason = line.split(maxsplit=2)
            reasons[door, name] = reason
    return reasons


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("place", type=pathlib.Path, help="where run_tests.py has left its files")
    arguments = parser.parse_args()

    results = json.loads((arguments.place / "results.json").read_text(encoding="utf-8"))
    reasons = read_reasons(pathlib.Path(__file__).with_name("differences.txt"))
    counts = {door: collections.Counter() for door in DOORS}
    for name, result in sorted(results.items()):
        test = Test(arguments.place, name, result, reasons)
        for door in DOORS:
            verdict, note = test.judge(door)
            counts[door][verdict] += 1
            print(f"{verdict:14}{door:18}{name}: {note}".rstrip(": "))
    print()
    for door in DOORS:
        told = ", ".join(f"{count} {verdict}" for verdict, count in counts[door].most_common())
        print(f"{door}: {told}")
    sys.exit(any(verdict not in GOOD and verdict != "VTK draws"
                 for door in DOORS for verdict in counts[door]))


if __name__ == "__main__":
    main()
