// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Input/InputFromMapper.h"

#include "Input/ScalarChoice.h"

#include <vtkDataArray.h>
#include <vtkDataObjectTree.h>
#include <vtkImageData.h>
#include <vtkRectilinearGrid.h>
#include <vtkVolumeMapper.h>
#include <vtkVolumeProperty.h>

#include <algorithm>
#include <exception>

namespace TemporalCoherence
{
namespace
{

/// The component with the largest weight; the first of equal ones.
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

int OtherInputPort(vtkVolumeMapper* mapper)
{
  for (int port = 1; port < mapper->GetNumberOfInputPorts(); ++port)
  {
    if (mapper->GetNumberOfInputConnections(port) > 0)
    {
      return port;
    }
  }
  return 0;
}

bool InputFromMapper::Find(vtkVolumeMapper* mapper, vtkVolumeProperty* property,
  const VectorChoice& vectors, MapperInput& input, std::string& error)
{
  input = MapperInput();
  if (mapper->GetBlendMode() != vtkVolumeMapper::ISOSURFACE_BLEND)
  {
    error = "Blend mode " + std::to_string(mapper->GetBlendMode()) +
      " is not supported, only isosurfaces are; call SetBlendModeToIsoSurface(), or use "
      "vtkGPUVolumeRayCastMapper, which draws the others, and isosurfaces by this mapper after "
      "vtkTemporalCoherenceObjectFactory::UseEverywhere().";
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

/// Find the image, or an image that stands for the input, and the array to draw.
bool InputFromMapper::FindImage(vtkVolumeMapper* mapper, MapperInput& input, std::string& error)
{
  vtkDataObject* object = mapper->GetDataObjectInput();
  if (!object)
  {
    error = "There is no input; give the mapper a vtkImageData or a vtkRectilinearGrid with "
            "SetInputData or SetInputConnection.";
    return false;
  }
  if (const int port = OtherInputPort(mapper))
  {
    error = "There is an input at port " + std::to_string(port) +
      ", but only port 0 is drawn; give each input a mapper and a vtkVolume of its own, or use "
      "vtkGPUVolumeRayCastMapper.";
    return false;
  }
  const ScalarChoice choice = ChoiceOf(mapper);
  ChosenScalars scalars;
  auto* tree = vtkDataObjectTree::SafeDownCast(object);
  auto* grid = vtkRectilinearGrid::SafeDownCast(object);
  input.Image = vtkImageData::SafeDownCast(object);
  if (tree)
  {
    if (!this->Blocks.Merge(tree, choice, error))
    {
      return false;
    }
    input.Image = this->Blocks.Image();
    scalars = this->Blocks.Scalars();
  }
  else if (input.Image || grid)
  {
    this->Blocks.Release();
    scalars = FindScalars(vtkDataSet::SafeDownCast(object), choice);
  }
  else
  {
    error = std::string("The input is a ") + object->GetClassName() +
      ", but only vtkImageData, blocks of them and vtkRectilinearGrid can be drawn; resample it "
      "with vtkResampleToImage.";
    return false;
  }
  vtkDataSet* dataSet = grid ? static_cast<vtkDataSet*>(grid) : input.Image;
  if (!scalars.Array && dataSet->GetNumberOfPoints() != 0)
  {
    error = WhyThereAreNoScalars(choice);
    return false;
  }
  input.Array = dataSet->GetNumberOfPoints() != 0 ? scalars.Array : nullptr;
  input.OnCells = scalars.OnCells;
  if (!grid)
  {
    this->Grid.Release();
    return true;
  }
  if (!this->Grid.See(grid, input.OnCells, error))
  {
    return false;
  }
  input.Image = this->Grid.Image();
  input.Kind = this->Grid.Kind();
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
    // As for the samples: whoever writes them may call Modified() of the array or of the image.
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
    input.Component = input.PropertyComponent = HeaviestComponent(property, components);
  }
  return true;
}

void InputFromMapper::Release()
{
  this->Blocks.Release();
  this->Magnitude.Release();
  this->Grid.Release();
}

}
