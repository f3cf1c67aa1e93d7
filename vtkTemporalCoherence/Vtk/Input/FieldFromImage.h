// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_FieldFromImage_h
#define TemporalCoherence_FieldFromImage_h

#include "Scene/Field.h"
#include "vtkTemporalCoherenceCompatibility.h"

#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;
class vtkImageData;
class vtkVolume;
VTK_ABI_NAMESPACE_END

namespace TemporalCoherence
{

/// The positions of samples along the axes of an image: sample i of an axis lies at First + i Step.
struct ImageAxes
{
  glm::dvec3 First{ 0.0 }, Step{ 1.0 };
};

/// Make a field of one component of an image's array. The samples are not copied.
/// \param image     defines the places of the samples
/// \param array     one tuple for each point, or for each cell, of the image; AreInPlace(array)
/// \param onCells   samples lie at the centres of cells; the field is the box between the centres
/// \param component of the array
/// \param error     receives the mistake and its remedy
/// \return false on error. An image with fewer than two samples along an axis is no error: its
///         field has no cells.
bool MakeField(vtkImageData* image, vtkDataArray* array, bool onCells, int component, Field& field,
  std::string& error);

/// Make the transform from index space to the world: by origin, spacing, direction and first index
/// of the image, and the transform of the volume.
/// \return false on error, for example if a spacing or a scale is zero
bool MakeIndexTransform(vtkImageData* image, bool onCells, vtkVolume* volume,
  IndexTransform& transform, std::string& error);

/// The positions of samples along the image's own axes: by origin, spacing and first index.
/// \param onCells samples lie at the centres of cells
ImageAxes AxesOf(vtkImageData* image, bool onCells);

}

#endif
