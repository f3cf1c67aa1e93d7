// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Peers.h"

#include <vtkActor.h>
#include <vtkContourValues.h>
#include <vtkFixedPointVolumeRayCastMapper.h>
#include <vtkFlyingEdges3D.h>
#include <vtkGPUVolumeRayCastMapper.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPolyDataMapper.h>
#include <vtkVolumeProperty.h>

namespace Peers
{
namespace
{

/// Width of the step of an opacity function, as a share of the range of values.
constexpr double StepWidth = 1e-6;

/// A volume that looks as the stage's does.
vtkSmartPointer<vtkVolume> VolumeLike(Stage& stage, vtkVolumeMapper* mapper)
{
  mapper->SetInputData(stage.Image);
  auto volume = vtkSmartPointer<vtkVolume>::New();
  volume->GetProperty()->DeepCopy(stage.Volume->GetProperty());
  volume->SetMapper(mapper);
  return volume;
}

/// The setter of a property's only isovalue.
std::function<void(double)> IsovalueOf(vtkVolume* volume)
{
  return [property = vtkSmartPointer<vtkVolumeProperty>(volume->GetProperty())](double isovalue)
  { property->GetIsoSurfaceValues()->SetValue(0, isovalue); };
}

}

Peer Ours(Stage& stage)
{
  vtkNew<vtkTemporalCoherenceVolumeMapper> mapper;
  mapper->ReuseFramesOff();
  mapper->SetAntialiasingToOff();
  const vtkSmartPointer<vtkVolume> volume = VolumeLike(stage, mapper);
  return { "vtkTemporalCoherenceVolumeMapper", volume, IsovalueOf(volume) };
}

Peer Polygons(Stage& stage)
{
  vtkNew<vtkFlyingEdges3D> contour;
  contour->SetInputData(stage.Image);
  contour->ComputeNormalsOn();
  contour->ComputeScalarsOff();
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(contour->GetOutputPort());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  return { "vtkFlyingEdges3D + vtkPolyDataMapper", actor,
    [contour = vtkSmartPointer<vtkFlyingEdges3D>(contour)](double isovalue)
    { contour->SetValue(0, isovalue); } };
}

Peer FixedPoint(Stage& stage)
{
  vtkNew<vtkFixedPointVolumeRayCastMapper> mapper;
  mapper->AutoAdjustSampleDistancesOff();
  mapper->SetImageSampleDistance(1.0f);
  mapper->SetSampleDistance(static_cast<float>(stage.VoxelSize()));
  const vtkSmartPointer<vtkVolume> volume = VolumeLike(stage, mapper);
  auto opacity = vtkSmartPointer<vtkPiecewiseFunction>::New();
  volume->GetProperty()->SetScalarOpacity(opacity);
  const double width = stage.ShareOfRange(StepWidth);
  return { "vtkFixedPointVolumeRayCastMapper", volume,
    [opacity, width](double isovalue)
    {
      opacity->RemoveAllPoints();
      opacity->AddPoint(isovalue - width, 0.0);
      opacity->AddPoint(isovalue, 1.0);
    } };
}

Peer Gpu(Stage& stage)
{
  const auto mapper = vtkSmartPointer<vtkGPUVolumeRayCastMapper>::New();
  mapper->SetBlendModeToIsoSurface();
  mapper->AutoAdjustSampleDistancesOff();
  mapper->SetSampleDistance(static_cast<float>(stage.VoxelSize()));
  const vtkSmartPointer<vtkVolume> volume = VolumeLike(stage, mapper);
  return { "vtkGPUVolumeRayCastMapper", volume, IsovalueOf(volume) };
}

}
