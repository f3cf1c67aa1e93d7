# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""The truth, in NumPy: isosurfaces of a trilinear field, and label maps, on every ray in every cell.

It shares no code with the library. Each ray is cut at all planes between cells; between two cuts the
field is a cubic of the distance, which is sampled at five places, which tells it wholly.
"""

import numpy as np


def rays_of(camera, width, height):
    """Origins and unit directions of the rays through the centres of pixels, in rows."""
    matrix = camera.GetCompositeProjectionTransformMatrix(width / height, -1.0, 1.0)
    to_world = np.linalg.inv(
        np.array([[matrix.GetElement(i, j) for j in range(4)] for i in range(4)]))
    x, y = np.meshgrid((np.arange(width) + 0.5) / width * 2.0 - 1.0,
                       (np.arange(height) + 0.5) / height * 2.0 - 1.0)

    def unproject(depth):
        points = np.stack([x, y, np.full_like(x, depth), np.ones_like(x)], axis=-1) @ to_world.T
        return (points[..., :3] / points[..., 3:]).reshape(-1, 3)

    near, far = unproject(-1.0), unproject(1.0)
    directions = far - near
    return near, directions / np.linalg.norm(directions, axis=1, keepdims=True)


class Field:
    """Samples [i, j, k] at origin + spacing * (i, j, k)."""

    def __init__(self, samples, origin, spacing):
        self.samples = samples.astype(float)
        self.origin = np.array(origin, float)
        self.spacing = np.array(spacing, float)
        self.gradients = np.stack(
            [np.gradient(self.samples, self.spacing[a], axis=a) for a in range(3)], axis=-1)

    def _interpolate(self, samples, points):
        """Trilinear, at points in index space."""
        last = np.array(self.samples.shape) - 2
        cell = np.clip(np.floor(points).astype(int), 0, last)
        result = 0.0
        for corner in np.ndindex(2, 2, 2):
            weight = np.prod(np.where(corner, points - cell, 1.0 - (points - cell)), axis=-1)
            at = samples[tuple((cell + corner)[..., a] for a in range(3))]
            result = result + at * (weight[..., None] if at.ndim > weight.ndim else weight)
        return result

    def _enter(self, begins, steps):
        """Distances at which rays pass the planes between cells, ascending, within the box."""
        ends = np.array(self.samples.shape) - 1.0
        with np.errstate(divide="ignore", invalid="ignore"):
            first, last = (0.0 - begins) / steps, (ends - begins) / steps
        enter = np.nanmax(np.minimum(first, last), axis=1)
        leave = np.nanmin(np.maximum(first, last), axis=1)
        enter = np.maximum(enter, 0.0)
        cuts = [enter[:, None], leave[:, None]]
        for axis in range(3):
            with np.errstate(divide="ignore", invalid="ignore"):
                passes = (np.arange(self.samples.shape[axis])[None, :] - begins[:, axis:axis + 1]) \
                    / steps[:, axis:axis + 1]
            cuts.append(np.clip(np.nan_to_num(passes, nan=0.0), enter[:, None], leave[:, None]))
        return np.sort(np.concatenate(cuts, axis=1), axis=1), enter < leave

    def trace(self, origins, directions, isovalue, is_solid=False):
        """First distances at which rays meet the surface (infinity: never), and unit normals."""
        hits = np.full(len(origins), np.inf)
        for first in range(0, len(origins), 4096):
            part = slice(first, first + 4096)
            hits[part] = self._trace(origins[part], directions[part], isovalue, is_solid)
        found = np.isfinite(hits)
        normals = np.zeros_like(directions)
        points = (origins + np.where(found, hits, 0.0)[:, None] * directions - self.origin) \
            / self.spacing
        normals[found] = self._interpolate(self.gradients, points[found])
        normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-30)
        return hits, normals

    def _trace(self, origins, directions, isovalue, is_solid):
        begins, steps = (origins - self.origin) / self.spacing, directions / self.spacing
        cuts, in_box = self._enter(begins, steps)
        shares = np.linspace(0.0, 1.0, 5)[:-1]
        lengths = np.diff(cuts, axis=1)
        places = (cuts[:, :-1, None] + lengths[:, :, None] * shares).reshape(len(cuts), -1)
        places = np.concatenate([places, cuts[:, -1:]], axis=1)
        inside = self._at(begins, steps, places) >= isovalue
        meets = inside[:, 1:] != inside[:, :-1]
        hits = np.full(len(origins), np.inf)
        rows = np.nonzero(in_box & meets.any(axis=1))[0]
        step = meets[rows].argmax(axis=1)
        low, high = places[rows, step], places[rows, step + 1]
        was_inside = inside[rows, step]
        for _ in range(50):
            middle = 0.5 * (low + high)
            is_before = (self._at(begins[rows], steps[rows], middle[:, None])[:, 0]
                         >= isovalue) == was_inside
            low, high = np.where(is_before, middle, low), np.where(is_before, high, middle)
        hits[rows] = high
        if is_solid:
            capped = in_box & inside[:, 0]
            hits[capped] = places[capped, 0]
        return hits

    def _at(self, begins, steps, places):
        return self._interpolate(
            self.samples, begins[:, None, :] + places[..., None] * steps[:, None, :])


class LabelMap:
    """Labels [i, j, k] at origin + spacing * (i, j, k); a point has the label of the nearest sample."""

    def __init__(self, labels, origin, spacing):
        self.labels = labels
        self.origin = np.array(origin, float)
        self.spacing = np.array(spacing, float)

    def composite(self, origins, directions, looks):
        """Colours on rays: those of the labels that a ray enters, from front to back.

        looks: red, green, blue and opacity of each label that is drawn."""
        begins, steps = (origins - self.origin) / self.spacing, directions / self.spacing
        cuts = self._cut(begins, steps)
        last = np.full(len(begins), np.iinfo(int).min)
        colors, passed = np.zeros((len(begins), 3)), np.ones(len(begins))
        for near, far in zip(cuts[:-1], cuts[1:]):
            places = np.rint(begins + (0.5 * (near + far))[:, None] * steps).astype(int)
            places = np.clip(places, 0, np.array(self.labels.shape) - 1)
            is_in = far - near > 1e-9
            label = np.where(is_in, self.labels[tuple(places.T)], last)
            for drawn, look in looks.items():
                opacity = passed * look[3] * ((label == drawn) & (last != drawn))
                colors += opacity[:, None] * np.array(look[:3])
                passed -= opacity
            last = label
        return colors

    def _cut(self, begins, steps):
        """Distances at which rays come to other samples, ascending, within the box."""
        ends = np.array(self.labels.shape) - 1.0
        with np.errstate(divide="ignore", invalid="ignore"):
            first, last = (0.0 - begins) / steps, (ends - begins) / steps
            enter = np.maximum(np.nanmax(np.minimum(first, last), axis=1), 0.0)
            leave = np.maximum(np.nanmin(np.maximum(first, last), axis=1), enter)
            passes = [(place - begins[:, axis]) / steps[:, axis]
                      for axis in range(3) for place in np.arange(ends[axis]) + 0.5]
        passes = [np.clip(np.nan_to_num(cut, nan=0.0), enter, leave) for cut in passes]
        return np.sort(np.array([enter, leave, *passes]), axis=0)
