// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_UniformBandBeam_h
#define TemporalCoherence_UniformBandBeam_h

#include "Fields/BandBeam.h"
#include "Fields/KernelsBeam.h"
#include "Fields/UniformCells.h"
#include "Isomap/BandProgress.h"
#include "Trace/CellWalk.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace TemporalCoherence
{

/// True if the walk of a ray goes through a cell: CellWalk's answer, without its way there. Where a
/// ray passes planes at the same t, it passes the one of the lowest axis first.
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

/// Brings the rays of a tile through a band by a beam, in an image none of whose cells is hidden.
///
/// The beam only leaves out cells: those that a ray does not pass, and those where single precision
/// proves that they do not bring it on. The others are measured and taken note of as on a walk.
template <typename T>
class UniformBandBeam final : private BandBeamScene
{
public:
  using Cells = BandCells<T, UniformCells<T>>;
  using Progress = BandProgress<T, UniformCells<T>, Interpolation::Linear>;
  using Real = typename Cells::Real;

  UniformBandBeam(const Cells& cells, const RayBatch& rays, Progress& progress)
    : Band(cells)
    , Rays(rays)
    , Found(progress)
    , Unit(UnitOf(cells.Scale))
  {
  }

  /// Bring some rays through the band, one bit each.
  /// \return false if they must walk
  bool Trace(std::uint64_t wanted)
  {
    TileBeam beam;
    if (!SetUpBeam(this->Rays, wanted, this->Band.Count, beam) || !AreRaysAlike(beam))
    {
      return false;
    }
    beam.IsPlain = false; // walks may begin behind surfaces, and end before
    BandReach reach;
    reach.Span = this->Rounded(this->Band.Span) * (1.0f + 0x1p-20f);
    reach.Rising.fill(BandReach::NotBegun);
    reach.Falling.fill(BandReach::NotBegun);
    for (std::size_t ray = 0; ray < static_cast<std::size_t>(this->Rays.Count); ++ray)
    {
      this->Update(ray, reach);
    }
    SearchBand(*this->Band.Scene.Active, *this, reach, beam);
    this->Found.CellsRead += beam.CellsPassed;
    return true;
  }

private:
  /// A cell that the beam has read.
  struct ReadCell
  {
    glm::ivec3 Place;
    ::TemporalCoherence::Corners<Real> Corners;
    CellReach<Real> Reach;
  };

  /// A power of two by which differences in double become floats not far from 1.
  static Real UnitOf(const BandScale& scale)
  {
    return sizeof(Real) == sizeof(double) && scale.Unit > 0.0
      ? static_cast<Real>(std::ldexp(1.0, std::min(-std::ilogb(scale.Unit), 1000)))
      : Real(1);
  }

  float Rounded(Real difference) const { return static_cast<float>(difference * this->Unit); }

  /// How far rounding may move progress that is not known to be exact in single precision.
  float RoundingOf(float progress) const
  {
    return (std::abs(progress) + this->Rounded(this->Band.Span)) * 0x1p-22f + 1e-30f;
  }

  /// Progress in single precision, rounded up.
  float Raised(Real progress) const
  {
    const float raised = std::min(this->Rounded(progress), BandReach::Done);
    return sizeof(Real) == sizeof(float) ? raised : raised + this->RoundingOf(raised);
  }

  std::uint64_t CellsOf(std::int64_t node, const glm::ivec3& cell) const override
  {
    return this->Band.Scene.Active->CellsOf(this->Band.Samples.All(), node, cell);
  }

  void Read(
    const glm::ivec3* places, std::size_t count, std::size_t first, BandCell* cells) override
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      ReadCell& read = this->ReadCells[first + i];
      read.Place = places[i];
      read.Reach = this->Band.Read(places[i], read.Corners);
      BandCell& cell = cells[i];
      for (std::size_t corner = 0; corner < 8; ++corner)
      {
        cell.Corners[corner] = this->Rounded(read.Corners[corner]);
      }
      cell.ToRise = this->Raised(read.Reach.Corner[Rising]);
      cell.ToFall = this->Raised(read.Reach.Corner[Falling]);
      cell.IsFinite = read.Reach.IsFinite;
    }
  }

  void Measure(
    const NotedCells& noted, std::size_t count, BandReach& reach, TileBeam& beam) override
  {
    Progress& found = this->Found;
    found.AppendAll(count, noted.Ray,
      [&](std::size_t i) -> const ReadCell& { return this->ReadCells[noted.Cell[i]]; });
    found.Measure();
    found.TakeNote(
      [&](std::size_t ray, std::size_t i)
      {
        const bool isSure = found.EnterOf(i) < found.LeaveOf(i) &&
          found.LeaveOf(i) > this->Rays.WalkBegin[ray] &&
          found.EnterOf(i) < this->Rays.WalkEnd[ray];
        return isSure || IsOnWalk({ this->Rays, ray }, found.CellOf(i), this->Band.Count);
      });
    const bool isTooLarge = found.IsTooLarge();
    for (std::size_t i = 0; i < count; ++i)
    {
      const std::size_t ray = noted.Ray[i];
      this->Update(ray, reach);
      if (found.IsDone(ray))
      {
        const float behind = beam.DistanceOf(found.LeaveOf(i)) + beam.Margin;
        beam.Behind[ray] = std::min(beam.Behind[ray], behind);
      }
    }
    if (isTooLarge)
    {
      reach.Rising.fill(BandReach::Done);
      reach.Falling.fill(BandReach::Done);
      beam.Behind.fill(-TileBeam::Never);
    }
  }

  /// Take over how far a ray has come.
  void Update(std::size_t ray, BandReach& reach) const
  {
    reach.Entered |= static_cast<std::uint64_t>(this->Found.HasEntered(ray)) << ray;
    const auto update = [&](std::size_t direction, float& reached)
    {
      const auto& of = this->Found.ReachOf(direction, ray);
      const float path = this->Rounded(of.Path);
      reached = of.IsDone ? BandReach::Done : std::max(reached, path - this->RoundingOf(path));
    };
    update(Rising, reach.Rising[ray]);
    update(Falling, reach.Falling[ray]);
  }

  const Cells& Band;
  const RayBatch& Rays;
  Progress& Found;
  Real Unit;
  std::array<ReadCell, MostCells> ReadCells;
};

}

#endif
