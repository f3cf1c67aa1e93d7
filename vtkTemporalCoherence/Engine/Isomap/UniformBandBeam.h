// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_UniformBandBeam_h
#define TemporalCoherence_UniformBandBeam_h

#include "Isomap/BandBeam.h"
#include "Isomap/BandProgress.h"
#include "Lattice/CellWalk.h"
#include "Lattice/KernelsBeam.h"
#include "Lattice/UniformCells.h"

#include <algorithm>
#include <limits>

namespace TemporalCoherence
{

/// True if the walk of a ray goes through a cell: CellWalk's answer, computed without walking. Of
/// planes passed at one t, the plane of the lowest axis comes first.
inline bool IsOnWalk(const BatchRay& ray, const glm::ivec3& cell, const glm::ivec3& cells)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  double enter[3], leave[3];
  double last = -infinity;
  for (int axis = 0; axis < 3; ++axis)
  {
    const int first = ray.WalkFrom(axis, ray.Rays.WalkBegin[ray.Ray], cells[axis]);
    const int ahead = ray.Direction(axis) > 0.0 ? 1 : 0;
    const int steps = ahead ? cell[axis] - first : first - cell[axis];
    if (steps < 0)
    {
      return false;
    }
    enter[axis] = steps > 0 ? ray.Pass(axis, cell[axis] + 1 - ahead) : -infinity;
    leave[axis] = ray.Pass(axis, cell[axis] + ahead);
    last = std::max(last, enter[axis]);
  }
  bool isInOrder = last < ray.WalkEnd();
  for (int a = 0; a < 3; ++a)
  {
    for (int b = 0; b < 3; ++b)
    {
      isInOrder &= a == b || (a < b ? enter[a] <= leave[b] : enter[a] < leave[b]);
    }
  }
  return isInOrder;
}

/// Takes the rays of a tile through a band as a beam, in an image without hidden cells.
///
/// The beam only skips cells that a ray does not pass or that cannot raise its progress. Other
/// cells are searched and noted as on a walk.
template <typename T>
class UniformBandBeam final : private BandBeamScene<RealOf<T>>
{
public:
  using Cells = BandCells<T, UniformCells<T>>;
  using Progress = BandProgress<T, UniformCells<T>, Interpolation::Linear>;
  using Real = RealOf<T>;

  UniformBandBeam(const Cells& cells, const RayBatch& rays, Progress& progress)
    : Band(cells)
    , Rays(rays)
    , Found(progress)
  {
  }

  /// Take some rays through the band, one bit each.
  /// \return false if they must walk
  bool Trace(std::uint64_t wanted)
  {
    TileBeam beam;
    if (!SetUpBeam(this->Rays, wanted, this->Band.Count, beam) || !beam.AreAlike)
    {
      return false;
    }
    SearchBand(*this->Band.Scene.Active, this->Rays, *this, beam);
    this->Found.CellsRead += beam.CellsPassed;
    return true;
  }

private:
  std::uint64_t CellsOf(std::int64_t node, const glm::ivec3& cell) const override
  {
    return this->Band.Scene.Active->CellsOf(this->Band.Samples.All(), node, cell);
  }

  const Real* ReachedIn(std::size_t direction) const override
  {
    return this->Found.ReachedIn(direction).data();
  }

  void Read(const glm::ivec3* places, std::size_t count, BandCell<Real>* cells) override
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      BandCell<Real>& cell = cells[i];
      cell.Place = places[i];
      cell.Reach = this->Band.Read(cell.Place, cell.Samples);
    }
  }

  bool TakeNote(const BandCell<Real>& cell, const CellStays<Real>& at, TileBeam& beam) override
  {
    const RangesView<Real> ranges{ at.Enter.data(), at.Leave.data(), at.Lowest.data(),
      at.Highest.data(),
      { at.Cubic[0].data(), at.Cubic[1].data(), at.Cubic[2].data(), at.Cubic[3].data() } };
    bool isDone = false;
    for (std::uint64_t left = at.Which; left != 0; left &= left - 1)
    {
      const std::size_t i = hwy::Num0BitsBelowLS1Bit_Nonzero64(left), ray = at.First + i;
      if ((at.IsOnWalk >> i & 1u) || IsOnWalk({ this->Rays, ray }, cell.Place, this->Band.Count))
      {
        this->Found.TakeNote(ray, cell.Place, cell.Reach, ranges, i);
        if (this->Found.IsDone(ray))
        {
          const float behind = beam.DistanceOf(at.Leave[i]) + beam.Margin;
          beam.Behind[ray] = std::min(beam.Behind[ray], behind);
          isDone = true;
        }
      }
    }
    if (this->Found.IsTooLarge())
    {
      beam.Behind.fill(-TileBeam::Never);
      isDone = true;
    }
    return isDone;
  }

  const Cells& Band;
  const RayBatch& Rays;
  Progress& Found;
};

}

#endif
