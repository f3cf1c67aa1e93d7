#!/usr/bin/python3
# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""Makes a picture of a page that can be dragged, as Chromium shows it.

It needs Chromium and Selenium (Debian packages chromium-driver and python3-selenium). Without them
it says so, and ends with 77.
"""

import argparse
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "Testing" / "ViewPage"))
from chromium import Chromium

SIZE = (480, 680)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("page", type=Path, help="a page (.html)")
    parser.add_argument("picture", type=Path, help="where its picture goes (.png)")
    asked = parser.parse_args()
    browser = Chromium()
    try:
        browser.set_window(*SIZE)
        browser.set_scheme("light")
        browser.open(asked.page.resolve())
        asked.picture.write_bytes(browser.screenshot())
    finally:
        browser.quit()


if __name__ == "__main__":
    main()
