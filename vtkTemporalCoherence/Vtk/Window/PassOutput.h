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

/// The output that a render pass of VTK needs from a surface. Such a pass modifies the shaders of
/// polygons; the shader of a picture writes the output itself.
enum class PassOutput : std::uint8_t
{
  Color,    ///< no such pass: colour and depth
  Occluder, ///< vtkSSAOPass: also position and normal in camera coordinates
  Shadow    ///< vtkShadowMapBakerPass: distance from the light instead of the colour
};
constexpr std::size_t NumberOfPassOutputs = 3;

/// The output for the pass that is drawing a volume.
PassOutput OutputFor(vtkVolume* volume);

/// Declarations and statements for the fragment shader. They read `texCoord`, and `color` and
/// `depth` of the pixel, and write gl_FragData. An occluder also needs the texture `normalTexture`
/// (world).
std::string DeclarationsOf(PassOutput output);
std::string StatementsOf(PassOutput output);

/// Set the uniforms that the declarations declare, except for the texture.
/// \param first, size part of the viewport (whose sides are 1) that texture coordinates 0 to 1
///               cover
void SetUniforms(PassOutput output, vtkShaderProgram* program, vtkRenderer* renderer,
  vtkVolume* volume, const glm::vec2& first, const glm::vec2& size);

}

#endif
