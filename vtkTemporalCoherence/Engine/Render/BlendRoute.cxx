// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Blending/BlendTracer.h"
#include "Render/RouteSteps.h"
#include "Render/Routes.h"
#include "Trace/RayPieces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>

namespace TemporalCoherence
{
namespace
{

std::uint8_t ByteOf(double share)
{
  return static_cast<std::uint8_t>(255.0 * std::clamp(share, 0.0, 1.0) + 0.5);
}

/// Blends what the rays of tiles see, and writes the planes of the frame.
class TileBlender
{
public:
  /// \throws NoBlendTracer, std::bad_alloc
  TileBlender(const FrameTask& task, const LeapedSpace& space)
    : Key(task.Key)
    , Space(space)
    , Rays(Key.View, Key.Transform, Key.Samples.Dimensions, Key.Region)
    , Tracer(Key.Samples.HasCells()
          ? BlendTracer::Make({ Key, space.Active, &task.Structures.Pyramid() })
          : nullptr)
  {
    if (!this->Tracer && Key.Samples.HasCells())
    {
      throw NoBlendTracer();
    }
  }

  TraceCounts Blend(std::int64_t tile, const PixelRect& part, Frame& frame) const
  {
    TraceCounts counts;
    // A sum of nothing is black.
    const bool isEmpty = this->Space.Active && this->Space.Bounds->At(tile).IsEmpty() &&
      this->Key.Volume.Mode != BlendMode::Additive;
    if (!this->Tracer || isEmpty)
    {
      StoreMisses(tile, part, this->Key.View.Parallel, frame);
      counts.DefiniteMisses = static_cast<std::int64_t>(part.Size.x) * part.Size.y;
      return counts;
    }
    frame.ClearTiles[static_cast<std::size_t>(tile)] = 0;
    RayBatch rays;
    WorldDirections world;
    this->Rays.SetUp(part.First, part.Size, rays, &world);
    this->EndWhereHidden(rays);
    if (this->Space.Active)
    {
      this->Space.Bounds->Narrow(tile, rays);
    }
    BlendedRays seen;
    this->Tracer->Begin(seen);
    this->Trace(rays, world, seen);
    this->Tracer->Finish(rays, world, seen);
    this->Store(rays, seen, frame, counts);
    counts.CellsRead = seen.CellsRead;
    return counts;
  }

private:
  /// Rays end at opaque things.
  void EndWhereHidden(RayBatch& rays) const
  {
    if (const auto& ends = this->Key.Volume.Ends)
    {
      for (std::size_t i = 0; i < static_cast<std::size_t>(rays.Count); ++i)
      {
        const double end = (*ends)[static_cast<std::size_t>(rays.Pixel[i])];
        rays.End[i] = std::min(rays.End[i], end);
        rays.WalkEnd[i] = std::min(rays.WalkEnd[i], end);
      }
    }
  }

  void Trace(const RayBatch& rays, const WorldDirections& world, BlendedRays& seen) const
  {
    if (!this->Rays.Clipper.HasPieces())
    {
      this->Tracer->Trace(rays, world, seen);
      return;
    }
    const RayPieces pieces(this->Rays.Clipper, rays);
    for (std::size_t piece = 0; piece < RegionClipper::MostPieces; ++piece)
    {
      RayBatch part = rays;
      if (pieces.Clip(piece, part) != 0)
      {
        this->Tracer->Trace(part, world, seen);
      }
    }
  }

  void Store(const RayBatch& rays, const BlendedRays& seen, Frame& frame, TraceCounts& counts) const
  {
    HitBatch hits;
    hits.Clear(rays.Count);
    const Appearance& appearance = this->Key.Appearance;
    RayBatch::Array<Answer> answers;
    for (std::size_t i = 0; i < static_cast<std::size_t>(rays.Count); ++i)
    {
      const double alpha = 1.0 - static_cast<double>(seen.Passed[i]);
      std::array<std::uint8_t, 4> color{ 0, 0, 0, ByteOf(alpha) };
      for (std::size_t channel = 0; channel < 3; ++channel)
      {
        color[channel] =
          ByteOf(appearance.ColorScale * static_cast<double>(seen.Color[channel][i]) +
            appearance.ColorShift * alpha);
      }
      const bool isSeen = color[0] + color[1] + color[2] + color[3] != 0;
      if (isSeen)
      {
        // What no place of a ray shows alone lies where the ray begins.
        hits.Depth[i] = std::isfinite(seen.First[i]) ? seen.First[i] : rays.Begin[i];
        hits.Surface[i] = 0;
        hits.Kind[i] = HitKind::Entry;
      }
      const auto pixel = static_cast<std::size_t>(rays.Pixel[i]);
      frame.Colors[pixel] = color;
      frame.Normals[pixel] = glm::vec3(0.0f);
      answers[i] = rays.HasWalk(i) ? Answer::PossibleHit : Answer::DefiniteMiss;
      counts.TracedRays += rays.HasWalk(i);
      ++(rays.HasWalk(i) ? counts.PossibleHits : counts.DefiniteMisses);
    }
    StoreHits(rays, hits, answers, this->Key.View.Parallel, frame);
  }

  const FrameKey& Key;
  LeapedSpace Space;
  RaySource Rays;
  std::shared_ptr<const BlendTracer> Tracer;
};

/// Make room for the frame, and find out where its rays can see anything.
LeapedSpace BeginBlending(FrameTask& task)
{
  Stopwatch watch(task.Statistics.TraceTime);
  const bool leaps = task.Options.SpaceLeaping && task.Structures.PrepareVisibleCells(task.Key);
  task.Costs = nullptr; // there are no isomaps
  task.Store.Begin(task.Key, FrameExtras());
  return task.Structures.VisibleSpace(leaps);
}

}

bool BlendCold(FrameTask& task)
{
  const LeapedSpace space = BeginBlending(task);
  const TileBlender blender(task, space);
  return MakeTiles(task,
    [&](std::int64_t tile, const PixelRect& part, Frame& frame)
    { return blender.Blend(tile, part, frame); });
}

}
