// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_UniformBeam_h
#define TemporalCoherence_UniformBeam_h

#include "Lattice/CellBeam.h"
#include "Lattice/HiddenSegment.h"
#include "Lattice/KernelsCrossing.h"
#include "Lattice/UniformCells.h"

#include <array>
#include <limits>

namespace TemporalCoherence
{

/// Finds the first surfaces of the rays of a tile by a beam, in an image. The kernel of walks
/// searches cells.
template <typename T>
class UniformBeam final : public CellBeam<T, UniformCells<T>>
{
public:
  using Base = CellBeam<T, UniformCells<T>>;
  using Real = typename Base::Real;
  using Base::Base;

private:
  /// Segments to search.
  struct Search
  {
    SegmentBatch<Real> Segments;
    RayBatch::Array<std::size_t> Ray;
    RayBatch::Array<std::int16_t> Surface;
  };

  void Decide(OpenCells& open, TileBeam& beam) override
  {
    if (this->CountOfRead() == 0)
    {
      return;
    }
    this->DecideMet(beam);
    Search search;
    this->VisitOpen(open, beam,
      [&](std::size_t ray, const glm::ivec3& cell) { this->Visit(ray, cell, search, beam); });
    this->Finish(search, beam);
    this->ForgetCells(beam);
  }

  /// Compute the beam's certain hits in full precision.
  void DecideMet(TileBeam& beam)
  {
    SegmentBatch<Real> segments;
    const std::uint64_t met = this->TakeMet(this->Places, beam, segments);
    for (std::size_t isovalue = 0; isovalue < this->Given.Isovalues.size(); ++isovalue)
    {
      if (this->SetCorners(beam, met, isovalue, segments))
      {
        FindCrossings(segments, this->Cells.Rules.IsSolid());
        for (std::uint64_t left = segments.Wanted; left != 0; left &= left - 1)
        {
          const std::size_t ray = hwy::Num0BitsBelowLS1Bit_Nonzero64(left);
          this->Keep(segments, ray, static_cast<std::int16_t>(isovalue), ray, beam);
        }
      }
    }
  }

  /// Note a ray's segments in a cell, of each isovalue that passes through it.
  void Visit(std::size_t ray, const glm::ivec3& cell, Search& search, TileBeam& beam)
  {
    const std::array<T, 8> samples = this->Cells.Samples.Read(cell);
    for (std::size_t surface = 0; surface < this->Given.Isovalues.size(); ++surface)
    {
      const Corners<Real> corners = this->Cells.Differ(samples, surface);
      if (!this->Cells.CanHold(corners))
      {
        continue;
      }
      if (search.Segments.Count == RayBatch::Capacity)
      {
        this->Finish(search, beam);
      }
      const auto at = static_cast<std::size_t>(search.Segments.Count);
      AppendSegment(this->Rays, ray, cell, corners, search.Segments);
      search.Ray[at] = ray;
      search.Surface[at] = static_cast<std::int16_t>(surface);
    }
  }

  /// Search the noted segments.
  void Finish(Search& search, TileBeam& beam)
  {
    SegmentBatch<Real>& segments = search.Segments;
    FindCrossings(segments, this->Cells.Rules.IsSolid());
    for (std::size_t i = 0; i < static_cast<std::size_t>(segments.Count); ++i)
    {
      this->Keep(segments, i, search.Surface[i], search.Ray[i], beam);
    }
    segments.Count = 0;
  }

  /// Keep the hit found in segment i, unless the ray enters another cell with a surface earlier.
  void Keep(const SegmentBatch<Real>& segments, std::size_t i, std::int16_t surface,
    std::size_t ray, TileBeam& beam)
  {
    const double enter = segments.Enter[i], distance = segments.Distance[i];
    if (!(distance < std::numeric_limits<double>::infinity() && enter <= this->FirstEnter[ray]))
    {
      return;
    }
    const bool fromInside = IsInside(segments.AtEntry[i]);
    if (enter < this->FirstEnter[ray])
    {
      this->FirstEnter[ray] = enter;
      this->Hits.Depth[ray] = distance;
      this->Hits.Surface[ray] = surface;
      this->Hits.Kind[ray] = HitRules::KindOf(fromInside);
      this->HideBehind(enter, ray, beam);
    }
    else // in the same cell
    {
      this->Cells.Rules.KeepFirst(distance, fromInside, surface, ray, this->Hits);
    }
    this->CapBehindHidden(segments, i, surface, ray);
  }

  /// Cap a solid where a ray inside it leaves hidden cells.
  void CapBehindHidden(
    const SegmentBatch<Real>& segments, std::size_t i, std::int16_t surface, std::size_t ray)
  {
    const double enter = segments.Enter[i];
    if (this->Cells.Rules.AreCappedBehindHidden() && IsInside(segments.AtEntry[i]))
    {
      this->Cells.Rules.CapBehindHidden(
        enter, surface, ray,
        [&] { return ComesFromHidden(segments, i, enter, *this->Cells.Hidden); }, this->Hits);
    }
  }
};

}

#endif
