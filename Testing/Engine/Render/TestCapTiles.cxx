// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// With THRESHOLD, tiles without a surface are left out only where no ray can begin in a solid:
// whatever field, region and camera are, the picture is the one without space leaping. Most tiles
// are left out.
#include "Grid.h"
#include "Kinds/FunctionKind.h"
#include "Kinds/RectilinearKind.h"
#include "Lattice/Coordinates.h"
#include "Lattice/Waves.h"
#include "Render/CapTiles.h"
#include "Render/FrameRenderer.h"
#include "SameFrames.h"

#include <glm/gtc/matrix_inverse.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <random>

namespace
{

using namespace TemporalCoherence;

const glm::ivec3 Dimensions(50, 41, 37);

/// Solids that the box of the field, and random planes, cut open.
class SolidFrames : public ::testing::Test
{
protected:
  SolidFrames()
  {
    this->Key.EditIsosurfaces() = { { 0.4 }, SurfaceMode::Threshold };
    this->Key.Appearance.Colors = { { 1.0, 0.5, 0.2 }, { 0.2, 0.5, 1.0 } };
    this->Key.Appearance.Shade = true;
    this->Key.Appearance.Lights = { Light() };
  }

  double Between(double low, double high)
  {
    return std::uniform_real_distribution<double>(low, high)(this->Engine);
  }

  glm::dvec3 Direction()
  {
    return glm::normalize(
      glm::dvec3(this->Between(-1.0, 1.0), this->Between(-1.0, 1.0), this->Between(-1.0, 1.0)));
  }

  glm::dvec3 Centre() const
  {
    const glm::dvec3 last(Dimensions - 1);
    return glm::dvec3(this->Key.Transform.WorldFromIndex * glm::dvec4(0.5 * last, 1.0));
  }

  /// A sheared and mirrored field, seen from outside or from within, through a near plane that may
  /// cut it.
  void SetRandomView()
  {
    glm::dmat4 matrix(1.0);
    for (int column = 0; column < 3; ++column)
    {
      for (int row = 0; row < 3; ++row)
      {
        matrix[column][row] += this->Between(-0.3, 0.3);
      }
    }
    matrix[0] *= this->Between(-1.0, 1.0) < 0.0 ? 1.0 : -1.5;
    this->Key.Transform = { matrix, glm::inverse(matrix) };
    const double radius = 0.5 * glm::length(glm::dvec3(Dimensions));
    const bool isParallel = this->Engine() % 2 == 0;
    const double distance = radius * (this->Engine() % 3 == 0 ? 0.5 : 3.0);
    const double near = this->Engine() % 3 == 0 ? distance * this->Between(0.5, 1.2) : 0.01;
    const glm::dvec2 range(isParallel && this->Engine() % 4 == 0 ? -radius : near, 6.0 * radius);
    const double half = this->Between(0.3, 2.0) * radius;
    const glm::dmat4 projection = isParallel
      ? glm::ortho(-half, half, -half, half, range.x, range.y)
      : glm::perspective(this->Between(0.3, 1.5), 1.2, range.x, range.y);
    const glm::dvec3 centre = this->Centre() + this->Between(0.0, 10.0) * this->Direction();
    ASSERT_TRUE(
      MakeView(glm::lookAt(centre + distance * this->Direction(), centre, this->Direction()),
        projection, range, { 61, 45 }, this->Key.View));
  }

  void SetRandomRegion()
  {
    this->Key.Region = Region();
    for (unsigned int left = this->Engine() % 3; left > 0; --left)
    {
      const glm::dvec3 normal = this->Direction();
      const glm::dvec3 point = this->Centre() + this->Between(-15.0, 15.0) * this->Direction();
      this->Key.Region.Clips.emplace_back(normal, -glm::dot(normal, point));
    }
    if (this->Engine() % 3 == 0)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        const double last = Dimensions[axis] - 1;
        this->Key.Region.Crops[static_cast<std::size_t>(axis)] = { this->Between(0.0, 0.5 * last),
          this->Between(0.5 * last, last) };
      }
      this->Key.Region.Boxes = this->Engine() & Region::AllBoxes;
    }
  }

  Frame Render(bool leaps) const
  {
    FrameRenderer renderer;
    FrameRenderer::Options options;
    options.SpaceLeaping = leaps;
    renderer.Render(this->Key, options);
    return renderer.LastFrame();
  }

  /// Compare pictures of random views and regions with those without space leaping.
  void Compare(int rounds)
  {
    for (int round = 0; round < rounds; ++round)
    {
      ASSERT_NO_FATAL_FAILURE(this->SetRandomView());
      this->SetRandomRegion();
      const Frame leaped = this->Render(true);
      ASSERT_TRUE(ShowTheSame(leaped, this->Render(false))) << round;
      this->Caps += std::count(leaped.Kinds.begin(), leaped.Kinds.end(), HitKind::Cap);
      this->LeftOut += std::count(leaped.ClearTiles.begin(), leaped.ClearTiles.end(), 1);
    }
    EXPECT_GT(this->Caps, 100 * rounds);
    EXPECT_GT(this->LeftOut, rounds);
  }

  FrameKey Key;
  std::mt19937 Engine{ 31 };
  std::int64_t Caps = 0, LeftOut = 0;
};

TEST_F(SolidFrames, AreThoseWithoutLeaping)
{
  Grid<float> waves(Dimensions);
  waves.Fill(Wave);
  this->Key.Samples = waves.Field;
  this->Compare(60);
  this->Key.EditIsosurfaces().Isovalues = { 0.9, -0.2 };
  this->Compare(20);
  this->Key.Samples.Between = Interpolation::Nearest;
  this->Compare(20);
}

TEST_F(SolidFrames, AreThoseWithoutLeapingOnRectilinearGrids)
{
  Grid<float> waves(Dimensions);
  waves.Fill(Wave);
  this->Key.Samples = waves.Field;
  for (const double ratio : { 3.0, 300.0 })
  {
    this->Key.Samples.Shape = RectilinearKind(Stretched(Dimensions, ratio, 3));
    this->Compare(20);
  }
}

TEST_F(SolidFrames, AreThoseWithoutLeapingOfAnySamples)
{
  Grid<double> holes(Dimensions);
  holes.Fill(WaveWithHoles);
  this->Key.Samples = holes.Field;
  this->Key.EditIsosurfaces().Isovalues = { 0.4e30 };
  this->Compare(15);
  Grid<std::uint8_t> cells(Dimensions);
  cells.Fill([](int i, int j, int k) { return 100.0 + 70.0 * Wave(i, j, k); });
  const glm::ivec3 count = Dimensions - 1;
  std::vector<std::uint8_t> flags(static_cast<std::size_t>(count.x * count.y * count.z));
  for (std::size_t i = 0; i < flags.size(); ++i)
  {
    flags[i] = i / static_cast<std::size_t>(count.x * count.y) / 5 % 3 == 1;
  }
  cells.Field.Flagged = HiddenCells::Make(Dimensions, { flags.data(), 1 });
  this->Key.Samples = cells.Field;
  this->Key.EditIsosurfaces().Isovalues = { 128.0 };
  this->Compare(15);
}

TEST_F(SolidFrames, AreThoseWithoutLeapingOfAFunction)
{
  this->Key.Samples.Type = ScalarType::Float64;
  this->Key.Samples.Dimensions = Dimensions;
  this->Key.Samples.Shape = std::make_shared<FunctionKind>(SmoothFunction{ [](const glm::dvec3& p)
    { return std::sin(0.2 * p.x) * std::cos(0.25 * p.y + 0.1 * p.z); },
    [](const glm::dvec3&) { return glm::dvec3(0.0, 0.0, 1.0); }, 0.5 });
  this->Compare(12);
}

/// Tiles that may show caps of a ball in the middle of the field.
class CapTiles : public SolidFrames
{
protected:
  CapTiles()
    : Ball(Dimensions)
  {
    this->Ball.Fill([](int i, int j, int k)
      { return 12.0 - glm::distance(glm::dvec3(i, j, k), 0.5 * glm::dvec3(Dimensions - 1)); });
    this->Key.Samples = this->Ball.Field;
    this->Key.EditIsosurfaces().Isovalues = { 0.0 };
    this->Ranges.Build(this->Key.Samples);
    this->Key.View = LookAt(Dimensions, { 1.0, 2.0, 0.7 }, { 160, 160 });
  }

  std::int64_t Count() const
  {
    const RaySource rays(this->Key.View, this->Key.Transform, Dimensions, this->Key.Region);
    const std::vector<std::uint8_t> tiles = FindCapTiles(this->Key, rays, this->Ranges);
    EXPECT_EQ(static_cast<std::int64_t>(tiles.size()), NumberOfTiles(this->Key.View.Size));
    return std::count(tiles.begin(), tiles.end(), 1);
  }

  Grid<float> Ball;
  ValueRangePyramid Ranges;
};

TEST_F(CapTiles, AreNoneWhereNothingIsCut)
{
  EXPECT_EQ(this->Count(), 0);
  // Planes that cut the field, but not the ball.
  this->Key.Region.Clips = { { 1.0, 0.0, 0.0, -5.0 } };
  EXPECT_EQ(this->Count(), 0);
  this->Key.Region.Crops = { glm::dvec2(4.0, 46.0), glm::dvec2(3.0, 38.0), glm::dvec2(1.0, 35.0) };
  this->Key.Region.Boxes = 1u << 13;
  EXPECT_EQ(this->Count(), 0);
}

TEST_F(CapTiles, AreThoseOfTheCut)
{
  this->Key.Region.Clips = { { 0.0, 1.0, 0.0, -20.0 } };
  const std::int64_t clipped = this->Count();
  EXPECT_GT(clipped, 10);
  EXPECT_LT(clipped, 150); // of 400
  this->Key.Region.Clips.clear();
  this->Key.View.Near = 3.0 * 0.5 * glm::length(glm::dvec3(Dimensions - 1)); // half of the ball
  EXPECT_GT(this->Count(), 10);
  EXPECT_LT(this->Count(), 300);
}

TEST_F(CapTiles, AreAllFromWithinASolid)
{
  const glm::dvec3 eye = 0.5 * glm::dvec3(Dimensions - 1);
  ASSERT_TRUE(MakeView(glm::lookAt(eye, eye + glm::dvec3(1.0, 0.3, 0.2), glm::dvec3(0, 0, 1)),
    glm::perspective(1.0, 1.0, 0.01, 100.0), { 0.01, 100.0 }, { 160, 160 }, this->Key.View));
  EXPECT_EQ(this->Count(), 400);
}

}
