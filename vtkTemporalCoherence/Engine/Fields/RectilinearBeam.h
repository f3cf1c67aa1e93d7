// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_RectilinearBeam_h
#define TemporalCoherence_RectilinearBeam_h

#include "Beams/CellBeam.h"
#include "Fields/RectilinearCells.h"

#include <array>
#include <limits>

namespace TemporalCoherence
{

/// Finds the first surfaces of the rays of a tile by a beam, in a rectilinear field. Cells are
/// searched ray by ray.
template <typename T>
class RectilinearBeam final : public CellBeam<T, RectilinearCells<T>>
{
public:
  using Base = CellBeam<T, RectilinearCells<T>>;
  using Base::Base;

private:
  using typename Base::ReadCell;
  using Segment = typename Base::Traced::Segment;

  void Decide(OpenCells& open, TileBeam& beam) override
  {
    const auto search = [&](std::size_t ray, const ReadCell& cell)
    { this->Search(ray, cell, beam); };
    this->VisitMet(beam, search);
    this->VisitOpen(open, beam, search);
    this->ForgetCells();
  }

  /// Search a cell, for each isovalue that passes through it.
  void Search(std::size_t ray, const ReadCell& read, TileBeam& beam)
  {
    const RectilinearRay line = this->Cells.Shape.RayOf(this->Rays, ray);
    const Segment segment(line, read.Place);
    if (this->Given.Isovalues.size() == 1)
    {
      this->SearchFor(read.Differences, 0, segment, ray, beam);
      return;
    }
    const std::array<T, 8> samples = this->Cells.Samples.Read(read.Place);
    for (std::size_t surface = 0; surface < this->Given.Isovalues.size(); ++surface)
    {
      this->SearchFor(this->Cells.Differ(samples, surface), surface, segment, ray, beam);
    }
  }

  /// Search a cell for one isovalue. What is found counts if the ray enters no cell with a surface
  /// before.
  void SearchFor(const Corners<double>& corners, std::size_t isovalue, const Segment& segment,
    std::size_t ray, TileBeam& beam)
  {
    if (!this->Cells.CanHold(corners))
    {
      return;
    }
    const CellHit found = this->Cells.SearchFor(segment, corners);
    const auto surface = static_cast<std::int16_t>(isovalue);
    const double enter = segment.Enter();
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
    this->Cells.Keep(segment, found, surface, ray, this->Hits);
  }
};

}

#endif
