// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef DividedGrid_h
#define DividedGrid_h

#include "vtkBoundingBox.h"
#include "vtkSmartPointer.h"

class vtkMultiProcessController;
class vtkOverlappingAMR;

/// A process's share of an adaptive grid. The surface goes on between blocks, also between those of
/// different processes: so space is divided into boxes, and each process draws one of them. It gets
/// all blocks in its box, and those that cells in its box go on into.
struct DividedGrid
{
  vtkSmartPointer<vtkOverlappingAMR> Blocks;
  vtkBoundingBox Box; ///< what to draw; boxes of processes touch and do not overlap
};

/// Divide an adaptive grid so that each process has about as many cells to draw. Blocks stay in
/// their order. If several processes have the same block, it counts once.
/// All processes call this together.
/// \param blocks of this process
DividedGrid Divide(vtkOverlappingAMR* blocks, vtkMultiProcessController* controller);

#endif
