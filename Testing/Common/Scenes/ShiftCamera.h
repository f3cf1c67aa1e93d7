// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_ShiftCamera_h
#define Testing_ShiftCamera_h

#include <vtkCamera.h>
#include <vtkMath.h>

/// Move a camera and its focal point to its right, by a distance in the world.
inline void ShiftCamera(vtkCamera* camera, double distance)
{
  double right[3];
  vtkMath::Cross(camera->GetDirectionOfProjection(), camera->GetViewUp(), right);
  vtkMath::Normalize(right);
  double position[3], focus[3];
  camera->GetPosition(position);
  camera->GetFocalPoint(focus);
  for (int axis = 0; axis < 3; ++axis)
  {
    position[axis] += distance * right[axis];
    focus[axis] += distance * right[axis];
  }
  camera->SetPosition(position);
  camera->SetFocalPoint(focus);
}

#endif
