// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_AmrGrids_h
#define TemporalCoherence_AmrGrids_h

#include <vtkImageData.h>
#include <vtkUniformGrid.h>
#include <vtkUniformGridAMR.h>
#include <vtkVersionMacros.h>

namespace TemporalCoherence
{

/// Adaptive grids of images. Since VTK 9.6 each is also a tree of blocks, and its grids may be
/// plain images instead of vtkUniformGrid.
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 6, 0)
using AdaptiveGrid = vtkAMRDataObject;
#else
using AdaptiveGrid = vtkUniformGridAMR;
#endif

/// The number of blocks of a level.
inline unsigned int CountBlocks(AdaptiveGrid* amr, unsigned int level)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 6, 0)
  return amr->GetNumberOfBlocks(level);
#else
  return amr->GetNumberOfDataSets(level);
#endif
}

/// The grid of a block; null without a grid or without points.
inline vtkImageData* GridOf(AdaptiveGrid* amr, unsigned int level, unsigned int block)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 6, 0)
  vtkImageData* const grid = amr->GetDataSetAsImageData(level, block);
#else
  vtkImageData* const grid = amr->GetDataSet(level, block);
#endif
  return grid && grid->GetNumberOfPoints() > 0 ? grid : nullptr;
}

/// Call `visit(level, grid)` for the grids of an adaptive grid that have points, level by level.
template <typename Visit>
void ForEachGrid(AdaptiveGrid* amr, const Visit& visit)
{
  for (unsigned int level = 0; level < amr->GetNumberOfLevels(); ++level)
  {
    for (unsigned int block = 0; block < CountBlocks(amr, level); ++block)
    {
      if (vtkImageData* const grid = GridOf(amr, level, block))
      {
        visit(level, grid);
      }
    }
  }
}

}

#endif
