// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_RayBatch_h
#define TemporalCoherence_RayBatch_h

#include "Scene/Field.h"
#include "Scene/Frame.h"

#include <algorithm>
#include <array>
#include <limits>

namespace TemporalCoherence
{

/// Lanes of the widest vectors in use. Kernels may read and write arrays up to the end of the last
/// vector: they must find finite numbers there, and what they write there has no meaning.
constexpr std::size_t WidestVector = 16;

/// `count`, rounded up to whole vectors.
constexpr std::size_t WholeVectors(std::size_t count)
{
  return (count + WidestVector - 1) / WidestVector * WidestVector;
}

/// One value for each ray of a tile, aligned so that no vector crosses a cache line.
template <typename T>
struct alignas(64) TileArray : std::array<T, 64>
{
};

/// The rays of one tile in index space, as arrays over rays: the form that kernels take.
///
/// A ray is Origin + t Direction. t is the world distance, so that a t found in index space needs
/// no conversion. In [Begin, End] the ray runs inside the field's box and between the clipping
/// planes; this determines the picture. [WalkBegin, WalkEnd] lies within it and bounds where a
/// surface can be; this saves time and must not change the result.
struct RayBatch
{
  static constexpr int Capacity = 64;
  template <typename T>
  using Array = TileArray<T>;

  int Count = 0;
  std::array<Array<double>, 3> Origin, Direction;
  std::array<Array<double>, 3> Inverse; ///< 1 / Direction
  Array<double> Begin, End, WalkBegin, WalkEnd;
  Array<double> PerDepth;    ///< t for each unit of the projection's divisor; 0: rays of no view
  Array<std::int32_t> Pixel; ///< position in the planes of the frame
  bool MayBeCapped = true;   ///< false: no ray begins in a solid

  /// True if a ray runs through the field and may meet a surface.
  bool HasWalk(std::size_t ray) const
  {
    return this->Begin[ray] < this->End[ray] && this->WalkBegin[ray] < this->WalkEnd[ray];
  }
};

/// Gradients of the field at hits of a batch, in index space, where the search computed them.
struct KnownGradients
{
  std::uint64_t Rays = 0; ///< one bit for each ray whose gradient is known
  std::array<RayBatch::Array<double>, 3> Gradient;

  void Set(std::size_t ray, const std::array<double, 3>& gradient)
  {
    this->Rays |= std::uint64_t(1) << ray;
    for (std::size_t a = 0; a < 3; ++a)
    {
      this->Gradient[a][ray] = gradient[a];
    }
  }
  void Forget(std::size_t ray) { this->Rays &= ~(std::uint64_t(1) << ray); }
};

/// The hits of a batch, as arrays over rays.
struct HitBatch
{
  RayBatch::Array<double> Depth;         ///< t, or infinity
  RayBatch::Array<SurfaceIndex> Surface; ///< position in the list of isovalues, or Frame::NoSurface
  RayBatch::Array<HitKind> Kind;
  RayBatch::Array<CellNumber> Cell; ///< of a mesh
  KnownGradients Gradients;
  std::int64_t CellsRead = 0; ///< cells whose eight samples were read

  /// Set the first `count` rays to misses.
  void Clear(int count)
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    std::fill_n(this->Depth.begin(), count, infinity);
    std::fill_n(this->Surface.begin(), count, Frame::NoSurface);
    std::fill_n(this->Kind.begin(), count, HitKind::None);
    std::fill_n(this->Cell.begin(), count, NoCell);
    this->Gradients.Rays = 0;
    this->CellsRead = 0;
  }
};

/// Append ray `ray` of one batch to another.
void AppendRay(const RayBatch& from, std::size_t ray, RayBatch& to);

/// Mean distance between neighbouring rays of a whole tile, in voxels, measured across the rays
/// where a middle one begins to walk.
/// \pre rays.Count == RayBatch::Capacity
double SpacingOf(const RayBatch& rays);

}

#endif
