# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of volumes that ParaView splits among processes: run with mpirun -np N pvbatch.

They are named SCENE-N.png; ComparePictures.py compares those of several processes with those of one.
"""

import os

from vtkmodules.vtkParallelCore import vtkMultiProcessController

from Stage import (AMRGaussianPulseSource, Calculator, Delete, GroupDatasets, LegacyVTKReader,
                   PointDatatoCellData, ProgrammableSource, Render, Tetrahedralize, Transform, check,
                   look_from, make_view, make_wavelet, show, statistic, take_picture)

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


def draw(name, source, isovalues, fxaa=0, **settings):
    """One scene, moved and with a new isovalue, so that what is kept is used again."""
    view = make_view()
    view.UseFXAA = fxaa
    display = show(source, view, isovalues)
    for setting, value in settings.items():
        setattr(display, setting, value)
    look_from(view)
    Render(view)
    view.GetActiveCamera().Azimuth(2.0)
    take_picture(view, f"{name}-{PROCESSES}")
    display.Isovalues = [value * 1.01 for value in isovalues]
    Render(view)
    display.Isovalues = [value * 1.02 for value in isovalues]
    take_picture(view, f"{name}-swept-{PROCESSES}")
    if name == "surface":
        counts = list(statistic(display, "RouteCounts"))
        check(counts[3] + counts[4] == 2,
              f"{PROCESSES} process(es): isovalues use again what is there", counts)
    Delete(display)
    Delete(view)


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
    draw("mixed", GroupDatasets(Input=[tetrahedra, Transform(Input=tetrahedra)]), [150.0])
    amr = AMRGaussianPulseSource()
    amr.UpdatePipeline()
    lengths = amr.CellData[0].GetRange(-1)  # the first array is drawn, which is of vectors
    draw("adaptive", amr, [0.5 * (lengths[0] + lengths[1])])


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
    meshes(wavelet)
    for kind in OUTPUTS:
        draw(f"parts-{kind}", make_parts(kind), [150.0])
    # Not a .vti: with recent updates of Debian 12's expat, its VTK cannot read some of these.
    real = os.path.join(os.environ.get("TEMPORAL_COHERENCE_DATA", ""), "ironProt.vtk")
    if os.path.exists(real):
        draw("protein", LegacyVTKReader(FileNames=[real]), [128.0])
    else:
        print("skipped: no TEMPORAL_COHERENCE_DATA with ironProt.vtk", flush=True)


main()
