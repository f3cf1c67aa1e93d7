// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Grids/MeshSource.h"

#include "Adaptive/AmrGrids.h"
#include "Grids/CellTypes.h"
#include "Grids/GridShape.h"
#include "Grids/MeshDefectText.h"
#include "Input/GhostArray.h"
#include "Input/VolumePlace.h"
#include "Kinds/MeshKind.h"
#include "Mesh/Tree/MeshTree.h"
#include "Scene/Timers.h"

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

int ComponentsOf(AdaptiveGrid* amr, const ScalarChoice& choice)
{
  int components = 0;
  ForEachGrid(amr,
    [&](unsigned int, vtkImageData* grid)
    {
      vtkDataArray* array = FindScalars(grid, choice).Array;
      components = std::max(components, array ? array->GetNumberOfComponents() : 0);
    });
  return components;
}

/// Count the cells of the input, before divisions.
std::int64_t CountCells(const std::vector<GridLeaf>& leaves, AdaptiveGrid* amr)
{
  std::int64_t cells = 0;
  for (const GridLeaf& leaf : leaves)
  {
    cells += leaf.Data->GetNumberOfCells();
  }
  if (amr)
  {
    ForEachGrid(amr, [&](unsigned int, vtkImageData* grid) { cells += grid->GetNumberOfCells(); });
  }
  return cells;
}

/// Make the transform from the lattice of a tree to the world.
bool PlaceTree(
  const MeshTree& tree, vtkVolume* volume, IndexTransform& transform, std::string& error)
{
  glm::dmat4& place = transform.WorldFromIndex;
  place = glm::dmat4(tree.Scale());
  place[3] = glm::dvec4(tree.Low(), 1.0);
  return PlaceVolume(volume, transform, error);
}

/// Keep all arrays that a mesh reads alive, even if a data set gets others.
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
        grid ? TypesOf(grid) : nullptr });
  }
}

}

bool MeshSource::Find(vtkDataObject* data, const ScalarChoice& choice, vtkVolumeProperty* property,
  const VectorChoice& vectors, DrawnComponent& found, std::string& error)
{
  this->Leaves.clear();
  this->Choice = choice;
  this->Amr = AdaptiveGrid::SafeDownCast(data);
  if (!this->Amr && !FindLeaves(data, choice, this->Leaves, error))
  {
    this->Leaves.clear();
    return false;
  }
  this->Arrays.DropUnused();
  for (GridLeaf& leaf : this->Leaves)
  {
    leaf.Array = this->Arrays.Of(leaf.Array, leaf.Data->GetMTime());
  }
  const int components = this->Amr ? ComponentsOf(this->Amr, choice) : MostComponents(this->Leaves);
  found = this->Component = ChooseComponent(property, vectors, components);
  return true;
}

bool MeshSource::Make(const FieldQuery& query, PlacedField& field, std::string& error)
{
  SampleMask mask; // masks of meshes are errors, unless they have no effect
  if (!FindMask(query.Mask, query.Mapper, glm::ivec3(0), query.Volume->GetProperty(),
        query.Isovalues, mask, error))
  {
    return false;
  }
  FieldSetUp& done = field.SetUp;
  const Stopwatch watch(done.Seconds);
  Keep(this->Leaves, field);
  field.Read.emplace_back(this->Amr);
  if (!this->SetUp(query, done, error))
  {
    return false;
  }
  const MeshTree& tree = *this->Tree;
  done.Memory = tree.MemoryInBytes() + this->Grids.MemoryInBytes() + this->Arrays.MemoryInBytes();
  done.Error = this->Grids.ErrorOfDivision();
  done.AveragesCells = std::any_of(
    this->Leaves.begin(), this->Leaves.end(), [](const GridLeaf& leaf) { return leaf.OnCells; });
  field.Samples = MeshField(tree, this->Shape);
  field.Cells = this->Grids.Origins();
  field.Axes = { tree.Low(), glm::dvec3(tree.Scale()) };
  field.PerStep = glm::dvec3(tree.Edges().Mean / tree.Scale());
  return PlaceTree(tree, query.Volume, field.Transform, error);
}

bool MeshSource::MakeValues(
  const ArrayChoice& choice, vtkVolume* volume, FoundValues& found, std::string& error)
{
  const Mesh& mesh = *this->Grids.Made();
  MeshValuesSource source;
  if (!(this->Amr ? this->Values.See(mesh, this->Amr, choice, error)
                  : this->Values.See(mesh, *this->Grids.Origins(), choice, found.Read, error)) ||
    !PlaceTree(*this->Tree, volume, source.Transform, error))
  {
    return false;
  }
  source.Tree = this->Tree;
  source.Parts = this->Values.Parts();
  source.Stamp = this->Values.Stamp();
  found.Values = MakeMeshValues(source);
  return true;
}

/// Make the mesh and its tree, or bring them up to date.
bool MeshSource::SetUp(const FieldQuery& query, FieldSetUp& done, std::string& error)
{
  constexpr double shareOfCells = 0.5; // of the progress, if cells are made
  double made = 0.0;
  MakingBudget budget;
  budget.Memory =
    query.MeshMemoryLimit ? query.MeshMemoryLimit : std::numeric_limits<std::size_t>::max();
  budget.PerCell = MeshTree::MemoryToBuild(1);
  budget.Report = [&](double share)
  {
    made = shareOfCells;
    return !query.Report || query.Report(shareOfCells * share);
  };
  const bool isSeen = this->Amr
    ? this->Grids.See(this->Amr, this->Choice, this->Component, budget, error)
    : this->Grids.See(this->Leaves, this->Component, budget, error);
  const bool isSetUp = isSeen &&
    this->SetUpTree(query.AveragedGradients, PartOf(query.Report, made, 1.0), budget, done, error);
  if (budget.IsTooSmall())
  {
    error = TextOfMemory(
      CountCells(this->Leaves, this->Amr), budget.NeededMemory(), query.MeshMemoryLimit);
  }
  return isSetUp;
}

/// Make a tree for the mesh, or bring it up to date.
/// \param budget receives the needed memory
bool MeshSource::SetUpTree(bool averagesGradients, const ReportProgress& progress,
  MakingBudget& budget, FieldSetUp& done, std::string& error)
{
  const std::shared_ptr<const Mesh>& mesh = this->Grids.Made();
  const Mesh* const last = this->Tree ? &this->Tree->TheMesh() : nullptr;
  const std::shared_ptr<const MeshTree> before = this->Tree;
  MeshProblem problem;
  if (!last || last->CellStamp != mesh->CellStamp)
  {
    done.Work = SetUpWork::Built;
    this->Shape = nullptr;
    this->Tree = nullptr;
    const std::size_t made = this->Grids.MemoryInBytes();
    const std::size_t limit = budget.Memory - std::min(budget.Memory, made);
    this->Tree = MeshTree::Build(mesh, progress, limit, problem);
    if (problem.Defect == MeshDefect::NoMemory)
    {
      budget.Allows(made, mesh->NumberOfCells());
    }
  }
  else if (last->PointStamp != mesh->PointStamp)
  {
    done.Work = SetUpWork::Refitted;
    this->Tree = this->Tree->Refit(mesh, progress, problem);
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
    this->Shape = nullptr;
    const auto origins = this->Grids.Origins();
    error = TextOf(problem, *mesh, origins ? *origins : CellOrigins(mesh, {}), this->Leaves);
    return false;
  }
  if (!this->Shape || this->Tree != before || this->HasAveragedGradients != averagesGradients)
  {
    this->Shape = MeshKind(this->Tree, averagesGradients);
    this->HasAveragedGradients = averagesGradients;
  }
  return true;
}

}
