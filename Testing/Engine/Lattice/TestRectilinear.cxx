// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Surfaces and gradients of rectilinear fields lie where the coordinates put them. Whole numbers as
// coordinates make the uniform field, bit by bit. Where a walk begins and ends does not change a
// hit.

#include "Acceleration/TileBounds.h"
#include "Checks/Sanitized.h"
#include "Grid.h"
#include "Kinds/FieldKind.h"
#include "Lattice/Coordinates.h"
#include "Lattice/SurfaceTracer.h"
#include "Render/FrameRenderer.h"
#include "SameFrames.h"
#include "Shade/RaysFromPoints.h"
#include "Shade/SurfaceNormal.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace
{

using namespace TemporalCoherence;

struct Structures
{
  explicit Structures(const Field& field, const Surfaces& surfaces)
  {
    this->Pyramid.Build(field);
    this->Active.Build(field, this->Pyramid, surfaces);
    this->Scene = { field, surfaces, this->Pyramid.FiniteRange(), &this->Active };
  }

  ValueRangePyramid Pyramid;
  ActiveCells Active;
  TraceScene Scene;
};

HitBatch Trace(const TraceScene& scene, const RayBatch& rays)
{
  HitBatch hits;
  MakeSurfaceTracer(scene)->Trace(rays, hits);
  return hits;
}

/// Call visit(rays) for the tiles of views from some directions, along axes among them.
template <typename Visit>
void ForEachTile(const glm::ivec3& dimensions, const Visit& visit)
{
  for (const glm::dvec3 direction : { glm::dvec3(1.0, 0.0, 0.0), glm::dvec3(0.0, 0.0, -1.0),
         glm::dvec3(-1.0, -1.0, 0.0), glm::dvec3(0.3, -0.7, 0.9), glm::dvec3(-0.5, 0.4, -0.2) })
  {
    for (const bool parallel : { false, true })
    {
      const View view = LookAt(dimensions, direction, { 64, 64 }, parallel);
      for (int tile = 0; tile < 64; tile += 3)
      {
        RayBatch rays;
        RaySource(view, IndexTransform(), dimensions)
          .SetUp(8 * glm::ivec2(tile % 8, tile / 8), glm::ivec2(8), rays);
        visit(rays);
      }
    }
  }
}

void ExpectSameHit(const HitBatch& a, const HitBatch& b, std::size_t i)
{
  EXPECT_EQ(a.Depth[i], b.Depth[i]);
  EXPECT_EQ(a.Surface[i], b.Surface[i]);
  EXPECT_EQ(a.Kind[i], b.Kind[i]);
}

/// All modes and interpolations, one isovalue and several.
template <typename Check>
void ForEachWay(Field field, const Check& check)
{
  for (const Interpolation between : { Interpolation::Linear, Interpolation::Nearest })
  {
    for (const SurfaceMode mode : { SurfaceMode::Crossing, SurfaceMode::Threshold })
    {
      field.Between = between;
      check(field, Surfaces{ { 2.0 }, mode });
      check(field, Surfaces{ { 2.7, 1.3 }, mode });
    }
  }
}

TEST(Rectilinear, WholeNumbersAsCoordinatesAreTheUniformField)
{
  Grid<double> grid(glm::ivec3(27, 34, 19));
  grid.Fill([](int i, int j, int k) { return (i * 7 + j * 3 + k * 5 + i * j * k) % 5; });
  ForEachWay(grid.Field,
    [](const Field& field, const Surfaces& surfaces)
    {
      Field rectilinear = field;
      rectilinear.Shape = RectilinearKind(Uniform(field.Dimensions));
      const Structures structures(field, surfaces);
      TraceScene asRectilinear = structures.Scene;
      asRectilinear.Samples = rectilinear;
      std::int64_t found = 0;
      ForEachTile(field.Dimensions,
        [&](const RayBatch& rays)
        {
          const HitBatch hits = Trace(structures.Scene, rays);
          const HitBatch others = Trace(asRectilinear, rays);
          for (std::size_t i = 0; i < 64; ++i)
          {
            ExpectSameHit(hits, others, i);
            found += hits.Surface[i] != Frame::NoSurface;
          }
        });
      EXPECT_GT(found, 3000);
    });
}

TEST(Rectilinear, ResultDoesNotDependOnTheWalk)
{
  for (const double ratio : { 1.5, 20.0, 1e6 })
  {
    Grid<std::uint8_t> grid(glm::ivec3(37, 29, 41));
    grid.FillRandomly(0.0, 4.0, 9); // few values: many samples equal the isovalue
    grid.Field.Shape = RectilinearKind(Stretched(grid.Field.Dimensions, ratio, 5));
    std::mt19937 engine(11);
    std::uniform_real_distribution<double> share(0.0, 1.0);
    ForEachWay(grid.Field,
      [&](const Field& field, const Surfaces& surfaces)
      {
        const Structures structures(field, surfaces);
        TraceScene plain = structures.Scene;
        plain.Active = nullptr;
        ForEachTile(field.Dimensions,
          [&](RayBatch& rays)
          {
            const HitBatch hits = Trace(structures.Scene, rays);
            const HitBatch plainHits = Trace(plain, rays);
            // Any walk that contains the hit must find it.
            for (std::size_t i = 0; i < 64; ++i)
            {
              if (hits.Surface[i] != Frame::NoSurface)
              {
                rays.WalkBegin[i] += share(engine) * (hits.Depth[i] - rays.WalkBegin[i]);
                rays.WalkEnd[i] = hits.Depth[i] + share(engine) * (rays.WalkEnd[i] - hits.Depth[i]);
              }
            }
            const HitBatch shortHits = Trace(structures.Scene, rays);
            for (std::size_t i = 0; i < 64; ++i)
            {
              ExpectSameHit(hits, plainHits, i);
              if (rays.WalkBegin[i] < rays.WalkEnd[i])
              {
                ExpectSameHit(hits, shortHits, i);
              }
            }
          });
      });
  }
}

TEST(Rectilinear, PlaneIsHitWhereItIs)
{
  const glm::dvec3 normal(0.5, -0.25, 1.0);
  const double isovalue = 8.125;
  Grid<double> grid(glm::ivec3(40, 30, 20));
  const auto coordinates = Stretched(grid.Field.Dimensions, 50.0, 3);
  grid.Field.Shape = RectilinearKind(coordinates);
  FillByPlace(grid, *coordinates, [&](const glm::dvec3& at) { return glm::dot(at, normal); });
  const Structures structures(grid.Field, { { isovalue }, SurfaceMode::Crossing });
  int found = 0;
  ForEachTile(grid.Field.Dimensions,
    [&](const RayBatch& rays)
    {
      const HitBatch hits = Trace(structures.Scene, rays);
      for (std::size_t i = 0; i < 64; ++i)
      {
        const glm::dvec3 o(rays.Origin[0][i], rays.Origin[1][i], rays.Origin[2][i]);
        const glm::dvec3 d(rays.Direction[0][i], rays.Direction[1][i], rays.Direction[2][i]);
        const double t = (isovalue - glm::dot(o, normal)) / glm::dot(d, normal);
        const bool isHit = t > rays.Begin[i] + 1e-9 && t < rays.End[i] - 1e-9;
        const bool isMiss = !(t >= rays.Begin[i] - 1e-9 && t <= rays.End[i] + 1e-9);
        EXPECT_TRUE(isHit ? hits.Surface[i] == 0 : !isMiss || hits.Surface[i] == Frame::NoSurface);
        EXPECT_NEAR(isHit ? hits.Depth[i] - t : 0.0, 0.0, 1e-9);
        found += isHit;
      }
    });
  EXPECT_GT(found, 2000);
}

TEST(Rectilinear, NearestFacesLieHalfWay)
{
  Grid<std::uint8_t> grid(glm::ivec3(4, 3, 3));
  auto coordinates = std::make_shared<GridCoordinates>(*Uniform(grid.Field.Dimensions));
  coordinates->Along[0] = { 0.0, 0.2, 2.0, 3.0 };
  grid.Field.Shape = RectilinearKind(coordinates);
  grid.Field.Between = Interpolation::Nearest;
  grid.Fill([](int i, int, int) { return i >= 2 ? 10 : 0; });
  const Structures structures(grid.Field, { { 5.0 }, SurfaceMode::Crossing });
  const View view = LookAt(grid.Field.Dimensions, { -1.0, 0.0, 0.0 }, { 8, 8 }, true);
  RayBatch rays;
  RaySource(view, IndexTransform(), grid.Field.Dimensions).SetUp({ 0, 0 }, glm::ivec2(8), rays);
  const HitBatch hits = Trace(structures.Scene, rays);
  int found = 0;
  for (std::size_t i = 0; i < 64; ++i)
  {
    if (rays.Begin[i] < rays.End[i])
    {
      EXPECT_NEAR(rays.Origin[0][i] + hits.Depth[i] * rays.Direction[0][i], 1.1, 1e-12);
      ++found;
    }
  }
  EXPECT_GT(found, 10);
}

TEST(Rectilinear, GradientsAreThoseOfTheWorld)
{
  const glm::dvec3 slope(0.5, -0.25, 1.0);
  Grid<float> grid(glm::ivec3(12, 10, 9));
  const auto coordinates = Stretched(grid.Field.Dimensions, 50.0, 3);
  grid.Field.Shape = RectilinearKind(coordinates);
  FillByPlace(
    grid, *coordinates, [&](const glm::dvec3& at) { return 100.0 + glm::dot(at, slope); });
  std::mt19937 engine(4);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  const std::vector<double> isovalues{ 104.0 };
  for (const Interpolation between : { Interpolation::Linear, Interpolation::Nearest })
  {
    grid.Field.Between = between;
    RaysFromPoints rays;
    HitRays::Vectors gradients;
    RayBatch::Array<SurfaceIndex> surfaces{};
    for (std::size_t i = 0; i < 64; ++i)
    {
      for (std::size_t a = 0; a < 3; ++a)
      {
        // Some on the boundary of the field, where differences are one-sided.
        const double last = grid.Field.Dimensions[static_cast<int>(a)] - 1;
        rays.Begin[a][i] = i % 7 == a ? 0.0 : i % 5 == a ? last : share(engine) * last;
        rays.Own[a][i] = share(engine) - 0.5;
      }
    }
    KindOf(grid.Field)
      .FindGradients({ grid.Field, glm::dmat4(1.0), { 90.0, 130.0 }, &isovalues },
        { rays, surfaces, gradients });
    for (std::size_t i = 0; i < 64; ++i)
    {
      for (std::size_t a = 0; a < 3; ++a)
      {
        EXPECT_NEAR(gradients[a][i], slope[static_cast<int>(a)], 1e-3);
      }
    }
  }
}

/// Differences of the largest numbers, and over short edges, have no number: gradients end before.
TEST(Rectilinear, GradientsOfTheLargestSamplesAreNumbers)
{
  constexpr double largest = std::numeric_limits<double>::max();
  Grid<double> grid(glm::ivec3(6, 7, 5));
  std::mt19937 engine(9);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  for (double& sample : grid.Samples)
  {
    sample = share(engine) < 0.5 ? -largest : largest;
  }
  const std::vector<double> isovalues{ 1.0 };
  for (const double ratio : { 50.0, 1e8 })
  {
    grid.Field.Shape = RectilinearKind(Stretched(grid.Field.Dimensions, ratio, 3));
    RaysFromPoints rays;
    HitRays::Vectors gradients;
    RayBatch::Array<SurfaceIndex> surfaces{};
    for (std::size_t i = 0; i < 64; ++i)
    {
      for (std::size_t a = 0; a < 3; ++a)
      {
        rays.Begin[a][i] = share(engine) * (grid.Field.Dimensions[static_cast<int>(a)] - 1);
        rays.Own[a][i] = share(engine) - 0.5;
      }
    }
    KindOf(grid.Field)
      .FindGradients({ grid.Field, glm::dmat4(1.0), { -largest, largest }, &isovalues },
        { rays, surfaces, gradients });
    for (std::size_t i = 0; i < 64; ++i)
    {
      for (std::size_t a = 0; a < 3; ++a)
      {
        EXPECT_TRUE(std::isfinite(gradients[a][i])) << ratio << ", hit " << i;
      }
    }
  }
}

TEST(Rectilinear, UniformGradientsAreThoseOfImages)
{
  Grid<std::int16_t> grid(glm::ivec3(12, 10, 9));
  grid.FillRandomly(-1000.0, 1000.0, 6);
  std::mt19937 engine(4);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  const std::vector<double> isovalues{ 3.0 };
  for (const Interpolation between : { Interpolation::Linear, Interpolation::Nearest })
  {
    grid.Field.Between = between;
    Field rectilinear = grid.Field;
    rectilinear.Shape = RectilinearKind(Uniform(rectilinear.Dimensions));
    RaysFromPoints rays;
    HitRays::Vectors gradients, others;
    RayBatch::Array<SurfaceIndex> surfaces{};
    for (std::size_t i = 0; i < 64; ++i)
    {
      for (std::size_t a = 0; a < 3; ++a)
      {
        rays.Begin[a][i] = share(engine) * (grid.Field.Dimensions[static_cast<int>(a)] - 1);
        rays.Own[a][i] = share(engine) - 0.5;
      }
    }
    const glm::dvec2 range(-1000.0, 1000.0);
    KindOf(grid.Field)
      .FindGradients(
        { grid.Field, glm::dmat4(1.0), range, &isovalues }, { rays, surfaces, gradients });
    KindOf(rectilinear)
      .FindGradients(
        { rectilinear, glm::dmat4(1.0), range, &isovalues }, { rays, surfaces, others });
    for (std::size_t i = 0; i < 64; ++i)
    {
      for (std::size_t a = 0; a < 3; ++a)
      {
        EXPECT_NEAR(gradients[a][i], others[a][i], 1e-3);
      }
    }
  }
}

class RectilinearFrames : public ::testing::Test
{
protected:
  RectilinearFrames()
    : Samples(glm::ivec3(60, 50, 40))
  {
    const auto coordinates = Stretched(this->Samples.Field.Dimensions, 30.0, 8);
    this->Samples.Field.Shape = RectilinearKind(coordinates);
    FillByPlace(this->Samples, *coordinates,
      [](const glm::dvec3& at) {
        return 120.0 + 100.0 * std::sin(0.2 * at.x) * std::cos(0.25 * at.y) * std::sin(0.3 * at.z);
      });
    this->Key.Samples = this->Samples.Field;
    this->Key.View = LookAt(this->Samples.Field.Dimensions, { 1.0, 2.0, 0.7 }, { 203, 117 });
    this->Key.EditIsosurfaces().Isovalues = { 150.0, 90.0 };
    this->Key.Appearance.Colors = { { 1.0, 0.5, 0.2 }, { 0.2, 0.5, 1.0 } };
    this->Key.Appearance.Shade = true;
    this->Key.Appearance.Lights = { Light() };
  }

  Frame Cold(bool leaps) const
  {
    FrameRenderer renderer;
    FrameRenderer::Options options;
    options.SpaceLeaping = leaps;
    renderer.Render(this->Key, options);
    EXPECT_EQ(renderer.Statistics().Made, Route::Cold);
    return renderer.LastFrame();
  }

  static void ExpectSamePicture(const Frame& a, const Frame& b) { EXPECT_TRUE(ShowTheSame(a, b)); }

  void ExpectLeapingChangesNothing() const
  {
    const Frame a = this->Cold(true);
    ExpectSamePicture(a, this->Cold(false));
    const auto isHit = [](SurfaceIndex surface) { return surface != Frame::NoSurface; };
    EXPECT_GT(std::count_if(a.Isovalues.begin(), a.Isovalues.end(), isHit), 500);
  }

  /// The cold picture.
  void ExpectLookedUp(const Frame& made) const
  {
    const Frame cold = this->Cold(true);
    EXPECT_EQ(made.Depth, cold.Depth);
    EXPECT_EQ(made.Isovalues, cold.Isovalues);
    EXPECT_EQ(made.Normals, cold.Normals);
    EXPECT_EQ(made.Colors, cold.Colors);
    EXPECT_EQ(made.Kinds, cold.Kinds);
  }

  Grid<std::uint8_t> Samples;
  FrameKey Key;
};

TEST_F(RectilinearFrames, SpaceLeapingDoesNotChangeThePicture)
{
  // Small pictures too: in them whole nodes are projected as one box.
  for (const glm::ivec2 size : { glm::ivec2(203, 117), glm::ivec2(64, 48) })
  {
    for (const SurfaceMode mode : { SurfaceMode::Crossing, SurfaceMode::Threshold })
    {
      this->Key.EditIsosurfaces().Mode = mode;
      for (const bool parallel : { false, true })
      {
        this->Key.View = LookAt(this->Samples.Field.Dimensions, { 1.0, 2.0, 0.7 }, size, parallel);
        this->ExpectLeapingChangesNothing();
      }
      const glm::dvec3 eye(20.3, 21.0, 17.9);
      ASSERT_TRUE(MakeView(glm::lookAt(eye, eye + glm::dvec3(1.0, 0.4, 0.2), glm::dvec3(0, 0, 1)),
        glm::perspective(1.2, 1.5, 0.01, 200.0), { 0.01, 200.0 }, size, this->Key.View));
      this->ExpectLeapingChangesNothing();
    }
  }
}

TEST_F(RectilinearFrames, SweepOfIsovaluesIsLookedUp)
{
  this->Key.Appearance.Colors = { glm::dvec3(1.0) };
  for (const Interpolation between : { Interpolation::Linear, Interpolation::Nearest })
  {
    for (const SurfaceMode mode : { SurfaceMode::Crossing, SurfaceMode::Threshold })
    {
      this->Key.Samples.Between = between;
      this->Key.EditIsosurfaces().Mode = mode;
      this->Key.EditIsosurfaces().Isovalues = { 90.0 };
      FrameRenderer renderer;
      FrameRenderer::Options options;
      options.Map.Range = { 85.0, 175.0 };
      renderer.Render(this->Key, options);
      constexpr int steps = IsMemorySanitized ? 10 : 40;
      for (int step = 1; step <= steps; ++step)
      {
        this->Key.EditIsosurfaces().Isovalues = { 90.0 + 84.0 * step / steps };
        renderer.Render(this->Key, options);
        EXPECT_EQ(renderer.Statistics().Made, step == 1 ? Route::IsomapBuild : Route::IsomapLookup);
        EXPECT_LT(renderer.Statistics().TracedRays, renderer.Statistics().Rays / 20);
        this->ExpectLookedUp(renderer.LastFrame());
      }
    }
  }
}

TEST_F(RectilinearFrames, TimeStepsCopyTilesThatSeeNoChange)
{
  FrameRenderer renderer;
  const auto step = [&](int first)
  {
    for (int i = first; i < first + 6; ++i)
    {
      this->Samples.At(i, 20, 20) = static_cast<std::uint8_t>(40 * (i - first));
    }
    ++this->Key.Samples.Stamp;
    renderer.Render(this->Key, {});
  };
  renderer.Render(this->Key, {});
  step(10); // data that never changes has no fingerprints
  EXPECT_EQ(renderer.Statistics().Made, Route::Cold);
  step(30);
  EXPECT_EQ(renderer.Statistics().Made, Route::TimeStep);
  EXPECT_LT(renderer.Statistics().TracedRays, renderer.Statistics().Rays / 4);
  ExpectSamePicture(renderer.LastFrame(), this->Cold(true));
  this->Key.Samples.Shape = RectilinearKind(Stretched(this->Key.Samples.Dimensions, 30.0, 9));
  step(31);
  EXPECT_EQ(renderer.Statistics().Made, Route::Cold) << "samples lie elsewhere";
}

}
