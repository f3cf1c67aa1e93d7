# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""A page with damaged data, or in a browser that is too old, says a sentence about it, keeps its first
picture, and throws nothing."""

import re
import struct
import unittest
import zlib

import needed  # noqa: F401
import numpy
from pages import PageTest
from scenes import Scene, file_of, waves, with_file


def with_header(file, change):
    """A view file whose header's text is another one, with its checksum."""
    length = struct.unpack_from("<I", file, 12)[0]
    header = change(file[24:24 + length])
    return (file[:12] + struct.pack("<III", len(header), zlib.crc32(header), 0) + header + file[24 + length:])


class DamagedPages(PageTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        path = Scene(waves(), 1.3, (96, 80)).write(cls.folder / "whole.html")
        cls.page = path.read_text(encoding="utf-8")
        cls.file = file_of(cls.page)
        cls.begin_of_sections = 24 + struct.unpack_from("<I", cls.file, 12)[0]

    def assert_refused(self, page, pattern="."):
        """The page says one or more sentences, about what is wrong."""
        path = self.folder / "damaged.html"
        path.write_text(page, encoding="utf-8")
        self.browser.open(path, "failed")
        message = self.browser.text("message")
        self.assertRegex(message, r"^[A-Z].{15,}\.$")
        self.assertRegex(message, pattern)
        self.assertTrue(self.browser.run("const box = document.getElementById('message').getBoundingClientRect(); "
                                         "return box.width > 0 && box.height > 0;"))
        # The picture that needs no script stays.
        self.assertTrue(self.browser.run("const poster = document.getElementById('poster'); "
                                         "return poster !== null && poster.naturalWidth > 1;"))
        # Controls of nothing, used all the same.
        self.browser.press("s", "n", "f")
        self.browser.click("slider")
        self.assert_no_complaints()

    def refuse_file(self, file, pattern="."):
        self.assert_refused(with_file(self.page, bytes(file)), pattern)

    def test_whole(self):
        """Else all that follows is refused for another reason."""
        path = self.folder / "same.html"
        path.write_text(with_file(self.page, self.file), encoding="utf-8")
        self.browser.open(path)

    def test_cut(self):
        for length in (0, 5, 23, 24, 200, self.begin_of_sections, len(self.file) // 2, len(self.file) - 1):
            self.refuse_file(self.file[:length])

    def test_cut_page(self):
        """As by a mail program that sends a part of it: there is no script. The first picture shows."""
        path = self.folder / "cut.html"
        path.write_text(self.page[:len(self.page) // 2], encoding="utf-8")
        self.browser.go_to(path.as_uri())
        self.assertTrue(self.browser.run("return document.getElementById('poster').naturalWidth > 1;"))
        self.assert_no_complaints()

    def test_no_base64(self):
        self.assert_refused(re.sub(r'(id="view-file">)', r"\1%%%", self.page), "Base64")

    def test_version(self):
        file = bytearray(self.file)
        file[8] = 2
        self.refuse_file(file, "version 2")

    def test_another_file(self):
        self.refuse_file(b"\x89PNG\r\n\x1a\n" + bytes(100), "no view file")

    def test_header(self):
        file = bytearray(self.file)
        file[100] ^= 1
        self.refuse_file(file, "checksum")
        for change in (
                lambda header: b"{" + header, lambda header: header[:-1], lambda _: b"null", lambda _: b"[]",
                lambda _: b"{}", lambda header: header.replace(b'"views":', b'"view":'),
                lambda header: header.replace(b'"knots":', b'"knot":'),
                lambda header: header.replace(b'"rays":', b'"ray":'),
                lambda header: header.replace(b'"chunks":[{', b'"chunks":[null,{'),
                lambda header: re.sub(rb'"size":\[\d+,\d+\]', b'"size":[0,80]', header),
                lambda header: re.sub(rb'"size":\[\d+,\d+\]', b'"size":[16000,16000]', header),
                lambda header: re.sub(rb'"offset":\d+', b'"offset":1e300', header),
                lambda header: re.sub(rb'"unpacked":\d+', b'"unpacked":900000', header),
                lambda header: re.sub(rb'"direction":"\w+"', b'"direction":"__proto__"', header),
                lambda header: header.replace(b'"isovalue":', b'"isovalue":"a","x":')):
            changed = with_header(self.file, change)
            self.assertNotEqual(changed, self.file)
            self.refuse_file(changed)

    def test_bytes(self):
        """Any changed byte of the sections is found: each has a checksum."""
        random = numpy.random.default_rng(11)
        for place in random.integers(self.begin_of_sections, len(self.file), 12):
            file = bytearray(self.file)
            file[place] ^= 1 << int(random.integers(0, 8))
            self.refuse_file(file)

    def test_old_browser(self):
        identifier = self.browser.before_scripts("delete globalThis.DecompressionStream;")
        self.addCleanup(self.browser.drop_script, identifier)
        self.assert_refused(self.page, "too old")


if __name__ == "__main__":
    unittest.main()
