// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BlendFrames.h"
#include "Grid.h"

#include <cmath>

namespace
{

using namespace TemporalCoherence;

/// A small ball in a field of which nothing else has an opacity.
class BlendShares : public ::testing::Test
{
protected:
  BlendShares()
    : Samples(glm::ivec3(50, 40, 45))
  {
    this->Samples.Fill([](int i, int j, int k)
      { return std::max(0.0, 100.0 - 12.0 * glm::length(glm::dvec3(i - 12, j - 14, k - 33))); });
    this->Key.Samples = this->Samples.Field;
    this->Key.View = LookAt(this->Samples.Field.Dimensions, { 1.0, 2.0, 0.7 }, { 60, 50 });
    ComponentLook look;
    look.Transfer = { { 0.0, 100.0 },
      { glm::dvec4(0.0), glm::dvec4(0.0), glm::dvec4(0.4), glm::dvec4(0.9) } };
    look.UnitDistance = 9.0;
    this->Key.Volume.Looks = { look };
    this->Key.Volume.ScalarRanges = { { 0.0, 100.0 } };
  }

  BlendErrors Errors() const { return CompareWithTruth(this->Key, BlendedFrame(this->Key), 1); }

  Grid<std::uint8_t> Samples;
  FrameKey Key;
};

TEST_F(BlendShares, ASumOfNothingIsBlack)
{
  this->Key.Volume.Mode = BlendMode::Additive;
  const BlendErrors errors = this->Errors();
  EXPECT_LT(errors.Largest, 1.0);
  EXPECT_GT(errors.Seen * PixelsForOne, 500);
}

TEST_F(BlendShares, AnAverageOfNothingIsNotSeen)
{
  this->Key.Volume.Mode = BlendMode::Average;
  this->Key.Volume.AverageRange = { 30.5, 80.0 };
  const BlendErrors errors = this->Errors();
  EXPECT_LT(errors.Largest, 1.0);
  EXPECT_GT(errors.Seen * PixelsForOne, 20);
  EXPECT_LT(errors.Seen, 500);
}

}
