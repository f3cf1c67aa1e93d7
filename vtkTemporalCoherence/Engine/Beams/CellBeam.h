// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_CellBeam_h
#define TemporalCoherence_CellBeam_h

#include "Beams/BeamLevels.h"
#include "Beams/KernelsBeam.h"
#include "Trace/TracedCells.h"

#include <algorithm>
#include <array>
#include <limits>

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
  /// A cell that the beam has read.
  struct ReadCell
  {
    glm::ivec3 Place;
    Corners<Real> Differences; ///< from the base
  };

  std::uint64_t CellsOf(std::int64_t node, const glm::ivec3& cell) const final
  {
    return this->Cells.Scene.Active->CellsOf(this->Cells.Samples.All(), node, cell);
  }

  std::int32_t Read(const glm::ivec3& cell, CellValues& values) final
  {
    ReadCell& read = this->ReadCells[static_cast<std::size_t>(this->NumberOfRead)];
    read.Place = cell;
    const T* const sample = this->Cells.Samples.All().At(cell);
    const glm::i64vec3& s = this->Cells.Samples.All().Strides;
    const std::array<std::int64_t, 4> rows = { 0, s.y, s.z, s.y + s.z };
    const auto& difference = this->Cells.Differences[this->Given.Base];
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
      read.Differences[2 * row] = low;
      read.Differences[2 * row + 1] = high;
      values.Set(row, single(low), single(high));
    }
    if (!(this->Given.template AreAlwaysTold<T>() ||
          this->Given.AreTold(this->Cells.Samples.Read(cell))))
    {
      values.SetUnknown();
    }
    return this->NumberOfRead++;
  }

  const ReadCell& CellOf(std::int32_t number) const
  {
    return this->ReadCells[static_cast<std::size_t>(number)];
  }

  /// Call visit(ray, cell) for the cells in which the beam has seen surfaces for sure, and forget
  /// them.
  template <typename Visitor>
  void VisitMet(TileBeam& beam, const Visitor& visit)
  {
    for (std::size_t ray = 0; ray < static_cast<std::size_t>(this->Rays.Count); ++ray)
    {
      if (beam.Cell[ray] != TileBeam::NoCell)
      {
        visit(ray, this->CellOf(beam.Cell[ray]));
        beam.Cell[ray] = TileBeam::NoCell;
      }
    }
  }

  /// The same for open cells that may hold hits.
  template <typename Visitor>
  void VisitOpen(OpenCells& open, const TileBeam& beam, const Visitor& visit)
  {
    for (std::size_t i = 0; i < open.Count; ++i)
    {
      const std::size_t ray = open.Ray[i];
      if (open.Enter[i] < beam.Behind[ray])
      {
        visit(ray, this->CellOf(open.Cell[i]));
      }
    }
    open.Count = 0;
  }

  /// A ray has a hit in a cell that it enters at some t: those that it enters later hold none.
  static void HideBehind(double enter, std::size_t ray, TileBeam& beam)
  {
    beam.Behind[ray] = std::min(beam.Behind[ray], beam.DistanceOf(enter) + beam.Margin);
  }

  void ForgetCells() { this->NumberOfRead = 0; }

  const Traced& Cells;
  const Levels& Given;
  const RayBatch& Rays;
  HitBatch& Hits;
  RayBatch::Array<double> FirstEnter; ///< where rays enter the cells of their hits

private:
  std::array<ReadCell, MostCells> ReadCells;
  std::int32_t NumberOfRead = 0;
};

}

#endif
