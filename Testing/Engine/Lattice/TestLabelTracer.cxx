// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Rays meet the labels that a walk from voxel to voxel meets: where the nearest sample becomes a
// label that is drawn. With and without leaping, beside hidden cells, and for labels of any type.

#include "Checks/Infinity.h"
#include "Grid.h"
#include "Kinds/LabelKind.h"
#include "Lattice/RaySource.h"
#include "Scene/HiddenCells.h"
#include "Scene/LabelSets.h"
#include "Shade/FieldNormals.h"
#include "Tracing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <set>
#include <vector>

namespace
{

using namespace TemporalCoherence;

/// What a ray meets.
struct Met
{
  double Distance;
  HitKind Kind;
  double Label;
  glm::dvec3 Into; ///< direction into the label; of entries
};

/// Labels that a ray meets, from front to back, by a walk from voxel to voxel.
/// \param isClear becomes false if rounding decides
template <typename T>
std::vector<Met> MeetByForce(Grid<T>& grid, const std::set<double>& drawn, const RayBatch& rays,
  std::size_t ray, bool& isClear)
{
  const glm::dvec3 origin(rays.Origin[0][ray], rays.Origin[1][ray], rays.Origin[2][ray]);
  const glm::dvec3 direction(
    rays.Direction[0][ray], rays.Direction[1][ray], rays.Direction[2][ray]);
  struct Plane
  {
    double Distance;
    int Axis;
  };
  std::vector<Plane> planes = { { rays.Begin[ray], -1 } };
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int sample = 0; direction[axis] != 0.0 && sample < grid.Field.Dimensions[axis]; ++sample)
    {
      for (const double side : { 0.0, 0.5 })
      {
        const double t = (sample + side - origin[axis]) / direction[axis];
        if (t > rays.Begin[ray] && t < rays.End[ray])
        {
          planes.push_back({ t, axis });
        }
      }
    }
  }
  std::sort(planes.begin(), planes.end(),
    [](const Plane& a, const Plane& b) { return a.Distance < b.Distance; });
  // Through an edge between voxels, rounding decides which of them a ray touches.
  for (std::size_t i = 2; i < planes.size(); ++i)
  {
    if (planes[i].Distance - planes[i - 1].Distance < 1e-9 && planes[i].Axis != planes[i - 1].Axis)
    {
      isClear = false;
    }
  }
  isClear &= rays.End[ray] - planes.back().Distance > 1e-9;
  std::vector<Met> met;
  double before = -Infinity;
  bool wasHidden = false, isFirst = true;
  for (std::size_t i = 0; i < planes.size(); ++i)
  {
    const double end = i + 1 < planes.size() ? planes[i + 1].Distance : rays.End[ray];
    if (end - planes[i].Distance < 1e-12)
    {
      continue;
    }
    const glm::dvec3 middle = origin + 0.5 * (planes[i].Distance + end) * direction;
    const glm::ivec3 cell(glm::floor(middle));
    if (grid.Field.Hidden && grid.Field.Hidden->IsHidden(cell))
    {
      wasHidden = true;
      isFirst = false;
      continue;
    }
    const glm::ivec3 sample(glm::floor(middle + 0.5));
    const auto label = static_cast<double>(grid.At(sample.x, sample.y, sample.z));
    const bool isCap = isFirst || wasHidden;
    if ((label != before || wasHidden) && drawn.count(label))
    {
      glm::dvec3 into(0.0);
      if (!isCap)
      {
        into[planes[i].Axis] = direction[planes[i].Axis] > 0.0 ? 1.0 : -1.0;
      }
      met.push_back({ planes[i].Distance, isCap ? HitKind::Cap : HitKind::Entry, label, into });
    }
    before = label;
    wasHidden = isFirst = false;
  }
  return met;
}

/// Compare all that rays meet with brute force.
/// \return how many surfaces there were
template <typename T>
int ExpectTruth(Grid<T>& grid, const std::vector<double>& labels, const glm::dvec3& direction,
  bool parallel, bool leaps)
{
  grid.Field.Shape = LabelKind();
  grid.Field.Labels = LabelSets::Make(grid.Field);
  Tracing<T> tracing(grid, labels, SurfaceMode::Threshold);
  tracing.Scene.Active = leaps ? tracing.Scene.Active : nullptr;
  const auto tracer = MakeSurfaceTracer(tracing.Scene);
  const View view = LookAt(grid.Field.Dimensions, direction, { 64, 64 }, parallel);
  const std::set<double> drawn(labels.begin(), labels.end());
  int count = 0;
  for (int tile = 0; tile < 64; ++tile)
  {
    RayBatch rays;
    const glm::ivec2 place(tile % 8, tile / 8);
    RaySource(view, IndexTransform(), grid.Field.Dimensions).SetUp(8 * place, glm::ivec2(8), rays);
    HitBatch hits;
    tracer->Trace(rays, hits);
    std::vector<std::vector<Met>> truth;
    std::size_t most = 0;
    std::array<bool, 64> isClear;
    isClear.fill(true);
    for (std::size_t ray = 0; ray < 64; ++ray)
    {
      truth.push_back(rays.Begin[ray] < rays.End[ray]
          ? MeetByForce(grid, drawn, rays, ray, isClear[ray])
          : std::vector<Met>());
      most = std::max(most, truth[ray].size());
    }
    for (std::size_t layer = 0; layer <= most; ++layer)
    {
      HitRays at;
      at.Count = 64;
      at.Eye = view.Origin;
      at.AreApart = true;
      GradientTile::Vectors gradients;
      RayBatch::Array<SurfaceIndex> surfaces;
      for (std::size_t ray = 0; ray < 64; ++ray)
      {
        for (std::size_t a = 0; a < 3; ++a)
        {
          at.Begin[a][ray] = rays.Origin[a][ray];
          at.Own[a][ray] = rays.Direction[a][ray];
        }
        surfaces[ray] = std::max<SurfaceIndex>(hits.Surface[ray], 0);
        at.T[ray] = std::isfinite(hits.Depth[ray]) ? hits.Depth[ray] : 0.0;
      }
      KindOf(grid.Field)
        .FindGradients({ grid.Field, glm::dmat4(1.0), tracing.Scene.FiniteRange, &labels },
          { at, surfaces, gradients });
      for (std::size_t ray = 0; ray < 64; ++ray)
      {
        if (layer > truth[ray].size() || !isClear[ray])
        {
          continue; // the search has begun again
        }
        if (layer == truth[ray].size())
        {
          EXPECT_EQ(hits.Surface[ray], Frame::NoSurface) << "tile " << tile << " ray " << ray;
          continue;
        }
        const Met& met = truth[ray][layer];
        ++count;
        EXPECT_NE(hits.Surface[ray], Frame::NoSurface) << "tile " << tile << " ray " << ray;
        if (hits.Surface[ray] == Frame::NoSurface)
        {
          return count;
        }
        EXPECT_EQ(labels[static_cast<std::size_t>(hits.Surface[ray])], met.Label);
        EXPECT_EQ(hits.Kind[ray], met.Kind);
        EXPECT_NEAR(hits.Depth[ray], met.Distance, 1e-9);
        if (met.Kind == HitKind::Entry)
        {
          const glm::dvec3 into(gradients[0][ray], gradients[1][ray], gradients[2][ray]);
          EXPECT_EQ(into, met.Into);
        }
      }
      tracer->FindNext(rays, hits);
    }
  }
  return count;
}

/// Labels of balls that overlap, in a background of 0.
template <typename T>
void FillWithBalls(Grid<T>& grid, const std::vector<double>& labels)
{
  std::mt19937 engine(7);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  std::vector<glm::dvec4> balls;
  for (std::size_t i = 0; i < labels.size(); ++i)
  {
    balls.emplace_back(share(engine) * (grid.Field.Dimensions.x - 1),
      share(engine) * (grid.Field.Dimensions.y - 1), share(engine) * (grid.Field.Dimensions.z - 1),
      2.0 + 6.0 * share(engine));
  }
  grid.Fill(
    [&](int i, int j, int k)
    {
      double label = 0.0;
      for (std::size_t ball = 0; ball < balls.size(); ++ball)
      {
        const bool isIn =
          glm::distance(glm::dvec3(i, j, k), glm::dvec3(balls[ball])) < balls[ball].w;
        label = isIn ? labels[ball] : label;
      }
      return label;
    });
}

const std::vector<glm::dvec3> Directions = { { 1.0, 0.0, 0.0 }, { 0.0, 0.0, -1.0 },
  { -1.0, -1.0, 0.0 }, { 0.3, -0.7, 0.9 } };

template <typename T>
class LabelTracerTest : public ::testing::Test
{
};
using LabelTypes = ::testing::Types<std::int8_t, std::uint8_t, std::int16_t, std::uint16_t,
  std::int32_t, std::uint32_t, std::int64_t, std::uint64_t>;
TYPED_TEST_SUITE(LabelTracerTest, LabelTypes);

TYPED_TEST(LabelTracerTest, MeetsWhatAWalkFromVoxelToVoxelMeets)
{
  using T = TypeParam;
  std::vector<double> labels;
  for (int i = 1; i <= 40; ++i)
  {
    // Labels of wide types lie far apart.
    labels.push_back(sizeof(T) == 1 ? i : sizeof(T) == 2 ? 750.0 * i : 5e7 * i + (i % 2));
  }
  Grid<T> grid(glm::ivec3(37, 30, 26));
  FillWithBalls(grid, labels);
  const std::vector<double> some = { labels[3], labels[1], labels[38], labels[20], labels[21] };
  int count = 0;
  for (const glm::dvec3& direction : Directions)
  {
    for (const bool parallel : { false, true })
    {
      count += ExpectTruth(grid, labels, direction, parallel, true);
      count += ExpectTruth(grid, some, direction, parallel, true);
    }
  }
  count += ExpectTruth(grid, labels, Directions[3], false, false);
  EXPECT_GT(count, 10000);
}

TEST(LabelTracer, NoiseIsMetVoxelByVoxel)
{
  Grid<std::uint8_t> grid(glm::ivec3(9, 14, 11));
  grid.FillRandomly(0.0, 5.99, 3);
  for (const glm::dvec3& direction : Directions)
  {
    EXPECT_GT(ExpectTruth(grid, { 5.0, 1.0, 3.0 }, direction, false, true), 1000);
    EXPECT_GT(ExpectTruth(grid, { 0.0 }, direction, true, true), 500);
  }
}

TEST(LabelTracer, LabelsBehindHiddenCellsAreCapped)
{
  Grid<std::uint16_t> grid(glm::ivec3(30, 30, 30));
  FillWithBalls(grid, { 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20 });
  std::vector<std::uint8_t> hidden(29 * 29 * 29);
  std::mt19937 engine(5);
  for (std::uint8_t& cell : hidden)
  {
    cell = engine() % 40 == 0;
  }
  HidingFlags flags;
  flags.OfCells = hidden.data();
  flags.CellMask = 1;
  grid.Field.Hidden = HiddenCells::Make(grid.Field.Dimensions, flags);
  for (const glm::dvec3& direction : Directions)
  {
    EXPECT_GT(ExpectTruth(grid, { 3, 5, 7, 9, 11, 13, 15 }, direction, false, true), 500);
  }
}

TEST(LabelTracer, OneLabelFillsTheBox)
{
  Grid<std::uint8_t> grid(glm::ivec3(6, 5, 7));
  grid.Fill([](int, int, int) { return 3; });
  EXPECT_GT(ExpectTruth(grid, { 3.0 }, Directions[3], false, true), 500);
  EXPECT_EQ(ExpectTruth(grid, { 2.0 }, Directions[3], false, true), 0);
}

TEST(LabelIndex, FindsPositions)
{
  for (const double step : { 1.0, 7.0, 1e6, 4e9 })
  {
    std::vector<double> labels;
    for (int i = 30; i > -20; --i)
    {
      labels.push_back(step * i);
    }
    const LabelIndex index(labels);
    for (std::size_t i = 0; i < labels.size(); ++i)
    {
      const auto label = static_cast<std::int64_t>(labels[i]);
      EXPECT_EQ(index.Of(label), static_cast<SurfaceIndex>(i));
      EXPECT_EQ(index.Of(label + 1),
        step > 1.0 || i == 0 ? Frame::NoSurface : static_cast<SurfaceIndex>(i - 1));
    }
    EXPECT_EQ(index.Of(std::numeric_limits<std::int64_t>::max()), Frame::NoSurface);
    EXPECT_EQ(index.Of(std::numeric_limits<std::int64_t>::lowest()), Frame::NoSurface);
  }
  EXPECT_EQ(LabelIndex({}).Of(0), Frame::NoSurface);
}

}
