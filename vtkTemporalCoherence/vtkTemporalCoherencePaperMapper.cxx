// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTemporalCoherencePaperMapper.h"

#include "Choice.h"

VTK_ABI_NAMESPACE_BEGIN
//------------------------------------------------------------------------------
vtkTemporalCoherencePaperMapper::vtkTemporalCoherencePaperMapper() = default;

//------------------------------------------------------------------------------
vtkTemporalCoherencePaperMapper::~vtkTemporalCoherencePaperMapper() = default;

//------------------------------------------------------------------------------
void vtkTemporalCoherencePaperMapper::SetImageCachePolicy(int policy)
{
  TemporalCoherence::SetChoice(this, "ImageCachePolicy", policy,
    { { LATEST, "LATEST" }, { KEY_IMAGE, "KEY_IMAGE" } }, this->ImageCachePolicy);
}

//------------------------------------------------------------------------------
void vtkTemporalCoherencePaperMapper::SetImageCacheShading(int shading)
{
  TemporalCoherence::SetChoice(this, "ImageCacheShading", shading,
    { { RESHADE, "RESHADE" }, { INTERPOLATE, "INTERPOLATE" } }, this->ImageCacheShading);
}

//------------------------------------------------------------------------------
void vtkTemporalCoherencePaperMapper::SetIsomapShading(int shading)
{
  TemporalCoherence::SetChoice(this, "IsomapShading", shading,
    { { RESHADE, "RESHADE" }, { INTERPOLATE, "INTERPOLATE" } }, this->IsomapShading);
}

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
