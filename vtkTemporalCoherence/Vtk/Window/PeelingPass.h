// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_PeelingPass_h
#define TemporalCoherence_PeelingPass_h

#include "vtkTemporalCoherenceCompatibility.h"

#include <glm/glm.hpp>

#include <vtkType.h>

#include <optional>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkDualDepthPeelingPass;
class vtkShaderProgram;
class vtkVolume;
VTK_ABI_NAMESPACE_END

namespace TemporalCoherence
{

/// Wraps vtkDualDepthPeelingPass while it draws volumes (UseDepthPeelingForVolumes) in slabs
/// between translucent polygons. The pass draws each volume once in front of and behind all
/// polygons, and then once for each pair of layers that it peels. A volume mapper gives it a shader
/// that computes the colour between two depths. The pass completes that shader for each stage, and
/// blends: by the maximum where several volumes lie in a slab.
class PeelingPass
{
public:
  /// The pass that is drawing a volume; none without such a pass.
  static std::optional<PeelingPass> Of(vtkVolume* volume);

  /// True if the pass draws the volume for the first time in a picture.
  bool IsFirst() const;

  /// The fragment shader. "//PeeledColor" must be replaced by code that returns the premultiplied
  /// colour of the window depths [zStart, zEnd), and "//PeeledDeclarations" by its declarations.
  const std::string& FragmentShader() const { return this->Source; }

  /// False if the pass did not complete the shader, as in an unknown version of VTK.
  bool IsKnown() const;

  /// Set the uniforms that the pass has declared.
  /// \param width, height of the viewport
  void SetUniforms(vtkShaderProgram* program, vtkVolume* volume, int width, int height) const;

  /// Give the pass targets of 16 bits for each channel, once. Its own targets have 8 bits, and it
  /// rounds to them twice for each polygon along a line of sight. Contents of the targets stay.
  void RefineTargets() const;

  /// Read the depths of opaque props from before the pass, row by row from below.
  /// \param size of the viewport
  /// \return false if they cannot be read
  /// \throws std::bad_alloc
  bool ReadOpaqueDepths(const glm::ivec2& size, std::vector<float>& depths) const;

  /// Identify the picture and the pass.
  vtkMTimeType Time() const;
  const void* Identity() const { return this->Pass; }

private:
  vtkDualDepthPeelingPass* Pass = nullptr;
  std::string Source;
};

/// True if a pass is drawing a volume again for the same picture.
inline bool IsPeeledAgain(vtkVolume* volume)
{
  const std::optional<PeelingPass> pass = PeelingPass::Of(volume);
  return pass && !pass->IsFirst();
}

}

#endif
