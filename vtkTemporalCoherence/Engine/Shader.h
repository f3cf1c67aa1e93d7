// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_Shader_h
#define TemporalCoherence_Shader_h

#include "Appearance.h"
#include "Field.h"
#include "Frame.h"
#include "View.h"

namespace TemporalCoherence
{

/// The part of a picture that a stage works on: pixels First .. First + Size - 1.
struct PixelRect
{
  glm::ivec2 First{ 0 }, Size{ 0 };
};

/// Where the hits of a picture get their normals from.
struct NormalSource
{
  Field Samples;
  Placement Where;
  std::vector<double> Isovalues;
  glm::dvec2 FiniteRange{ 0.0 };
};

/// Fill the normals of a part of the frame from its depths. Pure: a frame's depths and surfaces
/// decide its normals, whatever route made them.
void ComputeNormals(
  const NormalSource& source, const View& view, const PixelRect& part, Frame& frame);

/// Fill the colours of a part of the frame from its depths and normals.
///
/// VTK's Phong model: ambient light is the surface's own colour; each light adds a diffuse term
/// max(0, N.L) and a specular term max(0, R.V)^power, R being the light mirrored at the normal
/// (vtkVolumeShaderComposer of VTK 9.2 and later). Normals face the viewer, as for polygons.
void ShadePixels(
  const Appearance& appearance, const View& view, const PixelRect& part, Frame& frame);

}

#endif
