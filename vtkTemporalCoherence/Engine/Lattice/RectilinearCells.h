// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_RectilinearCells_h
#define TemporalCoherence_RectilinearCells_h

#include "Lattice/CellRoot.h"
#include "Scene/GridCoordinates.h"
#include "Scene/HiddenCells.h"
#include "Scene/RayBatch.h"

#include <hwy/base.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

namespace TemporalCoherence
{

/// One ray of a batch in a rectilinear field, for CellWalk: the counterpart of BatchRay.
struct RectilinearRay
{
  double Origin(int axis) const { return this->Rays.Origin[Index(axis)][this->Ray]; }
  double Direction(int axis) const { return this->Rays.Direction[Index(axis)][this->Ray]; }

  /// Distance at which the ray passes a coordinate of an axis.
  HWY_INLINE double PassAt(int axis, double coordinate) const
  {
    return (coordinate - this->Origin(axis)) * this->Rays.Inverse[Index(axis)][this->Ray];
  }

  /// Distance at which the ray passes plane `plane` of an axis, always computed from the coordinate
  /// of the plane. Planes beyond the last one are taken to lie at it.
  HWY_INLINE double Pass(int axis, int plane) const
  {
    return this->PassAt(axis, this->Grid.At(axis, plane));
  }

  /// The ray's cell at t, from low to high: the ray has passed its first plane, but not its second.
  /// Comparing t with planes, instead of rounding a point, misses no cell.
  int CellAt(int axis, double t, int low, int high) const
  {
    const bool isAscending = this->Direction(axis) > 0.0;
    high = std::min(high, static_cast<int>(this->Grid.Of(axis).size()) - 2);
    while (low < high)
    {
      const int middle = low + (high - low + 1) / 2;
      const bool isBehind = (this->Pass(axis, middle) <= t) == isAscending;
      (isBehind ? low : high) = isBehind ? middle : middle - 1;
    }
    return low;
  }

  /// Coordinate of the cell in which a walk begins.
  int WalkFrom(int axis, double t, int cells) const { return this->CellAt(axis, t, 0, cells - 1); }

  glm::ivec3 CellAt(double t, const glm::ivec3& cells) const
  {
    return { this->CellAt(0, t, 0, cells.x - 1), this->CellAt(1, t, 0, cells.y - 1),
      this->CellAt(2, t, 0, cells.z - 1) };
  }

  double WalkEnd() const { return this->Rays.WalkEnd[this->Ray]; }

  static std::size_t Index(int axis) { return static_cast<std::size_t>(axis); }

  const RayBatch& Rays;
  std::size_t Ray;
  const GridCoordinates& Grid;
};

/// The segment of a ray in one cell of a rectilinear field: where it enters and leaves, and the
/// path between in the cell's own coordinates (CellSegment.h).
struct RectilinearSegment
{
  RectilinearSegment(const RectilinearRay& ray, const glm::ivec3& cell)
    : Enter(ray.Rays.Begin[ray.Ray])
    , Leave(ray.Rays.End[ray.Ray])
  {
    std::array<double, 3> enter, leave;
    for (int axis = 0; axis < 3; ++axis)
    {
      const auto a = static_cast<std::size_t>(axis);
      const int ahead = ray.Direction(axis) > 0.0 ? 1 : 0;
      enter[a] = ray.Pass(axis, cell[axis] + 1 - ahead);
      leave[a] = ray.Pass(axis, cell[axis] + ahead);
      this->Enter = std::max(this->Enter, enter[a]);
      this->Leave = std::min(this->Leave, leave[a]);
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      const auto a = static_cast<std::size_t>(axis);
      const double low = ray.Grid.At(axis, cell[axis]), high = ray.Grid.At(axis, cell[axis] + 1);
      const double ahead = ray.Direction(axis) > 0.0 ? 1.0 : 0.0;
      // On a face the coordinate is exactly 0 or 1, as the neighbour across the face has it.
      const auto at = [&](double t)
      {
        const double x = ray.Origin(axis) + t * ray.Direction(axis);
        return std::min(std::max((x - low) / (high - low), 0.0), 1.0);
      };
      this->Path.Begin[a] = this->Enter == enter[a] ? 1.0 - ahead : at(this->Enter);
      this->Path.End[a] = this->Leave == leave[a] ? ahead : at(this->Leave);
      this->Middle[a] = ray.PassAt(axis, 0.5 * (low + high));
    }
  }

  /// True if the ray does more than touch the cell.
  bool HasLength() const { return this->Enter < this->Leave; }

  /// t at a share of the path; infinity if the ray only touches the cell.
  double DistanceAt(double share) const
  {
    return this->HasLength() ? this->Enter + share * (this->Leave - this->Enter)
                             : std::numeric_limits<double>::infinity();
  }

  /// The nearest samples along the path.
  /// \pre it has length
  NearestPath Nearest() const
  {
    std::array<double, 3> midway;
    for (std::size_t a = 0; a < 3; ++a)
    {
      midway[a] = (this->Middle[a] - this->Enter) / (this->Leave - this->Enter);
    }
    return FindNearestPath(this->Path, midway);
  }

  double Enter, Leave;
  CellPath<double> Path;
  std::array<double, 3> Middle; ///< t at which the ray passes the middle of the cell, by axis
};

/// True if a ray comes from a hidden cell.
/// \param enter t where it enters `cell`
/// \pre the ray does more than touch it
inline bool ComesFromHidden(
  const RectilinearRay& ray, const glm::ivec3& cell, double enter, const HiddenCells& hidden)
{
  // Through an edge or a corner the ray comes from the opposite cell.
  glm::ivec3 before = cell;
  for (int axis = 0; axis < 3; ++axis)
  {
    const int ahead = ray.Direction(axis) > 0.0 ? 1 : 0;
    const bool isEntry = ray.Pass(axis, cell[axis] + 1 - ahead) == enter;
    before[axis] += isEntry ? 1 - 2 * ahead : 0;
  }
  return hidden.IsHidden(before);
}

/// The geometry of the cells of a rectilinear field, for CellTracer.
template <typename T>
struct RectilinearCells
{
  using Value = double;
  using Real = double;
  static constexpr bool HasKernels = false;

  explicit RectilinearCells(const GridCoordinates& grid)
    : Grid(grid)
  {
  }

  RectilinearRay RayOf(const RayBatch& rays, std::size_t ray) const
  {
    return { rays, ray, this->Grid };
  }

  /// The segment of a ray in one cell.
  struct Segment
  {
    Segment(const RectilinearRay& ray, const glm::ivec3& cell)
      : Line(ray)
      , Cell(cell)
      , Inner(ray, cell)
    {
    }

    bool HasLength() const { return this->Inner.HasLength(); }
    double Enter() const { return this->Inner.Enter; }
    double Leave() const { return this->Inner.Leave; }
    double DistanceAt(double share) const { return this->Inner.DistanceAt(share); }
    const CellPath<double>& Path() const { return this->Inner.Path; }
    NearestPath Nearest() const { return this->Inner.Nearest(); }
    bool ComesFrom(const HiddenCells& hidden) const
    {
      return this->HasLength() && ComesFromHidden(this->Line, this->Cell, this->Enter(), hidden);
    }

  private:
    RectilinearRay Line;
    glm::ivec3 Cell;
    RectilinearSegment Inner;
  };

  const GridCoordinates& Grid;
};

}

#endif
