// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_KernelsCells_h
#define TemporalCoherence_KernelsCells_h

#include "Mesh/Cells/CellRays.h"
#include "Mesh/Cells/MeshCell.h"

#include <array>
#include <cstddef>
#include <cstdint>

/// Intersects rays with cells, in vectors of rays.
///
/// A result depends only on the ray and the cell, neither on other rays nor on the SIMD target.
/// `differences` are a cell's values minus the isovalue, finite, in the order of MeshCell::Points.
/// Points with a difference of at least 0 are inside. Coordinates and differences may be as large
/// as 1e90 and, where they are not 0, as small as 1e-90.
namespace TemporalCoherence
{
namespace MeshKernels
{

/// Crossings of rays with an isosurface in cells.
struct Crossings
{
  /// Most crossings of a ray with an isovalue in one cell: three multi-affine equations have no
  /// more single roots.
  static constexpr std::size_t MostInCell = 6;
  static constexpr std::size_t Capacity = 2 * MostInCell * MeshRays::Capacity;

  std::size_t Count = 0;
  std::array<std::uint8_t, Capacity> Ray;
  std::array<double, Capacity> T;
  std::array<bool, Capacity> Rises; ///< from outside to inside

  void Append(std::size_t ray, double t, bool rises)
  {
    this->Ray[this->Count] = static_cast<std::uint8_t>(ray);
    this->T[this->Count] = t;
    this->Rises[this->Count] = rises;
    ++this->Count;
  }
};

/// Interval of t along a ray inside of a cell, with the differences at both ends. It is not clipped
/// to Begin and End of the ray.
struct CellSpan
{
  double In, Out, AtIn, AtOut;
};

/// Spans of rays in a cell, by ray, ascending.
struct CellSpans
{
  static constexpr std::size_t Most = 3;

  TileArray<std::uint8_t> Count; ///< 0 for rays that were not searched
  TileArray<std::array<CellSpan, Most>> Spans;
};

/// Spans of rays in a tetrahedron, as one list with at most one span for each ray.
struct SpanList
{
  static constexpr std::size_t Capacity = MeshRays::Capacity + WidestVector;

  std::size_t Count = 0;
  std::array<std::uint8_t, Capacity> Ray;
  std::array<double, Capacity> In, Out, AtIn, AtOut;
};

using CellDifferences = std::array<double, 8>;
struct HexahedronFunctions;
struct TetrahedronPoints;

/// Append the crossings of rays in a cell, between Begin and End.
/// \param which one bit for each ray that is searched
/// \param found has room
/// \pre rays are prepared
void TetrahedronCrossings(const MeshCell& cell, const CellDifferences& differences,
  const MeshRays& rays, std::uint64_t which, Crossings& found);
void HexahedronCrossings(const MeshCell& cell, const CellDifferences& differences,
  const MeshRays& rays, std::uint64_t which, Crossings& found);

/// Append the crossings in a cell that was prepared for many batches of rays: from sorted points,
/// or from functions made from this cell and these differences.
void TetrahedronCrossings(
  const TetrahedronPoints& points, const MeshRays& rays, std::uint64_t which, Crossings& found);
void HexahedronCrossings(const HexahedronFunctions& functions, const MeshCell& cell,
  const CellDifferences& differences, const MeshRays& rays, std::uint64_t which, Crossings& found);

/// Find the spans of rays in a cell. Cells that share a face find bit-identical ends there.
void TetrahedronSpans(const MeshCell& cell, const CellDifferences& differences,
  const MeshRays& rays, std::uint64_t which, CellSpans& spans);
void HexahedronSpans(const MeshCell& cell, const CellDifferences& differences, const MeshRays& rays,
  std::uint64_t which, CellSpans& spans);

/// Find the spans that hold differences between `low` and `high`, and begin up to their ray's
/// limit.
/// \param limits of all rays, to the end of the last vector
void TetrahedronSpansWithin(const TetrahedronPoints& points, const MeshRays& rays,
  std::uint64_t which, double low, double high, const TileArray<double>& limits, SpanList& found);

/// Crossings in a cell of any shape; none in a cell of shape None.
inline void CellCrossings(const MeshCell& cell, const CellDifferences& differences,
  const MeshRays& rays, std::uint64_t which, Crossings& found)
{
  if (cell.Shape == MeshCellShape::Tetrahedron)
  {
    TetrahedronCrossings(cell, differences, rays, which, found);
  }
  else if (cell.Shape == MeshCellShape::Hexahedron)
  {
    HexahedronCrossings(cell, differences, rays, which, found);
  }
}

inline void FindCellSpans(const MeshCell& cell, const CellDifferences& differences,
  const MeshRays& rays, std::uint64_t which, CellSpans& spans)
{
  if (cell.Shape == MeshCellShape::Tetrahedron)
  {
    TetrahedronSpans(cell, differences, rays, which, spans);
  }
  else if (cell.Shape == MeshCellShape::Hexahedron)
  {
    HexahedronSpans(cell, differences, rays, which, spans);
  }
  else
  {
    spans.Count.fill(0);
  }
}

}
}

#endif
