// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Changes/Changes.h"

#include "World/Inputs.h"

#include <vtkColorTransferFunction.h>
#include <vtkDataArray.h>
#include <vtkLookupTable.h>
#include <vtkNew.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPointData.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace Fuzz
{
namespace Changes
{
namespace
{

/// Images of labels have labels from 0 on, fewer than these.
constexpr int MostLabels = 8;

void NewLabels(World& world)
{
  Inputs::Show(world, Inputs::MakeLabels(world));
  world.Subject->SetBlendModeToIsoSurface();
  world.Subject->SetSurfaceModeToLabels();
}

/// A colour and an opacity for each label; rarely too few.
void SetTable(World& world)
{
  Bytes& from = world.From;
  if (from.OneIn(6))
  {
    world.Subject->SetLabelTable(nullptr);
    Story::Tell("  no table of labels");
    return;
  }
  const int count = from.IsWild() ? 1 + from.Pick(MostLabels) : MostLabels;
  vtkNew<vtkLookupTable> table;
  table->SetNumberOfTableValues(count);
  table->SetTableRange(0.0, count - 1.0);
  const double opacities[] = { 1.0, 1.0, 0.0, 0.4, 0.9 };
  bool isSharp = false; // after an opaque first label no other is translucent
  for (int label = 0; label < count; ++label)
  {
    const double asked = from.OneOf(opacities);
    isSharp = label == 0 ? asked == 1.0 : isSharp;
    const double opacity = isSharp ? std::round(asked) : asked;
    table->SetTableValue(label, from.Between(0.0, 1.0), from.Between(0.0, 1.0), 0.3, opacity);
    Story::Tell("  label ", label, ": opacity ", opacity);
  }
  world.Subject->SetLabelTable(table);
}

void SetRadius(World& world)
{
  const double radii[] = { 0.0, 1.0, 2.5, 0.5, 4.0 };
  world.Subject->SetLabelRadius(world.From.OneOf(radii));
  Story::Tell("  radius ", world.Subject->GetLabelRadius());
}

void SetOutside(World& world)
{
  world.Subject->SetOutsideLabel(world.From.Pick(MostLabels) - 1);
  Story::Tell("  outside ", world.Subject->GetOutsideLabel());
}

/// A box of samples is painted.
void Paint(World& world)
{
  Bytes& from = world.From;
  vtkImageData* image = world.Image();
  vtkDataArray* samples = image ? image->GetPointData()->GetScalars() : nullptr;
  int size[3];
  if (!samples || samples->GetNumberOfTuples() != image->GetNumberOfPoints() ||
    samples->GetNumberOfTuples() > 100000)
  {
    return;
  }
  image->GetDimensions(size);
  int low[3], high[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    low[axis] = from.Pick(std::max(size[axis], 1));
    high[axis] = std::min(low[axis] + 1 + from.Pick(4), size[axis]);
  }
  const int label = from.Pick(MostLabels);
  for (int k = low[2]; k < high[2]; ++k)
  {
    for (int j = low[1]; j < high[1]; ++j)
    {
      for (int i = low[0]; i < high[0]; ++i)
      {
        samples->SetComponent(i + size[0] * (j + static_cast<vtkIdType>(size[1]) * k), 0, label);
      }
    }
  }
  Story::Tell("  label ", label, " from ", low[0], ", ", low[1], ", ", low[2], " to ", high[0],
    ", ", high[1], ", ", high[2]);
  if (label % 2 == 0)
  {
    samples->Modified();
    return;
  }
  int extent[6];
  image->GetExtent(extent);
  for (int axis = 0; axis < 3; ++axis)
  {
    extent[2 * axis + 1] = extent[2 * axis] + high[axis] - 1;
    extent[2 * axis] += low[axis];
  }
  Mapper::ModifiedWithin(image, extent);
}

/// Surfaces have the colours, and perhaps opacities, of some array of the data, or of none.
void SetColorArray(World& world)
{
  Bytes& from = world.From;
  const char* names[] = { "other", "Scalars", "other", nullptr };
  world.Subject->SetColorArrayName(from.IsWild() ? "missing" : from.OneOf(names));
  world.Subject->SetColorArrayOnCells(from.OneIn(6));
  world.Subject->SetColorArrayComponent(from.OneIn(4) ? -1 : 0);
  const bool isThere = !std::string(world.Subject->GetColorArrayName()).empty();
  world.Subject->SetColorArrayOpacity((isThere || from.IsWild()) && from.OneIn(3));
  Story::Tell("  colours ", world.Subject->GetColorArrayOpacity() ? "and opacities " : "", "of '",
    world.Subject->GetColorArrayName(), "'");
}

void SetColorTable(World& world)
{
  Bytes& from = world.From;
  if (from.OneIn(4))
  {
    world.Subject->SetColorTable(nullptr);
    return;
  }
  if (from.OneIn(3))
  {
    vtkNew<vtkLookupTable> steps;
    steps->SetNumberOfTableValues(2 + from.Pick(6));
    steps->SetTableRange(world.Low, world.High);
    steps->SetAlphaRange(from.Between(0.0, 1.0), 1.0);
    steps->Build();
    world.Subject->SetColorTable(steps);
    return;
  }
  vtkNew<vtkColorTransferFunction> table;
  table->AddRGBPoint(world.Low, from.Between(0.0, 1.0), 0.2, from.Between(0.0, 1.0));
  table->AddRGBPoint(world.Low + from.Between(0.2, 1.0) * (world.High - world.Low), 1.0,
    from.Between(0.0, 1.0), 0.0);
  world.Subject->SetColorTable(table);
}

/// The labels of a mask give looks to a composite volume.
void SetMaskLooks(World& world)
{
  Bytes& from = world.From;
  vtkImageData* image = world.Image();
  if (!image || image->GetNumberOfPoints() <= 0 || image->GetNumberOfPoints() > 100000)
  {
    return;
  }
  const auto mask = vtkSmartPointer<vtkImageData>::New();
  mask->SetDimensions(image->GetDimensions());
  mask->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  vtkDataArray* labels = mask->GetPointData()->GetScalars();
  const int edge = 1 + from.Pick(40);
  for (vtkIdType i = 0; i < labels->GetNumberOfTuples(); ++i)
  {
    labels->SetComponent(i, 0, static_cast<double>(i / edge % 4));
  }
  Mapper* mapper = world.Subject;
  mapper->SetBlendModeToComposite();
  mapper->SetMaskInput(from.OneIn(5) ? nullptr : mask);
  mapper->SetMaskTypeToLabelMap();
  mapper->SetMaskBlendFactor(from.OneIn(3) ? 0.5f : 1.0f);
  for (int label = 1; label < 4; ++label)
  {
    vtkNew<vtkPiecewiseFunction> opacity;
    opacity->AddPoint(world.Low, from.Between(0.0, 0.5));
    opacity->AddPoint(world.High, from.Between(0.0, 1.0));
    world.Property()->SetLabelScalarOpacity(label, from.OneIn(3) ? nullptr : opacity.Get());
  }
  Story::Tell("  looks of labels in runs of ", edge);
}

}

const std::vector<ChangeKind>& OfLabels()
{
  // Anything, Sweep, Orbit, TimeSteps, Looks, Wrecks, Layers
  static const std::vector<ChangeKind> kinds = {
    { "new labels", { 20, 20, 20, 10, 10, 10, 10 }, NewLabels },
    { "a table of labels", { 30, 30, 10, 10, 40, 10, 40 }, SetTable },
    { "the radius of labels", { 10, 10, 5, 5, 10, 10, 10 }, SetRadius },
    { "the outside of labels", { 5, 5, 5, 5, 5, 5, 5 }, SetOutside },
    { "a stroke", { 30, 30, 10, 80, 20, 10, 20 }, Paint },
    { "the array of colours", { 20, 20, 10, 10, 40, 20, 20 }, SetColorArray },
    { "the table of colours", { 10, 10, 5, 5, 20, 10, 10 }, SetColorTable },
    { "looks of a mask's labels", { 10, 10, 10, 5, 10, 10, 10 }, SetMaskLooks },
  };
  return kinds;
}

}
}
