// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_BlendRays_h
#define Testing_BlendRays_h

#include "Kinds/RectilinearKind.h"
#include "Scene/GridCoordinates.h"
#include "Scene/HiddenCells.h"
#include "Scene/RayBatch.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

/// A field as tests see it: by formulas in double precision, cell by cell.
template <typename T>
struct PlainField
{
  using Index = glm::ivec3;

  double Plane(int axis, int i) const { return this->Grid ? this->Grid->At(axis, i) : i; }

  /// True if a cell counts.
  bool IsSeen(const Index& cell) const
  {
    bool areFinite = true;
    for (int corner = 0; corner < 8; ++corner)
    {
      areFinite &= std::isfinite(this->Sample(cell, corner));
    }
    return areFinite && !(this->Field.Hidden && this->Field.Hidden->IsHidden(cell));
  }

  double Sample(const Index& cell, int corner) const
  {
    const TemporalCoherence::TypedField<T> samples(this->Field);
    return static_cast<double>(*samples.At(cell + Index(corner & 1, corner >> 1 & 1, corner >> 2)));
  }

  /// The value of a cell at a point of index space.
  double ValueAt(const Index& cell, const glm::dvec3& point) const
  {
    double sum = 0.0, largest = -1.0;
    for (int corner = 0; corner < 8; ++corner)
    {
      double weight = 1.0;
      for (int axis = 0; axis < 3; ++axis)
      {
        const double low = this->Plane(axis, cell[axis]), high = this->Plane(axis, cell[axis] + 1);
        const double share = (point[axis] - low) / (high - low);
        weight *= corner >> axis & 1 ? share : 1.0 - share;
      }
      if (this->Field.Between == TemporalCoherence::Interpolation::Linear)
      {
        sum += weight * this->Sample(cell, corner);
      }
      else if (weight > largest)
      {
        largest = weight;
        sum = this->Sample(cell, corner);
      }
    }
    return sum;
  }

  /// Call visit(cell, enter, leave) for each cell that counts and that a ray is in for a while.
  template <typename Visit>
  void ForEachCell(
    const TemporalCoherence::RayBatch& rays, std::size_t ray, const Visit& visit) const
  {
    const Index count = this->Field.Dimensions - 1;
    for (int number = 0; number < count.x * count.y * count.z; ++number)
    {
      const Index cell(number % count.x, number / count.x % count.y, number / (count.x * count.y));
      double enter = rays.Begin[ray], leave = rays.End[ray];
      for (int axis = 0; axis < 3; ++axis)
      {
        const auto a = static_cast<std::size_t>(axis);
        const double one =
          (this->Plane(axis, cell[axis]) - rays.Origin[a][ray]) * rays.Inverse[a][ray];
        const double two =
          (this->Plane(axis, cell[axis] + 1) - rays.Origin[a][ray]) * rays.Inverse[a][ray];
        enter = std::max(enter, std::min(one, two));
        leave = std::min(leave, std::max(one, two));
      }
      if (enter < leave && this->IsSeen(cell))
      {
        visit(cell, enter, leave);
      }
    }
  }

  /// Where a ray is at t.
  static glm::dvec3 PointOf(const TemporalCoherence::RayBatch& rays, std::size_t ray, double t)
  {
    return { rays.Origin[0][ray] + t * rays.Direction[0][ray],
      rays.Origin[1][ray] + t * rays.Direction[1][ray],
      rays.Origin[2][ray] + t * rays.Direction[2][ray] };
  }

  TemporalCoherence::Field Field;
  const TemporalCoherence::GridCoordinates* Grid = nullptr;
};

#endif
