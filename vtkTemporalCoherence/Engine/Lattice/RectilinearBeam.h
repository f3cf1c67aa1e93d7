// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_RectilinearBeam_h
#define TemporalCoherence_RectilinearBeam_h

#include "Lattice/CellBeam.h"
#include "Lattice/KernelsCrossing.h"
#include "Lattice/RectilinearCells.h"

#include <array>
#include <limits>

namespace TemporalCoherence
{

/// Finds the first surfaces of the rays of a tile by a beam, in a rectilinear field. A kernel
/// searches the cells of certain hits; open cells are searched ray by ray.
template <typename T>
class RectilinearBeam final : public CellBeam<T, RectilinearCells<T>>
{
public:
  using Base = CellBeam<T, RectilinearCells<T>>;
  using Base::Base;

private:
  using Segment = typename Base::Traced::Segment;

  void Decide(OpenCells& open, TileBeam& beam) override
  {
    if (this->CountOfRead() == 0)
    {
      return;
    }
    this->DecideMet(beam);
    this->VisitOpen(
      open, beam, [&](std::size_t ray, const glm::ivec3& cell) { this->Search(ray, cell, beam); });
    this->ForgetCells(beam);
  }

  /// Compute the beam's certain hits in full precision.
  void DecideMet(TileBeam& beam)
  {
    OfReadCells<CellCorners> boxes;
    const GridCoordinates& grid = this->Cells.Shape.Grid;
    for (std::size_t i = 0; i < this->CountOfRead(); ++i)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        const int cell = this->Places[i][axis];
        boxes[i][0][axis] = grid.At(axis, cell);
        boxes[i][1][axis] = grid.At(axis, cell + 1);
      }
    }
    SegmentBatch<double> segments;
    const std::uint64_t met = this->TakeMet(boxes, beam, segments);
    for (std::size_t isovalue = 0; isovalue < this->Given.Isovalues.size(); ++isovalue)
    {
      if (this->SetCorners(beam, met, isovalue, segments))
      {
        FindCrossingsInBoxes(segments, this->Cells.Rules.IsSolid());
        for (std::uint64_t left = segments.Wanted; left != 0; left &= left - 1)
        {
          const std::size_t ray = hwy::Num0BitsBelowLS1Bit_Nonzero64(left);
          const auto number = static_cast<std::size_t>(beam.Cell[ray]);
          this->Keep({ IsInside(segments.AtEntry[ray]), segments.Distance[ray] },
            segments.Enter[ray], this->Places[number], isovalue, ray, beam);
        }
      }
    }
  }

  /// Search a cell, for each isovalue that passes through it.
  void Search(std::size_t ray, const glm::ivec3& cell, TileBeam& beam)
  {
    const Segment segment(this->Cells.Shape.RayOf(this->Rays, ray), cell);
    const std::array<T, 8> samples = this->Cells.Samples.Read(cell);
    for (std::size_t isovalue = 0; isovalue < this->Given.Isovalues.size(); ++isovalue)
    {
      const Corners<double> corners = this->Cells.Differ(samples, isovalue);
      if (this->Cells.CanHold(corners))
      {
        this->Keep(
          this->Cells.SearchFor(segment, corners), segment.Enter(), cell, isovalue, ray, beam);
      }
    }
  }

  /// Keep the hit found in a cell, unless the ray enters another cell with a surface earlier.
  void Keep(const CellHit& found, double enter, const glm::ivec3& cell, std::size_t isovalue,
    std::size_t ray, TileBeam& beam)
  {
    const bool isFound = found.Distance < std::numeric_limits<double>::infinity();
    if (!isFound || !(enter <= this->FirstEnter[ray]))
    {
      return;
    }
    if (enter < this->FirstEnter[ray])
    {
      this->FirstEnter[ray] = enter;
      this->Hits.Depth[ray] = std::numeric_limits<double>::infinity();
      this->Hits.Surface[ray] = Frame::NoSurface;
      this->HideBehind(enter, ray, beam);
    }
    const auto surface = static_cast<SurfaceIndex>(isovalue);
    const HitRules& rules = this->Cells.Rules;
    rules.KeepFirst(found.Distance, found.FromInside, surface, ray, this->Hits);
    if (rules.AreCappedBehindHidden() && found.FromInside)
    {
      const auto comesFromHidden = [&]
      {
        const Segment segment(this->Cells.Shape.RayOf(this->Rays, ray), cell);
        return segment.ComesFrom(*this->Cells.Hidden);
      };
      rules.CapBehindHidden(enter, surface, ray, comesFromHidden, this->Hits);
    }
  }
};

}

#endif
