// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_KernelsBlocked_h
#define TemporalCoherence_KernelsBlocked_h

#include "Lattice/KernelsWalk.h"
#include "Scene/RayBatch.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace TemporalCoherence
{

/// Cells of a vector of rays, and the differences of their samples from an isovalue.
template <typename Real>
struct VectorCells
{
  static constexpr std::size_t Capacity = WidestVector / 2;

  std::uint64_t Which; ///< one bit for each ray that is in a cell
  std::array<std::array<double, Capacity>, 3> Cell;
  /// Corner (x, y, z) at [x + 2 y + 4 z]; finite, also for rays without a cell.
  alignas(64) std::array<std::array<Real, Capacity>, 8> Corners{};
};

/// Reads cells for vectors of rays.
template <typename Real>
class VectorCellReader
{
public:
  virtual ~VectorCellReader() = default;

  /// Read the samples of cells, as differences from isovalue number `surface`.
  virtual void Read(std::size_t surface, VectorCells<Real>& cells) const = 0;
};

/// Opaque surfaces of an image that may block rays.
template <typename Real>
struct BlockingScene
{
  WalkScene Walks;
  const VectorCellReader<Real>& Reader;
  std::size_t Surfaces; ///< number of isovalues
  bool IsSolid;         ///< THRESHOLD: a ray that begins inside is blocked
};

/// Find the rays of a batch that meet any surface.
/// \param cellsRead grows by the number of cells that were read
/// \return one bit for each ray that does
std::uint64_t FindBlocked(
  const BlockingScene<float>& scene, const RayBatch& rays, std::int64_t& cellsRead);
std::uint64_t FindBlocked(
  const BlockingScene<double>& scene, const RayBatch& rays, std::int64_t& cellsRead);

}

#endif
