// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_KernelsCells_h
#define TemporalCoherence_KernelsCells_h

#include "Mesh/CellRays.h"
#include "Mesh/MeshCell.h"

#include <array>
#include <cstddef>
#include <cstdint>

/// All that is decided about a ray and a cell, in vectors of rays.
///
/// What is found depends on the ray and on the cell alone: not on the other rays, and not on the
/// kind of vectors. `differences` are a cell's values minus the isovalue, finite, in the order of
/// MeshCell::Points. Inside is where they are not negative. Coordinates and differences may be as
/// large as 1e90 and, where they are not 0, as small as 1e-90.
namespace TemporalCoherence
{
namespace MeshKernels
{

/// What rays meet in cells.
struct Crossings
{
  /// A ray meets an isovalue at most so often in a cell: three multi-affine equations have no more
  /// single roots.
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

/// A part of a ray in a cell: between which t, and the differences there. Begin and End of the ray
/// do not shorten it.
struct CellSpan
{
  double In, Out, AtIn, AtOut;
};

/// The parts of rays in a cell, by ray. They are ascending.
struct CellSpans
{
  static constexpr std::size_t Most = 3;

  TileArray<std::uint8_t> Count; ///< 0 for rays that were not asked for
  TileArray<std::array<CellSpan, Most>> Spans;
};

/// Parts of rays in a tetrahedron, one after the other: one of a ray at most.
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

/// Append the crossings between Begin and End of rays with a cell.
/// \param which one bit for each ray that is searched
/// \param found has room
/// \pre rays are prepared
void TetrahedronCrossings(const MeshCell& cell, const CellDifferences& differences,
  const MeshRays& rays, std::uint64_t which, Crossings& found);
void HexahedronCrossings(const MeshCell& cell, const CellDifferences& differences,
  const MeshRays& rays, std::uint64_t which, Crossings& found);

/// The same for a cell that was prepared for many batches of rays: its points, or the functions of
/// this cell and these differences.
void TetrahedronCrossings(
  const TetrahedronPoints& points, const MeshRays& rays, std::uint64_t which, Crossings& found);
void HexahedronCrossings(const HexahedronFunctions& functions, const MeshCell& cell,
  const CellDifferences& differences, const MeshRays& rays, std::uint64_t which, Crossings& found);

/// Find the parts of rays in a cell. Cells that share a face have the same bits there.
void TetrahedronSpans(const MeshCell& cell, const CellDifferences& differences,
  const MeshRays& rays, std::uint64_t which, CellSpans& spans);
void HexahedronSpans(const MeshCell& cell, const CellDifferences& differences, const MeshRays& rays,
  std::uint64_t which, CellSpans& spans);

/// Of these, only the parts with differences between `low` and `high` that begin up to limits.
/// \param limits of all rays, to the end of the last vector
void TetrahedronSpansWithin(const TetrahedronPoints& points, const MeshRays& rays,
  std::uint64_t which, double low, double high, const TileArray<double>& limits, SpanList& found);

/// For a cell of any shape: nothing is found in one without.
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
