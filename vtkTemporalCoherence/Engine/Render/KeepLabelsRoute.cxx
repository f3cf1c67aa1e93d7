// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Render/RouteSteps.h"
#include "Scene/LabelIndex.h"

#include <hwy/base.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace TemporalCoherence
{
namespace
{

/// The labels of `some` that are not among `others`.
Surfaces Without(const std::vector<double>& others, const Surfaces& some)
{
  const LabelIndex index(others);
  Surfaces left;
  left.Mode = some.Mode;
  for (const double label : some.Isovalues)
  {
    if (!index.Has(static_cast<std::int64_t>(label)))
    {
      left.Isovalues.push_back(label);
    }
  }
  return left;
}

/// What the rays of the last frame met that stays when other labels are drawn.
class KeptHits
{
public:
  /// \pre active cells are prepared, if rays leap
  KeptHits(const FrameTask& task, const SampleComparer& changes)
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
    this->AreAddedBound = this->HasAdded && task.Options.SpaceLeaping;
    if (this->AreAddedBound)
    {
      this->OfAdded = task.Structures.BoundsOf(task.Key, added);
    }
  }

  /// The picture whose rays meet nothing before their old hit; null: they may.
  const Frame* Before() const { return this->HasAdded || this->Changes ? nullptr : &this->Last; }

  /// One bit for each pixel of a tile, row by row, whose ray must be traced: it met a label that is
  /// gone, or may meet another one earlier.
  std::uint64_t ToTrace(std::int64_t tile, const PixelRect& part) const
  {
    if (this->Changes && !this->Changes->CanCopy(tile))
    {
      return ~std::uint64_t(0) >> (64 - part.Size.x * part.Size.y);
    }
    const double added = this->NearestAdded(tile);
    const bool isClear = this->Last.ClearTiles[static_cast<std::size_t>(tile)] != 0;
    std::uint64_t which = 0;
    std::size_t bit = 0;
    for (int y = part.First.y; y < part.First.y + part.Size.y; ++y)
    {
      for (int x = part.First.x; x < part.First.x + part.Size.x; ++x, ++bit)
      {
        const std::size_t pixel = this->PlaceOf(x, y);
        const bool isGone = !isClear && this->Last.Isovalues[pixel] != Frame::NoSurface &&
          this->SurfaceNow(pixel) == Frame::NoSurface;
        const bool isHidden = isClear ? std::isfinite(added) : added <= this->Last.Depth[pixel];
        which |= static_cast<std::uint64_t>(isGone || isHidden) << bit;
      }
    }
    return which;
  }

  /// Copy a tile. The answers of its pixels become definite.
  /// \param traced pixels that are written later: they do not count
  TraceCounts Copy(
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

private:
  std::size_t PlaceOf(int x, int y) const
  {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(this->Last.Size.x) +
      static_cast<std::size_t>(x);
  }

  /// The position of the label that a pixel showed among those that are drawn now.
  SurfaceIndex SurfaceNow(std::size_t pixel) const
  {
    const SurfaceIndex before = this->Last.Isovalues[pixel];
    return before == Frame::NoSurface ? before : this->IndexNow[static_cast<std::size_t>(before)];
  }

  /// The distance from which on a tile may see added labels; infinity: nowhere.
  double NearestAdded(std::int64_t tile) const
  {
    return this->AreAddedBound ? static_cast<double>(this->OfAdded.At(tile).Near)
      : this->HasAdded         ? -std::numeric_limits<double>::infinity()
                               : std::numeric_limits<double>::infinity();
  }

  const Frame& Last;
  const SampleComparer* Changes; ///< null: no sample changed
  bool IsParallel;
  std::vector<SurfaceIndex> IndexNow; ///< of the last frame's surfaces
  bool HasAdded = false, AreAddedBound = false;
  TileBounds OfAdded;
};

}

bool TraceChangedLabels(FrameTask& task, const SampleComparer& changes)
{
  const LeapedSpace space = Begin(task, task.Options.SpaceLeaping, ExtrasToCopy(task));
  const KeptHits kept(task, changes);
  const TileTracer tracer(SceneOf(task, space, nullptr));
  const TileShader shader(ShadeSceneOf(task, space), HitSet::NotDefinite, HitSet::All);
  return MakeTiles(task,
    [&](std::int64_t tile, const PixelRect& part, Frame& frame)
    {
      const std::uint64_t which = kept.ToTrace(tile, part);
      TraceCounts counts = kept.Copy(tile, part, which, frame);
      if (which != 0)
      {
        counts += tracer.TraceSome(tile, part, which, frame, kept.Before());
      }
      shader.Shade(tile, part, nullptr, frame, counts);
      return counts;
    });
}

}
