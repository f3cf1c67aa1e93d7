// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_KernelsShading_h
#define TemporalCoherence_KernelsShading_h

#include "RayBatch.h"

#include <array>

namespace TemporalCoherence
{

/// Loops over the hits of a tile, in vectors of the widest kind that the machine has. The results
/// are the same to the last bit on all of them.
namespace ShadingKernels
{

template <typename T>
using Array = RayBatch::Array<T>;

/// Samples around points, each in a cell of its own.
template <typename Real>
struct GradientBatch
{
  std::size_t Count = 0;
  std::array<Array<Real>, 8> Corner; ///< of the cell, [x + 2 y + 4 z]
  /// Along each axis beyond the cell, before its four edges and behind them; edges in the order of
  /// their first corner.
  std::array<std::array<Array<Real>, 4>, 3> Before, Behind;
  std::array<Array<Real>, 3> ScaleFirst, ScaleSecond; ///< of differences at first, second corner
  std::array<Array<Real>, 3> At;                      ///< position in the cell
  std::array<Array<double>, 3> Gradient;              ///< found: per index step
};

/// Central differences at the corners, interpolated to the points.
void InterpolateGradients(GradientBatch<float>& batch);
void InterpolateGradients(GradientBatch<double>& batch);

/// Directions and points of rays, t along them.
struct RayPoints
{
  std::size_t Count = 0;
  Array<double> X, Y; ///< normalised device coordinates
  Array<double> T;
  /// Of any length, linear in X and Y: [0] + X [1] + Y [2].
  std::array<glm::dvec3, 3> LinearDirection, LinearOrigin;
  std::array<Array<double>, 3> Direction, Point; ///< found; directions have unit length
};
void FindRayPoints(RayPoints& points);

/// Unit normals that face the viewer, from gradients. Where there is no gradient the surface is
/// taken to face the viewer.
struct FacingNormals
{
  std::size_t Count = 0;
  glm::dmat3 WorldFromGradient{ 1.0 };
  std::array<Array<double>, 3> Gradient, Ray;
  std::array<Array<float>, 3> Normal; ///< found
};
void FindFacingNormals(FacingNormals& normals);

/// Sums of reflected light (Phong's model).
struct PhongSums
{
  std::size_t Count = 0;
  std::array<Array<float>, 3> Normal, Ray, Color, Sum;

  // One light:
  std::array<Array<float>, 3> ToLight; ///< unit vectors to the light
  Array<float> Share;                  ///< of the light that arrives
  std::array<float, 3> Diffuse, Specular;
  double Power = 1.0;
};
void AddLight(PhongSums& sums);

/// Bytes of the sums.
void RoundColors(const PhongSums& sums, std::array<Array<std::uint8_t>, 3>& bytes);

}

}

#endif
