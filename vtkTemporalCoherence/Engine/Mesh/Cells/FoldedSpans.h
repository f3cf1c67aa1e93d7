// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_FoldedSpans_h
#define TemporalCoherence_FoldedSpans_h

#include "Mesh/Cells/CornerPoints.h"
#include "Mesh/Cells/HexahedronRoots.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace TemporalCoherence
{
namespace MeshKernels
{

/// Hits of rays with the faces of a hexahedron, for rays with hits between entry and exit.
struct HexahedronHits
{
  static constexpr std::size_t Most = 12; ///< of a ray: two on each face

  /// Rounding error of coordinates, relative to the largest; how far outside of a face hits still
  /// count, in the face's coordinates, beyond rounding errors; and the largest rounding error of a
  /// hit.
  static constexpr double ValueError = 8e-15, Margin = 1e-12, MostError = 1e-3;

  /// Hits closer together than this share of the cell's length along the ray are one hit.
  static constexpr double SameHit = 1e-10;

  struct Hit
  {
    double T, Value;
  };

  void Add(std::size_t ray, double t, double value, double same)
  {
    std::uint8_t& count = this->Count[ray];
    this->Hits[ray][count++] = { t, value };
    this->Same[ray] = same;
  }

  std::uint64_t Which = 0;
  TileArray<std::uint8_t> Count{};
  TileArray<double> Same;
  TileArray<std::array<Hit, Most>> Hits;
};

/// A hexahedron in the sheared coordinates of one ray, with the distance behind t as its
/// difference.
inline SeenHexahedron SeeFrom(const MeshCell& cell, const MeshRays& rays, std::size_t ray, double t)
{
  const std::array<glm::length_t, 3> axes = TurnedAxes(rays.AxisOf(ray));
  SeenHexahedron seen;
  for (std::size_t corner = 0; corner < 8; ++corner)
  {
    const glm::dvec3& point = cell.Points[corner];
    const double depth = point[axes[2]] - rays.Turned[2][ray];
    seen.X[corner] = (point[axes[0]] - rays.Turned[0][ray]) - rays.ShearX[ray] * depth;
    seen.Y[corner] = (point[axes[1]] - rays.Turned[1][ray]) - rays.ShearY[ray] * depth;
    seen.T[corner] = depth * rays.PerDepth[ray];
    seen.Difference[corner] = seen.T[corner] - t;
  }
  return seen;
}

/// Find the spans between successive hits. A span counts if its midpoint lies in the cell.
inline void FindFoldedSpans(
  const MeshCell& cell, HexahedronHits& hits, const MeshRays& rays, CellSpans& spans)
{
  for (std::size_t ray = 0; ray < MeshRays::Capacity; ++ray)
  {
    if ((hits.Which >> ray & 1u) == 0)
    {
      continue;
    }
    auto& of = hits.Hits[ray];
    const std::size_t count = hits.Count[ray];
    std::stable_sort(of.begin(), of.begin() + static_cast<std::ptrdiff_t>(count),
      [](const auto& a, const auto& b) { return a.T < b.T; });
    std::uint8_t& found = spans.Count[ray];
    bool goesOn = false;
    std::size_t last = 0;
    for (std::size_t next = 1; next < count; ++next)
    {
      if (of[next].T - of[last].T <= hits.Same[ray] && next + 1 < count)
      {
        continue;
      }
      HexahedronRoots roots;
      FindRoots(SeeFrom(cell, rays, ray, 0.5 * (of[last].T + of[next].T)), roots);
      const bool isIn = roots.Count > 0;
      if (isIn && !goesOn && found < CellSpans::Most)
      {
        spans.Spans[ray][found++] = { of[last].T, of[next].T, of[last].Value, of[next].Value };
      }
      else if (isIn)
      {
        spans.Spans[ray][found - 1u].Out = of[next].T;
        spans.Spans[ray][found - 1u].AtOut = of[next].Value;
      }
      goesOn = isIn;
      last = next;
    }
  }
}

}
}

#endif
