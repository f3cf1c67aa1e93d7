// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FeatureFrames.h"

#include "Measuring.h"

#include <vtkCellData.h>
#include <vtkContourValues.h>
#include <vtkDataSetAttributes.h>
#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPlane.h>
#include <vtkPointData.h>
#include <vtkRectilinearGrid.h>
#include <vtkUnsignedCharArray.h>
#include <vtkVolumeProperty.h>

#include <functional>

namespace FeatureFrames
{
namespace
{

using Mapper = vtkTemporalCoherenceVolumeMapper;

constexpr double Degrees = 2.0; ///< of the orbit, a frame

struct Feature
{
  std::string Name;
  std::function<void(Stage&, Mapper*)> SwitchOn;
};

/// Three surfaces, the inner two at higher values, with these opacities.
void ShowThree(Stage& stage, const std::vector<double>& opacities)
{
  const double isovalue = stage.Isovalue();
  vtkNew<vtkPiecewiseFunction> opacity;
  vtkContourValues* list = stage.Volume->GetProperty()->GetIsoSurfaceValues();
  list->SetNumberOfContours(static_cast<int>(opacities.size()));
  for (std::size_t i = 0; i < opacities.size(); ++i)
  {
    const double value = isovalue + 0.15 * static_cast<double>(i) * stage.ShareOfRange(1.0);
    list->SetValue(static_cast<int>(i), value);
    opacity->AddPoint(value, opacities[i]);
  }
  stage.Volume->GetProperty()->SetScalarOpacity(opacity);
}

void Clip(Stage& stage, Mapper* mapper)
{
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(stage.Image->GetCenter());
  plane->SetNormal(0.3, 0.9, 0.2);
  mapper->AddClippingPlane(plane);
}

void Crop(Stage& stage, Mapper* mapper, int flags)
{
  double bounds[6];
  stage.Image->GetBounds(bounds);
  double planes[6];
  for (int i = 0; i < 6; i += 2)
  {
    planes[i] = bounds[i] + 0.35 * (bounds[i + 1] - bounds[i]);
    planes[i + 1] = bounds[i] + 0.65 * (bounds[i + 1] - bounds[i]);
  }
  mapper->CroppingOn();
  mapper->SetCroppingRegionPlanes(planes);
  mapper->SetCroppingRegionFlags(flags);
}

/// Every 20th layer of cells is hidden.
void Hide(Stage& stage, Mapper* mapper)
{
  vtkNew<vtkImageData> image;
  image->ShallowCopy(stage.Image);
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->SetNumberOfTuples(image->GetNumberOfCells());
  int cells[3];
  image->GetDimensions(cells);
  for (vtkIdType i = 0; i < ghosts->GetNumberOfTuples(); ++i)
  {
    const bool isHidden = i % (cells[0] - 1) % 20 == 0;
    ghosts->SetValue(i, isHidden ? vtkDataSetAttributes::HIDDENCELL : 0);
  }
  image->GetCellData()->AddArray(ghosts);
  mapper->SetInputData(image);
}

/// The same samples, the farther apart the farther from the first.
void Grade(Stage& stage, Mapper* mapper)
{
  vtkNew<vtkRectilinearGrid> grid;
  int size[3];
  stage.Image->GetDimensions(size);
  grid->SetDimensions(size);
  for (int axis = 0; axis < 3; ++axis)
  {
    vtkNew<vtkDoubleArray> coordinates;
    for (int i = 0; i < size[axis]; ++i)
    {
      const double share = static_cast<double>(i) / (size[axis] - 1);
      const double along = 0.8 * share + 0.2 * share * share;
      const double first = stage.Image->GetBounds()[2 * axis];
      const double last = stage.Image->GetBounds()[2 * axis + 1];
      coordinates->InsertNextValue(first + along * (last - first));
    }
    axis == 0     ? grid->SetXCoordinates(coordinates)
      : axis == 1 ? grid->SetYCoordinates(coordinates)
                  : grid->SetZCoordinates(coordinates);
  }
  grid->GetPointData()->SetScalars(stage.Image->GetPointData()->GetScalars());
  mapper->SetInputDataObject(grid);
}

std::vector<Feature> AllFeatures()
{
  const auto show = [](const std::vector<double>& opacities)
  { return [=](Stage& stage, Mapper*) { ShowThree(stage, opacities); }; };
  const auto crop = [](int flags)
  { return [=](Stage& stage, Mapper* mapper) { Crop(stage, mapper, flags); }; };
  return { { "none", [](Stage&, Mapper*) {} },
    { "THRESHOLD", [](Stage&, Mapper* mapper) { mapper->SetSurfaceModeToThreshold(); } },
    { "a clipping plane", Clip }, { "cropped to a box", crop(VTK_CROP_SUBVOLUME) },
    { "an inverted cross", crop(VTK_CROP_INVERTED_CROSS) }, { "hidden cells", Hide },
    { "rectilinear grid", Grade }, { "three opaque isovalues", show({ 1.0, 1.0, 1.0 }) },
    { "translucent, 0.4", show({ 0.4 }) },
    { "translucent, 0.2, 0.6, 1", show({ 0.2, 0.6, 1.0 }) } };
}

Times MeasureFeature(Stage& stage, const Feature& feature, int frames)
{
  const double isovalue = stage.Isovalue();
  vtkVolumeProperty* property = stage.Volume->GetProperty();
  vtkNew<vtkPiecewiseFunction> before;
  before->DeepCopy(property->GetScalarOpacity());
  Drawer cold(stage);
  feature.SwitchOn(stage, cold.Mapper);
  cold.Mapper->ReuseFramesOff();
  cold.Draw(stage);
  std::vector<double> coldTimes, shadedTimes;
  for (int frame = 0; frame < frames; ++frame)
  {
    stage.Orbit(Degrees);
    coldTimes.push_back(cold.Draw(stage));
    property->SetDiffuse(0.6 + 0.01 * (frame % 10));
    shadedTimes.push_back(cold.Draw(stage));
  }
  property->SetScalarOpacity(before);
  property->GetIsoSurfaceValues()->SetNumberOfContours(1);
  stage.SetIsovalue(isovalue);
  stage.ResetView();
  return { feature.Name, Measuring::Median(coldTimes), Measuring::Median(shadedTimes) };
}

}

std::vector<Times> Measure(Stage& stage, int frames)
{
  std::vector<Times> times;
  for (const Feature& feature : AllFeatures())
  {
    times.push_back(MeasureFeature(stage, feature, frames));
  }
  return times;
}

}
