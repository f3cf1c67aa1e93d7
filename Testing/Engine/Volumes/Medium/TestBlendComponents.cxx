// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Volumes of several components in every mode, with the errors that TestBlendModes allows.

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
  volume.Key.Blended().Looks[1].Weight = 0.0;
  ExpectBlendTruth(volume.Key, 5);
}

TEST_P(BlendComponents, ColorAndOpacity)
{
  ComponentVolume volume(GetParam(), 2, ComponentUse::ColorOpacity);
  SKIP_UNLESS_BLENDED(volume.Key);
  ExpectBlendTruth(volume.Key, 5);
  volume.Key.Blended().Looks[0].ByGradient.Nodes = { { 0.0, 0.2 }, { 20.0, 1.0 } };
  ExpectBlendTruth(volume.Key, 5);
}

TEST_P(BlendComponents, RgbAndOpacity)
{
  ComponentVolume volume(GetParam(), 4, ComponentUse::RgbOpacity);
  SKIP_UNLESS_BLENDED(volume.Key);
  ExpectBlendTruth(volume.Key, 5);
  volume.Key.Blended().Looks[0].ByGradient.Nodes = { { 0.0, 0.2 }, { 20.0, 1.0 } };
  ExpectBlendTruth(volume.Key, 5);
}

TEST_P(BlendComponents, NearestInterpolation)
{
  for (const ComponentUse use : { ComponentUse::Independent, ComponentUse::ColorOpacity })
  {
    ComponentVolume volume(GetParam(), 2, use);
    volume.Key.Samples.Between = Interpolation::Nearest;
    volume.Key.Blended().Others[0].Between = Interpolation::Nearest;
    SKIP_UNLESS_BLENDED(volume.Key);
    ExpectBlendTruth(volume.Key, 5);
  }
}

// Squares of extinctions leave the range of single precision there.
TEST_P(BlendComponents, TinyAndHugeWorlds)
{
  for (const double scale : { 1e-21, 1e21 })
  {
    ComponentVolume volume(GetParam(), 2, ComponentUse::Independent);
    SKIP_UNLESS_BLENDED(volume.Key);
    const glm::dmat4 world = glm::scale(glm::dmat4(1.0), glm::dvec3(scale));
    volume.Key.Transform = { world, glm::inverse(world) };
    for (ComponentLook& look : volume.Key.Blended().Looks)
    {
      look.UnitDistance *= scale;
    }
    const glm::dvec3 centre = 0.5 * scale * glm::dvec3(BlendSize - 1);
    const double radius = glm::length(centre);
    const glm::dvec3 eye = centre + 3.0 * radius * glm::normalize(glm::dvec3(1.0, 2.0, 0.7));
    ASSERT_TRUE(MakeView(glm::lookAt(eye, centre, glm::dvec3(0, 0, 1)),
      glm::perspective(0.7, 1.2, radius, 5.0 * radius), { radius, 5.0 * radius }, { 70, 58 },
      volume.Key.View));
    ExpectBlendTruth(volume.Key, 7);
  }
}

INSTANTIATE_TEST_SUITE_P(Modes, BlendComponents, ::testing::ValuesIn(AllBlendModes), NameOfMode);

}
