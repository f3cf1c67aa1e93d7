// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Leaping does not change a byte of a blended volume, and every frame is the cold one, whatever
// came before. Other colours of a projection need no search.

#include "BlendCase.h"
#include "BlendFrames.h"
#include "SameFrames.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{

using namespace TemporalCoherence;

/// Pictures do not depend on how they were made.
class BlendRoutes : public ::testing::TestWithParam<BlendMode>
{
protected:
  BlendRoutes()
    : Volume(BlendSize)
    , Key(MakeBlendKey(Volume, GetParam(), BlendLooks::Skin))
  {
    this->Key.Blended().Looks[0].Material.Shade = true;
  }

  /// One change after the other, as users make them.
  void Change(int step)
  {
    ComponentLook& look = this->Key.Blended().Looks[0];
    switch (step % 9)
    {
      case 0:
        this->Key.View = LookAt(BlendSize, { 1.0, 2.0 - 0.1 * step, 0.7 }, { 96, 80 });
        break;
      case 1:
        for (glm::dvec4& node : look.Transfer.Nodes)
        {
          node = { node.y, node.z, node.x, node.w };
        }
        break;
      case 2:
        look.Transfer = MakeTransfer(this->Volume.Range + 2.0 * step, BlendLooks::Skin);
        break;
      case 3:
        this->Key.Appearance.Lights[0].Diffuse = { 0.5 + 0.05 * step, 0.8, 0.7 };
        break;
      case 4:
        look.Material.Ambient = 0.1 + 0.03 * step;
        break;
      case 5:
        look.UnitDistance = 1.0 + 0.1 * step;
        break;
      case 6:
        this->Volume.At(20, 18, 22) = static_cast<std::uint8_t>(11 * step);
        ++this->Key.Samples.Stamp;
        break;
      case 7:
        this->Key.Blended().AverageRange.x += 3.0;
        this->Key.Blended().ScalarRanges[0].y -= 3.0;
        break;
      default:
        this->Key.Region.Clips = { { 1.0, 0.0, 0.0, -0.5 * step } };
        break;
    }
  }

  BlendVolume<std::uint8_t> Volume;
  FrameKey Key;
};

TEST_P(BlendRoutes, SpaceLeapingDoesNotChangeThePicture)
{
  SKIP_UNLESS_BLENDED(this->Key);
  FrameOptions plain;
  plain.SpaceLeaping = false;
  for (const auto* points : { &BlendLooks::Skin, &BlendLooks::Peaks, &BlendLooks::Bone,
         &BlendLooks::Valley, &BlendLooks::Fog })
  {
    this->Key.Blended().Looks[0].Transfer = MakeTransfer(this->Volume.Range, *points);
    EXPECT_TRUE(ShowTheSame(BlendedFrame(this->Key), BlendedFrame(this->Key, plain)));
    const FrameKey fine = FineKey(this->Key);
    EXPECT_TRUE(ShowTheSame(BlendedFrame(fine), BlendedFrame(fine, plain))) << "in fine pixels";
  }
}

TEST_P(BlendRoutes, AStillPictureIsShownAgain)
{
  SKIP_UNLESS_BLENDED(this->Key);
  FrameRenderer renderer;
  renderer.Render(this->Key, {});
  const Frame first = renderer.LastFrame();
  renderer.Render(this->Key, {});
  EXPECT_EQ(renderer.Statistics().Made, Route::Redisplay);
  EXPECT_TRUE(ShowTheSame(first, renderer.LastFrame()));
}

TEST_P(BlendRoutes, ExactFramesAreColdOnes)
{
  SKIP_UNLESS_BLENDED(this->Key);
  FrameRenderer renderer;
  FrameOptions exact;
  exact.Accuracy = ReuseAccuracy::Exact;
  for (int step = 0; step < 40; ++step)
  {
    this->Change(step);
    ASSERT_TRUE(renderer.Render(this->Key, exact));
    EXPECT_TRUE(ShowTheSame(renderer.LastFrame(), BlendedFrame(this->Key))) << step;
  }
}

TEST_P(BlendRoutes, OtherColorsOfAProjectionNeedNoSearch)
{
  SKIP_UNLESS_BLENDED(this->Key);
  FrameRenderer renderer;
  renderer.Render(this->Key, {});
  std::vector<glm::dvec4>& nodes = this->Key.Blended().Looks[0].Transfer.Nodes;
  const auto expect = [&](const char* what, bool areTraced)
  {
    renderer.Render(this->Key, {});
    EXPECT_TRUE(ShowTheSame(renderer.LastFrame(), BlendedFrame(this->Key))) << what;
    const bool isKept = GetParam() != BlendMode::Composite;
    EXPECT_EQ(renderer.Statistics().Made, isKept ? Route::KeepValues : Route::Cold) << what;
    EXPECT_EQ(renderer.Statistics().TracedRays > 0, areTraced || !isKept) << what;
  };
  for (glm::dvec4& node : nodes)
  {
    node = { node.y, node.z, 0.5 * node.x, node.w };
  }
  expect("colours", false);
  this->Key.Appearance.ColorScale = 0.5;
  this->Key.Appearance.ColorShift = 0.1;
  expect("window and level", false);
  this->Key.Blended().Looks[0].Material.Diffuse = 0.3;
  expect("light", false);
  FrameOptions options;
  options.Reuse.Frames = false;
  this->Key.Appearance.ColorScale = 0.6;
  renderer.Render(this->Key, options);
  EXPECT_EQ(renderer.Statistics().Made, Route::Cold);
  this->Key.Appearance.ColorScale = 0.7;
  renderer.Render(this->Key, {});
  EXPECT_EQ(renderer.Statistics().Made, Route::Cold) << "nothing was kept";
}

/// Opacities of extremes that are dragged.
class ExtremeRoutes : public BlendRoutes
{
protected:
  /// A ramp of opacity between two shares of the range of values, counted from the lowest for
  /// maxima, and from the highest for minima.
  void SetRamp(double low, double high)
  {
    std::vector<LookPoint> points{ { 0.0, { 1.0, 0.5, 0.2, low > 0.0 ? 0.0 : 0.2 } },
      { low, { 1.0, 0.5, 0.2, 0.0 } }, { high, { 0.2, 0.5, 1.0, 1.0 } },
      { 1.0, { 0.2, 0.9, 0.1, high < 0.9 ? 0.0 : 1.0 } } };
    if (GetParam() == BlendMode::Minimum)
    {
      std::reverse(points.begin(), points.end());
      for (LookPoint& point : points)
      {
        point.At = 1.0 - point.At;
      }
    }
    this->Key.Blended().Looks[0].Transfer = MakeTransfer(this->Volume.Range, points);
  }
};

TEST_P(ExtremeRoutes, RampsAreDragged)
{
  FrameRenderer renderer;
  renderer.Render(this->Key, {});
  int notTraced = 0, traced = 0;
  for (int step = 0; step < 60; ++step)
  {
    const double low = 0.35 + 0.3 * std::sin(0.7 * step) * std::cos(0.11 * step);
    this->SetRamp(step % 13 == 5 ? 0.0 : low, low + (step % 7 == 0 ? 0.6 : 0.2));
    this->Key.Region.Clips.clear();
    if (step % 20 > 10)
    {
      this->Key.Region.Clips = { { 1.0, 0.0, 0.0, -12.0 } };
    }
    FrameOptions options;
    options.SpaceLeaping = step % 3 != 0;
    renderer.Render(this->Key, options);
    ASSERT_TRUE(ShowTheSame(renderer.LastFrame(), BlendedFrame(this->Key))) << step;
    const FrameStatistics& statistics = renderer.Statistics();
    EXPECT_EQ(statistics.Rays,
      statistics.DefiniteHits + statistics.DefiniteMisses + statistics.PossibleHits);
    if (statistics.Made == Route::KeepValues)
    {
      ++(statistics.TracedRays > 0 ? traced : notTraced);
    }
  }
  EXPECT_GT(traced, 8);
  EXPECT_GT(notTraced, 8);
}

INSTANTIATE_TEST_SUITE_P(
  Modes, ExtremeRoutes, ::testing::Values(BlendMode::Maximum, BlendMode::Minimum), NameOfMode);

TEST_P(BlendRoutes, VolumesAndSurfacesInTurn)
{
  SKIP_UNLESS_BLENDED(this->Key);
  FrameRenderer renderer;
  FrameKey surfaces = this->Key;
  surfaces.Shown.emplace<Surfaces>().Isovalues = { 150.0 };
  surfaces.Appearance.Colors = { { 1.0, 0.5, 0.2 } };
  surfaces.Appearance.Shade = true;
  for (int turn = 0; turn < 3; ++turn)
  {
    for (const FrameKey* key : { &this->Key, &surfaces })
    {
      renderer.Render(*key, {});
      EXPECT_TRUE(ShowTheSame(renderer.LastFrame(), BlendedFrame(*key))) << turn;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Modes, BlendRoutes, ::testing::ValuesIn(AllBlendModes), NameOfMode);

}
