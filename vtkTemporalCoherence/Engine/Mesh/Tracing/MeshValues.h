// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_MeshValues_h
#define TemporalCoherence_MeshValues_h

#include "Mesh/Tree/MeshTree.h"
#include "Scene/ArrayLooks.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace TemporalCoherence
{

/// The values of an array in a part of a mesh.
struct PartValues
{
  std::vector<MeshArray> Components; ///< of several ones, the values are the lengths of vectors
  bool AreOfCells = false;           ///< of the data set's cells (MeshPart::Originals), not points
  std::vector<std::shared_ptr<const void>> Owners; ///< of arrays; others own the rest
};

/// An array on a mesh.
struct MeshValuesSource
{
  std::shared_ptr<const MeshTree> Tree;
  std::vector<PartValues> Parts; ///< of the tree's mesh
  IndexTransform Transform;      ///< of the tree's lattice
  std::uint64_t Stamp = 0;       ///< differs whenever values may have changed
};

/// Make the values of an array.
std::shared_ptr<const ArrayValues> MakeMeshValues(const MeshValuesSource& source);

}

#endif
