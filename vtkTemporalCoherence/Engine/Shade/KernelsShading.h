// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_KernelsShading_h
#define TemporalCoherence_KernelsShading_h

#include "Scene/RayBatch.h"

#include <array>
#include <cstdint>

namespace TemporalCoherence
{

/// Kernels that shade the hits of a tile, in the widest vectors of the machine. Every kind of
/// vectors gives bit-identical results. Arrays are read and written up to the end of the last
/// vector.
namespace ShadingKernels
{

template <typename T>
using Array = RayBatch::Array<T>;

/// Rays, and the points at t along them.
struct RayPoints
{
  std::size_t Count = 0;
  Array<double> X, Y; ///< normalised device coordinates
  Array<double> T;
  /// Of any length, and linear in X and Y: [0] + X [1] + Y [2].
  std::array<glm::dvec3, 3> LinearDirection, LinearOrigin;
  std::array<Array<double>, 3> Direction, Point; ///< result; directions have unit length
  std::array<Array<float>, 3> FloatDirection;    ///< the same, rounded
};
void FindRayPoints(RayPoints& rays);

/// The same bits for a whole tile of rays that all begin at one point, and whose directions are
/// known. X, Y and T are not used. A ray without a finite distance gets the point of another one.
/// \return one bit for each finite distance
std::uint64_t FindPointsFrom(const glm::dvec3& origin,
  const std::array<Array<double>, 3>& directions, const Array<double>& distances, RayPoints& rays);

/// Make unit normals that face the viewer from gradients. Where the gradient is 0, the surface is
/// taken to face the viewer.
/// \param rays    unit directions
/// \param normals result
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
  Array<float> Share;                  ///< share of its light that arrives
  std::array<float, 3> Diffuse, Specular;
  double Power = 1.0;
};
void AddLight(const RayPoints& rays, PhongSums& sums);

/// One light that is not positional, on surfaces of one colour.
struct SimpleLight
{
  std::array<float, 3> Color, Ambient; ///< of the surface; and what it shows without the light
  std::array<float, 3> Toward;         ///< unit vector to the light
  std::array<float, 3> Diffuse, Specular;
  double Power;
};

/// Find the colours of hits in one pass: the same bits as AddLight and RoundColors give. Normals
/// are read up to the end of the last vector.
void FindColors(const RayPoints& rays, const Array<std::array<float, 3>>& normals,
  const SimpleLight& light, Array<std::array<std::uint8_t, 4>>& colors);

/// Convert the sums to opaque RGBA colours.
void RoundColors(const PhongSums& sums, Array<std::array<std::uint8_t, 4>>& colors);

}

}

#endif
