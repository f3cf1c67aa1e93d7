// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Trees/MeshLeaves.h"

#include "Trees/MeshLattice.h"
#include "Trees/MeshSteps.h"

#include <algorithm>
#include <array>

namespace TemporalCoherence
{
namespace
{

constexpr std::int64_t CellsInLeaf = MeshLattice::SizeOfBlock;
constexpr std::int64_t LeavesInNode = MeshLattice::SizeOfBlock;

/// Every so many cells of a leaf tell the mean length of edges.
constexpr std::int64_t EdgeSample = 16;

/// What is found out about a node.
struct NodeFacts
{
  PointBox Box;
  EdgeSums Edges;
  MeshProblem Problem;
};

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
      const bool isSample = cell % EdgeSample == 0;
      if (corners == 4)
      {
        facts.Edges.Add(points, TetrahedronEdges, isSample);
      }
      else
      {
        facts.Edges.Add(points, HexahedronEdges, isSample);
      }
    });
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
  }
  result.Edges = edges.Lengths();
  return result;
}

}
