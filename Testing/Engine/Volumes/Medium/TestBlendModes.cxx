// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Blended volumes of every mode, look and type: at most 0.1 % of the pixels are more than 1/255
// from the integral in double, and none is more than 3/255.

#include "BlendCase.h"
#include "BlendFrames.h"

#include <ostream>
#include <string>
#include <tuple>

namespace
{

using namespace TemporalCoherence;

using Points = const std::vector<LookPoint>*;

struct NamedLook
{
  const char* Name;
  Points Look;
};

void PrintTo(const NamedLook& look, std::ostream* to)
{
  *to << look.Name;
}

const NamedLook Looks[] = { { "Bone", &BlendLooks::Bone }, { "Skin", &BlendLooks::Skin },
  { "Peaks", &BlendLooks::Peaks }, { "Step", &BlendLooks::Step }, { "Fog", &BlendLooks::Fog } };

/// Every mode with every look, for the types of samples that are computed with apart.
class BlendModes : public ::testing::TestWithParam<std::tuple<BlendMode, NamedLook, bool>>
{
protected:
  template <typename T>
  void Check(const glm::dvec2& range)
  {
    const auto& [mode, look, isShaded] = GetParam();
    const BlendVolume<T> volume(BlendSize, range);
    FrameKey key = MakeBlendKey(volume, mode, *look.Look);
    key.Blended().Looks[0].Material.Shade = isShaded;
    key.Blended().Looks[0].UnitDistance = mode == BlendMode::Additive ? 30.0 : 1.3;
    SKIP_UNLESS_BLENDED(key);
    ExpectBlendTruth(key, 5);
  }
};

TEST_P(BlendModes, OfBytes)
{
  this->Check<std::uint8_t>({ 0.0, 255.0 });
}

TEST_P(BlendModes, OfShorts)
{
  this->Check<std::int16_t>({ -1000.0, 3000.0 });
}

TEST_P(BlendModes, OfFloats)
{
  this->Check<float>({ -0.3, 0.7 });
}

TEST_P(BlendModes, OfDoubles)
{
  this->Check<double>({ 1e5, 1e5 + 3.0 });
}

std::string NameOfCase(const ::testing::TestParamInfo<BlendModes::ParamType>& info)
{
  const auto& [mode, look, isShaded] = info.param;
  return NameOf(mode) + look.Name + (isShaded ? "Shaded" : "");
}

INSTANTIATE_TEST_SUITE_P(Composite, BlendModes,
  ::testing::Combine(
    ::testing::Values(BlendMode::Composite), ::testing::ValuesIn(Looks), ::testing::Bool()),
  NameOfCase);

// Only composite volumes are lit: the material must not matter.
INSTANTIATE_TEST_SUITE_P(Projections, BlendModes,
  ::testing::Combine(::testing::Values(BlendMode::Maximum, BlendMode::Minimum, BlendMode::Average,
                       BlendMode::Additive),
    ::testing::Values(Looks[1], Looks[3], Looks[4]), ::testing::Bool()),
  NameOfCase);

}
