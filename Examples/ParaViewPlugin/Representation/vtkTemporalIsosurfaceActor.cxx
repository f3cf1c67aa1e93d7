// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTemporalIsosurfaceActor.h"

#include "vtkAbstractVolumeMapper.h"
#include "vtkObjectFactory.h"
#include "vtkTemporalCoherenceVolume.h"

vtkStandardNewMacro(vtkTemporalIsosurfaceActor);

//------------------------------------------------------------------------------
vtkTemporalIsosurfaceActor::vtkTemporalIsosurfaceActor() = default;

//------------------------------------------------------------------------------
vtkTemporalIsosurfaceActor::~vtkTemporalIsosurfaceActor() = default;

//------------------------------------------------------------------------------
/// The volume that draws, with all that was set on this; null where the outline is drawn.
vtkTemporalCoherenceVolume* vtkTemporalIsosurfaceActor::PrepareSurface(vtkViewport* viewport)
{
  if (this->EnableLOD || !this->GetMapper())
  {
    return nullptr;
  }
  this->Surface->SetMapper(this->GetMapper());
  this->Surface->SetProperty(this->Property);
  this->Surface->SetUserMatrix(this->GetMatrix());
  this->Surface->SetPropertyKeys(this->GetPropertyKeys());
  this->Surface->SetAllocatedRenderTime(this->AllocatedRenderTime, viewport);
  return this->Surface;
}

//------------------------------------------------------------------------------
int vtkTemporalIsosurfaceActor::RenderOpaqueGeometry(vtkViewport* viewport)
{
  vtkVolume* surface = this->PrepareSurface(viewport);
  return surface ? surface->RenderOpaqueGeometry(viewport)
                 : this->Superclass::RenderOpaqueGeometry(viewport);
}

//------------------------------------------------------------------------------
int vtkTemporalIsosurfaceActor::RenderVolumetricGeometry(vtkViewport* viewport)
{
  vtkVolume* surface = this->PrepareSurface(viewport);
  return surface ? surface->RenderVolumetricGeometry(viewport)
                 : this->Superclass::RenderVolumetricGeometry(viewport);
}

//------------------------------------------------------------------------------
vtkTypeBool vtkTemporalIsosurfaceActor::HasOpaqueGeometry()
{
  vtkVolume* surface = this->PrepareSurface(nullptr);
  return surface ? surface->HasOpaqueGeometry() : this->Superclass::HasOpaqueGeometry();
}

//------------------------------------------------------------------------------
void vtkTemporalIsosurfaceActor::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Surface->ReleaseGraphicsResources(window);
  this->Superclass::ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
void vtkTemporalIsosurfaceActor::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
