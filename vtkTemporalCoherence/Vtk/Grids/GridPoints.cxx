// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Grids/GridPoints.h"

#include "Grids/GridShape.h"
#include "Input/MatrixFromVtk.h"
#include "Input/SamplesOfArray.h"
#include "Scene/Parallel.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkPointSet.h>
#include <vtkPoints.h>
#include <vtkRectilinearGrid.h>
#include <vtkSmartPointer.h>

#include <array>
#include <memory>
#include <vector>

namespace TemporalCoherence
{
namespace
{

constexpr std::int64_t PointGrain = 1 << 14;

/// Points of a lattice in the order of VTK, each made by `place(i, j, k)`.
template <typename Place>
MadePoints MakePoints(const glm::ivec3& dimensions, const Place& place)
{
  const std::int64_t row = dimensions.x, slice = row * dimensions.y;
  const std::int64_t count = slice * dimensions.z;
  const auto made = std::make_shared<std::vector<double>>(3 * static_cast<std::size_t>(count));
  ParallelFor(count, PointGrain,
    [&](std::int64_t i)
    {
      const glm::dvec3 point = place(glm::i64vec3(i % row, i % slice / row, i / slice));
      for (int axis = 0; axis < 3; ++axis)
      {
        (*made)[static_cast<std::size_t>(3 * i + axis)] = point[axis];
      }
    });
  return made;
}

MadePoints CopiedPoints(vtkDataArray* points)
{
  const vtkSmartPointer<vtkDataArray> copy = CopyInPlace(points);
  const auto made = std::make_shared<std::vector<double>>();
  made->reserve(3 * static_cast<std::size_t>(copy->GetNumberOfTuples()));
  for (vtkIdType i = 0; i < copy->GetNumberOfTuples(); ++i)
  {
    const double* const point = copy->GetTuple3(i);
    made->insert(made->end(), point, point + 3);
  }
  return made;
}

void SetMadePoints(const std::vector<double>& made, MeshPart& part)
{
  part.NumberOfPoints = static_cast<std::int64_t>(made.size() / 3);
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    part.Coordinates[axis] = { made.data() + axis, ScalarType::Float64, 3 };
  }
}

std::array<vtkDataArray*, 3> CoordinatesOf(vtkRectilinearGrid* grid)
{
  return { grid->GetXCoordinates(), grid->GetYCoordinates(), grid->GetZCoordinates() };
}

MadePoints PointsOfImage(vtkImageData* image)
{
  const int* extent = image->GetExtent();
  const glm::i64vec3 first(extent[0], extent[2], extent[4]);
  const glm::dmat4 physicalFromIndex = MatrixFromVtk(image->GetIndexToPhysicalMatrix());
  return MakePoints(DimensionsOf(image),
    [&](const glm::i64vec3& index)
    { return glm::dvec3(physicalFromIndex * glm::dvec4(glm::dvec3(first + index), 1.0)); });
}

bool PointsOfGrid(
  const GridLeaf& leaf, vtkRectilinearGrid* grid, MadePoints& made, std::string& error)
{
  const glm::ivec3 dimensions = DimensionsOf(grid);
  const std::array<vtkDataArray*, 3> axes = CoordinatesOf(grid);
  std::array<std::vector<double>, 3> along;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const int count = dimensions[static_cast<int>(axis)];
    const vtkIdType given = axes[axis] ? axes[axis]->GetNumberOfTuples() : 0;
    if (given < count)
    {
      error = leaf.Name + " has " + std::to_string(count) + " points along axis " +
        std::to_string(axis) + ", but " + std::to_string(given) +
        " coordinates; give vtkRectilinearGrid one for each.";
      return false;
    }
    for (int i = 0; i < count; ++i)
    {
      along[axis].push_back(axes[axis]->GetComponent(i, 0));
    }
  }
  made = MakePoints(dimensions,
    [&](const glm::i64vec3& index)
    {
      return glm::dvec3(along[0][static_cast<std::size_t>(index.x)],
        along[1][static_cast<std::size_t>(index.y)], along[2][static_cast<std::size_t>(index.z)]);
    });
  return true;
}

/// \return false if a grid has fewer points than its dimensions need
bool HasItsPoints(const GridLeaf& leaf, std::int64_t count, std::string& error)
{
  const glm::i64vec3 dimensions(DimensionsOf(leaf.Data));
  const std::int64_t needed = dimensions.x * dimensions.y * dimensions.z;
  if (needed <= count)
  {
    return true;
  }
  error = leaf.Name + " has " + std::to_string(dimensions.x) + " x " +
    std::to_string(dimensions.y) + " x " + std::to_string(dimensions.z) + " points, but " +
    std::to_string(count) + " coordinates; call SetPoints with one point for each.";
  return false;
}

/// Set points in place, or from a copy if VTK computes them.
bool SetPointsOfSet(const GridLeaf& leaf, MeshPart& part, MadePoints& made, std::string& error)
{
  auto* set = vtkPointSet::SafeDownCast(leaf.Data);
  vtkDataArray* points = set && set->GetPoints() ? set->GetPoints()->GetData() : nullptr;
  part.NumberOfPoints = points ? points->GetNumberOfTuples() : 0;
  if (!HasItsPoints(leaf, part.NumberOfPoints, error))
  {
    return false;
  }
  if (points && !AreInPlace(points))
  {
    made = CopiedPoints(points);
    SetMadePoints(*made, part);
    return true;
  }
  for (std::size_t axis = 0; axis < 3 && points; ++axis)
  {
    const ArraySamples samples = SamplesOf(points, static_cast<int>(axis));
    part.Coordinates[axis] = { samples.First, samples.Type, samples.Step };
  }
  return true;
}

}

void NotePoints(const GridLeaf& leaf, MadeFrom& from)
{
  if (auto* image = vtkImageData::SafeDownCast(leaf.Data))
  {
    const double* matrix = image->GetIndexToPhysicalMatrix()->GetData();
    for (int i = 0; i < 16; ++i)
    {
      from.Add(matrix[i]);
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      from.Add(image->GetExtent()[2 * axis]);
    }
  }
  else if (auto* grid = vtkRectilinearGrid::SafeDownCast(leaf.Data))
  {
    for (vtkDataArray* axis : CoordinatesOf(grid))
    {
      from.Add(axis);
    }
  }
  else if (auto* set = vtkPointSet::SafeDownCast(leaf.Data))
  {
    vtkPoints* points = set->GetPoints();
    from.Add(points ? points->GetData() : nullptr, points ? points->GetMTime() : 0);
  }
}

bool SetPoints(const GridLeaf& leaf, MeshPart& part, MadePoints& made, std::string& error)
{
  made = nullptr;
  if (auto* image = vtkImageData::SafeDownCast(leaf.Data))
  {
    made = PointsOfImage(image);
  }
  else if (auto* grid = vtkRectilinearGrid::SafeDownCast(leaf.Data))
  {
    if (!PointsOfGrid(leaf, grid, made, error))
    {
      return false;
    }
  }
  else
  {
    return SetPointsOfSet(leaf, part, made, error);
  }
  SetMadePoints(*made, part);
  return true;
}

}
