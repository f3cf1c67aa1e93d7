// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTemporalIsosurfaceActor
 * @brief   ParaView's prop for volumes, which draws with a vtkTemporalCoherenceVolume
 *
 * vtkPVLODVolume draws no blocks but with a mapper of one class, and no volume before translucent
 * polygons. This one does both. On processes without data it draws the outline, as that does.
 */

#ifndef vtkTemporalIsosurfaceActor_h
#define vtkTemporalIsosurfaceActor_h

#include "vtkNew.h" // For vtkNew
#include "vtkPVLODVolume.h"

class vtkTemporalCoherenceVolume;

class vtkTemporalIsosurfaceActor : public vtkPVLODVolume
{
public:
  static vtkTemporalIsosurfaceActor* New();
  vtkTypeMacro(vtkTemporalIsosurfaceActor, vtkPVLODVolume);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  int RenderOpaqueGeometry(vtkViewport* viewport) override;
  int RenderVolumetricGeometry(vtkViewport* viewport) override;
  vtkTypeBool HasOpaqueGeometry() override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkTemporalIsosurfaceActor();
  ~vtkTemporalIsosurfaceActor() override;

private:
  vtkTemporalIsosurfaceActor(const vtkTemporalIsosurfaceActor&) = delete;
  void operator=(const vtkTemporalIsosurfaceActor&) = delete;

  vtkTemporalCoherenceVolume* PrepareSurface(vtkViewport* viewport);

  vtkNew<vtkTemporalCoherenceVolume> Surface;
};

#endif
