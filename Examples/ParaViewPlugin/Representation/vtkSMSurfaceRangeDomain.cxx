// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMSurfaceRangeDomain.h"

#include "InputArrays.h"

#include "vtkObjectFactory.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMUncheckedPropertyHelper.h"

vtkStandardNewMacro(vtkSMSurfaceRangeDomain);

//------------------------------------------------------------------------------
vtkSMSurfaceRangeDomain::vtkSMSurfaceRangeDomain() = default;

//------------------------------------------------------------------------------
vtkSMSurfaceRangeDomain::~vtkSMSurfaceRangeDomain() = default;

//------------------------------------------------------------------------------
void vtkSMSurfaceRangeDomain::Update(vtkSMProperty* property)
{
  vtkSMProperty* input = this->GetRequiredProperty("Input");
  vtkSMProperty* selection = this->GetRequiredProperty("SurfaceArraySelection");
  if (!input || !selection)
  {
    this->Superclass::Update(property);
    return;
  }
  vtkSMUncheckedPropertyHelper inputs(input), array(selection);
  auto* source = vtkSMSourceProxy::SafeDownCast(inputs.GetAsProxy());
  const bool hasFive = array.GetNumberOfElements() == 5;
  const char* name = hasFive ? array.GetAsString(4) : nullptr;
  if (!source || !IsArrayName(name))
  {
    this->Superclass::Update(property);
    return;
  }
  vtkSMProperty* component = this->GetRequiredProperty("ComponentSelection");
  this->vtkSMArrayRangeDomain::Update(name, array.GetAsInt(3), source, inputs.GetOutputPort(),
    component ? vtkSMUncheckedPropertyHelper(component).GetAsInt() : -1);
}

//------------------------------------------------------------------------------
void vtkSMSurfaceRangeDomain::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
