// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BlendCase.h"
#include "BlendFrames.h"
#include "SameFrames.h"

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
    this->Key.Volume.Looks[0].Material.Shade = true;
  }

  /// One change after the other, as users make them.
  void Change(int step)
  {
    ComponentLook& look = this->Key.Volume.Looks[0];
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
        this->Key.Volume.AverageRange.x += 3.0;
        this->Key.Volume.ScalarRanges[0].y -= 3.0;
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
    this->Key.Volume.Looks[0].Transfer = MakeTransfer(this->Volume.Range, *points);
    EXPECT_TRUE(ShowTheSame(BlendedFrame(this->Key), BlendedFrame(this->Key, plain)));
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

TEST_P(BlendRoutes, VolumesAndSurfacesInTurn)
{
  SKIP_UNLESS_BLENDED(this->Key);
  FrameRenderer renderer;
  FrameKey surfaces = this->Key;
  surfaces.Volume = Blending();
  surfaces.Isosurfaces.Isovalues = { 150.0 };
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
