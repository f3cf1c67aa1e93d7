// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_PeelingPass_h
#define TemporalCoherence_PeelingPass_h

#include "vtkTemporalCoherenceCompatibility.h"

#include <vtkType.h>

#include <optional>
#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkDualDepthPeelingPass;
class vtkShaderProgram;
class vtkVolume;
VTK_ABI_NAMESPACE_END

namespace TemporalCoherence
{

/// vtkDualDepthPeelingPass while it draws volumes (UseDepthPeelingForVolumes): the space between
/// translucent polygons, slab by slab. It draws each volume once for all that lies before and
/// behind these polygons, and then once for each pair of layers that it peels. Volume mappers give
/// it a shader that can tell what is seen between two depths; it completes that shader by what is
/// to be done in each stage, and blends.
class PeelingPass
{
public:
  /// The pass, while it draws a volume; none at other times.
  static std::optional<PeelingPass> Of(vtkVolume* volume);

  /// True if this is the first of the times that it draws the volume for a picture.
  bool IsFirst() const;

  /// True if what is drawn now is to be blended over what is there, and not to replace it.
  bool IsBlended() const;

  /// The fragment shader. It needs, in place of the text "//PeeledColor", the colour
  /// (premultiplied) of what is seen from a depth in the window, `zStart`, up to another, `zEnd`,
  /// without it; and declarations in place of "//PeeledDeclarations".
  const std::string& FragmentShader() const { return this->Source; }

  /// False if the pass has not completed the shader, as one may that is newer than this.
  bool IsKnown() const;

  /// Set what the pass has declared.
  /// \param width, height of the viewport
  void SetUniforms(vtkShaderProgram* program, vtkVolume* volume, int width, int height) const;

  /// What tells a picture of a pass from others.
  vtkMTimeType Time() const;
  const void* Identity() const { return this->Pass; }

private:
  vtkDualDepthPeelingPass* Pass = nullptr;
  std::string Source;
};

/// True if a pass draws more of a picture of a volume that it has drawn a part of.
inline bool IsPeeledAgain(vtkVolume* volume)
{
  const std::optional<PeelingPass> pass = PeelingPass::Of(volume);
  return pass && !pass->IsFirst();
}

}

#endif
