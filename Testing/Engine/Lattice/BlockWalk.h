// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_BlockWalk_h
#define Testing_BlockWalk_h

#include "Acceleration/ActiveCells.h"
#include "Lattice/CellWalk.h"

#include <algorithm>

namespace TemporalCoherence
{

/// Takes a ray from active leaf to active leaf. For kinds of fields whose leaves are cubes of index
/// space and that search a block by themselves.
///
/// Where the ray enters and leaves a leaf depends on ray and leaf alone, not on where the walk
/// began. So does the surface found there.
class BlockWalk
{
public:
  /// \param cells  of the field, along each axis
  /// \param active null: all leaves
  BlockWalk(
    const RayBatch& rays, std::size_t ray, const glm::ivec3& cells, const ActiveCells* active)
    : Line{ rays, ray }
    , Last((cells - 1) >> ActiveCells::LeafBits)
    , Active(active)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const int cell = this->Line.WalkFrom(axis, rays.WalkBegin[ray], cells[axis]);
      this->Leaf[axis] = cell >> ActiveCells::LeafBits;
      this->Ahead[axis] = this->Line.Direction(axis) > 0.0 ? 1 : 0;
    }
  }

  /// Go on to the next active leaf; the first time the walk may stay where it begins.
  /// \return false if the walk ends first
  bool Next()
  {
    while (!this->HasBegun || this->Step())
    {
      this->HasBegun = true;
      if (this->IsActive())
      {
        return true;
      }
    }
    return false;
  }

  /// Where the ray enters and leaves the leaf, between its Begin and its End.
  double Enter() const
  {
    double t = this->Line.Rays.Begin[this->Line.Ray];
    for (int axis = 0; axis < 3; ++axis)
    {
      t = std::max(t, this->Pass(axis, 1 - this->Ahead[axis]));
    }
    return t;
  }
  double Leave() const
  {
    double t = this->Line.Rays.End[this->Line.Ray];
    for (int axis = 0; axis < 3; ++axis)
    {
      t = std::min(t, this->Pass(axis, this->Ahead[axis]));
    }
    return t;
  }

private:
  /// t at the lower (0) or upper (1) plane of the leaf.
  double Pass(int axis, int side) const
  {
    return this->Line.Pass(axis, (this->Leaf[axis] + side) * ActiveCells::LeafSize);
  }

  bool IsActive() const
  {
    const glm::ivec3 cell = this->Leaf * ActiveCells::LeafSize;
    return !this->Active ||
      (this->Active->LeavesOf(this->Active->NodeOf(cell)) >> ActiveCells::LeafOf(cell) & 1u);
  }

  bool Step()
  {
    int exit = 0;
    for (int axis = 1; axis < 3; ++axis)
    {
      exit =
        this->Pass(axis, this->Ahead[axis]) < this->Pass(exit, this->Ahead[exit]) ? axis : exit;
    }
    if (!(this->Pass(exit, this->Ahead[exit]) < this->Line.WalkEnd()))
    {
      return false;
    }
    this->Leaf[exit] += 2 * this->Ahead[exit] - 1;
    return this->Leaf[exit] >= 0 && this->Leaf[exit] <= this->Last[exit];
  }

  BatchRay Line;
  glm::ivec3 Leaf; ///< counted in leaves
  glm::ivec3 Last; ///< the highest leaf along each axis
  glm::ivec3 Ahead;
  const ActiveCells* Active;
  bool HasBegun = false;
};

}

#endif
