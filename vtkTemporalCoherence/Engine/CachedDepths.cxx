// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CachedDepths.h"

#include "Parallel.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace TemporalCoherence
{
namespace
{

constexpr std::int64_t RowGrain = 16;

/// A neighbourhood is a smooth surface if opposite neighbours bend away from the plane through the
/// pixel by at most this share of the margin; the margin is then this share of itself.
constexpr float SmoothBend = 0.25f;
constexpr float SmoothMargin = 0.125f;

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

namespace
{

/// Makes guard disparities row by row.
class GuardRows
{
public:
  GuardRows(
    const Frame& frame, const View& view, const GuardOptions& options, const CachedDepths& depths)
    : Picture(frame)
    , Depths(depths)
    , Options(options)
    , IsParallel(view.Parallel)
    , Columns(static_cast<std::size_t>(frame.Size.x))
    , Outside(static_cast<float>(DisparityOfMiss(view.Parallel)))
    , Farthest(std::isfinite(options.FarthestDepth)
          ? static_cast<float>(DisparityOf(options.FarthestDepth, view.Parallel))
          : static_cast<float>(DisparityOfMiss(view.Parallel)))
  {
    this->Rows.fill(std::vector<float>(this->Columns + 2));
  }

  /// Read a row of the picture, in place of the one read three calls before.
  void Read(int row)
  {
    std::swap(this->Rows[0], this->Rows[1]);
    std::swap(this->Rows[1], this->Rows[2]);
    GatherRow(this->Picture, this->Depths, this->Options, row, this->Outside, this->Rows[2].data());
  }

  /// Make the row in the middle of the last three.
  void Make(float* out) const
  {
    const auto margin = static_cast<float>(this->Options.Margin);
    const float* const above = this->Rows[2].data();
    const float* const here = this->Rows[1].data();
    const float* const below = this->Rows[0].data();
    for (std::size_t x = 0; x < this->Columns; ++x)
    {
      const float centre = here[x + 1];
      float largest = centre, smallest = centre, bend = 0.0f;
      const auto look = [&](float a, float b)
      {
        largest = std::max(largest, std::max(a, b));
        smallest = std::min(smallest, std::min(a, b));
        bend = std::max(bend, std::abs((a - centre) + (b - centre)));
      };
      look(here[x], here[x + 2]);
      look(above[x], below[x + 2]);
      look(above[x + 1], below[x + 1]);
      look(above[x + 2], below[x]);

      // Disparity is affine on a plane, and half way to the neighbours are the pixel's corners.
      const float perMargin = this->IsParallel ? 1.0f : largest * smallest;
      const bool isSmooth = bend <= SmoothBend * margin * perMargin;
      const float nearest = isSmooth ? 0.5f * (centre + largest) : largest;
      const float distance = isSmooth ? SmoothMargin * margin : margin;
      const float moved = this->IsParallel ? nearest + distance : Nearer(nearest, distance);
      out[x] = std::max(moved, this->Farthest);
    }
  }

private:
  /// 1 / (depth - distance) from 1 / depth; infinity if that is behind the eye.
  static float Nearer(float disparity, float distance)
  {
    const float left = 1.0f - distance * disparity;
    return left > 0.0f ? disparity / left : std::numeric_limits<float>::infinity();
  }

  const Frame& Picture;
  const CachedDepths& Depths;
  const GuardOptions& Options;
  bool IsParallel;
  std::size_t Columns;
  float Outside, Farthest;
  std::array<std::vector<float>, 3> Rows; ///< with a pixel outside at both ends
};

}

void MakeGuardDepths(
  const Frame& frame, const View& view, const GuardOptions& options, CachedDepths& depths)
{
  depths.Guard.resize(depths.Surface.size());
  const std::int64_t strips = (frame.Size.y + RowGrain - 1) / RowGrain;
  std::vector<GuardRows> makers(
    static_cast<std::size_t>(strips), GuardRows(frame, view, options, depths));
  ParallelFor(strips, 1,
    [&](std::int64_t strip)
    {
      GuardRows& rows = makers[static_cast<std::size_t>(strip)];
      const int begin = static_cast<int>(strip * RowGrain);
      const int end = std::min(begin + static_cast<int>(RowGrain), frame.Size.y);
      rows.Read(begin - 1);
      rows.Read(begin);
      for (int row = begin; row < end; ++row)
      {
        rows.Read(row + 1);
        const std::size_t first =
          static_cast<std::size_t>(row) * static_cast<std::size_t>(frame.Size.x);
        rows.Make(&depths.Guard[first]);
      }
    });
  depths.HasGuard = true;
  depths.Guarded = options;
}

}
