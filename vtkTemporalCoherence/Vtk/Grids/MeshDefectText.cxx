// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Grids/MeshDefectText.h"

#include "Trees/MeshTree.h"

#include <vtkDataSet.h>

#include <algorithm>
#include <sstream>

namespace TemporalCoherence
{
namespace
{

constexpr const char* Correct = "; correct it or leave it out with vtkExtractCells.";

/// The part with a cell, whose number in the part it gets; null if there is none.
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

std::string TextOfCount(const MeshPart* part, std::int64_t cell)
{
  std::ostringstream text;
  text << " has ";
  if (part && part->Offsets.First)
  {
    text << part->Offsets.IdAt(cell + 1) - part->Offsets.IdAt(cell);
  }
  else
  {
    text << "other";
  }
  text << " points, which is not the number for its type";
  if (part && part->Types)
  {
    text << ' ' << static_cast<int>(part->Types[cell]);
  }
  return text.str();
}

}

std::string TextOf(const MeshProblem& problem, const Mesh& mesh, const CellOrigins& origins,
  const std::vector<GridLeaf>& leaves)
{
  std::int64_t inPart = problem.Cell;
  const MeshPart* const part = PartWith(mesh, inPart);
  const std::string cell = NameOf(origins.Of(problem.Cell), leaves);
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
      return cell + TextOfPoint(part, problem.Point) + ", which is not finite or too far away" +
        Correct;
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
