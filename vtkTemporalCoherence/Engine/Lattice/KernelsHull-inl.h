// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// The planes around a beam. Included by kernels once for each kind of vectors, hence the toggling
// guard.
#if defined(TemporalCoherence_KernelsHull_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef TemporalCoherence_KernelsHull_inl_h
#undef TemporalCoherence_KernelsHull_inl_h
#else
#define TemporalCoherence_KernelsHull_inl_h
#endif

#include "Lattice/CellCubics-inl.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace BeamKernels
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

/// Coordinates of the children of a block.
struct ChildPlaces
{
  ChildPlaces()
  {
    for (std::size_t i = 0; i < 64; ++i)
    {
      this->Along[0][i] = static_cast<float>(i & 3);
      this->Along[1][i] = static_cast<float>(i >> 2 & 3);
      this->Along[2][i] = static_cast<float>(i >> 4);
    }
  }

  alignas(64) std::array<std::array<float, 64>, 3> Along;
};

/// Store a plane's normal, and the tables computed from it.
HWY_INLINE void SetUpNormal(const glm::vec3& normal, std::size_t plane, TileBeam::Hull& hull)
{
  static const ChildPlaces places;
  const Floats d;
  std::array<float, 64>& table = hull.Children[plane];
  for (std::size_t i = 0; i < table.size(); i += hn::Lanes(d))
  {
    V sum = hn::Mul(hn::LoadU(d, &places.Along[0][i]), hn::Set(d, normal.x));
    sum = hn::MulAdd(hn::LoadU(d, &places.Along[1][i]), hn::Set(d, normal.y), sum);
    sum = hn::MulAdd(hn::LoadU(d, &places.Along[2][i]), hn::Set(d, normal.z), sum);
    hn::StoreU(sum, d, &table[i]);
  }
  for (std::size_t a = 0; a < 3; ++a)
  {
    hull.Normal[a][plane] = normal[static_cast<int>(a)];
  }
  hull.Reach[plane] =
    std::max(normal.x, 0.0f) + std::max(normal.y, 0.0f) + std::max(normal.z, 0.0f);
}

/// The largest offset, less a margin, with normal . point >= offset on all rays.
HWY_INLINE float FindOffset(const glm::vec3& normal, const TileBeam& beam)
{
  const Floats d;
  V least = hn::Set(d, TileBeam::Never);
  for (std::size_t i = 0; i < beam.Count; i += hn::Lanes(d))
  {
    V at = hn::Zero(d), per = hn::Zero(d);
    for (std::size_t a = 0; a < 3; ++a)
    {
      const V along = hn::Set(d, normal[static_cast<int>(a)]);
      at = hn::MulAdd(along, hn::LoadU(d, &beam.Origin[a][i]), at);
      per = hn::MulAdd(along, hn::LoadU(d, &beam.Direction[a][i]), per);
    }
    const V begin = hn::MulAdd(per, hn::LoadU(d, &beam.Begin[i]), at);
    const V end = hn::MulAdd(per, hn::LoadU(d, &beam.End[i]), at);
    least = hn::Min(least, hn::Min(begin, end));
  }
  return hn::GetLane(hn::MinOfLanes(d, least)) - 4.0f * beam.Margin;
}

/// Move the plane across a beam to the deepest Behind of its rays.
HWY_INLINE void MoveAcross(TileBeam& beam)
{
  V depth = Set(-TileBeam::Never);
  const hn::RebindToSigned<Floats> di;
  auto vector = hn::Zero(di);
  for (std::size_t i = 0; i < beam.Count; i += hn::Lanes(Floats()))
  {
    const V along = hn::Mul(Load(&beam.Behind[i]), Load(&beam.PerDepth[i]));
    const V end = hn::Add(Load(&beam.AtDepth[i]), along);
    const M isDeeper = hn::Gt(end, depth);
    depth = hn::IfThenElse(isDeeper, end, depth);
    vector = hn::IfThenElse(
      hn::RebindMask(di, isDeeper), hn::Set(di, static_cast<std::int32_t>(i)), vector);
  }
  const float deepest = hn::GetLane(hn::MaxOfLanes(Floats(), depth));
  const std::uint64_t lanes = BitsOf(hn::Eq(depth, Set(deepest)));
  const std::size_t lane = lanes != 0 ? hwy::Num0BitsBelowLS1Bit_Nonzero64(lanes) : 0;
  alignas(64) std::int32_t firsts[WidestVector];
  hn::Store(vector, di, firsts);
  beam.Deepest = static_cast<std::size_t>(firsts[lane]) + lane;
  beam.DeepestBehind = beam.Behind[beam.Deepest];
  beam.Around.Offset[TileBeam::Across] = -(deepest + 4.0f * beam.Margin);
}

/// Recompute the far plane if the deepest hit moved closer.
HWY_INLINE void MoveAcrossIfNearer(TileBeam& beam)
{
  if (beam.Behind[beam.Deepest] < beam.DeepestBehind)
  {
    MoveAcross(beam);
  }
}

HWY_INLINE void SetUpHull(const std::array<glm::vec3, 4>& normals, TileBeam& beam)
{
  TileBeam::Hull& hull = beam.Around;
  for (std::size_t a = 0; a < 3; ++a)
  {
    hull.Normal[a].fill(0.0f);
  }
  hull.Reach.fill(0.0f);
  std::fill(hull.Offset.begin() + TileBeam::Planes, hull.Offset.end(), 0.0f);
  for (std::size_t plane = 0; plane < normals.size(); ++plane)
  {
    SetUpNormal(normals[plane], plane, hull);
    hull.Offset[plane] = FindOffset(normals[plane], beam);
  }
  SetUpNormal(-beam.Forward, TileBeam::Across, hull);
}

/// Normals of four planes along the edges of the tile; 0 where there is none.
inline std::array<glm::vec3, 4> FindNormals(const RayBatch& rays, const TileBeam& beam)
{
  std::array<glm::vec3, 4> normals{};
  if (rays.Count != RayBatch::Capacity)
  {
    return normals;
  }
  constexpr std::array<std::size_t, 4> corners = { 0, 7, 63, 56 };
  std::array<glm::dvec3, 4> direction, point;
  const double perScale = 1.0 / beam.Scale, reach = 64.0 * perScale;
  for (std::size_t c = 0; c < 4; ++c)
  {
    for (int a = 0; a < 3; ++a)
    {
      const auto axis = static_cast<std::size_t>(a);
      direction[c][a] = rays.Direction[axis][corners[c]] * perScale;
      point[c][a] = rays.Origin[axis][corners[c]] - beam.Anchor[a] +
        (beam.First + reach) * rays.Direction[axis][corners[c]];
    }
  }
  for (std::size_t c = 0; c < 4; ++c)
  {
    const std::size_t next = (c + 1) & 3u, across = (c + 2) & 3u;
    const glm::dvec3 normal = glm::cross(direction[c], point[next] - point[c]);
    const double length = glm::length(normal);
    const double side = glm::dot(normal, point[across] - point[c]);
    if (length > 1e-12 && std::abs(side) > 1e-9 * length)
    {
      normals[c] = glm::vec3(normal * ((side > 0.0 ? 1.0 : -1.0) / length));
    }
  }
  return normals;
}

}
}
}
HWY_AFTER_NAMESPACE();

#endif
