// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Window/DepthReader.h"

#include "Window/OpenGLWindow.h"

#include <vtkNew.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkPixelBufferObject.h>

#include <array>

namespace TemporalCoherence
{
namespace
{

/// Read the framebuffer of a render pass.
bool ReadFramebuffer(vtkOpenGLRenderWindow* window, unsigned int framebuffer, const PixelRect& rect,
  std::vector<float>& depths)
{
  vtkOpenGLState* state = window->GetState();
  int samples = 0;
  state->vtkglGetIntegerv(Gl::Samples, &samples);
  if (samples > 1)
  {
    return false; // a copy with one sample needs its format, which is not known
  }
  vtkNew<vtkPixelBufferObject> buffer;
  buffer->SetContext(window);
  const glm::ivec2 last = rect.First + rect.Size - 1;
  std::array<int, 4> extent{ rect.First.x, last.x, rect.First.y, last.y };
  state->PushReadFramebufferBinding();
  state->vtkglBindFramebuffer(Gl::ReadFramebuffer, framebuffer);
  vtkOpenGLFramebufferObject::Download(extent.data(), VTK_FLOAT, 1, static_cast<int>(Gl::Float),
    static_cast<int>(Gl::DepthComponent), buffer);
  state->PopReadFramebufferBinding();
  std::array<unsigned int, 2> size{ static_cast<unsigned int>(rect.Size.x),
    static_cast<unsigned int>(rect.Size.y) };
  std::array<vtkIdType, 2> gaps{ 0, 0 };
  return buffer->Download2D(VTK_FLOAT, depths.data(), size.data(), 1, gaps.data());
}

}

bool ReadDepths(vtkOpenGLRenderWindow* window, const PixelRect& rect, std::vector<float>& depths)
{
  depths.resize(static_cast<std::size_t>(rect.Size.x) * static_cast<std::size_t>(rect.Size.y));
  unsigned int framebuffer = 0, buffer = 0;
  window->GetState()->GetCurrentDrawFramebufferState(framebuffer, buffer);
  if (framebuffer != window->GetRenderFramebuffer()->GetFBOIndex())
  {
    return ReadFramebuffer(window, framebuffer, rect, depths);
  }
  // The window can copy its own framebuffer if that is multisampled.
  vtkOpenGLState* state = window->GetState();
  vtkOpenGLState::ScopedglEnableDisable keepScissorTest(state, Gl::ScissorTest);
  vtkOpenGLState::ScopedglViewport keepViewport(state);
  vtkOpenGLState::ScopedglScissor keepScissor(state);
  const glm::ivec2 last = rect.First + rect.Size - 1;
  return window->GetZbufferData(rect.First.x, rect.First.y, last.x, last.y, depths.data()) ==
    VTK_OK;
}

}
