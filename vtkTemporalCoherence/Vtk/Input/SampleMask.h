// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_SampleMask_h
#define TemporalCoherence_SampleMask_h

#include "vtkTemporalCoherenceCompatibility.h"

#include <glm/glm.hpp>

#include <vtkType.h>

#include <cstdint>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;
class vtkImageData;
class vtkVolumeMapper;
class vtkVolumeProperty;
VTK_ABI_NAMESPACE_END

namespace TemporalCoherence
{

/// A mask as set by the user of a mapper.
struct MaskSettings
{
  vtkImageData* Image = nullptr; ///< or null
  bool IsLabelMap = false;       ///< otherwise binary
  float BlendFactor = 1.0f;      ///< weight of a label's own properties
};

/// A mask of a field's samples. Compared by value, except for the values of its array.
///
/// A binary mask shows samples where it is above 0. A label map hides the samples of some labels,
/// or gives looks to them.
struct SampleMask
{
  vtkDataArray* Array = nullptr; ///< one value for each sample; null if the mask has no effect
  bool OnCells = false;          ///< values lie on the cells of the mask's image
  vtkMTimeType Time = 0;         ///< differs whenever the array may have changed
  bool IsLabelMap = false;
  bool GivesLooks = false; ///< labels change how a blended volume looks, and hide nothing
  std::vector<std::int64_t> HiddenLabels; ///< of a label map, ascending

  bool operator==(const SampleMask& other) const
  {
    return this->Array == other.Array && this->OnCells == other.OnCells &&
      this->Time == other.Time && this->IsLabelMap == other.IsLabelMap &&
      this->GivesLooks == other.GivesLooks && this->HiddenLabels == other.HiddenLabels;
  }
};

/// Find the mask of a field. A label of surfaces is hidden if BlendFactor is 1, so that its own
/// scalar opacity counts alone, and this is 0 at all isovalues. In composite volumes labels give
/// looks. In other modes they have no effect.
/// \param mapper    its scalar mode chooses the array of the mask
/// \param samples   of the field along each axis
/// \param property  knows the labels
/// \param isovalues to draw; null for a blended volume
/// \param error     receives the mistake and its remedy
/// \return false on error
bool FindMask(const MaskSettings& settings, vtkVolumeMapper* mapper, const glm::ivec3& samples,
  vtkVolumeProperty* property, const std::vector<double>* isovalues, SampleMask& mask,
  std::string& error);

/// One byte for each sample of the field, 0 if the mask hides it.
/// \param room memory for the bytes, unless the mask's own values suffice
/// \pre the mask has an array
/// \throws std::bad_alloc
const std::uint8_t* SamplesShown(const SampleMask& mask, std::vector<std::uint8_t>& room);

}

#endif
