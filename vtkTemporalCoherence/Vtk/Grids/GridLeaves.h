// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_GridLeaves_h
#define TemporalCoherence_GridLeaves_h

#include "Input/ScalarChoice.h"
#include "vtkTemporalCoherenceCompatibility.h"

#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;
class vtkDataObject;
class vtkDataSet;
VTK_ABI_NAMESPACE_END

namespace TemporalCoherence
{

/// A data set that becomes a part of a mesh. The pointers are not owned.
struct GridLeaf
{
  vtkDataSet* Data = nullptr;
  vtkDataArray* Array = nullptr;
  bool OnCells = false;   ///< one tuple for each cell, otherwise for each point
  unsigned int Block = 0; ///< flat index in the composite data set; 0 if there is none
  std::string Name;       ///< for messages: "The input", or "Block 4 ('rotor')"
};

/// True if data are drawn as a mesh: an unstructured, curvilinear, explicit structured or adaptive
/// grid, or blocks with a grid of any sort that has cells with volume.
bool IsMesh(vtkDataObject* data);

/// Find the data sets with volume and with the chosen array. Blocks without three-dimensional cells
/// are ignored.
///
/// \pre IsMesh(data), and the data are no adaptive grid
/// \param error receives the mistake and its remedy
/// \return false on error: if a block is something else, or if none of the data sets has the array
bool FindLeaves(vtkDataObject* data, const ScalarChoice& choice, std::vector<GridLeaf>& leaves,
  std::string& error);

}

#endif
