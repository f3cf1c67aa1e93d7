// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_CellBeam_h
#define TemporalCoherence_CellBeam_h

#include "Beams/BeamLevels.h"
#include "Beams/KernelsBeam.h"
#include "Beams/KernelsCellValues.h"
#include "Beams/KernelsMetCells.h"
#include "Trace/TracedCells.h"

#include <algorithm>
#include <array>
#include <limits>
#include <type_traits>

#include <hwy/base.h>

namespace TemporalCoherence
{

/// Finds the first surfaces of the rays of a tile by a beam: what kinds of fields share.
///
/// The beam only leaves out cells: those that a ray does not pass, those where single precision
/// proves that it meets nothing, and those behind another where it proves that it does. What is in
/// the others is found as a walk finds it, from the same ray and cell, and of the cells with a
/// surface the one that the ray enters first holds the hit, as on a walk. (The order of cells by
/// where they are entered is theirs on the ray: each has its part of it between planes, and no two
/// of them share more than an end.)
///
/// \tparam Geometry of the cells, as for TracedCells
template <typename T, typename Geometry>
class CellBeam : protected BeamScene
{
public:
  using Real = typename Geometry::Real;
  using Traced = TracedCells<T, Geometry, Interpolation::Linear>;
  using Levels = BeamLevels<typename Geometry::Value>;

  CellBeam(const Traced& cells, const Levels& levels, const RayBatch& rays, HitBatch& hits)
    : Cells(cells)
    , Given(levels)
    , Rays(rays)
    , Hits(hits)
  {
  }

  /// Find the hits of some rays, one bit each.
  /// \param grid coordinates of samples; null: they lie at integers
  /// \return false if they must walk
  bool Trace(std::uint64_t wanted, const GridCoordinates* grid = nullptr)
  {
    TileBeam beam;
    if (!SetUpBeam(this->Rays, wanted, this->Cells.Count, beam))
    {
      return false;
    }
    this->FirstEnter.fill(std::numeric_limits<double>::infinity());
    const BeamTask task{ this->Given.Isovalues, *this->Cells.Scene.Active,
      this->Cells.Rules.IsSolid(), grid };
    SearchBeam(task, *this, beam);
    this->Hits.CellsRead += beam.CellsPassed;
    return true;
  }

protected:
  std::uint64_t CellsOf(std::int64_t node, const glm::ivec3& cell) const final
  {
    return this->Cells.Scene.Active->CellsOf(this->Cells.Samples.All(), node, cell);
  }

  std::int32_t Read(const glm::ivec3& cell, CellValues& values) final
  {
    const auto number = static_cast<std::size_t>(this->NumberOfRead);
    Corners<Real>& differences = this->FromBase[number];
    this->Places[number] = cell;
    this->TakeDifferences(cell, differences, values);
    if (!(this->Given.template AreAlwaysTold<T>() ||
          this->Given.AreTold(this->Cells.Samples.Read(cell))))
    {
      values.SetUnknown();
    }
    return this->NumberOfRead++;
  }

  /// Let segments be those of the rays in the cells where the beam has seen surfaces for sure.
  /// \param places of these cells, or more of them
  /// \return one bit for each ray that has such a cell
  template <typename Where>
  std::uint64_t TakeMet(
    const OfReadCells<Where>& places, const TileBeam& beam, SegmentBatch<Real>& segments)
  {
    segments.All = &this->Rays;
    segments.Count = this->Rays.Count;
    const std::uint64_t met = GatherPlaces(places, beam.Cell, segments);
    if (this->Given.Isovalues.size() > 1)
    {
      std::fill_n(this->MetBy.begin(), this->CountOfRead(), std::uint64_t(0));
      for (std::uint64_t left = met; left != 0; left &= left - 1)
      {
        const std::size_t ray = hwy::Num0BitsBelowLS1Bit_Nonzero64(left);
        this->MetBy[static_cast<std::size_t>(beam.Cell[ray])] |= std::uint64_t(1) << ray;
      }
    }
    return met;
  }

  /// Set the corners of the cells that rays have met.
  /// \param met one bit for each of the rays
  /// \return true if any of them may meet the isovalue: segments know which
  bool SetCorners(const TileBeam& beam, std::uint64_t met, std::size_t isovalue,
    SegmentBatch<Real>& segments) const
  {
    segments.Wanted = met;
    if (this->Given.Isovalues.size() == 1)
    {
      GatherCorners(this->FromBase, beam.Cell, segments);
      return met != 0;
    }
    OfReadCells<Corners<Real>> differences;
    segments.Wanted = 0;
    for (std::size_t i = 0; i < this->CountOfRead(); ++i)
    {
      if (this->MetBy[i] != 0)
      {
        differences[i] = isovalue == this->Given.Base
          ? this->FromBase[i]
          : this->Cells.Differ(this->Cells.Samples.Read(this->Places[i]), isovalue);
        segments.Wanted |= this->Cells.CanHold(differences[i]) ? this->MetBy[i] : 0;
      }
    }
    if (segments.Wanted != 0)
    {
      GatherCorners(differences, beam.Cell, segments);
    }
    return segments.Wanted != 0;
  }

  /// Call visit(ray, cell) for open cells that may hold hits, and forget them.
  template <typename Visitor>
  void VisitOpen(OpenCells& open, const TileBeam& beam, const Visitor& visit)
  {
    for (std::size_t i = 0; i < open.Count; ++i)
    {
      const std::size_t ray = open.Ray[i];
      if (open.Enter[i] < beam.Behind[ray])
      {
        visit(ray, this->Places[static_cast<std::size_t>(open.Cell[i])]);
      }
    }
    open.Count = 0;
  }

  /// A ray has a hit in a cell that it enters at some t: those that it enters later hold none.
  static void HideBehind(double enter, std::size_t ray, TileBeam& beam)
  {
    beam.Behind[ray] = std::min(beam.Behind[ray], beam.DistanceOf(enter) + beam.Margin);
  }

  std::size_t CountOfRead() const { return static_cast<std::size_t>(this->NumberOfRead); }

  /// Forget what the beam has read and met.
  void ForgetCells(TileBeam& beam)
  {
    beam.Cell.fill(TileBeam::NoCell);
    this->NumberOfRead = 0;
  }

  const Traced& Cells;
  const Levels& Given;
  const RayBatch& Rays;
  HitBatch& Hits;
  RayBatch::Array<double> FirstEnter; ///< where rays enter the cells of their hits
  OfReadCells<glm::ivec3> Places;     ///< of the cells that are read

private:
  /// Take the differences at the corners of a cell from the base.
  void TakeDifferences(const glm::ivec3& cell, Corners<Real>& differences, CellValues& values) const
  {
    const T* const sample = this->Cells.Samples.All().At(cell);
    const glm::i64vec3& s = this->Cells.Samples.All().Strides;
    const std::array<std::int64_t, 4> rows = { 0, s.y, s.z, s.y + s.z };
    const auto& difference = this->Cells.Differences[this->Given.Base];
    if constexpr (std::is_floating_point_v<T>)
    {
      if (s.x == 1)
      {
        const CellRows<T> from = { sample, sample + rows[1], sample + rows[2], sample + rows[3] };
        FindCellValues(from, difference.InDouble(), this->Given.Unit, differences, values);
        return;
      }
    }
    const auto single = [&](Real value)
    {
      return static_cast<float>(
        sizeof(Real) == sizeof(float) ? value : value * static_cast<Real>(this->Given.Unit));
    };
    for (std::size_t row = 0; row < 4; ++row) // in one loop: measured faster than in three
    {
      const T* const from = sample + rows[row];
      const Real low = difference(static_cast<typename Geometry::Value>(from[0]));
      const Real high = difference(static_cast<typename Geometry::Value>(from[s.x]));
      differences[2 * row] = low;
      differences[2 * row + 1] = high;
      values.Set(row, single(low), single(high));
    }
  }

  OfReadCells<Corners<Real>> FromBase; ///< differences at the corners of these cells
  /// Rays that meet a surface in them for sure, one bit each. Only set for several isovalues.
  OfReadCells<std::uint64_t> MetBy;
  std::int32_t NumberOfRead = 0;
};

}

#endif
