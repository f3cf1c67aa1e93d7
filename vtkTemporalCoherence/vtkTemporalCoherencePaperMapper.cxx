// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTemporalCoherencePaperMapper.h"

VTK_ABI_NAMESPACE_BEGIN
//------------------------------------------------------------------------------
vtkTemporalCoherencePaperMapper::vtkTemporalCoherencePaperMapper() = default;

//------------------------------------------------------------------------------
vtkTemporalCoherencePaperMapper::~vtkTemporalCoherencePaperMapper() = default;

//------------------------------------------------------------------------------
void vtkTemporalCoherencePaperMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ImageCachePolicy: " << this->ImageCachePolicy << endl;
  os << indent << "KeyImageInterval: " << this->KeyImageInterval << endl;
  os << indent << "ImageCacheShading: " << this->ImageCacheShading << endl;
  os << indent << "IsomapShading: " << this->IsomapShading << endl;
  os << indent << "ColorByAnswer: " << this->ColorByAnswer << endl;
  os << indent << "SpaceLeaping: " << this->SpaceLeaping << endl;
}
VTK_ABI_NAMESPACE_END
