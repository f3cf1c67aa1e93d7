// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Composite volumes with any lights, materials, gradient opacities and opaque ranges, with the
// errors that TestBlendModes allows.

#include "BlendCase.h"
#include "BlendFrames.h"

#include <algorithm>
#include <random>

namespace
{

using namespace TemporalCoherence;

/// How a composite volume looks: light, gradients, opacities.
class BlendLook : public ::testing::Test
{
protected:
  BlendLook()
    : Volume(BlendSize)
    , Key(MakeBlendKey(Volume, BlendMode::Composite, BlendLooks::Skin))
  {
    this->Of().Material.Shade = true;
  }

  ComponentLook& Of() { return this->Key.Blended().Looks[0]; }
  void Take(const std::vector<LookPoint>& points, std::size_t nodes = 4097)
  {
    this->Of().Transfer = MakeTransfer(this->Volume.Range, points, nodes);
  }

  BlendVolume<std::uint8_t> Volume;
  FrameKey Key;
};

TEST_F(BlendLook, SeveralLights)
{
  SKIP_UNLESS_BLENDED(this->Key);
  Light spot;
  spot.Positional = true;
  spot.Position = { 60.0, 70.0, 50.0 };
  spot.Direction = glm::normalize(glm::dvec3(-1.0, -1.2, -0.7));
  spot.ConeAngle = 25.0;
  spot.Exponent = 3.0;
  spot.Diffuse = { 1.5, 0.3, 0.9 };
  spot.Attenuation = { 0.2, 0.01, 1e-4 };
  Light lamp;
  lamp.Positional = true;
  lamp.Position = { 20.0, 18.0, 22.0 };
  lamp.Specular = { 0.0, 1.0, 0.0 };
  lamp.Attenuation = { 0.0, 0.1, 0.0 };
  this->Key.Appearance.Lights.push_back(spot);
  this->Key.Appearance.Lights.push_back(lamp);
  ExpectBlendTruth(this->Key);
  this->Take(BlendLooks::Step);
  ExpectBlendTruth(this->Key);
}

TEST_F(BlendLook, LightFromBehind)
{
  SKIP_UNLESS_BLENDED(this->Key);
  this->Key.Appearance.Lights[0].Direction = glm::normalize(glm::dvec3(1.0, 1.7, 0.9));
  for (const bool isTwoSided : { true, false })
  {
    this->Key.Appearance.TwoSided = isTwoSided;
    this->Take(BlendLooks::Fog);
    ExpectBlendTruth(this->Key);
    this->Take(BlendLooks::Step);
    ExpectBlendTruth(this->Key);
  }
}

TEST_F(BlendLook, OneSidedLightingLeavesInsidesDark)
{
  SKIP_UNLESS_BLENDED(this->Key);
  this->Key.Appearance.TwoSided = false;
  for (const auto* points : { &BlendLooks::Valley, &BlendLooks::Peaks, &BlendLooks::Bone })
  {
    this->Take(*points);
    ExpectBlendTruth(this->Key);
  }
}

TEST_F(BlendLook, HighlightsOfAnyPower)
{
  SKIP_UNLESS_BLENDED(this->Key);
  this->Take(BlendLooks::Step);
  for (const double power : { 0.0, 0.7, 1.0, 13.5, 40.0 })
  {
    this->Of().Material.Specular = 0.9;
    this->Of().Material.SpecularPower = power;
    ExpectBlendTruth(this->Key, 5);
  }
}

TEST_F(BlendLook, BrightColorsAreClampedWhereTheyAre)
{
  SKIP_UNLESS_BLENDED(this->Key);
  this->Of().Material.Ambient = 1.0;
  this->Of().Material.Diffuse = 1.0;
  this->Of().Material.Specular = 1.0;
  ExpectBlendTruth(this->Key);
}

TEST_F(BlendLook, ColoredAmbientLight)
{
  SKIP_UNLESS_BLENDED(this->Key);
  this->Of().Material.Ambient = 0.0;
  this->Of().Material.Glow = { 0.05, 0.4, 0.9 };
  ExpectBlendTruth(this->Key);
}

TEST_F(BlendLook, NoLights)
{
  SKIP_UNLESS_BLENDED(this->Key);
  this->Key.Appearance.Lights.clear();
  this->Of().Material.Ambient = 0.6;
  ExpectBlendTruth(this->Key);
}

TEST_F(BlendLook, GradientOpacity)
{
  SKIP_UNLESS_BLENDED(this->Key);
  for (const bool isShaded : { false, true })
  {
    this->Of().Material.Shade = isShaded;
    this->Of().ByGradient.Nodes = { { 2.0, 0.0 }, { 6.0, 0.3 }, { 25.0, 1.0 } };
    this->Take(BlendLooks::Skin);
    ExpectBlendTruth(this->Key);
    this->Take(BlendLooks::Peaks);
    ExpectBlendTruth(this->Key);
    // Nearly a step, and opaque values.
    this->Of().ByGradient.Nodes = { { 10.0, 0.0 }, { 10.01, 1.0 } };
    this->Take(BlendLooks::Step);
    ExpectBlendTruth(this->Key);
  }
}

/// Where colours jump or turn and opacity does not, it counts which of them a step emits first.
TEST_F(BlendLook, ColorsThatJump)
{
  SKIP_UNLESS_BLENDED(this->Key);
  for (const double width : { 1e-9, 0.02 })
  {
    for (const double opacity : { 0.05, 0.3, 0.7 })
    {
      const glm::dvec4 red{ 1.0, 0.0, 0.0, opacity }, cyan{ 0.0, 1.0, 1.0, opacity };
      for (const bool isShell : { false, true })
      {
        const double outside = isShell ? 0.0 : 1.0;
        const glm::dvec4 keep{ 1.0, 1.0, 1.0, outside };
        this->Take({ { 0.0, keep * red }, { 0.45, keep * red }, { 0.45 + 1e-9, red }, { 0.5, red },
                     { 0.5 + width, cyan }, { 0.56, cyan }, { 0.56 + 1e-9, keep * cyan },
                     { 1.0, keep * cyan } },
          16385);
        for (const bool isShaded : { false, true })
        {
          this->Of().Material.Shade = isShaded;
          SCOPED_TRACE(testing::Message()
            << "opacity " << opacity << ", width " << width << (isShell ? ", a shell" : "")
            << (isShaded ? ", lit" : ""));
          ExpectBlendTruth(this->Key, 5);
        }
      }
    }
  }
}

/// A function that bends to one side in every cell of a long path: what each cell misses adds up.
TEST_F(BlendLook, ThinFogInLongNoise)
{
  SKIP_UNLESS_BLENDED(this->Key);
  constexpr glm::dvec4 none{ 1.0, 1.0, 1.0, 0.0 }, much{ 1.0, 1.0, 1.0, 0.006 };
  const std::vector<LookPoint> fromNothing{ { 0.0, none }, { 0.5, none }, { 1.0, much } };
  const std::vector<LookPoint> fromLittle{ { 0.0, { 1.0, 1.0, 1.0, 0.001 } },
    { 0.5, { 1.0, 1.0, 1.0, 0.002 } }, { 1.0, much } };
  BlendVolume<float> noise({ 181, 175, 190 });
  std::mt19937 random(1);
  std::uniform_real_distribution<> values(0.0, 255.0);
  noise.Fill([&](int, int, int) { return values(random); });
  FrameKey key = MakeBlendKey(noise, BlendMode::Composite, fromNothing);
  key.View = LookAt(key.Samples.Dimensions, { 1.0, 2.0, 0.7 }, { 500, 500 });
  for (const auto* look : { &fromNothing, &fromLittle })
  {
    for (const double unit : { 1.5, 4.0 })
    {
      key.Blended().Looks[0].Transfer = MakeTransfer(this->Volume.Range, *look);
      key.Blended().Looks[0].UnitDistance = unit;
      const BlendErrors errors = CompareWithTruth(key, BlendedFrame(key), 833);
      EXPECT_LE(errors.Largest, 2.0);
    }
  }
}

/// Values from 0 to 3000, but for noise.
class NoisyLook : public BlendLook
{
protected:
  NoisyLook()
    : Noisy(BlendSize, { 0.0, 3000.0 })
  {
    this->Key.Samples = this->Noisy.Field;
  }

  /// \param most noise
  void AddNoise(int most)
  {
    std::minstd_rand random(5);
    std::uniform_int_distribution<int> noise(-most, most);
    for (std::int16_t& sample : this->Noisy.Samples)
    {
      sample = static_cast<std::int16_t>(sample + noise(random));
    }
  }

  BlendVolume<std::int16_t> Noisy;
};

// A ray passes the whole range within a small part of a cell.
TEST_F(NoisyLook, OpaqueRangesHideWhatIsBehind)
{
  SKIP_UNLESS_BLENDED(this->Key);
  this->AddNoise(500);
  for (const bool isShaded : { false, true })
  {
    this->Of().Material.Shade = isShaded;
    this->Of().Transfer = MakeTransfer(this->Noisy.Range, BlendLooks::OpaqueRanges, 65537);
    ExpectBlendTruth(this->Key, 2);
  }
}

// Where a field only touches its least or largest value, it is not opaque; where it stays there,
// it is.
TEST_F(NoisyLook, OpaqueEndsThatAreTouched)
{
  SKIP_UNLESS_BLENDED(this->Key);
  this->AddNoise(400);
  for (std::int16_t& sample : this->Noisy.Samples)
  {
    sample = static_cast<std::int16_t>(std::clamp<int>(sample, 600, 2400));
  }
  // Light would change at once where gradients begin.
  this->Of().Material.Shade = false;
  for (const std::size_t nodes : { std::size_t(4), std::size_t(256), std::size_t(65537) })
  {
    this->Of().Transfer = MakeTransfer({ 600.0, 2400.0 }, BlendLooks::OpaqueEnds, nodes);
    ExpectBlendTruth(this->Key, 2);
  }
}

// A peak may be reached between the ends of a cell alone, where normals turn in noise.
TEST_F(NoisyLook, Peaks)
{
  this->AddNoise(300);
  SKIP_UNLESS_BLENDED(this->Key);
  this->Of().Transfer = MakeTransfer(this->Noisy.Range, BlendLooks::Peaks);
  ExpectBlendTruth(this->Key, 1);
}

TEST_F(BlendLook, ShortAndLongUnitDistances)
{
  SKIP_UNLESS_BLENDED(this->Key);
  for (const double unit : { 0.01, 0.2, 5.0, 100.0 })
  {
    this->Of().UnitDistance = unit;
    this->Take(unit > 50.0 ? BlendLooks::Bone : BlendLooks::Skin);
    ExpectBlendTruth(this->Key, 5);
  }
}

TEST_F(BlendLook, FewAndManyNodes)
{
  SKIP_UNLESS_BLENDED(this->Key);
  for (const std::size_t nodes : { std::size_t(2), std::size_t(3), std::size_t(100001) })
  {
    this->Take(nodes == 2 ? BlendLooks::Fog : BlendLooks::Peaks, nodes);
    if (nodes == 3)
    {
      this->Take(BlendLooks::Bone, nodes);
    }
    ExpectBlendTruth(this->Key, 5);
  }
}

TEST_F(BlendLook, ConstantVolumes)
{
  SKIP_UNLESS_BLENDED(this->Key);
  this->Of().UnitDistance = 20.0;
  for (const int value : { 0, 100, 170, 255 })
  {
    this->Volume.Fill([&](int, int, int) { return value; });
    ++this->Key.Samples.Stamp;
    this->Take(BlendLooks::Fog);
    ExpectBlendTruth(this->Key, 7);
  }
}

TEST_F(BlendLook, ValuesOnNodes)
{
  // Whole faces of samples lie where opacity jumps.
  this->Volume.Fill(
    [](int i, int j, int k) { return i < 6 ? 200
                                : i > 20   ? 128
                                           : (j + k) % 9 * 16; });
  this->Key.Samples = this->Volume.Field;
  SKIP_UNLESS_BLENDED(this->Key);
  this->Volume.Range = { 0.0, 256.0 };
  this->Take(BlendLooks::Step, 257);
  ExpectBlendTruth(this->Key);
}

}
