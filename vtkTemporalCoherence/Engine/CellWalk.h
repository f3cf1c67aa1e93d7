// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_CellWalk_h
#define TemporalCoherence_CellWalk_h

#include "ActiveCells.h"
#include "RayBatch.h"

#include <cmath>

namespace TemporalCoherence
{

/// One ray on its way from cell to cell.
///
/// The distance at which the ray passes a plane between cells is always computed from the plane's
/// position, never summed up on the way, so that each cell's part of the ray is the same however
/// the ray got there.
class CellWalk
{
public:
  /// Nowhere, until another walk is assigned.
  CellWalk() {}

  /// Stand in the first cell of a ray's walk.
  CellWalk(const RayBatch& rays, std::size_t ray, const glm::ivec3& cells)
    : Cells(cells)
    , End(rays.WalkEnd[ray])
    , T(rays.WalkBegin[ray])
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const auto a = static_cast<std::size_t>(axis);
      this->Origin[axis] = rays.Origin[a][ray];
      this->Direction[axis] = rays.Direction[a][ray];
      this->Inverse[axis] = rays.Inverse[a][ray];
      this->Ahead[axis] = this->Direction[axis] > 0.0 ? 1 : 0;
    }
    this->Cell = CellAt(rays, ray, this->T, cells);
  }

  /// The cell that a ray is in at t.
  static glm::ivec3 CellAt(const RayBatch& rays, std::size_t ray, double t, const glm::ivec3& cells)
  {
    glm::ivec3 cell;
    for (int axis = 0; axis < 3; ++axis)
    {
      const auto a = static_cast<std::size_t>(axis);
      const double at = rays.Origin[a][ray] + t * rays.Direction[a][ray];
      cell[axis] = Clamp(static_cast<int>(std::floor(at)), 0, cells[axis] - 1);
    }
    return cell;
  }

  /// The cell in which the walk stands.
  const glm::ivec3& Here() const { return this->Cell; }

  /// Go on to the next active cell; the first call may stay where it is.
  /// \return false if the walk ends before
  template <typename T>
  bool FindActive(const ActiveCells& active, const TypedField<T>& samples)
  {
    while (true)
    {
      if (this->InLeaf == 0 && !this->FindActiveLeaf(active, samples))
      {
        return false;
      }
      // Step through the leaf.
      const int leaf = ActiveCells::LeafOf(this->Cell);
      while (true)
      {
        if (this->HasVisited)
        {
          const int exit = this->Step();
          if (exit < 0)
          {
            return false;
          }
          if (ActiveCells::LeafOf(this->Cell) != leaf)
          {
            this->InLeaf = 0;
            if (!this->IsInGrid(exit))
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

  /// Go on to the next cell, active or not; the first call stays where it is.
  /// \return false if the walk ends before
  bool FindAny()
  {
    if (!this->HasVisited)
    {
      this->BeginSteps();
      this->HasVisited = true;
      return true;
    }
    const int exit = this->Step();
    return exit >= 0 && this->IsInGrid(exit);
  }

private:
  /// Distance at which the ray passes plane `plane` of an axis.
  double Pass(int axis, int plane) const
  {
    return (plane - this->Origin[axis]) * this->Inverse[axis];
  }

  /// Leap from block to block until one is an active leaf, and prepare to step through it.
  template <typename T>
  bool FindActiveLeaf(const ActiveCells& active, const TypedField<T>& samples)
  {
    while (true)
    {
      const std::int64_t node = active.NodeOf(this->Cell);
      const std::uint64_t leaves = active.LeavesOf(node);
      if (leaves >> ActiveCells::LeafOf(this->Cell) & 1u)
      {
        this->InLeaf = active.CellsOf(samples, node, this->Cell);
        this->HasVisited = false;
        this->BeginSteps();
        return true;
      }
      if (!this->LeaveBlock(leaves == 0 ? ActiveCells::NodeBits : ActiveCells::LeafBits))
      {
        return false;
      }
    }
  }

  /// Go on behind the aligned block of 2^bits cells that holds the present cell.
  /// \return false if the walk ends before
  bool LeaveBlock(int bits)
  {
    const int size = 1 << bits;
    const glm::ivec3 first = this->Cell & -size;
    const double leave[3] = { this->Pass(0, first.x + this->Ahead.x * size),
      this->Pass(1, first.y + this->Ahead.y * size),
      this->Pass(2, first.z + this->Ahead.z * size) };
    const int exit = FirstOf(leave);
    this->T = leave[exit];
    if (!(this->T < this->End))
    {
      return false;
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      const double at = this->Origin[axis] + this->T * this->Direction[axis];
      this->Cell[axis] = Clamp(static_cast<int>(at), first[axis], first[axis] + size - 1);
    }
    this->Cell[exit] = this->Ahead[exit] ? first[exit] + size : first[exit] - 1;
    return this->IsInGrid(exit);
  }

  /// Prepare for steps from cell to cell.
  void BeginSteps()
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Next[axis] = this->Pass(axis, this->Cell[axis] + this->Ahead[axis]);
    }
  }

  /// Go on to the next cell.
  /// \return the axis along which the ray leaves the present cell, or -1 if the walk ends before
  int Step()
  {
    const int exit = FirstOf(this->Next);
    this->T = this->Next[exit];
    if (!(this->T < this->End))
    {
      return -1;
    }
    const int ahead = this->Ahead[exit];
    const int cell = this->Cell[exit] + 2 * ahead - 1;
    this->Cell[exit] = cell;
    this->Next[exit] = this->Pass(exit, cell + ahead);
    return exit;
  }

  bool IsInGrid(int axis) const
  {
    return static_cast<unsigned>(this->Cell[axis]) < static_cast<unsigned>(this->Cells[axis]);
  }

  static int Clamp(int value, int low, int high)
  {
    value = value < low ? low : value;
    return value > high ? high : value;
  }

  static int FirstOf(const double distances[3])
  {
    const int first = distances[1] < distances[0] ? 1 : 0;
    return distances[2] < distances[first] ? 2 : first;
  }

  glm::ivec3 Cells; ///< number of cells along each axis
  glm::ivec3 Cell;
  glm::ivec3 Ahead; ///< 1 where the ray runs towards higher cells, else 0
  glm::dvec3 Origin, Direction, Inverse;
  double End;
  double T;                 ///< where the walk stands
  double Next[3];           ///< where the ray leaves the present cell along each axis
  std::uint64_t InLeaf = 0; ///< active cells of the leaf stepped through; 0: in none
  bool HasVisited = false;  ///< the present cell is done
};

}

#endif
