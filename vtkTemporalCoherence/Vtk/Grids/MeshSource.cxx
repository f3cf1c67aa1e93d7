// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Grids/MeshSource.h"

#include "Grids/AmrGrids.h"
#include "Grids/GridShape.h"
#include "Grids/MeshDefectText.h"
#include "Input/GhostArray.h"
#include "Input/VolumePlace.h"
#include "MeshFields/MeshKind.h"
#include "Scene/Stopwatch.h"
#include "Trees/MeshTree.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataSet.h>
#include <vtkPointSet.h>
#include <vtkUnstructuredGrid.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>

#include <algorithm>
#include <limits>

namespace TemporalCoherence
{
namespace
{

/// The most components of the arrays of all data sets.
int MostComponents(const std::vector<GridLeaf>& leaves)
{
  int most = 0;
  for (const GridLeaf& leaf : leaves)
  {
    most = std::max(most, leaf.Array->GetNumberOfComponents());
  }
  return most;
}

int ComponentsOf(vtkUniformGridAMR* amr, const ScalarChoice& choice)
{
  int components = 0;
  ForEachGrid(amr,
    [&](vtkUniformGrid* grid)
    {
      vtkDataArray* array = FindScalars(grid, choice).Array;
      components = std::max(components, array ? array->GetNumberOfComponents() : 0);
    });
  return components;
}

/// Keep all that a mesh reads, also if a data set gets other arrays.
void Keep(const std::vector<GridLeaf>& leaves, PlacedField& field)
{
  for (const GridLeaf& leaf : leaves)
  {
    auto* const points = vtkPointSet::SafeDownCast(leaf.Data);
    auto* const grid = vtkUnstructuredGrid::SafeDownCast(leaf.Data);
    vtkCellArray* const cells = CellsOf(leaf.Data);
    field.Read.insert(field.Read.end(),
      { leaf.Data, leaf.Array, GhostsOf(leaf.Data->GetCellData()),
        points && points->GetPoints() ? points->GetPoints()->GetData() : nullptr,
        cells ? cells->GetOffsetsArray() : nullptr, cells ? cells->GetConnectivityArray() : nullptr,
        grid ? grid->GetCellTypesArray() : nullptr });
  }
}

}

bool MeshSource::Find(vtkDataObject* data, const ScalarChoice& choice, vtkVolumeProperty* property,
  const VectorChoice& vectors, DrawnComponent& found, std::string& error)
{
  this->Leaves.clear();
  this->Choice = choice;
  this->Amr = vtkUniformGridAMR::SafeDownCast(data);
  if (!this->Amr && !FindLeaves(data, choice, this->Leaves, error))
  {
    this->Leaves.clear();
    return false;
  }
  const int components = this->Amr ? ComponentsOf(this->Amr, choice) : MostComponents(this->Leaves);
  found = this->Component = ChooseComponent(property, vectors, components);
  return true;
}

bool MeshSource::Make(const FieldQuery& query, PlacedField& field, std::string& error)
{
  SampleMask mask; // an error, unless it has no effect
  if (!FindMask(query.Mask, query.Mapper, glm::ivec3(0), query.Volume->GetProperty(),
        *query.Isovalues, mask, error))
  {
    return false;
  }
  FieldSetUp& done = field.SetUp;
  const Stopwatch watch(done.Seconds);
  Keep(this->Leaves, field);
  const bool isSeen = this->Amr ? this->Grids.See(this->Amr, this->Choice, this->Component, error)
                                : this->Grids.See(this->Leaves, this->Component, error);
  if (!isSeen || !this->SetUpTree(query, done, error))
  {
    return false;
  }
  const MeshTree& tree = *this->Tree;
  done.Memory = tree.MemoryInBytes() + this->Grids.MemoryInBytes();
  done.Error = this->Grids.ErrorOfDivision();
  done.AveragesCells = std::any_of(
    this->Leaves.begin(), this->Leaves.end(), [](const GridLeaf& leaf) { return leaf.OnCells; });
  field.Samples = MeshField(tree, this->Kind);
  field.Cells = this->Grids.Origins();
  field.Axes = { tree.Low(), glm::dvec3(tree.Scale()) };
  field.PerStep = glm::dvec3(tree.Edges().Mean / tree.Scale());
  glm::dmat4& place = field.Transform.WorldFromIndex;
  place = glm::dmat4(tree.Scale());
  place[3] = glm::dvec4(tree.Low(), 1.0);
  return PlaceVolume(query.Volume, field.Transform, error);
}

/// Make a tree for the mesh, or bring it up to date.
bool MeshSource::SetUpTree(const FieldQuery& query, FieldSetUp& done, std::string& error)
{
  const std::shared_ptr<const Mesh>& mesh = this->Grids.Made();
  const Mesh* const last = this->Tree ? &this->Tree->TheMesh() : nullptr;
  const std::shared_ptr<const MeshTree> before = this->Tree;
  MeshProblem problem;
  if (!last || last->CellStamp != mesh->CellStamp)
  {
    done.Work = SetUpWork::Built;
    this->Kind = nullptr;
    this->Tree = nullptr;
    const std::size_t limit =
      query.MeshMemoryLimit ? query.MeshMemoryLimit : std::numeric_limits<std::size_t>::max();
    this->Tree = MeshTree::Build(mesh, query.Report, limit, problem);
  }
  else if (last->PointStamp != mesh->PointStamp)
  {
    done.Work = SetUpWork::Refitted;
    this->Tree = this->Tree->Refit(mesh, query.Report, problem);
  }
  else if (last->ValueStamp != mesh->ValueStamp)
  {
    done.Work = SetUpWork::NewValues;
    this->Tree = this->Tree->WithValuesOf(mesh);
  }
  else
  {
    done.Work = SetUpWork::Kept;
  }
  if (!this->Tree)
  {
    this->Kind = nullptr;
    const auto origins = this->Grids.Origins();
    error = TextOf(problem, *mesh, origins ? *origins : CellOrigins(mesh, {}), this->Leaves,
      query.MeshMemoryLimit);
    return false;
  }
  if (!this->Kind || this->Tree != before || this->HasAveragedGradients != query.AveragedGradients)
  {
    this->Kind = MeshKind(this->Tree, query.AveragedGradients);
    this->HasAveragedGradients = query.AveragedGradients;
  }
  return true;
}

}
