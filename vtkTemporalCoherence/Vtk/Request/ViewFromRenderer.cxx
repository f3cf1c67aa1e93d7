// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Request/ViewFromRenderer.h"

#include "Input/MatrixFromVtk.h"
#include "Window/OpenGLWindow.h"

#include <vtkCamera.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkRenderer.h>

#include <sstream>

namespace TemporalCoherence
{

glm::ivec2 PictureSizeOf(vtkRenderer* renderer)
{
  glm::ivec2 size, origin;
  renderer->GetTiledSizeAndOrigin(&size.x, &size.y, &origin.x, &origin.y);
  if (auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow()))
  {
    const glm::ivec2 viewport = ViewportOf(window).Size;
    if (size.x > 0 && size.y > 0 && viewport.x > 0 && viewport.y > 0)
    {
      size = viewport;
    }
  }
  return size;
}

bool MakeView(
  vtkRenderer* renderer, const glm::ivec2& size, double aspect, View& view, std::string& error)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  const double* range = camera->GetClippingRange();
  const bool isMade = MakeView(MatrixFromVtk(camera->GetModelViewTransformMatrix()),
    MatrixFromVtk(camera->GetProjectionTransformMatrix(aspect, -1.0, 1.0)), { range[0], range[1] },
    size, view);
  if (!isMade)
  {
    const double* p = camera->GetPosition();
    const double* f = camera->GetFocalPoint();
    const double* u = camera->GetViewUp();
    std::ostringstream what;
    what << "The camera is degenerate: position (" << p[0] << ", " << p[1] << ", " << p[2]
         << "), focal point (" << f[0] << ", " << f[1] << ", " << f[2] << "), view up (" << u[0]
         << ", " << u[1] << ", " << u[2] << "), view angle " << camera->GetViewAngle()
         << ", parallel scale " << camera->GetParallelScale() << ", clipping range " << range[0]
         << " to " << range[1]
         << "; set a focal point away from the position, a view up across that direction, a view "
            "angle and a parallel scale above 0, and a clipping range whose far end is beyond its "
            "near "
            "end and, in a perspective, in front of the camera.";
    error = what.str();
  }
  return isMade;
}

}
