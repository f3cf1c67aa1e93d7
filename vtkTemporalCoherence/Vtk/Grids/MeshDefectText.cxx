// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Grids/MeshDefectText.h"

#include "Mesh/Tree/MeshTree.h"

#include <vtkDataSet.h>
#include <vtkIdList.h>
#include <vtkNew.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace TemporalCoherence
{
namespace
{

constexpr const char* Correct = "; correct it or leave it out with vtkExtractCells.";

/// The part that contains a cell; null if no part does. The cell's number becomes relative to the
/// part.
const MeshPart* PartWith(const Mesh& mesh, std::int64_t& cell)
{
  for (const MeshPart& part : mesh.Parts)
  {
    if (cell < part.NumberOfCells)
    {
      return cell < 0 ? nullptr : &part;
    }
    cell -= part.NumberOfCells;
  }
  return nullptr;
}

std::string NameOf(const CellOrigin& origin, const std::vector<GridLeaf>& leaves)
{
  const auto leaf = std::find_if(leaves.begin(), leaves.end(),
    [&](const GridLeaf& each) { return each.Data == origin.Data && each.Block == origin.Block; });
  const std::string cell =
    origin.Cell < 0 ? std::string("A cell") : "Cell " + std::to_string(origin.Cell);
  return cell + " of " + (leaf == leaves.end() || !leaf->Block ? "the input" : leaf->Name);
}

std::string TextOfPoint(const MeshPart* part, std::int64_t point)
{
  std::ostringstream text;
  text << " has the point " << point;
  if (part && point >= 0 && point < part->NumberOfPoints)
  {
    text << " at (" << part->Coordinates[0].At(point) << ", " << part->Coordinates[1].At(point)
         << ", " << part->Coordinates[2].At(point) << ')';
  }
  return text.str();
}

/// The input's point that explains a bad point in a divided cell: the first point that is not
/// finite or, without one, the farthest point; -1 without points.
vtkIdType WorstPointOf(const CellOrigin& cell)
{
  vtkIdType worst = -1;
  if (!cell.Data || cell.Cell < 0)
  {
    return worst;
  }
  vtkNew<vtkIdList> points;
  cell.Data->GetCellPoints(cell.Cell, points);
  double farthest = -1.0;
  for (const vtkIdType point : *points)
  {
    glm::dvec3 at;
    cell.Data->GetPoint(point, &at.x);
    const glm::dvec3 along = glm::abs(at);
    const double distance = std::isfinite(along.x + along.y + along.z)
      ? std::max({ along.x, along.y, along.z })
      : std::numeric_limits<double>::infinity();
    if (distance > farthest)
    {
      farthest = distance;
      worst = point;
    }
  }
  return worst;
}

/// The text for a point that is not finite or too far away, with its number in the data.
std::string TextOfBadPoint(const MeshPart* part, std::int64_t point, const CellOrigin& origin)
{
  if (!part || !part->Originals.First)
  {
    return TextOfPoint(part, point);
  }
  const vtkIdType given = WorstPointOf(origin);
  if (given < 0)
  {
    return " has a point";
  }
  const double* const at = origin.Data->GetPoint(given);
  std::ostringstream text;
  text << " has the point " << given << " at (" << at[0] << ", " << at[1] << ", " << at[2] << ')';
  return text.str();
}

std::string TextOfCount(const MeshPart* part, std::int64_t cell)
{
  std::ostringstream text;
  text << " has ";
  if (part && part->Connectivity.First)
  {
    text << part->OffsetOf(cell + 1) - part->OffsetOf(cell);
  }
  else
  {
    text << "other";
  }
  text << " points, which is not the number for its type";
  if (part && part->Types)
  {
    text << ' ' << static_cast<int>(part->TypeOf(cell));
  }
  return text.str();
}

}

std::string TextOf(const MeshProblem& problem, const Mesh& mesh, const CellOrigins& origins,
  const std::vector<GridLeaf>& leaves)
{
  std::int64_t inPart = problem.Cell;
  const MeshPart* const part = PartWith(mesh, inPart);
  const CellOrigin origin = origins.Of(problem.Cell);
  const std::string cell = NameOf(origin, leaves);
  switch (problem.Defect)
  {
    case MeshDefect::TooManyCells:
      return "The input has " + std::to_string(mesh.NumberOfCells()) +
        " cells, more than the 4294967294 that can be drawn; draw parts of it, each with a mapper "
        "and a vtkVolume of its own.";
    case MeshDefect::PointOutOfRange:
      return cell + TextOfPoint(nullptr, problem.Point) + ", but there are " +
        std::to_string(part ? part->NumberOfPoints : 0) + " points" + Correct;
    case MeshDefect::OffsetsNotAscending:
      return cell + " has points that begin or end outside of the " +
        std::to_string(part ? part->ConnectivitySize : 0) +
        " point ids of its vtkCellArray; give SetData offsets that ascend up to their number.";
    case MeshDefect::WrongNumberOfPoints:
      return cell + TextOfCount(part, inPart) + Correct;
    case MeshDefect::PointNotFinite:
      return cell + TextOfBadPoint(part, problem.Point, origin) +
        ", which is not finite or too far away" + Correct;
    case MeshDefect::NoMemory:
    case MeshDefect::None:
    case MeshDefect::Stopped:
      break;
  }
  return std::string();
}

std::string TextOfMemory(std::int64_t cells, std::size_t needed, std::size_t limit)
{
  return "The input has " + std::to_string(cells) + " cells, which need at least " +
    std::to_string((needed >> 20) + 1) + " MiB to be set up, more than MeshMemoryLimit (" +
    std::to_string(limit >> 20) +
    " MiB); raise it with SetMeshMemoryLimit, or draw a part of the input (vtkExtractCells).";
}

}
