// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Render/KeptLabels.h"

#include "Lattice/RaySource.h"
#include "Render/CapTiles.h"
#include "Scene/LabelIndex.h"

#include <hwy/base.h>

#include <limits>

namespace TemporalCoherence
{
namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();

/// All pixels of a part of the picture, one bit each.
std::uint64_t All(const PixelRect& part)
{
  return ~std::uint64_t(0) >> (64 - part.Size.x * part.Size.y);
}

/// Surfaces of all labels but some.
Surfaces Without(const std::vector<double>& labels, const Surfaces& all)
{
  const LabelIndex index(labels);
  Surfaces left;
  left.Mode = all.Mode;
  for (const double label : all.Isovalues)
  {
    if (!index.Has(static_cast<std::int64_t>(label)))
    {
      left.Isovalues.push_back(label);
    }
  }
  return left;
}

/// For each tile, the distance from which on its rays may meet added labels; infinity: nowhere.
std::vector<double> NearestOf(const FrameTask& task, const Surfaces& added)
{
  const FrameKey& key = task.Key;
  const auto tiles = static_cast<std::size_t>(NumberOfTiles(key.View.Size));
  if (added.Isovalues.empty() || !task.Options.SpaceLeaping)
  {
    return std::vector<double>(tiles, added.Isovalues.empty() ? Infinity : -Infinity);
  }
  const FrameStructures& structures = task.Structures;
  ActiveCells active;
  active.Build(
    structures.Ranges().Samples, structures.Pyramid(), added, structures.SpaceToLeap(true).Active);
  TileBounds bounds;
  bounds.Build(key.View, key.Transform, active, *key.Samples.Shape);
  // Rays may begin in an added label, where no cell is active.
  FrameKey ofAdded = key;
  ofAdded.EditIsosurfaces() = added;
  const std::vector<std::uint8_t> capped = FindCapTiles(ofAdded,
    RaySource(key.View, key.Transform, key.Samples.Dimensions, key.Region), structures.Pyramid());
  std::vector<double> nearest(tiles);
  for (std::size_t tile = 0; tile < tiles; ++tile)
  {
    nearest[tile] = capped[tile]
      ? -Infinity
      : static_cast<double>(bounds.At(static_cast<std::int64_t>(tile)).Near);
  }
  return nearest;
}

}

KeptLabels::KeptLabels(const FrameTask& task, const SampleComparer& changes)
  : Last(task.Store.Last().Picture)
  , Changes(task.Store.Last().Key.Samples == task.Key.Samples ? nullptr : &changes)
  , IsParallel(task.Key.View.Parallel)
{
  const std::vector<double>& last = task.Store.Last().Key.Isosurfaces().Isovalues;
  const Surfaces& next = task.Key.Isosurfaces();
  const LabelIndex index(next.Isovalues);
  for (const double label : last)
  {
    this->IndexNow.push_back(index.Of(static_cast<std::int64_t>(label)));
  }
  const Surfaces added = Without(last, next);
  this->HasAdded = !added.Isovalues.empty();
  this->NearestAdded = NearestOf(task, added);
}

std::uint64_t KeptLabels::ToTrace(std::int64_t tile, const PixelRect& part) const
{
  if (this->Changes && !this->Changes->CanCopy(tile))
  {
    return All(part);
  }
  const double added = this->NearestAdded[static_cast<std::size_t>(tile)];
  if (this->Last.ClearTiles[static_cast<std::size_t>(tile)])
  {
    return added < Infinity ? All(part) : 0;
  }
  std::uint64_t which = 0;
  std::size_t bit = 0;
  for (int y = part.First.y; y < part.First.y + part.Size.y; ++y)
  {
    for (int x = part.First.x; x < part.First.x + part.Size.x; ++x, ++bit)
    {
      const std::size_t pixel = this->PlaceOf(x, y);
      const bool isGone = this->Last.Isovalues[pixel] != Frame::NoSurface &&
        this->SurfaceNow(pixel) == Frame::NoSurface;
      const bool mayMeetOther = added < Infinity && added <= this->Last.Depth[pixel];
      which |= static_cast<std::uint64_t>(isGone || mayMeetOther) << bit;
    }
  }
  return which;
}

TraceCounts KeptLabels::Copy(
  std::int64_t tile, const PixelRect& part, std::uint64_t traced, Frame& frame) const
{
  TraceCounts counts = CopyTile(tile, part, this->Last, this->IsParallel, frame);
  std::uint8_t& isClear = frame.ClearTiles[static_cast<std::size_t>(tile)];
  for (int y = part.First.y; isClear == 0 && y < part.First.y + part.Size.y; ++y)
  {
    for (int x = part.First.x; x < part.First.x + part.Size.x; ++x)
    {
      const std::size_t pixel = this->PlaceOf(x, y);
      frame.Isovalues[pixel] = this->SurfaceNow(pixel);
    }
  }
  isClear = traced != 0 ? 0 : isClear;
  for (std::uint64_t left = traced; left != 0; left &= left - 1)
  {
    const auto place = static_cast<int>(hwy::Num0BitsBelowLS1Bit_Nonzero64(left));
    const std::size_t pixel =
      this->PlaceOf(part.First.x + place % part.Size.x, part.First.y + place / part.Size.x);
    const bool wasHit = frame.Answers[pixel] == Answer::DefiniteHit;
    counts.DefiniteHits -= wasHit;
    counts.DefiniteMisses -= !wasHit;
  }
  return counts;
}

std::size_t KeptLabels::PlaceOf(int x, int y) const
{
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(this->Last.Size.x) +
    static_cast<std::size_t>(x);
}

/// The position of the label that a pixel showed among those that are drawn now.
SurfaceIndex KeptLabels::SurfaceNow(std::size_t pixel) const
{
  const SurfaceIndex before = this->Last.Isovalues[pixel];
  return before == Frame::NoSurface ? before : this->IndexNow[static_cast<std::size_t>(before)];
}

}
