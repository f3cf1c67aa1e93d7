// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Render/FrameRenderer.h"

#include "Kinds/FieldKind.h"
#include "Render/Antialias.h"
#include "Render/Routes.h"
#include "Scene/Timers.h"

#include <algorithm>
#include <iterator>
#include <new>

namespace TemporalCoherence
{
namespace
{

/// The share of a frame's progress that building a range of isovalues takes.
constexpr double ShareOfBuilding = 0.9;

/// The share of a frame's progress that its tiles take if edges are antialiased, too.
constexpr double ShareOfTiles = 0.5;

/// The share of a picture's progress that its edges have.
constexpr double ShareOfEdges = 0.1;

/// Rays of a pixel at an edge, about: each of them sends that share of a pixel's rays for light.
constexpr std::uint32_t RaysAtEdges = 8;

/// True if the light of surfaces is to be found.
bool HasLight(const FrameKey& key)
{
  return key.Appearance.HasMutualLight() && !key.Isosurfaces().Isovalues.empty() &&
    key.Samples.HasCells();
}

/// True if still pictures of a key are to be antialiased. Where colours tell of rays they are not.
bool WantsSmoothEdges(const FrameKey& key, const FrameOptions& options)
{
  return options.Antialias != Antialiasing::Off && !key.Appearance.ColorByAnswer;
}

/// True if the edges of a frame are antialiased, unless its route leaves pixels between rays.
bool SmoothsEdges(const FrameTask& task)
{
  return WantsSmoothEdges(task.Key, task.Options) &&
    (task.IsRepeated || task.Options.Antialias == Antialiasing::Always);
}

/// The part of a picture whose edges have one ray a pixel.
double ShareOfOpenEdges(const Frame& picture)
{
  const std::vector<std::uint8_t>& open = picture.OpenEdges;
  return open.empty() ? 1.0
                      : static_cast<double>(std::count(open.begin(), open.end(), 1)) /
      static_cast<double>(open.size());
}

/// Rays that each hit sends in a frame to find light.
std::uint32_t RaysOfFrame(const LightOptions& options, bool isStill)
{
  const std::uint32_t whenStill = options.AtOnce ? options.Rays : options.RaysWhenStill;
  return isStill ? whenStill : options.RaysOfFrame;
}

}

bool FrameRenderer::Render(
  const FrameKey& asked, const Options& options, const ReportProgress& report)
{
  FrameStatistics statistics;
  statistics.Rays = static_cast<std::int64_t>(asked.View.Size.x) * asked.View.Size.y;
  {
    Stopwatch watch(statistics.FrameTime);

    // The samples may have changed or moved in memory: structures and pictures follow.
    FrameKey key;
    {
      Stopwatch preparing(statistics.TraceTime);
      this->Map.Trim(options.Map.MemoryLimit);
      key = this->Prepare(asked);
    }
    const CachedImage& last = this->Store.Last();
    const bool isRepeat = !last.Picture.IsEmpty() && GiveSamePicture(last.Key, key);
    FrameTask task{ key, options, this->Store, this->Structures, statistics, nullptr, report,
      isRepeat };
    const auto readsOf = [&]()
    { return key.Samples.Bricks ? key.Samples.Bricks->NumberOfReads() : 0; };
    const std::int64_t readsBefore = readsOf();

    // The changes and the available data determine the route.
    const std::shared_ptr<CachedImage> nearest = this->Store.FindNearest(key, options);
    Route route = this->ChooseRoute(key, options, nearest != nullptr);

    // Some rays find the light of the surfaces.
    const std::unique_ptr<SurfaceLight> light = this->BeginLight(task, route);
    task.Light = light.get();
    task.Values = this->BeginValues(key, route);

    // One function makes the frame. If it is stopped or runs out of memory, the last frame is
    // unchanged.
    std::unique_ptr<SurfaceLight> ofEdges;
    const double ofTiles = SmoothsEdges(task) ? ShareOfTiles : 1.0;
    task.Report = PartOf(report, 0.0, ofTiles);
    if (!this->Make(route, task, nearest.get()) ||
      !this->SmoothEdges(route, task, PartOf(report, ofTiles, 1.0), ofEdges))
    {
      return false;
    }
    this->Finish(route, task);
    if (light)
    {
      this->Shadows.End();
    }
    this->ReadsOfLastFrame = readsOf() - readsBefore;
    this->KeepLight(light.get(), ofEdges.get(), task);
  }
  this->TimeToBuild = statistics.IsomapBuildTime;
  this->OfLastFrame = statistics;
  SampleUse::End();
  return true;
}

/// Prepare the values of an array at known hits; null if none are kept.
KeptHitValues* FrameRenderer::BeginValues(const FrameKey& key, Route route)
{
  const bool isShaded = route != Route::Redisplay && route != Route::Antialias;
  return isShaded && this->Values.Begin(key, route == Route::Reshade) ? &this->Values : nullptr;
}

/// Prepare the rays that find the light of the next frame's surfaces; null if none are needed.
std::unique_ptr<SurfaceLight> FrameRenderer::BeginLight(const FrameTask& task, Route route)
{
  const FrameKey& key = task.Key;
  if (!key.Appearance.HasMutualLight())
  {
    this->Light.Clear();
  }
  if (route == Route::Redisplay || route == Route::Antialias)
  {
    return nullptr;
  }
  const bool keepsShadows = this->Shadows.Begin(key, route == Route::Reshade);
  if (!HasLight(key))
  {
    return nullptr;
  }
  const LightOptions& options = task.Options.Light;
  const bool isRepeated = options.AtOnce || (route == Route::Reshade && task.IsRepeated);
  // Where the light of all hits is final it stays so.
  const bool isStill = isRepeated || (route == Route::Reshade && this->IsLightFinal);
  return this->MakeLight(task, RaysOfFrame(options, isRepeated), options.Rays, isStill,
    keepsShadows ? &this->Shadows : nullptr);
}

/// Prepare rays that find light.
/// \param raysOfFrame from each hit, and in all frames together
/// \param shadows     see SurfaceLight
std::unique_ptr<SurfaceLight> FrameRenderer::MakeLight(const FrameTask& task,
  std::uint32_t raysOfFrame, std::uint32_t rays, bool isStill, KeptShadows* shadows)
{
  const FrameKey& key = task.Key;
  this->Light.Follow(key);
  if (task.Options.SpaceLeaping)
  {
    task.Structures.PrepareActiveCells(key);
  }
  const glm::dvec2 finite = task.Structures.Pyramid().FiniteRange();
  return std::make_unique<SurfaceLight>(key, KindOf(key.Samples), finite,
    MakeSurfaceTracer({ key.Samples, key.Isosurfaces(), finite,
      task.Structures.SpaceToLeap(task.Options.SpaceLeaping).Active, false, Traversal::Walks }),
    this->Light, shadows, raysOfFrame, rays, !isStill);
}

/// Antialias the made picture if that is asked for.
/// \param report is called with the progress of this part
/// \param light receives the light of the surfaces that more rays meet; null if none is needed
/// \return false if the report stopped it, and the frame must not become the last one
bool FrameRenderer::SmoothEdges(
  Route route, FrameTask& task, const ReportProgress& report, std::unique_ptr<SurfaceLight>& light)
{
  const FrameKey& key = task.Key;
  const bool isOfLast = route == Route::Reshade || route == Route::Antialias;
  const bool isAlways = task.Options.Antialias == Antialiasing::Always;
  const bool isNow = SmoothsEdges(task);
  // A window's frame that refines may be stopped. Its edges then wait for the next frame.
  const bool isBetweenRays = (route == Route::FewerRays || route == Route::Refine) &&
    (!isAlways || !task.Store.Next().Doubts.empty());
  if (route == Route::Redisplay || isBetweenRays || !isNow)
  {
    if (route == Route::Antialias)
    {
      task.Store.LastToRecolor().Picture.ForgetAntialiased();
    }
    return true;
  }
  try
  {
    if (HasLight(key))
    {
      // The rays of a pixel share its work.
      const LightOptions& options = task.Options.Light;
      const auto shareOf = [](std::uint32_t rays) { return std::max(rays / RaysAtEdges, 1u); };
      const bool isStill = options.AtOnce || task.IsRepeated;
      light = this->MakeLight(
        task, shareOf(RaysOfFrame(options, isStill)), shareOf(options.Rays), isStill, nullptr);
    }
    CachedImage& made = isOfLast ? task.Store.LastToRecolor() : task.Store.Next();
    task.Report = task.Options.ReportsTiles ? report : ReportProgress();
    const double before = task.Statistics.TilesTime; // by which rays are chosen
    const bool isDone = Antialias(task, light.get(), made.Picture);
    task.Statistics.TilesTime = before;
    // Reshade has changed the last frame: it is valid without more rays.
    return isDone || route == Route::Reshade;
  }
  catch (const std::bad_alloc&)
  {
    if (route != Route::Reshade)
    {
      throw;
    }
    return true;
  }
}

/// Keep the light that a finished frame has found, and tell whether the frame is final.
void FrameRenderer::KeepLight(SurfaceLight* ofPixels, SurfaceLight* ofEdges, FrameTask& task)
{
  FrameStatistics& statistics = task.Statistics;
  LightCache::FoundInTiles found;
  try
  {
    for (SurfaceLight* light : { ofPixels, ofEdges })
    {
      if (light)
      {
        statistics.Progress = std::min(statistics.Progress, light->Progress());
        LightCache::FoundInTiles part = light->TakeFound();
        std::move(part.begin(), part.end(), std::back_inserter(found));
      }
    }
  }
  catch (const std::bad_alloc&)
  {
    found.clear(); // the next frame may have memory
  }
  if (!found.empty())
  {
    this->Light.Add(found, task.Options.Light.MemoryLimit);
  }
  this->IsLightFinal = statistics.Progress >= 1.0;
  const CachedImage& last = task.Store.Last();
  if (WantsSmoothEdges(task.Key, task.Options) && !last.Picture.IsSmooth())
  {
    statistics.Progress *= 1.0 - ShareOfEdges * ShareOfOpenEdges(last.Picture);
  }
  if (!last.Doubts.empty())
  {
    const auto traced =
      static_cast<double>(std::count(last.Doubts.begin(), last.Doubts.end(), 0.0f));
    // Reading bricks is progress, too, but less than a finished tile.
    const std::shared_ptr<const BrickCache>& bricks = task.Key.Samples.Bricks;
    const double begun =
      bricks ? 1.0 - 1.0 / (1.0 + 1e-4 * static_cast<double>(bricks->NumberOfReads())) : 0.0;
    statistics.Progress *= (traced + begun) / static_cast<double>(last.Doubts.size());
  }
}

/// Take a route. If the route proves impossible, take the next best and update `route`.
bool FrameRenderer::Make(Route& route, FrameTask& task, CachedImage* nearest)
{
  const ReportProgress report = task.Report;
  if (!task.Options.ReportsTiles)
  {
    task.Report = {};
  }
  switch (route)
  {
    case Route::Redisplay:
      ShowAgain(task);
      return true;
    case Route::Reshade:
      return ShadeAgain(task);
    case Route::Antialias:
      ShowAgain(task);
      return true;
    case Route::IsomapLookup:
      return this->LookUpIsomap(route, task);
    case Route::IsomapBuild:
      task.Report = report;
      return this->BuildAndLookUp(route, task);
    case Route::ImageCache:
      return TraceFromImage(task, *nearest);
    case Route::TimeStep:
      return TraceChangedTiles(task, this->Changes);
    case Route::Recomposite:
      return CompositeKnownLayers(task);
    case Route::KeepValues:
      return BlendKnownValues(task);
    case Route::KeepLabels:
      return TraceChangedLabels(task, this->Changes);
    case Route::FewerRays:
      return this->PrefersGrid(task) ? TraceFewerRays(task, this->Grid)
                                     : this->MakeInTime(route, task);
    case Route::Refine:
      return TraceBetweenRays(task);
    case Route::Cold:
      break;
  }
  return task.Key.IsBlended() ? BlendCold(task) : TraceCold(task);
}

/// True if a frame from fewer rays traces a grid of rays. Where many bricks are missing, a grid
/// takes as long as all rays: it meets nearly the same bricks.
bool FrameRenderer::PrefersGrid(const FrameTask& task) const
{
  constexpr std::int64_t many = 64;
  return CanHaveFewerRays(task.Key, task.Options) &&
    !(CanBeImpatient(task.Key, task.Options) && this->ReadsOfLastFrame > many);
}

/// Make a frame that does not wait for samples. Without missing samples its route is Cold.
bool FrameRenderer::MakeInTime(Route& route, FrameTask& task)
{
  const bool isMade = TraceInTime(task, this->Grid);
  route = isMade && task.Store.Next().Doubts.empty() ? Route::Cold : route;
  return isMade;
}

/// The new frame becomes the last frame, if the route made one.
void FrameRenderer::Finish(Route route, const FrameTask& task)
{
  task.Statistics.Made = route;
  this->ForPicks = nullptr;
  if (route == Route::Redisplay || route == Route::Reshade || route == Route::Antialias)
  {
    return;
  }
  this->Store.Finish(task.Options.Images);
  this->LastForm = Isomap::FormFor(task.Key, task.Options.Map);
  this->Changes.Take(task.Key.Samples, this->Structures.Ranges());
}

Route FrameRenderer::ChooseRoute(const FrameKey& key, const Options& options, bool hasImage) const
{
  const CachedImage& last = this->Store.Last();
  ReuseSwitches switches = options.Reuse;
  switches.FewerRays = CanHaveFewerRays(key, options) || CanBeImpatient(key, options);
  if (last.Picture.IsEmpty())
  {
    return switches.FewerRays ? Route::FewerRays : Route::Cold;
  }
  const bool isExactAsked = options.Accuracy == ReuseAccuracy::Exact;
  HeldForReuse held;
  held.IsExact = last.IsExact;
  held.Image = hasImage && !isExactAsked && !key.Samples.Labels;
  held.CanBuildIsomap = this->Map.CanBuild(key, options.Map);
  held.IsIsomapExact = this->Map.Built().Tolerance() == 0.0 && !options.Map.HasNormals;
  held.Isomap = this->Map.Covers(key, options.Map);
  held.ShareToTrace = this->Changes.ShareToTrace();
  held.IsLightFinal = this->IsLightFinal;
  held.IsSmooth =
    WantsSmoothEdges(key, options) ? last.Picture.IsSmooth() : !last.Picture.IsAntialiased();
  held.IsBetweenRays = !last.Doubts.empty();
  held.Values = !last.Picture.Met.empty() && !held.IsBetweenRays;
  // A picture from an isomap does not serve a request with another tolerance.
  switches.RefineWhenStill |= !(this->LastForm == Isomap::FormFor(key, options.Map));
  switches.RefineWhenStill |= isExactAsked || !switches.Frames;
  return PlanRoute(last.Key, key, switches, held);
}

/// Build the user's range of isovalues, if any. Then look the frame up, and build missing bands. If
/// the isomap proves impossible, take the next best route.
bool FrameRenderer::BuildAndLookUp(Route& route, FrameTask& task)
{
  const ReportProgress report = task.Report;
  double done = 0.0; // stays 0 if no range is built
  if (report)
  {
    task.Report = [&](double progress)
    {
      done = ShareOfBuilding;
      return report(ShareOfBuilding * progress);
    };
  }
  const Isomap::Outcome outcome = this->PrepareIsomap(task);
  task.Report = task.Options.ReportsTiles ? PartOf(report, done, 1.0) : ReportProgress();
  switch (outcome)
  {
    case Isomap::Outcome::Stopped:
      return false;
    case Isomap::Outcome::Built:
      return this->LookUpIsomap(route, task);
    default:
      route = this->ChooseRoute(task.Key, task.Options, false);
      route = route == Route::IsomapBuild ? Route::Cold : route;
      return this->Make(route, task, nullptr);
  }
}

/// Make a frame from the isomap. The route is IsomapBuild if some tiles lacked bands.
bool FrameRenderer::LookUpIsomap(Route& route, FrameTask& task)
{
  bool isBuilding = route == Route::IsomapBuild;
  const bool isMade = LookUp(task, this->Map, this->UnresolvedRays, isBuilding);
  route = isBuilding ? Route::IsomapBuild : Route::IsomapLookup;
  return isMade;
}

Isomap::Outcome FrameRenderer::PrepareIsomap(FrameTask& task)
{
  Stopwatch watch(task.Statistics.IsomapBuildTime);
  Isomap::Outcome outcome = Isomap::Outcome::TooLarge;
  try
  {
    outcome = this->Map.Prepare(
      { task.Key, this->Structures.Pyramid(), MakeBandTracer }, task.Options.Map, task.Report);
    task.Statistics.FieldSamples += 8 * this->Map.CellsRead();
  }
  catch (const std::bad_alloc&)
  {
    this->Map.GiveUp(); // a frame without it may fit into memory
  }
  return outcome;
}

Isomap::Outcome FrameRenderer::BuildIsomap(
  const FrameKey& key, const Options& options, const ReportProgress& report)
{
  this->TimeToBuild = 0.0;
  if (key.Isosurfaces().Isovalues.empty() || !this->Map.CanBuild(key, options.Map))
  {
    return Isomap::Outcome::Impossible;
  }
  double seconds = 0.0;
  Isomap::Outcome outcome = Isomap::Outcome::TooLarge;
  {
    Stopwatch watch(seconds);
    const FrameKey whole = this->Prepare(key);
    try
    {
      outcome = this->Map.BuildAhead(
        { whole, this->Structures.Pyramid(), MakeBandTracer }, options.Map, report);
    }
    catch (const std::bad_alloc&)
    {
      this->Map.GiveUp();
    }
  }
  this->TimeToBuild = seconds;
  return outcome;
}

/// Bring structures and pictures up to date with the samples.
/// \return the key with its hidden cells
FrameKey FrameRenderer::Prepare(const FrameKey& key)
{
  this->FollowSamples(key);
  this->PrepareRanges(key);
  return FrameStructures::WithHidden(key, this->Structures.Ranges());
}

/// Compare the samples with the last frame's, and find the tiles that changes affect.
void FrameRenderer::FollowSamples(const FrameKey& key)
{
  const FrameKey& last = this->Store.Last().Key;
  const SampleComparer::Result result =
    this->Changes.Compare(last.Samples, key.Samples, this->Structures.SharedByAll());
  if (result == SampleComparer::Result::Equal)
  {
    // From now on, the old memory of these samples must not be read.
    const Field before = last.Samples;
    Field now = key.Samples;
    now.Hidden = before.Hidden;
    this->Structures.MoveTo(now, before);
    this->Map.MoveTo(now, before);
    this->Store.MoveTo(now);
    this->Changes.TakeEqual();
  }
  else if (result == SampleComparer::Result::Different)
  {
    const FrameChange change = CompareFrames(last, key);
    if (change.Samples && !change.View && !key.Isosurfaces().Isovalues.empty())
    {
      this->PrepareRanges(key);
      this->Changes.FindTilesToTrace(key.View, key.Transform, this->Structures.Ranges());
    }
  }
}

/// Set the value ranges for the data. Isomaps of other data are dropped first, to make room.
void FrameRenderer::PrepareRanges(const FrameKey& key)
{
  if (this->Structures.NeedsRanges(key))
  {
    this->Map.Release();
    this->Structures.PrepareRanges(key);
  }
}

const FieldRanges& FrameRenderer::RangesOf(const FrameKey& key)
{
  this->ForPicks = this->Structures.RangesOf(key);
  return *this->ForPicks;
}

void FrameRenderer::Release()
{
  *this = FrameRenderer({ this->Structures.Sharing() });
}

}
