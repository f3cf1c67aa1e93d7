// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Kinds/FieldKind.h"
#include "Lattice/RayPieces.h"
#include "Render/ColdTiles.h"
#include "Render/RayColors.h"
#include "Render/RouteSteps.h"
#include "Render/Routes.h"
#include "Shade/Shader.h"
#include "Volumes/Projections/MetValues.h"
#include "Volumes/Samples/ComponentLooks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>

namespace TemporalCoherence
{
namespace
{

std::uint8_t ByteOf(double share)
{
  return static_cast<std::uint8_t>(255.0 * std::clamp(share, 0.0, 1.0) + 0.5);
}

/// True if the gradient at the first visible place is a normal: in composite volumes with a single
/// look. Extremes have no normal.
bool HasNormals(const Blending& volume)
{
  return volume.Mode == BlendMode::Composite && ComponentLooks(volume).Parts() == 1;
}

/// The field whose gradients are the normals of a volume.
const Field& FieldOfNormals(const FrameKey& key)
{
  const std::size_t component = ComponentLooks(key.Blended()).GradientOf(0);
  return component == 0 ? key.Samples : key.Blended().Others[component - 1];
}

/// Blends the rays of tiles, and writes the planes of the frame.
class TileBlender : public RayColors
{
public:
  /// \param last a frame whose rays met the same values; null: no values are known
  /// \throws std::bad_alloc
  TileBlender(const FrameTask& task, const LeapedSpace& space, const Frame* last = nullptr)
    : Key(task.Key)
    , Space(space)
    , Last(last)
    , IsAllKnown(last && KnowsAllExtremes(last->MetWithin, Key.Blended()))
    , Rays(Key.View, Key.Transform, Key.Samples.Dimensions, Key.Region)
    , Tracer(Key.Samples.HasCells()
          ? MakeBlendTracer(
              { Key, space.Active, &task.Structures.Pyramid() }, &task.Structures.TablesOfVolume())
          : nullptr)
  {
    if (this->Tracer && HasNormals(Key.Blended()))
    {
      // Gradients do not depend on the isovalue, so any value serves.
      const glm::dvec2& range = task.Structures.Pyramid().FiniteRange();
      const Field& field = FieldOfNormals(Key);
      this->Gradients.emplace(
        NormalSource{ field, KindOf(field), Key.Transform, {}, { range.x }, range });
    }
  }

  TraceCounts Blend(std::int64_t tile, const PixelRect& part, Frame& frame) const
  {
    TraceCounts counts;
    if (!this->Tracer || this->IsEmpty(tile))
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
    const std::uint64_t met =
      this->Last ? TakeMet(this->Key.Blended(), tile, *this->Last, seen) : 0;
    const std::uint64_t known = this->IsAllKnown ? ~std::uint64_t(0) : met;
    this->Trace(rays, known, world, seen);
    if (!frame.Met.empty())
    {
      KeepMet(this->Key.Blended(), tile, seen, frame);
    }
    this->Tracer->Finish(rays, world, seen);
    this->Store(rays, known, seen, frame, counts);
    if (this->Gradients)
    {
      HitList hits;
      GatherHits(this->Key.View, part, true, frame, hits);
      ComputeNormals(*this->Gradients, hits);
      StoreNormals(hits, frame);
    }
    counts.CellsRead = seen.CellsRead;
    return counts;
  }

  TraceCounts Find(std::int64_t tile, const LooseRays& loose, Frame& made) const override
  {
    TraceCounts counts;
    std::fill(made.Colors.begin(), made.Colors.end(), std::array<std::uint8_t, 4>{});
    if (!this->Tracer || this->IsEmpty(tile))
    {
      return counts;
    }
    RayBatch rays;
    WorldDirections world;
    loose.SetUp(this->Rays, rays, &world);
    const RayBatch::Array<std::int32_t> pixelsMade = rays.Pixel;
    rays.Pixel = loose.Pixel;
    this->EndWhereHidden(rays);
    rays.Pixel = pixelsMade;
    if (this->Space.Active)
    {
      this->Space.Bounds->Narrow(tile, rays);
    }
    BlendedRays seen;
    this->Tracer->Begin(seen);
    this->Trace(rays, 0, world, seen);
    this->Tracer->Finish(rays, world, seen);
    this->Store(rays, 0, seen, made, counts);
    counts.CellsRead = seen.CellsRead;
    return counts;
  }

private:
  /// True if a tile shows nothing. An empty sum does not count: it shows black.
  bool IsEmpty(std::int64_t tile) const
  {
    return this->Key.Blended().Mode != BlendMode::Additive &&
      ((this->IsAllKnown && this->Last->ClearTiles[static_cast<std::size_t>(tile)]) ||
        (this->Space.Active && this->Space.Bounds->At(tile).IsEmpty()));
  }

  /// End rays at opaque props.
  void EndWhereHidden(RayBatch& rays) const
  {
    if (const auto& ends = this->Key.Blended().Ends)
    {
      for (std::size_t i = 0; i < static_cast<std::size_t>(rays.Count); ++i)
      {
        const double end = (*ends)[static_cast<std::size_t>(rays.Pixel[i])];
        rays.End[i] = std::min(rays.End[i], end);
        rays.WalkEnd[i] = std::min(rays.WalkEnd[i], end);
      }
    }
  }

  /// Trace all rays except the known ones, one bit each.
  void Trace(const RayBatch& rays, std::uint64_t known, const WorldDirections& world,
    BlendedRays& seen) const
  {
    if (known == 0 && !this->Rays.Clipper.HasPieces())
    {
      this->Tracer->Trace(rays, world, seen);
    }
    else if (!this->Rays.Clipper.HasPieces())
    {
      this->TraceUnknown(rays, known, world, seen);
    }
    else if (~known != 0)
    {
      const RayPieces pieces(this->Rays.Clipper, rays);
      for (std::size_t piece = 0; piece < RegionClipper::MostPieces; ++piece)
      {
        RayBatch part = rays;
        if (pieces.Clip(piece, part) != 0)
        {
          this->TraceUnknown(part, known, world, seen);
        }
      }
    }
  }

  void TraceUnknown(
    const RayBatch& all, std::uint64_t known, const WorldDirections& world, BlendedRays& seen) const
  {
    if (~known == 0)
    {
      return;
    }
    RayBatch rays = all;
    for (std::size_t i = 0; i < static_cast<std::size_t>(rays.Count); ++i)
    {
      rays.End[i] = known >> i & 1 ? rays.Begin[i] : rays.End[i];
    }
    this->Tracer->Trace(rays, world, seen);
  }

  void Store(const RayBatch& rays, std::uint64_t known, const BlendedRays& seen, Frame& frame,
    TraceCounts& counts) const
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
        // If no single place on a ray is visible, the depth is the beginning of the ray.
        hits.Depth[i] = std::isfinite(seen.First[i]) ? seen.First[i] : rays.Begin[i];
        hits.Surface[i] = 0;
        hits.Kind[i] = HitKind::Entry;
      }
      const auto pixel = static_cast<std::size_t>(rays.Pixel[i]);
      frame.Colors[pixel] = color;
      frame.Normals[pixel] = glm::vec3(0.0f);
      const bool isTraced = rays.HasWalk(i) && !(known >> i & 1);
      const bool isHit = isSeen && !isTraced;
      answers[i] =
        isTraced ? Answer::PossibleHit : (isHit ? Answer::DefiniteHit : Answer::DefiniteMiss);
      counts.TracedRays += isTraced;
      counts.PossibleHits += isTraced;
      counts.DefiniteHits += isHit;
      counts.DefiniteMisses += !isTraced && !isHit;
    }
    StoreHits(rays, hits, answers, this->Key.View.Parallel, frame);
  }

  const FrameKey& Key;
  LeapedSpace Space;
  const Frame* Last;
  bool IsAllKnown; ///< every visible value, without a search
  RaySource Rays;
  std::shared_ptr<const BlendTracer> Tracer;
  std::optional<NormalSource> Gradients; ///< none: normals are 0
};

/// Make room for the frame, and find out where its rays can see anything.
/// \param searches false: no ray is searched
LeapedSpace BeginBlending(FrameTask& task, bool searches)
{
  Stopwatch watch(task.Statistics.TraceTime);
  const bool leaps =
    searches && task.Options.SpaceLeaping && task.Structures.PrepareVisibleCells(task.Key);
  FrameExtras extras;
  extras.Met = task.Options.Reuse.Frames ? NumbersMet(task.Key.Blended()) : 0;
  task.Store.Begin(task.Key, extras);
  task.Store.Next().Picture.MetWithin = ExtremesMet(task.Key.Blended());
  return task.Structures.VisibleSpace(leaps);
}

bool BlendTiles(FrameTask& task, const TileBlender& blender)
{
  return MakeTiles(task,
    [&](std::int64_t tile, const PixelRect& part, Frame& frame)
    { return blender.Blend(tile, part, frame); });
}

}

std::unique_ptr<RayColors> MakeBlendedColors(FrameTask& task)
{
  const bool leaps = task.Options.SpaceLeaping && task.Structures.PrepareVisibleCells(task.Key);
  return std::make_unique<TileBlender>(task, task.Structures.VisibleSpace(leaps));
}

LeapedSpace BeginBlended(FrameTask& task)
{
  return BeginBlending(task, true);
}

TileWork BlendedWork(const FrameTask& task, const LeapedSpace& space)
{
  const auto blender = std::make_shared<const TileBlender>(task, space);
  return [blender](std::int64_t tile, const PixelRect& part, Frame& frame)
  { return blender->Blend(tile, part, frame); };
}

bool BlendCold(FrameTask& task)
{
  const LeapedSpace space = BeginBlended(task);
  return BlendTiles(task, TileBlender(task, space));
}

bool BlendKnownValues(FrameTask& task)
{
  const Frame& last = task.Store.Last().Picture;
  const bool isAllKnown = KnowsAllExtremes(last.MetWithin, task.Key.Blended());
  const LeapedSpace space = BeginBlending(task, !isAllKnown);
  if (isAllKnown)
  {
    task.Store.Next().Picture.MetWithin = last.MetWithin;
  }
  return BlendTiles(task, TileBlender(task, space, &last));
}

}
