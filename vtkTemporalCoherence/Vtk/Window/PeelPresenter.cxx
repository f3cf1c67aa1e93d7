// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Window/PeelPresenter.h"

#include "Window/OpenGLWindow.h"
#include "Window/PeeledPicture.h"

#include <vtkNew.h>
#include <vtkOpenGLQuadHelper.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLShaderCache.h>
#include <vtkOpenGLState.h>
#include <vtkRenderer.h>
#include <vtkShaderProgram.h>
#include <vtkTextureObject.h>
#include <vtkWeakPointer.h>

#include <cstdint>
#include <map>
#include <vector>

namespace TemporalCoherence
{
namespace
{

/// Layers in a row of a texture.
constexpr std::size_t RowOfLayers = 4096;

constexpr const char* Declarations = "uniform sampler2D layersTexture;\n"
                                     "uniform sampler2D depthTexture;\n"
                                     "uniform sampler2D colorTexture;\n"
                                     "vec3 layers;\n";

/// The layers of a pixel: column and row of the first one in the textures, and their number.
constexpr const char* Color = "  vec4 seen = vec4(0.0);\n"
                              "  for (int i = 0; i < int(layers.z); ++i)\n"
                              "  {\n"
                              "    int at = int(layers.x) + i;\n"
                              "    ivec2 place = ivec2(at % row, int(layers.y) + at / row);\n"
                              "    float depth = texelFetch(depthTexture, place, 0).r;\n"
                              "    if (depth >= zEnd) { break; }\n"
                              "    if (depth >= zStart)\n"
                              "    {\n"
                              "      seen += (1.0 - seen.a) * texelFetch(colorTexture, place, 0);\n"
                              "    }\n"
                              "  }\n"
                              "  return seen;\n";

/// Pixels without a surface keep the colours of other volumes.
constexpr const char* Begin = "  layers = texture2D(layersTexture, texCoord).xyz;\n"
                              "  if (layers.z == 0.0) { discard; }\n";

std::string ShaderOf(const PeelingPass& pass)
{
  std::string source = pass.FragmentShader();
  vtkShaderProgram::Substitute(source, "//PeeledDeclarations",
    Declarations + ("const int row = " + std::to_string(RowOfLayers) + ";\n"));
  vtkShaderProgram::Substitute(source, "//PeeledColor", Color);
  vtkShaderProgram::Substitute(source, "void main()\n{\n", std::string("void main()\n{\n") + Begin);
  return source;
}

}

struct PeelPresenter::Resources
{
  vtkWeakPointer<vtkOpenGLRenderWindow> Window;
  std::map<std::string, std::unique_ptr<vtkOpenGLQuadHelper>> Quads; ///< by shader
  vtkNew<vtkTextureObject> Layers;         ///< position and number of each pixel's layers
  vtkNew<vtkTextureObject> Depths, Colors; ///< of the layers
  std::vector<std::uint64_t> Held; ///< PeeledPicture::Numbers() of the layers in the textures
  bool HasLayers = false;
  std::shared_ptr<const PeeledLayers> Own; ///< layers of the volume's last picture
  std::uint64_t OwnNumber = 0;             ///< of that picture

  void TakeLayers(const ShownFrame& shown);

  /// \return false if there are more layers than textures can hold
  bool Upload(const PeeledLayers& layers);
};

/// Find the layers of a picture unless they are known.
void PeelPresenter::Resources::TakeLayers(const ShownFrame& shown)
{
  if (!this->Own || this->OwnNumber != shown.Number)
  {
    this->Own.reset();
    this->Own = std::make_shared<const PeeledLayers>(
      PeeledLayers::Of(shown.Picture, shown.View, shown.IsBlended));
    this->OwnNumber = shown.Number;
  }
}

bool PeelPresenter::Resources::Upload(const PeeledLayers& layers)
{
  this->Held.clear();
  this->HasLayers = false;
  if (layers.All().empty())
  {
    return true;
  }
  const std::size_t rows = (layers.All().size() + RowOfLayers - 1) / RowOfLayers;
  int most = 0;
  this->Window->GetState()->vtkglGetIntegerv(Gl::MaxTextureSize, &most);
  if (rows > static_cast<std::size_t>(most))
  {
    return false;
  }
  std::vector<float> places, depths(rows * RowOfLayers);
  std::vector<PeeledLayers::FineColor> colors(rows * RowOfLayers);
  const std::vector<std::size_t>& begins = layers.Begins();
  places.reserve(3 * begins.size());
  for (std::size_t pixel = 0; pixel + 1 < begins.size(); ++pixel)
  {
    places.push_back(static_cast<float>(begins[pixel] % RowOfLayers));
    places.push_back(static_cast<float>(begins[pixel] / RowOfLayers));
    places.push_back(static_cast<float>(begins[pixel + 1] - begins[pixel]));
  }
  for (std::size_t i = 0; i < layers.All().size(); ++i)
  {
    depths[i] = layers.All()[i].Depth;
    colors[i] = layers.All()[i].Color;
  }
  const glm::uvec2 size(layers.Size());
  const auto width = static_cast<unsigned int>(RowOfLayers),
             height = static_cast<unsigned int>(rows);
  this->Layers->Create2DFromRaw(size.x, size.y, 3, VTK_FLOAT, places.data());
  this->Depths->Create2DFromRaw(width, height, 1, VTK_FLOAT, depths.data());
  this->Colors->Create2DFromRaw(width, height, 4, VTK_UNSIGNED_SHORT, colors.data());
  this->HasLayers = true;
  return true;
}

PeelPresenter::PeelPresenter() = default;
PeelPresenter::~PeelPresenter() = default;

bool PeelPresenter::Present(const PeelingPass& pass, vtkRenderer* renderer, vtkVolume* volume,
  const ShownFrame& shown, std::string& error)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetVTKWindow());
  if (!window || !pass.IsKnown())
  {
    error = "Depth peeling of volumes by this version of VTK is not supported; use a "
            "vtkTemporalCoherenceVolume with opaque surfaces, or UseDepthPeelingForVolumesOff().";
    return false;
  }
  if (!this->OpenGL || this->OpenGL->Window != window)
  {
    this->OpenGL = std::make_unique<Resources>();
    this->OpenGL->Window = window;
    PrepareTexture(this->OpenGL->Layers, window);
    PrepareTexture(this->OpenGL->Depths, window);
    PrepareTexture(this->OpenGL->Colors, window);
  }
  const auto picture = PeeledPicture::Of(renderer);
  if (pass.IsFirst())
  {
    pass.RefineTargets();
    this->OpenGL->TakeLayers(shown);
    picture->Add(pass, this, ViewportOf(window).Size, shown.Number, this->OpenGL->Own);
    if (this->OpenGL->Held != picture->Numbers())
    {
      const PeeledLayers& layers = picture->Merged();
      if (!this->OpenGL->Upload(layers))
      {
        error = "The picture has " + std::to_string(layers.All().size()) +
          " layers of surfaces in total, more than the textures of this OpenGL can hold; make the "
          "window smaller, or use a vtkTemporalCoherenceVolume with opaque surfaces.";
        return false;
      }
      this->OpenGL->Held = picture->Numbers();
    }
  }
  else if (picture->IsDrawnBy(this))
  {
    picture->ReleaseLayers();
  }
  else
  {
    return true;
  }
  const bool isInPlaceOfOthers = pass.IsFirst() && picture->NumberOfVolumes() > 1;
  return !this->OpenGL->HasLayers || this->Draw(pass, volume, isInPlaceOfOthers, error);
}

/// \param isInPlaceOfOthers overwrite the colours of earlier volumes
bool PeelPresenter::Draw(
  const PeelingPass& pass, vtkVolume* volume, bool isInPlaceOfOthers, std::string& error)
{
  vtkOpenGLRenderWindow* window = this->OpenGL->Window;
  const std::string source = ShaderOf(pass);
  auto& quad = this->OpenGL->Quads[source];
  if (!quad)
  {
    quad = std::make_unique<vtkOpenGLQuadHelper>(window, nullptr, source.c_str(), "");
  }
  vtkShaderProgram* program = quad->Program;
  if (!program || !program->GetCompiled())
  {
    error = "The shader that shows surfaces between translucent polygons does not compile on this "
            "OpenGL; use a vtkTemporalCoherenceVolume with opaque surfaces.";
    return false;
  }
  window->GetShaderCache()->ReadyShaderProgram(program);

  vtkOpenGLState* state = window->GetState();
  vtkOpenGLState::ScopedglEnableDisable keepDepthTest(state, Gl::DepthTest);
  vtkOpenGLState::ScopedglEnableDisable keepBlend(state, Gl::Blend);
  vtkOpenGLState::ScopedglEnableDisable keepCullFace(state, Gl::CullFace);
  state->vtkglDisable(Gl::DepthTest);
  state->vtkglDisable(Gl::CullFace);
  if (isInPlaceOfOthers)
  {
    state->vtkglDisable(Gl::Blend);
  }
  const glm::ivec2 size = ViewportOf(window).Size;
  pass.SetUniforms(program, volume, size.x, size.y);
  const auto bind = [&](const char* name, vtkTextureObject* texture)
  {
    texture->Activate();
    program->SetUniformi(name, texture->GetTextureUnit());
  };
  bind("layersTexture", this->OpenGL->Layers);
  bind("depthTexture", this->OpenGL->Depths);
  bind("colorTexture", this->OpenGL->Colors);
  quad->Render();
  this->OpenGL->Colors->Deactivate();
  this->OpenGL->Depths->Deactivate();
  this->OpenGL->Layers->Deactivate();
  return true;
}

void PeelPresenter::ReleaseGraphicsResources(vtkWindow* window)
{
  if (this->OpenGL && (!window || this->OpenGL->Window == window))
  {
    this->OpenGL.reset();
  }
}

}
