// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_ManyInputs_h
#define Testing_ManyInputs_h

#include "Walks/RandomChanges.h"

#include <vtkMultiBlockDataSet.h>
#include <vtkRectilinearGrid.h>
#include <vtkSmartPointer.h>

#include <vector>

/// The same waves as every kind of input of a mapper: in an image, a grid or blocks; as scalars of
/// points or cells, or as magnitudes or components of vectors.
class ManyInputs
{
public:
  enum Holder
  {
    InImage,
    InGrid,
    InBlocks
  };
  enum Scalars
  {
    OfPoints,
    OfCells,
    Lengths,
    Components,
    Weighted ///< the component of the largest weight
  };

  ManyInputs(Scene& scene, RandomViews& views);

  /// Give the scene one of the inputs.
  void Show(Holder holder, Scalars scalars);

  /// Change samples, positions, blocks, coordinates, arrays, masks and ghosts, also of inputs that
  /// are not shown now; at last, remove ghosts and mask.
  std::vector<Change> Changes();

  Holder In = InImage;
  Scalars Drawn = OfPoints;

  vtkSmartPointer<vtkImageData> Image; ///< has all arrays; samples of 16 bits

  /// True if the present input has hidden cells.
  bool HidesCells() const;

private:
  void AddArrays();
  void BendGrid();
  void CutBlocks();
  void ChangeSamples();
  void ChangeBlock();
  void ChooseColors();
  void SetMask();

  Scene& Of;
  RandomViews& Views;
  vtkSmartPointer<vtkRectilinearGrid> Grid;
  vtkSmartPointer<vtkMultiBlockDataSet> Blocks;
  bool IsBlockMissing = false;
};

#endif
