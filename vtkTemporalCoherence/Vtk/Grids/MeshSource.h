// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_MeshSource_h
#define TemporalCoherence_MeshSource_h

#include "Adaptive/AmrGrids.h"
#include "Grids/GridMesh.h"
#include "Input/FieldSource.h"
#include "Input/SamplesOfArray.h"

#include <memory>
#include <string>
#include <vector>

namespace TemporalCoherence
{

class MeshTree;

/// The fields of unstructured, curvilinear and explicit structured grids, of blocks of these, of
/// images and of rectilinear grids, and of adaptive grids with several levels.
///
/// The mesh and the tree over it are made once. New values leave the tree as it is, and new points
/// of the same cells move its boxes.
class MeshSource : public FieldSource
{
public:
  bool Find(vtkDataObject* data, const ScalarChoice& choice, vtkVolumeProperty* property,
    const VectorChoice& vectors, DrawnComponent& found, std::string& error) override;
  bool IsEmpty() const override { return this->Leaves.empty() && !this->Amr; }
  bool Make(const FieldQuery& query, PlacedField& field, std::string& error) override;
  void Release() override { *this = MeshSource(); }

private:
  bool SetUp(const FieldQuery& query, FieldSetUp& done, std::string& error);
  bool SetUpTree(bool averagesGradients, const ReportProgress& progress, MakingBudget& budget,
    FieldSetUp& done, std::string& error);

  std::vector<GridLeaf> Leaves; ///< that were found; their arrays are in place
  ArraysInPlace Arrays;         ///< of leaves
  AdaptiveGrid* Amr = nullptr;  ///< that was found instead
  ScalarChoice Choice;
  DrawnComponent Component;
  GridMesh Grids;
  std::shared_ptr<const MeshTree> Tree;
  std::shared_ptr<const FieldKind> Kind; ///< of the tree
  bool HasAveragedGradients = false;     ///< the kind
};

}

#endif
