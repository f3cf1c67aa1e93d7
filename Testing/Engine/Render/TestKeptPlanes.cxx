// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// A frame that is made in the memory of an earlier one keeps none of its contents: every plane, and
// the layers of translucent surfaces, are those of a renderer without a past.

#include "Grid.h"
#include "Render/FrameRenderer.h"
#include "SameFrames.h"
#include "Scene/Disparity.h"

#include <gtest/gtest.h>

#include <map>
#include <memory>
#include <random>
#include <string>
#include <vector>

namespace
{

using namespace TemporalCoherence;

const glm::ivec3 Dimensions(48, 40, 44);
const glm::ivec2 KeptSize(131, 93);

/// The planes of an exact picture are those of a cold one, those of answers left out.
void ExpectSamePlanes(const Frame& made, const Frame& cold, const std::string& what)
{
  EXPECT_TRUE(IsSamePlane(made.Depth, cold.Depth)) << what;
  // A picture that is shown again, or copied, has what the one before had of these.
  const auto isSame = [](const Plane<float>& a, const Plane<float>& b)
  { return a.empty() || b.empty() || IsSamePlane(a, b); };
  EXPECT_TRUE(isSame(made.Disparities, cold.Disparities)) << what;
  EXPECT_TRUE(IsSamePlane(made.Normals, cold.Normals)) << what;
  EXPECT_TRUE(IsSamePlane(made.Isovalues, cold.Isovalues)) << what;
  EXPECT_TRUE(IsSamePlane(made.Kinds, cold.Kinds)) << what;
  EXPECT_TRUE(IsSamePlane(made.Colors, cold.Colors)) << what;
  ASSERT_TRUE(HaveTheSameLayers(made, cold)) << what;
}

/// A clear tile holds misses of the picture's own projection, and nothing else.
void ExpectClearTilesAreClear(const Frame& frame, bool isParallel, const std::string& what)
{
  const auto miss = static_cast<float>(DisparityOfMiss(isParallel));
  for (std::int64_t tile = 0; tile < NumberOfTiles(frame.Size); ++tile)
  {
    const PixelRect part = PixelsOfTile(frame.Size, tile);
    for (int i = 0; i < part.Size.x * part.Size.y; ++i)
    {
      const glm::ivec2 place = part.First + glm::ivec2(i % part.Size.x, i / part.Size.x);
      const auto pixel = static_cast<std::size_t>(place.y * frame.Size.x + place.x);
      ASSERT_TRUE(!frame.ClearTiles[static_cast<std::size_t>(tile)] ||
        (frame.Isovalues[pixel] == Frame::NoSurface && std::isinf(frame.Depth[pixel]) &&
          (frame.Disparities.empty() || frame.Disparities[pixel] == miss) &&
          frame.Answers[pixel] == Answer::DefiniteMiss))
        << what << ", tile " << tile;
    }
  }
}

/// A scene that stands still, with a ball at one of three places.
class KeptPlanes : public ::testing::Test
{
protected:
  KeptPlanes()
  {
    this->Exact.Accuracy = ReuseAccuracy::Exact;
    this->Exact.Reuse.Isomap = false;
    this->Key.Appearance.Shade = true;
    this->Key.Appearance.Lights = { Light() };
    this->SetTranslucent(true);
    this->LookFrom({ 1.0, 2.0, 0.7 }, false);
    this->MoveBall(0);
  }

  void LookFrom(const glm::dvec3& from, bool isParallel)
  {
    this->Key.View = LookAt(Dimensions, from, KeptSize, isParallel);
  }

  void SetTranslucent(bool isTranslucent)
  {
    this->Key.EditIsosurfaces().Isovalues = { 60.0, 120.0 };
    this->Key.Appearance.Colors = { { 1.0, 0.5, 0.2 }, { 0.2, 0.5, 1.0 } };
    this->Key.EditIsosurfaces().Opacities =
      isTranslucent ? std::vector{ 0.4, 0.7 } : std::vector<double>();
  }

  /// Samples in other memory, as a reader gives them for the next time step.
  void MoveBall(int place)
  {
    const std::vector<glm::dvec3> places = { { 9, 30, 34 }, { 38, 10, 8 }, { 38, 31, 35 } };
    const glm::dvec3 centre = places[static_cast<std::size_t>(place)];
    this->Steps.push_back(std::make_unique<Grid<std::uint8_t>>(Dimensions));
    this->Steps.back()->Fill(
      [&](int i, int j, int k)
      {
        const double ball = 200.0 - 40.0 * glm::length(glm::dvec3(i, j, k) - centre);
        const double still = 200.0 - 20.0 * glm::length(glm::dvec3(i, j, k) - glm::dvec3(12.0));
        return std::max(0.0, std::max(ball, still));
      });
    this->Key.Samples = this->Steps.back()->Field;
    this->Key.Samples.Stamp = ++this->Stamp;
    this->Key.Samples.Between = this->Between;
  }

  /// Make the next frame, which is exact, and compare it with a cold one.
  void Render(const std::string& what)
  {
    this->Renderer.Render(this->Key, this->Exact);
    ++this->Routes[this->Renderer.Statistics().Made];
    FrameRenderer cold;
    cold.Render(this->Key, this->Exact);
    ASSERT_EQ(cold.Statistics().Made, Route::Cold);
    const std::string step = what + ", by " + NameOf(this->Renderer.Statistics().Made);
    const Frame& made = this->Renderer.LastFrame();
    ExpectSamePlanes(made, cold.LastFrame(), step);
    ExpectClearTilesAreClear(made, this->Key.View.Parallel, step);
  }

  std::vector<std::unique_ptr<Grid<std::uint8_t>>> Steps;
  std::uint64_t Stamp = 0;
  Interpolation Between = Interpolation::Linear;
  FrameKey Key;
  FrameRenderer Renderer;
  FrameRenderer::Options Exact;
  std::map<Route, int> Routes;
};

/// A miss is another number in each projection, in tiles that nobody else writes.
TEST_F(KeptPlanes, ClearTilesFollowTheProjection)
{
  int number = 0;
  for (const int isParallel : { 0, 0, 1, 1, 0, 1, 0, 0, 1, 1, 1, 0 })
  {
    this->LookFrom({ 1.0, 2.0 - 0.1 * number, 0.7 }, isParallel != 0);
    this->Render("frame " + std::to_string(number++));
  }
}

/// Layers of a copied tile are those of the picture it is copied from, not those that were there.
TEST_F(KeptPlanes, LayersAreCopiedWithTheirTiles)
{
  int number = 0;
  for (const int place : { 0, 1, 2, 0, 2, 1, 0, 1, 1, 2 })
  {
    this->MoveBall(place);
    this->Render("step " + std::to_string(number++));
    this->Key.Appearance.Ambient = 0.1 + 0.01 * number;
    this->Render("shaded again");
  }
  EXPECT_GE(this->Routes[Route::TimeStep], 7) << "tiles are copied";
  EXPECT_GE(this->Routes[Route::Reshade], 10);
}

/// What only other views need is there when such views may come, and whole.
TEST_F(KeptPlanes, PlanesForOtherViewsComeAndGoWithTheAccuracy)
{
  this->SetTranslucent(false);
  // Every frame is cold, or a time step.
  this->Exact.Images.Policy = ImageCachePolicy::KeyImage;
  this->Exact.Images.KeyImageInterval = 1;
  std::mt19937 engine(9);
  int disparities = 0;
  for (int step = 0; step < 60; ++step)
  {
    if (engine() % 2)
    {
      this->LookFrom({ 1.0, 2.0 - 0.02 * step, 0.7 }, engine() % 3 == 0);
    }
    else
    {
      this->MoveBall(static_cast<int>(engine() % 3));
    }
    this->Exact.Accuracy = engine() % 2 ? ReuseAccuracy::Paper : ReuseAccuracy::Exact;
    this->Render("step " + std::to_string(step));
    const Frame& made = this->Renderer.LastFrame();
    disparities += !made.Disparities.empty();
    EXPECT_TRUE(this->Exact.Accuracy != ReuseAccuracy::Exact ||
      this->Renderer.Statistics().Made == Route::Redisplay || made.Disparities.empty());
  }
  EXPECT_GE(this->Routes[Route::TimeStep], 5);
  EXPECT_GE(disparities, 8);
}

/// All of it in any order, opaque pictures in between.
TEST_F(KeptPlanes, NothingOfAnEarlierFrameStays)
{
  std::mt19937 engine(8);
  std::uniform_real_distribution<double> entry(-1.0, 1.0);
  for (int step = 0; step < 120; ++step)
  {
    const auto change = static_cast<int>(engine() % 6);
    switch (change)
    {
      case 0:
        this->LookFrom({ entry(engine), 2.0, entry(engine) }, !this->Key.View.Parallel);
        break;
      case 1:
        this->LookFrom({ entry(engine), 2.0, entry(engine) }, this->Key.View.Parallel);
        break;
      case 2:
        this->SetTranslucent(this->Key.Isosurfaces().Opacities.empty());
        break;
      case 3:
        this->Key.Appearance.Ambient = 0.2 + 0.1 * entry(engine);
        break;
      default:
        this->MoveBall(static_cast<int>(engine() % 3));
        break;
    }
    this->Render("step " + std::to_string(step) + ", change " + std::to_string(change));
  }
  EXPECT_GE(this->Routes[Route::TimeStep], 20);
  EXPECT_GE(this->Routes[Route::Reshade], 5);
}

}
