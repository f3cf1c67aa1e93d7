// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BlendComponents.h"
#include "BlendFrames.h"

namespace
{

using namespace TemporalCoherence;

/// Volumes of several components, in every mode.
class BlendComponents : public ::testing::TestWithParam<BlendMode>
{
};

TEST_P(BlendComponents, IndependentOnes)
{
  for (int components = 2; components <= 4; ++components)
  {
    const ComponentVolume volume(GetParam(), components, ComponentUse::Independent);
    SKIP_UNLESS_BLENDED(volume.Key);
    ExpectBlendTruth(volume.Key, 5);
  }
}

TEST_P(BlendComponents, ComponentsWithoutWeight)
{
  ComponentVolume volume(GetParam(), 3, ComponentUse::Independent);
  SKIP_UNLESS_BLENDED(volume.Key);
  volume.Key.Volume.Looks[1].Weight = 0.0;
  ExpectBlendTruth(volume.Key, 5);
}

TEST_P(BlendComponents, ColorAndOpacity)
{
  ComponentVolume volume(GetParam(), 2, ComponentUse::ColorOpacity);
  SKIP_UNLESS_BLENDED(volume.Key);
  ExpectBlendTruth(volume.Key, 5);
  volume.Key.Volume.Looks[0].ByGradient.Nodes = { { 0.0, 0.2 }, { 20.0, 1.0 } };
  ExpectBlendTruth(volume.Key, 5);
}

TEST_P(BlendComponents, RgbAndOpacity)
{
  ComponentVolume volume(GetParam(), 4, ComponentUse::RgbOpacity);
  SKIP_UNLESS_BLENDED(volume.Key);
  ExpectBlendTruth(volume.Key, 5);
  volume.Key.Volume.Looks[0].ByGradient.Nodes = { { 0.0, 0.2 }, { 20.0, 1.0 } };
  ExpectBlendTruth(volume.Key, 5);
}

TEST_P(BlendComponents, NearestInterpolation)
{
  for (const ComponentUse use : { ComponentUse::Independent, ComponentUse::ColorOpacity })
  {
    ComponentVolume volume(GetParam(), 2, use);
    volume.Key.Samples.Between = Interpolation::Nearest;
    volume.Key.Volume.Others[0].Between = Interpolation::Nearest;
    SKIP_UNLESS_BLENDED(volume.Key);
    ExpectBlendTruth(volume.Key, 5);
  }
}

INSTANTIATE_TEST_SUITE_P(Modes, BlendComponents, ::testing::ValuesIn(AllBlendModes), NameOfMode);

}
