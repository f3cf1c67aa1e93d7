// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_UniformBeam_h
#define TemporalCoherence_UniformBeam_h

#include "Beams/CellBeam.h"
#include "Fields/UniformCells.h"
#include "Trace/HiddenSegment.h"
#include "Trace/KernelsCrossing.h"

#include <array>
#include <limits>

namespace TemporalCoherence
{

/// Finds the first surfaces of the rays of a tile by a beam, in an image. Cells are searched by the
/// kernel of walks.
template <typename T>
class UniformBeam final : public CellBeam<T, UniformCells<T>>
{
public:
  using Base = CellBeam<T, UniformCells<T>>;
  using Real = typename Base::Real;
  using Base::Base;

private:
  using typename Base::ReadCell;

  /// Segments that are to be searched.
  struct Search
  {
    SegmentBatch<Real> Segments;
    RayBatch::Array<std::size_t> Ray;
    RayBatch::Array<std::int16_t> Surface;
  };

  void Decide(OpenCells& open, TileBeam& beam) override
  {
    Search search;
    if (this->Given.Isovalues.size() == 1)
    {
      this->DecideMet(beam);
    }
    const auto visit = [&](std::size_t ray, const ReadCell& cell)
    { this->Visit(ray, cell, search, beam); };
    this->VisitMet(beam, visit);
    this->VisitOpen(open, beam, visit);
    this->Finish(search, beam);
    this->ForgetCells();
  }

  /// Note a ray's segments in a cell, of each isovalue that passes through it.
  void Visit(std::size_t ray, const ReadCell& cell, Search& search, TileBeam& beam)
  {
    const std::array<T, 8> samples = this->Cells.Samples.Read(cell.Place);
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
      AppendSegment(this->Rays, ray, cell.Place, corners, search.Segments);
      search.Ray[at] = ray;
      search.Surface[at] = static_cast<std::int16_t>(surface);
    }
  }

  /// Search what is noted.
  void Finish(Search& search, TileBeam& beam)
  {
    SegmentBatch<Real>& segments = search.Segments;
    FindCrossings(segments, this->Cells.Rules.IsSolid());
    for (std::size_t i = 0; i < static_cast<std::size_t>(segments.Count); ++i)
    {
      const std::size_t ray = search.Ray[i];
      const bool isFound = segments.Distance[i] < std::numeric_limits<double>::infinity();
      if (isFound && segments.Enter[i] == this->FirstEnter[ray])
      {
        // In the same cell.
        this->Cells.Rules.KeepFirst(
          segments.Distance[i], IsInside(segments.AtEntry[i]), search.Surface[i], ray, this->Hits);
        this->CapBehindHidden(segments, i, search.Surface[i], ray);
      }
      else if (this->Keep(segments, i, search.Surface[i], ray))
      {
        this->HideBehind(segments.Enter[i], ray, beam);
      }
    }
    segments.Count = 0;
  }

  /// Find the surfaces that the beam has seen for sure.
  void DecideMet(TileBeam& beam)
  {
    const auto count = static_cast<std::size_t>(this->Rays.Count);
    std::array<std::size_t, RayBatch::Capacity> from;
    std::size_t met = 0;
    for (std::size_t ray = 0; ray < count; ++ray)
    {
      from[met] = ray;
      met += beam.Cell[ray] != TileBeam::NoCell;
    }
    if (met == 0)
    {
      return;
    }
    SegmentBatch<Real> segments;
    // Rays of a whole tile need not be copied; those that met nothing are searched in vain.
    const bool areAll = 4 * met > 3 * count;
    segments.All = areAll ? &this->Rays : nullptr;
    segments.Count = static_cast<int>(areAll ? count : met);
    const std::int32_t any = beam.Cell[from[0]];
    for (std::size_t i = 0; i < static_cast<std::size_t>(segments.Count); ++i)
    {
      from[i] = areAll ? i : from[i];
      const std::size_t ray = from[i];
      const std::int32_t number = beam.Cell[ray] != TileBeam::NoCell ? beam.Cell[ray] : any;
      const ReadCell& cell = this->CellOf(number);
      for (std::size_t a = 0; a < 3; ++a)
      {
        segments.Cell[a][i] = cell.Place[static_cast<int>(a)];
      }
      for (std::size_t corner = 0; corner < 8; ++corner)
      {
        segments.Corners[corner][i] = cell.Differences[corner];
      }
    }
    if (!areAll)
    {
      GatherRays(this->Rays, from, segments);
    }
    FindCrossings(segments, this->Cells.Rules.IsSolid());
    for (std::size_t i = 0; i < static_cast<std::size_t>(segments.Count); ++i)
    {
      if (beam.Cell[from[i]] != TileBeam::NoCell)
      {
        this->Keep(segments, i, 0, from[i]);
        beam.Cell[from[i]] = TileBeam::NoCell;
      }
    }
  }

  /// Keep what was found in segment i, if the ray meets it before what it has.
  bool Keep(
    const SegmentBatch<Real>& segments, std::size_t i, std::int16_t surface, std::size_t ray)
  {
    if (!(segments.Distance[i] < std::numeric_limits<double>::infinity() &&
          segments.Enter[i] < this->FirstEnter[ray]))
    {
      return false;
    }
    this->FirstEnter[ray] = segments.Enter[i];
    this->Hits.Depth[ray] = segments.Distance[i];
    this->Hits.Surface[ray] = surface;
    this->Hits.Kind[ray] = HitRules::KindOf(IsInside(segments.AtEntry[i]));
    this->CapBehindHidden(segments, i, surface, ray);
    return true;
  }

  /// Cap a solid that a ray is inside of where it leaves hidden cells.
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
