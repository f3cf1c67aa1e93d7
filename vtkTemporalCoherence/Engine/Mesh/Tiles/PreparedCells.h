// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_PreparedCells_h
#define TemporalCoherence_PreparedCells_h

#include "Mesh/Cells/HexahedronFunctions.h"
#include "Mesh/Cells/MeshCell.h"
#include "Mesh/Cells/TetrahedronPoints.h"
#include "Mesh/Tiles/CellOutlines.h"
#include "Mesh/Tiles/KernelsBoxes.h"
#include "Mesh/Tiles/MeshDifference.h"
#include "Mesh/Tree/MeshTree.h"
#include "Scene/Frame.h"

#include <cstddef>
#include <cstdint>
#include <vector>

#include <hwy/cache_control.h>

namespace TemporalCoherence
{

/// Prefetch memory. GCC drops calls of functions that only prefetch, so callers have to be inlined,
/// too.
template <typename T>
HWY_INLINE void PrefetchAll(const T* first, std::size_t count)
{
  if (count == 0)
  {
    return;
  }
  constexpr std::size_t line = 64;
  const char* const begin = reinterpret_cast<const char*>(first);
  const char* const end = begin + count * sizeof(T);
  for (const char* at = begin; at < end; at += line)
  {
    hwy::Prefetch(at);
  }
  hwy::Prefetch(end - 1); // The end may lie in one more cache line.
}

/// Purposes of prepared cells.
enum class CellPurpose : std::uint8_t
{
  Crossings, ///< to find where rays pass an isovalue
  Solids,    ///< to find parts of rays in a solid: cells that are wholly inside count, too
  Bands      ///< to find values of rays in a band: cells with values in the band count
};

/// A hexahedron, ready to be searched.
struct PreparedHexahedron
{
  MeshCell Cell;
  MeshKernels::CellDifferences Differences;
  MeshKernels::HexahedronFunctions Functions; ///< only for crossings
  NearlyLinear Values;                        ///< of differences; only for bands
  bool Folds = false;                         ///< MayFold(); only for bands
  FloatBox Box;                               ///< in index space, rounded as in BoxLanes
};

/// A cell, ready for the search of a solid.
struct SolidCell
{
  MeshCell Cell;
  MeshKernels::CellDifferences Differences;
};

/// The cells of a leaf that count for a purpose, ready to be searched: read from the mesh, with
/// differences from the isovalue. Tetrahedra come first.
struct PreparedCells
{
  std::size_t Count() const { return this->Numbers.size(); }
  bool IsTetrahedron(std::size_t cell) const { return cell < this->Tetrahedra.size(); }
  const PreparedHexahedron& HexahedronAt(std::size_t cell) const
  {
    return this->Hexahedra[cell - this->Tetrahedra.size()];
  }

  SolidCell SolidAt(std::size_t cell) const;

  /// Prefetch the data of a cell that a search reads.
  HWY_INLINE void Prefetch(std::size_t cell) const
  {
    if (this->IsTetrahedron(cell))
    {
      PrefetchAll(&this->Tetrahedra[cell], 1);
    }
    else
    {
      PrefetchAll(&this->HexahedronAt(cell).Functions, 1);
    }
  }

  /// The box around a cell in index space, rounded as in BoxLanes.
  FloatBox BoxOf(std::size_t cell, const MeshTree& tree) const;

  std::size_t SizeInBytes() const;

  std::vector<CellNumber> Numbers;
  std::vector<std::uint8_t> Places; ///< in the leaf
  CellOutlines Outlines;
  std::vector<MeshKernels::TetrahedronPoints> Tetrahedra;
  std::vector<PreparedHexahedron> Hexahedra;
};

/// Read and prepare cells of a leaf.
/// \param which one bit for each cell that may count
/// \param width how far a band goes above its lowest isovalue, as a difference; infinite: to the
///              largest value
/// \param cells result: the cells that count
/// \throws std::bad_alloc
void PrepareCells(const MeshTree& tree, std::int64_t leaf, std::uint64_t which,
  const MeshDifference& difference, double width, CellPurpose purpose, PreparedCells& cells);

}

#endif
