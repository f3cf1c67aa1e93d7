// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Acceleration/ValueRangePyramid.h"

#include "Acceleration/NodeRanges.h"
#include "Acceleration/RangeScan.h"
#include "Scene/LabelSets.h"
#include "Scene/Parallel.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <memory>
#include <mutex>
#include <utility>

namespace TemporalCoherence
{
namespace
{

/// Get the ranges of a node and its leaves from the kind of field. Empty beyond the end of the
/// field.
/// \param finite is widened by the finite values
void AskKind(const Field& field, const glm::ivec3& place, Range<double>* leaves,
  Range<double>& node, Range<double>& finite)
{
  node = ValueRangePyramid::Empty<double>();
  for (int leaf = 0; leaf < ValueRangePyramid::LeavesPerNode; ++leaf)
  {
    leaves[leaf] = ValueRangePyramid::Empty<double>();
    const CellBox cells = CellsOfLeaf(field, place, leaf);
    if (glm::any(glm::lessThan(cells.Size, glm::ivec3(1))))
    {
      continue;
    }
    const glm::dvec2 range = field.Shape->RangeIn(cells);
    leaves[leaf] = { range.x, range.y };
    node.Min = std::min(node.Min, range.x);
    node.Max = std::max(node.Max, range.y);
    const bool isKnown = IsFinite(leaves[leaf]) || range.x > range.y;
    const glm::dvec2 known = isKnown ? range : field.Shape->FiniteRangeIn(cells);
    finite.Min = std::isfinite(known.x) ? std::min(finite.Min, known.x) : finite.Min;
    finite.Max = std::isfinite(known.y) ? std::max(finite.Max, known.y) : finite.Max;
  }
}

}

void ValueRangePyramid::Build(const Field& field)
{
  this->Release();
  if (!field.Shape->Abilities().Samples)
  {
    this->BuildFromKind(field);
    return;
  }
  if (field.Labels)
  {
    DispatchScalarType(
      field.Type, [&](auto type) { this->BuildFromLabels<decltype(type)>(field); });
    return;
  }
  if (field.Known)
  {
    this->Take(*field.Known, NodesFor(field.Dimensions));
    return;
  }
  const glm::ivec3 nodes = NodesFor(field.Dimensions);
  RangeScan scan(field.Type, field.Dimensions,
    this->MakeRoom(RangeScan::BytesFor(field.Type, field.Dimensions)));
  scan.Scan(field, { 0, 0 }, { nodes.y, nodes.z });
  this->Take(scan.Finish(), nodes);
}

/// Make room of this pyramid's own.
std::shared_ptr<std::byte> ValueRangePyramid::MakeRoom(std::size_t bytes)
{
  this->OwnBytes = bytes;
  return { new std::byte[bytes], std::default_delete<std::byte[]>() };
}

void ValueRangePyramid::Take(KnownRanges known, const glm::ivec3& nodes)
{
  this->Nodes = nodes;
  this->Ranges = std::move(known);
}

/// Build the ranges of labels from those of nodes.
template <typename T>
void ValueRangePyramid::BuildFromLabels(const Field& field)
{
  this->Nodes = NodesFor(field.Dimensions);
  const std::int64_t count = this->NumberOfNodes();
  const auto room = this->MakeRoom(RangeScan::BytesFor(field.Type, field.Dimensions));
  const NodeRanges<T> ranges(count, room.get());
  Range<T>*const leaves = ranges.OfLeaves, *const ofNodes = ranges.OfNodes;
  ParallelFor(count, 64,
    [&](std::int64_t node)
    {
      const glm::ivec3 place(node % this->Nodes.x, node / this->Nodes.x % this->Nodes.y,
        node / this->Nodes.x / this->Nodes.y);
      ofNodes[node] = Empty<T>();
      for (const std::int64_t label : field.Labels->LabelsOf(node))
      {
        const auto value = static_cast<T>(label);
        ofNodes[node] = Union(ofNodes[node], { value, value });
      }
      for (int leaf = 0; leaf < LeavesPerNode; ++leaf)
      {
        const bool hasCells =
          glm::all(glm::greaterThan(CellsOfLeaf(field, place, leaf).Size, glm::ivec3(0)));
        leaves[node * LeavesPerNode + leaf] = hasCells ? ofNodes[node] : Empty<T>();
      }
    });
  const glm::dvec2 whole = WholeRangeOf(ofNodes, count);
  this->Ranges = { room, whole, whole, true, {} };
}

/// Build the ranges of a field without samples from its kind.
void ValueRangePyramid::BuildFromKind(const Field& field)
{
  assert(field.Type == ScalarType::Float64);
  this->Nodes = NodesFor(field.Dimensions);
  const std::int64_t count = this->NumberOfNodes();
  const auto room = this->MakeRoom(RangeScan::BytesFor(field.Type, field.Dimensions));
  const NodeRanges<double> ranges(count, room.get());
  Range<double>*const leaves = ranges.OfLeaves, *const ofNodes = ranges.OfNodes;
  Range<double> finite = Empty<double>();
  std::mutex guard;
  ParallelFor(count, 1,
    [&](std::int64_t node)
    {
      const glm::ivec3 place(node % this->Nodes.x, node / this->Nodes.x % this->Nodes.y,
        node / this->Nodes.x / this->Nodes.y);
      Range<double> inNode = Empty<double>();
      AskKind(field, place, leaves + node * LeavesPerNode, ofNodes[node], inNode);
      const std::lock_guard<std::mutex> lock(guard);
      finite.Min = std::min(finite.Min, inNode.Min);
      finite.Max = std::max(finite.Max, inNode.Max);
    });
  const bool hasFinite = finite.Min <= finite.Max;
  this->Ranges = { room, hasFinite ? glm::dvec2(finite.Min, finite.Max) : glm::dvec2(0.0),
    WholeRangeOf(ofNodes, count), hasFinite, {} };
}

void ValueRangePyramid::Release()
{
  this->Nodes = glm::ivec3(0);
  this->Ranges = {};
  this->OwnBytes = 0;
}

}
