# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""A window refines itself in VTK's own event loop, and tells Python how far it is."""

import gc
import unittest

import vtkmodules.vtkInteractionStyle  # noqa: F401
from spheres import distances, image_of, renderer_at
from vtkmodules.util.misc import calldata_type
from vtkmodules.util.vtkConstants import VTK_DOUBLE
from vtkmodules.vtkRenderingCore import vtkRenderWindow, vtkRenderWindowInteractor
from vtkTemporalCoherence import (
    isosurface, vtkTemporalCoherenceRefiner, vtkTemporalCoherenceVolumeMapper)


class Refiner(unittest.TestCase):
    def setUp(self):
        surface = isosurface(image_of(distances()), 0.5, ambient_occlusion=True)
        self.mapper = surface.GetMapper()
        renderer = renderer_at(4.0)
        renderer.AddVolume(surface)
        self.window = vtkRenderWindow()
        self.window.SetMultiSamples(0)
        self.window.SetSize(60, 60)
        self.window.AddRenderer(renderer)
        self.refiner = vtkTemporalCoherenceRefiner()

    def test_in_an_event_loop(self):
        interactor = vtkRenderWindowInteractor()
        interactor.SetRenderWindow(self.window)
        interactor.Initialize()
        told, of_mapper = [], []

        @calldata_type(VTK_DOUBLE)
        def tell(_refiner, _event, progress):
            told.append(progress)
            if progress == 1.0:
                interactor.TerminateApp()

        @calldata_type(VTK_DOUBLE)
        def hear(_mapper, _event, progress):
            of_mapper.append(progress)

        self.refiner.SetInteractor(interactor)
        self.refiner.AddObserver("ProgressEvent", tell)
        self.mapper.AddObserver(vtkTemporalCoherenceVolumeMapper.FrameProgressEvent, hear)
        self.window.Render()
        interactor.Start()
        self.assertTrue(self.mapper.GetFrameIsFinal())
        self.assertGreater(len(told), 8)
        self.assertEqual(told, sorted(told))
        self.assertEqual(told, of_mapper)
        self.assertEqual(self.refiner.GetProgress(), 1.0)

    def test_without_one(self):
        self.refiner.SetRenderWindow(self.window)
        self.assertTrue(self.refiner.Refine())
        self.assertTrue(self.mapper.GetFrameIsFinal())

    def test_keeps_nothing_alive(self):
        self.refiner.SetRenderWindow(self.window)
        self.window.Render()
        self.window = None
        gc.collect()
        self.assertIsNone(self.refiner.GetRenderWindow())
        self.assertEqual(self.refiner.GetReferenceCount(), 1)


if __name__ == "__main__":
    unittest.main()
