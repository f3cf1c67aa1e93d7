// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_KernelsKnownTetrahedra_h
#define TemporalCoherence_KernelsKnownTetrahedra_h

#include "Mesh/KernelsCells.h"
#include "Mesh/TetrahedronPoints.h"
#include "Scene/LayerBatch.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace TemporalCoherence
{
namespace MeshKernels
{

/// Tetrahedra that rays are to be searched in, each ray in one.
struct KnownTetrahedra
{
  using Corner = std::array<double, 4>; ///< x, y, z and the value

  std::uint64_t Rays = 0; ///< those that are searched, one bit each
  // By ray, so that vectors are loaded without gathering. 0 for rays that are not searched.
  std::array<TileArray<Corner>, 4> Corners{};
  TileArray<double> Handedness{};

  /// \param rays one bit for each ray that is to be searched in a tetrahedron
  void Add(const TetrahedronPoints& points, std::uint64_t rays)
  {
    this->Rays |= rays;
    for (std::size_t corner = 0; corner < 4; ++corner)
    {
      const glm::dvec3& point = points.Points[corner];
      const Corner found = { point.x, point.y, point.z, points.Values[corner] };
      ForEachRay(rays, [&](std::size_t ray) { this->Corners[corner][ray] = found; });
    }
    ForEachRay(rays, [&](std::size_t ray) { this->Handedness[ray] = points.Handedness; });
  }
};

/// Append the crossings between Begin and End of rays with their cells, as TetrahedronCrossings
/// does, with the same bits. It is faster if few rays have the same cell.
/// \pre rays are prepared
void KnownTetrahedronCrossings(
  const KnownTetrahedra& tetrahedra, const MeshRays& rays, Crossings& found);

}
}

#endif
