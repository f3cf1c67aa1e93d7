// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Window/OpenGLWindow.h"

#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkTextureObject.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>

namespace TemporalCoherence
{

PixelRect ViewportOf(vtkOpenGLRenderWindow* window)
{
  glm::ivec4 viewport(0);
  window->GetState()->vtkglGetIntegerv(Gl::Viewport, &viewport.x);
  return { { viewport.x, viewport.y }, { viewport.z, viewport.w } };
}

bool IsSoftwareRenderer(const std::string& name)
{
  std::string lower = name;
  std::transform(lower.begin(), lower.end(), lower.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  // Renderers of Mesa, Google and Apple, and of Windows without a driver.
  constexpr std::array<const char*, 8> words = { "llvmpipe", "softpipe", "swrast", "swr",
    "swiftshader", "software", "gdi generic", "basic render" };
  return std::any_of(words.begin(), words.end(),
    [&](const char* word) { return lower.find(word) != std::string::npos; });
}

bool HasSoftwareOpenGL(vtkRenderWindow* window)
{
  // The report is a text for users. One line of it names the renderer.
  const std::string label = "OpenGL renderer string:";
  const char* const report = window->ReportCapabilities();
  const std::string text = report ? report : "";
  const std::size_t begin = text.find(label);
  if (begin == std::string::npos)
  {
    return false;
  }
  const std::size_t end = std::min(text.find('\n', begin), text.size());
  return IsSoftwareRenderer(text.substr(begin + label.size(), end - begin - label.size()));
}

void PrepareTexture(vtkTextureObject* texture, vtkOpenGLRenderWindow* window)
{
  texture->SetContext(window);
  texture->SetMinificationFilter(vtkTextureObject::Nearest);
  texture->SetMagnificationFilter(vtkTextureObject::Nearest);
}

}
