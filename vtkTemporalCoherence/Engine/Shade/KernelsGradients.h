// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_KernelsGradients_h
#define TemporalCoherence_KernelsGradients_h

#include "Scene/Field.h"
#include "Scene/HitRays.h"

#include <array>
#include <cstdint>
#include <type_traits>

namespace TemporalCoherence
{

/// Gradients of a field at points, in the widest vectors of the machine. Every kind of vectors
/// gives bit-identical results.
namespace GradientKernels
{

template <typename T>
using Array = RayBatch::Array<T>;
using Vectors = std::array<Array<double>, 3>; ///< by axis

/// The cells of a field, and the transform from the world to index space.
struct CellSpace
{
  glm::dmat4 IndexFromWorld{ 1.0 };
  glm::ivec3 Dimensions{ 0 }; ///< samples along each axis
  bool IsNearest =
    false; ///< points are moved along the ray, into the box of the sample that it enters
};

/// Points and their cells. `Real` is the type in which samples are computed with.
template <typename Real>
struct CellPoints
{
  std::size_t Count = 0;
  std::array<Array<std::int32_t>, 3> Cell; ///< its first corner
  std::array<Array<Real>, 3> At; ///< position in the cell; 0 or 1 with nearest interpolation
};

/// Find the cells of hits.
/// \return true if all cells are inner ones: no sample around them is missing
bool FindCells(const CellSpace& space, const HitRays& rays, CellPoints<float>& found);
bool FindCells(const CellSpace& space, const HitRays& rays, CellPoints<double>& found);

/// The type in which samples are stored, four or two in a row: their own, except for integers that
/// vectors cannot convert to double.
template <typename T>
using StoredAs = std::conditional_t<std::is_integral_v<T> && (sizeof(T) > 2), double, T>;

/// The samples around points, for central differences, in rows along x.
template <typename Stored>
struct RowBatch
{
  /// Rows of the cell, extended by a sample before and a sample behind the cell: [y + 2 z].
  std::array<Array<std::array<Stored, 4>>, 4> Along;
  /// The rows beside the cell: [0, 1] before it in y, [2, 3] behind it, at both z; [4, 5] before it
  /// in z, [6, 7] behind it, at both y.
  std::array<Array<std::array<Stored, 2>>, 8> Beside;
  /// For samples that may not be finite: the isovalue, as a sum of two numbers, and the largest
  /// difference from it (Difference.h). Not used by narrow integers.
  Array<double> High, Low, Limit;
};

/// Find gradients: central differences at the corners of cells, one-sided at the boundary of the
/// field, interpolated to the points.
/// \param gradients result, per index step
void InterpolateGradients(const glm::ivec3& dimensions, const CellPoints<float>& points,
  const RowBatch<std::uint8_t>& rows, Vectors& gradients);
void InterpolateGradients(const glm::ivec3& dimensions, const CellPoints<float>& points,
  const RowBatch<std::int8_t>& rows, Vectors& gradients);
void InterpolateGradients(const glm::ivec3& dimensions, const CellPoints<float>& points,
  const RowBatch<std::uint16_t>& rows, Vectors& gradients);
void InterpolateGradients(const glm::ivec3& dimensions, const CellPoints<float>& points,
  const RowBatch<std::int16_t>& rows, Vectors& gradients);
void InterpolateGradients(const glm::ivec3& dimensions, const CellPoints<double>& points,
  const RowBatch<float>& rows, Vectors& gradients);
void InterpolateGradients(const glm::ivec3& dimensions, const CellPoints<double>& points,
  const RowBatch<double>& rows, Vectors& gradients);

/// Find gradients in inner cells. The vectors of the machine gather the samples themselves.
void GatherGradients(
  const NarrowSamples<std::uint8_t>& samples, const CellPoints<float>& points, Vectors& gradients);
void GatherGradients(
  const NarrowSamples<std::int8_t>& samples, const CellPoints<float>& points, Vectors& gradients);
void GatherGradients(
  const NarrowSamples<std::uint16_t>& samples, const CellPoints<float>& points, Vectors& gradients);
void GatherGradients(
  const NarrowSamples<std::int16_t>& samples, const CellPoints<float>& points, Vectors& gradients);

}

}

#endif
