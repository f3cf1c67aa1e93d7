# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""Depths and normals of the images of a Cinema database. A row is a dictionary of read_cinema."""

import numpy
from browser import read_png

#: From the smallest depth of an image to the largest.
STEPS = 65534.0


def depths_of(row):
    """The depths of an image of 16 bits; infinity without a surface."""
    steps = read_png(row["FILE_depth"].read_bytes())
    assert steps.dtype == numpy.uint16, steps.dtype
    steps = steps[..., 0].astype(float)
    low, high = row["depth_min"], row["depth_max"]
    return numpy.where(steps > 0, low + (steps - 1.0) / STEPS * (high - low), numpy.inf)


def normals_of(row):
    """The normals of an image of three bytes a pixel; 0 without a surface."""
    bytes_ = read_png(row["FILE_normal"].read_bytes()).astype(float)
    return numpy.where(bytes_.any(axis=2, keepdims=True), (bytes_ - 128.0) / 127.0, 0.0)
