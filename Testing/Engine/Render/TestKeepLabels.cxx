// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// When other labels are drawn, rays keep what they met unless that changes, and the picture is the
// cold one.

#include "Grid.h"
#include "Kinds/LabelKind.h"
#include "Render/FrameRenderer.h"
#include "SameFrames.h"
#include "Scene/HiddenCells.h"
#include "Scene/LabelSets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <string>
#include <vector>

namespace
{

using namespace TemporalCoherence;

class KeepLabels : public ::testing::Test
{
protected:
  static constexpr int Most = 20;
  const glm::ivec3 Dimensions{ 40, 37, 43 };

  KeepLabels()
    : Samples(Dimensions)
  {
    // Balls that cut into one another, and 0 around them.
    std::mt19937 engine(1);
    std::uniform_real_distribution<float> share(0.0f, 1.0f);
    this->Samples.Fill([](int, int, int) { return 0.0; });
    for (int label = 1; label <= Most; ++label)
    {
      const glm::vec3 middle =
        glm::vec3(share(engine), share(engine), share(engine)) * glm::vec3(Dimensions);
      const float radius = 3.0f + 6.0f * share(engine);
      for (int k = 0; k < Dimensions.z; ++k)
      {
        for (int j = 0; j < Dimensions.y; ++j)
        {
          for (int i = 0; i < Dimensions.x; ++i)
          {
            if (glm::distance(glm::vec3(i, j, k), middle) < radius)
            {
              this->Samples.At(i, j, k) = static_cast<std::uint16_t>(label);
            }
          }
        }
      }
    }
    this->Key.Samples = this->Samples.Field;
    this->Key.Samples.Labels = LabelSets::Make(this->Samples.Field);
    this->Key.Samples.Shape = LabelKind();
    this->Key.View = LookAt(Dimensions, { 1.0, 2.0, 0.7 }, { 101, 67 });
    this->Key.Appearance.Shade = true;
    this->Key.Appearance.Lights = { Light() };
    this->Key.EditIsosurfaces().Mode = SurfaceMode::Threshold;
  }

  void Draw(const std::vector<double>& labels)
  {
    this->Key.EditIsosurfaces().Isovalues = labels;
    this->Key.Appearance.Colors.clear();
    for (const double label : labels)
    {
      this->Key.Appearance.Colors.push_back(
        glm::abs(glm::sin(glm::dvec3(1.0, 2.0, 3.0) * (label + 0.1 * this->Step))));
    }
  }

  /// Make the next frame, which is the cold one.
  void Render(const std::string& what)
  {
    this->Renderer.Render(this->Key, this->Options);
    const FrameStatistics& made = this->Renderer.Statistics();
    ++this->Routes[made.Made];
    FrameRenderer cold;
    cold.Render(this->Key, this->Options);
    ASSERT_TRUE(ShowTheSame(this->Renderer.LastFrame(), cold.LastFrame()))
      << what << ", by " << NameOf(made.Made);
    ASSERT_EQ(made.Rays, made.DefiniteHits + made.DefiniteMisses + made.PossibleHits) << what;
    ASSERT_LE(made.TracedRays, cold.Statistics().TracedRays) << what;
    this->WasLess += made.TracedRays < cold.Statistics().TracedRays ? 1 : 0;
  }

  /// Walk through sets of labels: some go, some come, in any order of the list.
  void Walk(unsigned int seed, int steps = 16)
  {
    std::mt19937 engine(seed);
    std::vector<double> drawn;
    for (this->Step = 0; this->Step < steps; ++this->Step)
    {
      std::vector<double> next;
      const auto change = engine() % 5;
      // 0 fills the box around all, and the last one is not in the data.
      for (int label = 0; label <= Most + 1; ++label)
      {
        const bool was = std::count(drawn.begin(), drawn.end(), label) > 0;
        const bool isChosen = engine() % (change == 0 ? 2u : 5u) == 0;
        const bool isDrawn = change == 1 ? was && !isChosen // some go
          : change == 2                  ? was || isChosen  // some come
          : change == 3                  ? true             // all
                                         : was != isChosen;
        if (isDrawn)
        {
          next.push_back(label);
        }
      }
      if (next.empty())
      {
        next.push_back(1.0);
      }
      std::shuffle(next.begin(), next.end(), engine);
      drawn = next;
      this->Draw(next);
      this->Render("seed " + std::to_string(seed) + ", step " + std::to_string(this->Step));
      if (this->HasFatalFailure())
      {
        return;
      }
    }
  }

  Grid<std::uint16_t> Samples;
  FrameKey Key;
  FrameRenderer Renderer;
  FrameRenderer::Options Options;
  std::map<Route, int> Routes;
  int Step = 0;
  int WasLess = 0; ///< frames that traced fewer rays than the cold one
};

TEST_F(KeepLabels, WalksThroughSets)
{
  this->Walk(1, 30);
  EXPECT_GE(this->Routes[Route::KeepLabels], 25);
  EXPECT_GE(this->WasLess, 20);
}

TEST_F(KeepLabels, WalksThroughSetsOfSmoothLabels)
{
  const auto smooth = std::make_shared<const SmoothLabels>(this->Key.Samples, 2.0);
  this->Key.Samples.Shape = LabelKind(smooth);
  this->Walk(2);
  this->Key.View = LookAt(Dimensions, { -1.0, 0.4, 0.3 }, { 60, 59 }, true);
  this->Walk(3);
  EXPECT_GE(this->Routes[Route::KeepLabels], 25);
}

TEST_F(KeepLabels, WalksAmongHiddenCells)
{
  std::mt19937 engine(3);
  const glm::ivec3 cells = Dimensions - 1;
  std::vector<std::uint8_t> flags(static_cast<std::size_t>(cells.x * cells.y * cells.z));
  for (std::size_t cell = 0; cell < flags.size(); ++cell)
  {
    flags[cell] = engine() % 300 == 0 || cell % static_cast<std::size_t>(cells.x) == 20;
  }
  this->Key.Samples.Flagged = HiddenCells::Make(Dimensions, { flags.data(), 1, nullptr, 0 });
  this->Walk(4);
  this->Options.SpaceLeaping = false;
  this->Walk(5);
  EXPECT_GE(this->Routes[Route::KeepLabels], 25);
}

TEST_F(KeepLabels, WalksInRegionsAndFromWithin)
{
  this->Key.Region.Crops = { glm::dvec2(8.0, 19.0), glm::dvec2(9.0, 18.0), glm::dvec2(7.0, 17.0) };
  this->Key.Region.Boxes = Region::AllBoxes & ~(1u << 13);
  this->Key.Region.Clips = { { 1.0, 0.3, -0.2, -4.0 } };
  this->Walk(6);
  const glm::dvec3 eye(14.3, 13.0, 12.9);
  ASSERT_TRUE(MakeView(glm::lookAt(eye, eye + glm::dvec3(1.0, 0.4, 0.2), glm::dvec3(0, 0, 1)),
    glm::perspective(1.2, 1.5, 0.01, 200.0), { 0.01, 200.0 }, { 75, 50 }, this->Key.View));
  this->Walk(7);
  EXPECT_GE(this->Routes[Route::KeepLabels], 25);
}

TEST_F(KeepLabels, OnlyRaysOfALabelThatGoesAreTraced)
{
  std::vector<double> labels;
  for (int label = 1; label <= Most; ++label)
  {
    labels.push_back(label);
  }
  this->Draw(labels);
  this->Render("all");
  const Plane<SurfaceIndex>& shown = this->Renderer.LastFrame().Isovalues;
  std::int64_t ofLast = 0;
  while (ofLast <= 50 && labels.size() > 2)
  {
    // The next one that is seen becomes the last one.
    labels.pop_back();
    this->Draw(labels);
    this->Render("fewer");
    ofLast = std::count(shown.begin(), shown.end(), static_cast<SurfaceIndex>(labels.size()) - 1);
  }
  ASSERT_GT(ofLast, 50);
  labels.pop_back();
  this->Draw(labels);
  this->Render("without the last");
  EXPECT_EQ(this->Renderer.Statistics().Made, Route::KeepLabels);
  EXPECT_LE(this->Renderer.Statistics().TracedRays, ofLast);
  this->Render("again");
  EXPECT_EQ(this->Renderer.Statistics().Made, Route::Redisplay);
  this->Key.EditIsosurfaces().Opacities.assign(labels.size(), 0.5);
  this->Render("translucent");
  labels.pop_back();
  this->Draw(labels);
  this->Key.EditIsosurfaces().Opacities.assign(labels.size(), 0.5);
  this->Render("one translucent label fewer");
  EXPECT_EQ(this->Renderer.Statistics().Made, Route::Cold);
}

}
