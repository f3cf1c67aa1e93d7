// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// A new opacity traces only rays that lead on behind the layers that are known, and the picture is
// the cold one: planes, answers, and layers in their order.

#include "Lattice/Coordinates.h"
#include "Render/OpacityChanges.h"

#include <algorithm>

namespace
{

using namespace TemporalCoherence;

class Recomposite : public OpacityChanges
{
};

TEST_F(Recomposite, WalksThroughOpacities)
{
  for (const SurfaceMode mode : { SurfaceMode::Crossing, SurfaceMode::Threshold })
  {
    this->Key.EditIsosurfaces().Mode = mode;
    this->Walk(1);
  }
  this->ExpectRoute(10);
}

TEST_F(Recomposite, WalksWithoutIsomapAndInParallel)
{
  this->Options.Reuse.Isomap = false;
  this->Key.View = LookAt(Dimensions, { 1.0, 0.2, 0.7 }, { 60, 50 }, true);
  this->Walk(2);
  this->Options.SpaceLeaping = false;
  this->Key.EditIsosurfaces().Mode = SurfaceMode::Threshold;
  this->Walk(3);
  this->ExpectRoute(10);
}

TEST_F(Recomposite, WalksFromWithinAndWithFineAndCoarsePixels)
{
  for (const int size : { 11, 190 })
  {
    this->Key.View = LookAt(Dimensions, { -1.0, 0.4, 0.3 }, glm::ivec2(size));
    this->Walk(4, 8);
  }
  this->LookFromWithin();
  this->Key.EditIsosurfaces().Mode = SurfaceMode::Threshold;
  this->Walk(5, 10);
  this->ExpectRoute(12);
}

TEST_F(Recomposite, WalksInRegions)
{
  this->CutIntoPieces();
  for (const SurfaceMode mode : { SurfaceMode::Crossing, SurfaceMode::Threshold })
  {
    this->Key.EditIsosurfaces().Mode = mode;
    this->Walk(6, 10);
  }
  this->ExpectRoute(8);
}

TEST_F(Recomposite, WalksAmongHiddenCells)
{
  this->HideSomeCells();
  for (const SurfaceMode mode : { SurfaceMode::Crossing, SurfaceMode::Threshold })
  {
    this->Key.EditIsosurfaces().Mode = mode;
    this->Walk(7, 10);
  }
  this->ExpectRoute(8);
}

TEST_F(Recomposite, WalksInOtherKindsOfFields)
{
  this->Key.Samples.Between = Interpolation::Nearest;
  this->Walk(8, 10);
  this->Key.Samples.Between = Interpolation::Linear;
  this->Key.Samples.Shape = RectilinearKind(Stretched(Dimensions, 5.0, 2));
  this->Walk(9, 10);
  Grid<double> holes(Dimensions);
  holes.Fill(WaveWithHoles);
  this->Key.Samples = holes.Field;
  this->Key.Samples.Stamp = 9;
  this->Walk(10, 8);
  this->ExpectRoute(12);
  this->Renderer.Release(); // the samples go
}

TEST_F(Recomposite, ASliderTracesEachRayOnce)
{
  this->SetOpacity(0.9);
  this->Render("first", Route::Cold);
  bool wasTraced = false;
  for (const double opacity : { 0.7, 0.5, 0.3, 0.2, 0.1 })
  {
    this->SetOpacity(opacity);
    this->Render("down to " + std::to_string(opacity), Route::Recomposite);
    wasTraced |= this->Statistics().TracedRays > 0;
  }
  EXPECT_TRUE(wasTraced) << "the scene has no hidden layers";
  for (const double opacity : { 0.9, 0.1, 0.3, 0.6, 0.15, 0.9, 0.1 })
  {
    this->SetOpacity(opacity);
    this->Render("again " + std::to_string(opacity), Route::Recomposite);
    this->ExpectNothingTraced("again " + std::to_string(opacity));
  }
  this->Key.EditIsosurfaces().ByGradient.Nodes = { { 5.0, 0.8 }, { 30.0, 1.0 } };
  this->SetOpacity(0.4);
  this->Render("by gradient", Route::Recomposite);
  this->ExpectNothingTraced("by gradient: less light than before");
}

/// Of the others nothing more is known to be needed.
TEST_F(Recomposite, OnlyRaysThatLightPassesGoOn)
{
  this->Key.EditIsosurfaces().Isovalues = { 10.0 };
  this->Key.Appearance.Colors.resize(1);
  this->SetOpacity(0.9);
  this->Render("first", Route::Cold);
  // At 0.9, light passes two layers and not three; at 0.8, three.
  std::map<std::int32_t, int> layers;
  for (const std::vector<LayerHit>& tile : this->Renderer.LastFrame().Layers)
  {
    for (const LayerHit& hit : tile)
    {
      ++layers[hit.Pixel];
    }
  }
  const auto wereOpaque = std::count_if(
    layers.begin(), layers.end(), [](const auto& ofPixel) { return ofPixel.second == 3; });
  ASSERT_GT(wereOpaque, 100);
  this->SetOpacity(0.8);
  this->Render("more light", Route::Recomposite);
  EXPECT_EQ(this->Statistics().TracedRays, wereOpaque);
}

TEST_F(Recomposite, OpaqueSurfacesTraceNothing)
{
  this->SetOpacity(0.3);
  this->Render("first", Route::Cold);
  const std::int64_t layers = this->Statistics().Layers;
  this->Key.EditIsosurfaces().Opacities.clear();
  this->Render("opaque", Route::Recomposite);
  this->ExpectNothingTraced("opaque");
  EXPECT_TRUE(this->Renderer.LastFrame().Layers.empty());
  this->Key.Appearance.Ambient = 0.4;
  this->Render("opaque, in another light", Route::Reshade);
  this->SetOpacity(0.3);
  this->Render("translucent again", Route::Recomposite);
  this->ExpectNothingTraced("translucent again");
  EXPECT_EQ(this->Statistics().Layers, layers);
}

TEST_F(Recomposite, TranslucentSurfacesBeginBehindTheHits)
{
  this->Render("opaque", Route::Cold);
  const std::int64_t hits = std::count_if(this->Renderer.LastFrame().Isovalues.begin(),
    this->Renderer.LastFrame().Isovalues.end(),
    [](SurfaceIndex surface) { return surface != Frame::NoSurface; });
  this->SetOpacity(0.5);
  this->Render("translucent", Route::Recomposite);
  EXPECT_EQ(this->Statistics().TracedRays, hits);
}

/// Gradient opacity makes surfaces invisible. The planes hold the first visible ones, or misses.
TEST_F(Recomposite, InvisibleSurfacesComeBack)
{
  this->SetOpacity(0.6);
  this->Key.EditIsosurfaces().ByGradient.Nodes = { { 1e6, 0.0 }, { 2e6, 1.0 } };
  this->Render("all invisible", Route::Cold);
  EXPECT_GT(this->Statistics().Layers, 1000);
  this->Key.EditIsosurfaces().ByGradient.Nodes = { { 10.0, 0.0 }, { 40.0, 1.0 } };
  this->Render("some visible", Route::Recomposite);
  this->ExpectNothingTraced("all were passed");
  this->Key.EditIsosurfaces().ByGradient.Nodes = { { 1e6, 0.0 }, { 2e6, 1.0 } };
  this->Render("all invisible again", Route::Recomposite);
  this->Key.EditIsosurfaces().ByGradient.Nodes.clear();
  this->Key.EditIsosurfaces().Opacities.clear();
  this->Render("opaque", Route::Recomposite);
  this->ExpectNothingTraced("opaque");
}

TEST_F(Recomposite, FramesOfAnIsomapKnowTheirLayersToo)
{
  this->SetOpacity(0.7);
  this->Render("first");
  for (const double isovalue : { 41.0, 42.0, 43.0 })
  {
    this->Key.EditIsosurfaces().Isovalues = { isovalue, -isovalue };
    this->Render("isovalues");
    this->SetOpacity(this->Key.Isosurfaces().Opacities[0] - 0.2);
    this->Render("opacity", Route::Recomposite);
  }
  EXPECT_GT(this->Routes[Route::IsomapBuild] + this->Routes[Route::IsomapLookup], 2);
}

TEST_F(Recomposite, TimeStepsCopyWhatTilesKnow)
{
  this->SetOpacity(0.3);
  this->Render("first");
  this->SetOpacity(0.95);
  this->Render("layers behind", Route::Recomposite);
  EXPECT_GT(this->CountBehind(), 1000u);
  std::vector<Grid<std::int16_t>> steps;
  for (int step = 0; step < 3; ++step)
  {
    Grid<std::int16_t> next(Dimensions);
    next.Samples = this->Samples.Samples;
    next.At(3 + step, 4, 5) = 500;
    steps.push_back(std::move(next));
  }
  for (Grid<std::int16_t>& step : steps)
  {
    step.Field.Samples = step.Samples.data();
    step.Field.Stamp = this->Key.Samples.Stamp + 1;
    this->Key.Samples = step.Field;
    this->Render("time step");
    this->SetOpacity(this->Key.Isosurfaces().Opacities[0] == 0.5 ? 0.9 : 0.5);
    this->Render("opacity after a time step", Route::Recomposite);
  }
  EXPECT_GT(this->Routes[Route::TimeStep], 0);
  this->Renderer.Release(); // the samples go
}

}
