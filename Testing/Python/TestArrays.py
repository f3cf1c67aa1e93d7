# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""NumPy arrays as volumes, and arrays of pictures: their memory is shared, kept and given back."""

import gc
import itertools
import os
import tempfile
import unittest
import weakref

import numpy
from spheres import distances, image_of, renderer_at, volume_of
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkTemporalCoherence import numpy_to_image, planes, render


def scalars_of(image):
    return vtk_to_numpy(image.GetPointData().GetScalars())


def ramp(dtype, shape=(2, 3, 4)):
    return numpy.arange(numpy.prod(shape)).astype(dtype).reshape(shape)


class Volumes(unittest.TestCase):
    def test_order_of_axes(self):
        array = ramp(numpy.float32)
        image = numpy_to_image(array, spacing=(1.0, 2.0, 3.0), origin=(4.0, 5.0, 6.0), name="u")
        self.assertEqual(image.GetDimensions(), (4, 3, 2))
        self.assertEqual(image.GetSpacing(), (1.0, 2.0, 3.0))
        self.assertEqual(image.GetOrigin(), (4.0, 5.0, 6.0))
        self.assertEqual(image.GetPointData().GetScalars().GetName(), "u")
        for z, y, x in itertools.product(range(2), range(3), range(4)):
            self.assertEqual(image.GetScalarComponentAsDouble(x, y, z, 0), array[z, y, x])

    def test_components(self):
        array = ramp(numpy.uint16, (2, 3, 4, 5))
        image = numpy_to_image(array)
        self.assertEqual(image.GetNumberOfScalarComponents(), 5)
        self.assertEqual(image.GetScalarComponentAsDouble(3, 1, 0, 2), array[0, 1, 3, 2])

    def test_memory_is_shared_where_it_can_be(self):
        array = ramp(numpy.int16)
        self.assertTrue(numpy.shares_memory(scalars_of(numpy_to_image(array)), array))
        fortran = numpy.asfortranarray(ramp(numpy.float64))
        self.assertTrue(numpy.shares_memory(scalars_of(numpy_to_image(fortran.T)), fortran))
        self.assertFalse(numpy.shares_memory(scalars_of(numpy_to_image(fortran)), fortran))
        numpy.testing.assert_array_equal(scalars_of(numpy_to_image(fortran)), fortran.ravel())
        part = ramp(numpy.float32, (4, 6, 8))[::2, 1:4, ::2]
        numpy.testing.assert_array_equal(scalars_of(numpy_to_image(part)), part.ravel())

    def test_types(self):
        for dtype in "?bBhHiIlLqQefd":
            for order in "=><":
                array = ramp(numpy.dtype(dtype).newbyteorder(order))
                if array.dtype.kind == "i":
                    array = -array
                image = numpy_to_image(array)
                self.assertEqual(image.GetScalarRange(), (array.min(), array.max()), array.dtype)
                scalars = scalars_of(image)
                numpy.testing.assert_array_equal(scalars, array.ravel())
                self.assertEqual(
                    numpy.shares_memory(scalars, array), array.dtype.isnative and dtype not in "?e")

    def test_mapped_files_are_not_read(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "a.npy")
            numpy.save(path, distances())
            mapped = numpy.load(path, mmap_mode="r")
            image = image_of(mapped)
            self.assertTrue(numpy.shares_memory(scalars_of(image), mapped))
            del mapped
            color = render(volume_of(image, 0.5), renderer_at(5.0), (64, 64)).color
        numpy.testing.assert_array_equal(
            color, render(volume_of(image_of(distances()), 0.5), renderer_at(5.0), (64, 64)).color)

    def test_what_is_written_to_the_array_is_drawn(self):
        array = distances()
        image = image_of(array)
        volume, renderer = volume_of(image, 0.5), renderer_at(5.0)
        self.assertTrue(render(volume, renderer, (64, 64)).color.any())
        array[:] = 0.0
        image.GetPointData().GetScalars().Modified()
        self.assertFalse(render(volume, renderer, (64, 64)).color.any())

    def test_mistakes(self):
        for wrong in ([[[0.0]]], vtkImageData(), None):
            with self.assertRaisesRegex(TypeError, r"must be a NumPy array, .*numpy.asarray\(\)"):
                numpy_to_image(wrong)
        with self.assertRaisesRegex(TypeError, r"masked array: give array.filled"):
            numpy_to_image(numpy.ma.zeros((2, 2, 2)))
        for wrong in (numpy.zeros(8), numpy.zeros((2, 2)), numpy.zeros((2,) * 5),
                      numpy.zeros((2, 0, 2))):
            with self.assertRaisesRegex(ValueError, r"must have the shape .*reshape"):
                numpy_to_image(wrong)
        for wrong in (complex, numpy.longdouble, object, "S3", "M8[s]"):
            with self.assertRaisesRegex(TypeError, "must hold real numbers .*convert"):
                numpy_to_image(numpy.zeros((2, 2, 2), wrong))


class Lifetimes(unittest.TestCase):
    def test_an_image_keeps_its_array_and_lets_go_of_it(self):
        array = distances()
        is_there = weakref.finalize(array, lambda: None)
        image = image_of(array)
        expected = array.copy()
        del array
        gc.collect()
        # Memory that was given back would now hold other numbers.
        others = [numpy.full_like(expected, 7.0) for _ in range(20)]
        numpy.testing.assert_array_equal(scalars_of(image), expected.ravel())
        # The scalars alone keep it, too, in another image.
        other = vtkImageData()
        other.ShallowCopy(image)
        del image, others
        gc.collect()
        numpy.testing.assert_array_equal(scalars_of(other), expected.ravel())
        self.assertTrue(is_there.alive)
        del other
        gc.collect()
        self.assertFalse(is_there.alive)

    def test_planes_outlive_their_mapper_and_its_next_frames(self):
        volume, renderer = volume_of(image_of(distances()), 0.5), renderer_at(5.0)
        first = render(volume, renderer, (64, 64))
        copies = [plane.copy() for plane in first]
        volume.GetProperty().GetIsoSurfaceValues().SetValue(0, 0.3)
        second = render(volume, renderer, (64, 64))
        self.assertGreater((second.depth != first.depth).sum(), 100)
        del volume, renderer, second
        gc.collect()
        for plane, copy in zip(first, copies):
            numpy.testing.assert_array_equal(plane, copy)
        first.depth[:] = 0.0

    def test_objects_end_in_any_order(self):
        names = ("array", "image", "mapper", "volume", "renderer", "picture")
        for order in itertools.permutations(names):
            array = distances()[::16, ::16, ::16].copy()
            there = {"array": array, "image": image_of(array), "renderer": renderer_at(5.0)}
            there["volume"] = volume_of(there["image"], 0.5)
            there["mapper"] = there["volume"].GetMapper()
            there["picture"] = render(there["volume"], there["renderer"], (8, 8))
            del array
            for name in order:
                del there[name]
                if "volume" in there and "renderer" in there:
                    self.assertEqual(
                        render(there["volume"], there["renderer"], (8, 8)).color.shape, (8, 8, 4))
                elif "mapper" in there:
                    planes(there["mapper"])

    def test_memory_is_given_back(self):
        def pages():
            with open("/proc/self/statm", encoding="ascii") as file:
                return int(file.read().split()[1])

        if not os.path.exists("/proc/self/statm"):
            self.skipTest("Memory is counted by Linux's /proc.")
        if "asan" in os.environ.get("LD_PRELOAD", ""):
            self.skipTest("Under the address sanitizer what is given back is kept for a while.")

        def pictures(count):
            for _ in range(count):
                volume = volume_of(image_of(distances()), 0.5)
                render(volume, renderer_at(5.0), (256, 256))

        pictures(10)
        before = pages()
        # A leak of one array or one picture would be more than 1 MiB a turn.
        pictures(40)
        self.assertLess((pages() - before) * os.sysconf("SC_PAGESIZE"), 16 << 20)


if __name__ == "__main__":
    unittest.main()
