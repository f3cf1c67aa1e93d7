# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of volumes that ParaView splits among processes: run with mpirun -np N pvbatch.

They are named SCENE-N.png; ComparePictures.py compares those of several processes with those of one.
"""

import glob
import os

from paraview import servermanager
from vtkmodules.vtkParallelCore import vtkMultiProcessController

from Stage import (AMRGaussianPulseSource, Calculator, CreateWriter, Delete, GetColorTransferFunction,
                   GroupDatasets, HierarchicalFractal, LegacyVTKReader, OpenDataFile, PointDatatoCellData,
                   ProgrammableFilter, ProgrammableSource, Render, SaveData, Tetrahedralize,
                   Transform, check, check_same, count_different, look_from, make_labels, make_view,
                   make_wavelet, show, statistic, take_picture)

PROCESSES = vtkMultiProcessController.GetGlobalController().GetNumberOfProcesses()

# A source that gives each process its share of an image or of eight blocks, and no ghost cells.
INFORMATION = """
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm, vtkStreamingDemandDrivenPipeline
information = self.GetOutputInformation(0)
information.Set(vtkStreamingDemandDrivenPipeline.WHOLE_EXTENT(), -20, 20, -20, 20, -20, 20)
information.Set(vtkAlgorithm.CAN_HANDLE_PIECE_REQUEST(), 1)
"""
PARTS = """
from vtkmodules.vtkCommonCore import vtkDoubleArray
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkCommonExecutionModel import (vtkExtentTranslator,
                                                vtkStreamingDemandDrivenPipeline)
from vtkmodules.vtkImagingCore import vtkRTAnalyticSource
information = self.GetOutputInformation(0)
piece = information.Get(vtkStreamingDemandDrivenPipeline.UPDATE_PIECE_NUMBER())
pieces = information.Get(vtkStreamingDemandDrivenPipeline.UPDATE_NUMBER_OF_PIECES())

def part(number, count):
    translator = vtkExtentTranslator()
    translator.SetWholeExtent(-20, 20, -20, 20, -20, 20)
    translator.SetNumberOfPieces(count)
    translator.SetPiece(number)
    translator.PieceToExtent()
    source = vtkRTAnalyticSource()
    source.SetWholeExtent(-20, 20, -20, 20, -20, 20)
    source.UpdateExtent(translator.GetExtent())
    image = vtkImageData()
    image.ShallowCopy(source.GetOutput())
    image.Crop(translator.GetExtent())
    for data in (image.GetPointData(), image.GetCellData()):
        data.RemoveArray('vtkGhostType')
    return image

output = self.GetOutputDataObject(0)
"""
OUTPUTS = {
    "image": ("vtkImageData", "output.ShallowCopy(part(piece, pieces))"),
    "blocks": ("vtkMultiblockDataSet", """
output.SetNumberOfBlocks(8)
for block in range(8):
    if block % pieces == piece:
        output.SetBlock(block, part(block, 8))
"""),
    "grid": ("vtkRectilinearGrid", """
image = part(piece, pieces)
extent = image.GetExtent()
output.SetExtent(extent)
setters = (output.SetXCoordinates, output.SetYCoordinates, output.SetZCoordinates)
for axis, setter in enumerate(setters):
    coordinates = vtkDoubleArray()
    for i in range(extent[2 * axis], extent[2 * axis + 1] + 1):
        coordinates.InsertNextValue(i + 0.01 * i * abs(i))
    setter(coordinates)
output.GetPointData().ShallowCopy(image.GetPointData())
"""),
}


def make_parts(kind):
    """A source without ghost cells."""
    source = ProgrammableSource()
    source.OutputDataSetType = OUTPUTS[kind][0]
    source.ScriptRequestInformation = INFORMATION
    source.Script = PARTS + OUTPUTS[kind][1]
    return source


def sweep(view, display, isovalues, factor):
    """Other isovalues; labels have none, and are seen from elsewhere."""
    display.Isovalues = [value * factor for value in isovalues]
    if not isovalues:
        view.GetActiveCamera().Azimuth(1.0)


def draw(name, source, isovalues, fxaa=0, array=None, **settings):
    """One scene, moved and with a new isovalue, so that what is kept is used again: two pictures."""
    view = make_view()
    view.UseFXAA = fxaa
    display = show(source, view, isovalues, array)
    for setting, value in settings.items():
        setattr(display, setting, value)
    look_from(view)
    Render(view)
    view.GetActiveCamera().Azimuth(2.0)
    pictures = [take_picture(view, f"{name}-{PROCESSES}")]
    sweep(view, display, isovalues, 1.01)
    Render(view)
    sweep(view, display, isovalues, 1.02)
    pictures.append(take_picture(view, f"{name}-swept-{PROCESSES}"))
    if name == "surface":
        counts = list(statistic(display, "RouteCounts"))
        check(counts[3] + counts[4] == 2,
              f"{PROCESSES} process(es): isovalues use again what is there", counts)
    Delete(display)
    Delete(view)
    return pictures


def labels():
    """Parts of an image, as faces and smooth; one is hidden.

    Smooth ones ask the source for more ghost cells, which it keeps. With an odd number of layers,
    Tetrahedralize divides the cells of a part otherwise. So this source is not that of the meshes."""
    wavelet = make_wavelet()
    parts = make_labels(wavelet)
    table = GetColorTransferFunction("Parts")
    table.RGBPoints = [0.0, 0.0, 0.0, 1.0, 5.0, 1.0, 1.0, 0.0]
    look = {"array": ("POINTS", "Parts"), "SurfaceMode": "Labels", "LookupTable": table}
    draw("labels", parts, [], LabelOpacities=[4.0, 0.0], **look)
    draw("labels-smooth", parts, [], LabelRadius=2.5, LabelOpacities=[4.0, 0.0], **look)
    cells = make_labels(PointDatatoCellData(Input=wavelet))
    cells.AttributeType, cells.Function = "Cell Data", "floor(max(RTData-130,0)/27)"
    look["array"] = ("CELLS", "Parts")
    draw("labels-cells", cells, [], LabelRadius=1.5, **look)


def second_arrays(wavelet):
    """Surfaces in the colours of another array; the blocks of a translucent mesh are merged."""
    table = GetColorTransferFunction("Height")
    table.RGBPoints = [-20.0, 0.0, 0.0, 1.0, 20.0, 1.0, 1.0, 0.0]
    coloured = Calculator(Input=wavelet, Function="coordsZ", ResultArrayName="Height")
    look = {"array": ("POINTS", "Height"), "SurfaceArrayName": ["POINTS", "RTData"], "LookupTable": table}
    draw("coloured", coloured, [150.0], **look)
    mesh = Tetrahedralize(Input=coloured)
    blocks = GroupDatasets(Input=[mesh, Transform(Input=mesh)])
    draw("translucent-coloured-blocks", blocks, [120.0, 200.0], Opacity=0.4, **look)


def meshes(wavelet):
    """Grids other than images: each process draws its own cells."""
    tetrahedra = Tetrahedralize(Input=wavelet)
    draw("tetrahedra", tetrahedra, [150.0])
    draw("tetrahedra-solid", tetrahedra, [120.0, 200.0], SurfaceMode="Threshold")
    draw("translucent-tetrahedra", tetrahedra, [120.0, 200.0], Opacity=0.4)
    draw("tetrahedra-cells", PointDatatoCellData(Input=tetrahedra), [150.0])
    # Of an image, Transform makes a curvilinear grid; only the places of such points can be new.
    twisted = Calculator(Input=Transform(Input=wavelet), CoordinateResults=1, ResultArrayName="Places",
                         Function="iHat*(coordsX+0.01*coordsY*coordsZ)+jHat*(coordsY+0.1*coordsX)"
                         "+kHat*coordsZ")
    draw("curvilinear", twisted, [150.0])
    mixed = GroupDatasets(Input=[tetrahedra, Transform(Input=tetrahedra)])
    draw("mixed", mixed, [150.0])
    draw("translucent-mixed", mixed, [120.0, 200.0], Opacity=0.4)


def adaptive_grids():
    """Each process makes all blocks of the source of a pulse, and reads its share of those of a file."""
    for ratio in (2, 3, 4):
        pulse = AMRGaussianPulseSource(RefinementRatio=ratio)
        pulse.UpdatePipeline()
        lengths = pulse.CellData[0].GetRange(-1)  # the first array is drawn, which is of vectors
        draw(f"adaptive-{ratio}", pulse, [0.5 * (lengths[0] + lengths[1])])
    values = ("CELLS", "Gaussian-Pulse")
    draw("adaptive-solid", pulse, [0.1], array=values, SurfaceMode="Threshold")
    draw("translucent-adaptive", pulse, [0.1, 0.2], array=values, Opacity=0.4)

    values = ("CELLS", "Fractal Volume Fraction")
    path = os.path.join(os.environ["TEMPORAL_ISOSURFACE_OUTPUT"], "fractal.vthb")
    if PROCESSES == 1:  # in several, ParaView 5.11 crashes with this source
        fractals = [HierarchicalFractal(TwoDimensional=0, MaximumLevel=3, Dimensions=8,
                                        GhostLevels=layers) for layers in (0, 1)]
        SaveData(path, fractals[0])
        alone, layered = (draw(f"alone-{layers}", fractal, [0.5], array=values)
                          for layers, fractal in enumerate(fractals))
        # Its values are rounded otherwise.
        different = count_different(alone[0], layered[0], 2)
        check(different < 0.001 * alone[0].size / 3, "adaptive grids: layers of copies change nothing",
              f"{different} pixels differ")
    pieces = OpenDataFile(path)
    pieces.DefaultNumberOfLevels = 4
    pieces.UpdatePipeline()
    pictures = draw("adaptive-file", pieces, [0.5], array=values)
    draw("adaptive-file-solid", pieces, [0.5], array=values, SurfaceMode="Threshold")
    draw("translucent-adaptive-file", pieces, [0.3, 0.5], array=values, Opacity=0.4)
    if PROCESSES == 1:
        check_same("a file .vthb is as the data in memory", pictures, alone)


# Exodus files number points and cells from 1, without gaps; the same point has one number in all
# processes.
NUMBERS = """
import numpy
from vtkmodules.util.numpy_support import numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkIdTypeArray
from vtkmodules.vtkParallelCore import vtkMultiProcessController
output = self.GetOutputDataObject(0)
output.ShallowCopy(self.GetInputDataObject(0, 0))
places = numpy.rint(vtk_to_numpy(output.GetPoints().GetData())).astype(numpy.int64) + 20
controller = vtkMultiProcessController.GetGlobalController()
own, counts = vtkIdTypeArray(), vtkIdTypeArray()
own.InsertNextValue(output.GetNumberOfCells())
counts.SetNumberOfValues(controller.GetNumberOfProcesses())
controller.AllGather(own, counts)
first = int(vtk_to_numpy(counts)[:controller.GetLocalProcessId()].sum()) + 1
for data, numbers in ((output.GetPointData(), places @ numpy.array([1, 41, 41 * 41]) + 1),
                      (output.GetCellData(), numpy.arange(output.GetNumberOfCells()) + first)):
    ids = numpy_to_vtkIdTypeArray(numbers, deep=True)
    ids.SetName("ids")
    data.SetGlobalIds(ids)
"""


def read_again(source, extension):
    """What a source gives, by way of a file of which each process writes its part."""
    path = os.path.join(os.environ["TEMPORAL_ISOSURFACE_OUTPUT"], f"mesh-{PROCESSES}.{extension}")
    writer = CreateWriter(path, source)
    if hasattr(writer, "IgnoreMetaDataWarning"):  # of an Exodus file that the data were not read from
        writer.IgnoreMetaDataWarning = 1
    writer.UpdatePipeline()
    files = sorted(glob.glob(path + "*"))
    reader = OpenDataFile(files if len(files) > 1 else path)
    reader.UpdatePipeline()
    print(f".{extension}: {len(files)} file(s), read by {reader.GetXMLName()} as "
          f"{reader.GetDataInformation().GetDataSetTypeAsString()}", flush=True)
    return reader


def files():
    """Meshes by way of files."""
    # Of an image that was not drawn: pictures ask for layers of ghost cells, and writers keep them.
    mesh = ProgrammableFilter(Input=Tetrahedralize(Input=make_wavelet()), Script=NUMBERS)
    readers = {"exodus": read_again(mesh, "ex2")}
    if hasattr(servermanager.writers, "VTKHDFWriter"):
        readers["vtkhdf"] = read_again(mesh, "vtkhdf")
    else:
        print("skipped: this ParaView writes no VTKHDF", flush=True)
    values = ("POINTS", "RTData")
    pictures = draw("memory", mesh, [150.0], array=values)
    for name, reader in readers.items():
        check_same(f"{PROCESSES} process(es): a file, {name}, is as the data in memory",
                   draw(name, reader, [150.0], array=values), pictures)
        draw(f"translucent-{name}", reader, [120.0, 200.0], array=values, Opacity=0.4)
        draw(f"{name}-cells", PointDatatoCellData(Input=reader), [150.0], array=("CELLS", "RTData"))
    # A file that one process wrote, so that the others have nothing to read.
    whole = OpenDataFile(os.path.join(os.environ["TEMPORAL_ISOSURFACE_OUTPUT"], "mesh-1.ex2"))
    whole.UpdatePipeline()
    draw("exodus-whole", whole, [150.0], array=values)
    draw("translucent-exodus-whole", whole, [120.0, 200.0], array=values, Opacity=0.4)


def main():
    """All scenes."""
    wavelet = make_wavelet()
    wavelet.UpdatePipeline()
    points = wavelet.GetDataInformation().GetNumberOfPoints()
    check((points > 41 ** 3) == (PROCESSES > 1), f"{PROCESSES} process(es): the volume is {'split' if PROCESSES > 1 else 'whole'}",
          f"{points} points, those that parts share counted with each")
    draw("surface", wavelet, [150.0])
    draw("surfaces", wavelet, [120.0, 200.0], SurfaceMode="Threshold")
    # ParaView's default. Not for translucent surfaces: alone, VTK smooths before it draws volumes.
    draw("smoothed", wavelet, [120.0, 200.0], fxaa=1)
    draw("translucent", wavelet, [120.0, 150.0, 200.0], Opacity=0.4)
    draw("cropped", wavelet, [120.0], SurfaceMode="Threshold", UseCropping=1,
         CroppingOrigin=[3.0, 0.0, 0.0], CroppingScale=[0.6, 0.7, 0.8])
    draw("cells", PointDatatoCellData(Input=wavelet), [150.0])
    labels()
    second_arrays(wavelet)
    meshes(wavelet)
    adaptive_grids()
    files()
    for kind in OUTPUTS:
        draw(f"parts-{kind}", make_parts(kind), [150.0])
    # Not a .vti: with recent updates of Debian 12's expat, its VTK cannot read some of these.
    real = os.path.join(os.environ.get("TEMPORAL_COHERENCE_DATA", ""), "ironProt.vtk")
    if os.path.exists(real):
        draw("protein", LegacyVTKReader(FileNames=[real]), [128.0])
    else:
        print("skipped: no TEMPORAL_COHERENCE_DATA with ironProt.vtk", flush=True)


main()
