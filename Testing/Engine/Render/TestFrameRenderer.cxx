// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Every route makes the cold picture, whatever the number of threads, with and without leaping.
// Counters add up to all rays. Without memory, the last frame stays.

#include "Checks/Sanitized.h"
#include "Grid.h"
#include "Render/FrameRenderer.h"
#include "SameFrames.h"

#include <gtest/gtest.h>
#include <vtkSMPTools.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <new>
#include <set>
#include <string>

namespace
{

using namespace TemporalCoherence;

class FrameRendererTest : public ::testing::Test
{
protected:
  FrameRendererTest()
    : Samples(glm::ivec3(60, 50, 40))
  {
    this->Samples.Fill([](int i, int j, int k)
      { return 120.0 + 100.0 * std::sin(0.2 * i) * std::cos(0.25 * j) * std::sin(0.3 * k); });
    this->Key.Samples = this->Samples.Field;
    this->Key.View = LookAt(this->Samples.Field.Dimensions, { 1.0, 2.0, 0.7 }, { 203, 117 });
    this->Key.EditIsosurfaces().Isovalues = { 150.0, 90.0 };
    this->Key.Appearance.Colors = { { 1.0, 0.5, 0.2 }, { 0.2, 0.5, 1.0 } };
    this->Key.Appearance.Shade = true;
    this->Key.Appearance.Lights = { Light() };
  }

  Frame Cold(const FrameRenderer::Options& options = {}) const
  {
    FrameRenderer renderer;
    renderer.Render(this->Key, options);
    EXPECT_EQ(renderer.Statistics().Made, Route::Cold);
    return renderer.LastFrame();
  }

  Grid<std::uint8_t> Samples;
  FrameKey Key;
};

TEST_F(FrameRendererTest, SamePictureForAnyNumberOfThreads)
{
  // The backend of plain threads starts as many as it is told, whatever the machine has.
  const std::string backend = vtkSMPTools::GetBackend();
  vtkSMPTools::SetBackend("STDThread");
  vtkSMPTools::Initialize(1);
  const Frame one = this->Cold();
  for (const int threads : { 2, 7 })
  {
    vtkSMPTools::Initialize(threads);
    EXPECT_TRUE(ShowTheSame(one, this->Cold())) << threads;
  }
  vtkSMPTools::Initialize(0);
  vtkSMPTools::SetBackend(backend.c_str());
}

TEST_F(FrameRendererTest, OneSidedLightingTurnsWhatIsSeenFromInside)
{
  // From where the light comes, so that two-sided lighting leaves nothing in the dark.
  this->Key.Appearance.Lights[0].Direction = -glm::normalize(glm::dvec3(1.0, 2.0, 0.7));
  FrameRenderer renderer;
  renderer.Render(this->Key, {});
  const Frame twoSided = renderer.LastFrame();
  this->Key.Appearance.TwoSided = false;
  renderer.Render(this->Key, {});
  EXPECT_EQ(renderer.Statistics().Made, Route::Reshade);
  const Frame& oneSided = renderer.LastFrame();
  EXPECT_TRUE(ShowTheSame(oneSided, this->Cold()));
  int darkened = 0;
  for (std::size_t i = 0; i < oneSided.Kinds.size(); ++i)
  {
    EXPECT_EQ(oneSided.Normals[i], twoSided.Normals[i]);
    if (oneSided.Kinds[i] != HitKind::Exit)
    {
      EXPECT_EQ(oneSided.Colors[i], twoSided.Colors[i]);
    }
    darkened += oneSided.Colors[i][0] < twoSided.Colors[i][0];
  }
  EXPECT_GT(darkened, 1000);
}

// A stopped frame of another view leaves no shadows to the colours of the last one.
TEST_F(FrameRendererTest, StoppedFramesLeaveNoShadows)
{
  this->Key.EditIsosurfaces().Isovalues.resize(1);
  this->Key.Appearance.Lights[0].Direction = glm::normalize(glm::dvec3(-1.0, 0.2, -0.4));
  this->Key.Appearance.Lights[0].CastsShadows = true;
  const auto lookFrom = [this](const glm::dvec3& from) {
    this->Key.View = LookAt(this->Samples.Field.Dimensions, from, { 609, 351 });
  };
  lookFrom({ 1.0, 2.0, 0.7 });
  FrameRenderer renderer;
  renderer.Render(this->Key, {});
  const FrameKey first = this->Key;
  lookFrom({ -1.0, 2.0, 0.7 });
  FrameRenderer::Options inParts;
  inParts.ReportsTiles = true;
  int reports = 0;
  ASSERT_FALSE(renderer.Render(this->Key, inParts, [&](double) { return ++reports < 8; }));
  this->Key = first;
  renderer.Render(this->Key, {});
  EXPECT_EQ(renderer.Statistics().Made, Route::Redisplay);
  this->Key.Appearance.Ambient += 0.1;
  renderer.Render(this->Key, {});
  EXPECT_EQ(renderer.Statistics().Made, Route::Reshade);
  EXPECT_TRUE(ShowTheSame(renderer.LastFrame(), this->Cold()));
}

// The light of a still picture is kept, however much it is: of pixels, and of more rays at edges.
TEST_F(FrameRendererTest, LightBecomesFinalBeyondItsMemory)
{
  this->Key.View = LookAt(this->Samples.Field.Dimensions, { 1.0, 2.0, 0.7 }, { 41, 23 });
  this->Key.Appearance.Occlusion.Radius = 5.0;
  FrameRenderer::Options options;
  options.Antialias = Antialiasing::WhenStill;
  options.Light.Rays = 256;
  options.Light.MemoryLimit = 1;
  FrameRenderer renderer;
  int frames = 0;
  do
  {
    renderer.Render(this->Key, options);
    ++frames;
  } while (renderer.Statistics().Progress < 1.0 && frames < 40);
  EXPECT_EQ(renderer.Statistics().Progress, 1.0);
}

TEST_F(FrameRendererTest, SpaceLeapingDoesNotChangeThePicture)
{
  FrameRenderer::Options plain;
  plain.SpaceLeaping = false;
  for (const SurfaceMode mode : { SurfaceMode::Crossing, SurfaceMode::Threshold })
  {
    this->Key.EditIsosurfaces().Mode = mode;
    EXPECT_TRUE(ShowTheSame(this->Cold(), this->Cold(plain)));
    // From within the volume, where blocks reach behind the eye.
    View inside = this->Key.View;
    const glm::dvec3 eye(20.3, 21.0, 17.9);
    ASSERT_TRUE(MakeView(glm::lookAt(eye, eye + glm::dvec3(1.0, 0.4, 0.2), glm::dvec3(0, 0, 1)),
      glm::perspective(1.2, 1.5, 0.01, 200.0), { 0.01, 200.0 }, { 150, 100 }, this->Key.View));
    EXPECT_TRUE(ShowTheSame(this->Cold(), this->Cold(plain)));
    this->Key.View = inside;
  }
}

TEST_F(FrameRendererTest, RoutesGiveTheColdPicture)
{
  FrameRenderer renderer;
  renderer.Render(this->Key, {});
  EXPECT_EQ(renderer.Statistics().Made, Route::Cold);
  EXPECT_GT(renderer.Statistics().TracedRays, 0);
  EXPECT_GT(renderer.Statistics().FieldSamples, 0);

  renderer.Render(this->Key, {});
  EXPECT_EQ(renderer.Statistics().Made, Route::Redisplay);
  EXPECT_EQ(renderer.Statistics().TracedRays, 0);
  EXPECT_TRUE(ShowTheSame(renderer.LastFrame(), this->Cold()));

  this->Key.Appearance.Colors[1] = { 0.9, 0.1, 0.1 };
  this->Key.Appearance.Ambient = 0.4;
  renderer.Render(this->Key, {});
  EXPECT_EQ(renderer.Statistics().Made, Route::Reshade);
  EXPECT_EQ(renderer.Statistics().TracedRays, 0);
  EXPECT_EQ(renderer.Statistics().FieldSamples, 0);
  EXPECT_TRUE(ShowTheSame(renderer.LastFrame(), this->Cold()));
}

TEST_F(FrameRendererTest, ExactFramesOfAMovingCameraAreCold)
{
  FrameRenderer renderer;
  FrameRenderer::Options exact;
  exact.Accuracy = ReuseAccuracy::Exact;
  for (int frame = 0; frame < 6; ++frame)
  {
    this->Key.View =
      LookAt(this->Samples.Field.Dimensions, { 1.0, 2.0 - 0.1 * frame, 0.7 }, { 203, 117 });
    renderer.Render(this->Key, exact);
    EXPECT_EQ(renderer.Statistics().Made, Route::Cold);
    EXPECT_TRUE(ShowTheSame(renderer.LastFrame(), this->Cold()));
  }
  renderer.Render(this->Key, exact);
  EXPECT_EQ(renderer.Statistics().Made, Route::Redisplay) << "it is the cold picture already";
}

TEST_F(FrameRendererTest, ARepeatedViewIsCompletedOnce)
{
  FrameRenderer renderer;
  FrameRenderer::Options paper;
  paper.Accuracy = ReuseAccuracy::Paper;
  renderer.Render(this->Key, paper);
  this->Key.View = LookAt(this->Samples.Field.Dimensions, { 1.0, 1.95, 0.7 }, { 203, 117 });
  renderer.Render(this->Key, paper);
  EXPECT_EQ(renderer.Statistics().Made, Route::ImageCache);
  EXPECT_GT(renderer.Statistics().DefiniteHits, 0);
  renderer.Render(this->Key, paper);
  EXPECT_EQ(renderer.Statistics().Made, Route::Cold);
  EXPECT_TRUE(ShowTheSame(renderer.LastFrame(), this->Cold()));
  renderer.Render(this->Key, paper);
  EXPECT_EQ(renderer.Statistics().Made, Route::Redisplay);
  EXPECT_TRUE(ShowTheSame(renderer.LastFrame(), this->Cold()));
}

TEST_F(FrameRendererTest, AWalkThatBeginsInASolidBeginsAgain)
{
  // Pictures that know nothing of the solid: rays start behind its surface and must find it.
  this->Key.EditIsosurfaces().Mode = SurfaceMode::Threshold;
  this->Key.EditIsosurfaces().Isovalues = { 150.0 };
  this->Key.Appearance.Colors = { glm::dvec3(1.0) };
  FrameRenderer renderer;
  FrameRenderer::Options paper;
  paper.Accuracy = ReuseAccuracy::Paper;
  long different = 0, pixels = 0;
  for (int frame = 0; frame < 10; ++frame)
  {
    this->Key.View =
      LookAt(this->Samples.Field.Dimensions, { 1.0, 2.0 - 0.3 * frame, 0.7 }, { 203, 117 });
    renderer.Render(this->Key, paper);
    const Frame cold = this->Cold();
    for (std::size_t i = 0; i < cold.Depth.size(); ++i)
    {
      const bool isHit = cold.Isovalues[i] != Frame::NoSurface;
      const bool isMet = renderer.LastFrame().Isovalues[i] != Frame::NoSurface;
      // What is met is never the far side of a solid that was entered.
      different += isHit && isMet && renderer.LastFrame().Depth[i] > cold.Depth[i] + 3.0;
      pixels += isHit;
    }
  }
  EXPECT_GT(pixels, 10000);
  EXPECT_LT(different, pixels / 100);
}

TEST_F(FrameRendererTest, AnswersAddUpToRays)
{
  FrameRenderer renderer;
  for (int frame = 0; frame < 3; ++frame)
  {
    this->Key.Appearance.Ambient += frame == 2 ? 0.1 : 0.0;
    renderer.Render(this->Key, {});
    const FrameStatistics& s = renderer.Statistics();
    EXPECT_EQ(s.Rays, 203 * 117);
    EXPECT_EQ(s.DefiniteHits + s.DefiniteMisses + s.PossibleHits, s.Rays);
    EXPECT_LE(s.TraceTime + s.ShadeTime, s.FrameTime);
  }
}

TEST_F(FrameRendererTest, AnswersAreCountedOnEveryRoute)
{
  for (const SurfaceMode mode : { SurfaceMode::Crossing, SurfaceMode::Threshold })
  {
    for (const bool hasIsomap : { false, true })
    {
      FrameRenderer::Options options;
      options.Reuse.Isomap = hasIsomap;
      options.Accuracy = ReuseAccuracy::Paper;
      this->Key.EditIsosurfaces() = { { 110.0 }, mode };
      this->Key.Appearance.Colors = { { 1.0, 0.5, 0.2 } };
      FrameRenderer renderer;
      std::set<Route> routes;
      for (int frame = 0; frame < 8; ++frame)
      {
        this->Key.EditIsosurfaces().Isovalues[0] += frame % 4 ? 2.0 : 0.0;
        this->Key.View = LookAt(
          this->Samples.Field.Dimensions, { 1.0, 2.0 - 0.05 * (frame / 4), 0.7 }, { 203, 117 });
        renderer.Render(this->Key, options);
        const FrameStatistics& counted = renderer.Statistics();
        routes.insert(counted.Made);
        const Plane<Answer>& answers = renderer.LastFrame().Answers;
        const auto count = [&](Answer answer)
        { return std::count(answers.begin(), answers.end(), answer); };
        EXPECT_EQ(counted.DefiniteMisses, count(Answer::DefiniteMiss)) << NameOf(counted.Made);
        EXPECT_EQ(counted.DefiniteHits, count(Answer::DefiniteHit)) << NameOf(counted.Made);
        EXPECT_EQ(counted.PossibleHits, count(Answer::PossibleHit)) << NameOf(counted.Made);
      }
      EXPECT_EQ(routes.count(Route::ImageCache), 1u);
      EXPECT_EQ(routes.count(Route::IsomapBuild), hasIsomap ? 1u : 0u);
    }
  }
}

/// Each tile of a drag is looked up, built or traced. The counters count tiles, not groups of
/// tiles, the last of which has fewer.
TEST_F(FrameRendererTest, CountersOfADragCountAllTiles)
{
  FrameRenderer::Options options;
  options.Accuracy = ReuseAccuracy::Paper;
  this->Key.EditIsosurfaces().Isovalues = { 110.0 };
  this->Key.Appearance.Colors = { { 1.0, 0.5, 0.2 } };
  FrameRenderer renderer;
  renderer.Render(this->Key, options);
  this->Key.View = LookAt(this->Samples.Field.Dimensions, { 1.0, 1.95, 0.7 }, { 203, 117 });
  renderer.Render(this->Key, options);
  ASSERT_EQ(renderer.Statistics().Made, Route::ImageCache);
  this->Key.EditIsosurfaces().Isovalues[0] += 1.0;
  for (const double tolerance : { 0.0, 0.1 })
  {
    options.Map.Tolerance = tolerance;
    this->Key.EditIsosurfaces().Isovalues[0] += 1.0;
    renderer.Render(this->Key, options);
    const FrameStatistics& counted = renderer.Statistics();
    EXPECT_EQ(counted.Made, Route::IsomapBuild);
    EXPECT_GT(counted.TilesBuilt, 0);
    EXPECT_EQ(counted.TilesLookedUp + counted.TilesBuilt + counted.TilesTraced,
      NumberOfTiles(this->Key.View.Size));
  }
}

/// Where no range is built first, a frame's progress is that of its tiles.
TEST_F(FrameRendererTest, ProgressBeginsAtNothing)
{
  FrameRenderer::Options options;
  options.ReportsTiles = true;
  FrameRenderer renderer;
  renderer.Render(this->Key, options);
  for (const bool hasRange : { false, true })
  {
    options.Map.Range = hasRange ? ValueBand{ 145.0, 155.0 } : ValueBand{ 1.0, 0.0 };
    this->Key.EditIsosurfaces().Isovalues[0] = hasRange ? 147.0 : 151.0;
    std::vector<double> reported;
    renderer.Render(this->Key, options,
      [&](double progress)
      {
        reported.push_back(progress);
        return true;
      });
    ASSERT_EQ(renderer.Statistics().Made, Route::IsomapBuild);
    ASSERT_FALSE(reported.empty());
    EXPECT_LT(reported.front(), 0.1);
    EXPECT_TRUE(std::is_sorted(reported.begin(), reported.end()));
  }
}

TEST_F(FrameRendererTest, LayersEndWhereNothingShinesThrough)
{
  for (const double opacity : { 0.99, 0.997, 0.999 })
  {
    this->Key.EditIsosurfaces().Opacities = { opacity, opacity };
    const Frame frame = this->Cold();
    std::map<std::int32_t, int> layers;
    int most = 0;
    for (const std::vector<LayerHit>& tile : frame.Layers)
    {
      for (const LayerHit& layer : tile)
      {
        most = std::max(most, ++layers[layer.Pixel]);
      }
    }
    EXPECT_GT(layers.size(), 1000u);
    // Less than half a step of a colour, 1 / 512, cannot be told from nothing.
    EXPECT_EQ(most, 1.0 - opacity < 1.0 / 512.0 ? 1 : 2) << opacity;
  }
}

TEST_F(FrameRendererTest, SamplesThatChangedAreReadAgain)
{
  FrameRenderer renderer;
  renderer.Render(this->Key, {});
  this->Samples.Fill([](int i, int, int) { return 4 * i; });
  this->Key.Samples.Stamp = 2;
  renderer.Render(this->Key, {});
  EXPECT_EQ(renderer.Statistics().Made, Route::Cold);
  EXPECT_TRUE(ShowTheSame(renderer.LastFrame(), this->Cold()));
}

TEST_F(FrameRendererTest, WithoutMemoryTheLastFrameStays)
{
  if (IsMemorySanitized)
  {
    GTEST_SKIP() << "a build with a sanitizer, which throws no std::bad_alloc";
  }
  FrameRenderer renderer;
  renderer.Render(this->Key, {});
  const Frame before = renderer.LastFrame();
  FrameKey huge = this->Key;
  huge.Samples.Dimensions = glm::ivec3(2000000000, 2000000, 2);
  EXPECT_ANY_THROW(renderer.Render(huge, {}));
  EXPECT_TRUE(ShowTheSame(renderer.LastFrame(), before));
  EXPECT_EQ(renderer.Statistics().Made, Route::Cold);
  renderer.Render(this->Key, {});
  EXPECT_EQ(renderer.Statistics().Made, Route::Redisplay);
  this->Key.View = LookAt(this->Samples.Field.Dimensions, { 1.0, 1.9, 0.7 }, { 203, 117 });
  FrameRenderer::Options cold;
  cold.Reuse.Frames = false;
  renderer.Render(this->Key, cold);
  EXPECT_TRUE(ShowTheSame(renderer.LastFrame(), this->Cold()));
}

TEST_F(FrameRendererTest, NothingToSeeIsAnEmptyPicture)
{
  const auto isEmpty = [](const Frame& frame)
  {
    for (const std::array<std::uint8_t, 4>& color : frame.Colors)
    {
      if (color[3] != 0)
      {
        return false;
      }
    }
    return !frame.IsEmpty();
  };
  this->Key.EditIsosurfaces().Isovalues = { 1000.0, -1000.0 };
  EXPECT_TRUE(isEmpty(this->Cold()));
  this->Key.EditIsosurfaces().Isovalues.clear();
  this->Key.Appearance.Colors.clear();
  EXPECT_TRUE(isEmpty(this->Cold()));
  this->Key.EditIsosurfaces().Isovalues = { 100.0 };
  this->Key.Appearance.Colors = { glm::dvec3(1.0) };
  this->Key.Samples.Dimensions.z = 1;
  EXPECT_TRUE(isEmpty(this->Cold()));
}

}
