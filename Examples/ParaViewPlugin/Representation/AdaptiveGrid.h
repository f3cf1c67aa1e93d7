// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef AdaptiveGrid_h
#define AdaptiveGrid_h

#include "vtkOverlappingAMR.h"
#include "vtkUniformGrid.h"
#include "vtkVersionMacros.h"

#include <vector>

// What VTK 9.6 has new names for.

/// The number of blocks of a level.
inline unsigned int CountBlocks(vtkOverlappingAMR* amr, unsigned int level)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 6, 0)
  return amr->GetNumberOfBlocks(level);
#else
  return amr->GetNumberOfDataSets(level);
#endif
}

/// The grid of a block; null if this process does not have it.
inline vtkImageData* GridOf(vtkOverlappingAMR* amr, unsigned int level, unsigned int index)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 6, 0)
  return amr->GetDataSetAsImageData(level, index);
#else
  return amr->GetDataSet(level, index);
#endif
}

/// Give an adaptive grid places for so many blocks on each level.
inline void SetBlockCounts(vtkOverlappingAMR* amr, const std::vector<unsigned int>& counts)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 6, 0)
  amr->Initialize(counts);
#else
  const std::vector<int> numbers(counts.begin(), counts.end());
  amr->Initialize(static_cast<int>(numbers.size()), numbers.data());
#endif
}

#endif
