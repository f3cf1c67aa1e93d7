// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// The bounds of a tile hold all of its hits and all active leaves that it shows, under any
// transform and camera.

#include "Acceleration/TileBounds.h"
#include "Grid.h"
#include "Kinds/FieldKind.h"
#include "Lattice/RaySource.h"
#include "Lattice/SurfaceTracer.h"

#include <glm/gtc/matrix_inverse.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

namespace
{

using namespace TemporalCoherence;

/// Sheared, mirrored and stretched, as a user's matrix may be.
IndexTransform RandomTransform(std::mt19937& engine)
{
  std::uniform_real_distribution<double> entry(-0.4, 0.4);
  glm::dmat4 matrix(1.0);
  for (int column = 0; column < 3; ++column)
  {
    for (int row = 0; row < 3; ++row)
    {
      matrix[column][row] += entry(engine);
    }
    matrix[3][column] = 10.0 * entry(engine);
  }
  matrix[0] *= engine() % 2 ? 1.0 : -1.5;
  return { matrix, glm::inverse(matrix) };
}

/// From outside, or from within the volume.
View RandomView(
  const glm::dvec3& centre, double radius, const glm::ivec2& size, std::mt19937& engine)
{
  std::uniform_real_distribution<double> entry(-1.0, 1.0);
  const glm::dvec3 from =
    glm::normalize(glm::dvec3(entry(engine), entry(engine), 0.5 + entry(engine)));
  const double distance = engine() % 3 == 0 ? 0.3 * radius : 3.0 * radius;
  const bool isParallel = engine() % 2 == 0;
  const glm::dvec2 range(0.05 * radius, 6.0 * radius);
  glm::dmat4 projection = isParallel
    ? glm::ortho(-radius, radius, -radius, radius, range.x, range.y)
    : glm::perspective(0.7, static_cast<double>(size.x) / size.y, range.x, range.y);
  if (isParallel && engine() % 2)
  {
    projection[2][0] = 0.4 * projection[0][0]; // rays at an angle to the optical axis
  }
  View view;
  EXPECT_TRUE(MakeView(glm::lookAt(centre + distance * from, centre, glm::dvec3(0.1, 1.0, 0.2)),
    projection, range, size, view));
  return view;
}

/// A field with the structures of which bounds are made.
struct Scene
{
  template <typename Formula>
  Scene(double isovalue, const Formula& formula)
    : Samples(glm::ivec3(50, 41, 37))
    , Isosurfaces{ { isovalue }, SurfaceMode::Crossing }
  {
    this->Samples.Fill(formula);
    this->Pyramid.Build(this->Samples.Field);
    this->Active.Build(this->Samples.Field, this->Pyramid, this->Isosurfaces);
  }

  glm::dvec3 CentreAt(const IndexTransform& transform) const
  {
    const glm::dvec3 last(this->Samples.Field.Dimensions - 1);
    return glm::dvec3(transform.WorldFromIndex * glm::dvec4(0.5 * last, 1.0));
  }

  Grid<std::uint8_t> Samples;
  Surfaces Isosurfaces;
  ValueRangePyramid Pyramid;
  ActiveCells Active;
};

/// Every hit lies within the bounds of its tile, whether its node is projected as one box (small
/// pictures) or leaf by leaf (large ones).
TEST(TileBounds, HoldAllHits)
{
  const Scene scene(150.0,
    [](int i, int j, int k)
    { return 100.0 + 80.0 * std::sin(0.3 * i + 0.2 * j) * std::cos(0.4 * k); });
  const glm::ivec3& dimensions = scene.Samples.Field.Dimensions;
  const auto tracer = MakeSurfaceTracer(
    { scene.Samples.Field, scene.Isosurfaces, scene.Pyramid.FiniteRange(), nullptr });
  std::mt19937 engine(21);
  int hitCount = 0, emptyCount = 0;
  for (int round = 0; round < 60; ++round)
  {
    const glm::ivec2 size = round % 2 ? glm::ivec2(45, 37) : glm::ivec2(300, 170);
    const IndexTransform transform = RandomTransform(engine);
    const View view = RandomView(scene.CentreAt(transform), 40.0, size, engine);
    TileBounds bounds;
    bounds.Build(view, transform, scene.Active, *UniformShape());
    const RaySource source(view, transform, dimensions);
    for (std::int64_t tile = 0; tile < NumberOfTiles(size); tile += round % 2 ? 1 : 7)
    {
      const PixelRect part = PixelsOfTile(size, tile);
      RayBatch rays;
      HitBatch hits;
      source.SetUp(part.First, part.Size, rays);
      tracer->Trace(rays, hits);
      const TileBounds::Bounds& range = bounds.At(tile);
      emptyCount += range.IsEmpty();
      for (std::size_t i = 0; i < static_cast<std::size_t>(rays.Count); ++i)
      {
        if (hits.Kind[i] != HitKind::None)
        {
          ASSERT_GE(hits.Depth[i], static_cast<double>(range.Near)) << round << ' ' << tile;
          ASSERT_LE(hits.Depth[i], static_cast<double>(range.Far)) << round << ' ' << tile;
          ++hitCount;
        }
      }
    }
  }
  EXPECT_GT(hitCount, 10000);
  EXPECT_GT(emptyCount, 1000);
}

/// Rays that meet the plane of the picture at any angle up to 60 degrees, or come from an eye.
View ShearedView(
  const glm::dvec3& centre, double radius, const glm::ivec2& size, std::mt19937& engine)
{
  std::uniform_real_distribution<double> entry(-1.0, 1.0);
  const bool isParallel = engine() % 4 != 0;
  glm::dmat4 projection = glm::perspective(0.7, 1.0, 0.1 * radius, 6.0 * radius);
  if (isParallel)
  {
    projection = glm::ortho(-radius, radius, -radius, radius, 0.1 * radius, 6.0 * radius);
    projection[2][0] = 1.2 * entry(engine) * projection[0][0];
    projection[2][1] = 1.2 * entry(engine) * projection[1][1];
    // What is at the centre stays there.
    projection[3][0] = 3.0 * radius * projection[2][0];
    projection[3][1] = 3.0 * radius * projection[2][1];
  }
  const glm::dvec3 from =
    glm::normalize(glm::dvec3(entry(engine), entry(engine), 1.0 + entry(engine)));
  // A transform of the user's: parallel rays may come from an eye by it.
  glm::dmat4 transform(1.0);
  if (engine() % 2)
  {
    for (int column = 0; column < 3; ++column)
    {
      for (int row = 0; row < 3; ++row)
      {
        transform[column][row] += 0.3 * entry(engine);
      }
    }
    transform[2][3] = engine() % 2 ? 0.1 * entry(engine) / radius : 0.0;
  }
  View view;
  EXPECT_TRUE(MakeView(
    transform * glm::lookAt(centre + 3.0 * radius * from, centre, glm::dvec3(0.1, 1.0, 0.2)),
    projection, { 0.1 * radius, 6.0 * radius }, size, view));
  return view;
}

/// The first cells of the active leaves.
std::vector<glm::ivec3> LeavesOf(const ActiveCells& active)
{
  std::vector<glm::ivec3> leaves;
  const glm::ivec3 nodes = active.NodeDimensions();
  for (int node = 0; node < nodes.x * nodes.y * nodes.z; ++node)
  {
    const glm::ivec3 place(node % nodes.x, node / nodes.x % nodes.y, node / nodes.x / nodes.y);
    for (int leaf = 0; leaf < ValueRangePyramid::LeavesPerNode; ++leaf)
    {
      if (active.LeavesOf(node) >> leaf & 1u)
      {
        leaves.push_back(ValueRangePyramid::NodeSize * place +
          ValueRangePyramid::LeafSize * glm::ivec3(leaf & 3, leaf >> 2 & 3, leaf >> 4));
      }
    }
  }
  return leaves;
}

/// The corners of active leaves are within the bounds of the tiles that show them, at the distance
/// along the ray that shows them.
TEST(TileBounds, HoldTheCornersOfActiveLeaves)
{
  std::mt19937 engine(23);
  const Scene scene(100.0, [&](int, int, int) { return engine() % 2000 == 0 ? 255 : 0; });
  const std::vector<glm::ivec3> leaves = LeavesOf(scene.Active);
  ASSERT_GT(leaves.size(), 30u);
  int seen = 0;
  for (int round = 0; round < 80; ++round)
  {
    const glm::ivec2 size = round % 2 ? glm::ivec2(45, 37) : glm::ivec2(500, 410);
    const IndexTransform transform = RandomTransform(engine);
    const View view = ShearedView(scene.CentreAt(transform), 40.0, size, engine);
    TileBounds bounds;
    bounds.Build(view, transform, scene.Active, *UniformShape());
    for (const glm::ivec3& leaf : leaves)
    {
      for (int corner = 0; corner < 8; ++corner)
      {
        const glm::ivec3 offset(corner & 1, corner >> 1 & 1, corner >> 2);
        const glm::dvec3 point(
          transform.WorldFromIndex * glm::dvec4(glm::dvec3(leaf + 4 * offset), 1.0));
        const glm::dvec4 clip = view.ClipFromWorld * glm::dvec4(point, 1.0);
        const glm::dvec2 place = glm::dvec2(clip) / clip.w;
        if (clip.w <= 0.0 || std::abs(place.x) >= 1.0 || std::abs(place.y) >= 1.0)
        {
          continue;
        }
        const glm::dvec3 origin = view.Origin + place.x * view.OriginX + place.y * view.OriginY;
        const glm::dvec3 direction =
          glm::normalize(view.Direction + place.x * view.DirectionX + place.y * view.DirectionY);
        const double t = glm::dot(point - origin, direction);
        ASSERT_NEAR(glm::length(origin + t * direction - point), 0.0, 1e-9);
        if (!view.Parallel && t < 0.0)
        {
          continue; // behind the eye
        }
        const glm::ivec2 tile = glm::ivec2(0.5 * (place + 1.0) * glm::dvec2(size)) / TileSize;
        const TileBounds::Bounds& range = bounds.At(tile.y * bounds.Tiles().x + tile.x);
        ASSERT_LE(static_cast<double>(range.Near), t) << round;
        ASSERT_GE(static_cast<double>(range.Far), t) << round;
        ++seen;
      }
    }
  }
  EXPECT_GT(seen, 10000);
}

/// True if a ray passes a box of cells that is not smaller than a point.
bool Passes(const glm::dvec3& origin, const glm::dvec3& direction, const CellBox& box)
{
  double begin = 0.0, end = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis)
  {
    const double low = (box.First[axis] - origin[axis]) / direction[axis];
    const double high = (box.First[axis] + box.Size[axis] - origin[axis]) / direction[axis];
    begin = std::max(begin, std::min(low, high));
    end = std::min(end, std::max(low, high));
  }
  return begin <= end;
}

/// Whatever rays pass a box go through tiles that are found.
TEST(TileBounds, FindTilesOfBoxes)
{
  std::mt19937 engine(22);
  const glm::ivec3 cells(50, 41, 37);
  int passed = 0, left = 0;
  for (int round = 0; round < 200; ++round)
  {
    const glm::ivec2 size(93, 70);
    const IndexTransform transform = RandomTransform(engine);
    const glm::dvec3 centre(transform.WorldFromIndex * glm::dvec4(0.5 * glm::dvec3(cells), 1.0));
    const View view = RandomView(centre, 40.0, size, engine);
    std::vector<CellBox> boxes(1 + round % 3);
    for (CellBox& box : boxes)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        box.First[axis] = static_cast<int>(engine() % static_cast<unsigned>(cells[axis] - 1));
        box.Size[axis] = 1 + static_cast<int>(engine() % 8);
      }
    }
    const std::vector<std::uint8_t> found = FindTiles(view, transform, boxes, *UniformShape());
    ASSERT_EQ(static_cast<std::int64_t>(found.size()), NumberOfTiles(size));
    for (int y = 0; y < size.y; ++y)
    {
      for (int x = 0; x < size.x; ++x)
      {
        const Ray ray = view.RayThrough(x, y);
        const glm::dvec3 origin(transform.IndexFromWorld * glm::dvec4(ray.Origin, 1.0));
        const glm::dvec3 direction(transform.IndexFromWorld * glm::dvec4(ray.Direction, 0.0));
        const bool isFound = found[static_cast<std::size_t>(y / 8 * 12 + x / 8)] != 0;
        const bool passes = std::any_of(boxes.begin(), boxes.end(),
          [&](const CellBox& box) { return Passes(origin, direction, box); });
        ASSERT_TRUE(isFound || !passes) << round << ": " << x << ", " << y;
        passed += passes;
        left += !isFound;
      }
    }
  }
  EXPECT_GT(passed, 10000);
  EXPECT_GT(left, 200000);
}

}
