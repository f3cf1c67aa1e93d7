# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""Lists of files for times, .pvd and .series, give time steps in the order of their times. Files that are missing,
lists in lists and lists that are cut short are refused."""

from __future__ import annotations

import json
import os
import sys
import unittest

import meshes
import read_files
from originals import ORIGINALS, Original
from read_files import Files, same


def image(size: str) -> bytes:
    """One whose range tells it from others."""
    text = ORIGINALS["mha"](same).files["a.mha"]
    return text.replace(b"ElementDataFile", b"ElementToIntensityFunctionSlope = %s\nElementDataFile" % size.encode(), 1)


FILES = {f"{k}.mha": image(str(k)) for k in (1, 2, 3)}


def as_json(*entries, **more) -> Original:
    files = [{"name": name, "time": time} for name, time in entries]
    return Original("a.mha.series", {"a.mha.series": json.dumps(
        {"file-series-version": "1.0", "files": files, **more}).encode(), **FILES})


def as_pvd(sets: str, files: dict[str, bytes] | None = None) -> Original:
    return Original("a.pvd", {"a.pvd": f"""<?xml version="1.0"?>
<VTKFile type="Collection" version="0.1"><Collection>{sets}</Collection></VTKFile>""".encode(), **(files or FILES)})


def data_set(name: str, time: object, part: int = 0) -> str:
    return f'<DataSet timestep="{time}" group="" part="{part}" file="{name}"/>'


class Lists(Files):
    def assert_steps(self, original: Original, *factors: int) -> None:
        path = self.write(original)
        for step, factor in enumerate(factors, 1):
            told = self.tell(path, time_step=step)
            self.assertEqual(told.status, 0, told.said)
            self.assertAlmostEqual(told.range[1] / factor / self.most, 1.0)
        self.assert_refused(
            self.tell(path, time_step=len(factors) + 1), original.main, f"{len(factors)} time steps")

    def setUp(self) -> None:
        super().setUp()
        self.most = self.read(Original("1.mha", {"1.mha": FILES["1.mha"]})).range[1]

    def test_time_steps_in_the_order_of_times(self) -> None:
        entries = (("3.mha", 10), ("1.mha", -1.5), ("2.mha", 9))
        self.assert_steps(as_json(*entries), 1, 2, 3)
        self.assert_steps(as_json(("3.mha", None), ("1.mha", None)), 3, 1)
        self.assert_steps(as_json(("3.mha", 1), ("1.mha", 1)), 3, 1)
        self.assert_steps(as_pvd("".join(data_set(*entry) for entry in entries)), 1, 2, 3)

    def test_names(self) -> None:
        folder = self.folder / "of parts"
        folder.mkdir()
        (folder / "a & b.mha").write_bytes(FILES["2.mha"])
        self.assert_steps(as_json(("of parts/a & b.mha", 0)), 2)
        self.assert_steps(as_pvd(data_set("of parts/a &amp; b.mha", 0)), 2)
        self.assert_steps(as_pvd(data_set(str(folder / "a &amp; b.mha"), 0)), 2)

    def test_parts_of_one_time(self) -> None:
        grids = {"b.vtu": meshes.vtu(same), "c.vtu": meshes.vtu(same), **FILES}
        told = self.tell(self.write(as_pvd(data_set("b.vtu", 0) + data_set("c.vtu", 0, 1), grids)))
        self.assertEqual((told.status, told.array), (0, "ball"), told.said)
        told = self.tell(self.write(as_pvd(data_set("1.mha", 0) + data_set("3.mha", 0, 1))))
        self.assertAlmostEqual(told.range[1], 3 * self.most)

    def test_files_that_cannot_be_had(self) -> None:
        for make in (as_json, lambda *entries: as_pvd("".join(data_set(*entry) for entry in entries))):
            for name, words in (("4.mha", "not there"), (".", "not there"), ("/dev/zero", "not there"),
                                ("a.pvd", "another list"), ("a.mha.series", "another list"), ("", "no name")):
                original = make(("1.mha", 0), (name, -1))
                with self.subTest(name=name, main=original.main):
                    self.assert_refused(self.tell(self.write(original)), original.main, words)
            (self.folder / "5.txt").write_bytes(b"no volume")
            self.assert_refused(self.tell(self.write(make(("5.txt", 0)))), "5.txt", "suffix")
            original = make(("1.mha", 0))
            original.files["1.mha"] = FILES["1.mha"][:-9]
            self.assert_refused(self.tell(self.write(original)), "1.mha", "fewer samples")

    def test_links_to_themselves(self) -> None:
        for name in ("b.pvd", "b.series"):
            os.symlink(name, self.folder / name)
            self.assert_refused(self.tell(self.folder / name), name)
            os.symlink("a.pvd", self.folder / f"{name}.mha")
            self.assert_refused(self.tell(self.write(as_pvd(data_set(f"{name}.mha", 0)))), f"{name}.mha")

    def test_lists_that_are_broken(self) -> None:
        for original in (as_json(("1.mha", 0)), as_pvd(data_set("1.mha", 0))):
            data = original.files[original.main]
            for size in (0, 1, len(data) // 2, len(data) - 1):
                original.files[original.main] = data[:size]
                self.assert_refused(self.tell(self.write(original)), original.main, "no whole")
        for text in (b"[]", b"{}", b'{"files": 3}', b'{"files": []}', b'{"files": [3]}', b'{"files": [{"time": 1}]}',
                     b'{"files": [{"name": "1.mha", "time": "x"}]}', b'{"files": ' + 10**6 * b"["):
            self.assert_refused(self.tell(self.write(Original("a.series", {"a.series": text}))), "a.series")
        for sets in ("", data_set("1.mha", "x"), data_set("1.mha", "nan"), data_set("1.mha", 1e999), 10**6 * "<x>",
                     "<DataSet/>"):
            self.assert_refused(self.tell(self.write(as_pvd(sets))), "a.pvd")


if __name__ == "__main__":
    read_files.OPENER = sys.argv.pop(1)
    unittest.main()
