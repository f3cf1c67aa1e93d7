# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""Segmentations in one call: labels with names and colours, and sentences for mistakes."""

import unittest

import numpy
import vtkTemporalCoherence
from vtkTemporalCoherence import segmentation

NAMES = {1: "liver", 2: "spleen", 700: "bone"}


def balls(dtype=numpy.uint16):
    """Three balls, two of which touch, indexed [z, y, x]."""
    z, y, x = numpy.mgrid[:24, :28, :32].astype(float)
    labels = numpy.zeros(x.shape, dtype)
    for label, (a, b, c), radius in ((1, (9, 14, 12), 7), (2, (17, 14, 12), 6), (700, (27, 8, 6), 3)):
        labels[(x - a) ** 2 + (y - b) ** 2 + (z - c) ** 2 < radius ** 2] = label
    return labels


def seen(volume):
    return set(numpy.unique(volume.picture((120, 100)).isovalue_index)) - {-1}


class Segmentation(unittest.TestCase):
    def test_all_labels_are_seen(self):
        for dtype in (numpy.uint16, numpy.int32, numpy.int64):
            volume = segmentation(balls(dtype), NAMES)
            self.assertEqual(volume.labels, (1, 2, 700))
            self.assertEqual(volume.names, NAMES)
            self.assertEqual(seen(volume), {1, 2, 700})

    def test_some_labels_are_shown(self):
        volume = segmentation(balls(), NAMES, shown=["spleen", 700])
        self.assertEqual(volume.shown, (2, 700))
        self.assertEqual(seen(volume), {2, 700})
        volume.shown = "liver"
        self.assertEqual(seen(volume), {1})
        volume.shown = ()
        self.assertEqual(seen(volume), set())
        self.assertEqual(seen(segmentation(balls(), outside=1)), {0})

    def test_colors_are_those_that_are_given(self):
        volume = segmentation(balls(), NAMES, color={"liver": "red", 2: (0.0, 1.0, 0.0)}, lighting=False)
        volume.set_color("bone", "#0000ff")
        picture = volume.picture((120, 100))
        middle = picture.isovalue_index
        # Edges are antialiased: most pixels of a label have its colour.
        for label, color in ((1, (255, 0, 0)), (2, (0, 255, 0)), (700, (0, 0, 255))):
            colors = picture.color[middle == label][:, :3]
            self.assertGreater((colors == color).all(axis=1).mean(), 0.5, label)

    def test_what_is_behind_a_translucent_label_is_seen(self):
        opaque = segmentation(balls(), NAMES, lighting=False, color={1: "red", 2: "lime"})
        clear = segmentation(
            balls(), NAMES, lighting=False, color={1: "red", 2: "lime"}, opacity={"liver": 0.3})
        for volume in (opaque, clear):
            volume.look_from((-1.0, 0.0, 0.0))
        self.assertEqual(seen(clear), seen(opaque))
        pixel = (50, 60)
        self.assertEqual(tuple(opaque.picture((120, 100)).color[pixel][:2]), (255, 0))
        self.assertGreater(clear.picture((120, 100)).color[pixel][1], 100)
        clear.set_opacity("liver", 1.0)
        self.assertEqual(tuple(clear.picture((120, 100)).color[pixel][:2]), (255, 0))

    def test_painting_is_seen(self):
        labels = balls()
        volume = segmentation(labels, NAMES, radius=0)
        before = volume.picture((120, 100)).isovalue_index.copy()
        labels[10:14, 8:20, 8:20] = 2
        volume.data_changed()
        self.assertTrue((volume.picture((120, 100)).isovalue_index != before).any())

    def test_strokes_are_seen_where_they_are_told(self):
        labels = balls()
        volume = segmentation(labels, NAMES, radius=0)
        volume.picture((120, 100))
        for where, label in (
            (numpy.s_[10:14, 8:20, 8:20], 2), (numpy.s_[12, 10:, -20:-3], 9), (numpy.s_[5:2], 1),
            (numpy.s_[::5, 3], 700), (7, 70)):
            labels[where] = label
            volume.data_changed(where)
            told = volume.picture((120, 100)).isovalue_index
            new = segmentation(labels, radius=0).picture((120, 100)).isovalue_index
            self.assertTrue((told == new).all(), where)
        self.assertEqual(set(volume.shown), {1, 2, 9, 70, 700})
        labels[3:5, 3:5, 3:5] = 5
        volume.data_changed()
        self.assertIn(5, volume.shown)
        for wrong, error in ((numpy.s_[99], IndexError), ("here", TypeError), ((1, 2, 3, 4), TypeError)):
            with self.assertRaises(error):
                volume.data_changed(wrong)

    def test_mistakes_are_sentences(self):
        for wrong, error, sentence in (
            (lambda: segmentation(balls().astype(float)), ValueError, "whole numbers"),
            (lambda: segmentation(balls(), shown=["heart"]), ValueError, "No label is called 'heart'"),
            (lambda: segmentation(balls(), shown=[9]), ValueError, "no label 9"),
            (lambda: segmentation(balls(), {9: "heart"}, color={"heart": "red"}), ValueError, "no label 9"),
            (lambda: segmentation(balls(), opacity=2.0), ValueError, "from 0 to 1"),
            (lambda: segmentation(balls(), color={1: "reddish"}), ValueError, "no colour 'reddish'"),
            (lambda: segmentation([[1, 2]]), TypeError, "numpy.asarray"),
        ):
            with self.assertRaisesRegex(error, sentence):
                wrong()

    def test_names_are_public(self):
        self.assertIn("segmentation", vtkTemporalCoherence.__all__)
        self.assertIn("SegmentationVolume", repr(segmentation(balls())))


if __name__ == "__main__":
    unittest.main()
