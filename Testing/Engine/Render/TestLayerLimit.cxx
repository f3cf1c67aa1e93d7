// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Layers beyond the limit are merged, counted, and drawn all the same: the picture is the cold one
// on every route, and so is what is kept. Memory is bounded.

#include "Checks/Sanitized.h"
#include "RefusedMemory.h"
#include "Render/FrameStore.h"
#include "Render/OpacityChanges.h"

#include <vtkSMPTools.h>

#include <new>
#include <numeric>

namespace
{

using namespace TemporalCoherence;

/// Noise: a surface between almost any two samples.
class LayersOverTheLimit : public OpacityChanges
{
protected:
  LayersOverTheLimit()
  {
    this->Samples.FillRandomly(0.0, 100.0, 3);
    this->Key.EditIsosurfaces().Isovalues = { 18.0, 27.0, 36.0, 45.0, 54.0, 63.0, 72.0, 81.0 };
    this->Key.Appearance.Colors.resize(8, { 0.9, 0.9, 0.3 });
    this->Key.View = LookAt(Dimensions, { 1.0, 2.0, 0.7 }, { 32, 24 });
  }

  std::size_t CountKept() const
  {
    std::size_t count = 0;
    for (const std::vector<LayerHit>& tile : this->Renderer.LastFrame().Layers)
    {
      count += tile.size();
    }
    return count;
  }

  /// No pixel keeps more than the limit, and every layer is either kept or counted as merged.
  void ExpectLimits(const std::string& what) const
  {
    const Frame& frame = this->Renderer.LastFrame();
    std::map<std::int32_t, std::size_t> ofPixel;
    for (const std::vector<LayerHit>& tile : frame.Layers)
    {
      for (const LayerHit& hit : tile)
      {
        ++ofPixel[hit.Pixel];
      }
    }
    for (const LayersBehind& tile : frame.Behind)
    {
      for (const LayerHit& hit : tile.Hits)
      {
        ++ofPixel[hit.Pixel];
      }
    }
    std::size_t most = 0;
    for (const auto& [pixel, count] : ofPixel)
    {
      most = std::max(most, count);
    }
    EXPECT_LE(most, MostKeptLayers) << what;
    if (this->Statistics().Made != Route::TimeStep && this->Statistics().Made != Route::Redisplay)
    {
      EXPECT_EQ(this->Statistics().Layers,
        this->Statistics().MergedLayers + static_cast<std::int64_t>(this->CountKept()))
        << what;
    }
  }

  /// Make frames by all routes back and forth.
  void Wander(const std::vector<double>& opacities)
  {
    for (const double opacity : opacities)
    {
      const std::string what = "opacity " + std::to_string(opacity);
      this->SetOpacity(opacity);
      this->Render(what);
      this->ExpectLimits(what);
      this->Key.Appearance.Ambient = this->Key.Appearance.Ambient > 0.2 ? 0.1 : 0.3;
      this->Render(what + ", in another light", Route::Reshade);
      this->ExpectLimits(what + ", in another light");
      if (this->HasFatalFailure())
      {
        return;
      }
    }
  }

  const std::vector<double> BackAndForth{ 0.01, 0.05, 0.9, 0.01, 0.3, 1.0, 0.02, 0.1 };
};

TEST_F(LayersOverTheLimit, EveryRouteGivesTheColdPicture)
{
  for (const SurfaceMode mode : { SurfaceMode::Crossing, SurfaceMode::Threshold })
  {
    this->Key.EditIsosurfaces().Mode = mode;
    this->Wander(this->BackAndForth);
    this->SetOpacity(0.01);
    this->Render("last");
    EXPECT_GT(this->Statistics().MergedLayers, this->Statistics().Layers / 8)
      << this->Statistics().Layers << " layers by " << NameOf(this->Statistics().Made);
  }
  this->ExpectRoute(10);
  this->Key.EditIsosurfaces().Mode = SurfaceMode::Crossing;
  for (const double isovalue : { 19.0, 20.0, 21.0, 22.0 })
  {
    this->Key.EditIsosurfaces().Isovalues[0] = isovalue;
    this->Render("isovalue");
    this->ExpectLimits("isovalue");
    this->Wander({ this->Key.Isosurfaces().Opacities[0] * 1.2 });
  }
  int others = 0; // of an isomap, say
  for (const auto& [route, count] : this->Routes)
  {
    const bool isOther = route != Route::Cold && route != Route::Reshade;
    others += isOther && route != Route::Recomposite ? count : 0;
  }
  EXPECT_GT(others, 2);
}

TEST_F(LayersOverTheLimit, InRegionsParallelViewsAndByGradient)
{
  this->Key.View = LookAt(Dimensions, { 1.0, 0.2, 0.7 }, { 32, 24 }, true);
  this->Key.Region.Crops = { glm::dvec2(8.0, 19.0), glm::dvec2(9.0, 18.0), glm::dvec2(7.0, 17.0) };
  this->Key.Region.Boxes = Region::AllBoxes & ~(1u << 13); // up to three pieces of a ray
  this->Wander({ 0.01, 0.4, 0.03 });
  this->Key.Region = {};
  this->Options.SpaceLeaping = false;
  this->Key.EditIsosurfaces().ByGradient.Nodes = { { 10.0, 0.0 }, { 60.0, 1.0 } };
  this->Wander({ 0.02, 0.4, 0.03 });
  EXPECT_GT(this->Statistics().MergedLayers, 0);
  this->Key.EditIsosurfaces().ByGradient.Nodes = { { 1e6, 0.0 }, { 2e6, 1.0 } };
  this->Wander({ 0.5, 0.02 }); // all layers are invisible, and none is ever the last
}

/// Layers that fit, and one more: the opacity alone decides how many of them light reaches.
TEST_F(LayersOverTheLimit, NoneIsMergedAtTheLimit)
{
  this->SetOpacity(0.01);
  this->Render("first", Route::Cold);
  const Frame& frame = this->Renderer.LastFrame();
  std::map<std::int32_t, std::size_t> ofPixel;
  std::size_t merged = 0, whole = 0;
  for (std::size_t tile = 0; tile < frame.Layers.size(); ++tile)
  {
    for (const LayerHit& hit : frame.Layers[tile])
    {
      ++ofPixel[hit.Pixel];
    }
  }
  for (std::size_t tile = 0; tile < frame.Layers.size(); ++tile)
  {
    const PixelRect part = PixelsOfTile(frame.Size, static_cast<std::int64_t>(tile));
    for (const LayerHit& hit : frame.Layers[tile])
    {
      const std::size_t place = PlaceFinder(part, frame.Size.x).Find(hit.Pixel);
      const bool isMerged = frame.Behind[tile].Merged >> place & 1u;
      const bool hasEnd = frame.Behind[tile].Ends >> place & 1u;
      EXPECT_NE(isMerged, hasEnd) << "light passes them all";
      EXPECT_TRUE(!isMerged || ofPixel[hit.Pixel] > MostKeptLayers / 2);
      ++(isMerged ? merged : whole);
    }
  }
  EXPECT_GT(merged, 1000u);
  EXPECT_GT(whole, 1000u);
}

TEST_F(LayersOverTheLimit, AnyNumberOfThreadsKeepsTheSame)
{
  this->Options.Layers.Bytes = 9000 * sizeof(LayerHit);
  this->SetOpacity(0.02);
  const std::string backend = vtkSMPTools::GetBackend();
  vtkSMPTools::SetBackend("Sequential");
  const Frame alone = this->Cold();
  vtkSMPTools::SetBackend("STDThread");
  for (const int threads : { 2, 3, 7 })
  {
    vtkSMPTools::Initialize(threads);
    FrameRenderer renderer;
    renderer.Render(this->Key, this->Options);
    EXPECT_TRUE(ShowTheSame(renderer.LastFrame(), alone));
    EXPECT_TRUE(HaveTheSameLayers(renderer.LastFrame(), alone)) << threads;
  }
  vtkSMPTools::Initialize(0);
  vtkSMPTools::SetBackend(backend.c_str());
}

/// If all layers are too many, each pixel keeps fewer, by one limit that the picture decides.
TEST_F(LayersOverTheLimit, AFrameHasALimit)
{
  this->SetOpacity(0.01);
  this->Render("without a limit", Route::Cold);
  const Plane<std::array<std::uint8_t, 4>> colors = this->Renderer.LastFrame().Colors;
  const double ambient = this->Key.Appearance.Ambient;
  const std::size_t all = this->CountKept();
  std::size_t lowest = MostKeptLayers;
  for (const std::size_t most : { all, all - 1, all / 3, all / 20, std::size_t(1) })
  {
    this->Options.Layers.Bytes = most * sizeof(LayerHit);
    const std::string what = std::to_string(most) + " layers";
    this->Key.View.Near += 1e-9; // nothing is the same
    this->Key.Appearance.Ambient = ambient;
    this->Render(what, Route::Cold);
    const std::size_t ofPixel = this->Renderer.LastFrame().LayersOfPixel;
    EXPECT_TRUE(IsSamePlane(colors, this->Renderer.LastFrame().Colors)) << what;
    EXPECT_TRUE(this->CountKept() <= most || ofPixel == 1) << what;
    EXPECT_EQ(ofPixel, most == all ? MostKeptLayers : std::min(ofPixel, MostKeptLayers / 2))
      << what;
    EXPECT_EQ(this->Statistics().Layers,
      this->Statistics().MergedLayers + static_cast<std::int64_t>(this->CountKept()));
    this->Wander({ 0.05, 1.0, 0.01 });
    lowest = std::min(lowest, this->Renderer.LastFrame().LayersOfPixel);
  }
  EXPECT_EQ(lowest, 1u);
}

TEST_F(LayersOverTheLimit, TimeStepsKeepWhatColdFramesKeep)
{
  std::vector<Grid<std::int16_t>> steps;
  for (int step = 0; step < 6; ++step)
  {
    Grid<std::int16_t> next(Dimensions);
    next.Samples = this->Samples.Samples;
    for (int i = 0; i < 1 + 20 * (step % 2); ++i)
    {
      next.At(i, 4 + step, 5) = 500;
    }
    steps.push_back(std::move(next));
  }
  this->Options.Layers.Bytes = 20000 * sizeof(LayerHit);
  this->Key.View = LookAt(Dimensions, { 1.0, 2.0, 0.7 }, { 51, 37 });
  this->SetOpacity(0.03);
  this->Render("first");
  for (Grid<std::int16_t>& step : steps)
  {
    step.Field.Samples = step.Samples.data();
    step.Field.Stamp = this->Key.Samples.Stamp + 1;
    this->Key.Samples = step.Field;
    this->Render("time step");
    this->Wander({ this->Key.Isosurfaces().Opacities[0] == 0.2 ? 0.02 : 0.2 });
  }
  EXPECT_GT(this->Routes[Route::TimeStep], 0);
  this->Renderer.Release(); // the samples go
}

/// A frame that only gets other colours is changed in place: nothing may fail once it has begun.
TEST_F(LayersOverTheLimit, OtherColoursFailBeforeTheyBegin)
{
  if (IsMemorySanitized)
  {
    GTEST_SKIP() << "a build with a sanitizer, which throws no std::bad_alloc";
  }
  const std::string backend = vtkSMPTools::GetBackend();
  vtkSMPTools::SetBackend("Sequential"); // all memory is asked for by this thread
  this->Key.Region.Crops = { glm::dvec2(8.0, 19.0), glm::dvec2(9.0, 18.0), glm::dvec2(7.0, 17.0) };
  this->Key.Region.Boxes = Region::AllBoxes & ~(1u << 13);
  this->SetOpacity(0.01);
  this->Render("first", Route::Cold);
  int refused = 0;
  bool isMade = false;
  for (std::int64_t allowed = 0; !isMade; ++allowed)
  {
    const FrameKey before = this->Key;
    this->Key.Appearance.Ambient += 0.01;
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

/// After a haze comes a clear picture, in the same memory.
TEST_F(LayersOverTheLimit, MemoryShrinksWithThePicture)
{
  const auto capacity = [this]
  {
    const std::vector<std::vector<LayerHit>>& layers = this->Renderer.LastFrame().Layers;
    return std::accumulate(layers.begin(), layers.end(), std::size_t(0),
      [](std::size_t sum, const std::vector<LayerHit>& tile) { return sum + tile.capacity(); });
  };
  this->SetOpacity(0.01);
  for (int i = 0; i < 4; ++i)
  {
    this->Key.View = LookAt(Dimensions, { 1.0, 2.0 + 0.1 * i, 0.7 }, { 32, 24 });
    this->Render("haze", Route::Cold);
  }
  const std::size_t before = capacity();
  this->Key.EditIsosurfaces().Isovalues = { 99.5 };
  for (int i = 0; i < 2; ++i)
  {
    this->Key.View = LookAt(Dimensions, { 1.0, 3.0 + 0.1 * i, 0.7 }, { 32, 24 });
    this->Render("clear", Route::Cold);
    const std::size_t small = 64 * this->Renderer.LastFrame().Layers.size();
    EXPECT_LE(capacity(), 2 * this->CountKept() + small);
    EXPECT_LT(capacity(), before / 3);
  }
}

/// Pictures for other views are cached without their layers.
TEST(FrameStoreLayers, CachedImagesKeepNone)
{
  FrameStore store;
  FrameKey key;
  key.View.Size = glm::ivec2(16);
  key.EditIsosurfaces().Isovalues = { 1.0 };
  key.EditIsosurfaces().Opacities = { 0.5 };
  ImageCache::Options options;
  options.NumberOfImages = 3;
  std::vector<const CachedImage*> made;
  for (int i = 0; i < 7; ++i)
  {
    key.View.Position.x = i;
    store.Begin(key, {});
    ASSERT_EQ(store.Next().Picture.Layers.size(), 4u);
    store.Next().Picture.Layers[0].resize(100);
    if (i > 4)
    {
      EXPECT_GE(store.Next().Picture.Layers[0].capacity(), 100u);
    }
    store.Finish(options);
    for (const CachedImage* image : made)
    {
      if (image != &store.Last() && i < 3)
      {
        EXPECT_TRUE(image->Picture.Layers.empty());
        EXPECT_TRUE(image->Picture.Behind.empty());
      }
    }
    made.push_back(&store.Last());
    EXPECT_EQ(store.Last().Picture.Layers.at(0).size(), 100u);
  }
}

}
