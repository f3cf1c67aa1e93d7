// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Shapes/CellDivision.h"

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <utility>

namespace TemporalCoherence
{
namespace
{

/// Refinement of the lattice, which makes middles of triangles, quadrilaterals and cells lattice
/// points.
constexpr int Fineness = 12;
static_assert(MostParts * Fineness < (1 << 16), "places fit");

/// Corners of a linear cell or face on the lattice.
struct Corners
{
  int Count = 0;
  std::array<glm::ivec3, 8> At{};
  std::array<unsigned int, 8> Supports{}; ///< bits of the cell's corners with a weight there

  void Add(const glm::ivec3& place, unsigned int support)
  {
    this->At[static_cast<std::size_t>(this->Count)] = place;
    this->Supports[static_cast<std::size_t>(this->Count++)] = support;
  }
  const glm::ivec3& operator[](int corner) const
  {
    return this->At[static_cast<std::size_t>(corner)];
  }
  unsigned int SupportOf(int corner) const
  {
    return this->Supports[static_cast<std::size_t>(corner)];
  }
  int After(int corner) const { return (corner + 1) % this->Count; }
};

CurvedShape ShapeOf(MeshCellType type)
{
  return type == MeshCellType::Tetrahedron ? CurvedShape::Tetrahedron
    : type == MeshCellType::Wedge          ? CurvedShape::Wedge
    : type == MeshCellType::Pyramid        ? CurvedShape::Pyramid
                                           : CurvedShape::Hexahedron;
}

/// Walks over the linear cells of a divided cell, and gives their corners on the lattice to a sink:
/// `sink(type, corners)`.
template <typename Sink>
class Walk
{
public:
  /// \param onlyCones divide every part into cones
  Walk(CurvedShape shape, const CellParts& parts, bool onlyCones, Sink& sink)
    : Shape(shape)
    , Frame(FrameOf(shape))
    , Parts(parts)
    , AreWhole(!onlyCones && parts.AreEqual(this->Frame))
    , OnlyCones(onlyCones)
    , Of(Fineness * parts.Largest(this->Frame))
    , Unit(this->Of / parts.Inside)
    , To(sink)
  {
    for (const std::vector<int>& face : this->Frame.Faces)
    {
      this->FaceMasks.push_back(MaskOf(face));
    }
    for (const std::array<int, 2>& edge : this->Frame.Edges)
    {
      this->EdgeMasks.push_back(MaskOf(edge));
    }
  }

  void Run()
  {
    switch (this->Shape)
    {
      case CurvedShape::Tetrahedron:
        this->Tetrahedra();
        break;
      case CurvedShape::Hexahedron:
        this->Hexahedra();
        break;
      case CurvedShape::Wedge:
        this->Wedges();
        break;
      case CurvedShape::Pyramid:
        this->Pyramids();
        break;
    }
  }

private:
  using Place = glm::ivec3;

  template <typename Numbers>
  static unsigned int MaskOf(const Numbers& corners)
  {
    unsigned int mask = 0;
    for (const int corner : corners)
    {
      mask |= 1u << corner;
    }
    return mask;
  }

  void Tetrahedra();
  void Hexahedra();
  void Wedges();
  void Pyramids();

  /// Add a part of the cell: whole or, if its surface is divided further, as cones.
  void Part(MeshCellType type, std::initializer_list<Place> places)
  {
    const Corners corners = this->CornersAt(places, this->Unit);
    const std::vector<std::vector<int>>& faces = FrameOf(ShapeOf(type)).Faces;
    if (this->AreWhole || (!this->OnlyCones && this->IsInside(corners)))
    {
      this->To(type, corners);
      return;
    }
    const auto isWhole = [&](const std::vector<int>& face)
    { return this->IsWhole(FaceOf(corners, face)); };
    if (!this->OnlyCones && std::all_of(faces.begin(), faces.end(), isWhole))
    {
      this->To(type, corners);
      return;
    }
    this->Apex = MiddleOf(type, corners);
    for (const std::vector<int>& face : faces)
    {
      this->Cone(FaceOf(corners, face));
    }
  }

  /// True if no corner lies on a face of the cell.
  bool IsInside(const Corners& corners) const
  {
    const unsigned int all = (1u << this->Frame.NumberOfCorners) - 1u;
    unsigned int common = all;
    for (int corner = 0; corner < corners.Count; ++corner)
    {
      common &= corners.SupportOf(corner);
    }
    return common == all;
  }

  /// Add a tetrahedron with corners in any order. The orientation is corrected.
  void Tetrahedron(const Place& a, const Place& b, const Place& c, const Place& d)
  {
    this->IsLeft(a, b, c, d) ? this->Part(MeshCellType::Tetrahedron, { a, b, c, d })
                             : this->Part(MeshCellType::Tetrahedron, { a, c, b, d });
  }

  bool IsLeft(const Place& a, const Place& b, const Place& c, const Place& d) const
  {
    const auto at = [this](const Place& place) { return CoordinatesOn(this->Shape, place, 1); };
    const glm::dvec3 from = at(a);
    return glm::dot(glm::cross(at(b) - from, at(c) - from), at(d) - from) > 0.0;
  }

  Corners CornersAt(std::initializer_list<Place> places, int unit) const
  {
    Corners corners;
    for (const Place& place : places)
    {
      corners.Add(place * unit, this->AreWhole ? 0 : this->SupportOf(place * unit));
    }
    return corners;
  }

  static Corners FaceOf(const Corners& cell, const std::vector<int>& numbers)
  {
    Corners face;
    for (const int number : numbers)
    {
      face.Add(cell[number], cell.SupportOf(number));
    }
    return face;
  }

  /// A place that sees all faces.
  static Place MiddleOf(MeshCellType type, const Corners& corners)
  {
    Place sum(0);
    for (int corner = 0; corner < corners.Count; ++corner)
    {
      sum += corners[corner];
    }
    // In a pyramid, the middle lies at a third of the height, on the lattice.
    return type == MeshCellType::Pyramid ? ((sum - corners[4]) / 4 * 2 + corners[4]) / 3
                                         : sum / corners.Count;
  }

  unsigned int SupportOf(const Place& place) const
  {
    return SupportOn(this->Shape, place, this->Of);
  }

  /// Number of parts of the cell's edge or face that contains all corners; the inner number if none
  /// does.
  int PartsAt(unsigned int support, bool isEdge) const
  {
    for (std::size_t edge = 0; isEdge && edge < this->EdgeMasks.size(); ++edge)
    {
      if (support == this->EdgeMasks[edge])
      {
        return this->Parts.Edges[edge];
      }
    }
    for (std::size_t face = 0; face < this->FaceMasks.size(); ++face)
    {
      if ((support & ~this->FaceMasks[face]) == 0)
      {
        return this->Parts.Faces[face];
      }
    }
    return this->Parts.Inside;
  }

  /// Number of parts of the edge from a corner to the next one.
  int PartsOfEdge(const Corners& face, int corner) const
  {
    return this->PartsAt(face.SupportOf(corner) | face.SupportOf(face.After(corner)), true);
  }

  int PartsOfFace(const Corners& face) const
  {
    unsigned int support = 0;
    for (int corner = 0; corner < face.Count; ++corner)
    {
      support |= face.SupportOf(corner);
    }
    return this->PartsAt(support, false);
  }

  bool HasWholeEdges(const Corners& face, int parts) const
  {
    int corner = 0;
    while (corner < face.Count && this->PartsOfEdge(face, corner) == parts)
    {
      ++corner;
    }
    return corner == face.Count;
  }

  bool IsWhole(const Corners& face) const
  {
    return this->PartsOfFace(face) == this->Parts.Inside &&
      this->HasWholeEdges(face, this->Parts.Inside);
  }

  /// Add cones over the pieces of a face.
  void Cone(const Corners& face)
  {
    const int parts = this->PartsOfFace(face);
    const int n = parts / this->Parts.Inside;
    const Place right = (face[1] - face[0]) / n;
    const Place up = (face.Count == 4 ? face[3] - face[0] : face[2] - face[0]) / n;
    for (int j = 0; j < n; ++j)
    {
      for (int i = 0; i < (face.Count == 4 ? n : n - j); ++i)
      {
        const Place at = face[0] + i * right + j * up;
        if (face.Count == 4)
        {
          this->Piece(this->CornersAt({ at, at + right, at + right + up, at + up }, 1), parts);
          continue;
        }
        this->Piece(this->CornersAt({ at, at + right, at + up }, 1), parts);
        if (i + j + 2 <= n)
        {
          this->Piece(this->CornersAt({ at + right, at + right + up, at + up }, 1), parts);
        }
      }
    }
  }

  /// Add the cone over a piece of a face or, if its edges are divided further, cones over triangles
  /// around its middle.
  void Piece(const Corners& face, int parts)
  {
    if (this->HasWholeEdges(face, parts))
    {
      this->AddCone(face);
      return;
    }
    Place middle(0);
    for (int corner = 0; corner < face.Count; ++corner)
    {
      middle += face[corner];
    }
    middle /= face.Count;
    for (int corner = 0; corner < face.Count; ++corner)
    {
      const Place& from = face[corner];
      const int n = this->PartsOfEdge(face, corner) / parts;
      const Place step = (face[face.After(corner)] - from) / n;
      for (int i = 0; i < n; ++i)
      {
        this->AddCone(this->CornersAt({ from + i * step, from + (i + 1) * step, middle }, 1));
      }
    }
  }

  /// Add a tetrahedron or pyramid over a base.
  void AddCone(const Corners& base)
  {
    const int last = base.Count - 1;
    const bool isLeft = this->IsLeft(base[0], base[1], base[last], this->Apex);
    Corners corners;
    for (int corner = 0; corner < base.Count; ++corner)
    {
      corners.Add(base[isLeft ? corner : last - corner], 0);
    }
    corners.Add(this->Apex, 0);
    this->To(base.Count == 3 ? MeshCellType::Tetrahedron : MeshCellType::Pyramid, corners);
  }

  CurvedShape Shape;
  const ShapeFrame& Frame;
  const CellParts& Parts;
  bool AreWhole, OnlyCones;
  int Of, Unit;
  Sink& To;
  std::vector<unsigned int> FaceMasks, EdgeMasks;
  Place Apex{ 0 };
};

template <typename Sink>
void Walk<Sink>::Tetrahedra()
{
  const int n = this->Parts.Inside;
  const auto add = [this](const Place& a, const Place& b, const Place& c, const Place& d) {
    this->Part(MeshCellType::Tetrahedron, { a, b, c, d });
  };
  for (int k = 0; k < n; ++k)
  {
    for (int j = 0; j + k < n; ++j)
    {
      for (int i = 0; i + j + k < n; ++i)
      {
        const Place x(i + 1, j, k), y(i, j + 1, k), z(i, j, k + 1);
        const Place yz(i, j + 1, k + 1), xz(i + 1, j, k + 1), xy(i + 1, j + 1, k);
        add(Place(i, j, k), x, y, z);
        if (i + j + k <= n - 2) // an octahedron, around the diagonal from x to yz
        {
          add(x, yz, y, z);
          add(x, yz, z, xz);
          add(x, yz, xz, xy);
          add(x, yz, xy, y);
        }
        if (i + j + k <= n - 3)
        {
          add(xy, yz, xz, Place(i + 1, j + 1, k + 1));
        }
      }
    }
  }
}

template <typename Sink>
void Walk<Sink>::Hexahedra()
{
  const int n = this->Parts.Inside;
  for (int k = 0; k < n; ++k)
  {
    for (int j = 0; j < n; ++j)
    {
      for (int i = 0; i < n; ++i)
      {
        this->Part(MeshCellType::Hexahedron,
          { { i, j, k }, { i + 1, j, k }, { i + 1, j + 1, k }, { i, j + 1, k }, { i, j, k + 1 },
            { i + 1, j, k + 1 }, { i + 1, j + 1, k + 1 }, { i, j + 1, k + 1 } });
      }
    }
  }
}

template <typename Sink>
void Walk<Sink>::Wedges()
{
  const int n = this->Parts.Inside;
  const auto add = [&](int k, const glm::ivec2& a, const glm::ivec2& b, const glm::ivec2& c)
  {
    this->Part(MeshCellType::Wedge,
      { Place(a, k), Place(b, k), Place(c, k), Place(a, k + 1), Place(b, k + 1), Place(c, k + 1) });
  };
  for (int k = 0; k < n; ++k)
  {
    for (int j = 0; j < n; ++j)
    {
      for (int i = 0; i + j < n; ++i)
      {
        add(k, { i, j }, { i + 1, j }, { i, j + 1 });
        if (i + j <= n - 2)
        {
          add(k, { i + 1, j }, { i + 1, j + 1 }, { i, j + 1 });
        }
      }
    }
  }
}

template <typename Sink>
void Walk<Sink>::Pyramids()
{
  const int n = this->Parts.Inside;
  const auto add = [&](int i, int j, int base, const Place& apex)
  {
    const Place x(i + 1, j, base), y(i, j + 1, base);
    const bool isUpright = apex.z > base;
    this->Part(MeshCellType::Pyramid,
      { { i, j, base }, isUpright ? x : y, { i + 1, j + 1, base }, isUpright ? y : x, apex });
  };
  for (int k = 0; k < n; ++k)
  {
    const int m = n - k; // pyramids along an edge of this layer
    for (int j = 0; j < m; ++j)
    {
      for (int i = 0; i < m; ++i)
      {
        const Place apex(i, j, k + 1);
        add(i, j, k, apex);
        if (i + 1 < m && j + 1 < m)
        {
          add(i, j, k + 1, { i + 1, j + 1, k });
        }
        if (i + 1 < m)
        {
          this->Tetrahedron({ i + 1, j, k }, { i + 1, j + 1, k }, apex, { i + 1, j, k + 1 });
        }
        if (j + 1 < m)
        {
          this->Tetrahedron({ i, j + 1, k }, { i + 1, j + 1, k }, apex, { i, j + 1, k + 1 });
        }
      }
    }
  }
}

template <typename Sink>
void WalkOver(CurvedShape shape, const CellParts& parts, bool onlyCones, Sink& sink)
{
  Walk<Sink>(shape, parts, onlyCones, sink).Run();
}

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
