// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_RectilinearBeam_h
#define TemporalCoherence_RectilinearBeam_h

#include "Fields/BeamLevels.h"
#include "Fields/KernelsBeam.h"
#include "Fields/RectilinearCells.h"
#include "Trace/TracedCells.h"

#include <algorithm>
#include <array>
#include <limits>

namespace TemporalCoherence
{

/// Finds the first surfaces of the rays of a tile by a beam, in a rectilinear field.
///
/// As in an image (UniformBeam.h), the beam only leaves out cells. What is in the others is found
/// as a walk finds it, and of the cells with a surface the one that the ray enters first holds the
/// hit.
template <typename T>
class RectilinearBeam final : private BeamScene
{
public:
  using Traced = TracedCells<T, RectilinearCells<T>, Interpolation::Linear>;

  RectilinearBeam(
    const Traced& cells, const BeamLevels<double>& levels, const RayBatch& rays, HitBatch& hits)
    : Cells(cells)
    , Given(levels)
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
    const BeamTask task{ this->Given.Isovalues, *this->Cells.Scene.Active,
      this->Cells.Rules.IsSolid(), &this->Cells.Shape.Grid };
    SearchBeam(task, *this, beam);
    this->Hits.CellsRead += beam.CellsPassed;
    return true;
  }

private:
  /// A cell that the beam has read.
  struct ReadCell
  {
    glm::ivec3 Place;
    Corners<double> Differences; ///< from the base
  };

  std::uint64_t CellsOf(std::int64_t node, const glm::ivec3& cell) const override
  {
    return this->Cells.Scene.Active->CellsOf(this->Cells.Samples.All(), node, cell);
  }

  std::int32_t Read(const glm::ivec3& cell, std::array<float, 8>& corners) override
  {
    ReadCell& read = this->ReadCells[static_cast<std::size_t>(this->NumberOfRead)];
    const std::array<T, 8> samples = this->Cells.Samples.Read(cell);
    std::array<double, 8> converted;
    std::copy(samples.begin(), samples.end(), converted.begin());
    read.Place = cell;
    read.Differences = this->Cells.Differ(samples, this->Given.Base);
    for (std::size_t i = 0; i < 8; ++i)
    {
      corners[i] = static_cast<float>(read.Differences[i] * this->Given.Unit);
    }
    if (!this->Given.AreTold(converted))
    {
      corners.fill(std::numeric_limits<float>::quiet_NaN());
    }
    return this->NumberOfRead++;
  }

  void Decide(OpenCells& open, TileBeam& beam) override
  {
    for (std::size_t ray = 0; ray < static_cast<std::size_t>(this->Rays.Count); ++ray)
    {
      if (beam.Cell[ray] != TileBeam::NoCell)
      {
        this->Search(ray, beam.Cell[ray], beam);
        beam.Cell[ray] = TileBeam::NoCell;
      }
    }
    for (std::size_t i = 0; i < open.Count; ++i)
    {
      const std::size_t ray = open.Ray[i];
      if (open.Enter[i] < beam.Behind[ray])
      {
        this->Search(ray, open.Cell[i], beam);
      }
    }
    open.Count = 0;
    this->NumberOfRead = 0;
  }

  /// Search a cell, for each isovalue that passes through it.
  void Search(std::size_t ray, std::int32_t number, TileBeam& beam)
  {
    const ReadCell& read = this->ReadCells[static_cast<std::size_t>(number)];
    const RectilinearRay line = this->Cells.Shape.RayOf(this->Rays, ray);
    const typename Traced::Segment segment(line, read.Place);
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
  void SearchFor(const Corners<double>& corners, std::size_t isovalue,
    const typename Traced::Segment& segment, std::size_t ray, TileBeam& beam)
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
      // Cells that the ray enters later hold no hit.
      const float behind = beam.DistanceOf(enter) + beam.Margin;
      beam.Behind[ray] = std::min(beam.Behind[ray], behind);
    }
    this->Cells.Keep(segment, found, surface, ray, this->Hits);
  }

  const Traced& Cells;
  const BeamLevels<double>& Given;
  const RayBatch& Rays;
  HitBatch& Hits;
  RayBatch::Array<double> FirstEnter; ///< where rays enter the cells of their hits
  std::array<ReadCell, MostCells> ReadCells;
  std::int32_t NumberOfRead = 0;
};

}

#endif
