// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Input/ScalarChoice.h"

#include <vtkAbstractMapper.h>
#include <vtkDataArray.h>
#include <vtkDataSet.h>
#include <vtkPointData.h>
#include <vtkVolumeMapper.h>
#include <vtkVolumeProperty.h>

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace TemporalCoherence
{
namespace
{

/// The component with the largest weight; the first one of equal weights.
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

ScalarChoice ChoiceOf(vtkVolumeMapper* mapper)
{
  ScalarChoice choice;
  choice.Mode = mapper->GetScalarMode();
  choice.IsByName = mapper->GetArrayAccessMode() == VTK_GET_ARRAY_BY_NAME;
  choice.Number = mapper->GetArrayId();
  choice.Name = mapper->GetArrayName() ? mapper->GetArrayName() : "";
  return choice;
}

ScalarChoice ArrayChoice::Scalars() const
{
  ScalarChoice choice;
  choice.Mode =
    this->OnCells ? VTK_SCALAR_MODE_USE_CELL_FIELD_DATA : VTK_SCALAR_MODE_USE_POINT_FIELD_DATA;
  choice.IsByName = true;
  choice.Name = this->Name;
  return choice;
}

std::vector<int> ArrayChoice::ComponentsOf(vtkDataArray* array) const
{
  std::vector<int> components(
    this->Component < 0 ? static_cast<std::size_t>(array->GetNumberOfComponents()) : 1);
  std::iota(components.begin(), components.end(), std::max(this->Component, 0));
  return components;
}

std::string WhyThereIsNoArray(const ArrayChoice& choice)
{
  return "The input has no array of numbers named '" + choice.Name + "' on its " +
    (choice.OnCells ? "cells; choose an existing one with SetColorArrayName, or call "
                      "ColorArrayOnCellsOff()."
                    : "points; choose an existing one with SetColorArrayName, or call "
                      "ColorArrayOnCellsOn().");
}

ChosenScalars FindScalars(vtkDataSet* dataSet, const ScalarChoice& choice)
{
  ChosenScalars scalars;
  if (choice.Mode == VTK_SCALAR_MODE_USE_FIELD_DATA)
  {
    return scalars; // belongs to neither points nor cells
  }
  int isOnCells = 0;
  scalars.Array = vtkAbstractMapper::GetScalars(dataSet, choice.Mode,
    choice.IsByName ? VTK_GET_ARRAY_BY_NAME : VTK_GET_ARRAY_BY_ID, choice.Number,
    choice.Name.c_str(), isOnCells);
  scalars.OnCells = isOnCells != 0;
  return scalars;
}

ScalarChoice ChoiceForAll(const std::vector<vtkDataSet*>& dataSets, const ScalarChoice& choice)
{
  ScalarChoice same = choice;
  if (choice.Mode == VTK_SCALAR_MODE_DEFAULT)
  {
    const bool isOnPoints = std::any_of(dataSets.begin(), dataSets.end(),
      [](vtkDataSet* dataSet) { return dataSet->GetPointData()->GetScalars() != nullptr; });
    same.Mode = isOnPoints ? VTK_SCALAR_MODE_USE_POINT_DATA : VTK_SCALAR_MODE_USE_CELL_DATA;
  }
  return same;
}

bool IsOnCells(const ScalarChoice& choice)
{
  return choice.Mode == VTK_SCALAR_MODE_USE_CELL_DATA ||
    choice.Mode == VTK_SCALAR_MODE_USE_CELL_FIELD_DATA;
}

DrawnComponent ChooseComponent(
  vtkVolumeProperty* property, const VectorChoice& vectors, int components)
{
  using Modes = VectorChoice::Modes;
  DrawnComponent drawn;
  drawn.IsMagnitude = vectors.Mode == Modes::Magnitude && components > 1;
  if (vectors.Mode == Modes::Component)
  {
    drawn.Number = vectors.Component;
  }
  else if (vectors.Mode == Modes::Property && vectors.AreBlended)
  {
    drawn.Count = std::max(components, 1);
  }
  else if (vectors.Mode == Modes::Property && property->GetIndependentComponents())
  {
    drawn.Number = drawn.OfProperty = HeaviestComponent(property, components);
  }
  return drawn;
}

namespace
{

std::string WhyThereIsNoSuchArray(const ScalarChoice& choice)
{
  const std::string places = IsOnCells(choice) ? "cells" : "points";
  if (choice.IsByName ? choice.Name.empty() : choice.Number < 0)
  {
    return "ScalarMode asks for an array on " + places +
      ", but none is chosen; choose one with SelectScalarArray.";
  }
  return (choice.IsByName
             ? "The input has no array of numbers named '" + choice.Name + "' on its " + places
             : "The input has no array number " + std::to_string(choice.Number) + " on its " +
               places + ", or it holds no numbers") +
    "; choose an existing one with SelectScalarArray.";
}

}

std::string WhyThereAreNoScalars(const ScalarChoice& choice)
{
  switch (choice.Mode)
  {
    case VTK_SCALAR_MODE_DEFAULT:
      return "The input has no scalars on points or cells; make an array active with "
             "SetActiveScalars, or "
             "choose one with SetScalarModeToUsePointFieldData and SelectScalarArray.";
    case VTK_SCALAR_MODE_USE_POINT_DATA:
      return "The input has no scalars on points; make a point array active with SetActiveScalars, "
             "or call "
             "SetScalarModeToDefault or SetScalarModeToUseCellData.";
    case VTK_SCALAR_MODE_USE_CELL_DATA:
      return "The input has no scalars on cells; make a cell array active with SetActiveScalars, "
             "or call "
             "SetScalarModeToDefault or SetScalarModeToUsePointData.";
    case VTK_SCALAR_MODE_USE_POINT_FIELD_DATA:
    case VTK_SCALAR_MODE_USE_CELL_FIELD_DATA:
      return WhyThereIsNoSuchArray(choice);
    case VTK_SCALAR_MODE_USE_FIELD_DATA:
      return "Arrays of field data (ScalarMode VTK_SCALAR_MODE_USE_FIELD_DATA) have no place in "
             "space; call SetScalarModeToUsePointFieldData or SetScalarModeToUseCellFieldData.";
    default:
      return "ScalarMode is " + std::to_string(choice.Mode) +
        ", which is no scalar mode; call SetScalarModeToDefault or another SetScalarModeTo... .";
  }
}

}
