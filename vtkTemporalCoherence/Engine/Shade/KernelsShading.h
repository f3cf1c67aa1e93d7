// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_KernelsShading_h
#define TemporalCoherence_KernelsShading_h

#include "Scene/RayBatch.h"

#include <array>

namespace TemporalCoherence
{

/// What is done to all hits of a tile alike, in vectors of the widest kind that the machine has.
/// The results are the same to the last bit on all of them. Arrays are read and written as far as
/// to the end of the last vector.
namespace ShadingKernels
{

template <typename T>
using Array = RayBatch::Array<T>;

/// Rays, and points at t along them.
struct RayPoints
{
  std::size_t Count = 0;
  Array<double> X, Y; ///< normalised device coordinates
  Array<double> T;
  /// Of any length, linear in X and Y: [0] + X [1] + Y [2].
  std::array<glm::dvec3, 3> LinearDirection, LinearOrigin;
  std::array<Array<double>, 3> Direction, Point; ///< found; directions have unit length
  std::array<Array<float>, 3> FloatDirection;    ///< the same, rounded
};
void FindRayPoints(RayPoints& rays);

/// Unit normals that face the viewer, from gradients. Where there is no gradient the surface is
/// taken to face the viewer.
/// \param rays    unit directions
/// \param normals found
void FindFacingNormals(std::size_t count, const glm::dmat3& worldFromGradient,
  const std::array<Array<double>, 3>& gradients, const std::array<Array<double>, 3>& rays,
  Array<std::array<float, 3>>& normals);

/// Sums of reflected light (Phong's model).
struct PhongSums
{
  std::size_t Count = 0;
  Array<std::array<float, 3>> Normal;
  std::array<Array<float>, 3> Color, Sum;

  // One light:
  bool IsPositional = false;
  std::array<float, 3> Toward;         ///< unit vector to a light that is not positional
  std::array<Array<float>, 3> ToLight; ///< unit vectors to a positional one
  Array<float> Share;                  ///< of its light that arrives
  std::array<float, 3> Diffuse, Specular;
  double Power = 1.0;
};
void AddLight(const RayPoints& rays, PhongSums& sums);

/// Opaque colours of the sums, RGBA.
void RoundColors(const PhongSums& sums, Array<std::array<std::uint8_t, 4>>& colors);

}

}

#endif
