// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "InputFromMapper.h"

#include "ScalarChoice.h"

#include <vtkDataArray.h>
#include <vtkDataObjectTree.h>
#include <vtkImageData.h>
#include <vtkVolumeMapper.h>
#include <vtkVolumeProperty.h>

#include <algorithm>
#include <exception>

namespace TemporalCoherence
{
namespace
{

/// The component of the largest weight; of equal ones, the first.
int HeaviestComponent(vtkVolumeProperty* property, int components)
{
  int heaviest = 0;
  for (int c = 1; c < std::min(components, VTK_MAX_VRCOMP); ++c)
  {
    if (property->GetComponentWeight(c) > property->GetComponentWeight(heaviest))
    {
      heaviest = c;
    }
  }
  return heaviest;
}

}

bool InputFromMapper::Find(vtkVolumeMapper* mapper, vtkVolumeProperty* property,
  const VectorChoice& vectors, MapperInput& input, std::string& error)
{
  input = MapperInput();
  if (mapper->GetBlendMode() != vtkVolumeMapper::ISOSURFACE_BLEND)
  {
    error = "Blend mode " + std::to_string(mapper->GetBlendMode()) +
      " is not supported, only isosurfaces are; call SetBlendModeToIsoSurface().";
    return false;
  }
  try
  {
    return this->FindImage(mapper, input, error) &&
      this->ChooseComponent(property, vectors, input, error);
  }
  catch (const std::exception&)
  {
    error =
      "There is not enough memory to merge blocks or for the lengths of vectors; free memory, "
      "choose fewer blocks with vtkExtractBlock, or a component with "
      "SetVectorModeToComponent.";
    return false;
  }
}

bool InputFromMapper::FindImage(vtkVolumeMapper* mapper, MapperInput& input, std::string& error)
{
  vtkDataObject* object = mapper->GetDataObjectInput();
  if (!object)
  {
    error = "There is no input; give the mapper a vtkImageData with SetInputData or "
            "SetInputConnection.";
    return false;
  }
  const ScalarChoice choice = ChoiceOf(mapper);
  ChosenScalars scalars;
  if (auto* tree = vtkDataObjectTree::SafeDownCast(object))
  {
    if (!this->Blocks.Merge(tree, choice, error))
    {
      return false;
    }
    input.Image = this->Blocks.Image();
    scalars = this->Blocks.Scalars();
  }
  else if (auto* image = vtkImageData::SafeDownCast(object))
  {
    this->Blocks.Release();
    input.Image = image;
    scalars = FindScalars(image, choice);
  }
  else
  {
    error = std::string("The input is a ") + object->GetClassName() +
      ", but only vtkImageData and blocks of them can be drawn; resample it with "
      "vtkResampleToImage.";
    return false;
  }
  if (!scalars.Array && input.Image->GetNumberOfPoints() > 0)
  {
    error = WhyThereAreNoScalars(choice);
    return false;
  }
  input.Array = input.Image->GetNumberOfPoints() > 0 ? scalars.Array : nullptr;
  input.OnCells = scalars.OnCells;
  return true;
}

bool InputFromMapper::ChooseComponent(
  vtkVolumeProperty* property, const VectorChoice& vectors, MapperInput& input, std::string& error)
{
  const int components = input.Array ? input.Array->GetNumberOfComponents() : 0;
  const bool isMagnitude = vectors.Mode == VectorChoice::Modes::Magnitude && components > 1;
  if (!isMagnitude)
  {
    this->Magnitude.Release();
  }
  if (isMagnitude)
  {
    // As with the samples: who writes them may tell the array or the image.
    const vtkMTimeType stamp = std::max(input.Image->GetMTime(), input.Array->GetMTime());
    input.Array = this->Magnitude.Of(input.Array, stamp, error);
    return input.Array != nullptr;
  }
  if (vectors.Mode == VectorChoice::Modes::Component)
  {
    input.Component = vectors.Component;
  }
  else if (vectors.Mode == VectorChoice::Modes::Property && property->GetIndependentComponents())
  {
    input.Component = input.Look = HeaviestComponent(property, components);
  }
  return true;
}

void InputFromMapper::Release()
{
  this->Blocks.Release();
  this->Magnitude.Release();
}

}
