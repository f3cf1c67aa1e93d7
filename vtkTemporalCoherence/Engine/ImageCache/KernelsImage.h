// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_KernelsImage_h
#define TemporalCoherence_KernelsImage_h

#include "Scene/RayBatch.h"

#include <cstdint>

namespace TemporalCoherence
{

/// How much of a ray's walk a cached image covers.
enum class PathKind : std::uint8_t
{
  Unknown, ///< not the beginning
  Clipped, ///< not the end
  Whole
};

/// The walks of rays in a cached image, as arrays over rays. Column, row and disparity are affine
/// in a parameter that runs from 0 to End.
struct PathBatch
{
  template <typename T>
  using Array = RayBatch::Array<T>;

  Array<double> T0, T1; ///< distances along the ray at 0 and 1
  Array<double> Q0, Q1; ///< disparities
  Array<double> U, V, PerU, PerV;
  Array<double> End;
  Array<PathKind> Kind;
};

/// The projection of index space into a cached image.
struct ImageProjection
{
  bool IsParallel = false;
  double Near = 0.0, Far = 0.0;                     ///< depths of the clipping planes
  glm::dvec2 Size{ 0.0 };                           ///< pixels
  glm::dvec4 RowU{ 0.0 }, RowV{ 0.0 }, RowZ{ 0.0 }; ///< column and row (times depth), and depth
};
void ProjectWalks(const ImageProjection& image, const RayBatch& rays, PathBatch& paths);

}

#endif
