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
/// The images must lie on one lattice. Their chosen arrays are copied into one covering image, so
/// no seams appear. Cells without a block are marked as HIDDENCELL with vtkGhostType. The image is
/// made once, and again only when a block changes.
class MergedBlocks
{
public:
  /// \param error receives the mistake and its remedy
  /// \return false on error. Blocks without cells or without the array are skipped.
  bool Merge(vtkDataObjectTree* tree, const ScalarChoice& choice, std::string& error);

  /// The merged image. Without drawable blocks it has no points.
  vtkImageData* Image() const { return this->Merged; }

  /// The chosen array of Image(); null without drawable blocks.
  const ChosenScalars& Scalars() const { return this->Chosen; }

  void Release() { *this = MergedBlocks(); }

  /// An image of the composite data set. The pointers are not owned. After a merge they may dangle:
  /// they are only compared.
  struct Block
  {
    vtkImageData* Image = nullptr;
    vtkDataArray* Array = nullptr;
    vtkMTimeType Stamp = 0;
    std::string Name; ///< for errors
    LatticeBox Place;
    const std::uint8_t* PointGhosts = nullptr; ///< flags or null
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
