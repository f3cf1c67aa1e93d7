// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_AmrBlocks_h
#define TemporalCoherence_AmrBlocks_h

#include "Adaptive/AmrGrids.h"
#include "Input/ScalarChoice.h"
#include "vtkTemporalCoherenceCompatibility.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;
VTK_ABI_NAMESPACE_END

namespace TemporalCoherence
{

/// A box of whole numbers: from First up to, but without, End.
struct AmrBox
{
  glm::i64vec3 First, End;

  glm::i64vec3 Size() const { return this->End - this->First; }
};

inline AmrBox Common(const AmrBox& a, const AmrBox& b)
{
  return { glm::max(a.First, b.First), glm::min(a.End, b.End) };
}

inline bool IsEmpty(const AmrBox& box)
{
  return box.Size().x <= 0 || box.Size().y <= 0 || box.Size().z <= 0;
}

/// A block of an adaptive grid.
struct AmrBlock
{
  vtkImageData* Grid = nullptr;  ///< not owned
  vtkDataArray* Array = nullptr; ///< a tuple for each cell
  std::size_t Level = 0;
  AmrBox Stored;                        ///< cells in its arrays, on the lattice of the level
  AmrBox Cells;                         ///< without outer layers that copy other blocks
  AmrBox Finest;                        ///< Cells, on the finest lattice
  std::string Name;                     ///< for messages
  const std::uint8_t* Ghosts = nullptr; ///< flags of each stored cell; null: there are none

  /// Number of a cell among Cells.
  std::int64_t NumberOf(const glm::i64vec3& cell) const { return PlaceIn(this->Cells, cell); }

  /// Index of a cell in the arrays.
  std::int64_t IndexOf(const glm::i64vec3& cell) const { return PlaceIn(this->Stored, cell); }

private:
  static std::int64_t PlaceIn(const AmrBox& box, const glm::i64vec3& cell)
  {
    const glm::i64vec3 size = box.Size(), at = cell - box.First;
    return at.x + size.x * (at.y + size.y * at.z);
  }
};

/// A level of an adaptive grid: a lattice, in which cell (i, j, k) begins at Origin + (i, j, k)
/// Spacing.
struct AmrLevel
{
  glm::dvec3 Spacing;
  glm::i64vec3 Ratio; ///< cells of the finest lattice along a cell
};

/// The blocks of an adaptive grid on lattices that fit each other.
struct AmrBlocks
{
  glm::dvec3 Origin;
  std::vector<AmrLevel> Levels; ///< levels with blocks, the finest one last
  std::vector<AmrBlock> Blocks; ///< the finest level first; within a level as in the data set

  /// For each block: other blocks with cells inside or next to it, ascending.
  std::vector<std::vector<std::size_t>> Neighbours;
};

/// Find the blocks with data, their lattices and their neighbours.
/// \param error receives the mistake and its remedy
/// \return false on error
/// \throws std::bad_alloc
bool FindAmrBlocks(
  AdaptiveGrid* amr, const ScalarChoice& choice, AmrBlocks& found, std::string& error);

}

#endif
