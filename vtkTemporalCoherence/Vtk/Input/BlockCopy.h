// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_BlockCopy_h
#define TemporalCoherence_BlockCopy_h

#include "Input/SamplesOfArray.h"

#include <cstdint>
#include <vector>

namespace TemporalCoherence
{

/// A block to be copied into a larger array.
struct BlockSource
{
  std::vector<ArraySamples> Components;
  glm::ivec3 First{ 0 };  ///< position of its first point in the whole
  glm::ivec3 Points{ 0 }; ///< along each axis
  const std::uint8_t* PointGhosts = nullptr;
  const std::uint8_t* CellGhosts = nullptr;
};

/// The array that takes all blocks: points (or cells) of a box, x fastest.
struct BlockTarget
{
  glm::ivec3 Points{ 0 }; ///< along each axis
  bool OnCells = false;   ///< samples lie on the cells between the points
  void* Samples = nullptr;
  std::uint8_t* CellGhosts = nullptr; ///< receives 0, or HIDDENCELL for cells to hide
};

/// Copy blocks of samples of one type into one array, in parallel.
///
/// If several blocks hold a sample, the owner's copy is taken, else a duplicate, else a hidden
/// copy. Of equal blocks the first counts. A cell is visible if some block owns and shows it.
/// Samples without a block repeat their neighbours, so that gradients at the rim are one-sided
/// differences.
/// \pre all blocks lie in the target, with the same type and number of components
/// \return true if there are hidden cells
bool CopyBlocks(const std::vector<BlockSource>& blocks, const BlockTarget& target);

}

#endif
