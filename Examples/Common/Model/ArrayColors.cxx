// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Model/ArrayColors.h"

#include "Program/Quoted.h"
#include "View/Appearance.h"

#include <vtkTemporalCoherenceVolumeMapper.h>

void ArrayColors::Show(const ColorArrays& arrays)
{
  this->Choices = arrays;
  this->Shown = {};
}

ArrayColor ArrayColors::Fitted(const ArrayColor& color) const
{
  const ColorArrays::Item* const array = this->Choices.Find(color.Name);
  if (!array)
  {
    return {};
  }
  const bool isThere = color.Component >= 0 && color.Component < array->Components;
  return { color.Name, array->Components == 1 ? 0 : isThere ? color.Component : -1 };
}

void ArrayColors::Apply(
  const Look& look, bool areSurfaces, vtkTemporalCoherenceVolumeMapper* mapper)
{
  const ArrayColor& color = look.ColorBy;
  if (!areSurfaces || !this->Choices.Has(color.Name, color.Component))
  {
    this->Shown = {};
    mapper->SetColorArrayName(nullptr);
    mapper->SetColorTable(nullptr);
    return;
  }
  const std::array<double, 2> range = this->Choices.Range(color.Name, color.Component);
  const int map = look.Choice(Row::ColorMap);
  if (!this->Table || map != this->Map || range != this->Range)
  {
    this->Table = vtkSmartPointer<vtkColorTransferFunction>::New();
    SetPalette(this->Table, map, range);
    this->Map = map;
    this->Range = range;
  }
  const ColorArrays::Item* const array = this->Choices.Find(color.Name);
  mapper->SetColorArrayName(color.Name.c_str());
  mapper->SetColorArrayOnCells(array->Choice.IsOnCells);
  mapper->SetColorArrayComponent(color.Component);
  mapper->SetColorTable(this->Table);
  const std::string part = color.Component < 0 ? "length" : std::to_string(color.Component + 1);
  this->Shown = { this->Table, Printable(color.Name) + (array->Components > 1 ? " " + part : "") };
}
