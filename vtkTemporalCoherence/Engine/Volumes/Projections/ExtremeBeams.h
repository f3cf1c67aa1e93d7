// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_ExtremeBeams_h
#define TemporalCoherence_ExtremeBeams_h

#include "Volumes/Projections/ExtremeBlocks.h"
#include "Volumes/Projections/ExtremeSearch.h"
#include "Volumes/Projections/KernelsExtremes.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <utility>

namespace TemporalCoherence
{

/// Finds extremes tile by tile. Rays that run the same way along each axis form a beam, which goes
/// from block to block. Other rays walk.
/// \tparam Real number type of the geometry of cells
template <typename T, typename Real>
class ExtremeBeams final : public ExtremeSearch
{
public:
  /// \param walk    for rays that cannot form a beam
  /// \param meeting this walk for nearest interpolation; else null
  ExtremeBeams(const ExtremeTask& task, std::unique_ptr<const ExtremeSearch> walk,
    const CellMeeting<Real>* meeting)
    : Blocks(task.Samples, task.Ranges ? *task.Ranges : this->Build(task.Samples), task.IsMinimum)
    , Meeting(meeting)
    , Grid(task.Grid)
    , Least(RoundedDown(task.IsMinimum ? -task.LeastSeen : task.LeastSeen))
    , Sign(task.IsMinimum ? -1.0 : 1.0)
    , Walk(std::move(walk))
  {
  }

  void Search(const RayBatch& rays, const RayExtremes& found) const override
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    BeamExtremes<Real> largest;
    for (std::size_t i = 0; i < RayBatch::Capacity; ++i)
    {
      const double value = found.Value[i];
      largest.Value[i] = static_cast<Real>(std::isnan(value) ? -infinity : this->Sign * value);
      largest.First[i] = found.First[i];
    }
    const BeamSearch<Real> search{ this->Blocks, this->Meeting, this->Grid, this->Least };
    std::uint64_t walking = 0;
    for (const std::uint64_t which : Alike(rays))
    {
      const bool isDone = which == 0 || FindExtremes(search, rays, which, largest);
      walking |= isDone ? 0 : which;
    }
    for (std::size_t i = 0; i < static_cast<std::size_t>(rays.Count); ++i)
    {
      if (largest.First[i] < infinity)
      {
        found.Value[i] = this->Sign * static_cast<double>(largest.Value[i]);
        found.First[i] = largest.First[i];
      }
    }
    found.CellsRead += largest.CellsRead;
    if (walking != 0)
    {
      this->LetWalk(rays, walking, found);
    }
  }

private:
  const ValueRangePyramid& Build(const Field& samples)
  {
    this->Own.Build(samples);
    return this->Own;
  }

  /// The rays, one bit each, by the octant of their direction.
  static std::array<std::uint64_t, 8> Alike(const RayBatch& rays)
  {
    std::array<std::uint64_t, 8> alike{};
    for (std::size_t i = 0; i < static_cast<std::size_t>(rays.Count); ++i)
    {
      const std::size_t way = static_cast<std::size_t>(rays.Direction[0][i] > 0.0) |
        static_cast<std::size_t>(rays.Direction[1][i] > 0.0) << 1 |
        static_cast<std::size_t>(rays.Direction[2][i] > 0.0) << 2;
      alike[way] |= static_cast<std::uint64_t>(rays.HasWalk(i)) << i;
    }
    return alike;
  }

  void LetWalk(const RayBatch& rays, std::uint64_t which, const RayExtremes& found) const
  {
    RayBatch walking = rays;
    for (std::size_t i = 0; i < static_cast<std::size_t>(rays.Count); ++i)
    {
      walking.End[i] = which >> i & 1u ? walking.End[i] : walking.Begin[i];
    }
    this->Walk->Search(walking, found);
  }

  ValueRangePyramid Own; ///< if the task gives no ranges
  TypedExtremeBlocks<T, Real> Blocks;
  const CellMeeting<Real>* Meeting;
  const GridCoordinates* Grid;
  float Least; ///< smallest visible value
  double Sign;
  std::unique_ptr<const ExtremeSearch> Walk;
};

}

#endif
