// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_BlockCopy_h
#define TemporalCoherence_BlockCopy_h

#include "Input/SamplesOfArray.h"

#include <cstdint>
#include <vector>

namespace TemporalCoherence
{

/// One of the blocks that are copied into a larger array.
struct BlockSource
{
  std::vector<ArraySamples> Components;
  glm::ivec3 First{ 0 };  ///< its first point among those of the whole
  glm::ivec3 Points{ 0 }; ///< along each axis
  const std::uint8_t* PointGhosts = nullptr;
  const std::uint8_t* CellGhosts = nullptr;
};

/// The array that holds all blocks: points (or cells) of a box, x fastest.
struct BlockTarget
{
  glm::ivec3 Points{ 0 }; ///< along each axis
  bool OnCells = false;   ///< samples are those of the cells between the points
  void* Samples = nullptr;
  std::uint8_t* CellGhosts = nullptr; ///< gets 0, or HIDDENCELL where nothing is to be seen
};

/// Copy blocks of samples of one type into one array, in parallel.
///
/// Of several blocks that hold a sample, one gives it that owns it, else one that has a duplicate,
/// else one in which it is hidden; of equal ones, the first. A cell is seen if a block owns and
/// shows it, whether samples are those of points or of cells. Samples of no block continue those
/// beside them, so that gradients at the rim are one-sided differences.
/// \pre all blocks lie in the target, with the same type and number of components
/// \return true if there are hidden cells
bool CopyBlocks(const std::vector<BlockSource>& blocks, const BlockTarget& target);

}

#endif
