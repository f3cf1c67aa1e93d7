// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Isomap/UniformBandTracer.h"

#include "Isomap/BandBeam.h"
#include "Isomap/BandProgress.h"
#include "Isomap/CellBandTracer.h"
#include "Lattice/BeamChoice.h"
#include "Lattice/CellWalk.h"
#include "Lattice/KernelsBeam.h"
#include "Lattice/UniformCells.h"

#include <algorithm>
#include <limits>
#include <memory>

namespace TemporalCoherence
{
namespace
{

/// True if the walk of a ray goes through a cell: CellWalk's answer, computed without walking. If
/// planes are passed at one t, the plane of the lowest axis comes first.
bool IsOnWalk(const BatchRay& ray, const glm::ivec3& cell, const glm::ivec3& cells)
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

/// CellBandTracer that takes the rays of a tile as a beam where this is faster.
template <typename T>
class UniformBandTracer final : public CellBandTracer<T, UniformCells<T>, Interpolation::Linear>
{
public:
  using Base = CellBandTracer<T, UniformCells<T>, Interpolation::Linear>;
  using Progress = typename Base::Progress;
  using Base::Base;

  std::int64_t Trace(const RayBatch& rays, TileKnots& knots) const override
  {
    Progress progress(this->Cells, rays);
    std::uint64_t wanted = 0;
    for (std::size_t ray = 0; ray < static_cast<std::size_t>(rays.Count); ++ray)
    {
      const bool isWanted = rays.HasWalk(ray) && !progress.IsDone(ray);
      wanted |= static_cast<std::uint64_t>(isWanted) << ray;
    }
    if (!this->IsBeam(rays, wanted) ||
      !UniformBandBeam<T>(this->Cells, rays, progress).Trace(wanted))
    {
      this->Walk(rays, progress);
    }
    progress.HandOver(knots);
    return progress.CellsRead;
  }

private:
  bool IsBeam(const RayBatch& rays, std::uint64_t wanted) const
  {
    const BandScene& scene = this->Cells.Scene;
    return !scene.Samples.Hidden && AreBeam(scene.By, rays, wanted);
  }
};

}

std::shared_ptr<const BandTracer> MakeUniformBandTracer(const BandScene& scene)
{
  return DispatchScalarType(scene.Samples.Type,
    [&](auto type) -> std::shared_ptr<const BandTracer>
    {
      using T = decltype(type);
      if (scene.Samples.Between == Interpolation::Nearest)
      {
        return MakeCellBandTracer<T>(scene, UniformCells<T>());
      }
      return std::make_shared<UniformBandTracer<T>>(scene, UniformCells<T>());
    });
}

}
