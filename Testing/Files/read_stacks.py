# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pages of TIFFs, and numbered pictures of a folder, are stacked as slices in the order of their numbers: values of all
types, spacings, remarks on gaps. Slices of another size or type are refused by name."""

from __future__ import annotations

import os
import pathlib
import struct
import sys
import unittest
import zlib

import read_files
from originals import ORIGINALS, SIZE, Original, ball, slices
from pictures import LONG, RATIO, SHORT, TEXT, png, tiff
from read_files import Files, Told, same

NX, NY, NZ = SIZE
BALL = [round(value) for value in ball()]
FIRST = [BALL[i] for i in (0, 1, NX, NX * NY, -1)]


def plane(value: int, code: str = "B", width: int = 4, height: int = 3) -> bytes:
    return struct.pack(f"<{width * height}{code}", *(value + i for i in range(width * height)))


def gray(value: int, width: int = 4, height: int = 3) -> bytes:
    return png(plane(value, width=width, height=height), width, height)


class Stacks(Files):
    def put(self, **files: bytes) -> pathlib.Path:
        """Pictures in a new folder: s3=... is s3.png or s3.tif."""
        folder = self.folder / str(len(list(self.folder.iterdir())))
        folder.mkdir()
        for name, data in files.items():
            (folder / (name + (".png" if data[:1] == b"\x89" else ".tif"))).write_bytes(data)
        return folder

    def told(self, path: pathlib.Path) -> Told:
        told = self.tell(path)
        self.assertEqual(told.status, 0, told.said)
        return told

    def test_whole_files(self) -> None:
        for kind in ("tiff-pages", "tiff-pages-zlib", "tiff-pages-tiles", "tiff-slices", "png-slices", "png-folder"):
            with self.subTest(kind=kind):
                told = self.read(ORIGINALS[kind](same))
                self.assert_close(told.values, FIRST)
                self.assertEqual(told.remark, "")

    def test_types(self) -> None:
        for code, bits, sample in (("B", 8, 1), ("b", 8, 2), ("H", 16, 1), ("h", 16, 2), ("I", 32, 1), ("i", 32, 2),
                                   ("f", 32, 3), ("Q", 64, 1), ("q", 64, 2), ("d", 64, 3)):
            for order in "<>":
                pages = [struct.pack(f"{order}12{code}", *range(k, k + 12)) for k in (1, 50)]
                told = self.read(Original("a.tif", {"a.tif": tiff(
                    pages, 4, 3, bits=bits, order=order, tags={339: (SHORT, sample)})}))
                self.assert_close(told.values, [1, 2, 5, 50, 61])
        folder = self.put(**{f"s{k}": png(struct.pack(">12H", *range(300 * k, 300 * k + 12)), 4, 3, bits=16)
                             for k in (1, 2)})
        self.assert_close(self.told(folder).values, [300, 301, 304, 600, 611])

    def test_colors(self) -> None:
        pixels = bytes(range(36))
        for data in (png(pixels, 4, 3, color=2), tiff([pixels], 12, 3, bits=8, tags={
                256: (LONG, 4), 262: (SHORT, 2), 277: (SHORT, 3), 258: (SHORT, [8, 8, 8])})):
            told = self.told(self.put(s1=data, s2=data))
            self.assert_close(told.values, [0, 3, 12, 0, 33])
        table = bytes(range(30)) + bytes(738)
        data = png(plane(0), 4, 3, color=3, colors=table)
        other = tiff([plane(0)], 4, 3, bits=8, tags={262: (SHORT, 3), 320: (SHORT, 768 * [0])})
        for one in (data, other):
            told = self.told(self.put(s1=one, s2=one))
            self.assert_close(told.values, [0, 1, 4, 0, 11])
            self.assertIn("colours from a table", told.remark)
        white = tiff([plane(0), plane(0)], 4, 3, bits=8, tags={262: (SHORT, 0)})
        self.assert_close(self.told(self.put(s1=white) / "s1.tif").values[:2], [255, 254])

    def test_places(self) -> None:
        def steps(**tags) -> list[float]:
            made = tiff(slices("<H"), NX, NY, tags={int(key[1:]): value for key, value in tags.items()})
            return [step[i] for i, step in enumerate(self.read(Original("a.tif", {"a.tif": made})).steps())]

        self.assert_close(steps(), [1, 1, 1])
        x, y = (RATIO, 4.0), (RATIO, 8.0)
        self.assert_close(steps(_282=x, _283=y, _296=(SHORT, 3)), [2.5, 1.25, 2.5])
        self.assert_close(steps(_282=x, _283=y, _296=(SHORT, 1)), [0.25, 0.125, 0.25])
        self.assert_close(steps(_282=x, _283=x, _296=(SHORT, 1), _270=(TEXT, b"ImageJ=1\nspacing=3.5\n")), [0.25, 0.25, 3.5])
        self.assert_close(steps(_282=(RATIO, 0.0), _283=y, _296=(SHORT, 2)), [1, 1, 1])
        told = self.read(Original("a.tif", {"a.tif": tiff([plane(0), plane(50)], 4, 3, bits=8, tags={274: (SHORT, 4)})}))
        self.assert_close(told.values, [8, 9, 4, 58, 53])

    def test_order_of_numbers(self) -> None:
        folder = self.put(**{f"a1_s{k}b": gray(k) for k in (1, 2, 3, 9, 10, 11)}, other=gray(77), a1_s=gray(99))
        (folder / "._a1_s2b.png").write_bytes(b"of a system")
        (folder / "readme.txt").write_bytes(b"text")
        for path in (folder, folder / "a1_s10b.png"):
            told = self.told(path)
            self.assert_close([told.values[0], told.values[3], told.values[4]], [1, 2, 22])
            self.assertIn("5 of 11 numbers are missing", told.remark)
        told = self.told(self.put(**{f"s{k:03}": gray(k) for k in (0, 10, 20)}))
        self.assertEqual(told.remark, "")
        told = self.told(self.put(s1=gray(1), s2=gray(2), t3=gray(3)))
        self.assertIn("1 of 3 pictures", told.remark)

    def test_slices_that_differ(self) -> None:
        for data, words in ((gray(3, 5), "5 x 3, unsigned char"), (gray(3, 4, 4), "4 x 4"),
                            (png(2 * plane(3), 4, 3, bits=16), "unsigned short"),
                            (png(3 * plane(3), 4, 3, color=2), "3 x unsigned char"),
                            (png(plane(3), 4, 3, color=3, colors=bytes(768)), "palette")):
            folder = self.put(s1=gray(1), s2=gray(2), s10=data, s11=data)
            for path in (folder, folder / "s2.png"):
                self.assert_refused(self.tell(path), "s10.png", words, "another size or type")
        pages = tiff([plane(0), plane(1)], 4, 3, bits=8)
        other = tiff([plane(0, width=3)], 3, 3, bits=8)
        self.assert_refused(self.tell(self.put(s1=tiff([plane(1)], 4, 3, bits=8), s2=other)), "s2.tif", "3 x 3")
        self.assert_refused(self.tell(self.put(s1=tiff([plane(1)], 4, 3, bits=8), s2=pages) / "s1.tif"),
                            "s2.tif", "several pictures")

    def test_refusals(self) -> None:
        for path, words in (
                (self.put(a=gray(1)) / "a.png", "one slice"), (self.put(a1=gray(1)) / "a1.png", "one slice"),
                (self.put(a1=gray(1), b=gray(1)), "one slice"), (self.put(a1=gray(1), a01=gray(2)), "the number of another"),
                (self.put(a1=tiff([plane(1)], 4, 3, bits=8)) / "a1.tif", "one slice")):
            self.assert_refused(self.tell(path), str(path), words)
        one = plane(1)
        huge = tiff([one], 4, 3, bits=8, tags={256: (LONG, 2**20), 257: (LONG, 2**20)})
        self.assert_refused(self.tell(self.put(a1=huge, a2=huge)), "more samples than it can hold")
        for tags, words in (({258: (SHORT, 1)}, "1 bits"), ({258: (SHORT, 24)}, "24 bits"), ({339: (SHORT, 5)}, "format"),
                            ({262: (SHORT, 5)}, "neither grey nor RGB"), ({259: (SHORT, 34712)}, "compression"),
                            ({256: (LONG, 0)}, ""), ({256: (LONG, 2**31)}, "2147483648"),
                            ({277: (SHORT, 2), 284: (SHORT, 2)}, "planes"),
                            ({270: (TEXT, b"ImageJ=1\nimages=30\n")}, "ImageJ")):
            with self.subTest(tags=tags):
                data = tiff([one], 4, 3, bits=8, tags=tags)
                self.assert_refused(self.tell(self.put(a1=data, a2=data)), "a1.tif", words)

    def test_broken_files(self) -> None:
        data = tiff([plane(1)], 4, 3, bits=8)
        folder = self.put(s1=data, s2=data)
        for size in (0, 7, 9, len(data) // 2, len(data) - 20, len(data) - 5):  # the last 4 tell of no more pages
            (folder / "s2.tif").write_bytes(data[:size])
            self.assert_refused(self.tell(folder), "s2.tif")
        whole = gray(2)
        folder = self.put(s1=gray(1), s2=whole)
        for at in range(0, len(whole) - 4, 3):  # a sum of each part is in the file; new libpng skips that of the end
            (folder / "s2.png").write_bytes(whole[:at] + bytes([whole[at] ^ 16]) + whole[at + 1:])
            self.assert_refused(self.tell(folder), "s2.png")
        short = whole.replace(zlib.compress(b"".join(b"\0" + plane(2)[4 * j:4 * j + 4] for j in range(3))), b"")
        (folder / "s2.png").write_bytes(short)
        self.assert_refused(self.tell(folder), "s2.png")

    def test_links(self) -> None:
        folder = self.put(**{f"s{k}": gray(k) for k in (1, 2, 4, 5)})
        os.symlink("s3.png", folder / "s3.png")
        self.assertIn("1 of 5 numbers are missing", self.told(folder).remark)
        self.assert_refused(self.tell(folder / "s3.png"), "s3.png")
        (folder / "s2.png").unlink()
        os.mkfifo(folder / "s2.png")
        self.assertIn("2 of 5 numbers are missing", self.told(folder).remark)
        pages = bytearray(tiff([plane(0), plane(1)], 4, 3, bits=8))
        first = struct.unpack_from("<I", pages, 4)[0]
        entries = struct.unpack_from("<H", pages, first)[0]
        place = first + 2 + 12 * entries
        struct.pack_into("<I", pages, struct.unpack_from("<I", pages, place)[0] + 2 + 12 * entries, first)
        (folder / "loop.tif").write_bytes(pages)
        self.assert_refused(self.tell(folder / "loop.tif"), "loop.tif")


if __name__ == "__main__":
    read_files.OPENER = sys.argv.pop(1)
    unittest.main()
