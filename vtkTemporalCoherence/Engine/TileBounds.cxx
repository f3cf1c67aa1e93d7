// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TileBounds.h"

#include "Parallel.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace TemporalCoherence
{
namespace
{

using Bounds = TileBounds::Bounds;

/// Parts of the nodes projected at the same time, each into tiles of its own.
constexpr int NumberOfParts = 8;

/// Pixels by which projections are widened against rounding.
constexpr double Margin = 1.0 / 64;

/// Share of a distance by which bounds are widened, since they are stored in single precision.
constexpr double Slack = 1e-6;

/// Projects leaves of one size into tiles.
class LeafProjector
{
public:
  LeafProjector(const View& view, const Placement& placement, const glm::ivec2& tiles)
    : Seen(view)
    , Tiles(tiles)
    , ClipFromIndex(view.ClipFromWorld * placement.WorldFromIndex)
    , WorldFromIndex(placement.WorldFromIndex)
  {
    const double half = 0.5 * ValueRangePyramid::LeafSize;
    for (int axis = 0; axis < 3; ++axis)
    {
      this->HalfEdges[static_cast<std::size_t>(axis)] = half * this->ClipFromIndex[axis];
    }
    for (int corner = 0; corner < 4; ++corner)
    {
      const glm::dvec3 diagonal(half, corner & 1 ? half : -half, corner & 2 ? half : -half);
      this->Radius =
        std::max(this->Radius, glm::length(glm::dmat3(this->WorldFromIndex) * diagonal));
    }
    if (view.Parallel)
    {
      // Rays begin on the plane through the camera, which they may meet at an angle.
      const double cosine = glm::dot(view.Forward, glm::normalize(view.Direction));
      this->ParallelDepth = view.Forward / cosine;
      this->Radius /= cosine;
    }
  }

  void Widen(const glm::ivec3& firstCell, std::vector<Bounds>& bounds) const
  {
    const glm::dvec3 centre = glm::dvec3(firstCell) + 0.5 * ValueRangePyramid::LeafSize;
    const glm::dvec3 world(this->WorldFromIndex * glm::dvec4(centre, 1.0));
    const double distance = this->Seen.Parallel
      ? glm::dot(this->ParallelDepth, world - this->Seen.Position)
      : glm::length(world - this->Seen.Position);
    const double slack = Slack * std::abs(distance) + Slack * this->Radius;
    const float near = static_cast<float>(distance - this->Radius - slack);
    const float far = static_cast<float>(distance + this->Radius + slack);

    glm::ivec2 first, last;
    if (!this->FindTiles(this->ClipFromIndex * glm::dvec4(centre, 1.0), first, last))
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

private:
  /// Tiles that the leaf around a clip-space point can touch; false if there are none.
  bool FindTiles(const glm::dvec4& centre, glm::ivec2& first, glm::ivec2& last) const
  {
    glm::dvec2 low(std::numeric_limits<double>::infinity());
    glm::dvec2 high(-std::numeric_limits<double>::infinity());
    for (int corner = 0; corner < 8; ++corner)
    {
      const glm::dvec4 clip = centre + (corner & 1 ? this->HalfEdges[0] : -this->HalfEdges[0]) +
        (corner & 2 ? this->HalfEdges[1] : -this->HalfEdges[1]) +
        (corner & 4 ? this->HalfEdges[2] : -this->HalfEdges[2]);
      if (!(clip.w > 0.0))
      {
        // A leaf that reaches behind the eye can be seen anywhere.
        first = glm::ivec2(0);
        last = this->Tiles - 1;
        return true;
      }
      const glm::dvec2 point = glm::dvec2(clip) / clip.w;
      low = glm::min(low, point);
      high = glm::max(high, point);
    }
    const glm::dvec2 scale = 0.5 * glm::dvec2(this->Seen.Size);
    const glm::dvec2 lowPixel = (low + 1.0) * scale - Margin;
    const glm::dvec2 highPixel = (high + 1.0) * scale + Margin;
    if (lowPixel.x >= this->Seen.Size.x || lowPixel.y >= this->Seen.Size.y || highPixel.x < 0.0 ||
      highPixel.y < 0.0)
    {
      return false;
    }
    first = glm::ivec2(glm::max(lowPixel, glm::dvec2(0.0))) >> TileBits;
    last = glm::min(
      glm::ivec2(glm::min(highPixel, glm::dvec2(this->Seen.Size))) >> TileBits, this->Tiles - 1);
    return true;
  }

  const View& Seen;
  glm::ivec2 Tiles;
  glm::dmat4 ClipFromIndex, WorldFromIndex;
  std::array<glm::dvec4, 3> HalfEdges;
  double Radius = 0.0; ///< of the sphere around a leaf, as a distance along rays
  glm::dvec3 ParallelDepth{
    0.0
  }; ///< dot product with a vector from the camera: t of a parallel ray
};

}

void TileBounds::Build(const View& view, const Placement& placement, const ActiveCells& active)
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

  const LeafProjector projector(view, placement, this->Size);
  const glm::ivec3 nodes = active.NodeDimensions();
  const std::int64_t count = static_cast<std::int64_t>(nodes.x) * nodes.y * nodes.z;
  ParallelFor(NumberOfParts, 1,
    [&](std::int64_t part)
    {
      for (std::int64_t node = part; node < count; node += NumberOfParts)
      {
        const glm::ivec3 firstCell = ValueRangePyramid::NodeSize *
          glm::ivec3(node % nodes.x, node / nodes.x % nodes.y, node / nodes.x / nodes.y);
        const std::uint64_t leaves = active.LeavesOf(node);
        for (int leaf = 0; leaf < ValueRangePyramid::LeavesPerNode && leaves >> leaf; ++leaf)
        {
          if (leaves >> leaf & 1u)
          {
            const glm::ivec3 inNode(leaf & 3, leaf >> 2 & 3, leaf >> 4);
            projector.Widen(firstCell + ValueRangePyramid::LeafSize * inNode,
              this->Parts[static_cast<std::size_t>(part)]);
          }
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
