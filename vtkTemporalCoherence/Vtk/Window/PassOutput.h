// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_PassOutput_h
#define TemporalCoherence_PassOutput_h

#include "vtkTemporalCoherenceCompatibility.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkRenderer;
class vtkShaderProgram;
class vtkVolume;
VTK_ABI_NAMESPACE_END

namespace TemporalCoherence
{

/// What a render pass of VTK wants to know of a surface. Such passes change the shaders of
/// polygons; a picture's shader has to be told.
enum class PassOutput : std::uint8_t
{
  Color,    ///< no such pass: colour and depth
  Occluder, ///< vtkSSAOPass: position and normal in camera coordinates besides
  Shadow    ///< vtkShadowMapBakerPass: distance from the light in place of the colour
};
constexpr std::size_t NumberOfPassOutputs = 3;

/// What the pass that draws a volume now asks for.
PassOutput OutputFor(vtkVolume* volume);

/// Declarations and statements of a fragment shader. They find `texCoord`, and `color` and `depth`
/// of the pixel, write gl_FragData, and need a texture `normalTexture` (world) for an occluder.
std::string DeclarationsOf(PassOutput output);
std::string StatementsOf(PassOutput output);

/// Set what the declarations declare, other than the texture.
/// \param first, size part of the viewport that texture coordinates 0 to 1 cover; its sides are 1
void SetUniforms(PassOutput output, vtkShaderProgram* program, vtkRenderer* renderer,
  vtkVolume* volume, const glm::vec2& first, const glm::vec2& size);

}

#endif
