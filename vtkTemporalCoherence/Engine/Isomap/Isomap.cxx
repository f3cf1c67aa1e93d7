// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Isomap/Isomap.h"

#include "Acceleration/TileBounds.h"
#include "Isomap/BandTracer.h"
#include "Scene/FramePlanes.h"
#include "Scene/Parallel.h"
#include "Trace/RayPieces.h"
#include "Trace/RaySource.h"
#include "Trace/SurfaceTracer.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <limits>
#include <new>
#include <numeric>

namespace TemporalCoherence
{
namespace
{

/// Parts in which a band is built, each spread over the whole picture, with a report after each.
/// Measured by the worst frames of `Benchmark --scenarios isomap`.
constexpr std::int64_t NumberOfParts = 16;

/// The stored entry of a ray that begins below a band.
constexpr float NotInBand = -std::numeric_limits<float>::infinity();

/// Begin the walks of rays where they reach the upper end of the band underneath. A ray that begins
/// below that band and does not reach its end has no walk. (A ray that meets no cell of that band
/// may begin above it.)
void NarrowByCells(
  const TileKnots& knots, const BandScale& scale, const FieldKind& kind, RayBatch& rays)
{
  const CellKnots& table = knots.Cells[static_cast<std::size_t>(ValueDirection::Rising)];
  const BandScale::Key end = scale.KeyOf(scale.Span);
  CellList cells;
  for (std::size_t i = 0; i < static_cast<std::size_t>(rays.Count) && !table.IsEmpty(); ++i)
  {
    const bool beginsBelow = knots.Entries.empty() || knots.Entries[i] == NotInBand;
    const std::size_t first = table.Begin(i), last = table.Begin(i + 1);
    if (!beginsBelow || first == last || (knots.Unresolved >> i & 1u))
    {
      continue;
    }
    const std::size_t knot = FirstNotBelow(table.Get<1>(), first, last, end);
    if (knot == last)
    {
      rays.WalkEnd[i] = rays.WalkBegin[i];
    }
    else
    {
      cells.Append(i, table.Get<2>()[knot]);
    }
  }
  kind.FindEntries(rays, cells);
  for (std::size_t i = 0; i < static_cast<std::size_t>(cells.Count); ++i)
  {
    double& begin = rays.WalkBegin[cells.Ray[i]];
    begin = std::max(begin, cells.Enter[i]);
  }
}

/// The same with fitted knots.
void NarrowByFit(const TileKnots& knots, const BandScale& scale, double tolerance, RayBatch& rays)
{
  const FittedKnots& table = knots.Fitted[static_cast<std::size_t>(ValueDirection::Rising)];
  const float span = scale.Stored(scale.Span) - 2.0f * static_cast<float>(BandScale::StoredError);
  for (std::size_t i = 0; i < static_cast<std::size_t>(rays.Count) && !table.IsEmpty(); ++i)
  {
    const bool beginsBelow = knots.Entries.empty() || knots.Entries[i] == NotInBand;
    const std::size_t first = table.Begin(i), last = table.Begin(i + 1);
    if (!beginsBelow || first == last || (knots.Unresolved >> i & 1u))
    {
      continue;
    }
    const float* const progress = table.Get<0>();
    if (progress[last - 1] < span)
    {
      rays.WalkEnd[i] = rays.WalkBegin[i];
      continue;
    }
    const auto end = std::lower_bound(progress + first, progress + last, span);
    const std::size_t before = std::max(static_cast<std::size_t>(end - progress), first + 1) - 1;
    const double t = static_cast<double>(table.Get<1>()[before]) + rays.Begin[i];
    rays.WalkBegin[i] = std::max(rays.WalkBegin[i], t - 2.0 * tolerance);
  }
}

}

bool Isomap::Band::IsEmpty(std::int64_t tile) const
{
  const TileKnots* const knots = this->At(tile);
  return std::all_of(
    knots, knots + this->Pieces, [](const TileKnots& each) { return each.IsEmpty(); });
}

bool Isomap::CanHold(const Field& field)
{
  constexpr int largest = std::numeric_limits<CellIndex::value_type>::max();
  return field.HasCells() && field.Kind->Abilities().Isomaps &&
    glm::all(glm::lessThanEqual(field.Dimensions, glm::ivec3(largest)));
}

double Isomap::SmallestTolerance(const Field& field, const IndexTransform& transform)
{
  const glm::dmat3 edges(transform.WorldFromIndex);
  const glm::dvec3 cells(field.Dimensions - 1);
  double longest = 0.0;
  for (const glm::dvec3 side : { glm::dvec3(1.0, 1.0, 1.0), glm::dvec3(-1.0, 1.0, 1.0),
         glm::dvec3(1.0, -1.0, 1.0), glm::dvec3(1.0, 1.0, -1.0) })
  {
    longest = std::max(longest, glm::length(edges * (side * cells)));
  }
  constexpr double rounding = 0.5 * std::numeric_limits<float>::epsilon();
  const double kept = rounding * longest / (1.0 - FitShare);
  return std::max(FinestTolerance, kept / field.Kind->VoxelSizeIn(transform).Shortest);
}

KnotForm Isomap::FormFor(const FrameKey& key, const Options& options)
{
  // With nearest interpolation there are no curves to fit. Behind hidden cells, distances may jump.
  const bool isFitted = key.Samples.Between == Interpolation::Linear && !key.Samples.Hidden &&
    options.Tolerance > 0.0 && options.Tolerance >= SmallestTolerance(key.Samples, key.Transform);
  return { isFitted ? options.Tolerance * key.Samples.Kind->VoxelSizeIn(key.Transform).Shortest
                    : 0.0,
    options.HasNormals };
}

bool Isomap::IsOf(const FrameKey& key, const Options& options) const
{
  return this->IsBegun && this->Form == FormFor(key, options) && this->Key.Samples == key.Samples &&
    this->Key.Transform == key.Transform && this->Key.Region == key.Region &&
    this->Key.View == key.View && this->Key.Isosurfaces.Mode == key.Isosurfaces.Mode;
}

void Isomap::Begin(const FrameKey& key, const Options& options)
{
  this->Release();
  this->Key = key;
  this->Form = FormFor(key, options);
  this->IsBegun = true;
}

void Isomap::MoveTo(const Field& now, const Field& before)
{
  if (this->Key.Samples == before)
  {
    this->Key.Samples = now;
  }
}

void Isomap::Release()
{
  this->BuiltBands.clear();
  this->IsBegun = false;
  this->Dropped = false;
}

/// The inputs of a band, and the progress of building it.
struct Isomap::BandSource
{
  BandSource(const Isomap& map, const ValueBand& band, const ValueRangePyramid& pyramid,
    std::size_t memoryLimit)
    : Key(map.Key)
    , Form(map.Form)
    , FiniteRange(pyramid.FiniteRange())
    , Rays(map.Key.View, map.Key.Transform, map.Key.Samples.Dimensions, map.Key.Region)
  {
    this->Active.Build(map.Key.Samples, pyramid, band, map.Key.Isosurfaces.Mode);
    this->Bounds.Build(map.Key.View, map.Key.Transform, this->Active, *map.Key.Samples.Kind);
    this->Tracer = BandTracer::Make({ map.Key.Samples, pyramid.FiniteRange(), &pyramid,
      &this->Active, band, map.Key.Isosurfaces.Mode, map.Form, map.Key.Transform, memoryLimit });
    // If hits are not ordered, lower isovalues do not tell where higher ones can be.
    const bool areOrdered = AreHitsOrdered(map.Key);
    for (const std::shared_ptr<Band>& built : map.BuiltBands)
    {
      if (areOrdered && built->Values.High == band.Low)
      {
        this->Underneath = built;
      }
    }
  }

  /// Begin or go on with the work, up to these limits.
  void Begin(const Limits& upTo)
  {
    this->UpTo = upTo;
    this->Since = std::chrono::steady_clock::now();
    this->HasEnough = false;
  }

  /// True if no further tile should be begun.
  bool IsInterrupted() const { return this->HasEnough.load(std::memory_order_relaxed); }

  /// Trace the rays of a tile. Thread-safe; exceptions do not leave the thread.
  /// \param knots one for each piece of the rays
  void Trace(std::int64_t tile, TileKnots* knots)
  {
    this->TraceRays(tile, knots);
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - this->Since;
    if (this->Memory > this->UpTo.Memory || static_cast<double>(this->Cells) > this->UpTo.Cells ||
      this->HasFailed || taken.count() > this->UpTo.Patience)
    {
      this->HasEnough = true;
    }
  }

  /// Trace the rays of a part of the tiles until the work is interrupted.
  /// \param done how many tiles of each group of the part are traced
  void TracePart(std::int64_t part, std::vector<std::uint8_t>& done, Band& band)
  {
    ParallelFor(static_cast<std::int64_t>(done.size()), 1,
      [&](std::int64_t i)
      {
        std::uint8_t& doneInGroup = done[static_cast<std::size_t>(i)];
        const std::int64_t first = (part + i * NumberOfParts) * TileGrain;
        const std::int64_t count = std::min(TileGrain, NumberOfTiles(this->Key.View.Size) - first);
        for (; doneInGroup < count && !this->IsInterrupted(); ++doneInGroup)
        {
          const std::int64_t tile = first + doneInGroup;
          this->Trace(tile, band.At(tile));
        }
      });
  }

  std::atomic<std::int64_t> Cells{ 0 };
  std::atomic<std::size_t> Memory{ 0 }, Knots{ 0 };
  std::atomic<bool> HasFailed{ false };

private:
  void TraceRays(std::int64_t tile, TileKnots* knots)
  {
    // A solid may be capped where there is no active cell.
    if (this->Key.Isosurfaces.Mode == SurfaceMode::Crossing && this->Bounds.At(tile).IsEmpty())
    {
      return;
    }
    const PixelRect part = PixelsOfTile(this->Key.View.Size, tile);
    RayBatch rays;
    this->Rays.SetUp(part.First, part.Size, rays);
    this->Bounds.Narrow(tile, rays);
    if (this->Underneath)
    {
      const TileKnots& below = *this->Underneath->At(tile);
      const BandScale scale(this->Key.Samples.Type, this->Underneath->Values, this->FiniteRange);
      NarrowByCells(below, scale, *this->Key.Samples.Kind, rays);
      NarrowByFit(below, scale, this->Form.Tolerance, rays);
    }
    try
    {
      if (!this->Rays.Clipper.HasPieces())
      {
        this->TraceInto(*knots, rays);
        return;
      }
      const RayPieces pieces(this->Rays.Clipper, rays);
      RayBatch clipped = rays;
      for (std::size_t piece = 0; pieces.Clip(piece, clipped) != 0; ++piece)
      {
        this->TraceInto(knots[piece], clipped);
        clipped = rays;
      }
    }
    catch (const std::bad_alloc&)
    {
      this->HasFailed = true;
    }
  }

  void TraceInto(TileKnots& knots, const RayBatch& rays)
  {
    this->Cells.fetch_add(this->Tracer->Trace(rays, knots), std::memory_order_relaxed);
    this->Memory.fetch_add(knots.MemoryInBytes(), std::memory_order_relaxed);
    this->Knots.fetch_add(knots.NumberOfKnots(), std::memory_order_relaxed);
  }

  const FrameKey& Key;
  KnotForm Form;
  glm::dvec2 FiniteRange;
  RaySource Rays;
  ActiveCells Active;
  TileBounds Bounds;
  std::shared_ptr<const BandTracer> Tracer;
  std::shared_ptr<const Band> Underneath; ///< the band that ends where this one begins

  Limits UpTo{ 0, 0.0 };
  std::chrono::steady_clock::time_point Since;
  std::atomic<bool> HasEnough{ false };
};

namespace
{

/// The remainder of a limit.
std::size_t RoomFor(std::size_t limit, std::size_t taken)
{
  return limit > taken ? limit - taken : 0;
}

}

Isomap::Outcome Isomap::Build(const ValueBand& band, const ValueRangePyramid& pyramid,
  const Limits& limits, const ReportProgress& report)
{
  const std::int64_t tiles = NumberOfTiles(this->Key.View.Size);
  const std::size_t pieces = this->Key.Region.IsConvex() ? 1 : RegionClipper::MostPieces;
  const std::size_t fixed = static_cast<std::size_t>(tiles) * pieces * sizeof(TileKnots);
  if (!this->MakeRoom(fixed, limits.Memory))
  {
    return Outcome::TooLarge;
  }
  const auto built = std::make_shared<Band>();
  built->Values = band;
  built->HasNormals = this->Form.HasNormals;
  built->Pieces = pieces;
  built->Tiles.resize(static_cast<std::size_t>(tiles) * pieces);

  BandSource source(*this, band, pyramid, limits.Memory);
  const std::int64_t groups = (tiles + TileGrain - 1) / TileGrain;
  std::int64_t tilesBefore = 0;
  for (std::int64_t part = 0; part < NumberOfParts; ++part)
  {
    std::vector<std::uint8_t> tilesDone(
      static_cast<std::size_t>((groups - part + NumberOfParts - 1) / NumberOfParts), 0);
    bool isWhole = false;
    while (!isWhole)
    {
      // A part that takes too long or too much is interrupted for the checks below, and continues
      // after them.
      source.Begin({ RoomFor(limits.Memory, this->MemoryInBytes() + fixed), limits.Cells,
        report ? limits.Patience : std::numeric_limits<double>::infinity() });
      source.TracePart(part, tilesDone, *built);
      isWhole = !source.IsInterrupted();
      if (source.HasFailed)
      {
        throw std::bad_alloc();
      }
      built->Memory = fixed + source.Memory;
      if (!this->MakeRoom(built->Memory, limits.Memory))
      {
        return Outcome::TooLarge;
      }
      // Only whole parts, which are spread over the picture, allow an estimate of the rest.
      const double whole = static_cast<double>(part + 1) / NumberOfParts;
      if (static_cast<double>(source.Cells) > limits.Cells * (isWhole ? whole : 1.0))
      {
        return Outcome::TooCostly;
      }
      const std::int64_t inPart = std::accumulate(tilesDone.begin(), tilesDone.end(), tilesBefore);
      const double done = static_cast<double>(inPart) / static_cast<double>(tiles);
      const double least = static_cast<double>(part) / NumberOfParts;
      if (report && !report(isWhole ? whole : std::min(std::max(done, least), whole)))
      {
        return Outcome::Stopped;
      }
    }
    tilesBefore = std::accumulate(tilesDone.begin(), tilesDone.end(), tilesBefore);
  }
  built->NumberOfKnots = source.Knots;
  built->CellsRead = source.Cells;
  built->LastUse = ++this->Uses;
  this->BuiltBands.push_back(built);
  return Outcome::Built;
}

/// Drop the least recently used bands until there is room for this many more bytes.
/// \return false, dropping nothing, if that is impossible
bool Isomap::MakeRoom(std::size_t bytes, std::size_t limit)
{
  if (bytes > limit)
  {
    return false;
  }
  while (!this->BuiltBands.empty() && this->MemoryInBytes() + bytes > limit)
  {
    this->BuiltBands.erase(std::min_element(this->BuiltBands.begin(), this->BuiltBands.end(),
      [](const auto& a, const auto& b) { return a->LastUse < b->LastUse; }));
    this->Dropped = true;
  }
  return true;
}

ValueBand Isomap::GapAround(double isovalue) const
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  ValueBand gap{ -infinity, infinity };
  for (const auto& band : this->BuiltBands)
  {
    if (band->Values.High < isovalue)
    {
      gap.Low = std::max(gap.Low, band->Values.High);
    }
    else
    {
      gap.High = std::min(gap.High, band->Values.Low);
    }
  }
  return gap;
}

const Isomap::Band* Isomap::Use(double isovalue)
{
  for (const std::shared_ptr<Band>& band : this->BuiltBands)
  {
    if (band->Values.Holds(isovalue))
    {
      band->LastUse = ++this->Uses;
      return band.get();
    }
  }
  return nullptr;
}

bool Isomap::Covers(const std::vector<double>& isovalues) const
{
  return std::all_of(isovalues.begin(), isovalues.end(),
    [this](double isovalue)
    {
      return std::any_of(this->BuiltBands.begin(), this->BuiltBands.end(),
        [isovalue](const auto& band) { return band->Values.Holds(isovalue); });
    });
}

std::size_t Isomap::MemoryInBytes() const
{
  std::size_t bytes = 0;
  for (const std::shared_ptr<Band>& band : this->BuiltBands)
  {
    bytes += band->Memory;
  }
  return bytes;
}

std::size_t Isomap::NumberOfKnots() const
{
  std::size_t knots = 0;
  for (const std::shared_ptr<Band>& band : this->BuiltBands)
  {
    knots += band->NumberOfKnots;
  }
  return knots;
}

}
