// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef DistributedPart_h
#define DistributedPart_h

#include "InputArrays.h"

#include "vtkBoundingBox.h"
#include "vtkSmartPointer.h"

#include <array>
#include <vector>

class vtkDataObject;
class vtkDataSet;
class vtkMultiProcessController;

/// What a process has to know of its part of a distributed volume, and of the whole.
struct DistributedPart
{
  using Interval = std::array<double, 2>;
  static constexpr Interval Nothing{ { 1.0, -1.0 } };

  vtkBoundingBox Owned;         ///< in the world: what this process draws
  vtkBoundingBox Whole;         ///< in the world: what all processes draw
  bool IsCut = false;           ///< samples reach beyond what is drawn, without a ghost array
  vtkBoundingBox Crop;          ///< if it is cut: where, along the axes of the image
  std::vector<Interval> Ranges; ///< finite values of each component in all processes
  Interval Lengths = Nothing;   ///< of its tuples
  bool HoldsLabels = true;      ///< in all processes, they are whole numbers on images

  /// The data is delivered, and may be kept for an animation: so is what describes it.
  void WriteTo(vtkDataObject* data) const;
  static DistributedPart ReadFrom(vtkDataObject* data);
};

/// True unless all cells of a data set are of less than three dimensions. The mapper takes data
/// without volume for a mistake, but a process may well have none of the cells.
bool HasVolume(vtkDataSet* dataSet);

/// Layers of cells beyond the own that surfaces need: one for gradients, and one more for scalars
/// of cells, whose samples lie half a cell farther inside.
constexpr int LeastGhostLayers = 2;

/// What a process needs to draw its part.
struct NeededData
{
  vtkSmartPointer<vtkDataObject> Data;
  vtkBoundingBox Box; ///< all that is to be drawn of it; invalid: that, the data tells

  /// True if a process has grids other than images, rectilinear and adaptive ones: their cells that
  /// belong to another process are not drawn, and nothing has to be cut.
  bool HasMeshes = false;
};

/// A copy, as shallow as can be, that has ghost cells wherever another process goes on; of an
/// adaptive grid, the blocks that fill this process's box and its surroundings.
/// All processes call this together.
/// \param layers of ghost cells that are made if the input has none
NeededData WithGhostCells(vtkDataObject* input, int layers, vtkMultiProcessController* controller);

/// Describe the part of this process. Ghost arrays that tell of nothing but layers around a box are
/// taken away: a box is cut off more cheaply, and has isomaps. Where scalars of cells are chosen,
/// cells of other processes are samples as good as any.
/// All processes call this together.
DistributedPart Describe(
  const NeededData& needed, const ArrayChoice& choice, vtkMultiProcessController* controller);

#endif
