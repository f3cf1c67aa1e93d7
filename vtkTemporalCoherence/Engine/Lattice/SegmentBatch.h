// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_SegmentBatch_h
#define TemporalCoherence_SegmentBatch_h

#include "Scene/RayBatch.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace TemporalCoherence
{

/// Cell segments, as arrays over segments. A cell segment is the part of a ray in one cell. `Real`
/// is the type of computations with samples.
template <typename Real>
struct SegmentBatch
{
  template <typename T>
  using Array = RayBatch::Array<T>;

  int Count = 0;

  /// The rays, in index space. Unused if All is set: segment i then belongs to ray i of that batch.
  std::array<Array<double>, 3> Origin, Direction, Inverse;
  Array<double> Begin, End;
  const RayBatch* All = nullptr;
  /// One bit for each segment to search. The results of other segments are undefined.
  std::uint64_t Wanted = ~std::uint64_t(0);

  std::array<Array<double>, 3> Cell;  ///< its first corner
  std::array<Array<double>, 3> Last;  ///< its last corner; used only by FindCrossingsInBoxes
  std::array<Array<Real>, 8> Corners; ///< differences from the isovalue, [x + 2 y + 4 z]

  Array<double> Enter;    ///< result: t where the ray enters the cell
  Array<double> Distance; ///< result: t of the first crossing; infinity if there is none
  Array<Real> AtEntry;    ///< result: difference from the isovalue where the ray enters the cell

  const double* OriginOf(std::size_t axis) const
  {
    return (this->All ? this->All->Origin : this->Origin)[axis].data();
  }
  const double* DirectionOf(std::size_t axis) const
  {
    return (this->All ? this->All->Direction : this->Direction)[axis].data();
  }
  const double* InverseOf(std::size_t axis) const
  {
    return (this->All ? this->All->Inverse : this->Inverse)[axis].data();
  }
  const double* BeginOf() const { return (this->All ? this->All->Begin : this->Begin).data(); }
  const double* EndOf() const { return (this->All ? this->All->End : this->End).data(); }
};

/// Append the segment of a ray through a cell.
template <typename Real>
void AppendSegment(const RayBatch& rays, std::size_t ray, const glm::ivec3& cell,
  const std::array<Real, 8>& corners, SegmentBatch<Real>& segments)
{
  const auto at = static_cast<std::size_t>(segments.Count++);
  for (std::size_t a = 0; a < 3; ++a)
  {
    segments.Origin[a][at] = rays.Origin[a][ray];
    segments.Direction[a][at] = rays.Direction[a][ray];
    segments.Inverse[a][at] = rays.Inverse[a][ray];
    segments.Cell[a][at] = cell[static_cast<int>(a)];
  }
  segments.Begin[at] = rays.Begin[ray];
  segments.End[at] = rays.End[ray];
  for (std::size_t corner = 0; corner < 8; ++corner)
  {
    segments.Corners[corner][at] = corners[corner];
  }
}

/// Repeat the last segment up to the end of the last vector, so that no lane is uninitialised.
template <typename Real>
void FillLastVector(SegmentBatch<Real>& in)
{
  if (in.Count == RayBatch::Capacity)
  {
    return;
  }
  const auto count = static_cast<std::size_t>(in.Count);
  const std::size_t end = WholeVectors(count);
  const auto fill = [&](auto& array)
  {
    std::fill(array.begin() + static_cast<std::ptrdiff_t>(count),
      array.begin() + static_cast<std::ptrdiff_t>(end), array[count - 1]);
  };
  for (std::size_t a = 0; a < 3; ++a)
  {
    fill(in.Cell[a]);
  }
  for (std::size_t a = 0; a < 3 && !in.All; ++a)
  {
    fill(in.Origin[a]);
    fill(in.Direction[a]);
    fill(in.Inverse[a]);
  }
  if (!in.All)
  {
    fill(in.Begin);
    fill(in.End);
  }
  for (auto& corner : in.Corners)
  {
    fill(corner);
  }
}

}

#endif
