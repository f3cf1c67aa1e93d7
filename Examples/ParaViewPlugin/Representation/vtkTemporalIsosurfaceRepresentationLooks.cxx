// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTemporalIsosurfaceRepresentation.h"

#include "InputArrays.h"

#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkPiecewiseFunction.h"
#include "vtkTemporalCoherenceVolumeMapper.h"
#include "vtkTemporalIsosurfaceLabelTable.h"
#include "vtkVolumeProperty.h"

#include <algorithm>

//------------------------------------------------------------------------------
bool vtkTemporalIsosurfaceRepresentation::AreLabelsDrawn()
{
  return this->GetMapper()->GetSurfaceMode() == vtkTemporalCoherenceVolumeMapper::LABELS;
}

//------------------------------------------------------------------------------
bool vtkTemporalIsosurfaceRepresentation::IsTranslucent()
{
  if (this->AreLabelsDrawn())
  {
    this->UpdateLabelTable();
    return this->LabelTable->MayBeTranslucent();
  }
  return this->UseOpacityFunction || this->Opacity < 1.0 ||
    std::any_of(this->SurfaceLooks.begin(), this->SurfaceLooks.end(),
      [](const Look& look) { return look[3] < 1.0; });
}

//------------------------------------------------------------------------------
/// The array that the user chose; without a name if none.
ArrayChoice vtkTemporalIsosurfaceRepresentation::ArrayChosenFor(int index)
{
  vtkInformation* info = this->GetInputArrayInformation(index);
  const char* name = info ? info->Get(vtkDataObject::FIELD_NAME()) : nullptr;
  if (!IsArrayName(name))
  {
    return {};
  }
  return { name,
    info->Get(vtkDataObject::FIELD_ASSOCIATION()) == vtkDataObject::FIELD_ASSOCIATION_CELLS };
}

//------------------------------------------------------------------------------
bool vtkTemporalIsosurfaceRepresentation::IsColoredByArray()
{
  return !this->ArrayChosenFor(ColorArray).Name.empty();
}

//------------------------------------------------------------------------------
/// True if colours come from another array, or component, than surfaces.
bool vtkTemporalIsosurfaceRepresentation::IsColoredBySecondArray()
{
  const ArrayChoice surface = this->ArrayChosenFor(SurfaceArray);
  const ArrayChoice color = this->ArrayChosenFor(ColorArray);
  if (surface.Name.empty() || color.Name.empty() || !this->Table)
  {
    return false;
  }
  return surface.Name != color.Name || surface.IsOnCells != color.IsOnCells ||
    (this->NumberOfComponents > 1 && this->SurfaceComponent() != this->ColorComponent());
}

//------------------------------------------------------------------------------
/// The component that the lookup table names; -1: the length.
int vtkTemporalIsosurfaceRepresentation::ColorComponent()
{
  const bool isComponent = this->Table && this->IsColoredByArray() &&
    this->Table->GetVectorMode() == vtkScalarsToColors::COMPONENT;
  return isComponent ? this->Table->GetVectorComponent() : -1;
}

//------------------------------------------------------------------------------
/// The component of the array that is drawn; -1: the length.
int vtkTemporalIsosurfaceRepresentation::SurfaceComponent()
{
  if (this->ArrayChosenFor(SurfaceArray).Name.empty())
  {
    return this->ColorComponent();
  }
  return this->SurfaceArrayComponent < this->NumberOfComponents ? this->SurfaceArrayComponent : -1;
}

//------------------------------------------------------------------------------
vtkColorTransferFunction* vtkTemporalIsosurfaceRepresentation::ColorsOfSurfaceArray()
{
  const bool hasTable = this->Table && this->IsColoredByArray() && !this->IsColoredBySecondArray();
  return hasTable ? this->Table.Get() : this->SolidColor.Get();
}

//------------------------------------------------------------------------------
vtkPiecewiseFunction* vtkTemporalIsosurfaceRepresentation::OpacitiesOfSurfaceArray()
{
  const bool usesFunction =
    this->UseOpacityFunction && this->OpacityFunction && !this->IsColoredBySecondArray();
  return usesFunction ? this->OpacityFunction.Get() : this->ConstantOpacity.Get();
}

//------------------------------------------------------------------------------
/// \return a sentence about a second array that the input lacks; empty if all is well
std::string vtkTemporalIsosurfaceRepresentation::ShowLooks(
  vtkDataObject* data, const ArrayChoice& drawn)
{
  vtkColorTransferFunction* colors = this->ColorsOfSurfaceArray();
  vtkPiecewiseFunction* opacities = this->OpacitiesOfSurfaceArray();
  this->UpdateLabelTable();
  if (!this->SurfaceLooks.empty())
  {
    this->ShowSurfaceLooks(colors, opacities);
    colors = this->ColorsOfSurfaces;
    opacities = this->OpacitiesOfSurfaces;
  }
  this->Property->SetColor(colors);
  this->Property->SetScalarOpacity(opacities);
  return this->ShowSecondArray(data, drawn);
}

//------------------------------------------------------------------------------
void vtkTemporalIsosurfaceRepresentation::UpdateLabelTable()
{
  std::map<double, double> opacities;
  for (const auto& [label, opacity] : this->LabelOpacities)
  {
    opacities[label] = opacity;
  }
  this->LabelTable->SetColors(this->ColorsOfSurfaceArray());
  this->LabelTable->SetOpacities(this->OpacitiesOfSurfaceArray());
  this->LabelTable->SetOwnOpacities(opacities);
}

//------------------------------------------------------------------------------
/// Colour surfaces by another array than the one that is drawn, if the user chose one.
/// \return a sentence about this array if a data set lacks it, which is then not coloured
std::string vtkTemporalIsosurfaceRepresentation::ShowSecondArray(
  vtkDataObject* data, const ArrayChoice& drawn)
{
  vtkTemporalCoherenceVolumeMapper* mapper = this->GetMapper();
  ArrayChoice color;
  int numberOfComponents = 1;
  std::string mistake;
  if (this->IsColoredBySecondArray())
  {
    color = this->ArrayChosenFor(ColorArray);
    for (vtkDataSet* dataSet : DataSetsOf(data))
    {
      vtkDataArray* array = color.In(dataSet);
      numberOfComponents = array ? array->GetNumberOfComponents() : numberOfComponents;
      if (!array && drawn.In(dataSet) && mistake.empty())
      {
        mistake = SayMissing(color, data, "ColorBy");
      }
    }
  }
  const int component = this->ColorComponent();
  mapper->SetColorArrayName(mistake.empty() ? color.Name.c_str() : nullptr);
  mapper->SetColorArrayOnCells(color.IsOnCells);
  mapper->SetColorArrayComponent(numberOfComponents == 1 ? 0
      : component < numberOfComponents                   ? component
                                                         : -1);
  mapper->SetColorTable(this->Table);
  return mistake;
}

//------------------------------------------------------------------------------
/// Give the functions of surfaces a node at each isovalue that is drawn. They are left alone if
/// nothing is new, so that their pictures are used again.
/// \param colors, opacities of isovalues without a look
void vtkTemporalIsosurfaceRepresentation::ShowSurfaceLooks(
  vtkColorTransferFunction* colors, vtkPiecewiseFunction* opacities)
{
  std::map<double, Look> looks;
  const auto count = static_cast<std::size_t>(this->ShownIsovalues->GetNumberOfTuples());
  for (std::size_t i = 0; i < count; ++i)
  {
    const double isovalue = this->ShownIsovalues->GetValue(static_cast<vtkIdType>(i));
    Look look;
    if (i < this->SurfaceLooks.size())
    {
      look = this->SurfaceLooks[i];
    }
    else
    {
      colors->GetColor(isovalue, look.data());
      look[3] = opacities->GetValue(isovalue);
    }
    looks[isovalue] = look;
  }
  if (looks == this->LooksInFunctions)
  {
    return;
  }
  this->LooksInFunctions = looks;
  this->ColorsOfSurfaces->RemoveAllPoints();
  this->OpacitiesOfSurfaces->RemoveAllPoints();
  for (const auto& [isovalue, look] : looks)
  {
    this->ColorsOfSurfaces->AddRGBPoint(isovalue, look[0], look[1], look[2]);
    this->OpacitiesOfSurfaces->AddPoint(isovalue, look[3]);
  }
}
