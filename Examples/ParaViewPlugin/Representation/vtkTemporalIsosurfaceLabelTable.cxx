// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTemporalIsosurfaceLabelTable.h"

#include "vtkDiscretizableColorTransferFunction.h"
#include "vtkObjectFactory.h"
#include "vtkPiecewiseFunction.h"
#include "vtkVariant.h"

#include <algorithm>

vtkStandardNewMacro(vtkTemporalIsosurfaceLabelTable);

namespace
{

bool IsTranslucent(double opacity)
{
  return opacity > 0.0 && opacity < 1.0;
}

}

//------------------------------------------------------------------------------
vtkTemporalIsosurfaceLabelTable::vtkTemporalIsosurfaceLabelTable() = default;

//------------------------------------------------------------------------------
vtkTemporalIsosurfaceLabelTable::~vtkTemporalIsosurfaceLabelTable() = default;

//------------------------------------------------------------------------------
void vtkTemporalIsosurfaceLabelTable::SetColors(vtkColorTransferFunction* colors)
{
  if (this->Colors != colors)
  {
    this->Colors = colors;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkTemporalIsosurfaceLabelTable::SetOpacities(vtkPiecewiseFunction* opacities)
{
  if (this->Opacities != opacities)
  {
    this->Opacities = opacities;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkTemporalIsosurfaceLabelTable::SetOwnOpacities(const std::map<double, double>& opacities)
{
  if (this->OwnOpacities != opacities)
  {
    this->OwnOpacities = opacities;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
bool vtkTemporalIsosurfaceLabelTable::HasOpacitiesOfCategories()
{
  auto* map = vtkDiscretizableColorTransferFunction::SafeDownCast(this->Colors);
  return map && map->GetIndexedLookup() && map->GetEnableOpacityMapping();
}

//------------------------------------------------------------------------------
bool vtkTemporalIsosurfaceLabelTable::MayBeTranslucent()
{
  if (std::any_of(this->OwnOpacities.begin(), this->OwnOpacities.end(),
        [](const auto& own) { return IsTranslucent(own.second); }))
  {
    return true;
  }
  if (!this->HasOpacitiesOfCategories())
  {
    double node[4] = { 0.0, 1.0, 0.0, 0.0 }; // place, opacity, and how it goes on
    const int count = this->Opacities->GetSize();
    for (int i = 0; i < count; ++i)
    {
      const double last = node[1];
      this->Opacities->GetNodeValue(i, node);
      if (IsTranslucent(node[1]) || (i > 0 && node[1] != last))
      {
        return true;
      }
    }
    return false;
  }
  this->Build();
  bool isTranslucent = IsTranslucent(this->Colors->GetNanOpacity());
  for (vtkIdType i = 0; i < this->Colors->GetNumberOfAnnotatedValues(); ++i)
  {
    double rgba[4];
    this->Colors->GetIndexedColor(i, rgba);
    isTranslucent = isTranslucent || IsTranslucent(rgba[3]);
  }
  return isTranslucent;
}

//------------------------------------------------------------------------------
/// The colour and opacity of a label's category, or those of values that have none.
void vtkTemporalIsosurfaceLabelTable::GetCategory(double label, double rgba[4])
{
  const vtkIdType category = this->Colors->GetAnnotatedValueIndex(vtkVariant(label));
  if (category >= 0)
  {
    this->Colors->GetIndexedColor(category, rgba);
    return;
  }
  this->Colors->GetNanColor(rgba);
  rgba[3] = this->Colors->GetNanOpacity();
}

//------------------------------------------------------------------------------
void vtkTemporalIsosurfaceLabelTable::GetColor(double label, double rgb[3])
{
  if (!this->Colors->GetIndexedLookup())
  {
    this->Colors->GetColor(label, rgb);
    return;
  }
  double rgba[4];
  this->GetCategory(label, rgba);
  std::copy_n(rgba, 3, rgb);
}

//------------------------------------------------------------------------------
double vtkTemporalIsosurfaceLabelTable::GetOpacity(double label)
{
  const auto own = this->OwnOpacities.find(label);
  if (own != this->OwnOpacities.end())
  {
    return own->second;
  }
  if (!this->HasOpacitiesOfCategories())
  {
    return this->Opacities->GetValue(label);
  }
  double rgba[4];
  this->GetCategory(label, rgba);
  return rgba[3];
}

//------------------------------------------------------------------------------
void vtkTemporalIsosurfaceLabelTable::Build()
{
  this->Colors->Build();
}

//------------------------------------------------------------------------------
vtkMTimeType vtkTemporalIsosurfaceLabelTable::GetMTime()
{
  vtkMTimeType time = this->Superclass::GetMTime();
  for (vtkObject* part :
    { static_cast<vtkObject*>(this->Colors), static_cast<vtkObject*>(this->Opacities) })
  {
    time = part ? std::max(time, part->GetMTime()) : time;
  }
  return time;
}

//------------------------------------------------------------------------------
void vtkTemporalIsosurfaceLabelTable::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "OwnOpacities: " << this->OwnOpacities.size() << "\n";
}
