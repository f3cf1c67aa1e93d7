// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Window/OpenGLWindow.h"

#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkTextureObject.h>

namespace TemporalCoherence
{

PixelRect ViewportOf(vtkOpenGLRenderWindow* window)
{
  glm::ivec4 viewport(0);
  window->GetState()->vtkglGetIntegerv(Gl::Viewport, &viewport.x);
  return { { viewport.x, viewport.y }, { viewport.z, viewport.w } };
}

void PrepareTexture(vtkTextureObject* texture, vtkOpenGLRenderWindow* window)
{
  texture->SetContext(window);
  texture->SetMinificationFilter(vtkTextureObject::Nearest);
  texture->SetMagnificationFilter(vtkTextureObject::Nearest);
}

}
