// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_MergedBlocks_h
#define TemporalCoherence_MergedBlocks_h

#include "Input/ImageLattice.h"
#include "Input/ScalarChoice.h"
#include "vtkTemporalCoherenceCompatibility.h"

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <cstdint>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;
class vtkDataObjectTree;
VTK_ABI_NAMESPACE_END

namespace TemporalCoherence
{

/// The images of a composite data set as one image.
///
/// The images must lie on one lattice. Their chosen arrays are copied into one image that covers
/// them all, so that there are no seams. Cells without a block are marked as HIDDENCELL with
/// vtkGhostType. The image is made once, and again only when a block changes.
class MergedBlocks
{
public:
  /// \param error gets what is wrong and what to do about it
  /// \return false on error. Blocks without cells or without the array are skipped.
  bool Merge(vtkDataObjectTree* tree, const ScalarChoice& choice, std::string& error);

  /// The merged image. It has no points if there is no block to draw.
  vtkImageData* Image() const { return this->Merged; }

  /// Its array; null if there is no block to draw.
  const ChosenScalars& Scalars() const { return this->Chosen; }

  void Release() { *this = MergedBlocks(); }

  /// An image of the composite data set. The pointers are not owned. Those of the last merge may
  /// dangle: they are only compared.
  struct Block
  {
    vtkImageData* Image = nullptr;
    vtkDataArray* Array = nullptr;
    vtkMTimeType Stamp = 0;
    std::string Name; ///< for errors
    LatticeBox Place;
    const std::uint8_t* PointGhosts = nullptr; ///< flags; null: there are none
    const std::uint8_t* CellGhosts = nullptr;
  };

private:
  void Copy(const std::vector<Block>& blocks, bool onCells, const LatticeBox& whole);

  std::vector<Block> Blocks;
  vtkSmartPointer<vtkImageData> Merged;
  ChosenScalars Chosen;
};

}

#endif
