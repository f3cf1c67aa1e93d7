// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BlendCase.h"
#include "BlendFrames.h"

#include <memory>
#include <string>

namespace
{

using namespace TemporalCoherence;

/// Volumes of several components, in every mode.
class BlendComponents : public ::testing::TestWithParam<BlendMode>
{
protected:
  /// Samples that lie interleaved in memory.
  void Make(int components, ComponentUse use)
  {
    const std::vector<LookPoint>* const looks[] = { &BlendLooks::Skin, &BlendLooks::Valley,
      &BlendLooks::Peaks, &BlendLooks::Bone };
    const BlendVolume<std::uint8_t> volume(BlendSize);
    this->Key = MakeBlendKey(volume, GetParam(), BlendLooks::Skin);
    this->Key.Volume.Use = use;
    this->Key.Volume.Looks.clear();
    this->Key.Volume.ScalarRanges.clear();
    const std::size_t count = volume.Samples.size();
    this->Samples.assign(count * static_cast<std::size_t>(components), 0);
    for (int c = 0; c < components; ++c)
    {
      for (std::size_t i = 0; i < count; ++i)
      {
        // Each component is the field from another end.
        const std::size_t from = c % 2 == 0 ? i : count - 1 - i;
        const int value = volume.Samples[from];
        this->Samples[i * static_cast<std::size_t>(components) + static_cast<std::size_t>(c)] =
          static_cast<std::uint8_t>(c < 2 ? value : 255 - value);
      }
      Field field = volume.Field;
      field.Samples = this->Samples.data() + c;
      field.Strides = field.Strides * static_cast<std::int64_t>(components);
      if (c == 0)
      {
        this->Key.Samples = field;
      }
      else
      {
        this->Key.Volume.Others.push_back(field);
      }
      this->Key.Volume.ScalarRanges.push_back({ 10.0 * c, 255.0 - 20.0 * c });
      if (use == ComponentUse::Independent || c == 0)
      {
        ComponentLook look;
        look.Transfer = MakeTransfer(volume.Range, *looks[c]);
        look.UnitDistance = GetParam() == BlendMode::Additive ? 40.0 : 1.0 + 0.5 * c;
        look.Material.Shade = c != 1;
        look.Weight = 1.0 - 0.3 * c;
        if (c == 2)
        {
          look.ByGradient.Nodes = { { 0.0, 0.2 }, { 20.0, 1.0 } };
        }
        this->Key.Volume.Looks.push_back(look);
      }
    }
  }

  std::vector<std::uint8_t> Samples;
  FrameKey Key;
};

TEST_P(BlendComponents, IndependentOnes)
{
  for (int components = 2; components <= 4; ++components)
  {
    this->Make(components, ComponentUse::Independent);
    SKIP_UNLESS_BLENDED(this->Key);
    ExpectBlendTruth(this->Key, 5);
  }
}

TEST_P(BlendComponents, ComponentsWithoutWeight)
{
  this->Make(3, ComponentUse::Independent);
  SKIP_UNLESS_BLENDED(this->Key);
  this->Key.Volume.Looks[1].Weight = 0.0;
  ExpectBlendTruth(this->Key, 5);
}

TEST_P(BlendComponents, ColorAndOpacity)
{
  this->Make(2, ComponentUse::ColorOpacity);
  SKIP_UNLESS_BLENDED(this->Key);
  ExpectBlendTruth(this->Key, 5);
  this->Key.Volume.Looks[0].ByGradient.Nodes = { { 0.0, 0.2 }, { 20.0, 1.0 } };
  ExpectBlendTruth(this->Key, 5);
}

TEST_P(BlendComponents, RgbAndOpacity)
{
  this->Make(4, ComponentUse::RgbOpacity);
  SKIP_UNLESS_BLENDED(this->Key);
  ExpectBlendTruth(this->Key, 5);
  this->Key.Volume.Looks[0].ByGradient.Nodes = { { 0.0, 0.2 }, { 20.0, 1.0 } };
  ExpectBlendTruth(this->Key, 5);
}

INSTANTIATE_TEST_SUITE_P(Modes, BlendComponents, ::testing::ValuesIn(AllBlendModes), NameOfMode);

}
