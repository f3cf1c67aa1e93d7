// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Window/PeelingPass.h"

#include "Window/FindPass.h"
#include "Window/OpenGLWindow.h"

#include <vtkDualDepthPeelingPass.h>
#include <vtkPixelBufferObject.h>
#include <vtkShaderProgram.h>
#include <vtkSmartPointer.h>
#include <vtkTextureObject.h>
#include <vtkVolume.h>
#include <vtkVolumeMapper.h>

#include <array>
#include <cstddef>
#include <vector>

namespace TemporalCoherence
{
namespace
{

/// The markers that the pass replaces in shaders of volumes, and the functions and variables it
/// uses.
constexpr const char* Work = "//VTK::CallWorker::Impl";
constexpr const char* Template = "//VTK::System::Dec\n"
                                 "//VTK::Output::Dec\n"
                                 "in vec2 texCoord;\n"
                                 "uniform vec2 in_inverseWindowSize;\n"
                                 "const float g_opacityThreshold = 1.0;\n"
                                 "//VTK::DepthPeeling::Dec\n"
                                 "//PeeledDeclarations\n"
                                 "void initializeRayCast() {}\n"
                                 "vec4 castRay(float zStart, float zEnd)\n"
                                 "{\n"
                                 "//PeeledColor\n"
                                 "}\n"
                                 "void main()\n"
                                 "{\n"
                                 "//VTK::CallWorker::Impl\n"
                                 "}\n";

/// Textures that only certain stages of the pass bind: they identify the stage.
constexpr const char* OfPeels = "lastFrontColorTex";
constexpr const char* OfRest = "depthRangeTex";

/// Accesses the textures of any pass, which are protected members.
struct Targets : vtkDualDepthPeelingPass
{
  static std::vector<vtkTextureObject*> Of(vtkDualDepthPeelingPass* pass)
  {
    auto& textures = pass->*(&Targets::Textures);
    return { textures[BackTemp], textures[Back], textures[FrontA], textures[FrontB] };
  }
  static vtkTextureObject* OpaqueDepthsOf(vtkDualDepthPeelingPass* pass)
  {
    return (pass->*(&Targets::Textures))[OpaqueDepth];
  }
};

/// Change a texture of bytes to 16 bits a channel, and keep its contents.
void Refine(vtkTextureObject* texture)
{
  constexpr int channels = 4;
  unsigned int size[2] = { texture->GetWidth(), texture->GetHeight() };
  std::vector<unsigned char> pixels(std::size_t(channels) * size[0] * size[1]);
  vtkIdType increments[2] = { 0, 0 };
  texture->Activate(); // or it would be bound in place of another one
  const auto buffer = vtkSmartPointer<vtkPixelBufferObject>::Take(texture->Download());
  buffer->Download2D(VTK_UNSIGNED_CHAR, pixels.data(), size, channels, increments);
  texture->SetInternalFormat(Gl::Rgba16);
  texture->Create2DFromRaw(size[0], size[1], channels, VTK_UNSIGNED_CHAR, pixels.data());
}

bool Has(const std::string& text, const char* word)
{
  return text.find(word) != std::string::npos;
}

}

std::optional<PeelingPass> PeelingPass::Of(vtkVolume* volume)
{
  PeelingPass found;
  found.Pass = FindPass<vtkDualDepthPeelingPass>(volume);
  if (!found.Pass)
  {
    return std::nullopt;
  }
  found.Source = Template;
  std::string vertexShader, geometryShader;
  found.Pass->PreReplaceShaderValues(
    vertexShader, geometryShader, found.Source, volume->GetMapper(), volume);
  return found;
}

bool PeelingPass::IsFirst() const
{
  return !Has(this->Source, OfPeels) && !Has(this->Source, OfRest);
}

bool PeelingPass::IsKnown() const
{
  return !Has(this->Source, Work);
}

void PeelingPass::SetUniforms(
  vtkShaderProgram* program, vtkVolume* volume, int width, int height) const
{
  const float inverse[2] = { 1.0f / static_cast<float>(width), 1.0f / static_cast<float>(height) };
  program->SetUniform2f("in_inverseWindowSize", inverse);
  this->Pass->SetShaderParameters(program, volume->GetMapper(), volume, nullptr);
}

void PeelingPass::RefineTargets() const
{
  for (vtkTextureObject* texture : Targets::Of(this->Pass))
  {
    if (texture && texture->GetInternalFormat(VTK_UNSIGNED_CHAR, 4, false) == Gl::Rgba8)
    {
      Refine(texture);
    }
  }
}

bool PeelingPass::ReadOpaqueDepths(const glm::ivec2& size, std::vector<float>& depths) const
{
  vtkTextureObject* texture = Targets::OpaqueDepthsOf(this->Pass);
  if (!texture || glm::ivec2(texture->GetWidth(), texture->GetHeight()) != size ||
    texture->GetVTKDataType() != VTK_FLOAT)
  {
    return false;
  }
  depths.resize(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
  std::array<unsigned int, 2> area{ texture->GetWidth(), texture->GetHeight() };
  std::array<vtkIdType, 2> gaps{ 0, 0 };
  texture->Activate(); // or it would be bound in place of another one
  const auto buffer = vtkSmartPointer<vtkPixelBufferObject>::Take(texture->Download());
  return buffer->Download2D(VTK_FLOAT, depths.data(), area.data(), 1, gaps.data());
}

vtkMTimeType PeelingPass::Time() const
{
  return this->Pass->GetShaderStageMTime();
}

}
