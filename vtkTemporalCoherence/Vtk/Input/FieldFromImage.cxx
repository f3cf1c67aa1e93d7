// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Input/FieldFromImage.h"

#include "Input/MatrixFromVtk.h"
#include "Input/SamplesOfArray.h"
#include "Input/VolumePlace.h"
#include "OutOfCore/OutOfCoreVolume.h"
#include "OutOfCore/VolumeOfArray.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>

#include <algorithm>
#include <sstream>

namespace TemporalCoherence
{
namespace
{

/// Make the transform from sample indices, counted from 0, to the image's coordinates.
bool PlaceImage(
  vtkImageData* image, bool onCells, glm::dmat4& physicalFromIndex, std::string& error)
{
  const int* extent = image->GetExtent();
  glm::dmat4 toFirst(1.0);
  toFirst[3] = glm::dvec4(extent[0], extent[2], extent[4], 1.0);
  if (onCells)
  {
    toFirst[3] += glm::dvec4(0.5, 0.5, 0.5, 0.0); // a cell's value lies at its centre
  }
  physicalFromIndex = MatrixFromVtk(image->GetIndexToPhysicalMatrix()) * toFirst;

  const double* spacing = image->GetSpacing();
  const double* origin = image->GetOrigin();
  std::ostringstream what;
  if (!IsFinite(physicalFromIndex))
  {
    what << "The image's spacing (" << spacing[0] << ", " << spacing[1] << ", " << spacing[2]
         << "), its origin (" << origin[0] << ", " << origin[1] << ", " << origin[2]
         << ") or its direction matrix is not finite; set finite numbers.";
  }
  else if (IsFlat(physicalFromIndex))
  {
    what
      << "The image's spacing (" << spacing[0] << ", " << spacing[1] << ", " << spacing[2]
      << ") or its direction matrix flattens it; set a spacing other than 0 along every axis and "
         "an invertible direction matrix.";
  }
  error = what.str();
  return error.empty();
}

/// Make a field of samples that are read when they are needed.
bool TakeVolume(const OutOfCoreVolume& volume, Field& field, std::string& error)
{
  const glm::ivec3& size = volume.Level().Dimensions;
  if (field.Dimensions != size)
  {
    std::ostringstream what;
    what << "The image has " << field.Dimensions.x << " x " << field.Dimensions.y << " x "
         << field.Dimensions.z << " samples, but the volume that its array is read from has "
         << size.x << " x " << size.y << " x " << size.z
         << "; draw the image that vtkTemporalCoherenceBrickSource gives.";
    error = what.str();
    return false;
  }
  const glm::i64vec3 inArray(1, size.x, static_cast<std::int64_t>(size.x) * size.y);
  field.Bricks = volume.Bricks();
  field.Samples = field.Bricks ? field.Bricks.get() : volume.Mapped();
  field.Strides = field.Bricks ? BrickCache::Strides() : inArray;
  field.Type = volume.File().Type();
  field.Known = volume.Ranges();
  return true;
}

}

bool MakeField(vtkImageData* image, vtkDataArray* array, bool onCells, int component, Field& field,
  std::string& error)
{
  field = Field();
  if (!HasComponent(array, component, error) ||
    !CheckTuples(array, { "The image", onCells, CountSamples(image, onCells) }, error))
  {
    return false;
  }
  glm::ivec3 dimensions;
  image->GetDimensions(&dimensions.x);
  field.Dimensions = onCells ? glm::max(dimensions - 1, 1) : dimensions;
  field.Stamp = std::max(image->GetMTime(), array->GetMTime());
  if (const auto volume = VolumeOf(array))
  {
    return TakeVolume(*volume, field, error);
  }
  const ArraySamples samples = SamplesOf(array, component);
  field.Samples = samples.First;
  field.Type = samples.Type;
  field.Strides.x = samples.Step;
  field.Strides.y = field.Strides.x * field.Dimensions.x;
  field.Strides.z = field.Strides.y * field.Dimensions.y;
  return true;
}

bool MakeIndexTransform(vtkImageData* image, bool onCells, vtkVolume* volume,
  IndexTransform& transform, std::string& error)
{
  return PlaceImage(image, onCells, transform.WorldFromIndex, error) &&
    PlaceVolume(volume, transform, error);
}

ImageAxes AxesOf(vtkImageData* image, bool onCells)
{
  const int* extent = image->GetExtent();
  ImageAxes axes;
  for (int axis = 0; axis < 3; ++axis)
  {
    axes.Step[axis] = image->GetSpacing()[axis];
    const double first = extent[2 * axis] + (onCells ? 0.5 : 0.0);
    axes.First[axis] = image->GetOrigin()[axis] + first * axes.Step[axis];
  }
  return axes;
}

}
