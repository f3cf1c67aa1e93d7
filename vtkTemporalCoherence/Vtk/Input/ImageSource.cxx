// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Input/ImageSource.h"

#include "Acceleration/FiniteRange.h"
#include "Input/ToldChanges.h"
#include "OutOfCore/VolumeOfArray.h"

#include <vtkDataArray.h>
#include <vtkDataObjectTree.h>
#include <vtkImageData.h>
#include <vtkRectilinearGrid.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>

#include <algorithm>

namespace TemporalCoherence
{

bool ImageSource::Find(vtkDataObject* data, const ScalarChoice& choice, vtkVolumeProperty* property,
  const VectorChoice& vectors, DrawnComponent& found, std::string& error)
{
  this->Data = data;
  this->Found = FoundImage();
  this->Arrays.DropUnused();
  if (!this->FindImage(data, choice, error))
  {
    return false;
  }
  this->FindScalar(property, vectors);
  found = this->Found.Component;
  return true;
}

/// Find the image, or an image that stands for the data, and its array.
bool ImageSource::FindImage(vtkDataObject* data, const ScalarChoice& choice, std::string& error)
{
  ChosenScalars scalars;
  auto* tree = vtkDataObjectTree::SafeDownCast(data);
  auto* grid = vtkRectilinearGrid::SafeDownCast(data);
  if (tree)
  {
    if (!this->Blocks.Merge(tree, choice, error))
    {
      return false;
    }
    this->Found.Image = this->Blocks.Image();
    scalars = this->Blocks.Scalars();
  }
  else
  {
    this->Found.Image = vtkImageData::SafeDownCast(data);
    this->Blocks.Release();
    scalars = FindScalars(vtkDataSet::SafeDownCast(data), choice);
  }
  vtkDataSet* dataSet = grid ? static_cast<vtkDataSet*>(grid) : this->Found.Image;
  if (!scalars.Array && dataSet->GetNumberOfPoints() != 0)
  {
    error = WhyThereAreNoScalars(choice);
    return false;
  }
  this->Found.Array = dataSet->GetNumberOfPoints() != 0
    ? (AreInBricks(scalars.Array) ? scalars.Array
                                  : this->Arrays.Of(scalars.Array, dataSet->GetMTime()))
    : nullptr;
  this->Found.OnCells = scalars.OnCells;
  if (!grid)
  {
    this->Grid.Release();
    return true;
  }
  if (!this->Grid.See(grid, this->Found.OnCells, error))
  {
    return false;
  }
  this->Found.Image = this->Grid.Image();
  this->Found.Shape = this->Grid.Shape();
  return true;
}

void ImageSource::FindScalar(vtkVolumeProperty* property, const VectorChoice& vectors)
{
  const int components = this->Found.Array ? this->Found.Array->GetNumberOfComponents() : 0;
  this->Found.Component = ChooseComponent(property, vectors, components);
  if (!this->Found.Component.IsMagnitude)
  {
    this->Magnitude.Release();
    return;
  }
  // Writers of samples may call Modified() of the array or of the image.
  const vtkMTimeType stamp = std::max(this->Found.Image->GetMTime(), this->Found.Array->GetMTime());
  this->Found.Array = this->Magnitude.Of(this->Found.Array, stamp);
}

bool ImageSource::Make(const FieldQuery& query, PlacedField& field, std::string& error)
{
  vtkVolumeProperty* property = query.Volume->GetProperty();
  const FoundImage& found = this->Found;
  SampleMask ofSamples;
  if (!MakeField(
        found.Image, found.Array, found.OnCells, found.Component.Number, field.Samples, error) ||
    !FindMask(query.Mask, query.Mapper, field.Samples.Dimensions, property, query.Isovalues,
      ofSamples, error) ||
    !this->MakeLabels(query.Mask, ofSamples, field, error) ||
    !this->Hidden.Find(found.Image, found.OnCells, ofSamples.GivesLooks ? SampleMask() : ofSamples,
      field.Samples.Flagged, error) ||
    !MakeIndexTransform(found.Image, found.OnCells, query.Volume, field.Transform, error))
  {
    return false;
  }
  field.Samples.Shape = found.Shape;
  field.Samples.Between = property->GetInterpolationType() == VTK_NEAREST_INTERPOLATION
    ? Interpolation::Nearest
    : Interpolation::Linear;
  if (!this->MakeOthers(field, error))
  {
    return false;
  }
  if (query.NeedsScalarRanges)
  {
    this->FindRanges(field);
  }
  field.Axes = AxesOf(found.Image, found.OnCells);
  const glm::dvec3 distances = glm::abs(field.Axes.Step);
  field.PerStep = (distances.x + distances.y + distances.z) / 3.0 / distances;
  field.Told = ToldChanges(found.Array, field.Samples.Dimensions);
  field.Read.emplace_back(found.Array);
  return true;
}

/// Make the field of labels, if the mask gives looks to samples.
bool ImageSource::MakeLabels(
  const MaskSettings& settings, const SampleMask& mask, PlacedField& field, std::string& error)
{
  if (!mask.GivesLooks)
  {
    return true;
  }
  vtkDataArray* const array = this->Arrays.Of(mask.Array, settings.Image->GetMTime());
  field.Read.emplace_back(array);
  return MakeField(settings.Image, array, mask.OnCells, 0, field.Labels.emplace(), error);
}

/// Make the fields of all components but the first.
bool ImageSource::MakeOthers(PlacedField& field, std::string& error) const
{
  const FoundImage& found = this->Found;
  for (int i = 1; i < found.Component.Count; ++i)
  {
    Field other;
    if (!MakeField(
          found.Image, found.Array, found.OnCells, found.Component.Number + i, other, error))
    {
      return false;
    }
    const Field& first = field.Samples;
    other.Between = first.Between;
    other.Shape = first.Shape;
    other.Flagged = first.Flagged;
    field.Others.push_back(other);
  }
  return true;
}

/// Find the ranges of all components whose samples may have changed. VTK's arrays keep ranges, too,
/// but do not notice that an image is modified.
void ImageSource::FindRanges(PlacedField& field)
{
  std::vector<KnownRange> ranges;
  const auto add = [&](const Field& samples)
  {
    const auto known = std::find_if(this->Ranges.begin(), this->Ranges.end(),
      [&](const KnownRange& range)
      {
        return range.Of.Samples == samples.Samples && range.Of.Type == samples.Type &&
          range.Of.Dimensions == samples.Dimensions && range.Of.Strides == samples.Strides &&
          range.Of.Stamp == samples.Stamp;
      });
    ranges.push_back(
      known != this->Ranges.end() ? *known : KnownRange{ samples, FindFiniteRange(samples) });
    field.ScalarRanges.push_back(ranges.back().Range);
  };
  add(field.Samples);
  std::for_each(field.Others.begin(), field.Others.end(), add);
  this->Ranges.swap(ranges);
}

void ImageSource::Release()
{
  this->Ranges.clear();
  this->Found = FoundImage();
  this->Arrays = ArraysInPlace();
  this->Blocks.Release();
  this->Magnitude.Release();
  this->Grid.Release();
  this->Hidden.Release();
  this->Values.Release();
}

}
