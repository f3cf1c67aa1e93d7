# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
from vtk import vtkRTAnalyticSource, vtkVolume
from vtkTemporalCoherence import render, vtkTemporalCoherenceVolumeMapper, write_png
source = vtkRTAnalyticSource()
mapper = vtkTemporalCoherenceVolumeMapper()  # was: vtkGPUVolumeRayCastMapper()
mapper.SetInputConnection(source.GetOutputPort())
volume = vtkVolume()
volume.SetMapper(mapper)
volume.GetProperty().GetIsoSurfaceValues().SetValue(0, 150.0)
volume.GetProperty().GetRGBTransferFunction().AddRGBPoint(150.0, 0.95, 0.75, 0.45)
volume.GetProperty().SetInterpolationTypeToLinear()
volume.GetProperty().ShadeOn()
write_png("drop_in.png", render(volume).color)  # or as any volume: renderer.AddVolume(volume)
