// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Blended volumes have the same bytes for any number of threads and on every kind of vectors.

#include "BlendComponents.h"
#include "BlendFrames.h"
#include "EachTarget.h"
#include "Lattice/Coordinates.h"
#include "SameFrames.h"

#include <vtkSMPTools.h>

#include <string>

namespace
{

using namespace TemporalCoherence;

/// During its lifetime, threads are those of a backend that starts as many as it is told.
class ManyThreads
{
public:
  ManyThreads()
    : Backend(vtkSMPTools::GetBackend())
  {
    vtkSMPTools::SetBackend("STDThread");
  }
  ~ManyThreads()
  {
    vtkSMPTools::Initialize(0);
    vtkSMPTools::SetBackend(this->Backend.c_str());
  }
  ManyThreads(const ManyThreads&) = delete;
  void operator=(const ManyThreads&) = delete;

  static void Set(int threads) { vtkSMPTools::Initialize(threads); }

private:
  std::string Backend;
};

/// The bytes of a picture depend neither on the number of threads nor on the kind of vectors.
class BlendBytes : public ::testing::TestWithParam<BlendMode>
{
public:
  /// A small picture: its rays are as different as those of a large one.
  static FrameKey Small(FrameKey key, const glm::ivec2& size = { 43, 37 })
  {
    key.View = LookAt(key.Samples.Dimensions, { 1.0, 2.0, 0.7 }, size);
    return key;
  }

  static void ExpectSameBytes(const FrameKey& key)
  {
    SKIP_UNLESS_BLENDED(key);
    const ManyThreads many;
    ManyThreads::Set(1);
    const Frame expected = BlendedFrame(key);
    for (const std::int64_t target : VectorTarget::All())
    {
      const VectorTarget chosen(target);
      EXPECT_TRUE(ShowTheSame(expected, BlendedFrame(key))) << hwy::TargetName(target);
    }
    for (const int threads : { 2, 7 })
    {
      ManyThreads::Set(threads);
      EXPECT_TRUE(ShowTheSame(expected, BlendedFrame(key))) << threads << " threads";
    }
  }

  /// One component of a type, lit or not, with each look.
  template <typename T>
  static void ExpectSameBytesOf(const glm::dvec2& range)
  {
    const BlendVolume<T> volume(BlendSize, range);
    for (const auto* points : { &BlendLooks::Skin, &BlendLooks::Peaks, &BlendLooks::OpaqueRanges })
    {
      for (const bool isShaded : { false, true })
      {
        FrameKey key = Small(MakeBlendKey(volume, GetParam(), *points));
        key.Blended().Looks[0].Material.Shade = isShaded;
        ExpectSameBytes(key);
      }
    }
  }
};

TEST_P(BlendBytes, OfBytes)
{
  ExpectSameBytesOf<std::uint8_t>({ 0.0, 255.0 });
}

TEST_P(BlendBytes, OfShorts)
{
  ExpectSameBytesOf<std::int16_t>({ -1000.0, 3000.0 });
}

TEST_P(BlendBytes, OfFloats)
{
  ExpectSameBytesOf<float>({ -0.3, 0.7 });
}

TEST_P(BlendBytes, OfDoubles)
{
  ExpectSameBytesOf<double>({ 1e5, 1e5 + 3.0 });
}

TEST_P(BlendBytes, GradientOpacity)
{
  const BlendVolume<std::uint8_t> volume(BlendSize);
  FrameKey key = Small(MakeBlendKey(volume, GetParam(), BlendLooks::Skin));
  key.Blended().Looks[0].Material.Shade = true;
  key.Blended().Looks[0].ByGradient.Nodes = { { 0.0, 0.2 }, { 20.0, 1.0 } };
  ExpectSameBytes(key);
}

/// Tiles that go as beams, in a part of a view.
TEST(BlendBeamBytes, OfAnyTypeAndLight)
{
  const auto expectOf = [](auto type, const glm::dvec2& range)
  {
    const BlendVolume<decltype(type)> volume(BlendSize, range);
    for (const auto* points : { &BlendLooks::Skin, &BlendLooks::Peaks, &BlendLooks::Bone })
    {
      FrameKey key = MakeBlendKey(volume, BlendMode::Composite, *points);
      key.View = LookAt(key.Samples.Dimensions, { 1.0, 2.0, 0.7 }, { 200, 184 });
      BlendBytes::ExpectSameBytes(key);
      key.Blended().Looks[0].Material.Shade = true;
      BlendBytes::ExpectSameBytes(key);
      key.Blended().Looks[0].Material.Specular = 0.5;
      key.Appearance.Lights[0].Diffuse = { 1.0, 0.5, 0.7 };
      BlendBytes::ExpectSameBytes(key);
    }
  };
  expectOf(std::uint8_t(), { 0.0, 255.0 });
  if (!IsMemorySanitized)
  {
    expectOf(std::int16_t(), { -1000.0, 3000.0 });
    expectOf(float(), { -0.3, 0.7 });
  }
}

TEST_P(BlendBytes, SamplesAtADistance)
{
  const BlendVolume<std::uint8_t> volume(BlendSize);
  FrameKey key = Small(MakeBlendKey(volume, GetParam(), BlendLooks::Skin));
  key.Blended().Looks[0].Material.Shade = true;
  key.Blended().SampleDistance = 0.7;
  ExpectSameBytes(key);
}

TEST_P(BlendBytes, CellsOfAnyKind)
{
  const BlendVolume<std::int16_t> volume(BlendSize, { -1000.0, 3000.0 });
  FrameKey key = Small(MakeBlendKey(volume, GetParam(), BlendLooks::Skin));
  key.Blended().Looks[0].Material.Shade = true;
  FrameKey other = key;
  other.Samples.Between = Interpolation::Nearest;
  ExpectSameBytes(other);
  other = key;
  other.Samples.Shape = RectilinearKind(Stretched(BlendSize, 4.0, 3));
  ExpectSameBytes(other);
  other = key;
  other.Region.Clips = { { 1.0, 0.3, 0.0, -12.0 } };
  ExpectSameBytes(other);
}

TEST_P(BlendBytes, SeveralComponents)
{
  for (int components = 2; components <= 4; ++components)
  {
    const ComponentVolume volume(GetParam(), components, ComponentUse::Independent);
    ExpectSameBytes(Small(volume.Key));
  }
  const ComponentVolume two(GetParam(), 2, ComponentUse::ColorOpacity);
  ExpectSameBytes(Small(two.Key));
  const ComponentVolume four(GetParam(), 4, ComponentUse::RgbOpacity);
  ExpectSameBytes(Small(four.Key));
}

INSTANTIATE_TEST_SUITE_P(Modes, BlendBytes, ::testing::ValuesIn(AllBlendModes), NameOfMode);

}
