// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Isomap/KnotImage.h"

#include "Isomap/TileGroups.h"
#include "Scene/Parallel.h"
#include "Scene/Tiles.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace TemporalCoherence
{
namespace
{

double SignOf(double value)
{
  return value < 0.0 ? -1.0 : 1.0;
}

/// Tiles of an isomap, with the places of their pixels in an image.
class TilesOfMap
{
public:
  TilesOfMap(const Isomap& map, const ValueBand& range)
    : Map(map)
    , Range(range)
    , Size(map.FirstKey().View.Size)
  {
  }

  /// Call visit(knots, ray, pixel) for all pixels of tiles with knots, in parallel by groups.
  template <typename Visit>
  void ForPixels(const Visit& visit) const
  {
    ParallelFor(static_cast<std::int64_t>(this->Map.Size()), 1,
      [&](std::int64_t group)
      {
        const GroupBand* const band =
          this->Map.Find(static_cast<std::size_t>(group), this->Range.Low);
        const TileRange tiles = TilesOfGroup(this->Size, static_cast<std::size_t>(group));
        for (std::int64_t tile = tiles.First; band && tile < tiles.End; ++tile)
        {
          const TileKnots* const knots = band->At(static_cast<std::size_t>(tile % TileGrain), 1);
          if (knots && !knots->IsEmpty())
          {
            this->ForPixelsOf(tile, *knots, visit);
          }
        }
      });
  }

private:
  template <typename Visit>
  void ForPixelsOf(std::int64_t tile, const TileKnots& knots, const Visit& visit) const
  {
    const PixelRect pixels = PixelsOfTile(this->Size, tile);
    for (int ray = 0; ray < pixels.Size.x * pixels.Size.y; ++ray)
    {
      const glm::ivec2 at = pixels.First + glm::ivec2(ray % pixels.Size.x, ray / pixels.Size.x);
      visit(knots, static_cast<std::size_t>(ray),
        static_cast<std::size_t>(at.y) * static_cast<std::size_t>(this->Size.x) +
          static_cast<std::size_t>(at.x));
    }
  }

  const Isomap& Map;
  ValueBand Range;
  glm::ivec2 Size;
};

/// Copy the knots of one direction.
void CopyKnots(const TilesOfMap& tiles, std::size_t direction, PixelKnots& image)
{
  tiles.ForPixels(
    [&](const TileKnots& knots, std::size_t ray, std::size_t pixel)
    {
      const FittedKnots& table = knots.Fitted[direction];
      image.Begin[pixel + 1] =
        table.IsEmpty() ? 0 : static_cast<std::uint32_t>(table.Begin(ray + 1) - table.Begin(ray));
    });
  std::partial_sum(image.Begin.begin(), image.Begin.end(), image.Begin.begin());
  const std::size_t count = image.Begin.back();
  image.Progress.resize(count);
  image.Distance.resize(count);
  image.Normals.resize(count);
  image.Middles.resize(count);
  tiles.ForPixels(
    [&](const TileKnots& knots, std::size_t ray, std::size_t pixel)
    {
      const FittedKnots& table = knots.Fitted[direction];
      std::size_t to = image.Begin[pixel];
      for (std::size_t from = table.IsEmpty() ? 0 : table.Begin(ray); to < image.Begin[pixel + 1];
           ++from, ++to)
      {
        const PackedNormal* const normals = knots.Normals[direction].Get<0>() + 2 * from;
        image.Distance[to] = table.Get<0>()[from];
        image.Progress[to] = table.Get<1>()[from];
        image.Normals[to] = ToOctahedral({ normals[0][0], normals[0][1], normals[0][2] });
        image.Middles[to] = ToOctahedral({ normals[1][0], normals[1][1], normals[1][2] });
      }
    });
}

}

OctahedralNormal ToOctahedral(const glm::dvec3& normal)
{
  const double length = std::abs(normal.x) + std::abs(normal.y) + std::abs(normal.z);
  if (!(length > 0.0))
  {
    return {};
  }
  glm::dvec2 at(normal.x / length, normal.y / length);
  if (normal.z < 0.0)
  {
    at = { (1.0 - std::abs(at.y)) * SignOf(at.x), (1.0 - std::abs(at.x)) * SignOf(at.y) };
  }
  return { static_cast<std::int8_t>(std::lround(at.x * OctahedralSteps)),
    static_cast<std::int8_t>(std::lround(at.y * OctahedralSteps)) };
}

glm::dvec3 FromOctahedral(const OctahedralNormal& packed, int steps)
{
  glm::dvec3 normal(
    packed[0] / static_cast<double>(steps), packed[1] / static_cast<double>(steps), 0.0);
  normal.z = 1.0 - std::abs(normal.x) - std::abs(normal.y);
  if (normal.z < 0.0)
  {
    const double x = normal.x;
    normal.x = (1.0 - std::abs(normal.y)) * SignOf(x);
    normal.y = (1.0 - std::abs(x)) * SignOf(normal.y);
  }
  return glm::normalize(normal);
}

double KnotImage::StepsOf(ValueDirection direction, double isovalue) const
{
  const double difference = isovalue - this->Values.Low;
  const double span = this->Values.High - this->Values.Low;
  return this->Grid.StepsOf(direction == ValueDirection::Rising ? difference : span - difference);
}

KnotImage::Hit KnotImage::LookUp(std::size_t pixel, double isovalue) const
{
  Hit hit;
  const double rising = this->StepsOf(ValueDirection::Rising, isovalue);
  const double entry = this->Entries.empty() ? 0.0 : this->Entries[pixel];
  hit.Direction = entry > rising ? ValueDirection::Falling : ValueDirection::Rising;
  const PixelKnots& knots = this->Knots[static_cast<std::size_t>(hit.Direction)];
  const bool isUnknown = !this->Unknown.empty() && this->Unknown[pixel] != 0;
  hit.IsSure = !isUnknown && !(entry > 0.0 && std::abs(entry - rising) <= 1.5);
  if (isUnknown || knots.IsEmpty(pixel))
  {
    return hit;
  }
  FitPoint point{};
  const double steps =
    hit.Direction == ValueDirection::Rising ? rising : this->StepsOf(hit.Direction, isovalue);
  // Errors of progress are for look-ups that could trace the ray instead.
  const FitAnswer answer = FindInFit(knots.RayOf(pixel), steps, 1.0, point);
  hit.IsReached = answer == FitAnswer::Reached || answer == FitAnswer::UnsureHit;
  hit.IsSure &= answer == FitAnswer::Reached || answer == FitAnswer::Missed;
  if (hit.IsReached)
  {
    const glm::dvec3 before = FromOctahedral(knots.Normals[point.Before], this->NormalSteps);
    const glm::dvec3 behind = FromOctahedral(knots.Normals[point.Knot], this->NormalSteps);
    const glm::dvec3 middle = FromOctahedral(knots.Middles[point.Knot], this->NormalSteps);
    const glm::dvec3 mean = NormalOnPiece(before, middle, behind, static_cast<double>(point.Share));
    const double length = glm::length(mean);
    hit.Distance = point.Distance * this->Grid.DistanceStep;
    hit.Normal = length > 0.0 ? mean / length : behind;
  }
  return hit;
}

KnotImage ImageOf(const Isomap& map, const ValueBand& range, const glm::dvec2& finiteRange)
{
  const FrameKey& key = map.FirstKey();
  const BandScale scale(key.Samples.Type, range, finiteRange);
  const KnotGrid grid = scale.GridFor(map.Tolerance(), map.Form().LargestProgress);
  const TilesOfMap tiles(map, range);
  const auto pixels =
    static_cast<std::size_t>(key.View.Size.x) * static_cast<std::size_t>(key.View.Size.y);

  KnotImage image;
  image.Size = key.View.Size;
  image.Values = range;
  image.Grid = grid;
  image.Grid.ProgressStep /= scale.Isovalues.Factor;
  for (std::size_t direction = 0; direction < NumberOfDirections; ++direction)
  {
    image.Knots[direction].Begin.assign(pixels + 1, 0);
    CopyKnots(tiles, direction, image.Knots[direction]);
  }
  image.Entries.assign(pixels, 0);
  image.Unknown.assign(pixels, 0);
  tiles.ForPixels(
    [&](const TileKnots& knots, std::size_t ray, std::size_t pixel)
    {
      image.Unknown[pixel] = static_cast<std::uint8_t>(knots.Unresolved >> ray & 1u);
      const double entry =
        knots.Entries.empty() ? -1.0 : static_cast<double>(knots.Entries[ray]) * scale.Unit;
      if (entry >= 0.0)
      {
        const double steps = std::round(grid.StepsOf(entry));
        image.Entries[pixel] =
          static_cast<std::uint16_t>(std::min(std::max(steps, 1.0), 1.0 * grid.LargestProgress));
      }
    });
  const auto isZero = [](auto value) { return value == 0; };
  if (std::all_of(image.Entries.begin(), image.Entries.end(), isZero))
  {
    image.Entries.clear();
  }
  if (std::all_of(image.Unknown.begin(), image.Unknown.end(), isZero))
  {
    image.Unknown.clear();
  }
  return image;
}

}
