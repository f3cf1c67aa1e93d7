// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_OpacityChanges_h
#define Testing_OpacityChanges_h

#include "Grid.h"
#include "Lattice/Waves.h"
#include "Render/FrameRenderer.h"
#include "SameFrames.h"
#include "Scene/HiddenCells.h"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <string>
#include <vector>

/// A scene with many layers on most rays, in which opacities change.
class OpacityChanges : public ::testing::Test
{
protected:
  const glm::ivec3 Dimensions{ 30, 28, 26 };

  using Frame = TemporalCoherence::Frame;
  using FrameKey = TemporalCoherence::FrameKey;
  using FrameRenderer = TemporalCoherence::FrameRenderer;
  using FrameStatistics = TemporalCoherence::FrameStatistics;
  using Route = TemporalCoherence::Route;

  OpacityChanges()
    : Samples(Dimensions)
  {
    this->Samples.Fill([](int i, int j, int k) { return 100.0 * Wave(i, j, k); });
    this->Key.Samples = this->Samples.Field;
    this->Key.View = LookAt(Dimensions, { 1.0, 2.0, 0.7 }, { 101, 67 });
    this->Key.EditIsosurfaces().Isovalues = { 40.0, -30.0 };
    this->Key.Appearance.Colors = { { 1.0, 0.5, 0.2 }, { 0.2, 0.5, 1.0 } };
    this->Key.Appearance.Shade = true;
    this->Key.Appearance.Lights = { TemporalCoherence::Light() };
  }

  void SetOpacity(double opacity)
  {
    this->Key.EditIsosurfaces().Opacities.assign(this->Key.Isosurfaces().Isovalues.size(), opacity);
  }

  /// Let the region keep up to three pieces of a ray, and cut these.
  void CutIntoPieces()
  {
    TemporalCoherence::Region& region = this->Key.Region;
    region.Crops = { glm::dvec2(8.0, 19.0), glm::dvec2(9.0, 18.0), glm::dvec2(7.0, 17.0) };
    region.Boxes = TemporalCoherence::Region::AllBoxes & ~(1u << 13);
    region.Clips = { { 1.0, 0.3, -0.2, -4.0 } };
  }

  void HideSomeCells()
  {
    std::mt19937 engine(3);
    const glm::ivec3 cells = Dimensions - 1;
    std::vector<std::uint8_t> flags(static_cast<std::size_t>(cells.x * cells.y * cells.z));
    for (std::uint8_t& flag : flags)
    {
      flag = engine() % 12 == 0;
    }
    this->Key.Samples.Flagged =
      TemporalCoherence::HiddenCells::Make(Dimensions, { flags.data(), 1, nullptr, 0 });
  }

  void LookFromWithin()
  {
    const glm::dvec3 eye(14.3, 13.0, 12.9);
    ASSERT_TRUE(TemporalCoherence::MakeView(
      glm::lookAt(eye, eye + glm::dvec3(1.0, 0.4, 0.2), glm::dvec3(0, 0, 1)),
      glm::perspective(1.2, 1.5, 0.01, 200.0), { 0.01, 200.0 }, { 75, 50 }, this->Key.View));
  }

  Frame Cold(FrameStatistics* statistics = nullptr) const
  {
    FrameRenderer renderer;
    renderer.Render(this->Key, this->Options);
    EXPECT_EQ(renderer.Statistics().Made, Route::Cold);
    if (statistics)
    {
      *statistics = renderer.Statistics();
    }
    return renderer.LastFrame();
  }

  const FrameStatistics& Statistics() const { return this->Renderer.Statistics(); }

  /// The last frame is the cold one.
  void ExpectCold(const std::string& what)
  {
    FrameStatistics ofCold;
    const Frame cold = this->Cold(&ofCold);
    const Frame& made = this->Renderer.LastFrame();
    const std::string step = what + ", by " + NameOf(this->Statistics().Made);
    ASSERT_TRUE(ShowTheSame(made, cold)) << step;
    ASSERT_TRUE(HaveTheSameLayers(made, cold)) << step;
    if (this->HasColdAnswers)
    {
      ASSERT_TRUE(IsSamePlane(made.Answers, cold.Answers)) << step;
      ASSERT_TRUE(made.ClearTiles == cold.ClearTiles) << step;
    }
    if (this->Statistics().Made == Route::Recomposite)
    {
      ASSERT_EQ(this->Statistics().Layers, ofCold.Layers) << step;
    }
    ASSERT_EQ(this->Statistics().Rays,
      this->Statistics().DefiniteHits + this->Statistics().DefiniteMisses +
        this->Statistics().PossibleHits);
  }

  /// Make the next frame, which is the cold one.
  void Render(const std::string& what)
  {
    this->Renderer.Render(this->Key, this->Options);
    const Route made = this->Statistics().Made;
    ++this->Routes[made];
    // From what routes that look up find out, other answers follow.
    this->HasColdAnswers = made == Route::Cold ||
      ((made == Route::Recomposite || made == Route::Reshade) && this->HasColdAnswers);
    this->ExpectCold(what);
  }

  /// The same, by this route.
  void Render(const std::string& what, Route route)
  {
    this->Render(what);
    ASSERT_EQ(NameOf(this->Statistics().Made), std::string(NameOf(route))) << what;
  }

  void ExpectNothingTraced(const std::string& what) const
  {
    EXPECT_EQ(this->Statistics().TracedRays, 0) << what;
    EXPECT_EQ(this->Statistics().FieldSamples, 0) << what;
  }

  std::size_t CountBehind() const
  {
    std::size_t count = 0;
    for (const TemporalCoherence::LayersBehind& tile : this->Renderer.LastFrame().Behind)
    {
      count += tile.Hits.size();
    }
    return count;
  }

  /// Opacities as a user may set them, of any kind.
  void SetAnyOpacities(std::mt19937& engine)
  {
    std::uniform_real_distribution<double> share(0.0, 1.0);
    TemporalCoherence::Surfaces& surfaces = this->Key.EditIsosurfaces();
    switch (engine() % 6)
    {
      case 0:
        surfaces.Opacities.clear();
        surfaces.ByGradient.Nodes.clear();
        break;
      case 1:
        // Also invisible where the field changes slowly, or quickly.
        surfaces.ByGradient.Nodes = { { 20.0 * share(engine), engine() % 2 ? 0.0 : share(engine) },
          { 20.0 + 20.0 * share(engine), engine() % 2 ? 0.0 : 1.0 } };
        break;
      case 2:
        surfaces.ByGradient.Nodes.clear();
        break;
      default:
        surfaces.Opacities.clear();
        for (std::size_t i = 0; i < surfaces.Isovalues.size(); ++i)
        {
          surfaces.Opacities.push_back(engine() % 5 ? 0.05 + 0.95 * share(engine) : 1.0);
        }
        break;
    }
  }

  /// Walk through opacities, and now and then through what else may change.
  void Walk(unsigned int seed, int steps = 16)
  {
    std::mt19937 engine(seed);
    for (int step = 0; step < steps; ++step)
    {
      const auto change = engine() % 10;
      if (change == 0)
      {
        std::vector<double>& isovalues = this->Key.EditIsosurfaces().Isovalues;
        isovalues = engine() % 2 ? std::vector{ 40.0, -30.0 } : std::vector{ 10.0, 60.0 };
      }
      else if (change == 1)
      {
        this->Key.Appearance.Ambient = 0.02 * static_cast<double>(engine() % 20);
      }
      if (change != 1 || engine() % 2)
      {
        this->SetAnyOpacities(engine);
      }
      this->Render("seed " + std::to_string(seed) + ", step " + std::to_string(step));
      if (this->HasFatalFailure())
      {
        return;
      }
    }
  }

  void ExpectRoute(int atLeast)
  {
    EXPECT_GE(this->Routes[Route::Recomposite], atLeast) << "opacities made other routes";
  }

  Grid<std::int16_t> Samples;
  FrameKey Key;
  FrameRenderer Renderer;
  FrameRenderer::Options Options;
  std::map<Route, int> Routes;
  bool HasColdAnswers = false;
};

#endif
