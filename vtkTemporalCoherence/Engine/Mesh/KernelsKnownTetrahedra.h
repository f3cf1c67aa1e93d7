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
  std::size_t Count = 0;
  std::array<TetrahedronPoints, MeshRays::Capacity> Cells;
  std::uint64_t Rays = 0;       ///< those that are searched, one bit each
  TileArray<std::uint8_t> Cell; ///< the place of each ray's cell; of others, that of any

  KnownTetrahedra() { this->Cell.fill(0); }

  void Add(const TetrahedronPoints& points, std::uint64_t rays)
  {
    this->Rays |= rays;
    ForEachRay(
      rays, [&](std::size_t ray) { this->Cell[ray] = static_cast<std::uint8_t>(this->Count); });
    this->Cells[this->Count++] = points;
  }
};

/// Append the crossings between Begin and End of rays with their cells, as TetrahedronCrossings
/// does, with the same bits. It is faster if few rays have the same cell.
/// \pre rays are prepared, and there is a cell
void KnownTetrahedronCrossings(
  const KnownTetrahedra& tetrahedra, const MeshRays& rays, Crossings& found);

}
}

#endif
