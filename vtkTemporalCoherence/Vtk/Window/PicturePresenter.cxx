// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Window/PicturePresenter.h"

#include "Window/DepthReader.h"
#include "Window/LayerCut.h"
#include "Window/OpenGLWindow.h"

#include <vtkNew.h>
#include <vtkOpenGLQuadHelper.h>
#include <vtkOpenGLRenderUtilities.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLShaderCache.h>
#include <vtkOpenGLState.h>
#include <vtkRenderer.h>
#include <vtkShaderProgram.h>
#include <vtkTextureObject.h>
#include <vtkWeakPointer.h>

#include <array>

namespace TemporalCoherence
{
namespace
{

std::string FragmentShader(PassOutput output)
{
  std::string source = vtkOpenGLRenderUtilities::GetFullScreenQuadFragmentShaderTemplate();
  vtkShaderProgram::Substitute(source, "//VTK::FSQ::Decl",
    "uniform sampler2D colorTexture;\n"
    "uniform sampler2D depthTexture;\n"
    "uniform int isOpaquePart;\n" +
      DeclarationsOf(output));
  vtkShaderProgram::Substitute(source, "//VTK::FSQ::Impl",
    "vec4 color = texture(colorTexture, texCoord);\n"
    "if (color.a == 0.0 || (color.a == 1.0) != (isOpaquePart != 0)) { discard; }\n"
    "float depth = texture(depthTexture, texCoord).r;\n"
    "gl_FragDepth = depth;\n" +
      StatementsOf(output));
  return source;
}

/// Where in the window a part is of a picture that fills the viewport.
PixelRect InWindow(vtkOpenGLRenderWindow* window, const glm::ivec2& size, const PixelRect& part)
{
  const PixelRect viewport = ViewportOf(window);
  const glm::ivec2 first = part.First * viewport.Size / size;
  const glm::ivec2 end = (part.First + part.Size) * viewport.Size / size;
  return { viewport.First + first, end - first };
}

}

struct PicturePresenter::Resources
{
  vtkWeakPointer<vtkOpenGLRenderWindow> Window;
  std::array<std::unique_ptr<vtkOpenGLQuadHelper>, NumberOfPassOutputs> Quads; ///< or null
  vtkOpenGLQuadHelper* Quad = nullptr; ///< the one that draws now
  vtkNew<vtkTextureObject> Color;
  vtkNew<vtkTextureObject> Depth;
  vtkNew<vtkTextureObject> Cut;     ///< colours where other things lie among the layers
  vtkNew<vtkTextureObject> Normal;  ///< in the world, for passes that ask for it
  std::uint64_t Picture = 0;        ///< the one in the textures
  std::uint64_t NormalsPicture = 0; ///< the one in the texture of normals
  glm::ivec2 Size{ 0 };             ///< of the whole picture
  PixelRect Rect;                   ///< the part of it in the textures
};

PicturePresenter::PicturePresenter() = default;
PicturePresenter::~PicturePresenter() = default;

bool PicturePresenter::Present(vtkRenderer* renderer, vtkVolume* volume, const Frame& frame,
  const View& view, std::uint64_t picture, std::string& error)
{
  const PassOutput output = volume ? OutputFor(volume) : PassOutput::Color;
  if (!this->Prepare(renderer, frame, view, picture, output, error))
  {
    return false;
  }
  const PixelRect& rect = this->OpenGL->Rect;
  if (rect.Size.x == 0)
  {
    return true;
  }
  const bool isCut = this->Shown.HasLayers && this->CutLayers(frame, view);
  const glm::vec2 size(frame.Size);
  SetUniforms(output, this->OpenGL->Quad->Program, renderer, volume, glm::vec2(rect.First) / size,
    glm::vec2(rect.Size) / size);
  if (output == PassOutput::Occluder)
  {
    this->UploadNormals(frame);
    this->OpenGL->Normal->Activate();
    this->OpenGL->Quad->Program->SetUniformi(
      "normalTexture", this->OpenGL->Normal->GetTextureUnit());
  }
  if (isCut)
  {
    this->Draw(this->OpenGL->Cut, this->Shown.HasOpaque, true);
  }
  else
  {
    this->Draw(this->OpenGL->Color, this->Shown.HasOpaque, this->Shown.HasTranslucent);
  }
  if (output == PassOutput::Occluder)
  {
    this->OpenGL->Normal->Deactivate();
  }
  return true;
}

bool PicturePresenter::PresentColors(vtkRenderer* renderer, const Frame& frame, const View& view,
  std::uint64_t picture, const std::vector<PixelColor>& colors, std::string& error)
{
  if (!this->Prepare(renderer, frame, view, picture, PassOutput::Color, error))
  {
    return false;
  }
  const PixelRect& rect = this->OpenGL->Rect;
  if (rect.Size.x == 0)
  {
    return true;
  }
  std::vector<PixelColor> part(this->Shown.Colors.size());
  for (int y = 0; y < rect.Size.y; ++y)
  {
    for (int x = 0; x < rect.Size.x; ++x)
    {
      const auto to = static_cast<std::size_t>(y) * static_cast<std::size_t>(rect.Size.x) +
        static_cast<std::size_t>(x);
      const auto from =
        static_cast<std::size_t>(rect.First.y + y) * static_cast<std::size_t>(frame.Size.x) +
        static_cast<std::size_t>(rect.First.x + x);
      if (this->Shown.Colors[to][3] != 0)
      {
        part[to] = colors[from];
        part[to][3] = 255;
      }
    }
  }
  vtkNew<vtkTextureObject> texture;
  PrepareTexture(texture, this->OpenGL->Window);
  texture->Create2DFromRaw(static_cast<unsigned int>(rect.Size.x),
    static_cast<unsigned int>(rect.Size.y), 4, VTK_UNSIGNED_CHAR, part.data());
  this->Draw(texture, true, false);
  return true;
}

/// Make the quad, and put the picture into its textures.
bool PicturePresenter::Prepare(vtkRenderer* renderer, const Frame& frame, const View& view,
  std::uint64_t picture, PassOutput output, std::string& error)
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
    this->OpenGL.reset();
  }
  if (!this->OpenGL)
  {
    this->OpenGL = std::make_unique<Resources>();
    this->OpenGL->Window = window;
    PrepareTexture(this->OpenGL->Color, window);
    PrepareTexture(this->OpenGL->Depth, window);
    PrepareTexture(this->OpenGL->Cut, window);
    PrepareTexture(this->OpenGL->Normal, window);
  }
  auto& quad = this->OpenGL->Quads[static_cast<std::size_t>(output)];
  if (quad)
  {
    window->GetShaderCache()->ReadyShaderProgram(quad->Program);
  }
  else
  {
    quad = std::make_unique<vtkOpenGLQuadHelper>(window,
      vtkOpenGLRenderUtilities::GetFullScreenQuadVertexShader().c_str(),
      FragmentShader(output).c_str(), "");
  }
  this->OpenGL->Quad = quad.get();
  if (!this->OpenGL->Quad->Program || !this->OpenGL->Quad->Program->GetCompiled())
  {
    error = "The shader that shows the picture does not compile on this OpenGL.";
    return false;
  }

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
      this->OpenGL->Color->Create2DFromRaw(
        width, height, 4, VTK_UNSIGNED_CHAR, this->Shown.Colors.data());
      this->OpenGL->Depth->Create2DFromRaw(width, height, 1, VTK_FLOAT, this->Shown.Depths.data());
    }
  }
  return true;
}

/// Put the picture's colours into the texture Cut, without those layers that lie behind what is in
/// the window.
/// \return false if there is no need to, or no way
bool PicturePresenter::CutLayers(const Frame& frame, const View& view)
{
  vtkOpenGLRenderWindow* window = this->OpenGL->Window;
  const PixelRect target = InWindow(window, this->OpenGL->Size, this->OpenGL->Rect);
  if (target.Size.x <= 0 || target.Size.y <= 0)
  {
    return false;
  }
  const bool isRead = ReadDepths(window, target, this->Depths);
  // Some windows take a program of their own to read depths.
  window->GetShaderCache()->ReadyShaderProgram(this->OpenGL->Quad->Program);
  if (!isRead ||
    !CutLayersAt(this->Depths, target.Size, this->Shown.Rect, frame, view, this->CutColors))
  {
    return false;
  }
  this->OpenGL->Cut->Create2DFromRaw(static_cast<unsigned int>(target.Size.x),
    static_cast<unsigned int>(target.Size.y), 4, VTK_UNSIGNED_CHAR, this->CutColors.data());
  return true;
}

void PicturePresenter::UploadNormals(const Frame& frame)
{
  if (this->OpenGL->NormalsPicture == this->OpenGL->Picture)
  {
    return;
  }
  const PixelRect& rect = this->OpenGL->Rect;
  std::vector<glm::vec3> normals;
  normals.reserve(this->Shown.Colors.size());
  for (int y = rect.First.y; y < rect.First.y + rect.Size.y; ++y)
  {
    const auto row = frame.Normals.begin() + static_cast<std::ptrdiff_t>(y) * frame.Size.x;
    normals.insert(normals.end(), row + rect.First.x, row + rect.First.x + rect.Size.x);
  }
  this->OpenGL->Normal->Create2DFromRaw(static_cast<unsigned int>(rect.Size.x),
    static_cast<unsigned int>(rect.Size.y), 3, VTK_FLOAT, normals.data());
  this->OpenGL->NormalsPicture = this->OpenGL->Picture;
}

/// Draw the hits, opaque ones, translucent ones or both, in the colours of a texture.
void PicturePresenter::Draw(vtkTextureObject* color, bool isOpaque, bool isTranslucent)
{
  vtkOpenGLState* state = this->OpenGL->Window->GetState();
  vtkOpenGLState::ScopedglEnableDisable keepDepthTest(state, Gl::DepthTest);
  vtkOpenGLState::ScopedglEnableDisable keepBlend(state, Gl::Blend);
  vtkOpenGLState::ScopedglBlendFuncSeparate keepBlendFunction(state);
  vtkOpenGLState::ScopedglDepthFunc keepDepthFunction(state);
  vtkOpenGLState::ScopedglDepthMask keepDepthMask(state);
  vtkOpenGLState::ScopedglViewport keepViewport(state);
  const PixelRect target = InWindow(this->OpenGL->Window, this->OpenGL->Size, this->OpenGL->Rect);
  state->vtkglViewport(target.First.x, target.First.y, target.Size.x, target.Size.y);
  state->vtkglEnable(Gl::DepthTest);
  state->vtkglDepthFunc(Gl::LessOrEqual);

  vtkShaderProgram* program = this->OpenGL->Quad->Program;
  vtkTextureObject* depth = this->OpenGL->Depth;
  color->Activate();
  depth->Activate();
  program->SetUniformi("colorTexture", color->GetTextureUnit());
  program->SetUniformi("depthTexture", depth->GetTextureUnit());
  if (isOpaque)
  {
    state->vtkglDepthMask(Gl::True);
    state->vtkglDisable(Gl::Blend);
    program->SetUniformi("isOpaquePart", 1);
    this->OpenGL->Quad->Render();
  }
  if (isTranslucent)
  {
    state->vtkglDepthMask(Gl::False);
    state->vtkglEnable(Gl::Blend);
    state->vtkglBlendFuncSeparate(
      Gl::One, Gl::OneMinusSourceAlpha, Gl::One, Gl::OneMinusSourceAlpha);
    program->SetUniformi("isOpaquePart", 0);
    this->OpenGL->Quad->Render();
  }
  depth->Deactivate();
  color->Deactivate();
}

void PicturePresenter::ReleaseGraphicsResources(vtkWindow* window)
{
  if (this->OpenGL && (!window || this->OpenGL->Window == window))
  {
    this->OpenGL.reset();
  }
}

}
