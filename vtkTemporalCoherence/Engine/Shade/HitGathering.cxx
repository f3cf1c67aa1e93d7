// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// The hits of a tile become the arrays that shading works on.

#include "Shade/Shader.h"

#include <algorithm>

#include <hwy/base.h>

namespace TemporalCoherence
{
namespace
{

template <typename T>
using Array = HitList::Array<T>;

/// Normalised device coordinates of the columns and rows of a part of the picture.
struct PixelCentres
{
  PixelCentres(const View& view, const PixelRect& part)
  {
    for (int column = 0; column < part.Size.x; ++column)
    {
      this->X[static_cast<std::size_t>(column)] = view.PixelCentre(part.First.x + column, 0).x;
    }
    for (int row = 0; row < part.Size.y; ++row)
    {
      this->Y[static_cast<std::size_t>(row)] = view.PixelCentre(0, part.First.y + row).y;
    }
  }

  Array<double> X, Y;
};

/// Sorts the pixels of a part of the picture into hits and misses, row by row.
class PixelSorter
{
public:
  PixelSorter(bool withDefiniteHits, Frame& frame, HitList& hits)
    : WithDefiniteHits(withDefiniteHits)
    , Planes(frame)
    , Hits(hits)
  {
    hits.Rays.Count = 0;
  }

  /// Sort the pixels [first, first + count) of a row.
  void Sort(std::size_t first, std::size_t count, const double* x, double y)
  {
    const SurfaceIndex* const surfaces = &this->Planes.Isovalues[first];
    if (count == TileSize && this->WithDefiniteHits)
    {
      // Most rows are full or empty.
      int hitCount = 0;
      for (std::size_t i = 0; i < TileSize; ++i)
      {
        hitCount += surfaces[i] != Frame::NoSurface ? 1 : 0;
      }
      if (hitCount == TileSize)
      {
        this->TakeRow(first, x, y);
        return;
      }
      if (hitCount == 0)
      {
        std::fill_n(&this->Planes.Normals[first], TileSize, glm::vec3(0.0f));
        std::fill_n(&this->Planes.Colors[first], TileSize, NoColor);
        return;
      }
    }
    this->SortRow(first, count, x, y);
  }

private:
  static constexpr std::array<std::uint8_t, 4> NoColor = { 0, 0, 0, 0 };

  /// Take a row of hits.
  void TakeRow(std::size_t first, const double* x, double y)
  {
    const std::size_t at = this->Hits.Rays.Count;
    // Copy array by array: the compiler does not know that the arrays do not overlap.
    for (std::size_t i = 0; i < TileSize; ++i)
    {
      this->Hits.Pixel[at + i] = static_cast<std::int32_t>(first + i);
    }
    std::copy_n(&this->Planes.Isovalues[first], TileSize, &this->Hits.Surface[at]);
    std::copy_n(&this->Planes.Kinds[first], TileSize, &this->Hits.Kind[at]);
    if (!this->Planes.Cells.empty())
    {
      std::copy_n(&this->Planes.Cells[first], TileSize, &this->Hits.Cell[at]);
    }
    std::copy_n(x, TileSize, &this->Hits.X[at]);
    std::fill_n(&this->Hits.Y[at], TileSize, y);
    std::copy_n(&this->Planes.Depth[first], TileSize, &this->Hits.Rays.T[at]);
    this->Hits.Rays.Count = at + TileSize;
  }

  /// Sort a row of hits and misses.
  void SortRow(std::size_t first, std::size_t count, const double* x, double y)
  {
    Array<std::size_t> misses;
    std::size_t hitCount = this->Hits.Rays.Count, missCount = 0;
    for (std::size_t i = 0; i < count; ++i)
    {
      // Without branches, which would be mispredicted at silhouettes: every pixel is written to the
      // end of both lists, but extends one list at most.
      const std::size_t pixel = first + i;
      const bool isMiss = this->Planes.Isovalues[pixel] == Frame::NoSurface;
      const bool isKnown =
        !this->WithDefiniteHits && this->Planes.Answers[pixel] == Answer::DefiniteHit;
      this->Hits.Pixel[hitCount] = static_cast<std::int32_t>(pixel);
      this->Hits.Surface[hitCount] = this->Planes.Isovalues[pixel];
      this->Hits.Kind[hitCount] = this->Planes.Kinds[pixel];
      this->Hits.Cell[hitCount] = this->Planes.Cells.empty() ? NoCell : this->Planes.Cells[pixel];
      this->Hits.X[hitCount] = x[i];
      this->Hits.Y[hitCount] = y;
      this->Hits.Rays.T[hitCount] = this->Planes.Depth[pixel];
      misses[missCount] = pixel;
      hitCount += isMiss || isKnown ? 0 : 1;
      missCount += isMiss ? 1 : 0;
    }
    this->Hits.Rays.Count = hitCount;
    for (std::size_t i = 0; i < missCount; ++i)
    {
      this->Planes.Normals[misses[i]] = glm::vec3(0.0f);
      this->Planes.Colors[misses[i]] = NoColor;
    }
  }

  bool WithDefiniteHits;
  Frame& Planes;
  HitList& Hits;
};

}

void GatherHits(
  const View& view, const PixelRect& part, bool withDefiniteHits, Frame& frame, HitList& hits)
{
  hits.Misses = 0;
  const PixelCentres centres(view, part);
  PixelSorter sorter(withDefiniteHits, frame, hits);
  for (int row = 0; row < part.Size.y; ++row)
  {
    const int first = (part.First.y + row) * frame.Size.x + part.First.x;
    sorter.Sort(static_cast<std::size_t>(first), static_cast<std::size_t>(part.Size.x),
      centres.X.data(), centres.Y[static_cast<std::size_t>(row)]);
  }
  FindHitRays(view, hits);
}

void TakeHits(const View& view, const TileHits& found, HitList& hits)
{
  hits.Pixel = found.Rays.Pixel;
  hits.Surface = found.Hits.Surface;
  hits.Kind = found.Hits.Kind;
  hits.Cell = found.Hits.Cell;
  hits.Gradients = &found.Hits.Gradients;
  hits.Rays.Eye = view.Origin;
  hits.Rays.Direction = &found.World;
  const std::uint64_t met = ShadingKernels::TakeFinite(found.Hits.Depth, hits.Rays.T);
  hits.Rays.Count = met != 0 ? RayBatch::Capacity : 0;
  hits.Misses = ~met;
  for (std::uint64_t left = hits.Misses; left != 0 && met != 0; left &= left - 1)
  {
    hits.Surface[hwy::Num0BitsBelowLS1Bit_Nonzero64(left)] =
      hits.Surface[hwy::Num0BitsBelowLS1Bit_Nonzero64(met)];
  }
}

void TakeHitsAt(const View& view, const RayPlaces& at, const TileHits& found, HitList& hits)
{
  std::size_t& count = hits.Rays.Count;
  count = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(found.Rays.Count); ++i)
  {
    hits.Pixel[count] = found.Rays.Pixel[i];
    hits.Surface[count] = found.Hits.Surface[i];
    hits.Kind[count] = found.Hits.Kind[i];
    hits.Cell[count] = found.Hits.Cell[i];
    hits.X[count] = at.X[i];
    hits.Y[count] = at.Y[i];
    hits.Rays.T[count] = found.Hits.Depth[i];
    count += found.Hits.Surface[i] != Frame::NoSurface;
  }
  FindHitRays(view, hits);
}

void ClearMisses(const HitList& hits, Frame& frame)
{
  for (std::uint64_t left = hits.Misses; left != 0; left &= left - 1)
  {
    const auto pixel =
      static_cast<std::size_t>(hits.Pixel[hwy::Num0BitsBelowLS1Bit_Nonzero64(left)]);
    frame.Normals[pixel] = glm::vec3(0.0f);
    frame.Colors[pixel] = {};
  }
}

void FindHitRays(const View& view, HitList& hits)
{
  const std::size_t count = hits.Rays.Count;
  if (count > 0)
  {
    FillLastVector(count, hits.X);
    FillLastVector(count, hits.Y);
    FillLastVector(count, hits.Rays.T);
    ShadingKernels::FindRays(view, hits.X, hits.Y, hits.Rays);
  }
}

}
