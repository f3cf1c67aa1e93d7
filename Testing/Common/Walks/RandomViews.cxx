// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Walks/RandomViews.h"

#include "Scenes/ShiftCamera.h"

#include <vtkMath.h>

RandomViews::RandomViews(Scene& scene, unsigned seed, int size)
  : Target(scene)
  , Engine(seed)
  , Smallest(size)
  , Width(size + 20)
  , Height(size)
{
  this->Jump();
}

bool RandomViews::RenderNext()
{
  this->Move();
  if (this->Pick(25) == 0)
  {
    this->Resize();
  }
  return this->Render();
}

void RandomViews::Move()
{
  vtkCamera* camera = this->Target.Renderer->GetActiveCamera();
  const int move = this->Pick(20);
  switch (move)
  {
    case 0:
      this->Jump();
      break;
    case 1:
      this->GoInside();
      break;
    case 2:
      camera->SetParallelProjection(1 - camera->GetParallelProjection());
      break;
    case 3:
    case 4:
      this->Pan();
      break;
    case 5:
    case 6:
      camera->Zoom(this->Between(0.9, 1.1));
      break;
    case 7:
    case 8:
      camera->Dolly(this->Between(0.9, 1.15));
      break;
    case 9:
      camera->Roll(this->Between(-20.0, 20.0));
      break;
    case 10:
      camera->Azimuth(this->Between(-40.0, 40.0));
      break;
    default:
      camera->Azimuth(this->Between(-3.0, 3.0));
      camera->Elevation(this->Between(-3.0, 3.0));
      camera->OrthogonalizeViewUp();
      break;
  }
  this->Target.Renderer->ResetCameraClippingRange();
  if (move == 11)
  {
    this->ClipByNearPlane();
  }
}

void RandomViews::Resize()
{
  this->Width = this->Smallest + 3 * this->Pick(21);
  this->Height = this->Smallest + 3 * this->Pick(21);
}

void RandomViews::Jump()
{
  this->Target.Renderer->GetActiveCamera()->SetViewAngle(30.0);
  const double x = this->Between(-1.0, 1.0);
  const double y = this->Between(-1.0, 1.0);
  this->Target.LookFrom(x, y, this->Between(0.1, 1.0));
}

void RandomViews::GoInside()
{
  const double* bounds = this->Target.Volume->GetBounds();
  double position[3], focus[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    position[axis] = this->Between(bounds[2 * axis], bounds[2 * axis + 1]);
    focus[axis] = this->Between(bounds[2 * axis], bounds[2 * axis + 1]);
  }
  if (vtkMath::Distance2BetweenPoints(position, focus) > 0.0)
  {
    vtkCamera* camera = this->Target.Renderer->GetActiveCamera();
    camera->SetPosition(position);
    camera->SetFocalPoint(focus);
    camera->SetViewUp(0.1, 0.2, 1.0);
  }
}

void RandomViews::Pan()
{
  vtkCamera* camera = this->Target.Renderer->GetActiveCamera();
  ShiftCamera(camera, this->Between(-0.3, 0.3) * camera->GetDistance());
}

void RandomViews::ClipByNearPlane()
{
  vtkCamera* camera = this->Target.Renderer->GetActiveCamera();
  double range[2];
  camera->GetClippingRange(range);
  camera->SetClippingRange(range[0] + this->Between(0.2, 0.7) * (range[1] - range[0]), range[1]);
}
