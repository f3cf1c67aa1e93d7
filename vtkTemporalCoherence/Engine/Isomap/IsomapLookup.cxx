// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Isomap/IsomapLookup.h"

#include "Isomap/TileGroups.h"
#include "Lattice/RayPieces.h"

#include <algorithm>
#include <cmath>
#include <new>

#include <hwy/base.h>

namespace TemporalCoherence
{
namespace
{

std::uint64_t Bit(std::size_t ray)
{
  return std::uint64_t(1) << ray;
}

/// One bit for each ray.
std::uint64_t RaysOf(const RayBatch& rays)
{
  return ~std::uint64_t(0) >> (RayBatch::Capacity - rays.Count);
}

/// The columns of a tile's knots in one direction; null if there are none.
struct KnotColumns
{
  KnotColumns() = default;
  explicit KnotColumns(const CellKnots& table)
  {
    if (!table.IsEmpty())
    {
      this->Table = &table;
      this->Begins = table.NarrowBegins();
      this->Paths = table.Get<0>();
      this->Cells = table.Get<1>();
    }
  }

  std::size_t Begin(std::size_t ray) const
  {
    return this->Begins ? this->Begins[ray] : this->Table->Begin(ray);
  }

  const CellKnots* Table = nullptr;
  const std::uint16_t* Begins = nullptr; ///< null in large tables
  const BandScale::Key* Paths = nullptr;
  const CellIndex* Cells = nullptr;
};

glm::vec3 Unpack(const PackedNormal& normal)
{
  return { normal[0], normal[1], normal[2] };
}

/// True if a ray can go from one cell to the other directly.
bool AreNeighbors(const CellIndex& a, const CellIndex& b)
{
  return std::abs(a[0] - b[0]) + std::abs(a[1] - b[1]) + std::abs(a[2] - b[2]) <= 1;
}

/// The normal at a key, interpolated between the previous knot and knot `knot`. If their cells are
/// not adjacent, the normal of `knot` alone.
glm::vec3 NormalInCells(const CellKnots& table, const PackedNormal* normals, std::size_t first,
  std::size_t knot, BandScale::Key key)
{
  const CellIndex* const cells = table.Get<1>();
  if (knot == first || !AreNeighbors(cells[knot - 1], cells[knot]))
  {
    return Unpack(normals[knot]);
  }
  const BandScale::Key* const paths = table.Get<0>();
  const int way = paths[knot] - paths[knot - 1];
  // In a mesh the knot before may reach the key, too, without a surface in its cell.
  const int ahead = std::max(key - paths[knot - 1], 0);
  const float share = way > 0 ? static_cast<float>(ahead) / static_cast<float>(way) : 1.0f;
  return glm::mix(Unpack(normals[knot - 1]), Unpack(normals[knot]), share);
}

}

IsomapLookup::IsomapLookup(const FrameKey& key, const Isomap& map, const glm::dvec2& finiteRange,
  std::shared_ptr<const SurfaceTracer> tracer)
  : Key(key)
  , Map(map)
  , FiniteRange(finiteRange)
  , Tolerance(map.Tolerance())
  , HasNormals(map.Form().HasNormals)
  , Pieces(map.Pieces())
  , Rays(key.View, key.Transform, key.Samples.Dimensions, key.Region)
  , Rules(key.Isosurfaces(), key.Samples.Hidden != nullptr)
  , Tracer(std::move(tracer))
{
}

bool IsomapLookup::FindBands(std::size_t group, std::vector<IsovalueKeys>& keys) const
try
{
  keys.clear();
  for (const double isovalue : this->Key.Isosurfaces().Isovalues)
  {
    const GroupBand* const band = this->Map.Find(group, isovalue);
    if (!band)
    {
      return false;
    }
    const BandScale scale(this->Key.Samples.Type, band->Values, this->FiniteRange);
    const KnotGrid grid = scale.GridFor(this->Tolerance, this->Map.Form().LargestProgress);
    IsovalueKeys found{ band, {}, {}, {}, scale.ErrorIn(grid), grid.DistanceStep,
      BandScale::StoredError };
    if (this->Tolerance > 0.0 && scale.Unit > 0.0)
    {
      found.EntryError = std::max(found.EntryError, grid.ProgressStep / scale.Unit);
    }
    for (const ValueDirection direction : { ValueDirection::Rising, ValueDirection::Falling })
    {
      const double progress = scale.Progress(direction, scale.DifferenceOf(isovalue));
      found.Progress[static_cast<std::size_t>(direction)] =
        scale.Unit > 0.0 ? progress / scale.Unit : 0.0;
      found.Steps[static_cast<std::size_t>(direction)] = grid.StepsOf(progress);
      found.Key[static_cast<std::size_t>(direction)] = scale.KeyOf(progress);
    }
    keys.push_back(found);
  }
  return true;
}
catch (const std::bad_alloc&)
{
  return false;
}

/// The knots of a tile for an isovalue, one entry per ray piece; null if all rays miss the band.
const TileKnots* IsomapLookup::KnotsOf(const IsovalueKeys& keys, std::int64_t tile) const
{
  return keys.Band->At(static_cast<std::size_t>(tile % TileGrain), this->Pieces);
}

/// True if no ray of a tile meets an isovalue of any of the bands.
bool IsomapLookup::IsMiss(std::int64_t tile, const std::vector<IsovalueKeys>& keys) const
{
  return std::all_of(keys.begin(), keys.end(),
    [&](const IsovalueKeys& each)
    {
      const TileKnots* const knots = this->KnotsOf(each, tile);
      return !knots ||
        std::all_of(
          knots, knots + this->Pieces, [](const TileKnots& piece) { return piece.IsEmpty(); });
    });
}

/// Prefetch the knots of the next tile while this tile is looked up.
void IsomapLookup::PrefetchNext(std::int64_t tile, const std::vector<IsovalueKeys>& keys) const
{
  const auto group = static_cast<std::size_t>(tile / TileGrain);
  if (tile + 1 == TilesOfGroup(this->Key.View.Size, group).End || this->Tolerance > 0.0)
  {
    return;
  }
  for (const IsovalueKeys& each : keys)
  {
    const TileKnots* const next = this->KnotsOf(each, tile + 1);
    for (std::size_t piece = 0; next && piece < this->Pieces; ++piece)
    {
      next[piece].Prefetch();
    }
  }
}

TraceCounts IsomapLookup::LookUpTile(std::int64_t tile, const PixelRect& part,
  const std::vector<IsovalueKeys>& keys, Frame& frame, std::uint64_t& unresolved,
  TileHits& tileHits) const
{
  TraceCounts counts;
  unresolved = 0;
  if (this->IsMiss(tile, keys))
  {
    StoreMisses(tile, part, this->Key.View.Parallel, frame);
    counts.DefiniteMisses += static_cast<std::int64_t>(part.Size.x) * part.Size.y;
    return counts;
  }
  this->PrefetchNext(tile, keys);
  frame.ClearTiles[static_cast<std::size_t>(tile)] = 0;
  RayBatch& rays = tileHits.Rays;
  this->Rays.SetUp(part.First, part.Size, rays, &tileHits.World);
  Found found(keys, tileHits.Hits);
  found.Hits.Clear(rays.Count);
  if (this->Rays.Clipper.HasPieces())
  {
    this->FindInPieces(tile, rays, found);
  }
  else
  {
    this->FindSurfaces(tile, 0, rays, found);
  }
  unresolved = found.Unresolved;
  counts = this->StoreFound(unresolved, tileHits, frame);
  if (this->HasNormals)
  {
    this->StoreNormals(rays, found, frame);
  }
  return counts;
}

/// Write the hits of a tile.
/// \param unresolved rays to leave out of the counts, one bit each
TraceCounts IsomapLookup::StoreFound(
  std::uint64_t unresolved, TileHits& tileHits, Frame& frame) const
{
  TraceCounts counts;
  const RayBatch& rays = tileHits.Rays;
  tileHits.AreAll = true;
  counts.CellsRead = tileHits.Hits.CellsRead;
  RayBatch::Array<Answer> answers;
  int misses = 0, caps = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(rays.Count); ++i)
  {
    const HitKind kind = tileHits.Hits.Kind[i];
    misses += kind == HitKind::None;
    caps += kind == HitKind::Cap;
    answers[i] = kind == HitKind::None ? Answer::DefiniteMiss
      : kind == HitKind::Cap           ? Answer::PossibleHit
                                       : Answer::DefiniteHit;
  }
  counts.DefiniteHits = rays.Count - misses - caps;
  for (std::uint64_t left = unresolved; left != 0; left &= left - 1)
  {
    const HitKind kind = tileHits.Hits.Kind[hwy::Num0BitsBelowLS1Bit_Nonzero64(left)];
    misses -= kind == HitKind::None;
    caps -= kind == HitKind::Cap;
    counts.DefiniteHits -= kind != HitKind::None && kind != HitKind::Cap;
  }
  counts.DefiniteMisses = misses;
  counts.PossibleHits = caps;
  StoreHits(rays, tileHits.Hits, answers, this->Key.View.Parallel, frame);
  return counts;
}

/// Look up all rays in their first pieces, then rays without a hit in their next pieces.
void IsomapLookup::FindInPieces(std::int64_t tile, const RayBatch& rays, Found& found) const
{
  const RayPieces pieces(this->Rays.Clipper, rays);
  std::uint64_t met = 0;
  for (std::size_t piece = 0; piece < RegionClipper::MostPieces; ++piece)
  {
    RayBatch clipped = rays;
    found.Wanted = pieces.Clip(piece, clipped) & ~met & ~found.Unresolved;
    if (found.Wanted != 0)
    {
      this->FindSurfaces(tile, piece, clipped, found);
    }
    for (std::size_t ray = 0; ray < static_cast<std::size_t>(rays.Count); ++ray)
    {
      met |= found.Hits.Kind[ray] != HitKind::None ? Bit(ray) : 0;
    }
  }
}

/// Look up the first surface of the wanted rays, which are clipped to one of their pieces.
void IsomapLookup::FindSurfaces(
  std::int64_t tile, std::size_t piece, const RayBatch& rays, Found& found) const
{
  for (std::size_t surface = 0; surface < found.Isovalues.size(); ++surface)
  {
    const TileKnots* const ofPieces = this->KnotsOf(found.Isovalues[surface], tile);
    if (!ofPieces)
    {
      continue;
    }
    const TileKnots& knots = ofPieces[piece];
    RayBatch::Array<std::uint8_t> directions;
    const std::uint64_t which = this->BeginOn(surface, knots, rays, directions, found);
    if (this->Tolerance > 0.0)
    {
      this->FindInFittedKnots(surface, which, directions, rays, knots, found);
    }
    else
    {
      this->FindInCells(surface, which, directions, rays, knots, found);
    }
  }
}

/// Find the direction in which each ray reaches an isovalue.
/// \return one bit for each ray to look up; the others are capped or unresolved
std::uint64_t IsomapLookup::BeginOn(std::size_t surface, const TileKnots& knots,
  const RayBatch& rays, RayBatch::Array<std::uint8_t>& directions, Found& found) const
{
  const auto rising = static_cast<std::size_t>(ValueDirection::Rising);
  const auto falling = static_cast<std::size_t>(ValueDirection::Falling);
  const IsovalueKeys& keys = found.Isovalues[surface];
  found.Unresolved |= knots.Unresolved & found.Wanted;
  directions.fill(static_cast<std::uint8_t>(rising));
  std::uint64_t which = ~knots.Unresolved & found.Wanted;
  for (std::size_t ray = 0; ray < static_cast<std::size_t>(rays.Count) && !knots.Entries.empty();
       ++ray)
  {
    if (!(which >> ray & 1u))
    {
      continue;
    }
    const double ahead = keys.Progress[rising] - static_cast<double>(knots.Entries[ray]);
    if (std::abs(ahead) <= keys.EntryError)
    {
      found.Unresolved |= Bit(ray);
      which &= ~Bit(ray);
    }
    else if (ahead < 0.0 && this->Key.Isosurfaces().Mode == SurfaceMode::Threshold)
    {
      this->Rules.CapWhereItBegins(
        rays.Begin[ray], static_cast<SurfaceIndex>(surface), ray, found.Hits);
      which &= ~Bit(ray);
    }
    else if (ahead < 0.0)
    {
      directions[ray] = static_cast<std::uint8_t>(falling);
    }
  }
  return which;
}

/// Find the first knot of each ray at a key or behind it.
/// \param cells   gets the cells of these knots
/// \param places  gets the places of knots in their tables
void IsomapLookup::FindKnots(const IsovalueKeys& keys, std::uint64_t which,
  const RayBatch::Array<std::uint8_t>& directions, const TileKnots& knots, RayCells& cells,
  RayBatch::Array<std::size_t>& places)
{
  std::array<KnotColumns, NumberOfDirections> columns;
  for (std::size_t direction = 0; direction < NumberOfDirections; ++direction)
  {
    columns[direction] = KnotColumns(knots.Cells[direction]);
  }
  cells.Rays = 0;
  CellIndex cell = columns[columns[0].Table ? 0 : 1].Cells[0];
  for (std::size_t ray = 0; ray < RayBatch::Capacity; ++ray)
  {
    const std::size_t direction = directions[ray];
    const KnotColumns& table = columns[direction];
    if (table.Table)
    {
      const std::size_t end = table.Begin(ray + 1);
      const std::size_t hit =
        FirstNotBelow(table.Paths, table.Begin(ray), end, keys.Key[direction]);
      const std::uint64_t isFound = static_cast<std::uint64_t>(hit != end) & which >> ray;
      places[ray] = isFound ? hit : places[ray];
      cell = isFound ? table.Cells[hit] : cell;
      cells.Rays |= isFound << ray;
    }
    for (std::size_t a = 0; a < 3; ++a)
    {
      cells.Cell[a][ray] = cell[a];
    }
  }
}

/// Search the cells of further knots: in a mesh, a ray may fail to reach the key of a knot in the
/// knot's cell.
/// \param missing one bit for each ray that has no surface in the cell of its knot
/// \param places  of these knots; moved on to the last knots searched
/// \return one bit for each ray without a surface, or whose surface other cells share
std::uint64_t IsomapLookup::SearchNextKnots(std::uint64_t missing,
  const RayBatch::Array<std::uint8_t>& directions, const RayBatch& rays, const TileKnots& knots,
  RayCells& cells, RayBatch::Array<std::size_t>& places, HitBatch& hits) const
{
  constexpr int mostKnots = 6; // a ray that meets nothing in so many is traced
  std::uint64_t lost = 0;
  for (int knot = 0; knot < mostKnots && missing != 0; ++knot)
  {
    cells.Rays = missing;
    for (std::uint64_t left = missing; left != 0; left &= left - 1)
    {
      const std::size_t ray = hwy::Num0BitsBelowLS1Bit_Nonzero64(left);
      const CellKnots& table = knots.Cells[directions[ray]];
      if (++places[ray] >= table.Begin(ray + 1))
      {
        cells.Rays &= ~Bit(ray);
        lost |= Bit(ray);
        continue;
      }
      const CellIndex& cell = table.Get<1>()[places[ray]];
      for (std::size_t a = 0; a < 3; ++a)
      {
        cells.Cell[a][ray] = cell[a];
      }
    }
    const SearchedCells searched =
      cells.Rays != 0 ? this->Tracer->SearchCells(rays, cells, hits) : SearchedCells();
    missing = searched.Missing;
    lost |= searched.Shared;
  }
  return lost | missing;
}

void IsomapLookup::FindInCells(std::size_t surface, std::uint64_t which,
  const RayBatch::Array<std::uint8_t>& directions, const RayBatch& rays, const TileKnots& knots,
  Found& found) const
{
  HitBatch& hits = found.Hits;
  if (knots.NumberOfKnots() == 0)
  {
    return;
  }
  RayCells cells;
  cells.Surface = surface;
  RayBatch::Array<std::size_t> places{};
  FindKnots(found.Isovalues[surface], which & RaysOf(rays), directions, knots, cells, places);
  const std::uint64_t searched = cells.Rays; // further knots have other cells
  if (searched != 0)
  {
    const SearchedCells first = this->Tracer->SearchCells(rays, cells, hits);
    found.Unresolved |= first.Shared;
    found.Unresolved |= this->Key.Samples.Shape->Abilities().IsMesh
      ? this->SearchNextKnots(first.Missing, directions, rays, knots, cells, places, hits)
      : first.Missing;
  }
  for (std::uint64_t left = this->HasNormals ? searched : 0; left != 0; left &= left - 1)
  {
    const std::size_t ray = hwy::Num0BitsBelowLS1Bit_Nonzero64(left), direction = directions[ray];
    if (hits.Surface[ray] == static_cast<int>(surface))
    {
      const CellKnots& table = knots.Cells[direction];
      found.Normals[ray] = NormalInCells(table, knots.Normals[direction].Get<0>(), table.Begin(ray),
        places[ray], found.Isovalues[surface].Key[direction]);
    }
  }
}

void IsomapLookup::FindInFittedKnots(std::size_t surface, std::uint64_t which,
  const RayBatch::Array<std::uint8_t>& directions, const RayBatch& rays, const TileKnots& knots,
  Found& found) const
{
  const IsovalueKeys& keys = found.Isovalues[surface];
  HitBatch& hits = found.Hits;
  for (std::size_t ray = 0; ray < static_cast<std::size_t>(rays.Count); ++ray)
  {
    const std::size_t direction = directions[ray];
    const FittedKnots& table = knots.Fitted[direction];
    if (!(which >> ray & 1u) || table.IsEmpty() || table.Begin(ray) == table.Begin(ray + 1))
    {
      continue;
    }
    FitPoint point{};
    const FitAnswer answer =
      FindInFit({ table.Get<0>(), table.Get<1>(), table.Begin(ray), table.Begin(ray + 1) },
        keys.Steps[direction], keys.StepError, point);
    const double depth = rays.Begin[ray] + point.Distance * keys.DistanceStep;
    if (answer == FitAnswer::UnsureMiss || answer == FitAnswer::UnsureHit)
    {
      found.Unresolved |= Bit(ray);
    }
    else if (answer == FitAnswer::Reached && depth < hits.Depth[ray])
    {
      hits.Depth[ray] = depth;
      hits.Surface[ray] = static_cast<SurfaceIndex>(surface);
      hits.Kind[ray] =
        HitRules::KindOf(direction == static_cast<std::size_t>(ValueDirection::Falling));
      if (this->HasNormals)
      {
        const PackedNormal* const normals = knots.Normals[direction].Get<0>();
        found.Normals[ray] = NormalOnPiece(Unpack(normals[2 * point.Before]),
          Unpack(normals[2 * point.Knot + 1]), Unpack(normals[2 * point.Knot]), point.Share);
      }
    }
  }
}

/// Write the normals of entries and exits, turned towards the viewer.
void IsomapLookup::StoreNormals(const RayBatch& rays, const Found& found, Frame& frame) const
{
  const int width = this->Key.View.Size.x;
  for (std::size_t i = 0; i < static_cast<std::size_t>(rays.Count); ++i)
  {
    const HitKind kind = found.Hits.Kind[i];
    if (kind == HitKind::Entry || kind == HitKind::Exit)
    {
      const std::int32_t pixel = rays.Pixel[i];
      const glm::vec3 along(this->Key.View.RayThrough(pixel % width, pixel / width).Direction);
      const float length = glm::length(found.Normals[i]);
      const glm::vec3 normal = length > 0.0f ? found.Normals[i] / length : -along;
      frame.Normals[static_cast<std::size_t>(pixel)] =
        glm::dot(normal, along) > 0.0f ? -normal : normal;
    }
  }
}

}
