# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures as arrays, and how what one shows agrees with what another does."""

import dataclasses

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

# Of 255: pixels that differ by less are no outline. A translucent surface may have, by chance, the
# very colour of what is behind it.
LEAST_SEEN = 16
# Pixels that differ by more show something else.
FAR = 48


def read_picture(path):
    """The colours of a picture [row, column, channel], or None if it is not there."""
    if not path.exists():
        return None
    reader = vtkPNGReader()
    reader.SetFileName(str(path))
    reader.Update()
    image = reader.GetOutput()
    width, height, _ = image.GetDimensions()
    pixels = vtk_to_numpy(image.GetPointData().GetScalars())
    return pixels.reshape(height, width, -1)[:, :, :3].astype(int)


def is_same(one, other):
    """Whether two pictures are the same, byte for byte."""
    return one.shape == other.shape and (one == other).all()


def widened(mask):
    """Pixels of a mask and their neighbours."""
    wide = numpy.pad(mask, 1)
    height, width = mask.shape
    return numpy.any(
        [wide[y:y + height, x:x + width] for y in range(3) for x in range(3)], axis=0)


def astray(mask, other):
    """Pixels of one mask only that have no outline of both masks within a pixel."""
    outside = numpy.pad(~mask, 1, constant_values=True)
    at_outline = widened(outside)[1:-1, 1:-1]
    return mask & ~other & ~(widened(other) & at_outline)


@dataclasses.dataclass
class Likeness:
    """How far the pixels are apart that one of two pictures covers, of 255: in the mean, and the
    share of those that are far apart."""
    seen: int
    mean: float
    far: float

    def is_within(self, mean, far):
        """Whether there is something to see, and it looks alike."""
        return self.seen > 0 and self.mean <= mean and self.far <= far

    def __str__(self):
        return f"{self.seen} pixels apart by {self.mean:.2f}, {100 * self.far:.2f} % of them far"


def likeness(picture, reference, ground):
    """How alike two pictures are where they are unlike the ground."""
    if not picture.shape == reference.shape == ground.shape:
        return Likeness(0, 255.0, 1.0)
    difference = numpy.abs(picture - reference).max(axis=2)
    seen = (picture != ground).any(axis=2) | (reference != ground).any(axis=2)
    count = max(int(seen.sum()), 1)
    return Likeness(int(seen.sum()), float(difference[seen].sum() / count),
                    float((difference[seen] > FAR).sum() / count))


@dataclasses.dataclass
class Agreement:
    """Pixels that both pictures cover, that only one does, how many of these stray, and how far
    colours are apart in the middle of the pixels that both cover, of 255."""
    both: int
    only: int
    astray: int
    color: float

    def is_within(self, astray_share, color):
        """Whether no more than a share of the pixels strays, and colours are as near as this."""
        return (self.both > 0 and self.astray <= astray_share * self.both
                and self.color <= color)

    def __str__(self):
        return (f"{self.both} pixels of both, {self.only} of one, {self.astray} astray, "
                f"colours {self.color:g}")


def agreement(picture, reference, ground):
    """How two pictures agree where they are unlike the ground, the scene without what is judged."""
    if not picture.shape == reference.shape == ground.shape:
        return Agreement(0, 0, ground.size, 255)
    one, other = (picture != ground).any(axis=2), (reference != ground).any(axis=2)
    both = one & other
    difference = numpy.abs(picture - reference).max(axis=2)
    strays = (astray(one, other) | astray(other, one)) & (difference > LEAST_SEEN)
    return Agreement(
        int(both.sum()), int((one ^ other).sum()), int(strays.sum()),
        float(numpy.median(difference[both])) if both.any() else 0.0)
