// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MeshFields/MeshBandTracer.h"

#include "Isomap/KnotCollector.h"
#include "Mesh/KernelsCells.h"
#include "MeshFields/MeshDifference.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace TemporalCoherence
{
namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr auto Rising = static_cast<std::size_t>(ValueDirection::Rising);
constexpr auto Falling = static_cast<std::size_t>(ValueDirection::Falling);

/// Between two ways to compute a value, relative to the largest one.
constexpr double Rounding = 256.0 * std::numeric_limits<double>::epsilon();

/// How far a ray has come through a band.
struct RayProgress
{
  std::array<double, NumberOfDirections> Reached{ -Infinity, -Infinity }; ///< infinity: done
  std::array<BandScale::Key, NumberOfDirections> Noted{};                 ///< of the last knots
  bool HasEntered = false;

  bool IsDone() const
  {
    return this->Reached[Rising] == Infinity && this->Reached[Falling] == Infinity;
  }
};

}

void MeshBandTracer::Append(const MeshCell& cell, CellNumber, const glm::ivec3& place,
  const MeshTile& tile, std::uint64_t which, std::vector<Passage>& passages) const
{
  const BandScale scale(this->Scene.Samples.Type, this->Scene.Band, this->Scene.FiniteRange);
  const MeshDifference fromLowest(this->Scene.Band.Low, this->Scene.FiniteRange);
  MeshKernels::CellDifferences differences;
  fromLowest.Of(cell, differences);
  const auto count = static_cast<std::size_t>(cell.NumberOfPoints());
  bool isFinite = true;
  for (std::size_t i = 0; i < count; ++i)
  {
    isFinite &= std::isfinite(cell.Values[i]);
  }
  const auto [least, most] = std::minmax_element(
    differences.begin(), differences.begin() + static_cast<std::ptrdiff_t>(count));
  const double unit = scale.Isovalues.Factor / fromLowest.Unit();
  const CellIndex index = { static_cast<std::uint16_t>(place.x),
    static_cast<std::uint16_t>(place.y), static_cast<std::uint16_t>(place.z) };

  MeshKernels::CellSpans spans;
  const bool isExact = cell.Shape == MeshCellShape::Tetrahedron;
  (isExact ? MeshKernels::TetrahedronSpans : MeshKernels::HexahedronSpans)(
    cell, differences, tile.InMesh, which, spans);
  ForEachRay(which,
    [&](std::size_t ray)
    {
      for (std::size_t i = 0; i < spans.Count[ray]; ++i)
      {
        const MeshKernels::CellSpan& span = spans.Spans[ray][i];
        if (span.Out < tile.Rays.Begin[ray] || span.In > tile.Rays.End[ray])
        {
          continue;
        }
        // Where the ray begins within a tetrahedron, values are linear.
        const double begin = tile.Rays.Begin[ray];
        const double share = isExact && span.In < begin && span.Out > span.In
          ? (begin - span.In) / (span.Out - span.In)
          : 0.0;
        const double atBegin = (1.0 - share) * span.AtIn + share * span.AtOut;
        const double low = isExact ? std::min(atBegin, span.AtOut) : *least;
        const double high = isExact ? std::max(atBegin, span.AtOut) : *most;
        passages.push_back({ span.In, unit * atBegin, unit * span.AtOut, unit * low, unit * high,
          isFinite, isExact, static_cast<std::uint8_t>(ray), index });
      }
    });
}

/// Find the passages of all rays, those of a ray in their order along it.
/// \return number of cells read
std::int64_t MeshBandTracer::Find(const RayBatch& rays, std::vector<Passage>& passages) const
{
  const MeshTile tile(rays, this->Tree, this->Leaves, RayLimits::None);
  const std::int64_t cellsRead =
    VisitCells(tile, this->Tree, this->Leaves, RaysWithWalk(rays), rays.WalkEnd,
      [&](CellNumber number, std::int64_t rank, const MeshCell& cell, std::uint64_t which)
      { this->Append(cell, number, MeshTree::PlaceOf(rank), tile, which, passages); });
  std::sort(passages.begin(), passages.end(),
    [](const Passage& a, const Passage& b) {
      return a.Ray != b.Ray ? a.Ray < b.Ray : a.In != b.In ? a.In < b.In : a.Place < b.Place;
    });
  return cellsRead;
}

std::int64_t MeshBandTracer::Trace(const RayBatch& rays, TileKnots& knots) const
{
  const BandScale scale(this->Scene.Samples.Type, this->Scene.Band, this->Scene.FiniteRange);
  const bool isSolid = this->Scene.Mode == SurfaceMode::Threshold;
  std::vector<Passage> passages;
  const std::int64_t cellsRead = this->Find(rays, passages);
  KnotCollector collector(rays, this->Scene.Form, scale);
  std::vector<float> entries(
    static_cast<std::size_t>(rays.Count), -std::numeric_limits<float>::infinity());
  bool hasEntries = false;
  RayProgress progress;
  for (std::size_t i = 0; i < passages.size(); ++i)
  {
    const Passage& passage = passages[i];
    if (i == 0 || passage.Ray != passages[i - 1].Ray)
    {
      progress = RayProgress();
      progress.Reached[Falling] = isSolid ? Infinity : -Infinity;
    }
    if (progress.IsDone() || collector.MemoryInBytes() > this->Scene.MemoryLimit)
    {
      continue;
    }
    if (!passage.IsFinite)
    {
      collector.GiveUp(passage.Ray);
      progress.Reached.fill(Infinity);
      continue;
    }
    const double error =
      Rounding * (std::max(std::abs(passage.Low), std::abs(passage.High)) + scale.Span);
    if (!progress.HasEntered && !isSolid)
    {
      // Where a ray begins within a hexahedron, its value there is not known.
      const bool isClipped = passage.In < rays.Begin[passage.Ray];
      if (isClipped && !passage.IsExact && passage.High + error >= 0.0)
      {
        collector.GiveUp(passage.Ray);
        progress.Reached.fill(Infinity);
        continue;
      }
      if (passage.AtIn + error >= 0.0)
      {
        entries[passage.Ray] = scale.Stored(passage.AtIn);
        hasEntries = true;
      }
      progress.Reached[Rising] = passage.AtIn - error > scale.Span ? Infinity : -Infinity;
      progress.Reached[Falling] = passage.AtIn + error < 0.0 ? Infinity : -Infinity;
    }
    progress.HasEntered = true;
    const std::array<double, 2> most = { passage.High, scale.Span - passage.Low };
    const std::array<double, 2> known = { std::max(passage.AtIn, passage.AtOut),
      scale.Span - std::min(passage.AtIn, passage.AtOut) };
    for (std::size_t direction = 0; direction < NumberOfDirections; ++direction)
    {
      double& reached = progress.Reached[direction];
      if (reached == Infinity || !(most[direction] > reached))
      {
        continue;
      }
      const BandScale::Key key = scale.KeyOf(most[direction] + error);
      if (key > progress.Noted[direction])
      {
        progress.Noted[direction] = key;
        collector.AddCell(direction, passage.Ray, key, passage.Place, passage.In);
      }
      reached =
        most[direction] + error > scale.Span ? Infinity : std::max(reached, known[direction]);
    }
  }
  collector.HandOver(this->Scene.Samples, this->Scene.FiniteRange, this->Scene.Transform, knots);
  if (hasEntries)
  {
    knots.Entries = std::move(entries);
  }
  return cellsRead;
}

}
