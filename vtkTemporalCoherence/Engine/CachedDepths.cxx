// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CachedDepths.h"

#include "Parallel.h"

#include <algorithm>
#include <cmath>

namespace TemporalCoherence
{
namespace
{

constexpr std::int64_t RowGrain = 16;

/// Surface disparities of a row; `out` has room for one more pixel at both ends.
void GatherRow(const Frame& frame, const CachedDepths& depths, const GuardOptions& options, int row,
  float outside, float* out)
{
  const auto columns = static_cast<std::size_t>(frame.Size.x);
  if (row < 0 || row >= frame.Size.y)
  {
    std::fill_n(out, columns + 2, outside);
    return;
  }
  const std::size_t first = static_cast<std::size_t>(row) * columns;
  out[0] = out[columns + 1] = outside;
  std::copy_n(&depths.Surface[first], columns, out + 1);
  if (options.OnlyEntered)
  {
    for (std::size_t x = 0; x < columns; ++x)
    {
      if (frame.Kinds[first + x] != HitKind::Enters)
      {
        out[x + 1] = std::numeric_limits<float>::infinity();
      }
    }
  }
}

}

void MakeSurfaceDepths(const Frame& frame, const View& view, CachedDepths& depths)
{
  const auto columns = static_cast<std::size_t>(frame.Size.x);
  depths.Surface.resize(columns * static_cast<std::size_t>(frame.Size.y));
  ParallelFor(frame.Size.y, RowGrain,
    [&](std::int64_t row)
    {
      const std::size_t first = static_cast<std::size_t>(row) * columns;
      for (std::size_t x = 0; x < columns; ++x)
      {
        // Unlike t, depth along the axis needs no square root for a perspective's misses.
        const double t = frame.Depth[first + x];
        if (t == std::numeric_limits<double>::infinity())
        {
          depths.Surface[first + x] = static_cast<float>(DisparityOfMiss(view.Parallel));
          continue;
        }
        const Ray ray = view.RayThrough(static_cast<int>(x), static_cast<int>(row));
        const double depth = t * glm::dot(ray.Direction, view.Forward);
        depths.Surface[first + x] = static_cast<float>(DisparityOf(depth, view.Parallel));
      }
    });
  depths.HasSurface = true;
}

void MakeGuardDepths(
  const Frame& frame, const View& view, const GuardOptions& options, CachedDepths& depths)
{
  const auto columns = static_cast<std::size_t>(frame.Size.x);
  const auto outside = static_cast<float>(DisparityOfMiss(view.Parallel));
  const auto farthest = static_cast<float>(std::isfinite(options.FarthestDepth)
      ? DisparityOf(options.FarthestDepth, view.Parallel)
      : DisparityOfMiss(view.Parallel));
  const auto margin = static_cast<float>(options.Margin);
  depths.Guard.resize(depths.Surface.size());

  const std::int64_t strips = (frame.Size.y + RowGrain - 1) / RowGrain;
  std::vector<float> scratch(static_cast<std::size_t>(strips) * 4 * (columns + 2));
  ParallelFor(strips, 1,
    [&](std::int64_t strip)
    {
      float* const across = &scratch[static_cast<std::size_t>(strip) * 4 * (columns + 2)];
      float* const gathered = across + 3 * (columns + 2);
      const auto fill = [&](int row)
      {
        GatherRow(frame, depths, options, row, outside, gathered);
        float* const out = across + static_cast<std::size_t>((row + 3) % 3) * (columns + 2);
        for (std::size_t x = 0; x < columns; ++x)
        {
          out[x] = std::max(gathered[x], std::max(gathered[x + 1], gathered[x + 2]));
        }
      };
      const int begin = static_cast<int>(strip * RowGrain);
      const int end = std::min(begin + static_cast<int>(RowGrain), frame.Size.y);
      fill(begin - 1);
      fill(begin);
      for (int row = begin; row < end; ++row)
      {
        fill(row + 1);
        float* const out = &depths.Guard[static_cast<std::size_t>(row) * columns];
        const float* const a = across;
        const float* const b = across + (columns + 2);
        const float* const c = across + 2 * (columns + 2);
        for (std::size_t x = 0; x < columns; ++x)
        {
          const float nearest = std::max(std::max(a[x], b[x]), std::max(c[x], farthest));
          if (view.Parallel)
          {
            out[x] = nearest + margin;
          }
          else
          {
            // 1 / (depth - margin), and no free space at all in front of it if that is behind.
            const float left = 1.0f - margin * nearest;
            out[x] = left > 0.0f ? nearest / left : std::numeric_limits<float>::infinity();
          }
        }
      }
    });
  depths.HasGuard = true;
  depths.Guarded = options;
}

}
