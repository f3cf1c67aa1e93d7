// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// A sum of nothing is black, and an average of nothing is not seen, also where interpolated values
// are rounded into its range.

#include "Grid.h"
#include "Lattice/Coordinates.h"
#include "Volumes/Medium/BlendFrames.h"

#include <algorithm>
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
    this->Key.Shown.emplace<Blending>().Looks = { look };
    this->Key.Blended().ScalarRanges = { { 0.0, 100.0 } };
  }

  BlendErrors Errors() const { return CompareWithTruth(this->Key, BlendedFrame(this->Key), 1); }

  Grid<std::uint8_t> Samples;
  FrameKey Key;
};

TEST_F(BlendShares, ASumOfNothingIsBlack)
{
  this->Key.Blended().Mode = BlendMode::Additive;
  const BlendErrors errors = this->Errors();
  EXPECT_LT(errors.Largest, 1.0);
  EXPECT_GT(errors.Seen * PixelsForOne, 500);
}

TEST_F(BlendShares, AnAverageOfNothingIsNotSeen)
{
  this->Key.Blended().Mode = BlendMode::Average;
  this->Key.Blended().AverageRange = { 30.5, 80.0 };
  const BlendErrors errors = this->Errors();
  EXPECT_LT(errors.Largest, 1.0);
  EXPECT_GT(errors.Seen * PixelsForOne, 20);
  EXPECT_LT(errors.Seen, 500);
}

/// Where no sample lies in the range of an average, nothing is seen, though interpolated values may
/// be rounded into it: from far away beside a sample that is far away from all others.
TEST_F(BlendShares, AnAverageOfValuesRoundedIntoItsRangeIsNotSeen)
{
  Grid<double> samples({ 12, 10, 11 });
  const auto coordinates = Stretched(samples.Field.Dimensions, 3.0, 7);
  this->Key.View = LookAt(samples.Field.Dimensions, { 1.0, 2.0, 0.7 }, { 60, 50 });
  this->Key.Blended().Mode = BlendMode::Average;
  const auto expectNothing = [&](const char* which)
  {
    for (const bool leaps : { true, false })
    {
      FrameOptions options;
      options.SpaceLeaping = leaps;
      const Frame frame = BlendedFrame(this->Key, options);
      const auto seen = std::count_if(
        frame.Colors.begin(), frame.Colors.end(), [](const auto& color) { return color[3] != 0; });
      EXPECT_EQ(seen, 0) << which << ", leaping " << leaps;
    }
  };
  const auto expectNothingOfAll = [&]
  {
    this->Key.Samples = samples.Field;
    this->Key.Blended().SampleDistance = 0.0;
    expectNothing("an image");
    this->Key.Samples.Shape = RectilinearKind(coordinates);
    expectNothing("a grid");
    this->Key.Blended().SampleDistance = 0.1;
    expectNothing("a grid, samples at a distance");
  };
  samples.Fill(
    [](int i, int j, int k) { return (i + 2 * j + 3 * k) % 5 == 0 ? -9e18 : 30.0 + (i + j) % 7; });
  this->Key.Blended().AverageRange = { 37.0, 48.0 };
  expectNothingOfAll();
  samples.Fill([](int, int, int) { return 30.1; });
  this->Key.Blended().AverageRange = { std::nextafter(30.1, 31.0), 48.0 };
  expectNothingOfAll();
}

}
