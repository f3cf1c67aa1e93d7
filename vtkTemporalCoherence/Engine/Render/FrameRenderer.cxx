// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Render/FrameRenderer.h"

#include "Isomap/IsomapLookup.h"
#include "Render/TileLoop.h"
#include "Scene/Stopwatch.h"

#include <algorithm>
#include <bitset>
#include <memory>
#include <new>
#include <numeric>
#include <utility>
#include <vector>

namespace TemporalCoherence
{
namespace
{

/// Fewer rays than this are traced without space leaping.
constexpr std::int64_t FewRays = 256;

/// Part of the progress of a frame that is the building of an isomap, where it has to be built.
constexpr double ShareOfBuilding = 0.9;

/// Progress in one part of a frame, as progress of the frame.
Isomap::ReportProgress ReportOf(const Isomap::ReportProgress& frame, double begin, double end)
{
  if (!frame)
  {
    return {};
  }
  return [frame, begin, end](double progress) { return frame(begin + progress * (end - begin)); };
}

/// True if the colours of a cached image may be taken over: those of the same surfaces under the
/// same lights, which may have moved, as a headlight moves with every view (the paper's choice).
bool HasColorsFor(const CachedImage& cached, const FrameKey& next)
{
  Appearance look = cached.Key.Look;
  if (look.Lights.size() != next.Look.Lights.size())
  {
    return false;
  }
  for (std::size_t i = 0; i < look.Lights.size(); ++i)
  {
    look.Lights[i].Position = next.Look.Lights[i].Position;
    look.Lights[i].Direction = next.Look.Lights[i].Direction;
  }
  return look == next.Look && cached.Key.Sought == next.Sought && !next.Look.ColorByAnswer;
}

}

bool FrameRenderer::Render(
  const FrameKey& key, const Options& options, const Isomap::ReportProgress& report)
{
  const FrameStatistics before = this->Counters;
  this->Counters = FrameStatistics();
  bool isMade = false;
  try
  {
    Stopwatch watch(this->Counters.FrameTime);
    const auto suits = [&](const CachedImage& image)
    {
      const bool isTooEroded = image.IsEroded && options.Accuracy == ReuseAccuracy::Bounded;
      return !isTooEroded && ImageQuery::CanAsk(image.Key, options.Accuracy);
    };
    this->Map.Trim(options.Map.MemoryLimit);
    {
      Stopwatch comparing(this->Counters.TraceTime);
      this->CompareSamples(key);
    }
    const std::shared_ptr<CachedImage> nearest = this->Images.Find(key, options.Images, suits);
    this->Counters.Made = this->ChooseRoute(key, options, nearest.get());
    this->Counters.Rays = static_cast<std::int64_t>(key.Seen.Size.x) * key.Seen.Size.y;
    isMade = this->TakeRoute(key, options, nearest.get(), report);
  }
  catch (...)
  {
    this->Counters = before;
    throw;
  }
  if (!isMade)
  {
    this->Counters = before;
  }
  return isMade;
}

Isomap::Outcome FrameRenderer::BuildIsomap(
  const FrameKey& key, const Options& options, const Isomap::ReportProgress& report)
{
  this->Counters.IsomapBuildTime = 0.0;
  if (key.Sought.Isovalues.empty() || !this->Map.CanBuild(key, options.Map))
  {
    return Isomap::Outcome::Impossible;
  }
  this->CompareSamples(key);
  this->PreparePyramid(key);
  this->Map.DropNarrowBands(key, options.Map, this->Pyramid());
  return this->BuildBands(key, options, report);
}

bool FrameRenderer::TakeRoute(const FrameKey& key, const Options& options, CachedImage* nearest,
  const Isomap::ReportProgress& report)
{
  const Isomap::ReportProgress tiles = options.ReportsTiles ? report : Isomap::ReportProgress();
  const Isomap::ReportProgress afterBuilding = ReportOf(tiles, ShareOfBuilding, 1.0);
  switch (this->Counters.Made)
  {
    case Route::Redisplay:
      this->CountKnownHits();
      return true;
    case Route::Reshade:
      this->PreparePyramid(key); // which a frame of other data that failed may have let go
      this->Front->Key = key;
      this->ShadeAgain();
      this->CountKnownHits();
      return true;
    case Route::IsomapBuild:
      switch (this->BuildBands(key, options, ReportOf(report, 0.0, ShareOfBuilding)))
      {
        case Isomap::Outcome::Stopped:
          return false;
        case Isomap::Outcome::Built:
          return this->LookUpFrame(key, options, afterBuilding);
        default:
          break;
      }
      // Now that it is known to be impossible, the next best.
      this->Counters.Made = this->ChooseRoute(key, options, nearest);
      return this->TraceFrame(key, options, nullptr, afterBuilding);
    case Route::IsomapLookup:
      return this->LookUpFrame(key, options, tiles);
    case Route::ImageCache:
      // Of other samples, no image tells but the last one, where they are not seen.
      return this->TraceFrame(
        key, options, CompareFrames(this->Front->Key, key).Data ? nullptr : nearest, tiles);
    default:
      return this->TraceFrame(key, options, nullptr, tiles);
  }
}

Route FrameRenderer::ChooseRoute(
  const FrameKey& key, const Options& options, const CachedImage* nearest) const
{
  if (this->Front->Picture.IsEmpty())
  {
    return Route::Cold;
  }
  HeldForReuse held;
  held.IsExact = this->Front->IsExact;
  held.Image = nearest != nullptr;
  held.CanBuildIsomap = this->Map.CanBuild(key, options.Map);
  held.IsIsomapExact = this->Map.Built().Tolerance() == 0.0 && !options.Map.HasNormals;
  held.Isomap = this->Map.Covers(key, options.Map);
  held.ShareToTrace = this->Steps.ShareToTrace();
  ReuseSwitches switches = options.Reuse;
  // A picture that is as near as an isomap told is not what is asked for of another.
  switches.RefineWhenStill |= !(this->FrontForm == Isomap::FormFor(key, options.Map));
  switches.RefineWhenStill |= options.Accuracy == ReuseAccuracy::Exact || !switches.ImageCache;
  return PlanRoute(this->Front->Key, key, switches, held);
}

/// Make a frame by tracing: from a cached image, or, on that route without one, where the last
/// picture cannot be copied; or, on that route, with the last picture's hits as hints; or cold.
/// \return false if it was stopped, as all that make frames do
bool FrameRenderer::TraceFrame(const FrameKey& key, const Options& options, CachedImage* cached,
  const Isomap::ReportProgress& report)
{
  const bool isExact = !cached || options.Accuracy == ReuseAccuracy::Exact;
  const bool interpolates = !isExact && options.Accuracy == ReuseAccuracy::Paper &&
    options.InterpolateColors && HasColorsFor(*cached, key) && !key.Sought.IsTranslucent();
  {
    Stopwatch watch(this->Counters.TraceTime);
    this->PreparePyramid(key);
    if (options.SpaceLeaping)
    {
      this->PrepareActiveCells(key);
    }
    this->BeginFrame(key);
  }
  CachedImage& made = *this->Back;
  const bool isFromCache = this->Counters.Made == Route::ImageCache;
  const bool isCopied = isFromCache && !cached;
  made.Picture.IsFromCache = isFromCache;
  std::unique_ptr<ImageQuery> query;
  if (!isExact)
  {
    Stopwatch watch(this->Counters.QueryTime);
    query = std::make_unique<ImageQuery>(*cached, key, options.Accuracy);
  }
  const LeapedSpace space{ options.SpaceLeaping ? this->Cells->Active.get() : nullptr,
    &this->Bounds };
  TileScene scene{ key, space.Active, space.Bounds, this->Pyramid().FiniteRange(), query.get(),
    interpolates };
  if (this->Counters.Made == Route::ThresholdHint)
  {
    scene.Before = &this->Front->Picture;
    scene.IsRaised = CompareFrames(this->Front->Key, key).Raised;
  }
  const HitSet hits = interpolates ? HitSet::NotDefinite : HitSet::All;
  const TileTracer tracer(scene);
  const TileShader shader(key, this->Pyramid().FiniteRange(), space, hits, hits);
  const bool isMade = CountTiles(key.Seen.Size, report, this->Counters,
    [&](std::int64_t tile, const PixelRect& part)
    {
      if (isCopied && this->Steps.CanCopy(tile))
      {
        return CopyTile(tile, part, this->Front->Picture, key.Seen.Parallel, made.Picture);
      }
      TraceCounts counts = tracer.Trace(tile, part, made.Picture);
      shader.Shade(tile, part, made.Picture, counts);
      return counts;
    });
  if (!isMade)
  {
    return false;
  }
  made.IsExact = isExact;
  made.IsEroded = !isExact && options.Accuracy == ReuseAccuracy::Paper;
  this->FrontForm = Isomap::FormFor(key, options.Map);
  if (this->Counters.Made == Route::Cold || this->Counters.Made == Route::ThresholdHint)
  {
    this->Cold = { this->Counters.FieldSamples / 8, key.Sought };
  }
  this->FinishFrame(options);
  return true;
}

/// Build the bands of the isomap that a frame needs and that are not there.
Isomap::Outcome FrameRenderer::BuildBands(
  const FrameKey& key, const Options& options, const Isomap::ReportProgress& report)
{
  Stopwatch watch(this->Counters.IsomapBuildTime);
  this->PreparePyramid(key);
  Isomap::Outcome outcome = Isomap::Outcome::TooLarge;
  try
  {
    outcome = this->Map.Build(key, options.Map, *this->Front, this->Pyramid(), this->Cold, report);
    this->Counters.FieldSamples += 8 * this->Map.CellsRead();
  }
  catch (const std::bad_alloc&)
  {
    this->Map.GiveUp(); // there may be memory for a frame without it
  }
  return outcome;
}

/// Make a frame from the isomap, which holds its isovalues.
bool FrameRenderer::LookUpFrame(
  const FrameKey& key, const Options& options, const Isomap::ReportProgress& report)
{
  this->BeginFrame(key);
  CachedImage& made = *this->Back;
  made.Picture.IsFromCache = false;
  this->OpenRays.resize(static_cast<std::size_t>(NumberOfTiles(key.Seen.Size)));
  const Isomap& map = this->Map.Built();
  const bool leaps = options.SpaceLeaping && key.Sought.IsTranslucent();
  if (leaps)
  {
    Stopwatch watch(this->Counters.TraceTime);
    this->PrepareActiveCells(key);
  }
  const IsomapLookup lookup(
    key, this->Map.BandsFor(key), map.Tolerance(), this->Pyramid().FiniteRange());
  const TileShader shader(key, this->Pyramid().FiniteRange(),
    { leaps ? this->Cells->Active.get() : nullptr, &this->Bounds },
    options.Map.HasNormals ? HitSet::NotDefinite : HitSet::All, HitSet::All);
  const bool isLookedUp = CountTiles(key.Seen.Size, ReportOf(report, 0.0, 0.5), this->Counters,
    [&](std::int64_t tile, const PixelRect& part)
    {
      std::uint64_t& left = this->OpenRays[static_cast<std::size_t>(tile)];
      TraceCounts counts = lookup.Look(tile, part, made.Picture, left);
      if (left == 0)
      {
        shader.Shade(tile, part, made.Picture, counts);
      }
      return counts;
    });
  if (!isLookedUp ||
    !this->TraceOpenRays(key, options, shader, made.Picture, ReportOf(report, 0.5, 1.0)))
  {
    return false;
  }
  made.IsExact = map.Tolerance() == 0.0 && !options.Map.HasNormals;
  made.IsEroded = map.Tolerance() > 0.0;
  this->FrontForm = Isomap::FormFor(key, options.Map);
  this->FinishFrame(options);
  return true;
}

/// Get room for a frame in Back.
void FrameRenderer::BeginFrame(const FrameKey& key)
{
  if (!this->Back)
  {
    this->Back = std::make_shared<CachedImage>();
  }
  CachedImage& made = *this->Back;
  made.Picture.Resize(key.Seen.Size);
  made.Picture.Layers.resize(key.Sought.IsTranslucent() ? made.Picture.ClearTiles.size() : 0);
  if (made.Key.Seen.Parallel != key.Seen.Parallel)
  {
    // The disparity of a miss is another one.
    std::fill(made.Picture.ClearTiles.begin(), made.Picture.ClearTiles.end(), std::uint8_t(0));
  }
  made.Key = key;
}

/// What is in Back is the last frame now.
void FrameRenderer::FinishFrame(const Options& options)
{
  this->Back->Free.Clear();
  const std::shared_ptr<CachedImage> dropped = this->Images.Keep(this->Back, options.Images);
  std::swap(this->Front, this->Back);
  if (this->Images.Holds(this->Back))
  {
    this->Back = dropped;
  }
  this->Steps.Take(this->Front->Key.Samples, *this->Ranges);
}

/// Find out what changed in samples that are not those of the last frame.
void FrameRenderer::CompareSamples(const FrameKey& key)
{
  switch (this->Steps.Compare(this->Front->Key.Samples, key.Samples, *this->Shared))
  {
    case SampleComparer::Result::Equal:
      this->MoveTo(key.Samples);
      break;
    case SampleComparer::Result::Different:
    {
      const FrameChange change = CompareFrames(this->Front->Key, key);
      if (change.Samples && !change.View && !key.Sought.Isovalues.empty())
      {
        this->PreparePyramid(key);
        this->Steps.FindTilesToTrace(key.Seen, key.Where, *this->Ranges);
      }
      break;
    }
    default:
      break;
  }
}

/// The samples of the last frame are equal to those of a field, which lie elsewhere: they may not
/// be read any more where they were.
void FrameRenderer::MoveTo(const Field& field)
{
  const Field before = this->Front->Key.Samples;
  if (this->Ranges->Samples == before)
  {
    this->Shared->MoveTo(field, this->Ranges);
  }
  if (this->Cells->Samples == before)
  {
    this->Shared->MoveTo(field, this->Cells);
  }
  this->Map.MoveTo(field, before);
  this->Images.MoveTo(field, before);
  this->Front->Key.Samples = field;
  this->Steps.TakeEqual();
}

/// Value ranges belong to the data.
void FrameRenderer::PreparePyramid(const FrameKey& key)
{
  if (key.Samples.HasCells() && !key.Sought.Isovalues.empty() &&
    !(this->Ranges->Samples == key.Samples))
  {
    this->Cells = std::make_shared<const SurfaceCells>();
    this->Map.Release();
    this->Shared->Provide(key.Samples, this->Ranges);
  }
}

glm::dvec2 FrameRenderer::FiniteRangeOf(const FrameKey& key)
{
  this->CompareSamples(key);
  this->PreparePyramid(key);
  return this->Pyramid().FiniteRange();
}

/// Active cells belong to data and isovalues, the bounds of tiles to the frame.
void FrameRenderer::PrepareActiveCells(const FrameKey& key)
{
  if (!key.Samples.HasCells() || key.Sought.Isovalues.empty())
  {
    return;
  }
  if (!(this->Cells->Samples == key.Samples) || !AreMetAlike(this->Cells->Sought, key.Sought))
  {
    this->Shared->Provide(*this->Ranges, key.Sought, this->Cells);
  }
  this->Bounds.Build(key.Seen, key.Where, *this->Cells->Active, *key.Samples.Kind);
}

/// Shade the last frame again, all whose hits are known.
void FrameRenderer::ShadeAgain()
{
  Stopwatch watch(this->Counters.ShadeTime);
  Frame& frame = this->Front->Picture;
  const TileShader shader(
    this->Front->Key, this->Pyramid().FiniteRange(), {}, HitSet::None, HitSet::All);
  ParallelFor(NumberOfTiles(frame.Size), TileGrain,
    [&](std::int64_t tile)
    {
      TraceCounts counts;
      shader.Shade(tile, PixelsOfTile(frame.Size, tile), frame, counts);
    });
}

/// Trace the rays that an isomap leaves open, one bit each, tile by tile, and shade these tiles.
bool FrameRenderer::TraceOpenRays(const FrameKey& key, const Options& options,
  const TileShader& shader, Frame& frame, const Isomap::ReportProgress& report)
{
  const std::vector<std::uint64_t>& open = this->OpenRays;
  const std::int64_t rays = std::accumulate(open.begin(), open.end(), std::int64_t(0),
    [](std::int64_t sum, std::uint64_t tile)
    { return sum + static_cast<std::int64_t>(std::bitset<64>(tile).count()); });
  if (rays == 0)
  {
    return true;
  }
  // A few rays are traced sooner than active cells are found.
  const bool leaps = options.SpaceLeaping && rays > FewRays;
  if (leaps)
  {
    this->PrepareActiveCells(key);
  }
  const TileTracer tracer({ key, leaps ? this->Cells->Active.get() : nullptr, &this->Bounds,
    this->Pyramid().FiniteRange() });
  return CountTiles(frame.Size, report, this->Counters,
    [&](std::int64_t tile, const PixelRect& part)
    {
      TraceCounts counts;
      const std::uint64_t which = open[static_cast<std::size_t>(tile)];
      if (which != 0)
      {
        counts = tracer.TraceSome(tile, part, which, frame);
        shader.Shade(tile, part, frame, counts);
      }
      return counts;
    });
}

/// Every pixel of a picture that is shown again is an answer known before.
void FrameRenderer::CountKnownHits()
{
  const Plane<std::int16_t>& isovalues = this->Front->Picture.Isovalues;
  this->Counters.DefiniteMisses = std::count(isovalues.begin(), isovalues.end(), Frame::NoSurface);
  this->Counters.DefiniteHits = this->Counters.Rays - this->Counters.DefiniteMisses;
}

void FrameRenderer::Release()
{
  *this = FrameRenderer(this->Shared);
}

}
