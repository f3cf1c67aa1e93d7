// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// A new opacity traces only rays that lead on behind the layers that are known, and the picture is
// the cold one: planes, answers, and layers in their order. Layers that no light reaches are kept
// for later opacities, but not for other surfaces, views or data.

#include "Acceleration/HiddenCells.h"
#include "Checks/Sanitized.h"
#include "Fields/Coordinates.h"
#include "Fields/Waves.h"
#include "Grid.h"
#include "RefusedMemory.h"
#include "Render/FrameRenderer.h"
#include "Render/FrameStore.h"
#include "Render/TileLoop.h"
#include "SameFrames.h"

#include <gtest/gtest.h>
#include <vtkSMPTools.h>

#include <functional>
#include <map>
#include <new>
#include <random>
#include <string>
#include <vector>

namespace
{

using namespace TemporalCoherence;

const glm::ivec3 Dimensions(30, 28, 26);

/// Many layers on most rays.
class Recomposite : public ::testing::Test
{
protected:
  Recomposite()
    : Samples(Dimensions)
  {
    this->Samples.Fill([](int i, int j, int k) { return 100.0 * Wave(i, j, k); });
    this->Key.Samples = this->Samples.Field;
    this->Key.View = LookAt(Dimensions, { 1.0, 2.0, 0.7 }, { 101, 67 });
    this->Key.Isosurfaces.Isovalues = { 40.0, -30.0 };
    this->Key.Appearance.Colors = { { 1.0, 0.5, 0.2 }, { 0.2, 0.5, 1.0 } };
    this->Key.Appearance.Shade = true;
    this->Key.Appearance.Lights = { Light() };
  }

  void SetOpacity(double opacity)
  {
    this->Key.Isosurfaces.Opacities.assign(this->Key.Isosurfaces.Isovalues.size(), opacity);
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
    for (const LayersBehind& tile : this->Renderer.LastFrame().Behind)
    {
      count += tile.Hits.size();
    }
    return count;
  }

  /// Opacities as a user may set them, of any kind.
  void SetAnyOpacities(std::mt19937& engine)
  {
    std::uniform_real_distribution<double> share(0.0, 1.0);
    Surfaces& surfaces = this->Key.Isosurfaces;
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
        std::vector<double>& isovalues = this->Key.Isosurfaces.Isovalues;
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

TEST_F(Recomposite, WalksThroughOpacities)
{
  for (const SurfaceMode mode : { SurfaceMode::Crossing, SurfaceMode::Threshold })
  {
    this->Key.Isosurfaces.Mode = mode;
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
  this->Key.Isosurfaces.Mode = SurfaceMode::Threshold;
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
  const glm::dvec3 eye(14.3, 13.0, 12.9);
  ASSERT_TRUE(MakeView(glm::lookAt(eye, eye + glm::dvec3(1.0, 0.4, 0.2), glm::dvec3(0, 0, 1)),
    glm::perspective(1.2, 1.5, 0.01, 200.0), { 0.01, 200.0 }, { 75, 50 }, this->Key.View));
  this->Key.Isosurfaces.Mode = SurfaceMode::Threshold;
  this->Walk(5, 10);
  this->ExpectRoute(12);
}

TEST_F(Recomposite, WalksInRegions)
{
  Region& region = this->Key.Region;
  region.Crops = { glm::dvec2(8.0, 19.0), glm::dvec2(9.0, 18.0), glm::dvec2(7.0, 17.0) };
  region.Boxes = Region::AllBoxes & ~(1u << 13); // up to three pieces of a ray
  region.Clips = { { 1.0, 0.3, -0.2, -4.0 } };
  for (const SurfaceMode mode : { SurfaceMode::Crossing, SurfaceMode::Threshold })
  {
    this->Key.Isosurfaces.Mode = mode;
    this->Walk(6, 10);
  }
  this->ExpectRoute(8);
}

TEST_F(Recomposite, WalksAmongHiddenCells)
{
  std::mt19937 engine(3);
  const glm::ivec3 cells = Dimensions - 1;
  std::vector<std::uint8_t> flags(static_cast<std::size_t>(cells.x * cells.y * cells.z));
  for (std::uint8_t& flag : flags)
  {
    flag = engine() % 12 == 0;
  }
  this->Key.Samples.Hidden = HiddenCells::Make(Dimensions, { flags.data(), 1, nullptr, 0 });
  for (const SurfaceMode mode : { SurfaceMode::Crossing, SurfaceMode::Threshold })
  {
    this->Key.Isosurfaces.Mode = mode;
    this->Walk(7, 10);
  }
  this->ExpectRoute(8);
}

TEST_F(Recomposite, WalksInOtherKindsOfFields)
{
  this->Key.Samples.Between = Interpolation::Nearest;
  this->Walk(8, 10);
  this->Key.Samples.Between = Interpolation::Linear;
  this->Key.Samples.Kind = RectilinearKind(Stretched(Dimensions, 5.0, 2));
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
  this->Key.Isosurfaces.ByGradient.Nodes = { { 5.0, 0.8 }, { 30.0, 1.0 } };
  this->SetOpacity(0.4);
  this->Render("by gradient", Route::Recomposite);
  this->ExpectNothingTraced("by gradient: less light than before");
}

/// Of the others nothing more is known to be needed.
TEST_F(Recomposite, OnlyRaysThatLightPassesGoOn)
{
  this->Key.Isosurfaces.Isovalues = { 10.0 };
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
  this->Key.Isosurfaces.Opacities.clear();
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
    [](std::int16_t surface) { return surface != Frame::NoSurface; });
  this->SetOpacity(0.5);
  this->Render("translucent", Route::Recomposite);
  EXPECT_EQ(this->Statistics().TracedRays, hits);
}

/// Gradient opacity makes surfaces invisible. The planes hold the first visible ones, or misses.
TEST_F(Recomposite, InvisibleSurfacesComeBack)
{
  this->SetOpacity(0.6);
  this->Key.Isosurfaces.ByGradient.Nodes = { { 1e6, 0.0 }, { 2e6, 1.0 } };
  this->Render("all invisible", Route::Cold);
  EXPECT_GT(this->Statistics().Layers, 1000);
  this->Key.Isosurfaces.ByGradient.Nodes = { { 10.0, 0.0 }, { 40.0, 1.0 } };
  this->Render("some visible", Route::Recomposite);
  this->ExpectNothingTraced("all were passed");
  this->Key.Isosurfaces.ByGradient.Nodes = { { 1e6, 0.0 }, { 2e6, 1.0 } };
  this->Render("all invisible again", Route::Recomposite);
  this->Key.Isosurfaces.ByGradient.Nodes.clear();
  this->Key.Isosurfaces.Opacities.clear();
  this->Render("opaque", Route::Recomposite);
  this->ExpectNothingTraced("opaque");
}

TEST_F(Recomposite, FramesOfAnIsomapKnowTheirLayersToo)
{
  this->SetOpacity(0.7);
  this->Render("first");
  for (const double isovalue : { 41.0, 42.0, 43.0 })
  {
    this->Key.Isosurfaces.Isovalues[0] = isovalue;
    this->Render("isovalue");
    this->SetOpacity(this->Key.Isosurfaces.Opacities[0] - 0.2);
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
    this->SetOpacity(this->Key.Isosurfaces.Opacities[0] == 0.5 ? 0.9 : 0.5);
    this->Render("opacity after a time step", Route::Recomposite);
  }
  EXPECT_GT(this->Routes[Route::TimeStep], 0);
  this->Renderer.Release(); // the samples go
}

TEST_F(Recomposite, LayersBehindGoWithWhatTheyBelongTo)
{
  const auto expectGone = [this](const std::string& what)
  {
    this->SetOpacity(0.2);
    this->Render("many layers before " + what);
    this->SetOpacity(1.0);
    this->Render("layers behind before " + what, Route::Recomposite);
    EXPECT_GT(this->CountBehind(), 1000u);
  };
  expectGone("isovalues");
  this->Key.Isosurfaces.Isovalues = { 10.0, 60.0 };
  this->Render("isovalues");
  EXPECT_EQ(this->CountBehind(), 0u);
  expectGone("the view");
  this->Key.View = LookAt(Dimensions, { 1.0, 1.8, 0.7 }, { 101, 67 });
  this->Render("view");
  EXPECT_EQ(this->CountBehind(), 0u);
  expectGone("data");
  this->Key.Transform.WorldFromIndex[3][0] = 0.5;
  this->Render("data");
  EXPECT_EQ(this->CountBehind(), 0u);
}

/// What does not belong to the new frame is not kept with an older one either.
TEST(FrameStoreTest, AnOldFrameKeepsNoLayersBehind)
{
  FrameStore store;
  FrameKey key;
  key.View.Size = glm::ivec2(16);
  key.Isosurfaces.Isovalues = { 1.0 };
  key.Isosurfaces.Opacities = { 0.5 };
  const auto behind = [&store](const CachedImage& image)
  { return image.Picture.Behind.at(0).Hits.capacity(); };
  const auto make = [&]
  {
    store.Begin(key, {});
    store.Next().Picture.Behind[0].Hits.resize(100);
    store.Finish({});
  };
  make();
  const CachedImage& first = store.Last();
  key.Isosurfaces.Opacities = { 0.6 };
  make();
  EXPECT_GE(behind(first), 100u) << "memory for the next opacity";
  key.Isosurfaces.Isovalues = { 2.0 };
  const CachedImage& second = store.Last();
  make();
  EXPECT_EQ(behind(second), 0u);
  EXPECT_GE(behind(store.Last()), 100u);
}

TEST_F(Recomposite, WithoutImageCacheFramesAreCold)
{
  this->Options.Reuse.ImageCache = false;
  this->Options.Reuse.Isomap = false;
  this->SetOpacity(0.3);
  this->Render("first", Route::Cold);
  this->SetOpacity(0.6);
  this->Render("without image cache", Route::Cold);
  this->Options.Reuse.ImageCache = true;
  this->SetOpacity(0.5);
  this->Render("with image cache", Route::Recomposite);
}

/// Wherever a frame is stopped, the last one is whole, and so is the next.
TEST_F(Recomposite, AStoppedFrameLeavesNoTrace)
{
  this->Options.ReportsTiles = true;
  this->Key.View = LookAt(Dimensions, { 1.0, 2.0, 0.7 }, { 301, 203 });
  this->SetOpacity(0.9);
  this->Render("first", Route::Cold);
  const FrameKey before = this->Key;
  for (const double stop : { 0.0, 0.4, 0.9 })
  {
    this->SetOpacity(0.3);
    const bool isMade = this->Renderer.Render(
      this->Key, this->Options, [stop](double progress) { return progress < stop; });
    EXPECT_FALSE(isMade);
    EXPECT_TRUE(this->Renderer.LastKey().Isosurfaces == before.Isosurfaces);
    this->Key = before;
    this->ExpectCold("after a stop");
  }
  this->SetOpacity(0.4);
  this->Render("after stops", Route::Recomposite);
}

/// Layers are kept in memory that may be refused at any tile.
TEST_F(Recomposite, WithoutMemoryTheLastFrameStays)
{
  if (IsMemorySanitized)
  {
    GTEST_SKIP() << "a build with a sanitizer, which throws no std::bad_alloc";
  }
  const std::string backend = vtkSMPTools::GetBackend();
  vtkSMPTools::SetBackend("Sequential"); // all memory is asked for by this thread
  this->SetOpacity(0.9);
  this->Render("first", Route::Cold);
  int refused = 0;
  bool isMade = false;
  for (std::int64_t allowed = 0; !isMade; allowed += 1 + allowed / 2)
  {
    const FrameKey before = this->Key;
    this->SetOpacity(this->Key.Isosurfaces.Opacities[0] == 0.9 ? 0.3 : 0.9);
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
  vtkSMPTools::SetBackend(backend.c_str());
}

/// Threads of some kinds end the program where an exception leaves them.
TEST(TileLoop, AThreadWithoutMemoryEndsTheFrameOnly)
{
  const std::string backend = vtkSMPTools::GetBackend();
  vtkSMPTools::SetBackend("STDThread");
  vtkSMPTools::Initialize(3);
  FrameStatistics statistics;
  const auto work = [](std::size_t group, TraceCounts&)
  {
    if (group % 5 == 2)
    {
      throw std::bad_alloc();
    }
  };
  const auto done = [](std::size_t, std::int64_t) {};
  EXPECT_THROW(
    CountGroups(glm::ivec2(400), ReportProgress(), statistics, work, done), std::bad_alloc);
  vtkSMPTools::Initialize(0);
  vtkSMPTools::SetBackend(backend.c_str());
}

}
