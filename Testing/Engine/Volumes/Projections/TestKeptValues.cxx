// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// What the rays of a projection have met is kept: a picture in other colours is the cold one, to
// the last bit. A frame that is stopped changes nothing.

#include "EachTarget.h"
#include "Lattice/Coordinates.h"
#include "SameFrames.h"
#include "Volumes/Medium/BlendComponents.h"
#include "Volumes/Medium/BlendFrames.h"

#include <cmath>
#include <random>

namespace
{

using namespace TemporalCoherence;

class KeptValues : public ::testing::TestWithParam<BlendMode>
{
protected:
  /// Other colours, and what else does not change what rays meet.
  void Recolor(FrameKey& key)
  {
    for (ComponentLook& look : key.Blended().Looks)
    {
      const double red = this->Share(this->Random), green = this->Share(this->Random);
      for (glm::dvec4& node : look.Transfer.Nodes)
      {
        node = { red * node.y, node.z, green, node.w };
      }
      look.Weight = this->Share(this->Random);
      look.Material.Ambient = this->Share(this->Random);
      look.Material.Glow.y = this->Share(this->Random);
    }
    key.Appearance.ColorScale = 0.5 + this->Share(this->Random);
    key.Appearance.ColorShift = 0.2 * this->Share(this->Random);
  }

  /// The same, and other opacities.
  void ChangeOpacity(FrameKey& key)
  {
    for (ComponentLook& look : key.Blended().Looks)
    {
      const double first = 0.8 * this->Share(this->Random), last = 0.2 + this->Share(this->Random);
      const auto nodes = static_cast<double>(look.Transfer.Nodes.size() - 1);
      for (std::size_t i = 0; i < look.Transfer.Nodes.size(); ++i)
      {
        const double at = static_cast<double>(i) / nodes;
        look.Transfer.Nodes[i].w = at < first || at > last ? 0.0 : 0.9 * std::abs(at - first);
      }
    }
  }

  /// Change a volume again and again.
  void ExpectColdBytes(FrameKey key)
  {
    SKIP_UNLESS_BLENDED(key);
    key.View = LookAt(key.Samples.Dimensions, { 1.0, 2.0, 0.7 }, { 45, 38 });
    const bool isExtreme = GetParam() == BlendMode::Maximum || GetParam() == BlendMode::Minimum;
    FrameRenderer renderer;
    renderer.Render(key, {});
    for (int step = 0; step < 12; ++step)
    {
      this->Recolor(key);
      if (isExtreme && step % 3 != 0)
      {
        this->ChangeOpacity(key);
      }
      FrameOptions options;
      options.SpaceLeaping = step % 4 != 1;
      renderer.Render(key, options);
      EXPECT_EQ(renderer.Statistics().Made, Route::KeepValues) << step;
      EXPECT_TRUE(ShowTheSame(renderer.LastFrame(), BlendedFrame(key))) << step;
      EXPECT_TRUE(isExtreme || renderer.Statistics().TracedRays == 0) << step;
    }
  }

  std::mt19937 Random{ 5 };
  std::uniform_real_distribution<double> Share{ 0.0, 1.0 };
};

TEST_P(KeptValues, OneComponent)
{
  const BlendVolume<std::uint8_t> bytes(BlendSize);
  this->ExpectColdBytes(MakeBlendKey(bytes, GetParam(), BlendLooks::Skin));
  const BlendVolume<double> doubles(BlendSize, { 1e5, 1e5 + 3.0 });
  this->ExpectColdBytes(MakeBlendKey(doubles, GetParam(), BlendLooks::Skin));
}

TEST_P(KeptValues, SeveralComponents)
{
  for (int components = 2; components <= 4; ++components)
  {
    const ComponentVolume volume(GetParam(), components, ComponentUse::Independent);
    this->ExpectColdBytes(volume.Key);
  }
  const ComponentVolume two(GetParam(), 2, ComponentUse::ColorOpacity);
  this->ExpectColdBytes(two.Key);
  const ComponentVolume four(GetParam(), 4, ComponentUse::RgbOpacity);
  this->ExpectColdBytes(four.Key);
}

TEST_P(KeptValues, CellsOfAnyKind)
{
  const BlendVolume<std::int16_t> volume(BlendSize, { -1000.0, 3000.0 });
  const FrameKey key = MakeBlendKey(volume, GetParam(), BlendLooks::Skin);
  FrameKey other = key;
  other.Samples.Between = Interpolation::Nearest;
  this->ExpectColdBytes(other);
  other = key;
  other.Samples.Shape = RectilinearKind(Stretched(BlendSize, 4.0, 3));
  this->ExpectColdBytes(other);
  other = key;
  other.Blended().SampleDistance = 0.7;
  this->ExpectColdBytes(other);
}

TEST_P(KeptValues, PiecesOfRays)
{
  const BlendVolume<std::uint8_t> volume(BlendSize);
  FrameKey key = MakeBlendKey(volume, GetParam(), BlendLooks::Skin);
  key.Region.Clips = { { 1.0, 0.3, 0.0, -12.0 } };
  this->ExpectColdBytes(key);
  key.Region.Crops = { glm::dvec2(9.3, 30.1), glm::dvec2(8.0, 24.5), glm::dvec2(11.0, 40.0) };
  constexpr std::uint32_t inside = 1u << 13;
  key.Region.Boxes = Region::AllBoxes & ~inside;
  this->ExpectColdBytes(key);
}

TEST_P(KeptValues, EachKindOfVectors)
{
  const BlendVolume<std::uint8_t> volume(BlendSize);
  for (const std::int64_t target : VectorTarget::All())
  {
    const VectorTarget chosen(target);
    this->ExpectColdBytes(MakeBlendKey(volume, GetParam(), BlendLooks::Skin));
  }
}

TEST_P(KeptValues, AFrameThatIsStoppedChangesNothing)
{
  const BlendVolume<std::uint8_t> volume(BlendSize);
  FrameKey key = MakeBlendKey(volume, GetParam(), BlendLooks::Skin);
  FrameRenderer renderer;
  FrameOptions options;
  options.ReportsTiles = true;
  renderer.Render(key, options);
  const FrameKey first = key;
  this->Recolor(key);
  EXPECT_FALSE(renderer.Render(key, options, [](double) { return false; }));
  EXPECT_TRUE(ShowTheSame(renderer.LastFrame(), BlendedFrame(first)));
  EXPECT_TRUE(renderer.Render(key, options));
  EXPECT_EQ(renderer.Statistics().Made, Route::KeepValues);
  EXPECT_TRUE(ShowTheSame(renderer.LastFrame(), BlendedFrame(key)));
}

INSTANTIATE_TEST_SUITE_P(Modes, KeptValues,
  ::testing::Values(
    BlendMode::Maximum, BlendMode::Minimum, BlendMode::Average, BlendMode::Additive),
  NameOfMode);

}
