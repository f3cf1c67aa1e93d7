// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PicturePresenter.h"

#include <vtkNew.h>
#include <vtkOpenGLQuadHelper.h>
#include <vtkOpenGLRenderUtilities.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLShaderCache.h>
#include <vtkOpenGLState.h>
#include <vtkRenderer.h>
#include <vtkShaderProgram.h>
#include <vtkTextureObject.h>

namespace TemporalCoherence
{
namespace
{

// Enumerants of OpenGL 1.1, named here because the header that has them differs between versions
// of VTK.
constexpr unsigned int GlDepthTest = 0x0B71;
constexpr unsigned int GlBlend = 0x0BE2;
constexpr unsigned int GlViewport = 0x0BA2;
constexpr unsigned int GlLessOrEqual = 0x0203;
constexpr unsigned char GlTrue = 1;

std::string FragmentShader()
{
  std::string source = vtkOpenGLRenderUtilities::GetFullScreenQuadFragmentShaderTemplate();
  vtkShaderProgram::Substitute(source, "//VTK::FSQ::Decl",
    "uniform sampler2D colorTexture;\n"
    "uniform sampler2D depthTexture;\n");
  vtkShaderProgram::Substitute(source, "//VTK::FSQ::Impl",
    "vec4 color = texture(colorTexture, texCoord);\n"
    "if (color.a == 0.0) { discard; }\n"
    "gl_FragData[0] = color;\n"
    "gl_FragDepth = texture(depthTexture, texCoord).r;\n");
  return source;
}

/// Let the quad cover only a part of a picture that fills the viewport.
void ShrinkViewport(vtkOpenGLState* state, const glm::ivec2& size, const PixelRect& part)
{
  int viewport[4];
  state->vtkglGetIntegerv(GlViewport, viewport);
  const glm::ivec2 whole(viewport[2], viewport[3]);
  const glm::ivec2 first = part.First * whole / size;
  const glm::ivec2 end = (part.First + part.Size) * whole / size;
  state->vtkglViewport(
    viewport[0] + first.x, viewport[1] + first.y, end.x - first.x, end.y - first.y);
}

}

struct PicturePresenter::Resources
{
  vtkOpenGLRenderWindow* Window = nullptr;
  std::unique_ptr<vtkOpenGLQuadHelper> Quad;
  vtkNew<vtkTextureObject> Color;
  vtkNew<vtkTextureObject> Depth;
  std::uint64_t Picture = 0; ///< the one in the textures
  glm::ivec2 Size{ 0 };      ///< of the whole picture
  PixelRect Rect;            ///< the part of it in the textures
};

PicturePresenter::PicturePresenter() = default;
PicturePresenter::~PicturePresenter() = default;

bool PicturePresenter::Present(vtkRenderer* renderer, const Frame& frame, const View& view,
  std::uint64_t picture, std::string& error)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetVTKWindow());
  if (!window)
  {
    error = "The renderer has no OpenGL render window; add it to one, or use RenderToImage, which "
            "needs none.";
    return false;
  }
  if (this->OpenGL && this->OpenGL->Window != window)
  {
    this->ReleaseGraphicsResources(this->OpenGL->Window);
  }
  if (!this->OpenGL)
  {
    this->OpenGL = std::make_unique<Resources>();
    this->OpenGL->Window = window;
    for (vtkTextureObject* texture : { this->OpenGL->Color.Get(), this->OpenGL->Depth.Get() })
    {
      texture->SetContext(window);
      texture->SetMinificationFilter(vtkTextureObject::Nearest);
      texture->SetMagnificationFilter(vtkTextureObject::Nearest);
    }
    this->OpenGL->Quad = std::make_unique<vtkOpenGLQuadHelper>(window,
      vtkOpenGLRenderUtilities::GetFullScreenQuadVertexShader().c_str(), FragmentShader().c_str(),
      "");
  }
  else
  {
    window->GetShaderCache()->ReadyShaderProgram(this->OpenGL->Quad->Program);
  }
  vtkShaderProgram* program = this->OpenGL->Quad->Program;
  if (!program || !program->GetCompiled())
  {
    error = "The shader that shows the picture does not compile on this OpenGL.";
    return false;
  }

  vtkTextureObject* color = this->OpenGL->Color;
  vtkTextureObject* depth = this->OpenGL->Depth;
  if (this->OpenGL->Picture != picture)
  {
    this->Shown.Assign(frame, view);
    this->OpenGL->Picture = picture;
    this->OpenGL->Size = frame.Size;
    this->OpenGL->Rect = this->Shown.Rect;
    if (!this->Shown.Colors.empty())
    {
      const auto width = static_cast<unsigned int>(this->Shown.Rect.Size.x);
      const auto height = static_cast<unsigned int>(this->Shown.Rect.Size.y);
      color->Create2DFromRaw(width, height, 4, VTK_UNSIGNED_CHAR, this->Shown.Colors.data());
      depth->Create2DFromRaw(width, height, 1, VTK_FLOAT, this->Shown.Depths.data());
    }
  }
  if (this->OpenGL->Rect.Size.x == 0)
  {
    return true;
  }

  vtkOpenGLState* state = window->GetState();
  vtkOpenGLState::ScopedglEnableDisable keepDepthTest(state, GlDepthTest);
  vtkOpenGLState::ScopedglEnableDisable keepBlend(state, GlBlend);
  vtkOpenGLState::ScopedglDepthFunc keepDepthFunction(state);
  vtkOpenGLState::ScopedglDepthMask keepDepthMask(state);
  vtkOpenGLState::ScopedglViewport keepViewport(state);
  ShrinkViewport(state, this->OpenGL->Size, this->OpenGL->Rect);
  state->vtkglEnable(GlDepthTest);
  state->vtkglDepthFunc(GlLessOrEqual);
  state->vtkglDepthMask(GlTrue);
  state->vtkglDisable(GlBlend);

  color->Activate();
  depth->Activate();
  program->SetUniformi("colorTexture", color->GetTextureUnit());
  program->SetUniformi("depthTexture", depth->GetTextureUnit());
  this->OpenGL->Quad->Render();
  depth->Deactivate();
  color->Deactivate();
  return true;
}

void PicturePresenter::ReleaseGraphicsResources(vtkWindow* window)
{
  if (this->OpenGL)
  {
    this->OpenGL->Color->ReleaseGraphicsResources(window);
    this->OpenGL->Depth->ReleaseGraphicsResources(window);
    this->OpenGL.reset();
  }
}

}
