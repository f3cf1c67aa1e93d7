# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""Volumes that are read when they are needed show what arrays in memory show: of a path, of a folder of
Zarr, of raw samples, and of a reader in Python. Mistakes are exceptions that name the file."""

import json
import pathlib
import tempfile
import unittest

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.util.vtkAlgorithm import VTKPythonAlgorithmBase
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm, vtkStreamingDemandDrivenPipeline

from vtkTemporalCoherence import isosurface, open_volume, vtkTemporalCoherenceBrickSource

SHAPE = (45, 50, 55)


def waves() -> numpy.ndarray:
    z, y, x = numpy.indices(SHAPE)
    return (1000.0 * numpy.sin(0.3 * x) * numpy.cos(0.2 * y + 0.1 * z)).astype(numpy.int16)


def picture(data) -> numpy.ndarray:
    return numpy.asarray(isosurface(data, 100).picture((80, 60)).color)


class Slices(VTKPythonAlgorithmBase):
    """Gives what it is asked for."""

    def __init__(self, samples):
        super().__init__(nInputPorts=0, nOutputPorts=1, outputType="vtkImageData")
        self.samples = samples
        self.asked = []

    def RequestInformation(self, request, inputs, outputs):
        output = outputs.GetInformationObject(0)
        z, y, x = self.samples.shape
        output.Set(vtkStreamingDemandDrivenPipeline.WHOLE_EXTENT(), 0, x - 1, 0, y - 1, 0, z - 1)
        output.Set(vtkAlgorithm.CAN_PRODUCE_SUB_EXTENT(), 1)
        return 1

    def RequestData(self, request, inputs, outputs):
        e = outputs.GetInformationObject(0).Get(vtkStreamingDemandDrivenPipeline.UPDATE_EXTENT())
        self.asked.append(e)
        part = self.samples[e[4]:e[5] + 1, e[2]:e[3] + 1, e[0]:e[1] + 1]
        image = vtkImageData.GetData(outputs)
        image.SetExtent(e)
        image.GetPointData().SetScalars(numpy_to_vtk(numpy.ascontiguousarray(part).ravel(), deep=True))
        return 1


class LargeVolumes(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.path = pathlib.Path(self.folder.name)
        self.samples = waves()
        self.expected = picture(self.samples)

    def tearDown(self):
        self.folder.cleanup()

    def test_path(self):
        self.samples.astype("<i2").tofile(self.path / "waves.raw")
        z, y, x = SHAPE
        (self.path / "waves.mhd").write_text(
            f"ObjectType = Image\nNDims = 3\nDimSize = {x} {y} {z}\nElementType = MET_SHORT\n"
            f"ElementByteOrderMSB = False\nElementDataFile = waves.raw\n")
        numpy.testing.assert_array_equal(picture(self.path / "waves.mhd"), self.expected)
        numpy.testing.assert_array_equal(picture(str(self.path / "waves.mhd")), self.expected)
        self.assertTrue((self.path / "waves.mhd.ranges").exists())

    def test_zarr(self):
        folder = self.path / "waves.zarr"
        (folder / "0").mkdir(parents=True)
        (folder / ".zgroup").write_text(json.dumps({"zarr_format": 2}))
        (folder / ".zattrs").write_text(json.dumps({"multiscales": [{
            "version": "0.4", "axes": [{"name": name, "type": "space"} for name in "zyx"],
            "datasets": [{"path": "0", "coordinateTransformations": [
                {"type": "scale", "scale": [1.0, 1.0, 1.0]}]}]}]}))
        (folder / "0/.zarray").write_text(json.dumps({
            "zarr_format": 2, "shape": SHAPE, "chunks": [20, 20, 20], "dtype": "<i2", "compressor": None,
            "fill_value": 0, "filters": None, "order": "C"}))
        padded = numpy.zeros((60, 60, 60), "<i2")
        padded[:SHAPE[0], :SHAPE[1], :SHAPE[2]] = self.samples
        for k, j, i in numpy.ndindex(3, 3, 3):
            padded[20 * k:20 * k + 20, 20 * j:20 * j + 20, 20 * i:20 * i + 20].tofile(
                folder / f"0/{k}.{j}.{i}")
        try:
            volume = open_volume(folder, memory_limit=1 << 20)
        except OSError as error:
            self.assertIn("cannot read Zarr", str(error))
            self.skipTest(str(error))
        numpy.testing.assert_array_equal(picture(volume), self.expected)

    def test_raw_of_the_other_byte_order(self):
        self.samples.astype(">i2").tofile(self.path / "waves.bin")
        volume = open_volume(self.path / "waves.bin", shape=SHAPE, dtype=numpy.int16, big_endian=True)
        numpy.testing.assert_array_equal(picture(volume), self.expected)

    def test_reader(self):
        reader = Slices(self.samples)
        volume = open_volume(reader=reader, ranges_folder=self.path)
        numpy.testing.assert_array_equal(picture(volume), self.expected)
        self.assertEqual(volume.GetScalarRange(), (self.samples.min(), self.samples.max()))

    def test_coarse_image(self):
        self.samples.astype(">i2").tofile(self.path / "waves.bin")
        source = vtkTemporalCoherenceBrickSource()
        source.SetFileName(str(self.path / "waves.bin"))
        source.SetRawLayout(SHAPE[2], SHAPE[1], SHAPE[0], 4, 0, True)
        source.Update()
        coarse = source.GetCoarseImage()
        self.assertEqual(coarse.GetDimensions(), (13, 12, 11))
        self.assertLessEqual(source.GetMemoryInUse(), source.GetMemoryLimit())

    def test_mistakes(self):
        with self.assertRaisesRegex(OSError, "nothing.mhd is not there"):
            open_volume(self.path / "nothing.mhd")
        with self.assertRaisesRegex(OSError, "SetFileName"):
            open_volume()
        (self.path / "short.bin").write_bytes(b"abc")
        with self.assertRaisesRegex(OSError, "short.bin"):
            open_volume(self.path / "short.bin", shape=SHAPE)
        with self.assertRaisesRegex(ValueError, "complex64"):
            open_volume(self.path / "short.bin", shape=SHAPE, dtype="complex64")


if __name__ == "__main__":
    unittest.main()
