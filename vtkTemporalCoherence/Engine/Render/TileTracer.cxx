// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Render/TileTracer.h"

#include "Scene/FramePlanes.h"
#include "Scene/TileTimer.h"
#include "Trace/RayPieces.h"

#include <algorithm>
#include <cmath>

namespace TemporalCoherence
{
namespace
{

/// A surface found within so many voxels of where the image told to start counts as known.
constexpr double NearStart = 2.0;

/// Share of a depth by which a walk to it goes farther, so that its cell is not left out.
constexpr double DepthError = 1e-9;

bool AreMisses(const QueryBatch& known, int count)
{
  return std::all_of(known.Answers.begin(), known.Answers.begin() + count,
    [](Answer answer) { return answer == Answer::DefiniteMiss; });
}

void Count(Answer answer, TraceCounts& counts)
{
  counts.DefiniteHits += answer == Answer::DefiniteHit;
  counts.DefiniteMisses += answer == Answer::DefiniteMiss;
  counts.PossibleHits += answer == Answer::PossibleHit;
}

}

TileTracer::TileTracer(const TileScene& scene)
  : Scene(scene)
  , Rays(scene.Key.Seen, scene.Key.Where, scene.Key.Samples.Dimensions, scene.Key.Kept)
  , HasSurfaces(scene.Key.Samples.HasCells() && !scene.Key.Sought.Isovalues.empty())
  , IsSolid(scene.Key.Sought.Mode == SurfaceMode::Threshold)
  , Tracer(
      SurfaceTracer::Make({ scene.Key.Samples, scene.Key.Sought, scene.FiniteRange, scene.Active }))
{
}

bool TileTracer::CanSkip(std::int64_t tile) const
{
  // A solid may be cut open where there is no active cell.
  return !this->HasSurfaces ||
    (this->Scene.Active && !this->IsSolid && this->Scene.Bounds->At(tile).IsEmpty());
}

TraceCounts TileTracer::Trace(std::int64_t tile, const PixelRect& part, Frame& frame) const
{
  TraceCounts counts;
  RayBatch rays;
  QueryBatch known;
  bool isMiss = this->CanSkip(tile);
  if (!isMiss)
  {
    this->Rays.SetUp(part.First, part.Size, rays);
    if (this->Scene.Active)
    {
      this->Scene.Bounds->Narrow(tile, rays);
    }
    if (this->Scene.Query)
    {
      const TileTimer timer(tile, counts.QueryTime);
      this->Scene.Query->Ask(rays, known);
      isMiss = !this->IsSolid && AreMisses(known, rays.Count);
    }
  }
  if (isMiss)
  {
    StoreMisses(tile, part, this->Scene.Key.Seen.Parallel, frame);
    counts.DefiniteMisses = static_cast<std::int64_t>(part.Size.x) * part.Size.y;
  }
  else
  {
    frame.ClearTiles[static_cast<std::size_t>(tile)] = 0;
    if (this->Scene.Query)
    {
      this->TraceKnown(known, rays, frame, counts);
    }
    else if (this->Scene.Before)
    {
      this->TraceHinted(rays, frame, counts);
    }
    else
    {
      this->TraceCold(rays, frame, counts);
    }
  }
  return counts;
}

TraceCounts TileTracer::TraceSome(
  std::int64_t tile, const PixelRect& part, std::uint64_t which, Frame& frame) const
{
  TraceCounts counts;
  RayBatch all, rays;
  this->Rays.SetUp(part.First, part.Size, all);
  if (this->Scene.Active)
  {
    this->Scene.Bounds->Narrow(tile, all);
  }
  for (std::size_t i = 0; i < static_cast<std::size_t>(all.Count); ++i)
  {
    if (which >> i & 1u)
    {
      AppendRay(all, i, rays);
    }
  }
  this->TraceCold(rays, frame, counts);
  return counts;
}

/// Find the first surface along each ray, in what the region leaves of it.
void TileTracer::Find(const RayBatch& rays, HitBatch& hits) const
{
  if (!this->Rays.Cut.HasPieces())
  {
    this->Tracer->Trace(rays, hits);
    return;
  }
  hits.Clear(rays.Count);
  FindInPieces(this->Rays.Cut, rays, hits,
    [this](const RayBatch& part, HitBatch& found) { this->Tracer->Trace(part, found); });
}

void TileTracer::TraceCold(const RayBatch& rays, Frame& frame, TraceCounts& counts) const
{
  HitBatch hits;
  this->Find(rays, hits);
  counts.CellsRead += hits.CellsRead;
  for (std::size_t i = 0; i < static_cast<std::size_t>(rays.Count); ++i)
  {
    this->StoreTraced(rays, hits, i, frame, counts);
  }
}

/// Store what a ray found of which nothing was known before.
void TileTracer::StoreTraced(const RayBatch& rays, const HitBatch& hits, std::size_t ray,
  Frame& frame, TraceCounts& counts) const
{
  const bool isTraced = rays.WalkBegin[ray] < rays.WalkEnd[ray] || hits.Kind[ray] == HitKind::Cap;
  const Answer answer = isTraced ? Answer::PossibleHit : Answer::DefiniteMiss;
  counts.TracedRays += isTraced;
  Count(answer, counts);
  StoreHit(rays, hits, ray, answer, this->Scene.Key.Seen.Parallel, frame);
}

/// As an isovalue rises, the hit of a ray that begins below it moves away; as it falls, it comes
/// nearer, unless the ray now begins above it.
void TileTracer::TraceHinted(RayBatch& rays, Frame& frame, TraceCounts& counts) const
{
  const RayBatch::Array<double> walkEnd = rays.WalkEnd;
  const Frame& before = *this->Scene.Before;
  if (this->Scene.IsRaised)
  {
    BeginAtContacts(before, this->Scene.Key.Seen.Parallel, rays);
  }
  else
  {
    for (std::size_t i = 0; i < static_cast<std::size_t>(rays.Count); ++i)
    {
      const auto pixel = static_cast<std::size_t>(rays.Pixel[i]);
      if (before.Kinds[pixel] == HitKind::Enters)
      {
        const double t = before.Depth[pixel];
        rays.WalkEnd[i] = std::min(rays.WalkEnd[i], t + DepthError * std::abs(t));
      }
    }
  }
  HitBatch hits;
  this->Find(rays, hits);
  counts.CellsRead += hits.CellsRead;
  RayBatch again;
  for (std::size_t i = 0; i < static_cast<std::size_t>(rays.Count); ++i)
  {
    if (rays.WalkEnd[i] < walkEnd[i] && hits.Kind[i] == HitKind::None)
    {
      rays.WalkEnd[i] = walkEnd[i];
      AppendRay(rays, i, again);
      continue;
    }
    this->StoreTraced(rays, hits, i, frame, counts);
  }
  this->TraceAgain(again, frame, counts);
}

void TileTracer::TraceKnown(
  const QueryBatch& known, RayBatch& rays, Frame& frame, TraceCounts& counts) const
{
  const RayBatch::Array<double> walkBegin = rays.WalkBegin;
  const RayBatch::Array<double> walkEnd = rays.WalkEnd;
  this->NarrowByImage(known, rays);
  HitBatch hits;
  this->Find(rays, hits);
  counts.CellsRead += hits.CellsRead;

  RayBatch again;
  for (std::size_t i = 0; i < static_cast<std::size_t>(rays.Count); ++i)
  {
    Answer answer = known.Answers[i];
    if (answer == Answer::DefiniteHit && this->Scene.InterpolateColors)
    {
      const auto pixel = static_cast<std::size_t>(rays.Pixel[i]);
      this->Scene.Query->Interpolate(known, i, pixel, frame);
      frame.Disparities[pixel] = DisparityAt(rays, i, known.Hit[i], this->Scene.Key.Seen.Parallel);
      frame.Contacts[pixel] = frame.Disparities[pixel];
    }
    else if ((rays.WalkBegin[i] > walkBegin[i] || rays.WalkEnd[i] < walkEnd[i]) &&
      this->IsWrong(known, hits, i))
    {
      rays.WalkBegin[i] = hits.Kind[i] == HitKind::None ? known.Free[i] : walkBegin[i];
      rays.WalkEnd[i] = walkEnd[i];
      AppendRay(rays, i, again);
      continue;
    }
    else
    {
      counts.TracedRays += hits.Kind[i] == HitKind::Cap || answer == Answer::PossibleHit;
      answer = this->AnswerAfter(known, hits, i, known.Free[i] > walkBegin[i]);
      StoreHit(rays, hits, i, answer, this->Scene.Key.Seen.Parallel, frame);
    }
    Count(answer, counts);
  }
  this->TraceAgain(again, frame, counts);
}

/// Let each ray walk only where its answer leaves something to find.
void TileTracer::NarrowByImage(const QueryBatch& known, RayBatch& rays) const
{
  const double voxel = this->Scene.Query->VoxelSize();
  for (std::size_t i = 0; i < static_cast<std::size_t>(rays.Count); ++i)
  {
    switch (known.Answers[i])
    {
      case Answer::DefiniteMiss:
        rays.WalkEnd[i] = rays.WalkBegin[i];
        break;
      case Answer::DefiniteHit:
        rays.WalkBegin[i] = std::max(rays.WalkBegin[i], known.Hit[i] - voxel);
        rays.WalkEnd[i] = this->Scene.InterpolateColors
          ? rays.WalkBegin[i]
          : std::min(rays.WalkEnd[i], known.Hit[i] + voxel);
        break;
      case Answer::PossibleHit:
        rays.WalkBegin[i] = known.Free[i];
        break;
    }
  }
}

/// True if a trace shows that the image was wrong about a ray: no surface where it has one, or a
/// surface met from inside that it does not see from inside, so that the walk began behind another.
bool TileTracer::IsWrong(const QueryBatch& known, const HitBatch& hits, std::size_t ray) const
{
  switch (hits.Kind[ray])
  {
    case HitKind::None:
      return known.Answers[ray] == Answer::DefiniteHit;
    case HitKind::Leaves:
      return this->IsSolid || !this->Scene.Query->IsSeenFromInside(known.Pixel[ray]);
    default:
      return false;
  }
}

Answer TileTracer::AnswerAfter(
  const QueryBatch& known, const HitBatch& hits, std::size_t ray, bool isServed) const
{
  const Answer answer = known.Answers[ray];
  if (hits.Kind[ray] == HitKind::Cap)
  {
    return Answer::PossibleHit;
  }
  const double near = NearStart * this->Scene.Query->VoxelSize();
  const bool isFoundNear = this->Scene.Query->IsBounded() && answer == Answer::PossibleHit &&
    isServed && hits.Depth[ray] - known.Free[ray] <= near;
  return isFoundNear ? Answer::DefiniteHit : answer;
}

/// Trace rays about which the image was wrong.
void TileTracer::TraceAgain(const RayBatch& rays, Frame& frame, TraceCounts& counts) const
{
  if (rays.Count == 0)
  {
    return;
  }
  HitBatch hits;
  this->Find(rays, hits);
  counts.CellsRead += hits.CellsRead;
  counts.TracedRays += rays.Count;
  counts.PossibleHits += rays.Count;
  for (std::size_t i = 0; i < static_cast<std::size_t>(rays.Count); ++i)
  {
    StoreHit(rays, hits, i, Answer::PossibleHit, this->Scene.Key.Seen.Parallel, frame);
  }
}

}
