// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// A frame from fewer rays is nearer to the cold one than blocks of the same rays. It does not
// depend on threads, gets better with each further frame, and ends as the cold one. A stop leaves
// it as it was.

#include "Lattice/Coordinates.h"
#include "Render/OpacityChanges.h"
#include "Volumes/Medium/BlendCase.h"

#include <vtkSMPTools.h>

#include <atomic>
#include <cstdlib>
#include <limits>

namespace
{

using namespace TemporalCoherence;

/// What frames show.
enum class Kind
{
  Composite,
  Maximum,
  Average,
  Layers,
  LayersByGradient,
  Solid,
  Opaque
};

std::string NameOfKind(const ::testing::TestParamInfo<Kind>& info)
{
  constexpr const char* names[] = { "Composite", "Maximum", "Average", "Layers", "LayersByGradient",
    "Solid", "Opaque" };
  return names[static_cast<int>(info.param)];
}

FrameRenderer::Options Fewer(double distance, std::int64_t tiles)
{
  FrameRenderer::Options options;
  options.Fewer.Distance = distance;
  options.Fewer.Tiles = tiles;
  return options;
}

class FewerRaysTest
  : public OpacityChanges
  , public ::testing::WithParamInterface<Kind>
{
protected:
  FewerRaysTest()
    : Volume(BlendSize)
  {
    const Kind kind = this->GetParam();
    if (kind == Kind::Composite || kind == Kind::Maximum || kind == Kind::Average)
    {
      const BlendMode mode = kind == Kind::Composite
        ? BlendMode::Composite
        : (kind == Kind::Maximum ? BlendMode::Maximum : BlendMode::Average);
      this->Key = MakeBlendKey(this->Volume, mode, BlendLooks::Skin);
      this->Key.View = LookAt(BlendSize, { 1.0, 2.0, 0.7 }, { 203, 135 });
      return;
    }
    this->Key.View = LookAt(Dimensions, { 1.0, 2.0, 0.7 }, { 203, 135 });
    Surfaces& surfaces = this->Key.EditIsosurfaces();
    surfaces.Mode = kind == Kind::Solid ? SurfaceMode::Threshold : SurfaceMode::Crossing;
    if (kind == Kind::LayersByGradient)
    {
      surfaces.ByGradient.Nodes = { { 10.0, 0.1 }, { 30.0, 1.0 } };
    }
    else if (kind != Kind::Opaque)
    {
      this->SetOpacity(0.4);
    }
  }

  std::int64_t ErrorOf(const Frame& frame, const Frame& cold) const
  {
    std::int64_t sum = 0;
    for (std::size_t pixel = 0; pixel < cold.Colors.size(); ++pixel)
    {
      for (std::size_t channel = 0; channel < 4; ++channel)
      {
        sum += std::abs(frame.Colors[pixel][channel] - cold.Colors[pixel][channel]);
      }
    }
    return sum;
  }

  /// The last frame is the cold one, with its answers.
  void ExpectColdBytes(const std::string& what)
  {
    const Frame cold = this->Cold();
    const Frame& made = this->Renderer.LastFrame();
    EXPECT_TRUE(ShowTheSame(made, cold)) << what;
    EXPECT_TRUE(HaveTheSameLayers(made, cold)) << what;
    EXPECT_TRUE(IsSamePlane(made.Answers, cold.Answers)) << what;
    EXPECT_EQ(this->Statistics().Progress, 1.0) << what;
    this->ExpectAllRaysCount(what);
  }

  void ExpectAllRaysCount(const std::string& what) const
  {
    EXPECT_EQ(this->Statistics().Rays,
      this->Statistics().DefiniteHits + this->Statistics().DefiniteMisses +
        this->Statistics().PossibleHits)
      << what;
  }

  /// Fewer rays, then all of them.
  void ExpectRefined(double distance, std::int64_t tiles, const std::string& what)
  {
    this->Renderer = FrameRenderer();
    this->Renderer.Render(this->Key, Fewer(distance, tiles));
    ASSERT_EQ(NameOf(this->Statistics().Made), std::string("FewerRays")) << what;
    EXPECT_LT(this->Statistics().Progress, 1.0) << what;
    this->ExpectAllRaysCount(what);
    EXPECT_LT(this->Statistics().TracedRays, this->Statistics().Rays / 2) << what;
    this->Renderer.Render(this->Key, {});
    ASSERT_EQ(NameOf(this->Statistics().Made), std::string("Refine")) << what;
    this->ExpectColdBytes(what);
    this->Renderer.Render(this->Key, {});
    EXPECT_EQ(NameOf(this->Statistics().Made), std::string("Redisplay")) << what;
  }

  BlendVolume<std::uint8_t> Volume;
};

TEST_P(FewerRaysTest, EndAsTheColdFrame)
{
  this->ExpectRefined(2.0, 0, "every second ray");
  this->ExpectRefined(3.3, 17, "some tiles");
  this->ExpectRefined(10.0, 3, "few rays");
  this->Key.View.Parallel = false;
  this->Key.Samples.Between = Interpolation::Nearest;
  this->ExpectRefined(4.0, 9, "nearest");
  this->Key.Samples.Between = Interpolation::Linear;
  const glm::ivec3 dimensions = this->Key.Samples.Dimensions;
  this->Key.View = LookAt(dimensions, { 1.0, 0.2, 0.7 }, { 133, 90 }, true);
  this->ExpectRefined(4.0, 9, "parallel");
  this->CutIntoPieces();
  this->ExpectRefined(3.0, 9, "clipped");
}

TEST_P(FewerRaysTest, NothingToSeeNeedsNoRays)
{
  if (!this->Key.IsBlended())
  {
    this->Key.EditIsosurfaces().Isovalues.clear();
    this->Renderer.Render(this->Key, Fewer(4.0, 9));
    EXPECT_EQ(this->Renderer.Statistics().Made, Route::Cold);
  }
  this->Key.Samples.Dimensions.z = 0;
  this->Renderer.Render(this->Key, Fewer(4.0, 9));
  EXPECT_EQ(this->Renderer.Statistics().Made, Route::Cold);
}

TEST_P(FewerRaysTest, AllTilesMakeTheColdFrameAtOnce)
{
  this->Renderer.Render(this->Key, Fewer(4.0, std::numeric_limits<std::int64_t>::max()));
  this->ExpectColdBytes("all tiles");
}

TEST_P(FewerRaysTest, GetBetterWithEachFrame)
{
  const Frame cold = this->Cold();
  std::int64_t before = std::numeric_limits<std::int64_t>::max();
  int frames = 0;
  do
  {
    this->Renderer.Render(this->Key, Fewer(5.0, 40));
    const std::int64_t error = this->ErrorOf(this->Renderer.LastFrame(), cold);
    EXPECT_LE(error, before) << "frame " << frames;
    before = error;
    ASSERT_LT(++frames, 100);
  } while (this->Statistics().Progress < 1.0);
  EXPECT_GT(frames, 3);
  this->ExpectColdBytes("after all frames");
}

TEST_P(FewerRaysTest, AreBetterThanBlocks)
{
  this->Key.View.Size *= 4;
  const Frame cold = this->Cold();
  const auto errorOfBlocks = [&](int distance)
  {
    FrameKey coarse = this->Key;
    coarse.View.Size = (this->Key.View.Size + distance - 1) / distance;
    FrameRenderer renderer;
    renderer.Render(coarse, {});
    const glm::ivec2 size = this->Key.View.Size, rays = coarse.View.Size;
    Frame blocks;
    blocks.Resize(size);
    for (int y = 0; y < size.y; ++y)
    {
      for (int x = 0; x < size.x; ++x)
      {
        const int atX = (2 * x + 1) * rays.x / (2 * size.x);
        const int atY = (2 * y + 1) * rays.y / (2 * size.y);
        blocks.Colors[static_cast<std::size_t>(y * size.x + x)] =
          renderer.LastFrame().Colors[static_cast<std::size_t>(atY * rays.x + atX)];
      }
    }
    return this->ErrorOf(blocks, cold);
  };
  const bool isSmooth = this->GetParam() == Kind::Composite || this->GetParam() == Kind::Average;
  const auto errorOfFewer = [&](std::int64_t tiles)
  {
    FrameRenderer renderer;
    renderer.Render(this->Key, Fewer(4.0, tiles));
    return static_cast<double>(this->ErrorOf(renderer.LastFrame(), cold));
  };
  // The grid alone, and with so many tiles that rays are as many as those of blocks of 3 x 3.
  const auto blocks = static_cast<double>(errorOfBlocks(4));
  const auto finer = static_cast<double>(errorOfBlocks(3));
  const std::int64_t tiles = NumberOfTiles(this->Key.View.Size) / 20;
  // Between rays on both sides of an edge, a step is as good as a ramp. Tiles are what helps there.
  EXPECT_LT(errorOfFewer(0), (isSmooth ? 0.8 : 1.1) * blocks);
  EXPECT_LT(errorOfFewer(tiles), (isSmooth ? 0.75 : 0.9) * finer);
}

TEST_P(FewerRaysTest, DoNotDependOnThreads)
{
  const std::string backend = vtkSMPTools::GetBackend();
  vtkSMPTools::SetBackend("STDThread");
  const auto make = [&](int threads)
  {
    vtkSMPTools::Initialize(threads);
    FrameRenderer renderer;
    renderer.Render(this->Key, Fewer(3.7, 21));
    return renderer.LastFrame();
  };
  const Frame one = make(1), three = make(3);
  vtkSMPTools::Initialize(0);
  vtkSMPTools::SetBackend(backend.c_str());
  EXPECT_TRUE(ShowTheSame(one, three));
  EXPECT_TRUE(HaveTheSameLayers(one, three));
  EXPECT_TRUE(IsSamePlane(one.Answers, three.Answers));
}

TEST_P(FewerRaysTest, StoppedFramesLeaveTheLastOne)
{
  this->Renderer.Render(this->Key, Fewer(4.0, 11));
  const Frame before = this->Renderer.LastFrame();
  int stops = 0;
  for (int reports = 0; reports < 40; ++reports)
  {
    int left = reports;
    FrameRenderer::Options whole;
    whole.ReportsTiles = true;
    FrameRenderer copy; // a renderer of its own, as the last stop may finish the frame
    copy.Render(this->Key, Fewer(4.0, 11));
    if (copy.Render(this->Key, whole, [&](double) { return left-- > 0; }))
    {
      break;
    }
    ++stops;
    EXPECT_TRUE(ShowTheSame(copy.LastFrame(), before));
    EXPECT_TRUE(copy.Render(this->Key, {}));
    EXPECT_EQ(NameOf(copy.Statistics().Made), std::string("Refine"));
  }
  EXPECT_GT(stops, 0);
  // A first frame, too.
  int left = 1;
  FrameRenderer::Options fewer = Fewer(4.0, 11);
  fewer.ReportsTiles = true;
  FrameRenderer fresh;
  EXPECT_FALSE(fresh.Render(this->Key, fewer, [&](double) { return left-- > 0; }));
  EXPECT_TRUE(fresh.LastFrame().IsEmpty());
}

TEST_P(FewerRaysTest, ServeNoRouteThatNeedsAllRays)
{
  this->Renderer.Render(this->Key, Fewer(4.0, 11));
  this->Key.Appearance.Ambient += 0.1;
  this->Renderer.Render(this->Key, {});
  this->ExpectColdBytes("other light");
  this->Renderer.Render(this->Key, Fewer(4.0, 11));
  this->Key.View = LookAt(this->Key.Samples.Dimensions, { -1.0, 2.0, 0.7 }, { 150, 90 });
  this->Renderer.Render(this->Key, Fewer(4.0, 11));
  EXPECT_EQ(NameOf(this->Statistics().Made), std::string("FewerRays"));
  if (!this->Key.IsBlended())
  {
    this->SetOpacity(0.6);
    this->Renderer.Render(this->Key, {});
    this->ExpectColdBytes("other opacities");
    this->Renderer.Render(this->Key, Fewer(4.0, 11));
    this->Key.EditIsosurfaces().Isovalues[0] += 5.0;
    this->Renderer.Render(this->Key, {});
    const Frame cold = this->Cold();
    EXPECT_TRUE(ShowTheSame(this->Renderer.LastFrame(), cold)) << "another isovalue";
  }
}

// A grid that will nearly be ready when the time is up is finished; else it is given up soon, and a
// coarser one takes its place.
TEST_P(FewerRaysTest, AGridThatTakesTooLongGetsCoarser)
{
  constexpr double asked = 1.5, most = 10.0;
  const glm::ivec2 size = this->Key.View.Size;
  const std::int64_t tiles = NumberOfTiles((2 * size + 2) / 3);
  ASSERT_GT(tiles, 10);
  const auto render = [&](std::int64_t inTime)
  {
    FrameRenderer::Options options = Fewer(asked, 0);
    options.Fewer.MostDistance = most;
    std::atomic<std::int64_t> begun{ 0 };
    options.Fewer.Elapsed = [&]()
    { return static_cast<double>(++begun) / static_cast<double>(inTime); };
    this->Renderer = FrameRenderer();
    this->Renderer.Render(this->Key, options);
    EXPECT_EQ(NameOf(this->Statistics().Made), std::string("FewerRays"));
    return this->Renderer.LastFrame();
  };
  const auto at = [&](double distance)
  {
    FrameRenderer renderer;
    renderer.Render(this->Key, Fewer(distance, 0));
    return renderer.LastFrame();
  };
  EXPECT_TRUE(ShowTheSame(render(tiles), at(asked))) << "all in time";
  EXPECT_TRUE(ShowTheSame(render(tiles - 3), at(asked))) << "nearly all";
  EXPECT_TRUE(ShowTheSame(render(0), at(most))) << "none";
  render(tiles / 2);
  const std::int64_t rays = this->Statistics().GridRays;
  const std::int64_t pixels = std::int64_t(size.x) * size.y;
  EXPECT_LT(rays, pixels / 3) << "a quarter of what there was time for, and a coarser grid";
  this->Renderer.Render(this->Key, {});
  this->ExpectColdBytes("after a coarser grid");
}

// Edges that there is no time for wait for the next frames, and become those of one long frame.
TEST_P(FewerRaysTest, EdgesWaitForTime)
{
  FrameRenderer::Options options;
  options.Antialias = Antialiasing::WhenStill;
  FrameRenderer whole, parts;
  whole.Render(this->Key, options);
  whole.Render(this->Key, options);
  ASSERT_TRUE(whole.LastFrame().IsSmooth());

  options.Fewer.Elapsed = []() { return 1.0; };
  parts.Render(this->Key, options);
  double progress = parts.Statistics().Progress;
  int frames = 0;
  for (; progress < 1.0 && frames < 100; ++frames)
  {
    parts.Render(this->Key, options);
    EXPECT_EQ(parts.Statistics().Made, Route::Antialias);
    EXPECT_GT(parts.Statistics().Progress, progress);
    progress = parts.Statistics().Progress;
  }
  EXPECT_GT(frames, 3);
  EXPECT_EQ(parts.LastFrame().Antialiased, whole.LastFrame().Antialiased);
  EXPECT_TRUE(ShowTheSame(parts.LastFrame(), whole.LastFrame()));
  parts.Render(this->Key, options);
  EXPECT_EQ(parts.Statistics().Made, Route::Redisplay);

  // Switched off half way, none is left.
  this->Key.View = LookAt(BlendSize, { 1.0, 2.0, 0.8 }, { 203, 135 });
  parts.Render(this->Key, options);
  parts.Render(this->Key, options);
  EXPECT_TRUE(parts.LastFrame().IsAntialiased() && !parts.LastFrame().IsSmooth());
  options.Antialias = Antialiasing::Off;
  parts.Render(this->Key, options);
  EXPECT_FALSE(parts.LastFrame().IsAntialiased());
  EXPECT_EQ(parts.Statistics().Progress, 1.0);
}

TEST_P(FewerRaysTest, HaveDepthsBetweenThoseOfRays)
{
  this->Renderer.Render(this->Key, Fewer(4.0, 0));
  const Frame& frame = this->Renderer.LastFrame();
  const Frame cold = this->Cold();
  double nearest = std::numeric_limits<double>::infinity(), farthest = 0.0;
  for (const double depth : cold.Depth)
  {
    nearest = std::min(nearest, depth);
    farthest = std::isinf(depth) ? farthest : std::max(farthest, depth);
  }
  int seen = 0, far = 0;
  for (std::size_t pixel = 0; pixel < frame.Depth.size(); ++pixel)
  {
    const bool isHit = frame.Isovalues[pixel] != Frame::NoSurface;
    EXPECT_EQ(isHit, std::isfinite(frame.Depth[pixel]));
    EXPECT_EQ(isHit, frame.Kinds[pixel] != HitKind::None);
    EXPECT_EQ(isHit, frame.Colors[pixel] != (std::array<std::uint8_t, 4>{}));
    if (isHit)
    {
      EXPECT_GE(frame.Depth[pixel], nearest - 1.0);
      EXPECT_LE(frame.Depth[pixel], farthest + 1.0);
      ++seen;
      far +=
        std::isfinite(cold.Depth[pixel]) && std::abs(frame.Depth[pixel] - cold.Depth[pixel]) > 2.0;
    }
  }
  EXPECT_GT(seen, 1000);
  EXPECT_LT(far, seen / 5);
}

INSTANTIATE_TEST_SUITE_P(Kinds, FewerRaysTest,
  ::testing::Values(Kind::Composite, Kind::Maximum, Kind::Average, Kind::Layers,
    Kind::LayersByGradient, Kind::Solid, Kind::Opaque),
  NameOfKind);

}
