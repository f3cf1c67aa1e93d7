// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTemporalCoherenceVolume.h"

#include "vtkTemporalCoherenceVolumeMapper.h"

#include "vtkObjectFactory.h"
#include "vtkRenderer.h"

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkTemporalCoherenceVolume);

//------------------------------------------------------------------------------
int vtkTemporalCoherenceVolume::RenderOpaqueGeometry(vtkViewport* viewport)
{
  // vtkVolume draws nothing in this pass, and everything in its volumetric pass.
  return this->HasOpaqueGeometry() ? this->Superclass::RenderVolumetricGeometry(viewport) : 0;
}

//------------------------------------------------------------------------------
int vtkTemporalCoherenceVolume::RenderVolumetricGeometry(vtkViewport* viewport)
{
  if (!this->HasOpaqueGeometry())
  {
    return this->Superclass::RenderVolumetricGeometry(viewport);
  }
  if (auto* renderer = vtkRenderer::SafeDownCast(viewport))
  {
    vtkTemporalCoherenceVolumeMapper::SafeDownCast(this->Mapper)->RenderEdges(renderer, this);
  }
  return 0;
}

//------------------------------------------------------------------------------
vtkTypeBool vtkTemporalCoherenceVolume::HasOpaqueGeometry()
{
  auto* mapper = vtkTemporalCoherenceVolumeMapper::SafeDownCast(this->Mapper);
  return mapper && mapper->IsOpaque(this);
}

//------------------------------------------------------------------------------
vtkTypeBool vtkTemporalCoherenceVolume::HasTranslucentPolygonalGeometry()
{
  return 0;
}

//------------------------------------------------------------------------------
void vtkTemporalCoherenceVolume::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
VTK_ABI_NAMESPACE_END
