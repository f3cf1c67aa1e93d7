// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_UniformBeam_h
#define TemporalCoherence_UniformBeam_h

#include "Fields/KernelsBeam.h"
#include "Fields/UniformCells.h"
#include "Trace/KernelsCrossing.h"
#include "Trace/TracedCells.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace TemporalCoherence
{

/// Finds the first surfaces of the rays of a tile by a beam, for one isovalue in an image whose
/// cells are all seen.
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

  UniformBeam(const Traced& cells, double unit, const RayBatch& rays, HitBatch& hits)
    : Cells(cells)
    , Unit(static_cast<Real>(unit))
    , Rays(rays)
    , Hits(hits)
    , Numbers(cells.Count)
  {
  }

  /// What differences are multiplied by, for the beam.
  static double UnitFor(const TraceScene& scene)
  {
    if (sizeof(Real) == sizeof(float))
    {
      return 1.0;
    }
    const double isovalue = scene.Sought.Isovalues.front();
    const double largest = IsovalueScale::For<T>({ isovalue, isovalue }, scene.FiniteRange)
                             .LargestFrom(isovalue, scene.FiniteRange);
    return largest > 0.0 ? std::ldexp(1.0, std::min(-std::ilogb(largest), 1000)) : 1.0;
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
    SearchBeam({ *this->Cells.Scene.Active, this->Cells.Count, this->Numbers,
                 this->Cells.Rules.IsSolid() },
      *this, beam);
    this->Hits.CellsRead += beam.CellsPassed;
    this->DecideMet(beam);
    this->FindContacts(beam);
    return true;
  }

private:
  std::uint64_t CellsOf(std::int64_t node, const glm::ivec3& cell) const override
  {
    return this->Cells.Scene.Active->CellsOf(this->Cells.Samples.All(), node, cell);
  }

  void ReadCorners(const glm::ivec3& cell, std::array<float, 8>& corners) const override
  {
    const Corners<Real> differences = this->Cells.Differ(this->Cells.Samples.Read(cell), 0);
    for (std::size_t i = 0; i < 8; ++i)
    {
      corners[i] = static_cast<float>(differences[i] * this->Unit);
    }
  }

  void Decide(OpenCells& open, TileBeam& beam) override
  {
    PassageBatch<Real> passages;
    std::array<std::size_t, RayBatch::Capacity> from;
    for (std::size_t i = 0; i < static_cast<std::size_t>(open.Count); ++i)
    {
      const std::size_t ray = open.Ray[i];
      if (open.Enter[i] < beam.Behind[ray])
      {
        from[static_cast<std::size_t>(passages.Count)] = ray;
        this->Append(ray, this->Numbers.At(open.Cell[i]), passages);
      }
    }
    open.Count = 0;
    FindCrossings(passages, this->Cells.Rules.IsSolid());
    for (std::size_t i = 0; i < static_cast<std::size_t>(passages.Count); ++i)
    {
      const std::size_t ray = from[i];
      if (this->Keep(passages, i, ray))
      {
        const float distance = beam.DistanceOf(passages.Distance[i]) + beam.Margin;
        beam.Behind[ray] = std::min(beam.Behind[ray], distance);
        this->HitCell[ray] = this->Numbers.Of(
          glm::ivec3(passages.Cell[0][i], passages.Cell[1][i], passages.Cell[2][i]));
      }
    }
  }

  void Append(std::size_t ray, const glm::ivec3& cell, PassageBatch<Real>& passages) const
  {
    AppendPassage(this->Rays, ray, cell,
      this->Cells.Differ(this->Cells.Samples.Read(cell), 0), passages);
  }

  /// Keep what was found in passage i, if the ray meets it before what it has.
  bool Keep(const PassageBatch<Real>& passages, std::size_t i, std::size_t ray)
  {
    if (!(passages.Distance[i] < std::numeric_limits<double>::infinity() &&
          passages.Enter[i] < this->FirstEnter[ray]))
    {
      return false;
    }
    this->FirstEnter[ray] = passages.Enter[i];
    this->Hits.Depth[ray] = passages.Distance[i];
    this->Hits.Surface[ray] = 0;
    this->Hits.Kind[ray] = HitRules::KindOf(IsInside(passages.AtEntry[i]));
    return true;
  }

  /// Find the surfaces that the beam has seen for sure.
  void DecideMet(const TileBeam& beam)
  {
    PassageBatch<Real> passages;
    std::array<std::size_t, RayBatch::Capacity> from;
    for (std::size_t ray = 0; ray < static_cast<std::size_t>(this->Rays.Count); ++ray)
    {
      if (beam.Cell[ray] != CellNumbers::None)
      {
        from[static_cast<std::size_t>(passages.Count)] = ray;
        this->Append(ray, this->Numbers.At(beam.Cell[ray]), passages);
      }
    }
    FindCrossings(passages, this->Cells.Rules.IsSolid());
    for (std::size_t i = 0; i < static_cast<std::size_t>(passages.Count); ++i)
    {
      if (this->Keep(passages, i, from[i]))
      {
        this->HitCell[from[i]] = beam.Cell[from[i]];
      }
    }
  }

  /// Find where rays first enter active cells.
  void FindContacts(const TileBeam& beam)
  {
    PassageBatch<Real> misses;
    std::array<std::size_t, RayBatch::Capacity> from;
    for (std::size_t ray = 0; ray < static_cast<std::size_t>(this->Rays.Count); ++ray)
    {
      if (beam.ContactCell[ray] == CellNumbers::None)
      {
        continue;
      }
      const bool isHit = this->Hits.Surface[ray] != Frame::NoSurface;
      glm::ivec3 cell = this->Numbers.At(beam.ContactCell[ray]);
      glm::dvec2 ends = this->EndsIn(ray, cell);
      const bool isSure = ends.x < ends.y && ends.y > this->Rays.WalkBegin[ray] &&
        ends.x < this->Rays.WalkEnd[ray] &&
        beam.DistanceOf(ends.x) + beam.Margin < beam.NextContact[ray];
      if (!isSure)
      {
        if (!this->WalkToActive(ray, cell))
        {
          continue;
        }
        ends = this->EndsIn(ray, cell);
      }
      this->Hits.Contact[ray] = ends.x;
      this->Hits.FromInside[ray] = this->Hits.Kind[ray] == HitKind::Leaves;
      if (!isHit)
      {
        from[static_cast<std::size_t>(misses.Count)] = ray;
        this->Append(ray, cell, misses);
      }
    }
    FindCrossings(misses, this->Cells.Rules.IsSolid());
    for (std::size_t i = 0; i < static_cast<std::size_t>(misses.Count); ++i)
    {
      this->Hits.FromInside[from[i]] = IsInside(misses.AtEntry[i]);
    }
  }

  /// Where a ray enters a cell, and where it leaves it.
  glm::dvec2 EndsIn(std::size_t ray, const glm::ivec3& cell) const
  {
    glm::dvec2 ends(this->Rays.Begin[ray], this->Rays.End[ray]);
    const BatchRay line{ this->Rays, ray };
    for (int axis = 0; axis < 3; ++axis)
    {
      const int ahead = line.Direction(axis) > 0.0 ? 1 : 0;
      ends.x = std::max(ends.x, line.Pass(axis, cell[axis] + 1 - ahead));
      ends.y = std::min(ends.y, line.Pass(axis, cell[axis] + ahead));
    }
    return ends;
  }

  /// Walk to the first active cell.
  bool WalkToActive(std::size_t ray, glm::ivec3& cell) const
  {
    const BatchRay line{ this->Rays, ray };
    CellWalk walk;
    walk.Begin(line, this->Cells.Count);
    const bool isFound =
      walk.FindActive(line, *this->Cells.Scene.Active, this->Cells.Samples.All());
    cell = walk.Here();
    return isFound;
  }

  const Traced& Cells;
  Real Unit;
  const RayBatch& Rays;
  HitBatch& Hits;
  CellNumbers Numbers;
  RayBatch::Array<double> FirstEnter;
  RayBatch::Array<std::uint32_t> HitCell;
};

}

#endif
