# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""Volumes that are read as they are needed: folders of Zarr, raw samples and stacks of slices have the samples, places
and pictures of files that are read whole. What is broken, missing or of another format is refused in one sentence."""

from __future__ import annotations

import json
import os
import pathlib
import sys
import tempfile
import unittest

import read_files
from originals import ORIGINALS, SIZE, ball
from read_files import Files, same

NX, NY, NZ = SIZE
BALL = bytes(round(value) for value in ball())
FIRST = [BALL[i] for i in (0, 1, NX, NX * NY, -1)]
CHUNK = (4, 5, 6)  # of z, y and x


class Large(Files):
    def zarr(self, **changes) -> pathlib.Path:
        """A folder of OME-Zarr with one level, in chunks that do not fit the volume."""
        folder = self.folder / "a.zarr"
        (folder / "0").mkdir(parents=True)
        scale = {"type": "scale", "scale": [3, 2, 0.5]}
        axes = [{"name": name, "type": "space"} for name in "zyx"]
        (folder / ".zgroup").write_text('{"zarr_format": 2}')
        (folder / ".zattrs").write_text(json.dumps({"multiscales": [{
            "version": "0.4", "axes": axes, "datasets": [{"path": "0", "coordinateTransformations": [scale]}]}]}))
        (folder / "0" / ".zarray").write_text(json.dumps({
            "zarr_format": 2, "shape": [NZ, NY, NX], "chunks": CHUNK, "dtype": "|u1", "compressor": None,
            "fill_value": 0, "order": "C", "filters": None, **changes}))
        for z, y, x in ((z, y, x) for z in range(2) for y in range(2) for x in range(2)):
            (folder / "0" / f"{z}.{y}.{x}").write_bytes(bytes(
                self.sample(CHUNK[0] * z + k, CHUNK[1] * y + j, CHUNK[2] * x + i)
                for k in range(CHUNK[0]) for j in range(CHUNK[1]) for i in range(CHUNK[2])))
        return folder

    @staticmethod
    def sample(z: int, y: int, x: int) -> int:
        return BALL[x + NX * (y + NY * z)] if x < NX and y < NY and z < NZ else 0

    def test_zarr(self) -> None:
        folder = self.zarr()
        for _ in range(2):  # the second time, value ranges come from their file
            told = self.tell(folder)
            self.assertEqual(told.status, 0, told.said)
            self.assert_close(told.values, FIRST)
            self.assertEqual(told.range, (min(BALL), max(BALL)))
            self.assert_close([step[i] for i, step in enumerate(told.steps())], [0.5, 2, 3])
            self.assertIn("read as it is needed", told.remark)
        for way in ("explorer", "orbit"):
            drawn = self.tell(folder, way=way)
            self.assertEqual((drawn.status, drawn.said), (0, ""))

    def test_same_as_whole_files(self) -> None:
        for kind in ("mhd", "mha", "nrrd", "nhdr", "vti-raw", "tiff-pages", "tiff-pages-zlib", "tiff-slices",
                     "png-slices", "png-folder"):
            with self.subTest(kind=kind):
                path = self.write(ORIGINALS[kind](same))
                told, large = self.tell(path), self.tell(path, way="large-tell")
                self.assertEqual(large.status, 0, large.said)
                self.assertEqual((large.values, large.places, large.range), (told.values, told.places, told.range))
                self.assertIn("read as it is needed", large.remark)
                for way in ("large-explorer", "large-orbit"):
                    drawn = self.tell(path, way=way)
                    self.assertEqual((drawn.status, drawn.said), (0, ""))
        original = ORIGINALS["raw"](same)
        drawn = self.tell(self.write(original), original.layout, "large-explorer")
        self.assertEqual((drawn.status, drawn.said), (0, ""))

    def test_formats_that_are_read_whole(self) -> None:
        for kind in ("mhd-zlib", "nrrd-gzip", "nrrd-text", "vti-raw-zlib", "vti-ascii", "nii", "vtk-binary", "vtu", "slc"):
            with self.subTest(kind=kind):
                path = self.write(ORIGINALS[kind](same))
                self.assert_refused(self.tell(path, way="large-tell"), str(path), "leave out --large")
        rescaled = self.write(ORIGINALS["mhd"](same))
        rescaled.write_bytes(b"ElementToIntensityFunctionOffset = -5\n" + rescaled.read_bytes())
        self.assert_refused(self.tell(rescaled, way="large-tell"), "stand for other values", "leave out --large")

    def test_broken_zarr(self) -> None:
        folder = self.zarr()
        self.assert_refused(self.tell(folder, time_step=2), "a.zarr")
        whole = (folder / "0" / "1.1.1").read_bytes()
        for chunk in (whole[:-1], b"", whole + b"\0"):
            # What cannot be read is shown as zeros, with a word, by what draws.
            (folder / "0" / "1.1.1").write_bytes(chunk)
            self.assertEqual(self.tell(folder).status, 0)
            drawn = self.tell(folder, way="orbit")
            self.assertIn("1.1.1", drawn.said)
        (folder / "0" / "1.1.1").write_bytes(whole)
        header = (folder / "0" / ".zarray").read_text()
        for text in ("", header[:-9], header.replace("|u1", "<x9"), header.replace(str(NX), "-1"), "[]",
                     header.replace('"shape"', '"form"')):
            (folder / "0" / ".zarray").write_text(text)
            for way in ("tell", "explorer", "orbit"):
                self.assert_refused(self.tell(folder, way=way), "a.zarr")
        (folder / ".zattrs").write_text("{")
        self.assert_refused(self.tell(folder), "a.zarr")

    def test_broken_others(self) -> None:
        for name in ("a.h5", "a.ims", "a.hdf5"):
            path = self.folder / name
            for data in (b"", b"\x89HDF\r\n\x1a\n", bytes(5000)):
                path.write_bytes(data)
                self.assert_refused(self.tell(path), name)
        path = self.write(ORIGINALS["tiff-slices"](same))
        path.write_bytes(path.read_bytes()[:-30])
        self.assert_refused(self.tell(path, way="large-tell"), path.name)
        path = self.write(ORIGINALS["mhd"](same))
        samples = path.with_suffix(".raw")
        samples.write_bytes(samples.read_bytes()[:-1])
        self.assert_refused(self.tell(path, way="large-tell"), "a.mhd", "a.raw")
        thin = self.zarr(shape=[1, NY, NX])
        self.assert_refused(self.tell(thin), "9 x 8 x 1 samples")


if __name__ == "__main__":
    read_files.OPENER = sys.argv.pop(1)
    with tempfile.TemporaryDirectory() as caches:
        os.environ["XDG_CACHE_HOME"] = caches  # where value ranges of stacks go
        unittest.main()
