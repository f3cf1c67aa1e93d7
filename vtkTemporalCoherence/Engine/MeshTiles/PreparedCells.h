// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_PreparedCells_h
#define TemporalCoherence_PreparedCells_h

#include "Mesh/HexahedronFunctions.h"
#include "Mesh/MeshCell.h"
#include "Mesh/TetrahedronPoints.h"
#include "MeshTiles/CellOutlines.h"
#include "MeshTiles/KernelsBoxes.h"
#include "MeshTiles/MeshDifference.h"
#include "Scene/Frame.h"
#include "Trees/MeshTree.h"

#include <cstddef>
#include <cstdint>
#include <vector>

#include <hwy/cache_control.h>

namespace TemporalCoherence
{

/// Ask for memory that will be read. GCC leaves out calls that do no more than this, so what calls
/// it has to be inlined, too.
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
  hwy::Prefetch(end - 1); // It may lie in one more line.
}

/// What cells are prepared for.
enum class CellPurpose : std::uint8_t
{
  Crossings, ///< to find where rays pass an isovalue
  Solids,    ///< to find parts of rays in a solid: cells that are wholly inside count, too
  Bands      ///< to find what rays reach in a band: cells with values in it count
};

/// A hexahedron, ready to be searched.
struct PreparedHexahedron
{
  MeshCell Cell;
  MeshKernels::CellDifferences Differences;
  MeshKernels::HexahedronFunctions Functions; ///< only for crossings
  NearlyLinear Values;                        ///< of differences; only for bands
  bool Folds = false;                         ///< MayFold(); only for bands
  FloatBox Box;                               ///< in index space, rounded as those of BoxLanes
};

/// A cell as it is searched for parts of rays in a solid.
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

  /// Ask for what a search reads of a cell.
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

  /// The box around a cell in index space, rounded as those of BoxLanes.
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
/// \param cells gets those that count
/// \throws std::bad_alloc
void PrepareCells(const MeshTree& tree, std::int64_t leaf, std::uint64_t which,
  const MeshDifference& difference, double width, CellPurpose purpose, PreparedCells& cells);

}

#endif
