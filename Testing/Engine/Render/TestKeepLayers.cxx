// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// A new isovalue of one of several translucent surfaces traces nothing of the others, and the
// picture is the cold one: planes, answers, and layers in their order.

#include "Checks/Sanitized.h"
#include "Fields/Coordinates.h"
#include "RefusedMemory.h"
#include "Render/OpacityChanges.h"

#include <vtkSMPTools.h>

#include <algorithm>
#include <new>

namespace
{

using namespace TemporalCoherence;

class KeepLayers : public OpacityChanges
{
protected:
  KeepLayers()
  {
    this->Options.Reuse.Isomap = false;
    this->Key.Appearance.Colors = { { 1.0, 0.5, 0.2 }, { 0.2, 0.5, 1.0 }, { 0.3, 0.9, 0.4 },
      { 0.8, 0.8, 0.1 } };
  }

  /// Set isovalues, all of one opacity.
  void SetIsovalues(const std::vector<double>& isovalues, double opacity)
  {
    this->Key.Isosurfaces.Isovalues = isovalues;
    this->SetOpacity(opacity);
    this->Key.Appearance.Colors.resize(isovalues.size());
  }

  /// Keep some isovalues, drop and add others, and change their order.
  void ChangeIsovalues(std::mt19937& engine)
  {
    std::vector<double>& isovalues = this->Key.Isosurfaces.Isovalues;
    if (engine() % 2)
    {
      std::shuffle(isovalues.begin(), isovalues.end(), engine);
    }
    if (isovalues.size() > 3 || (isovalues.size() > 1 && engine() % 2))
    {
      isovalues.pop_back();
    }
    // Integers are samples, too: whole faces of cells are at such an isovalue.
    const double added = engine() % 2 ? std::uniform_real_distribution(-95.0, 95.0)(engine)
                                      : static_cast<double>(engine() % 190) - 95.0;
    const bool isThere = std::count(isovalues.begin(), isovalues.end(), added) > 0;
    if (!isThere && engine() % 5)
    {
      isovalues.insert(isovalues.begin() + engine() % (isovalues.size() + 1), added);
    }
    this->Key.Appearance.Colors.resize(isovalues.size(), { 0.3, 0.4, 0.5 });
  }

  /// Walk through isovalues and opacities.
  void Walk(unsigned int seed, int steps = 14)
  {
    std::mt19937 engine(seed);
    for (int step = 0; step < steps; ++step)
    {
      if (engine() % 6)
      {
        this->ChangeIsovalues(engine);
      }
      if (engine() % 2)
      {
        this->SetAnyOpacities(engine);
      }
      std::vector<double>& opacities = this->Key.Isosurfaces.Opacities;
      if (!opacities.empty() || engine() % 2)
      {
        opacities.resize(this->Key.Isosurfaces.Isovalues.size(), 0.3);
      }
      this->Key.Appearance.ColorByAnswer = engine() % 8 == 0;
      this->Render("seed " + std::to_string(seed) + ", step " + std::to_string(step));
      if (this->HasFatalFailure())
      {
        return;
      }
    }
  }

  void ExpectKept(int atLeast)
  {
    EXPECT_GE(this->Routes[Route::KeepLayers], atLeast) << "isovalues made other routes";
  }
};

TEST_F(KeepLayers, WalksThroughIsovalues)
{
  for (const SurfaceMode mode : { SurfaceMode::Crossing, SurfaceMode::Threshold })
  {
    this->Key.Isosurfaces.Mode = mode;
    this->Walk(1);
    this->Walk(2);
  }
  this->ExpectKept(20);
}

TEST_F(KeepLayers, WalksWithoutLeapingAndInParallel)
{
  this->Key.View = LookAt(Dimensions, { 1.0, 0.2, 0.7 }, { 60, 50 }, true);
  this->Walk(3);
  this->Options.SpaceLeaping = false;
  this->Key.Isosurfaces.Mode = SurfaceMode::Threshold;
  this->Walk(4);
  this->ExpectKept(10);
}

TEST_F(KeepLayers, WalksFromWithinAndWithFineAndCoarsePixels)
{
  for (const int size : { 11, 190 })
  {
    this->Key.View = LookAt(Dimensions, { -1.0, 0.4, 0.3 }, glm::ivec2(size));
    this->Walk(5, 8);
  }
  this->LookFromWithin();
  this->Key.Isosurfaces.Mode = SurfaceMode::Threshold;
  this->Walk(6, 12);
  this->ExpectKept(8);
}

TEST_F(KeepLayers, WalksInRegions)
{
  this->CutIntoPieces();
  for (const SurfaceMode mode : { SurfaceMode::Crossing, SurfaceMode::Threshold })
  {
    this->Key.Isosurfaces.Mode = mode;
    this->Walk(7);
  }
  this->ExpectKept(8);
}

TEST_F(KeepLayers, WalksAmongHiddenCells)
{
  this->HideSomeCells();
  for (const SurfaceMode mode : { SurfaceMode::Crossing, SurfaceMode::Threshold })
  {
    this->Key.Isosurfaces.Mode = mode;
    this->Walk(8);
  }
  this->ExpectKept(8);
}

TEST_F(KeepLayers, WalksInOtherKindsOfFields)
{
  for (const SurfaceMode mode : { SurfaceMode::Crossing, SurfaceMode::Threshold })
  {
    this->Key.Isosurfaces.Mode = mode;
    this->Key.Samples = this->Samples.Field;
    this->Key.Samples.Between = Interpolation::Nearest;
    this->Walk(9, 8);
    this->Key.Samples.Between = Interpolation::Linear;
    this->Key.Samples.Kind = RectilinearKind(Stretched(Dimensions, 5.0, 2));
    this->Walk(10, 8);
  }
  Grid<double> holes(Dimensions);
  holes.Fill(WaveWithHoles);
  this->Key.Samples = holes.Field;
  this->Key.Samples.Stamp = 9;
  this->Walk(11, 10);
  this->ExpectKept(16);
  this->Renderer.Release(); // the samples go
}

/// As an isomap is there, look-ups make frames, too.
TEST_F(KeepLayers, WalksWithAnIsomap)
{
  this->Options.Reuse.Isomap = true;
  this->Walk(12);
  this->Walk(13);
  this->ExpectKept(6);
}

/// Pictures that the paper's image cache starts from.
TEST_F(KeepLayers, WalksWithWhatOtherViewsNeed)
{
  this->Options.Accuracy = ReuseAccuracy::Paper;
  this->Options.Reuse.RefineWhenStill = true;
  this->Walk(14, 8);
  const Frame cold = this->Cold();
  EXPECT_TRUE(IsSamePlane(cold.Disparities, this->Renderer.LastFrame().Disparities));
  EXPECT_FALSE(cold.Disparities.empty());
  this->ExpectKept(3);
}

/// More layers of a ray than one pass finds.
TEST_F(KeepLayers, ManyLayersOfARay)
{
  Grid<float> plates(Dimensions);
  plates.Fill([](int i, int j, int k) { return (i % 2 ? 50.0 : -50.0) + 0.3 * j + 0.1 * k; });
  this->Key.Samples = plates.Field;
  this->Key.View = LookAt(Dimensions, { 1.0, 0.02, 0.03 }, { 40, 30 });
  this->SetIsovalues({ -20.0, 0.0, 20.0 }, 0.05);
  this->Render("first", Route::Cold);
  EXPECT_GT(this->Statistics().Layers, 40 * 30 * 18);
  for (const double opacity : { 0.05, 0.01, 0.2 })
  {
    this->SetIsovalues({ -20.0, 100.0 * opacity, 20.0 }, opacity);
    this->Render("one of three", Route::KeepLayers);
    this->Key.Isosurfaces.ByGradient.Nodes = { { 0.0, 0.0 }, { 60.0, 0.5 } };
    this->SetIsovalues({ -25.0 - opacity, 100.0 * opacity, 20.0 }, opacity);
    this->Render("by gradient", Route::KeepLayers);
    this->Key.Isosurfaces.ByGradient.Nodes.clear();
    this->SetIsovalues({ -20.0, 100.0 * opacity, 20.0 }, 0.03);
    this->Render("more light", Route::KeepLayers);
  }
  this->Renderer.Release(); // the samples go
}

/// Tiles that show nothing begin to, and the other way round.
TEST_F(KeepLayers, SurfacesLeaveAndEnterTiles)
{
  Grid<float> ball(Dimensions);
  ball.Fill(
    [](int i, int j, int k) { return 13.0 - glm::length(glm::dvec3(i - 14, j - 13, k - 12)); });
  this->Key.Samples = ball.Field;
  this->SetIsovalues({ 10.5, 1.0 }, 0.5);
  this->Render("first", Route::Cold);
  for (const double isovalue : { 9.0, 12.0, 4.0, 0.5, 20.0, 8.0 })
  {
    this->SetIsovalues({ 10.5, isovalue }, 0.5);
    this->Render("another ball", Route::KeepLayers);
    this->SetOpacity(0.3);
    this->Render("and another opacity", Route::Recomposite);
    this->ExpectNothingTraced("all layers were found");
  }
  this->SetIsovalues({ 30.0, 8.0 }, 0.5);
  this->Render("a surface that is nowhere", Route::KeepLayers);
  this->SetIsovalues({ 30.0, 40.0 }, 0.5);
  this->Render("two of them", Route::KeepLayers);
  this->SetIsovalues({ 30.0, 8.0 }, 0.5);
  this->Render("back again", Route::KeepLayers);
  this->Renderer.Release(); // the samples go
}

/// However long a drag takes: what is searched is the dragged surface alone, and what is kept is
/// what is seen.
TEST_F(KeepLayers, NothingOfKeptSurfacesIsTraced)
{
  this->Key.View = LookAt(Dimensions, { 1.0, 2.0, 0.7 }, { 45, 37 });
  this->SetIsovalues({ 40.0, -30.0 }, 0.15);
  this->Render("first", Route::Cold);
  for (int step = 0; step < 100; ++step)
  {
    const double dragged = 41.0 + 0.4 * step;
    this->SetIsovalues({ dragged, -30.0 }, 0.15);
    this->Render("step " + std::to_string(step), Route::KeepLayers);
    EXPECT_EQ(this->CountBehind(), 0u);
    if (step % 20 == 0)
    {
      const FrameStatistics made = this->Statistics();
      const FrameKey key = this->Key;
      this->SetIsovalues({ dragged }, 0.15);
      FrameStatistics alone;
      this->Cold(&alone);
      EXPECT_EQ(made.FieldSamples, alone.FieldSamples);
      EXPECT_EQ(made.TracedRays, alone.TracedRays);
      EXPECT_GT(made.TracedRays, 100);
      this->Key = key;
    }
  }
}

TEST_F(KeepLayers, FewerIsovaluesAndAnotherOrderTraceNothing)
{
  this->SetIsovalues({ 40.0, -30.0, 10.0 }, 0.15);
  this->Render("first", Route::Cold);
  this->SetIsovalues({ 10.0, 40.0, -30.0 }, 0.15);
  this->Render("another order", Route::KeepLayers);
  this->ExpectNothingTraced("another order");
  this->SetIsovalues({ -30.0, 40.0 }, 0.2);
  this->Render("fewer", Route::KeepLayers);
  this->ExpectNothingTraced("fewer");
  this->SetIsovalues({ 40.0 }, 0.15);
  this->Render("one", Route::KeepLayers);
  this->ExpectNothingTraced("one");
}

/// Only rays that an opaque surface ended go on, if it goes.
TEST_F(KeepLayers, LightFallsBehindASurfaceThatGoes)
{
  this->SetIsovalues({ 40.0, -30.0 }, 0.15);
  this->Key.Isosurfaces.Opacities[1] = 1.0;
  this->Render("first", Route::Cold);
  std::int64_t ended = 0;
  for (const std::vector<LayerHit>& tile : this->Renderer.LastFrame().Layers)
  {
    ended += std::count_if(
      tile.begin(), tile.end(), [](const LayerHit& hit) { return hit.Isovalue == 1; });
  }
  ASSERT_GT(ended, 1000);
  this->SetIsovalues({ 40.0 }, 0.15);
  this->Render("without it", Route::KeepLayers);
  EXPECT_EQ(this->Statistics().TracedRays, ended);
  this->SetIsovalues({ 40.0, 10.0 }, 0.15);
  this->Render("another one", Route::KeepLayers);
  this->SetOpacity(0.1);
  this->Render("more light", Route::Recomposite);
  this->ExpectNothingTraced("all layers are known again");
}

/// Behind an opaque surface that stays, the others are not searched.
TEST_F(KeepLayers, NothingIsSearchedInTheDark)
{
  this->SetIsovalues({ 40.0, -30.0 }, 0.15);
  this->Key.Isosurfaces.Opacities[1] = 1.0;
  this->Render("first", Route::Cold);
  this->Key.Isosurfaces.Isovalues[0] = 20.0;
  this->Render("before and behind", Route::KeepLayers);
  const FrameStatistics made = this->Statistics();
  this->SetIsovalues({ 20.0 }, 0.15);
  FrameStatistics alone;
  this->Cold(&alone);
  EXPECT_LT(made.FieldSamples, alone.FieldSamples * 3 / 4);
  EXPECT_GT(made.FieldSamples, 0);
}

/// Also where the moved surface has become opaque at the same time.
TEST_F(KeepLayers, WhatBecomesDarkIsForgotten)
{
  this->SetIsovalues({ 40.0, -30.0 }, 0.15);
  this->Render("first", Route::Cold);
  this->Key.Isosurfaces.Isovalues[0] = 20.0;
  this->Key.Isosurfaces.Opacities[0] = 1.0;
  this->Render("opaque", Route::KeepLayers);
  EXPECT_EQ(this->CountBehind(), 0u);
  this->SetOpacity(0.15);
  this->Render("more light", Route::Recomposite);
  EXPECT_GT(this->Statistics().TracedRays, 1000);
  this->Key.Isosurfaces.Isovalues[1] = -20.0;
  this->Render("the other one", Route::KeepLayers);
}

TEST_F(KeepLayers, IsTheSameForAnyNumberOfThreads)
{
  const std::string backend = vtkSMPTools::GetBackend();
  vtkSMPTools::SetBackend("STDThread");
  for (const int threads : { 1, 4 })
  {
    vtkSMPTools::Initialize(threads);
    this->Renderer.Release();
    this->SetIsovalues({ 40.0, -30.0 }, 0.3);
    this->Render("first", Route::Cold);
    this->Key.Isosurfaces.Isovalues[1] = -35.0;
    this->Render("second", Route::KeepLayers);
  }
  vtkSMPTools::Initialize(0);
  vtkSMPTools::SetBackend(backend.c_str());
}

/// Wherever a frame is stopped, or memory is refused, the last one is whole, and so is the next.
TEST_F(KeepLayers, AFrameThatFailsLeavesNoTrace)
{
  this->SetIsovalues({ 40.0, -30.0 }, 0.9);
  this->Render("first", Route::Cold);
  const FrameKey before = this->Key;
  this->Options.ReportsTiles = true;
  this->Key.Isosurfaces.Isovalues[0] = 10.0;
  EXPECT_FALSE(this->Renderer.Render(this->Key, this->Options, [](double) { return false; }));
  this->Key = before;
  this->ExpectCold("after a stop");
  if (IsMemorySanitized)
  {
    GTEST_SKIP() << "a build with a sanitizer, which throws no std::bad_alloc";
  }
  const std::string backend = vtkSMPTools::GetBackend();
  vtkSMPTools::SetBackend("Sequential"); // all memory is asked for by this thread
  int refused = 0;
  bool isMade = false;
  for (std::int64_t allowed = 0; !isMade; allowed += 1 + allowed / 2)
  {
    this->Key.Isosurfaces.Isovalues[0] = 10.0;
    try
    {
      const RefusedMemory without(allowed);
      isMade = this->Renderer.Render(this->Key, this->Options);
    }
    catch (const std::bad_alloc&)
    {
      ++refused;
      this->Key = before;
    }
    this->ExpectCold("with " + std::to_string(allowed) + " allocations");
  }
  EXPECT_GT(refused, 3);
  EXPECT_EQ(this->Statistics().Made, Route::KeepLayers);
  vtkSMPTools::SetBackend(backend.c_str());
}

}
