// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Window/PicturePresenter.h"

#include "Window/DepthReader.h"
#include "Window/LayerDepthClip.h"
#include "Window/OpenGLWindow.h"
#include "Window/PixelHit.h"

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

/// The position in the window of a part of a picture that fills the viewport.
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
  vtkOpenGLQuadHelper* Quad = nullptr;                                         ///< the present one
  vtkNew<vtkTextureObject> Color;
  vtkNew<vtkTextureObject> Depth;
  vtkNew<vtkTextureObject> Clipped; ///< colours clipped by the window's depths
  vtkNew<vtkTextureObject> Normal;  ///< in the world, for passes that ask for it
  std::uint64_t PictureNumber = 0;  ///< of the picture in the textures
  std::uint64_t NormalsPicture = 0; ///< of the picture in the texture of normals
  glm::ivec2 Pixels{ 0 };           ///< of the viewport that the picture was made for
  glm::ivec2 Size{ 0 };             ///< of the whole picture
  PixelRect Rect;                   ///< the part of it in the textures
};

PicturePresenter::PicturePresenter() = default;
PicturePresenter::~PicturePresenter() = default;

bool PicturePresenter::Present(
  vtkRenderer* renderer, vtkVolume* volume, const ShownFrame& shown, std::string& error)
{
  const PassOutput output = volume ? OutputFor(volume) : PassOutput::Color;
  const Frame& frame = shown.Picture;
  if (!this->Prepare(renderer, shown, output, error))
  {
    return false;
  }
  const PixelRect& rect = this->OpenGL->Rect;
  if (rect.Size.x == 0)
  {
    return true;
  }
  const bool isClipped = this->Shown.HasLayers && this->ClipLayers(frame, shown.View);
  const glm::vec2 size(this->OpenGL->Size);
  SetUniforms(output, this->OpenGL->Quad->Program, renderer, volume, glm::vec2(rect.First) / size,
    glm::vec2(rect.Size) / size);
  if (output == PassOutput::Occluder)
  {
    this->UploadNormals(frame);
    this->OpenGL->Normal->Activate();
    this->OpenGL->Quad->Program->SetUniformi(
      "normalTexture", this->OpenGL->Normal->GetTextureUnit());
  }
  if (isClipped)
  {
    this->Draw(this->OpenGL->Clipped, { this->Shown.HasOpaque, true });
  }
  else
  {
    this->Draw(this->OpenGL->Color,
      { this->Shown.HasOpaque && shown.Part != PicturePart::Edges,
        this->Shown.HasTranslucent && shown.Part != PicturePart::Inside, shown.IsBlended,
        shown.ComparesDepths });
  }
  if (output == PassOutput::Occluder)
  {
    this->OpenGL->Normal->Deactivate();
  }
  return true;
}

bool PicturePresenter::PresentColors(vtkRenderer* renderer, const ShownFrame& shown,
  const std::function<PixelColor(const glm::ivec2&)>& colorOf, std::string& error)
{
  if (!this->Prepare(renderer, shown, PassOutput::Color, error))
  {
    return false;
  }
  const PixelRect& rect = this->OpenGL->Rect;
  if (rect.Size.x == 0)
  {
    return true;
  }
  const PixelRays rays(shown.Picture.Size, this->OpenGL->Size);
  std::vector<PixelColor> part(this->Shown.Colors.size());
  std::size_t to = 0;
  for (int y = 0; y < rect.Size.y; ++y)
  {
    for (int x = 0; x < rect.Size.x; ++x, ++to)
    {
      const auto ray = rays.Shown(shown.Picture, rect.First + glm::ivec2(x, y));
      if (ray && this->Shown.Colors[to][3] != 0)
      {
        part[to] = colorOf(*ray);
        part[to][3] = 255;
      }
    }
  }
  vtkNew<vtkTextureObject> texture;
  PrepareTexture(texture, this->OpenGL->Window);
  texture->Create2DFromRaw(static_cast<unsigned int>(rect.Size.x),
    static_cast<unsigned int>(rect.Size.y), 4, VTK_UNSIGNED_CHAR, part.data());
  this->Draw(texture, { true, false });
  return true;
}

/// Make the quad, and put the picture into its textures.
bool PicturePresenter::Prepare(
  vtkRenderer* renderer, const ShownFrame& shown, PassOutput output, std::string& error)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetVTKWindow());
  if (!window)
  {
    error = "The renderer has no OpenGL render window; add it to one, or use MakeImage, which "
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
    PrepareTexture(this->OpenGL->Clipped, window);
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

  if (this->OpenGL->PictureNumber != shown.Number || this->OpenGL->Pixels != shown.Pixels)
  {
    this->Shown.Assign(shown.Picture, shown.View, shown.Pixels);
    this->OpenGL->PictureNumber = shown.Number;
    this->OpenGL->Pixels = shown.Pixels;
    this->OpenGL->NormalsPicture = 0;
    this->OpenGL->Size = this->Shown.Size;
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

/// Put the picture's colours into the texture Clipped, without the layers that lie behind other
/// props in the window.
/// \return false if no layer is clipped, or if depths cannot be read
bool PicturePresenter::ClipLayers(const Frame& frame, const View& view)
{
  vtkOpenGLRenderWindow* window = this->OpenGL->Window;
  const PixelRect target = InWindow(window, this->OpenGL->Size, this->OpenGL->Rect);
  if (target.Size.x <= 0 || target.Size.y <= 0)
  {
    return false;
  }
  const bool isRead = ReadDepths(window, target, this->Depths);
  // Reading depths may bind another shader program.
  window->GetShaderCache()->ReadyShaderProgram(this->OpenGL->Quad->Program);
  if (!isRead || !this->ClipColorsAt(target.Size, frame, view))
  {
    return false;
  }
  this->OpenGL->Clipped->Create2DFromRaw(static_cast<unsigned int>(target.Size.x),
    static_cast<unsigned int>(target.Size.y), 4, VTK_UNSIGNED_CHAR, this->ClippedColors.data());
  return true;
}

/// Clip layers by the depths that were read.
/// \param size window pixels that the picture covers
/// \return false if no colour changes
bool PicturePresenter::ClipColorsAt(const glm::ivec2& size, const Frame& frame, const View& view)
{
  const PixelRays rays(frame.Size, this->Shown.Size);
  if (!rays.AreMore())
  {
    return ClipLayersAt(this->Depths, size, this->Shown.Rect, frame, view, this->ClippedColors);
  }
  if (size != this->Shown.Rect.Size)
  {
    return false;
  }
  // The layers of a ray are clipped by the depth of the pixel that holds its centre.
  const PixelRect &hits = this->Shown.Hits, &rect = this->Shown.Rect;
  const PixelRays pixels(this->Shown.Size, frame.Size);
  std::vector<float> depths;
  depths.reserve(static_cast<std::size_t>(hits.Size.x) * static_cast<std::size_t>(hits.Size.y));
  for (int y = hits.First.y; y < hits.First.y + hits.Size.y; ++y)
  {
    for (int x = hits.First.x; x < hits.First.x + hits.Size.x; ++x)
    {
      const glm::ivec2 at = pixels.AtCentre({ x, y }) - rect.First;
      depths.push_back(this->Depths[static_cast<std::size_t>(at.y * rect.Size.x + at.x)]);
    }
  }
  std::vector<PixelColor> colors;
  if (!ClipLayersAt(depths, hits.Size, hits, frame, view, colors))
  {
    return false;
  }
  this->ClippedColors = this->Shown.MeanColors(frame, colors);
  return true;
}

void PicturePresenter::UploadNormals(const Frame& frame)
{
  if (this->OpenGL->NormalsPicture == this->OpenGL->PictureNumber)
  {
    return;
  }
  const PixelRect& rect = this->OpenGL->Rect;
  const PixelRays rays(frame.Size, this->OpenGL->Size);
  std::vector<glm::vec3> normals;
  normals.reserve(this->Shown.Colors.size());
  for (int y = rect.First.y; y < rect.First.y + rect.Size.y; ++y)
  {
    for (int x = rect.First.x; x < rect.First.x + rect.Size.x; ++x)
    {
      const auto ray = rays.Shown(frame, { x, y });
      normals.push_back(ray ? frame.Normals[IndexOfPixel(frame, ray->x, ray->y)] : glm::vec3(0.0f));
    }
  }
  this->OpenGL->Normal->Create2DFromRaw(static_cast<unsigned int>(rect.Size.x),
    static_cast<unsigned int>(rect.Size.y), 3, VTK_FLOAT, normals.data());
  this->OpenGL->NormalsPicture = this->OpenGL->PictureNumber;
}

/// Draw hits in the colours of a texture.
void PicturePresenter::Draw(vtkTextureObject* color, const Parts& parts)
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
  if (!parts.ComparesDepths)
  {
    state->vtkglDisable(Gl::DepthTest);
  }

  vtkShaderProgram* program = this->OpenGL->Quad->Program;
  vtkTextureObject* depth = this->OpenGL->Depth;
  color->Activate();
  depth->Activate();
  program->SetUniformi("colorTexture", color->GetTextureUnit());
  program->SetUniformi("depthTexture", depth->GetTextureUnit());
  if (parts.Opaque && !parts.AreBlended)
  {
    state->vtkglDepthMask(Gl::True);
    state->vtkglDisable(Gl::Blend);
    program->SetUniformi("isOpaquePart", 1);
    this->OpenGL->Quad->Render();
  }
  if (parts.Translucent || parts.AreBlended)
  {
    state->vtkglDepthMask(Gl::False);
    state->vtkglEnable(Gl::Blend);
    state->vtkglBlendFuncSeparate(
      Gl::One, Gl::OneMinusSourceAlpha, Gl::One, Gl::OneMinusSourceAlpha);
    if (parts.Opaque && parts.AreBlended)
    {
      program->SetUniformi("isOpaquePart", 1);
      this->OpenGL->Quad->Render();
    }
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
