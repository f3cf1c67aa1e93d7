// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/Tree/MeshCheck.h"

#include "Mesh/Cells/MeshCell.h"
#include "Mesh/Tree/MeshReader.h"
#include "Mesh/Tree/MeshSteps.h"

#include <algorithm>

namespace TemporalCoherence
{
namespace
{

/// Small enough to balance threads, large enough to make the cost of a chunk itself negligible.
constexpr std::int64_t CellsInChunk = 1 << 14;

/// Cells have 32-bit numbers, of which one is kept free.
constexpr std::int64_t MostCells = (std::int64_t(1) << 32) - 2;

/// Number of points of a cell, by its type; 0 for types without volume.
std::int64_t PointsOfType(const MeshPart& part, std::int64_t cell)
{
  switch (static_cast<MeshCellType>(part.TypeOf(cell)))
  {
    case MeshCellType::Tetrahedron:
      return 4;
    case MeshCellType::Voxel:
    case MeshCellType::Hexahedron:
      return 8;
    case MeshCellType::Wedge:
      return 6;
    case MeshCellType::Pyramid:
      return 5;
  }
  return 0;
}

/// Check the offsets and the number of points of a cell of a list.
MeshDefect CheckOffsets(const MeshPart& part, std::int64_t cell)
{
  const std::int64_t begin = part.OffsetOf(cell), end = part.OffsetOf(cell + 1);
  if (begin < 0 || end < begin || end > part.ConnectivitySize)
  {
    return MeshDefect::OffsetsNotAscending;
  }
  const std::int64_t expected = PointsOfType(part, cell);
  return expected != 0 && expected != end - begin ? MeshDefect::WrongNumberOfPoints
                                                  : MeshDefect::None;
}

/// Check the cells of a chunk, up to the first defect.
MeshProblem CheckChunk(const MeshPart& part, CellChunk& chunk)
{
  std::array<glm::dvec3, 8> points;
  for (std::int64_t cell = chunk.Begin; cell < chunk.End; ++cell)
  {
    const std::int64_t number = chunk.First + cell - chunk.Begin;
    const bool isListed = part.Dimensions.x == 0;
    const MeshDefect defect = isListed ? CheckOffsets(part, cell) : MeshDefect::None;
    if (defect != MeshDefect::None)
    {
      return { defect, number, -1 };
    }
    const MeshCellPoints ids = MeshReader::FindPoints(part, cell);
    const auto count = static_cast<std::size_t>(NumberOfPointsIn(ids.Shape));
    for (std::size_t i = 0; i < count; ++i)
    {
      if (ids.Ids[i] < 0 || ids.Ids[i] >= part.NumberOfPoints)
      {
        return { MeshDefect::PointOutOfRange, number, ids.Ids[i] };
      }
    }
    MeshReader::ReadCoordinates(part, ids, points);
    for (std::size_t i = 0; i < count; ++i)
    {
      if (!IsPointUsable(points[i]))
      {
        return { MeshDefect::PointNotFinite, number, ids.Ids[i] };
      }
      chunk.Box.Widen(points[i]);
    }
    chunk.NumberOfCells += count != 0 ? 1 : 0;
  }
  return {};
}

/// True if a curvilinear grid has enough points, and as many cells as its dimensions imply.
bool IsGridComplete(const MeshPart& part)
{
  const glm::i64vec3 points(part.Dimensions);
  if (points.x < 2 || points.y < 2 || points.z < 2 ||
    points.z > part.NumberOfPoints / (points.x * points.y))
  {
    return false;
  }
  return part.NumberOfCells == (points.x - 1) * (points.y - 1) * (points.z - 1);
}

/// Divide the cells of all parts into chunks.
std::vector<CellChunk> ChunksOf(const Mesh& mesh, MeshProblem& problem)
{
  std::vector<CellChunk> chunks;
  std::int64_t first = 0;
  for (std::size_t i = 0; i < mesh.Parts.size(); ++i)
  {
    const MeshPart& part = mesh.Parts[i];
    if (part.Dimensions.x > 0 && part.NumberOfCells > 0 && !IsGridComplete(part))
    {
      problem = { MeshDefect::WrongNumberOfPoints, first, -1 };
      return {};
    }
    if (part.NumberOfCells > MostCells - first)
    {
      problem = { MeshDefect::TooManyCells, -1, -1 };
      return {};
    }
    for (std::int64_t begin = 0; begin < part.NumberOfCells; begin += CellsInChunk)
    {
      const std::int64_t end = std::min(begin + CellsInChunk, part.NumberOfCells);
      chunks.push_back({ i, begin, end, first + begin, 0, {} });
    }
    first += part.NumberOfCells;
  }
  return chunks;
}

}

std::vector<CellChunk> CheckMesh(
  const Mesh& mesh, const ReportProgress& progress, MeshProblem& problem)
{
  problem = {};
  std::vector<CellChunk> chunks = ChunksOf(mesh, problem);
  std::vector<MeshProblem> problems(chunks.size());
  const bool isDone = InSteps(static_cast<std::int64_t>(chunks.size()), progress,
    [&](std::int64_t i)
    {
      const auto at = static_cast<std::size_t>(i);
      problems[at] = CheckChunk(mesh.Parts[chunks[at].Part], chunks[at]);
    });
  for (std::size_t i = 0; i < problems.size() && problem.Defect == MeshDefect::None; ++i)
  {
    problem = problems[i];
  }
  if (problem.Defect == MeshDefect::None && !isDone)
  {
    problem.Defect = MeshDefect::Stopped;
  }
  return chunks;
}

}
