// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Acceleration/TileBounds.h"

#include "Scene/Parallel.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace TemporalCoherence
{
namespace
{

using Bounds = TileBounds::Bounds;

/// Nodes are projected in this many parallel parts, each into tiles of its own.
constexpr int NumberOfParts = 8;

/// Margin in pixels around projections, against rounding.
constexpr double Margin = 1.0 / 64;

/// Relative margin of bounds, which are stored in single precision.
constexpr double Slack = 1e-6;

/// Rounding error of a sum and of the ray compared with it, relative to the sum's largest terms.
/// Terms may be much larger than their sum in long thin cells and far from the origin.
constexpr double Rounding = 64.0 * std::numeric_limits<double>::epsilon();

/// Nodes of at most this half width in pixels are projected as one box instead of leaf by leaf:
/// they look as small as leaves of other volumes. Measured by `Benchmark --scenarios growth`.
constexpr double SmallNode = 10.0;

/// A box of cells.
struct Box
{
  glm::dvec3 Centre, Half; ///< half of its edges
};

/// The box around the active leaves of a node, given their word, in leaves: first leaf and size.
std::array<glm::ivec3, 2> LeavesAround(std::uint64_t leaves)
{
  glm::ivec3 first(3), last(0);
  for (int leaf = 0; leaf < ValueRangePyramid::LeavesPerNode && leaves >> leaf; ++leaf)
  {
    if (leaves >> leaf & 1u)
    {
      const glm::ivec3 place(leaf & 3, leaf >> 2 & 3, leaf >> 4);
      first = glm::min(first, place);
      last = glm::max(last, place);
    }
  }
  return { first, last - first + 1 };
}

/// Projects boxes of cells into tiles.
class BoxProjector
{
public:
  /// \param cells of the field along each axis
  BoxProjector(const TemporalCoherence::View& view, const IndexTransform& transform,
    const glm::ivec2& tiles, const glm::ivec3& cells, const FieldShape& shape)
    : View(view)
    , Tiles(tiles)
    , Shape(shape)
    , AreAlike(shape.AreBlocksAlike())
    , ClipFromIndex(view.ClipFromWorld * transform.WorldFromIndex)
    , WorldFromIndex(transform.WorldFromIndex)
  {
    if (view.Parallel)
    {
      // Rays begin on the plane through the camera, perhaps at an angle.
      const double cosine = glm::dot(view.Forward, glm::normalize(view.Direction));
      this->ParallelDepth = view.Forward / cosine;
      this->PerRadius = 1.0 / cosine;
    }
    this->LeafRadius = this->RadiusOf(glm::dvec3(0.5 * ValueRangePyramid::LeafSize));
    this->FindErrors(glm::dvec4(cells, 1.0));
  }

  /// The box of the cells first .. first + cells - 1 of each axis.
  Box BoxOf(const glm::ivec3& first, const glm::ivec3& cells) const
  {
    const IndexBox box = this->Shape.BoxOf({ first, cells });
    return { 0.5 * (box.Low + box.High), 0.5 * (box.High - box.Low) };
  }

  /// Radius of the sphere around a box, as a distance along rays.
  double RadiusOf(const glm::dvec3& half) const
  {
    double radius = 0.0;
    for (int corner = 0; corner < 4; ++corner)
    {
      const glm::dvec3 diagonal(
        half.x, corner & 1 ? half.y : -half.y, corner & 2 ? half.z : -half.z);
      radius = std::max(radius, glm::length(glm::dmat3(this->WorldFromIndex) * diagonal));
    }
    return radius * this->PerRadius;
  }

  /// True if a box is small in the picture.
  bool IsSmall(const Box& box) const
  {
    const double w = (this->ClipFromIndex * glm::dvec4(box.Centre, 1.0)).w;
    glm::dvec2 extent(0.0);
    for (int axis = 0; axis < 3; ++axis)
    {
      extent += box.Half[axis] * glm::abs(glm::dvec2(this->ClipFromIndex[axis]));
    }
    const glm::dvec2 pixels = 0.5 * extent * glm::dvec2(this->View.Size);
    return pixels.x < SmallNode * w && pixels.y < SmallNode * w;
  }

  void WidenByLeaf(const glm::ivec3& firstCell, std::vector<Bounds>& bounds) const
  {
    const Box box = this->BoxOf(firstCell, glm::ivec3(ValueRangePyramid::LeafSize));
    this->Widen(box, this->AreAlike ? this->LeafRadius : this->RadiusOf(box.Half), bounds);
  }

  void Widen(const Box& box, double radius, std::vector<Bounds>& bounds) const
  {
    const glm::dvec3 world(this->WorldFromIndex * glm::dvec4(box.Centre, 1.0));
    const double distance = this->View.Parallel
      ? glm::dot(this->ParallelDepth, world - this->View.Position)
      : glm::length(world - this->View.Position);
    const double slack = Slack * std::abs(distance) + Slack * radius + this->DistanceError;
    const float near = Below(distance - radius - slack);
    const float far = -Below(-(distance + radius + slack));

    glm::ivec2 first, last;
    if (!this->FindTiles(box, first, last))
    {
      return;
    }
    for (int y = first.y; y <= last.y; ++y)
    {
      for (int x = first.x; x <= last.x; ++x)
      {
        Bounds& tile = bounds[static_cast<std::size_t>(y * this->Tiles.x + x)];
        tile.Near = std::min(tile.Near, near);
        tile.Far = std::max(tile.Far, far);
      }
    }
  }

  /// Find the tiles that a box can touch: all tiles if it reaches behind the eye or if numbers
  /// overflow.
  /// \return false if there are none
  bool FindTiles(const Box& box, glm::ivec2& first, glm::ivec2& last) const
  {
    first = glm::ivec2(0);
    last = this->Tiles - 1;
    const glm::dvec4 centre = this->ClipFromIndex * glm::dvec4(box.Centre, 1.0);
    const std::array<glm::dvec4, 3> half = { box.Half.x * this->ClipFromIndex[0],
      box.Half.y * this->ClipFromIndex[1], box.Half.z * this->ClipFromIndex[2] };
    glm::dvec2 low(std::numeric_limits<double>::infinity());
    glm::dvec2 high(-std::numeric_limits<double>::infinity());
    double nearest = std::numeric_limits<double>::infinity();
    for (int corner = 0; corner < 8; ++corner)
    {
      const glm::dvec4 clip = centre + (corner & 1 ? half[0] : -half[0]) +
        (corner & 2 ? half[1] : -half[1]) + (corner & 4 ? half[2] : -half[2]);
      if (!(clip.w > this->ClipError.w))
      {
        return true;
      }
      const glm::dvec2 point = glm::dvec2(clip) / clip.w;
      low = glm::min(low, point);
      high = glm::max(high, point);
      nearest = std::min(nearest, clip.w);
    }
    const glm::dvec2 farthest = glm::max(glm::abs(low), glm::abs(high));
    const glm::dvec2 error =
      (glm::dvec2(this->ClipError) + farthest * this->ClipError.w) / (nearest - this->ClipError.w);
    const glm::dvec2 scale = 0.5 * glm::dvec2(this->View.Size);
    const glm::dvec2 margin = Margin + scale * error;
    const glm::dvec2 lowPixel = (low + 1.0) * scale - margin;
    const glm::dvec2 highPixel = (high + 1.0) * scale + margin;
    if (!std::isfinite(lowPixel.x + lowPixel.y + highPixel.x + highPixel.y))
    {
      return true;
    }
    if (lowPixel.x >= this->View.Size.x || lowPixel.y >= this->View.Size.y || highPixel.x < 0.0 ||
      highPixel.y < 0.0)
    {
      return false;
    }
    first = glm::ivec2(glm::max(lowPixel, glm::dvec2(0.0))) >> TileBits;
    last = glm::min(
      glm::ivec2(glm::min(highPixel, glm::dvec2(this->View.Size))) >> TileBits, this->Tiles - 1);
    return true;
  }

private:
  /// How far rounding may move a projected point.
  void FindErrors(const glm::dvec4& cells)
  {
    const auto sizes = [](const glm::dmat4& matrix)
    {
      return glm::dmat4(
        glm::abs(matrix[0]), glm::abs(matrix[1]), glm::abs(matrix[2]), glm::abs(matrix[3]));
    };
    const glm::dvec4 world = sizes(this->WorldFromIndex) * cells;
    this->ClipError = Rounding * (sizes(this->View.ClipFromWorld) * world);
    const glm::dvec3 reach = glm::dvec3(world) + glm::abs(this->View.Position);
    this->DistanceError = Rounding * this->PerRadius * (reach.x + reach.y + reach.z) +
      static_cast<double>(std::numeric_limits<float>::min());
  }

  /// Convert to single precision, for a lower bound; rounding is covered by the slack. NaN becomes
  /// the lowest value.
  static float Below(double number)
  {
    constexpr auto Largest = static_cast<double>(std::numeric_limits<float>::max());
    return number >= -Largest ? static_cast<float>(std::min(number, Largest))
                              : -std::numeric_limits<float>::infinity();
  }

  const TemporalCoherence::View& View;
  glm::ivec2 Tiles;
  const FieldShape& Shape;
  bool AreAlike; ///< all leaves have the same size
  glm::dmat4 ClipFromIndex, WorldFromIndex;
  double PerRadius = 1.0; ///< distance along rays for a distance in the world
  double LeafRadius;
  glm::dvec4 ClipError{ 0.0 };
  double DistanceError = 0.0;
  glm::dvec3 ParallelDepth{
    0.0
  }; ///< dot product with a vector from the camera: t of a parallel ray
};

/// Widen bounds by the active leaves of a node.
void WidenByNode(const BoxProjector& projector, const glm::ivec3& firstCell, std::uint64_t leaves,
  std::vector<Bounds>& bounds)
{
  constexpr int size = ValueRangePyramid::LeafSize;
  if (projector.IsSmall(projector.BoxOf(firstCell, glm::ivec3(ValueRangePyramid::NodeSize))))
  {
    const std::array<glm::ivec3, 2> around = LeavesAround(leaves);
    const Box box = projector.BoxOf(firstCell + size * around[0], size * around[1]);
    projector.Widen(box, projector.RadiusOf(box.Half), bounds);
    return;
  }
  for (int leaf = 0; leaf < ValueRangePyramid::LeavesPerNode && leaves >> leaf; ++leaf)
  {
    if (leaves >> leaf & 1u)
    {
      const glm::ivec3 inNode(leaf & 3, leaf >> 2 & 3, leaf >> 4);
      projector.WidenByLeaf(firstCell + size * inNode, bounds);
    }
  }
}

}

std::vector<std::uint8_t> FindTiles(const View& view, const IndexTransform& transform,
  const std::vector<CellBox>& boxes, const FieldShape& shape)
{
  const glm::ivec2 tiles = TilesOf(view.Size);
  glm::ivec3 cells(0);
  for (const CellBox& box : boxes)
  {
    cells = glm::max(cells, box.First + box.Size);
  }
  const BoxProjector projector(view, transform, tiles, cells, shape);
  std::vector<std::uint8_t> touched(static_cast<std::size_t>(NumberOfTiles(view.Size)), 0);
  for (const CellBox& box : boxes)
  {
    glm::ivec2 first, last;
    if (projector.FindTiles(projector.BoxOf(box.First, box.Size), first, last))
    {
      for (int y = first.y; y <= last.y; ++y)
      {
        std::fill_n(touched.begin() + y * tiles.x + first.x, last.x - first.x + 1, std::uint8_t(1));
      }
    }
  }
  return touched;
}

void TileBounds::Build(const View& view, const IndexTransform& transform, const ActiveCells& active,
  const FieldShape& shape)
{
  this->Size = TilesOf(view.Size);
  const std::size_t tiles =
    static_cast<std::size_t>(this->Size.x) * static_cast<std::size_t>(this->Size.y);
  this->All.resize(tiles);
  this->Parts.resize(NumberOfParts);
  for (std::vector<Bounds>& part : this->Parts)
  {
    part.assign(tiles, Bounds());
  }

  const glm::ivec3 nodes = active.NodeDimensions();
  const BoxProjector projector(
    view, transform, this->Size, ValueRangePyramid::NodeSize * nodes, shape);
  const std::int64_t count = static_cast<std::int64_t>(nodes.x) * nodes.y * nodes.z;
  ParallelFor(NumberOfParts, 1,
    [&](std::int64_t part)
    {
      std::vector<Bounds>& bounds = this->Parts[static_cast<std::size_t>(part)];
      for (std::int64_t node = part; node < count; node += NumberOfParts)
      {
        const std::uint64_t leaves = active.LeavesOf(node);
        if (leaves != 0)
        {
          const glm::ivec3 place(
            node % nodes.x, node / nodes.x % nodes.y, node / nodes.x / nodes.y);
          WidenByNode(projector, ValueRangePyramid::NodeSize * place, leaves, bounds);
        }
      }
    });

  ParallelFor(static_cast<std::int64_t>(tiles), 1024,
    [&](std::int64_t tile)
    {
      Bounds bounds;
      for (const std::vector<Bounds>& part : this->Parts)
      {
        bounds.Near = std::min(bounds.Near, part[static_cast<std::size_t>(tile)].Near);
        bounds.Far = std::max(bounds.Far, part[static_cast<std::size_t>(tile)].Far);
      }
      this->All[static_cast<std::size_t>(tile)] = bounds;
    });
}

void TileBounds::Unite(const TileBounds& all, const glm::ivec2& pixels, const glm::ivec2& fewer)
{
  this->Size = TilesOf(fewer);
  const auto number =
    static_cast<std::size_t>(this->Size.x) * static_cast<std::size_t>(this->Size.y);
  this->All.assign(number, Bounds());
  for (std::size_t tile = 0; tile < number; ++tile)
  {
    const glm::i64vec2 at(static_cast<std::int64_t>(tile) % this->Size.x,
      static_cast<std::int64_t>(tile) / this->Size.x);
    // The pixels that the tile covers, at least in part.
    const glm::i64vec2 size(pixels), rays(fewer), length(TileSize);
    const glm::ivec2 first((at * length * size / rays) / length);
    const glm::ivec2 end =
      glm::min(glm::ivec2(((at + std::int64_t(1)) * length * size / rays) / length) + 1, all.Size);
    Bounds& bounds = this->All[tile];
    for (int y = first.y; y < end.y; ++y)
    {
      for (int x = first.x; x < end.x; ++x)
      {
        const Bounds& covered = all.All[static_cast<std::size_t>(y * all.Size.x + x)];
        bounds.Near = std::min(bounds.Near, covered.Near);
        bounds.Far = std::max(bounds.Far, covered.Far);
      }
    }
  }
}

std::size_t TileBounds::MemoryInBytes() const
{
  std::size_t count = this->All.capacity();
  for (const std::vector<Bounds>& part : this->Parts)
  {
    count += part.capacity();
  }
  return count * sizeof(Bounds);
}

std::size_t TileBounds::MemoryFor(const glm::ivec2& pixels)
{
  return static_cast<std::size_t>(NumberOfTiles(pixels)) * sizeof(Bounds);
}

void TileBounds::Narrow(std::int64_t tile, RayBatch& rays) const
{
  const Bounds& bounds = this->At(tile);
  if (bounds.IsEmpty())
  {
    rays.WalkEnd = rays.WalkBegin;
    return;
  }
  for (std::size_t i = 0; i < static_cast<std::size_t>(rays.Count); ++i)
  {
    rays.WalkBegin[i] = std::max(rays.WalkBegin[i], static_cast<double>(bounds.Near));
    rays.WalkEnd[i] = std::min(rays.WalkEnd[i], static_cast<double>(bounds.Far));
  }
}

}
