// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_AmrGrids_h
#define TemporalCoherence_AmrGrids_h

#include <vtkUniformGrid.h>
#include <vtkUniformGridAMR.h>

namespace TemporalCoherence
{

/// Call `visit(grid)` for the grids of an adaptive grid that have points, level by level.
template <typename Visit>
void ForEachGrid(vtkUniformGridAMR* amr, const Visit& visit)
{
  for (unsigned int level = 0; level < amr->GetNumberOfLevels(); ++level)
  {
    for (unsigned int index = 0; index < amr->GetNumberOfDataSets(level); ++index)
    {
      vtkUniformGrid* grid = amr->GetDataSet(level, index);
      if (grid && grid->GetNumberOfPoints() > 0)
      {
        visit(grid);
      }
    }
  }
}

}

#endif
