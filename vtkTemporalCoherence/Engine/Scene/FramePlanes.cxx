// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/FramePlanes.h"

#include "Scene/Disparity.h"
#include "Scene/KernelsPlanes.h"

#include <algorithm>
#include <limits>

namespace TemporalCoherence
{
namespace
{

/// Disparities are stored in single precision: this is their relative error.
constexpr double DisparityError = 1e-6;

/// The kind of a ray's hit as frames store it.
HitKind KindOf(const HitBatch& hits, std::size_t ray)
{
  return hits.Kind[ray] == HitKind::None && hits.FromInside[ray] ? HitKind::Within : hits.Kind[ray];
}

std::size_t PlaceOf(const Frame& frame, int x, int y)
{
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(frame.Size.x) +
    static_cast<std::size_t>(x);
}

}

void StoreMisses(std::int64_t tile, const PixelRect& part, bool isParallel, Frame& frame)
{
  std::uint8_t& isClear = frame.ClearTiles[static_cast<std::size_t>(tile)];
  if (isClear)
  {
    return;
  }
  const auto miss = static_cast<float>(DisparityOfMiss(isParallel));
  for (int y = part.First.y; y < part.First.y + part.Size.y; ++y)
  {
    const std::size_t row = PlaceOf(frame, part.First.x, y);
    Frame::ForEachPlane(miss,
      [&](auto plane, const auto& value)
      { std::fill_n(&(frame.*plane)[row], part.Size.x, value); });
  }
  isClear = 1;
}

TraceCounts CopyTile(
  std::int64_t tile, const PixelRect& part, const Frame& from, bool isParallel, Frame& frame)
{
  TraceCounts counts;
  const auto place = static_cast<std::size_t>(tile);
  if (!frame.Layers.empty())
  {
    frame.Layers[place] = from.Layers[place];
  }
  if (from.ClearTiles[place])
  {
    StoreMisses(tile, part, isParallel, frame);
    counts.DefiniteMisses = static_cast<std::int64_t>(part.Size.x) * part.Size.y;
    return counts;
  }
  frame.ClearTiles[place] = 0;
  for (int y = part.First.y; y < part.First.y + part.Size.y; ++y)
  {
    const std::size_t row = PlaceOf(frame, part.First.x, y);
    const auto count = static_cast<std::size_t>(part.Size.x);
    Frame::ForEachPlane(0.0f,
      [&](auto plane, const auto&)
      { std::copy_n(&(from.*plane)[row], count, &(frame.*plane)[row]); });
    for (std::size_t pixel = row; pixel < row + count; ++pixel)
    {
      const bool isHit = from.Isovalues[pixel] != Frame::NoSurface;
      frame.Answers[pixel] = isHit ? Answer::DefiniteHit : Answer::DefiniteMiss;
      counts.DefiniteHits += isHit;
      counts.DefiniteMisses += !isHit;
    }
  }
  return counts;
}

float DisparityAt(const RayBatch& rays, std::size_t ray, double t, bool isParallel)
{
  const double perDepth = rays.PerDepth[ray];
  return static_cast<float>(
    isParallel ? std::max(-t / perDepth, DisparityOfMiss(true)) : perDepth / t);
}

void StoreHit(const RayBatch& rays, const HitBatch& hits, std::size_t ray, Answer answer,
  bool isParallel, Frame& frame)
{
  const auto pixel = static_cast<std::size_t>(rays.Pixel[ray]);
  frame.Depth[pixel] = hits.Depth[ray];
  frame.Disparities[pixel] = DisparityAt(rays, ray, hits.Depth[ray], isParallel);
  frame.FirstEntries[pixel] = DisparityAt(rays, ray, hits.FirstEntry[ray], isParallel);
  frame.Isovalues[pixel] = hits.Surface[ray];
  frame.Kinds[pixel] = KindOf(hits, ray);
  frame.Answers[pixel] = answer;
}

void StoreHits(const RayBatch& rays, const HitBatch& hits, const RayBatch::Array<Answer>& answers,
  bool isParallel, Frame& frame)
{
  if (rays.Count == RayBatch::Capacity)
  {
    StoreRows(rays, hits, answers, isParallel, frame);
    return;
  }
  for (std::size_t i = 0; i < static_cast<std::size_t>(rays.Count); ++i)
  {
    StoreHit(rays, hits, i, answers[i], isParallel, frame);
  }
}

void BeginAtFirstEntries(const Frame& picture, bool isParallel, RayBatch& rays)
{
  const auto miss = static_cast<float>(DisparityOfMiss(isParallel));
  for (std::size_t i = 0; i < static_cast<std::size_t>(rays.Count); ++i)
  {
    const auto pixel = static_cast<std::size_t>(rays.Pixel[i]);
    const float firstEntry = picture.FirstEntries[pixel];
    const HitKind kind = picture.Kinds[pixel];
    const bool isKnown = kind == HitKind::Entry || (kind == HitKind::None && firstEntry != miss);
    if (isKnown)
    {
      const double t = DepthOf(static_cast<double>(firstEntry), isParallel) * rays.PerDepth[i];
      rays.WalkBegin[i] = std::max(rays.WalkBegin[i], t - DisparityError * std::abs(t));
    }
  }
}

}
