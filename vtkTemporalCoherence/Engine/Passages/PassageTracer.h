// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_PassageTracer_h
#define TemporalCoherence_PassageTracer_h

#include "Beams/BeamChoice.h"
#include "Beams/KernelsBeam.h"
#include "Isomap/BandCells.h"
#include "Isomap/BandTracer.h"
#include "Passages/PassageBeam.h"
#include "Passages/PassageRows.h"
#include "Trace/CellWalk.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace TemporalCoherence
{

/// Finds the passages of the rays of a tile, for translucent surfaces: the cells in which each ray
/// may pass isovalues of a band. Nothing depends on what a ray has met before.
template <typename T, typename Geometry>
class PassageTracer final : public BandTracer
{
public:
  using Real = typename Geometry::Real;

  /// \param grid coordinates of samples; null: they lie at integers
  PassageTracer(
    const BandScene& scene, const Geometry& shape, const GridCoordinates* grid = nullptr)
    : Band(scene, shape)
    , Grid(grid)
    , HasCaps(Band.IsSolid && scene.Samples.Hidden)
  {
  }

  std::int64_t Trace(const RayBatch& rays, TileKnots& knots) const override
  {
    Work work(*this, rays);
    std::uint64_t wanted = 0;
    for (std::size_t ray = 0; ray < static_cast<std::size_t>(rays.Count); ++ray)
    {
      wanted |= static_cast<std::uint64_t>(rays.HasWalk(ray)) << ray;
    }
    if (this->Band.Scene.Samples.Between == Interpolation::Linear &&
      AreLayerBeam(this->Band.Scene.By, rays, wanted))
    {
      wanted = work.TraceBeams(wanted);
    }
    ForEachRay(wanted, [&](std::size_t ray) { work.Walk(ray); });
    knots.Passages.MayBeCapped = this->Band.IsSolid && this->MayBeginInSolid(rays);
    work.Rows.HandOver(knots);
    return work.CellsRead;
  }

private:
  /// The passages of a tile.
  struct Work final : private PassageScene
  {
    Work(const PassageTracer& tracer, const RayBatch& rays)
      : Rows(tracer.Band.Scene.MemoryLimit)
      , Tracer(tracer)
      , Band(tracer.Band)
      , Rays(rays)
    {
    }

    /// \return one bit for each ray that must walk
    std::uint64_t TraceBeams(std::uint64_t wanted)
    {
      std::uint64_t mustWalk = 0;
      while (wanted != 0)
      {
        const std::uint64_t which = this->AlikeIn(wanted);
        wanted &= ~which;
        TileBeam beam;
        if (SetUpBeam(this->Rays, which, this->Band.Count, beam) && beam.AreAlike)
        {
          this->Wanted = which;
          FindPassages({ *this->Band.Scene.Active, this->Band.IsSolid, this->Tracer.HasCaps,
                         this->Tracer.Grid },
            *this, beam);
          this->CellsRead += beam.CellsPassed;
        }
        else
        {
          mustWalk |= which;
        }
      }
      return mustWalk;
    }

    /// Walk through all active cells.
    void Walk(std::size_t ray)
    {
      const auto line = this->Band.Shape.RayOf(this->Rays, ray);
      CellWalk walk;
      walk.Begin(line, this->Band.Count);
      bool isDone = this->Rows.IsTooLarge();
      while (!isDone && walk.FindActive(line, *this->Band.Scene.Active, this->Band.Samples.All()))
      {
        Corners<Real> corners;
        const CellReach<Real> reach = this->Band.Read(walk.Here(), corners);
        ++this->CellsRead;
        const Real highest = reach.Corner[Rising] + reach.Error;
        const Real lowest = this->Band.Span - reach.Corner[Falling] - reach.Error;
        if (!reach.IsFinite || this->Tracer.HasCaps)
        {
          isDone = this->Rows.Append(ray, KeyRange::OfAll(), this->Rows.AddCell(walk.Here()));
        }
        else if (highest >= Real(0) && lowest <= this->Band.Span)
        {
          const BandScale& scale = this->Band.Scale;
          const KeyRange keys = KeyRange::Of(
            scale.InKeys(static_cast<double>(lowest)), scale.InKeys(static_cast<double>(highest)));
          isDone = this->Rows.Append(ray, keys, this->Rows.AddCell(walk.Here()));
        }
      }
    }

    PassageRows Rows;
    std::int64_t CellsRead = 0;

  private:
    /// The rays that run the same way along each axis as the first of some, one bit each.
    std::uint64_t AlikeIn(std::uint64_t rays) const
    {
      const auto isDown = [this](std::size_t axis, std::size_t ray)
      { return this->Rays.Direction[axis][ray] < 0.0; };
      const std::size_t first = hwy::Num0BitsBelowLS1Bit_Nonzero64(rays);
      std::uint64_t alike = 0;
      ForEachRay(rays,
        [&](std::size_t ray)
        {
          const bool isAlike = isDown(0, ray) == isDown(0, first) &&
            isDown(1, ray) == isDown(1, first) && isDown(2, ray) == isDown(2, first);
          alike |= static_cast<std::uint64_t>(isAlike) << ray;
        });
      return alike;
    }

    std::uint64_t CellsOf(std::int64_t node, const glm::ivec3& cell) const override
    {
      return this->Band.Scene.Active->CellsOf(this->Band.Samples.All(), node, cell);
    }

    void Read(const glm::ivec3& cell, PassedCell& values) override
    {
      Corners<Real> corners;
      const CellReach<Real> reach = this->Band.Read(cell, corners);
      const Real span = this->Band.Span, lowest = span - reach.Corner[Falling];
      const Real unit = std::max(std::abs(lowest), std::abs(reach.Corner[Rising])) + span;
      // Numbers so small or large that their shares lose bits tell nothing.
      constexpr Real least = std::is_same_v<Real, float> ? Real(1e-30f) : Real(1e-270);
      constexpr Real most = std::is_same_v<Real, float> ? Real(1e30f) : Real(1e270);
      values.IsAny = !(reach.IsFinite && unit > least && unit < most && span > Real(0));
      if (!values.IsAny)
      {
        const Real toUnit = Real(1) / unit;
        for (std::size_t row = 0; row < 4; ++row)
        {
          values.Values.Set(row, static_cast<float>(corners[2 * row] * toUnit),
            static_cast<float>(corners[2 * row + 1] * toUnit));
        }
        values.KeysPerUnit = static_cast<float>(
          std::min(static_cast<double>(unit) / span * BandScale::LargestInKeys, 1e30));
      }
    }

    std::uint64_t Store(
      const glm::ivec3& cell, std::uint64_t which, const PassedKeys& keys) override
    {
      const std::uint16_t number = this->Rows.AddCell(cell);
      std::uint64_t done = 0;
      ForEachRay(which,
        [&](std::size_t ray)
        {
          const KeyRange range{ static_cast<PassageKey>(keys.Low[ray]),
            static_cast<PassageKey>(keys.High[ray]) };
          const bool isDone = this->Rows.Append(ray, range, number);
          done |= static_cast<std::uint64_t>(isDone) << ray;
        });
      return this->Rows.IsTooLarge() ? this->Wanted : done;
    }

    const PassageTracer& Tracer;
    const BandCells<T, Geometry>& Band;
    const RayBatch& Rays;
    std::uint64_t Wanted = 0; ///< the rays of the beam
  };

  /// True if a ray may begin in a solid of an isovalue of the band.
  bool MayBeginInSolid(const RayBatch& rays) const
  {
    const HiddenCells* const hidden = this->Band.Scene.Samples.Hidden.get();
    glm::ivec3 last(-1);
    for (std::size_t ray = 0; ray < static_cast<std::size_t>(rays.Count); ++ray)
    {
      if (!(rays.Begin[ray] < rays.End[ray]))
      {
        continue;
      }
      const glm::ivec3 cell =
        this->Band.Shape.RayOf(rays, ray).CellAt(rays.Begin[ray], this->Band.Count);
      if (cell != last && !(hidden && hidden->IsHidden(cell)))
      {
        Corners<Real> corners;
        const CellReach<Real> reach = this->Band.Read(cell, corners);
        if (!reach.IsFinite || reach.Corner[Rising] + reach.Error >= Real(0))
        {
          return true;
        }
      }
      last = cell;
    }
    return false;
  }

  BandCells<T, Geometry> Band;
  const GridCoordinates* Grid;
  bool HasCaps; ///< solids are capped behind hidden cells
};

}

#endif
