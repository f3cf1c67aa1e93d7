// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_UniformBeam_h
#define TemporalCoherence_UniformBeam_h

#include "Fields/BeamLevels.h"
#include "Fields/KernelsBeam.h"
#include "Fields/UniformCells.h"
#include "Trace/HiddenSegment.h"
#include "Trace/KernelsCrossing.h"
#include "Trace/TracedCells.h"

#include <algorithm>
#include <array>
#include <limits>

namespace TemporalCoherence
{

/// Finds the first surfaces of the rays of a tile by a beam, in an image.
///
/// The beam only leaves out cells: those that a ray does not pass, those where single precision
/// proves that it meets nothing, and those behind another where it proves that it does. What is in
/// the others is found as a walk finds it, by the same kernel from the same ray and cell, and of
/// the cells with a surface the one that the ray enters first holds the hit, as on a walk. (The
/// order of cells by where they are entered is theirs on the ray: each has its part of it between
/// planes, and no two of them share more than an end.)
template <typename T>
class UniformBeam final : private BeamScene
{
public:
  using Real = RealOf<T>;
  using Traced = TracedCells<T, UniformCells<T>, Interpolation::Linear>;

  UniformBeam(
    const Traced& cells, const BeamLevels<T>& levels, const RayBatch& rays, HitBatch& hits)
    : Cells(cells)
    , Given(levels)
    , Unit(static_cast<Real>(levels.Unit))
    , Rays(rays)
    , Hits(hits)
  {
  }

  /// Find the hits of some rays, one bit each.
  /// \return false if they must walk
  bool Trace(std::uint64_t wanted)
  {
    TileBeam beam;
    if (!SetUpBeam(this->Rays, wanted, this->Cells.Count, beam))
    {
      return false;
    }
    this->FirstEnter.fill(std::numeric_limits<double>::infinity());
    SearchBeam({ this->Given.Isovalues, *this->Cells.Scene.Active, this->Cells.Rules.IsSolid() },
      *this, beam);
    this->Hits.CellsRead += beam.CellsPassed;
    return true;
  }

private:
  /// A cell that the beam has read.
  struct ReadCell
  {
    std::array<double, 3> Place;
    Corners<Real> Differences;
  };

  std::uint64_t CellsOf(std::int64_t node, const glm::ivec3& cell) const override
  {
    return this->Cells.Scene.Active->CellsOf(this->Cells.Samples.All(), node, cell);
  }

  std::int32_t Read(const glm::ivec3& cell, std::array<float, 8>& corners) override
  {
    ReadCell& read = this->ReadCells[static_cast<std::size_t>(this->NumberOfRead)];
    read.Place = { cell.x + 0.0, cell.y + 0.0, cell.z + 0.0 };
    const T* const sample = this->Cells.Samples.All().At(cell);
    const glm::i64vec3& s = this->Cells.Samples.All().Strides;
    const std::array<std::int64_t, 4> rows = { 0, s.y, s.z, s.y + s.z };
    const Difference<T>& difference = this->Cells.Differences[this->Given.Base];
    for (std::size_t i = 0; i < 8; ++i) // in one loop: measured faster than Differ(Read(cell))
    {
      const Real value = difference(sample[rows[i / 2] + (i & 1 ? s.x : 0)]);
      read.Differences[i] = value;
      corners[i] = sizeof(Real) == sizeof(float) ? static_cast<float>(value)
                                                 : static_cast<float>(value * this->Unit);
    }
    if (!this->Given.AreTold(this->Cells.Samples.Read(cell)))
    {
      corners.fill(std::numeric_limits<float>::quiet_NaN());
    }
    return this->NumberOfRead++;
  }

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
    else
    {
      this->VisitMet(search, beam);
    }
    for (std::size_t i = 0; i < open.Count; ++i)
    {
      const std::size_t ray = open.Ray[i];
      if (open.Enter[i] < beam.Behind[ray])
      {
        this->Visit(ray, open.Cell[i], search, beam);
      }
    }
    this->Finish(search, beam);
    open.Count = 0;
    this->NumberOfRead = 0;
  }

  /// Visit the cells in which the beam has seen surfaces for sure.
  void VisitMet(Search& search, TileBeam& beam)
  {
    for (std::size_t ray = 0; ray < static_cast<std::size_t>(this->Rays.Count); ++ray)
    {
      if (beam.Cell[ray] != TileBeam::NoCell)
      {
        this->Visit(ray, beam.Cell[ray], search, beam);
        beam.Cell[ray] = TileBeam::NoCell;
      }
    }
  }

  /// Note a ray's segments in a cell, of each isovalue that passes through it.
  void Visit(std::size_t ray, std::int32_t number, Search& search, TileBeam& beam)
  {
    const std::array<double, 3>& place = this->ReadCells[static_cast<std::size_t>(number)].Place;
    const glm::ivec3 cell(place[0], place[1], place[2]);
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
        // Cells that the ray enters later hold no hit.
        const float behind = beam.DistanceOf(segments.Enter[i]) + beam.Margin;
        beam.Behind[ray] = std::min(beam.Behind[ray], behind);
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
      const ReadCell& cell = this->ReadCells[static_cast<std::size_t>(number)];
      for (std::size_t a = 0; a < 3; ++a)
      {
        segments.Cell[a][i] = cell.Place[a];
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

  const Traced& Cells;
  const BeamLevels<T>& Given;
  Real Unit;
  const RayBatch& Rays;
  HitBatch& Hits;
  RayBatch::Array<double> FirstEnter; ///< where rays enter the cells of their hits
  std::array<ReadCell, MostCells> ReadCells;
  std::int32_t NumberOfRead = 0;
};

}

#endif
