// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "IsomapLookup.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace TemporalCoherence
{

IsomapLookup::IsomapLookup(const FrameKey& key, const std::vector<const Isomap::Band*>& bands,
  const glm::dvec2& finiteRange)
  : Key(key)
  , Rays(key.Seen, key.Where, key.Samples.Dimensions)
  , Tracer(SurfaceTracer::Make({ key.Samples, key.Sought, finiteRange, nullptr }))
{
  for (std::size_t surface = 0; surface < bands.size(); ++surface)
  {
    const ValueBand& values = bands[surface]->Values;
    const BandScale scale(values);
    const double difference = key.Sought.Isovalues[surface] - values.Low;
    const double largest =
      std::max(std::abs(finiteRange.x - values.Low), std::abs(finiteRange.y - values.Low));
    Sought sought{ bands[surface], {}, difference,
      32.0 * std::numeric_limits<float>::epsilon() * (largest + scale.Span) };
    for (const Course course : { Course::Rising, Course::Falling })
    {
      sought.Key[static_cast<std::size_t>(course)] =
        scale.KeyOf(scale.Progress(course, difference));
    }
    this->Isovalues.push_back(sought);
  }
}

TraceCounts IsomapLookup::Look(
  std::int64_t tile, const PixelRect& part, Frame& frame, std::uint64_t& open) const
{
  TraceCounts counts;
  open = 0;
  const bool isMiss = std::all_of(this->Isovalues.begin(), this->Isovalues.end(),
    [tile](const Sought& sought)
    { return sought.Band->Tiles[static_cast<std::size_t>(tile)].IsEmpty(); });
  if (isMiss)
  {
    StoreMisses(tile, part, this->Key.Seen.Parallel, frame);
    counts.DefiniteMisses += static_cast<std::int64_t>(part.Size.x) * part.Size.y;
    return counts;
  }
  frame.ClearTiles[static_cast<std::size_t>(tile)] = 0;
  RayBatch rays;
  HitBatch hits;
  this->Rays.SetUp(part.First, part.Size, rays);
  hits.Clear(rays.Count);
  for (std::size_t surface = 0; surface < this->Isovalues.size(); ++surface)
  {
    open |= this->LookFor(surface, tile, rays, hits);
  }
  counts.CellsRead = hits.CellsRead;
  RayBatch::Array<Answer> answers;
  for (std::size_t i = 0; i < static_cast<std::size_t>(rays.Count); ++i)
  {
    const bool isKnown = !(open >> i & 1u);
    const bool isHit = hits.Kind[i] != HitKind::None;
    counts.DefiniteHits += isKnown && isHit;
    counts.DefiniteMisses += isKnown && !isHit;
    answers[i] = isHit ? Answer::DefiniteHit : Answer::DefiniteMiss;
  }
  StoreHits(rays, hits, answers, this->Key.Seen.Parallel, frame);
  return counts;
}

std::uint64_t IsomapLookup::LookFor(
  std::size_t surface, std::int64_t tile, const RayBatch& rays, HitBatch& hits) const
{
  const Sought& sought = this->Isovalues[surface];
  const TileKnots& knots = sought.Band->Tiles[static_cast<std::size_t>(tile)];
  std::uint64_t open = 0;
  CellList cells;
  cells.Surface = surface;
  for (std::size_t ray = 0; ray < static_cast<std::size_t>(rays.Count); ++ray)
  {
    std::size_t course = static_cast<std::size_t>(Course::Rising);
    if (!knots.Entries.empty())
    {
      const double ahead = sought.Difference - static_cast<double>(knots.Entries[ray]);
      if (std::abs(ahead) <= sought.EntryError)
      {
        open |= std::uint64_t(1) << ray;
        continue;
      }
      if (ahead < 0.0)
      {
        course = static_cast<std::size_t>(Course::Falling);
        if (this->Key.Sought.Mode == SurfaceMode::Threshold)
        {
          this->Cap(surface, ray, rays, hits);
          continue;
        }
      }
    }
    const CellKnots& table = knots.Cells[course];
    if (table.IsEmpty())
    {
      continue;
    }
    const BandScale::Key key = sought.Key[course];
    const std::size_t end = table.Begin(ray + 1);
    const std::size_t contact = FirstOf(table.Get<1>(), table.Begin(ray), end, key);
    if (contact == end)
    {
      continue;
    }
    const CellIndex* const indices = table.Get<2>();
    const double enter = EntryInto(indices[contact], rays, ray);
    if (enter < hits.Contact[ray])
    {
      hits.Contact[ray] = enter;
      hits.FromInside[ray] = course == static_cast<std::size_t>(Course::Falling);
    }
    const std::size_t hit = FirstOf(table.Get<0>(), contact, end, key);
    if (hit != end)
    {
      const auto at = static_cast<std::size_t>(cells.Count++);
      cells.Ray[at] = ray;
      cells.Cell[at] = glm::ivec3(indices[hit][0], indices[hit][1], indices[hit][2]);
    }
  }
  return open | this->Tracer->SearchCells(rays, cells, hits);
}

/// The ray begins in a solid. Of several the one of the highest isovalue is seen.
void IsomapLookup::Cap(
  std::size_t surface, std::size_t ray, const RayBatch& rays, HitBatch& hits) const
{
  const std::vector<double>& isovalues = this->Key.Sought.Isovalues;
  const bool isHighest = hits.Kind[ray] != HitKind::Cap ||
    isovalues[surface] > isovalues[static_cast<std::size_t>(hits.Surface[ray])];
  if (isHighest)
  {
    hits.Depth[ray] = rays.Begin[ray];
    hits.Contact[ray] = rays.Begin[ray];
    hits.FromInside[ray] = 0;
    hits.Surface[ray] = static_cast<std::int16_t>(surface);
    hits.Kind[ray] = HitKind::Cap;
  }
}

}
