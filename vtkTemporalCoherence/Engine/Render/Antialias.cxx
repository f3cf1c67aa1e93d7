// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Render/Antialias.h"

#include "Render/EdgePixels.h"
#include "Render/EdgeRays.h"
#include "Render/RayColors.h"
#include "Render/TileLoop.h"

#include <hwy/base.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace TemporalCoherence
{
namespace
{

using ColorPlane = Plane<std::array<std::uint8_t, 4>>;

/// So many pixels of a tile at edges are traced tile by tile, so that beams serve them.
constexpr std::size_t FewestOfBeam = 16;

/// Light whose rays are few makes colours grainy.
EdgeSign SignFor(const FrameKey& key)
{
  const Appearance& appearance = key.Appearance;
  const bool isGrainy = appearance.Occlusion.IsOn() ||
    std::any_of(appearance.Lights.begin(), appearance.Lights.end(),
      [](const Light& light) { return light.CastsSoftShadows(); });
  return isGrainy && appearance.HasMutualLight() && !key.IsBlended() ? EdgeSign::Normals
                                                                     : EdgeSign::Colors;
}

/// Sends more rays through the pixels at edges, tile by tile.
class EdgeTiles
{
public:
  EdgeTiles(const FrameKey& key, const RayColors& colors, const Frame& picture)
    : View(key.View)
    , Sign(SignFor(key))
    , HasCells(!picture.Cells.empty())
    , Colors(colors)
    , Picture(picture)
  {
  }

  /// \param shown gets the colours of pixels at edges
  /// \throws std::bad_alloc
  TraceCounts Make(std::int64_t tile, const PixelRect& part, ColorPlane& shown) const
  {
    TraceCounts counts;
    const std::uint64_t edges = FindEdges(this->Picture, part, this->Sign);
    if (edges == 0)
    {
      return counts;
    }
    std::array<EdgeRays::RaySum, RayBatch::Capacity> sums;
    Work work(tile, part, sums, this->OneRow());
    ForEachRay(edges,
      [&](std::size_t pixel)
      {
        const auto centre = static_cast<std::size_t>(this->PixelOf(part, pixel));
        sums[pixel].See(this->Picture.Colors[centre]);
      });
    std::uint64_t open = edges;
    std::size_t first = 0;
    for (const EdgeRays::Round& round : EdgeRays::Rounds)
    {
      ForEachRay(open,
        [&](std::size_t pixel)
        { open &= ~(std::uint64_t(sums[pixel].Contrast() < round.Contrast) << pixel); });
      this->Trace(open, first, round.Rays, work, counts);
      first = round.Rays;
    }
    ForEachRay(edges,
      [&](std::size_t pixel)
      { shown[static_cast<std::size_t>(this->PixelOf(part, pixel))] = sums[pixel].Mean(); });
    return counts;
  }

private:
  /// Work on a tile.
  struct Work
  {
    Work(std::int64_t tile, const PixelRect& part,
      std::array<EdgeRays::RaySum, RayBatch::Capacity>& sums, Frame made)
      : Tile(tile)
      , Part(part)
      , Sums(sums)
      , Made(std::move(made))
    {
    }

    std::int64_t Tile;
    const PixelRect& Part;
    std::array<EdgeRays::RaySum, RayBatch::Capacity>& Sums; ///< of the pixels
    Frame Made;                                             ///< the colours of rays
    LooseRays Rays;                                         ///< that wait to be traced
    RayBatch::Array<std::uint8_t> Pixel; ///< that each ray goes through: its place in the tile
  };

  /// A frame of one row, for the colours of rays.
  Frame OneRow() const
  {
    Frame frame;
    FrameExtras extras;
    extras.Cells = this->HasCells;
    frame.Resize(glm::ivec2(RayBatch::Capacity, 1), extras);
    return frame;
  }

  std::int32_t PixelOf(const PixelRect& part, std::size_t pixel) const
  {
    const auto place = static_cast<int>(pixel);
    return (part.First.y + place / part.Size.x) * this->View.Size.x + part.First.x +
      place % part.Size.x;
  }

  /// Trace the rays [first, end) of each pixel.
  void Trace(
    std::uint64_t pixels, std::size_t first, std::size_t end, Work& work, TraceCounts& counts) const
  {
    const bool areMany =
      hwy::PopCount(pixels) >= FewestOfBeam && work.Part.Size == glm::ivec2(TileSize);
    for (std::size_t ray = first; ray < end && areMany; ++ray)
    {
      for (std::size_t pixel = 0; pixel < RayBatch::Capacity; ++pixel)
      {
        this->Append(pixel, ray, work);
      }
      work.Rays.Empty = ~pixels;
      this->Flush(work, counts);
    }
    if (areMany)
    {
      return;
    }
    ForEachRay(pixels,
      [&](std::size_t pixel)
      {
        for (std::size_t ray = first; ray < end; ++ray)
        {
          this->Append(pixel, ray, work);
          if (work.Rays.Count == LooseRays::Most)
          {
            this->Flush(work, counts);
          }
        }
      });
    this->Flush(work, counts);
  }

  void Append(std::size_t pixel, std::size_t ray, Work& work) const
  {
    const auto place = static_cast<int>(pixel);
    const glm::ivec2 at =
      work.Part.First + glm::ivec2(place % work.Part.Size.x, place / work.Part.Size.x);
    const glm::dvec2 through = this->View.PixelCentre(at.x, at.y) +
      2.0 * EdgeRays::PlaceOf(ray) / glm::dvec2(this->View.Size);
    const std::size_t i = work.Rays.Count++;
    work.Rays.At.X[i] = through.x;
    work.Rays.At.Y[i] = through.y;
    work.Rays.Pixel[i] = this->PixelOf(work.Part, pixel);
    work.Pixel[i] = static_cast<std::uint8_t>(pixel);
  }

  /// Trace the rays that wait.
  void Flush(Work& work, TraceCounts& counts) const
  {
    if (work.Rays.Count == 0)
    {
      return;
    }
    for (std::size_t i = work.Rays.Count; i < RayBatch::Capacity; ++i)
    {
      work.Rays.At.X[i] = work.Rays.At.X[work.Rays.Count - 1];
      work.Rays.At.Y[i] = work.Rays.At.Y[work.Rays.Count - 1];
    }
    counts.CellsRead += this->Colors.Find(work.Tile, work.Rays, work.Made).CellsRead;
    const std::uint64_t wanted =
      ~work.Rays.Empty & ~std::uint64_t(0) >> (RayBatch::Capacity - work.Rays.Count);
    counts.TracedRays += static_cast<std::int64_t>(hwy::PopCount(wanted));
    ForEachRay(
      wanted, [&](std::size_t ray) { work.Sums[work.Pixel[ray]].Add(work.Made.Colors[ray]); });
    work.Rays.Count = 0;
    work.Rays.Empty = 0;
  }

  const TemporalCoherence::View& View;
  EdgeSign Sign;
  bool HasCells;
  const RayColors& Colors;
  const Frame& Picture;
};

}

bool Antialias(FrameTask& task, SurfaceLight* light, Frame& picture)
{
  ColorPlane shown = picture.IsAntialiased() ? picture.Antialiased : picture.Colors;
  if (!MayShowAnything(task.Key))
  {
    picture.Antialiased.swap(shown);
    return true;
  }
  // Light is found in whole frames only.
  const auto hasTime = [&]() { return light || task.Options.Fewer.HasTime(); };
  std::vector<std::uint8_t> open = picture.OpenEdges;
  open.resize(
    static_cast<std::size_t>(NumberOfTiles(picture.Size)), picture.OpenEdges.empty() ? 1 : 0);
  // A frame that begins without time makes one group.
  const bool isLate = !hasTime();
  std::atomic<bool> isBegun{ false };
  const std::unique_ptr<RayColors> colors =
    task.Key.IsBlended() ? MakeBlendedColors(task) : MakeSurfaceColors(task, light);
  const EdgeTiles edges(task.Key, *colors, picture);
  const bool isDone = CountGroups(picture.Size, task.Report, task.Statistics,
    [&](std::size_t group, TraceCounts& ofGroup)
    {
      std::optional<bool> isMade; // the one group
      CountGroup(picture.Size, group, ofGroup,
        [&](std::int64_t tile, const PixelRect& part)
        {
          std::uint8_t& isOpen = open[static_cast<std::size_t>(tile)];
          if (isOpen == 0)
          {
            return TraceCounts();
          }
          isMade = isMade ? isMade : isLate && !isBegun.exchange(true);
          if (!*isMade && !hasTime())
          {
            return TraceCounts();
          }
          isOpen = 0;
          return edges.Make(tile, part, shown);
        });
    });
  if (isDone)
  {
    picture.Antialiased.swap(shown);
    const bool isWhole = std::find(open.begin(), open.end(), 1) == open.end();
    picture.OpenEdges = isWhole ? std::vector<std::uint8_t>() : std::move(open);
  }
  return isDone;
}

}
