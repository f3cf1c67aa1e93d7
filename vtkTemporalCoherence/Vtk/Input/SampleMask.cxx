// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Input/SampleMask.h"

#include "Input/SamplesOfArray.h"
#include "Input/ScalarChoice.h"
#include "Input/SettingCheck.h"
#include "Scene/Parallel.h"

#include <vtkDataArray.h>
#include <vtkDataObjectTree.h>
#include <vtkImageData.h>
#include <vtkPiecewiseFunction.h>
#include <vtkRectilinearGrid.h>
#include <vtkVolumeMapper.h>
#include <vtkVolumeProperty.h>

#include <algorithm>
#include <sstream>

namespace TemporalCoherence
{
namespace
{

constexpr std::int64_t SampleGrain = 1 << 16;

std::string TextOf(const glm::ivec3& count)
{
  return std::to_string(count.x) + " x " + std::to_string(count.y) + " x " +
    std::to_string(count.z);
}

/// Find the hidden labels, whose own opacity is 0 at all isovalues.
/// \return false if a label is hidden at some isovalues only
bool FindHiddenLabels(vtkVolumeProperty* property, const std::vector<double>& isovalues,
  std::vector<std::int64_t>& hidden, std::string& error)
{
  for (const int label : property->GetLabelMapLabels())
  {
    vtkPiecewiseFunction* const own = property->GetLabelScalarOpacity(label);
    const double* lastShown = nullptr;
    const double* lastHidden = nullptr;
    for (const double& isovalue : isovalues)
    {
      const double opacity = own ? own->GetValue(isovalue) : 1.0;
      SettingCheck check({ "label", label, "the volume's property" }, error);
      check("Scalar opacity", opacity, Allowed::Opacity, "GetLabelScalarOpacity(label)->AddPoint");
      if (!check.HasPassed())
      {
        return false;
      }
      (opacity > 0.0 ? lastShown : lastHidden) = &isovalue;
    }
    if (lastHidden && lastShown)
    {
      std::ostringstream what;
      what << "The scalar opacity of label " << label << " is 0 at isovalue " << *lastHidden
           << ", but not at " << *lastShown
           << "; a label can be hidden at all isovalues or at none: set it with "
              "SetLabelScalarOpacity, or draw each isovalue by a mapper and a vtkVolume of its "
              "own.";
      error = what.str();
      return false;
    }
    if (lastHidden)
    {
      hidden.push_back(label);
    }
  }
  return true;
}

/// The error message for an unusable array of a mask; empty if it is usable.
std::string WhyUnusable(
  vtkImageData* image, const ChosenScalars& scalars, const glm::ivec3& samples)
{
  constexpr const char* remedy = ", or call SetMaskInput(nullptr).";
  if (!scalars.Array)
  {
    return std::string("The mask has no scalars; give it one number for each sample of the input") +
      remedy;
  }
  glm::ivec3 count;
  image->GetDimensions(&count.x);
  count -= scalars.OnCells ? 1 : 0;
  if (count != samples)
  {
    return "The mask has " + TextOf(count) + " values, but the input has " + TextOf(samples) +
      " samples; give it a mask with one value for each sample" + remedy;
  }
  const int components = scalars.Array->GetNumberOfComponents();
  if (components != 1)
  {
    return "The array " + NameOf(scalars.Array) + " of the mask has " + std::to_string(components) +
      " components; give it one" + remedy;
  }
  const std::int64_t values = CountSamples(image, scalars.OnCells);
  if (!HasOneForEach(scalars.Array, { "The mask", scalars.OnCells, values }))
  {
    return "The array " + NameOf(scalars.Array) + " of the mask has " +
      std::to_string(scalars.Array->GetNumberOfTuples()) + " values, but the input has " +
      TextOf(samples) + " samples; give it one value for each sample" + remedy;
  }
  return std::string();
}

}

bool FindMask(const MaskSettings& settings, vtkVolumeMapper* mapper, const glm::ivec3& samples,
  vtkVolumeProperty* property, const std::vector<double>* isovalues, SampleMask& mask,
  std::string& error)
{
  mask = SampleMask();
  vtkImageData* const image = settings.Image;
  if (!image)
  {
    return true;
  }
  mask.IsLabelMap = settings.IsLabelMap;
  if (mask.IsLabelMap)
  {
    const bool countsAlone = isovalues && settings.BlendFactor >= 1.0f;
    if (countsAlone && !FindHiddenLabels(property, *isovalues, mask.HiddenLabels, error))
    {
      return false;
    }
    mask.GivesLooks = !isovalues && mapper->GetBlendMode() == vtkVolumeMapper::COMPOSITE_BLEND &&
      settings.BlendFactor > 0.0f && !property->GetLabelMapLabels().empty();
    if (mask.HiddenLabels.empty() && !mask.GivesLooks)
    {
      return true; // the mask has no effect
    }
  }
  vtkDataObject* input = mapper->GetDataObjectInput();
  if (vtkDataObjectTree::SafeDownCast(input))
  {
    error = "A mask cannot be used with blocks; hide cells of the blocks with "
            "vtkUniformGrid::BlankCell, or call SetMaskInput(nullptr).";
    return false;
  }
  if (!vtkImageData::SafeDownCast(input) && !vtkRectilinearGrid::SafeDownCast(input))
  {
    error = std::string("A mask cannot be used with a ") + input->GetClassName() +
      "; hide cells with an array vtkGhostType (vtkDataSet::AllocateCellGhostArray), or call "
      "SetMaskInput(nullptr).";
    return false;
  }
  ChosenScalars scalars = FindScalars(image, ChoiceOf(mapper));
  if (!scalars.Array)
  {
    scalars = FindScalars(image, ScalarChoice());
  }
  error = WhyUnusable(image, scalars, samples);
  if (!error.empty())
  {
    return false;
  }
  const int type = scalars.Array->GetDataType();
  if (type == VTK_FLOAT || type == VTK_DOUBLE)
  {
    error = "The values of the mask have the type " +
      std::string(scalars.Array->GetDataTypeAsString()) +
      "; give it integers, for example with vtkImageCast, or call SetMaskInput(nullptr).";
    return false;
  }
  mask.Array = scalars.Array;
  mask.OnCells = scalars.OnCells;
  mask.Time = std::max(image->GetMTime(), scalars.Array->GetMTime());
  return true;
}

const std::uint8_t* SamplesShown(const SampleMask& mask, std::vector<std::uint8_t>& room)
{
  const bool areInPlace = AreInPlace(mask.Array);
  const auto array =
    areInPlace ? vtkSmartPointer<vtkDataArray>(mask.Array) : CopyInPlace(mask.Array);
  const ArraySamples values = SamplesOf(array, 0);
  if (areInPlace && values.Type == ScalarType::UInt8 && values.Step == 1 && !mask.IsLabelMap)
  {
    return static_cast<const std::uint8_t*>(values.First);
  }
  const vtkIdType count = mask.Array->GetNumberOfTuples();
  room.resize(static_cast<std::size_t>(count));
  const std::vector<std::int64_t>& hidden = mask.HiddenLabels;
  DispatchScalarType(values.Type,
    [&](auto sample)
    {
      using T = decltype(sample);
      const T* const first = static_cast<const T*>(values.First);
      ParallelFor(count, SampleGrain,
        [&](std::int64_t i)
        {
          const T value = first[i * values.Step];
          const bool isShown = mask.IsLabelMap
            ? !std::binary_search(hidden.begin(), hidden.end(), static_cast<std::int64_t>(value))
            : value > T(0);
          room[static_cast<std::size_t>(i)] = isShown;
        });
    });
  return room.data();
}

}
