// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_KernelsKnownTetrahedra_h
#define TemporalCoherence_KernelsKnownTetrahedra_h

#include "Mesh/Cells/KernelsCells.h"
#include "Mesh/Cells/TetrahedronPoints.h"
#include "Scene/LayerBatch.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace TemporalCoherence
{
namespace MeshKernels
{

/// Tetrahedra as arrays over cells, in the order of their points in the mesh.
struct TetrahedronLanes
{
  static constexpr std::size_t Capacity = 64;

  std::size_t Count = 0;
  std::array<std::array<TileArray<double>, 4>, 4> Numbers; ///< by point: x, y, z and the value

  void Append(const MeshCell& cell)
  {
    for (std::size_t point = 0; point < 4; ++point)
    {
      for (int a = 0; a < 3; ++a)
      {
        this->Numbers[point][static_cast<std::size_t>(a)][this->Count] = cell.Points[point][a];
      }
      this->Numbers[point][3][this->Count] = cell.Values[point];
    }
    ++this->Count;
  }

  MeshCell CellAt(std::size_t i) const
  {
    MeshCell cell;
    cell.Shape = MeshCellShape::Tetrahedron;
    for (std::size_t point = 0; point < 4; ++point)
    {
      const auto& numbers = this->Numbers[point];
      cell.Points[point] = { numbers[0][i], numbers[1][i], numbers[2][i] };
      cell.Values[point] = numbers[3][i];
    }
    return cell;
  }

  /// Repeat the last cell up to the end of the last vector, so that no lane is uninitialised.
  void FillUp()
  {
    for (auto& numbers : this->Numbers)
    {
      for (TileArray<double>& each : numbers)
      {
        for (std::size_t i = this->Count; i > 0 && i < WholeVectors(this->Count); ++i)
        {
          each[i] = each[i - 1];
        }
      }
    }
  }
};

/// Tetrahedra in the order of TetrahedronPoints, by cell or by ray.
struct SortedTetrahedra
{
  using Corner = std::array<double, 4>; ///< x, y, z and the difference

  // By corner, so that vectors are loaded without gathering.
  std::array<TileArray<Corner>, 4> Corners;
  TileArray<double> Handedness;

  void Set(std::size_t at, const TetrahedronPoints& points)
  {
    for (std::size_t corner = 0; corner < 4; ++corner)
    {
      const glm::dvec3& point = points.Points[corner];
      this->Corners[corner][at] = { point.x, point.y, point.z, points.Values[corner] };
    }
    this->Handedness[at] = points.Handedness;
  }
};

/// Crossings of rays, each in the cell of its ray.
struct KnownCrossings
{
  std::uint64_t Met = 0;    ///< one bit for each ray with a crossing
  std::uint64_t Rising = 0; ///< one bit for each ray that comes from outside
  std::uint64_t AtEnds = 0; ///< one bit for each ray that crosses where it leaves the cell
  TileArray<double> T;      ///< of rays with a crossing
};

/// Find the crossings of rays in their cells between Begin and End, bit-identical to
/// TetrahedronCrossings. Faster than this function if few rays share a cell.
/// \param cells which rays are searched in each of the first `count` tetrahedra, one bit each
/// \pre rays are prepared; no ray has two cells
void FindKnownCrossings(const SortedTetrahedra& tetrahedra, const TileArray<std::uint64_t>& cells,
  std::size_t count, const MeshRays& rays, KnownCrossings& found);

}
}

#endif
