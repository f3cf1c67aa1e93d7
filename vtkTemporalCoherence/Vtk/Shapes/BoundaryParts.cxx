// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Shapes/BoundaryParts.h"

#include <vtkIdList.h>

#include <algorithm>
#include <array>

namespace TemporalCoherence
{
namespace
{

/// The key of a face or edge. Equal points count once: a face without width is an edge.
template <typename Corners>
std::uint64_t KeyOf(const Corners& corners, vtkIdList* points)
{
  std::array<vtkIdType, 4> ids;
  std::size_t count = 0;
  for (const int corner : corners)
  {
    std::size_t at = count++;
    for (; at > 0 && ids[at - 1] > points->GetId(corner); --at)
    {
      ids[at] = ids[at - 1];
    }
    ids[at] = points->GetId(corner);
  }
  std::uint64_t key = 0x9e3779b97f4a7c15u;
  for (std::size_t i = 0; i < count; ++i)
  {
    if (i == 0 || ids[i] != ids[i - 1])
    {
      key = MixBits(key + static_cast<std::uint64_t>(ids[i]) + 0x9e3779b97f4a7c15u);
    }
  }
  return key;
}

}

void BoundaryParts::Add(const ShapeFrame& frame, vtkIdList* points, int parts)
{
  for (const std::vector<int>& face : frame.Faces)
  {
    this->Raise(KeyOf(face, points), parts);
  }
  for (const std::array<int, 2>& edge : frame.Edges)
  {
    this->Raise(KeyOf(edge, points), parts);
  }
}

CellParts BoundaryParts::Of(const ShapeFrame& frame, vtkIdList* points, int inside) const
{
  CellParts parts(inside);
  for (std::size_t face = 0; face < frame.Faces.size(); ++face)
  {
    parts.Faces[face] = std::max(inside, this->PartsOf(KeyOf(frame.Faces[face], points)));
  }
  for (std::size_t edge = 0; edge < frame.Edges.size(); ++edge)
  {
    parts.Edges[edge] = std::max(inside, this->PartsOf(KeyOf(frame.Edges[edge], points)));
  }
  return parts;
}

/// Position of a key in the table, or of its free entry.
std::size_t BoundaryParts::PlaceOf(std::uint64_t key) const
{
  const std::size_t mask = this->Entries.size() - 1;
  std::size_t at = static_cast<std::size_t>(key) & mask;
  while (this->Entries[at].Parts > 0 && this->Entries[at].Key != key)
  {
    at = (at + 1) & mask;
  }
  return at;
}

int BoundaryParts::PartsOf(std::uint64_t key) const
{
  return this->Entries.empty() ? 0 : this->Entries[this->PlaceOf(key)].Parts;
}

void BoundaryParts::Raise(std::uint64_t key, int parts)
{
  if (3 * (this->Used + 1) > 2 * this->Entries.size())
  {
    this->Grow();
  }
  Entry& entry = this->Entries[this->PlaceOf(key)];
  this->Used += entry.Parts == 0 ? 1 : 0;
  entry = { key, std::max(entry.Parts, parts) };
}

void BoundaryParts::Grow()
{
  constexpr std::size_t smallest = 256;
  std::vector<Entry> old(std::max(smallest, 2 * this->Entries.size()));
  old.swap(this->Entries);
  for (const Entry& entry : old)
  {
    if (entry.Parts > 0)
    {
      this->Entries[this->PlaceOf(entry.Key)] = entry;
    }
  }
}

}
