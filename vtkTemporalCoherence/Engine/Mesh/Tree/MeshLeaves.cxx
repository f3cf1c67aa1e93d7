// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/Tree/MeshLeaves.h"

#include "Mesh/Tree/MeshLattice.h"
#include "Mesh/Tree/MeshSteps.h"

#include <algorithm>
#include <array>

namespace TemporalCoherence
{
namespace
{

constexpr std::int64_t CellsInLeaf = MeshLattice::SizeOfBlock;
constexpr std::int64_t LeavesInNode = MeshLattice::SizeOfBlock;

/// Sample for the mean length of edges: the first cell with volume of this many consecutive cells.
/// A prime, which hits all kinds of cells in cubes that are divided alike.
constexpr std::int64_t CellsOfSample = 13;

/// Results for a node.
struct NodeFacts
{
  PointBox Box;
  EdgeSums Edges;
  bool HasVolume = false; ///< true if some cell is not flat
  MeshProblem Problem;
};

/// How far rounding may have moved points in a direction. Points that single precision holds may
/// come from there.
double RoundingOf(const std::array<glm::dvec3, 8>& points, int count, const glm::dvec3& direction)
{
  glm::dvec3 largest(0.0);
  bool areSingle = true;
  for (int i = 0; i < count; ++i)
  {
    const glm::dvec3& point = points[static_cast<std::size_t>(i)];
    areSingle = areSingle && glm::dvec3(glm::vec3(point)) == point;
    largest = glm::max(largest, glm::abs(point));
  }
  return glm::dot(largest, glm::abs(direction)) * (areSingle ? 0x1p-22 : 0x1p-50);
}

/// True if points are all at one place, on a line or in a plane, as far as rounding tells.
bool AreFlat(const std::array<glm::dvec3, 8>& points, int count)
{
  glm::dvec3 longest(0.0), normal(0.0);
  const auto forEachEdge = [&](const auto& visit)
  {
    for (int i = 1; i < count; ++i)
    {
      visit(points[static_cast<std::size_t>(i)] - points[0]);
    }
  };
  forEachEdge([&](const glm::dvec3& edge)
    { longest = glm::length(edge) > glm::length(longest) ? edge : longest; });
  const double size = glm::length(longest);
  if (!(size > 0.0))
  {
    return true;
  }
  forEachEdge(
    [&](const glm::dvec3& edge)
    {
      const glm::dvec3 across = glm::cross(longest / size, edge / size);
      normal = glm::length(across) > glm::length(normal) ? across : normal;
    });
  const double width = glm::length(normal);
  if (!(width > 0.0))
  {
    return true;
  }
  double height = 0.0;
  forEachEdge([&](const glm::dvec3& edge)
    { height = std::max(height, std::abs(glm::dot(normal / width, edge))); });
  return height <= RoundingOf(points, count, normal / width);
}

void AddEdges(const std::array<glm::dvec3, 8>& points, int corners, bool isSample, EdgeSums& edges)
{
  if (corners == 4)
  {
    edges.Add(points, TetrahedronEdges, isSample);
  }
  else
  {
    edges.Add(points, HexahedronEdges, isSample);
  }
}

/// Read the cells of a leaf.
/// \param box around them
void ReadLeaf(const MeshReader& reader, const std::uint32_t* cells, std::size_t count,
  PointBox& box, NodeFacts& facts)
{
  reader.ReadPointsOfAll(cells, count,
    [&](std::size_t cell, const std::array<glm::dvec3, 8>& points, int corners)
    {
      for (std::size_t i = 0; i < static_cast<std::size_t>(corners); ++i)
      {
        if (!IsPointUsable(points[i]) && facts.Problem.Defect == MeshDefect::None)
        {
          facts.Problem = { MeshDefect::PointNotFinite, cells[cell],
            reader.PointAt(cells[cell], i) };
        }
        box.Widen(points[i]);
      }
      AddEdges(points, corners, false, facts.Edges);
      facts.HasVolume = facts.HasVolume || !AreFlat(points, corners);
    });
}

/// The first cell with volume in [from, end); `end` if no such cell exists.
std::int64_t FirstWithVolume(const MeshReader& reader, std::int64_t from, std::int64_t end)
{
  const auto hasVolume = [&](std::int64_t cell)
  {
    std::size_t part;
    std::int64_t inPart;
    reader.Locate(cell, part, inPart);
    return MeshReader::FindPoints(reader.PartAt(part), inPart).Shape != MeshCellShape::None;
  };
  while (from < end && !hasVolume(from))
  {
    ++from;
  }
  return from;
}

/// Sum the edges of a sample of all cells. It is taken and summed in the order of the cells'
/// numbers, so that meshes with equal points have equal sums, whatever the order of their trees.
EdgeSums SampleEdges(const MeshReader& reader)
{
  constexpr std::int64_t inChunk = MeshReader::MostTogether * CellsOfSample;
  const std::int64_t cells = reader.NumberOfCells(), chunks = (cells + inChunk - 1) / inChunk;
  std::vector<EdgeSums> sums(static_cast<std::size_t>(chunks));
  ParallelFor(chunks, 1,
    [&](std::int64_t chunk)
    {
      MeshReader::Together<std::uint32_t> sample;
      std::size_t count = 0;
      const std::int64_t endOfChunk = std::min((chunk + 1) * inChunk, cells);
      for (std::int64_t first = chunk * inChunk; first < endOfChunk; first += CellsOfSample)
      {
        const std::int64_t end = std::min(first + CellsOfSample, endOfChunk);
        const std::int64_t cell = FirstWithVolume(reader, first, end);
        sample[count] = static_cast<std::uint32_t>(cell);
        count += cell < end ? 1 : 0;
      }
      EdgeSums& edges = sums[static_cast<std::size_t>(chunk)];
      reader.ReadPointsOfAll(sample.data(), count,
        [&](std::size_t, const std::array<glm::dvec3, 8>& points, int corners)
        { AddEdges(points, corners, true, edges); });
    });
  EdgeSums whole;
  for (const EdgeSums& edges : sums)
  {
    whole.Add(edges);
  }
  return whole;
}

/// Read the cells of a node.
/// \param boxes of its leaves
void ReadNode(const MeshReader& reader, const CellNumbers& order, std::int64_t node,
  PointBox* boxes, NodeFacts& facts)
{
  const std::int64_t first = node * LeavesInNode * CellsInLeaf;
  const auto count = static_cast<std::int64_t>(order.size());
  const std::int64_t end = std::min(first + LeavesInNode * CellsInLeaf, count);
  for (std::int64_t leaf = 0; leaf * CellsInLeaf < end - first; ++leaf)
  {
    const std::int64_t begin = first + leaf * CellsInLeaf;
    ReadLeaf(reader, order.data() + begin,
      static_cast<std::size_t>(std::min(CellsInLeaf, end - begin)), boxes[leaf], facts);
    if (facts.Problem.Defect != MeshDefect::None)
    {
      return;
    }
    facts.Box.Widen(boxes[leaf]);
  }
}

}

MeshLeaves ReadLeaves(const MeshReader& reader, const CellNumbers& order,
  const ReportProgress& progress, MeshProblem& problem)
{
  const auto cells = static_cast<std::int64_t>(order.size());
  const std::int64_t leaves = (cells + CellsInLeaf - 1) / CellsInLeaf;
  const std::int64_t nodes = (leaves + LeavesInNode - 1) / LeavesInNode;
  MeshLeaves result;
  result.Boxes.resize(static_cast<std::size_t>(leaves));
  std::vector<NodeFacts> facts(static_cast<std::size_t>(nodes));
  const bool isDone = InSteps(nodes, progress,
    [&](std::int64_t node)
    {
      ReadNode(reader, order, node, result.Boxes.data() + node * LeavesInNode,
        facts[static_cast<std::size_t>(node)]);
    });
  if (!isDone)
  {
    problem = { MeshDefect::Stopped, -1, -1 };
    return {};
  }
  EdgeSums edges;
  for (const NodeFacts& node : facts)
  {
    const MeshProblem& found = node.Problem;
    if (found.Defect != MeshDefect::None &&
      (problem.Defect == MeshDefect::None || found.Cell < problem.Cell))
    {
      problem = found;
    }
    result.Whole.Widen(node.Box);
    edges.Add(node.Edges);
    result.HasVolume = result.HasVolume || node.HasVolume;
  }
  if (problem.Defect == MeshDefect::None)
  {
    edges.Add(SampleEdges(reader));
  }
  result.Edges = edges.Lengths();
  return result;
}

}
