// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_CellWalk_h
#define TemporalCoherence_CellWalk_h

#include "Acceleration/ActiveCells.h"
#include "Scene/RayBatch.h"

#include <hwy/base.h>

#include <algorithm>

namespace TemporalCoherence
{

/// One ray of a batch, in index space.
struct BatchRay
{
  double Origin(int axis) const { return this->Rays.Origin[Index(axis)][this->Ray]; }
  double Direction(int axis) const { return this->Rays.Direction[Index(axis)][this->Ray]; }

  /// Distance at which the ray passes plane `plane` of an axis. Always computed from the plane's
  /// position, never by adding steps: a cell's segment does not depend on the cells visited before.
  double Pass(int axis, int plane) const
  {
    return (plane - this->Origin(axis)) * this->Rays.Inverse[Index(axis)][this->Ray];
  }

  /// Coordinate of the cell that the ray is in at t, clamped to low .. high.
  int CellAt(int axis, double t, int low, int high) const
  {
    // From very far away a point may be rounded to anywhere, so it is clamped before it is
    // converted. Truncation rounds down here, as the value is not negative.
    const double x = this->Origin(axis) + t * this->Direction(axis);
    return !(x > low) ? low : (x < high ? static_cast<int>(x) : high);
  }

  /// Coordinate of the cell in which a walk begins, found by the distances of planes. The position
  /// alone is not enough: it may be rounded across a plane that the ray, almost parallel to it,
  /// passes much later.
  int WalkFrom(int axis, double t, int cells) const
  {
    const int cell = this->CellAt(axis, t, 0, cells - 1);
    const double direction = this->Direction(axis);
    const int before = direction > 0.0 ? cell - 1 : cell + 1;
    const bool isAhead = direction != 0.0 && this->Pass(axis, std::max(cell, before)) > t;
    return isAhead && before >= 0 && before < cells ? before : cell;
  }

  /// The ray's cell at t, clamped to a field of `cells` cells along each axis.
  glm::ivec3 CellAt(double t, const glm::ivec3& cells) const
  {
    return { this->CellAt(0, t, 0, cells.x - 1), this->CellAt(1, t, 0, cells.y - 1),
      this->CellAt(2, t, 0, cells.z - 1) };
  }

  double WalkEnd() const { return this->Rays.WalkEnd[this->Ray]; }

  static std::size_t Index(int axis) { return static_cast<std::size_t>(axis); }

  const RayBatch& Rays;
  std::size_t Ray;
};

/// A filter that skips no active cell. The walk visits all active cells, like KernelsWalk.
struct TakeAll
{
  bool IsNodeOfUse(std::int64_t) const { return true; }
  bool IsLeafOfUse(std::int64_t, int) const { return true; }
};

/// The walk of a ray from cell to cell. The ray is a BatchRay, or a RectilinearRay if cells differ
/// in size.
class CellWalk
{
public:
  /// Nowhere, until Begin is called.
  CellWalk() {}

  /// Go to the first cell of a ray's walk.
  template <typename WalkingRay>
  void Begin(const WalkingRay& ray, const glm::ivec3& cells)
  {
    const double begin = ray.Rays.WalkBegin[ray.Ray];
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Cell[axis] = ray.WalkFrom(axis, begin, cells[axis]);
      this->Ahead[axis] = ray.Direction(axis) > 0.0 ? 1 : 0;
    }
    this->InLeaf = 0;
    this->HasVisited = false;
  }

  /// The present cell.
  const glm::ivec3& Here() const { return this->Cell; }

  /// Go on to the next active cell. The first call may stay in the present cell.
  /// \param filter has IsNodeOfUse(node) and IsLeafOfUse(node, leaf), which return false for blocks
  ///               to skip
  /// \return false if the walk ends first
  template <typename WalkingRay, typename T, typename Filter = TakeAll>
  HWY_INLINE bool FindActive(const WalkingRay& ray, const ActiveCells& active,
    const TypedField<T>& samples, const Filter& filter = {})
  {
    while (true)
    {
      if (this->InLeaf == 0 && !this->FindActiveLeaf(ray, active, samples, filter))
      {
        return false;
      }
      // Step through the leaf.
      const int leaf = ActiveCells::LeafOf(this->Cell);
      while (true)
      {
        if (this->HasVisited)
        {
          const int exit = this->Step(ray);
          if (exit < 0)
          {
            return false;
          }
          if (ActiveCells::LeafOf(this->Cell) != leaf)
          {
            this->InLeaf = 0;
            if (!IsWithin(this->Cell[exit], samples.Dimensions[exit] - 1))
            {
              return false;
            }
            break;
          }
        }
        this->HasVisited = true;
        if (this->InLeaf >> ActiveCells::BitOf(this->Cell) & 1u)
        {
          return true;
        }
      }
    }
  }

  /// Go on to the next cell, active or not. The first call stays in the present cell.
  /// \return false if the walk ends first
  template <typename WalkingRay>
  bool FindAny(const WalkingRay& ray, const glm::ivec3& cells)
  {
    if (!this->HasVisited)
    {
      this->BeginSteps(ray);
      this->HasVisited = true;
      return true;
    }
    const int exit = this->Step(ray);
    return exit >= 0 && IsWithin(this->Cell[exit], cells[exit]);
  }

private:
  /// Leap from block to block until one is an active leaf, and prepare to step through it.
  template <typename WalkingRay, typename T, typename Filter>
  HWY_INLINE bool FindActiveLeaf(const WalkingRay& ray, const ActiveCells& active,
    const TypedField<T>& samples, const Filter& filter)
  {
    while (true)
    {
      const std::int64_t node = active.NodeOf(this->Cell);
      const std::uint64_t leaves = active.LeavesOf(node);
      const int leaf = ActiveCells::LeafOf(this->Cell);
      if ((leaves >> leaf & 1u) && filter.IsLeafOfUse(node, leaf))
      {
        this->InLeaf = active.CellsOf(samples, node, this->Cell);
        this->HasVisited = false;
        this->BeginSteps(ray);
        return true;
      }
      const bool isEmpty = leaves == 0 || !filter.IsNodeOfUse(node);
      const int bits = isEmpty ? ActiveCells::NodeBits : ActiveCells::LeafBits;
      if (!this->LeaveBlock(ray, bits, samples.Dimensions - 1))
      {
        return false;
      }
    }
  }

  /// Leave the aligned block of 2^bits cells along each axis that holds the present cell.
  /// \return false if the walk ends first
  template <typename WalkingRay>
  HWY_INLINE bool LeaveBlock(const WalkingRay& ray, int bits, const glm::ivec3& cells)
  {
    const int size = 1 << bits;
    const glm::ivec3 first = this->Cell & -size;
    const double leave[3] = { ray.Pass(0, first.x + this->Ahead[0] * size),
      ray.Pass(1, first.y + this->Ahead[1] * size), ray.Pass(2, first.z + this->Ahead[2] * size) };
    const int exit = FirstOf(leave);
    const double t = leave[exit];
    if (!(t < ray.WalkEnd()))
    {
      return false;
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Cell[axis] = this->Land(ray, axis, exit, t, { first[axis], first[axis] + size - 1 });
    }
    this->Cell[exit] = this->Ahead[exit] ? first[exit] + size : first[exit] - 1;
    return IsWithin(this->Cell[exit], cells[exit]);
  }

  /// The cell along an axis that steps from cell to cell would have reached when they leave a block
  /// along axis `exit` at t. The position alone may be rounded across a plane that the ray passes
  /// earlier or later.
  /// \param ends lowest and highest cell of the block along the axis
  template <typename WalkingRay>
  HWY_INLINE int Land(
    const WalkingRay& ray, int axis, int exit, double t, const glm::ivec2& ends) const
  {
    const int ahead = this->Ahead[axis], step = 2 * ahead - 1;
    const int first = ahead ? ends.x : ends.y, last = ahead ? ends.y : ends.x;
    const int cell = ray.CellAt(axis, t, ends.x, ends.y);
    const double enter = ray.Pass(axis, cell + 1 - ahead), leave = ray.Pass(axis, cell + ahead);
    // If planes are passed at the same t, the plane of the lowest axis comes first.
    if (cell != first && (axis > exit ? enter >= t : enter > t))
    {
      return cell - step;
    }
    return cell != last && (axis < exit ? leave <= t : leave < t) ? cell + step : cell;
  }

  /// Prepare to step from cell to cell.
  template <typename WalkingRay>
  void BeginSteps(const WalkingRay& ray)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Next[axis] = ray.Pass(axis, this->Cell[axis] + this->Ahead[axis]);
    }
  }

  /// Go on to the next cell.
  /// \return the axis along which the ray leaves the present cell, or -1 if the walk ends first
  template <typename WalkingRay>
  HWY_INLINE int Step(const WalkingRay& ray)
  {
    const int exit = FirstOf(this->Next);
    if (!(this->Next[exit] < ray.WalkEnd()))
    {
      return -1;
    }
    const int ahead = this->Ahead[exit];
    const int cell = this->Cell[exit] + 2 * ahead - 1;
    this->Cell[exit] = cell;
    this->Next[exit] = ray.Pass(exit, cell + ahead);
    return exit;
  }

  static bool IsWithin(int cell, int cells)
  {
    return static_cast<unsigned>(cell) < static_cast<unsigned>(cells);
  }

  static int FirstOf(const double distances[3])
  {
    const int first = distances[1] < distances[0] ? 1 : 0;
    return distances[2] < distances[first] ? 2 : first;
  }

  glm::ivec3 Cell;
  glm::ivec3 Ahead;     ///< 1 if the ray runs towards higher cells, else 0
  bool HasVisited;      ///< the present cell is done
  std::uint64_t InLeaf; ///< active cells of the present leaf; 0 outside of active leaves
  double Next[3];       ///< where the ray leaves the present cell along each axis
};

/// The walking rays of a batch.
struct LiveRays
{
  /// Begin the walks of the wanted rays that have one.
  /// \param shape of the cells: has RayOf(rays, ray), for CellWalk
  template <typename Geometry, typename IsWanted>
  void Begin(
    const RayBatch& rays, const Geometry& shape, const glm::ivec3& cells, const IsWanted& isWanted)
  {
    for (std::size_t ray = 0; ray < static_cast<std::size_t>(rays.Count); ++ray)
    {
      if (rays.HasWalk(ray) && isWanted(ray))
      {
        this->Walks[ray].Begin(shape.RayOf(rays, ray), cells);
        this->Rays[this->Count++] = ray;
      }
    }
  }

  /// Drop the rays for which `keeps` is false.
  template <typename Keeps>
  HWY_INLINE void Keep(const Keeps& keeps)
  {
    std::size_t left = 0;
    for (std::size_t i = 0; i < this->Count; ++i)
    {
      const std::size_t ray = this->Rays[i];
      if (keeps(ray))
      {
        this->Rays[left++] = ray;
      }
    }
    this->Count = left;
  }

  std::array<CellWalk, RayBatch::Capacity> Walks;   ///< of each ray of the batch
  std::array<std::size_t, RayBatch::Capacity> Rays; ///< the walking rays
  std::size_t Count = 0;
};

}

#endif
