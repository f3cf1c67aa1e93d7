// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PicturePresenter.h"

#include "Parallel.h"

#include <vtkNew.h>
#include <vtkOpenGLQuadHelper.h>
#include <vtkOpenGLRenderUtilities.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLShaderCache.h>
#include <vtkOpenGLState.h>
#include <vtkRenderer.h>
#include <vtkShaderProgram.h>
#include <vtkTextureObject.h>

#include <algorithm>

namespace TemporalCoherence
{
namespace
{

// Enumerants of OpenGL 1.1, named here because the header that has them differs between versions
// of VTK.
constexpr unsigned int GlDepthTest = 0x0B71;
constexpr unsigned int GlBlend = 0x0BE2;
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

/// What the depth buffer holds for each hit of a frame: 0 at the near plane, 1 at the far plane.
void FindWindowDepths(const Frame& frame, const View& view, std::vector<float>& depths)
{
  depths.resize(frame.Depth.size());
  ParallelFor(frame.Size.y, 8,
    [&](std::int64_t row)
    {
      const int y = static_cast<int>(row);
      for (int x = 0; x < frame.Size.x; ++x)
      {
        const std::size_t pixel =
          static_cast<std::size_t>(row) * static_cast<std::size_t>(frame.Size.x) +
          static_cast<std::size_t>(x);
        if (frame.Isovalues[pixel] == Frame::NoSurface)
        {
          depths[pixel] = 1.0f;
          continue;
        }
        const Ray ray = view.RayThrough(x, y);
        const glm::dvec3 world = ray.Origin + frame.Depth[pixel] * ray.Direction;
        const glm::dvec4 clip = view.ClipFromWorld * glm::dvec4(world, 1.0);
        depths[pixel] =
          static_cast<float>(std::min(std::max(0.5 * clip.z / clip.w + 0.5, 0.0), 1.0));
      }
    });
}

}

struct PicturePresenter::Resources
{
  vtkOpenGLRenderWindow* Window = nullptr;
  std::unique_ptr<vtkOpenGLQuadHelper> Quad;
  vtkNew<vtkTextureObject> Color;
  vtkNew<vtkTextureObject> Depth;
  std::uint64_t Picture = 0; ///< the one in the textures
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
    FindWindowDepths(frame, view, this->WindowDepth);
    const auto width = static_cast<unsigned int>(frame.Size.x);
    const auto height = static_cast<unsigned int>(frame.Size.y);
    // VTK copies from the pointers, which it takes as not const.
    color->Create2DFromRaw(
      width, height, 4, VTK_UNSIGNED_CHAR, const_cast<std::uint8_t*>(frame.Colors.data()->data()));
    depth->Create2DFromRaw(width, height, 1, VTK_FLOAT, this->WindowDepth.data());
    this->OpenGL->Picture = picture;
  }

  vtkOpenGLState* state = window->GetState();
  vtkOpenGLState::ScopedglEnableDisable keepDepthTest(state, GlDepthTest);
  vtkOpenGLState::ScopedglEnableDisable keepBlend(state, GlBlend);
  vtkOpenGLState::ScopedglDepthFunc keepDepthFunction(state);
  vtkOpenGLState::ScopedglDepthMask keepDepthMask(state);
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
