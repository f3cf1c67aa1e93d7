// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_MeshSource_h
#define TemporalCoherence_MeshSource_h

#include "Adaptive/AmrGrids.h"
#include "Grids/GridArray.h"
#include "Grids/GridMesh.h"
#include "Input/FieldSource.h"
#include "Input/SamplesOfArray.h"

#include <memory>
#include <string>
#include <vector>

namespace TemporalCoherence
{

class MeshTree;

/// Makes the fields of unstructured, curvilinear and explicit structured grids, of blocks of these
/// (also with images and rectilinear grids), and of adaptive grids with several levels.
///
/// The mesh and its tree are made once. New values keep the tree, and new points of the same cells
/// move its boxes.
class MeshSource : public FieldSource
{
public:
  bool Find(vtkDataObject* data, const ScalarChoice& choice, vtkVolumeProperty* property,
    const VectorChoice& vectors, DrawnComponent& found, std::string& error) override;
  bool IsEmpty() const override { return this->Leaves.empty() && !this->Amr; }
  bool Make(const FieldQuery& query, PlacedField& field, std::string& error) override;
  bool MakeValues(
    const ArrayChoice& choice, vtkVolume* volume, FoundValues& found, std::string& error) override;
  void Release() override { *this = MeshSource(); }

private:
  bool SetUp(const FieldQuery& query, FieldSetUp& done, std::string& error);
  bool SetUpTree(bool averagesGradients, const ReportProgress& progress, MakingBudget& budget,
    FieldSetUp& done, std::string& error);

  std::vector<GridLeaf> Leaves; ///< found leaves, with arrays in place
  ArraysInPlace Arrays;         ///< of leaves
  AdaptiveGrid* Amr = nullptr;  ///< found instead of leaves
  ScalarChoice Choice;
  DrawnComponent Component;
  GridMesh Grids;
  GridArray Values; ///< of another array
  std::shared_ptr<const MeshTree> Tree;
  std::shared_ptr<const FieldShape> Shape; ///< of the tree
  bool HasAveragedGradients = false;       ///< of Shape
};

}

#endif
