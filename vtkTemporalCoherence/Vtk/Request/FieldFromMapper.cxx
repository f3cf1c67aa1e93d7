// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Request/FieldFromMapper.h"

#include "Adaptive/AmrMesh.h"
#include "Request/EmptyInput.h"

#include <vtkDataObjectTree.h>
#include <vtkImageData.h>
#include <vtkRectilinearGrid.h>
#include <vtkVolumeMapper.h>

#include <exception>

namespace TemporalCoherence
{

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

bool FieldFromMapper::Find(vtkVolumeMapper* mapper, vtkVolumeProperty* property,
  const VectorChoice& vectors, DrawnComponent& found, std::string& error)
{
  found = DrawnComponent();
  vtkDataObject* data = mapper->GetDataObjectInput();
  if (!data)
  {
    error = "There is no input; give the mapper an image or a grid with SetInputData or "
            "SetInputConnection.";
    return false;
  }
  if (const int port = OtherInputPort(mapper))
  {
    error = "There is an input at port " + std::to_string(port) +
      ", but only port 0 is drawn; give each input a mapper and a vtkVolume of its own, or use "
      "vtkGPUVolumeRayCastMapper.";
    return false;
  }
  try
  {
    // Several levels of an adaptive grid are a mesh; one level alone is an image.
    auto* amr = AdaptiveGrid::SafeDownCast(data);
    this->OnlyLevel = amr && HasOneLevel(amr) ? BlocksOf(amr) : nullptr;
    vtkDataObject* drawn = this->OnlyLevel ? this->OnlyLevel.Get() : data;
    if (!this->ChooseSource(drawn, vectors.AreBlended, error) ||
      !this->Source->Find(drawn, ChoiceOf(mapper), property, vectors, found, error))
    {
      return false;
    }
    error = this->IsEmpty() && !MayBeEmpty(data) ? WhyThereIsNoVolume(data) : std::string();
    return error.empty();
  }
  catch (const std::exception&)
  {
    error =
      "There is not enough memory to merge the blocks or to compute the lengths of vectors; free "
      "memory, choose fewer blocks with vtkExtractBlock, or draw one component with "
      "SetVectorModeToComponent().";
    return false;
  }
}

bool FieldFromMapper::ChooseSource(vtkDataObject* data, bool areBlended, std::string& error)
{
  if (IsMesh(data))
  {
    if (areBlended)
    {
      error = std::string("The input is a ") + data->GetClassName() +
        ", which can only be drawn by isosurfaces; call SetBlendModeToIsoSurface(), or resample it "
        "with vtkResampleToImage.";
      return false;
    }
    this->Images.Release();
    this->Source = &this->Meshes;
    return true;
  }
  this->Meshes.Release();
  if (vtkImageData::SafeDownCast(data) || vtkRectilinearGrid::SafeDownCast(data) ||
    vtkDataObjectTree::SafeDownCast(data))
  {
    this->Source = &this->Images;
    return true;
  }
  error = std::string("The input is a ") + data->GetClassName() +
    ", but only images, rectilinear, curvilinear, explicit structured and unstructured grids, and "
    "blocks of these, can be drawn; resample it with vtkResampleToImage.";
  return false;
}

bool FieldFromMapper::Make(const FieldQuery& query, PlacedField& field, std::string& error)
{
  try
  {
    return this->Source->Make(query, field, error);
  }
  catch (const std::exception&)
  {
    error = "There is not enough memory to set up the cells of the input; free memory, or draw a "
            "part of it (vtkExtractCells).";
    return false;
  }
}

bool FieldFromMapper::MakeValues(
  const ArrayChoice& choice, vtkVolume* volume, FoundValues& found, std::string& error)
{
  try
  {
    return this->Source->MakeValues(choice, volume, found, error);
  }
  catch (const std::exception&)
  {
    error = "There is not enough memory to colour by array '" + choice.Name +
      "'; free memory, or call SetColorArrayName(nullptr).";
    return false;
  }
}

void FieldFromMapper::Release()
{
  this->Source = nullptr;
  this->Meshes.Release();
  this->Images.Release();
}

}
