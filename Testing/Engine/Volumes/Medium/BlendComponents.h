// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_BlendComponents_h
#define Testing_BlendComponents_h

#include "BlendCase.h"

#include <cstddef>
#include <cstdint>
#include <vector>

/// A volume of several components, which lie interleaved in memory.
class ComponentVolume
{
public:
  ComponentVolume(
    TemporalCoherence::BlendMode mode, int components, TemporalCoherence::ComponentUse use)
    : Volume(BlendSize)
    , Key(MakeBlendKey(Volume, mode, BlendLooks::Skin))
    , Samples(Volume.Samples.size() * static_cast<std::size_t>(components))
  {
    this->Key.Blended().Use = use;
    this->Key.Blended().Looks.clear();
    this->Key.Blended().ScalarRanges.clear();
    for (int c = 0; c < components; ++c)
    {
      this->FillComponent(c, components);
      TemporalCoherence::Field field = this->Volume.Field;
      field.Samples = this->Samples.data() + c;
      field.Strides = field.Strides * static_cast<std::int64_t>(components);
      if (c == 0)
      {
        this->Key.Samples = field;
      }
      else
      {
        this->Key.Blended().Others.push_back(field);
      }
      this->Key.Blended().ScalarRanges.push_back({ 10.0 * c, 255.0 - 20.0 * c });
      if (use == TemporalCoherence::ComponentUse::Independent || c == 0)
      {
        this->Key.Blended().Looks.push_back(this->LookOf(c));
      }
    }
  }
  // The key has pointers to the samples.
  ComponentVolume(const ComponentVolume&) = delete;
  void operator=(const ComponentVolume&) = delete;

private:
  /// Each component is the field from another end.
  void FillComponent(int c, int components)
  {
    const std::size_t count = this->Volume.Samples.size();
    for (std::size_t i = 0; i < count; ++i)
    {
      const int value = this->Volume.Samples[c % 2 == 0 ? i : count - 1 - i];
      this->Samples[i * static_cast<std::size_t>(components) + static_cast<std::size_t>(c)] =
        static_cast<std::uint8_t>(c < 2 ? value : 255 - value);
    }
  }

  TemporalCoherence::ComponentLook LookOf(int c) const
  {
    const std::vector<LookPoint>* const looks[] = { &BlendLooks::Skin, &BlendLooks::Valley,
      &BlendLooks::Peaks, &BlendLooks::Bone };
    const bool isSum = this->Key.Blended().Mode == TemporalCoherence::BlendMode::Additive;
    TemporalCoherence::ComponentLook look;
    look.Transfer = MakeTransfer(this->Volume.Range, *looks[c]);
    look.UnitDistance = isSum ? 40.0 : 1.0 + 0.5 * c;
    look.Material.Shade = c != 1;
    look.Weight = 1.0 - 0.3 * c;
    if (c == 2)
    {
      look.ByGradient.Nodes = { { 0.0, 0.2 }, { 20.0, 1.0 } };
    }
    return look;
  }

  BlendVolume<std::uint8_t> Volume;

public:
  TemporalCoherence::FrameKey Key;

private:
  std::vector<std::uint8_t> Samples;
};

#endif
