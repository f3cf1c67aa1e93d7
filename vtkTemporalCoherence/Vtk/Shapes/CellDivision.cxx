// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Shapes/CellDivision.h"

#include "Shapes/DivisionWalk.h"

#include <algorithm>
#include <utility>

namespace TemporalCoherence
{
namespace
{

/// Numbers the points of cells.
struct NumberingSink
{
  CellDivider& Divider;
  DivisionSink& To;

  void operator()(MeshCellType type, const Corners& corners)
  {
    DivisionCell cell{ type, corners.Count, {} };
    for (int corner = 0; corner < corners.Count; ++corner)
    {
      cell.Points[static_cast<std::size_t>(corner)] = this->Divider.NumberOf(corners[corner]);
    }
    this->To.Add(cell);
  }
};

struct CountingSink
{
  DivisionSize Size;

  void operator()(MeshCellType, const Corners& corners)
  {
    ++this->Size.Cells;
    this->Size.Ids += corners.Count;
  }
};

/// Collects the cells of a division.
struct CollectingSink : public DivisionSink
{
  CellDivision Division;

  void Add(const DivisionCell& cell) override { this->Division.Cells.push_back(cell); }
};

}

bool CellParts::AreEqual(const ShapeFrame& frame) const
{
  const auto isInside = [this](int parts) { return parts == this->Inside; };
  return std::all_of(this->Faces.begin(), this->Faces.begin() + frame.Faces.size(), isInside) &&
    std::all_of(this->Edges.begin(), this->Edges.begin() + frame.Edges.size(), isInside);
}

int CellParts::Largest(const ShapeFrame& frame) const
{
  return std::max({ this->Inside,
    *std::max_element(this->Faces.begin(), this->Faces.begin() + frame.Faces.size()),
    *std::max_element(this->Edges.begin(), this->Edges.begin() + frame.Edges.size()) });
}

void CellDivider::Divide(CurvedShape shape, const CellParts& parts, DivisionSink& sink)
{
  this->Divide(shape, parts, false, sink);
}

void CellDivider::DivideIntoCones(CurvedShape shape, int parts, DivisionSink& sink)
{
  this->Divide(shape, CellParts(parts), true, sink);
}

void CellDivider::Divide(
  CurvedShape shape, const CellParts& parts, bool onlyCones, DivisionSink& sink)
{
  const ShapeFrame& frame = FrameOf(shape);
  this->PlacesOfCell.clear();
  this->Of = Fineness * parts.Largest(frame);
  this->Unit = !onlyCones && parts.AreEqual(frame) ? Fineness : 0;
  this->Row = parts.Inside + 1;
  if (this->Unit > 0)
  {
    const auto row = static_cast<std::size_t>(this->Row);
    this->Lattice.assign(row * row * row, -1);
  }
  else
  {
    constexpr std::size_t fewest = 256;
    this->Entries.assign(std::max(fewest, this->Entries.size()), Entry());
  }
  NumberingSink numbering{ *this, sink };
  WalkOver(shape, parts, onlyCones, numbering);
}

int CellDivider::NumberOf(const glm::ivec3& place)
{
  int* number = this->FindNumber(place);
  if (*number < 0)
  {
    *number = static_cast<int>(this->PlacesOfCell.size());
    this->PlacesOfCell.push_back(
      { static_cast<std::uint16_t>(place.x), static_cast<std::uint16_t>(place.y),
        static_cast<std::uint16_t>(place.z), static_cast<std::uint16_t>(this->Of) });
  }
  return *number;
}

/// Address of the number of a place; -1 stands there for a new place.
int* CellDivider::FindNumber(const glm::ivec3& place)
{
  if (this->Unit > 0)
  {
    const glm::ivec3 at = place / this->Unit;
    return &this->Lattice[static_cast<std::size_t>(at.x + this->Row * (at.y + this->Row * at.z))];
  }
  if (2 * (this->PlacesOfCell.size() + 1) > this->Entries.size())
  {
    this->Grow();
  }
  const std::uint64_t key = static_cast<std::uint64_t>(place.x) |
    static_cast<std::uint64_t>(place.y) << 16 | static_cast<std::uint64_t>(place.z) << 32;
  const std::size_t mask = this->Entries.size() - 1;
  std::size_t at = static_cast<std::size_t>((key * 0x9e3779b97f4a7c15u) >> 32) & mask;
  while (this->Entries[at].Number >= 0 && this->Entries[at].Key != key)
  {
    at = (at + 1) & mask;
  }
  this->Entries[at].Key = key;
  return &this->Entries[at].Number;
}

void CellDivider::Grow()
{
  std::vector<Entry> old(2 * this->Entries.size());
  old.swap(this->Entries);
  for (const Entry& entry : old)
  {
    if (entry.Number >= 0)
    {
      const auto at = [&](int shift) { return static_cast<int>(entry.Key >> shift & 0xffffu); };
      *this->FindNumber({ at(0), at(16), at(32) }) = entry.Number;
    }
  }
}

CellDivision Divide(CurvedShape shape, const CellParts& parts)
{
  CollectingSink sink;
  CellDivider divider;
  divider.Divide(shape, parts, sink);
  sink.Division.Points = divider.Places();
  return std::move(sink.Division);
}

CellDivision DivideIntoCones(CurvedShape shape, int parts)
{
  CollectingSink sink;
  CellDivider divider;
  divider.DivideIntoCones(shape, parts, sink);
  sink.Division.Points = divider.Places();
  return std::move(sink.Division);
}

DivisionSize SizeOf(CurvedShape shape, const CellParts& parts)
{
  CountingSink sink;
  if (shape != CurvedShape::Pyramid && parts.AreEqual(FrameOf(shape)))
  {
    const std::int64_t n = parts.Inside;
    return { n * n * n, FrameOf(shape).NumberOfCorners * n * n * n };
  }
  WalkOver(shape, parts, false, sink);
  return sink.Size;
}

}
