# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""Compares the pictures of several processes with those of one: ComparePictures.py DIRECTORY N ...

Where surfaces are opaque, a pixel differs that is not the same. Where they are translucent, colours of
8 bits are blended once more for each process: one differs that is off by more than 2 of 255.
Pictures alone-* are not made by several processes.
"""

import glob
import os
import sys

from Stage import check, count_different, read_picture

MOST_DIFFERENT = 0.001  # of the pixels


def main():
    """Compare all scenes."""
    directory, counts = sys.argv[1], sys.argv[2:]
    scenes = sorted(path[:-len("-1.png")] for path in glob.glob(os.path.join(directory, "*-1.png")))
    check(len(scenes) > 0, "distributed: there are pictures", len(scenes))
    for scene in scenes:
        name = os.path.basename(scene)
        if name.startswith("alone"):
            continue
        alone = read_picture(scene + "-1.png")
        tolerance = 2 if name.startswith("translucent") else 0
        check(alone.max() > 0, f"{name}: something is seen")
        for count in counts:
            path = f"{scene}-{count}.png"
            different = count_different(alone, read_picture(path), tolerance) \
                if os.path.exists(path) else alone.size
            check(different < MOST_DIFFERENT * alone.shape[0] * alone.shape[1],
                  f"{name}: {count} processes make the picture of one", f"{different} pixels differ")


main()
