// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Volumes/Projections/FieldProbe.h"

#include "Lattice/CellRoot.h"
#include "Lattice/CellSamples.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace TemporalCoherence
{
namespace
{

template <typename T>
double ValueIn(const Field& field, const glm::ivec3& cell, const glm::dvec3& at)
{
  const std::array<T, 8> samples = CellSamples<T>(field).Read(cell);
  if (field.Between == Interpolation::Nearest)
  {
    return static_cast<double>(samples[NearestCorner(std::array{ at.x, at.y, at.z })]);
  }
  double sum = 0.0;
  for (std::size_t corner = 0; corner < 8; ++corner)
  {
    const double x = corner & 1 ? at.x : 1.0 - at.x;
    const double y = corner & 2 ? at.y : 1.0 - at.y;
    const double z = corner & 4 ? at.z : 1.0 - at.z;
    sum += x * y * z * static_cast<double>(samples[corner]);
  }
  return sum;
}

}

FieldProbe::FieldProbe(const Field& field, const GridCoordinates* grid)
  : Samples(field)
  , Grid(grid)
{
}

double FieldProbe::At(const RayBatch& rays, std::size_t ray, double t) const
{
  // The point may lie where the ray enters a cell, or the box around a sample. Rounding may move it
  // to the wrong side: look slightly behind it.
  constexpr double indexDistance = 1e-7;
  const double fastest = std::max({ std::abs(rays.Direction[0][ray]),
    std::abs(rays.Direction[1][ray]), std::abs(rays.Direction[2][ray]) });
  const double nudge = indexDistance / fastest;
  const double behind = this->ValueAt(rays, ray, t + nudge);
  // If that cell has samples that are not finite, look slightly before the point.
  return std::isfinite(behind) ? behind : this->ValueAt(rays, ray, t - nudge);
}

double FieldProbe::ValueAt(const RayBatch& rays, std::size_t ray, double t) const
{
  glm::ivec3 cell(0);
  glm::dvec3 at(0.0);
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto a = static_cast<std::size_t>(axis);
    const double last = this->Samples.Dimensions[axis] - 1;
    const double x = std::clamp(rays.Origin[a][ray] + t * rays.Direction[a][ray], 0.0, last);
    cell[axis] =
      this->Grid ? this->Grid->CellOf(axis, x) : static_cast<int>(std::min(x, last - 1.0));
    const double low = this->Grid ? this->Grid->At(axis, cell[axis]) : cell[axis];
    const double high = this->Grid ? this->Grid->At(axis, cell[axis] + 1) : cell[axis] + 1;
    at[axis] = (x - low) / (high - low);
  }
  return DispatchScalarType(this->Samples.Type,
    [&](auto type) { return ValueIn<decltype(type)>(this->Samples, cell, at); });
}

}
