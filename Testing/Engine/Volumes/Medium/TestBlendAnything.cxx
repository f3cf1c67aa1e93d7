// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Random volumes that nobody would choose: no pixel is more than 3/255 from the integral in double,
// and at most 0.1 % are more than 1/255.

#include "AnyBlending.h"
#include "BlendFrames.h"

#include <cstdlib>
#include <sstream>

namespace
{

/// The first and the last seed. The environment can ask for others, such as "1000 9999".
std::pair<unsigned int, unsigned int> Seeds()
{
  std::pair<unsigned int, unsigned int> seeds{ 20, 200 };
  if (const char* asked = std::getenv("TEMPORAL_COHERENCE_BLEND_SEEDS"))
  {
    std::istringstream(asked) >> seeds.first >> seeds.second;
  }
  return seeds;
}

/// How far the volume of a seed is from its integral: nowhere by more than 3/255.
BlendErrors ErrorsOf(unsigned int seed, bool hasLabels = false)
{
  const AnyBlending any(seed, hasLabels);
  const BlendErrors errors =
    CompareWithTruth(any.Key, BlendedFrame(any.Key), 3, any.Coordinates.get());
  EXPECT_EQ(errors.BeyondThree, 0)
    << "seed " << seed << ": the worst of " << errors.BeyondOne << ", by " << errors.Largest
    << ", is " << errors.Worst.x << ", " << errors.Worst.y << "; " << any.Story();
  return errors;
}

/// Volumes that nobody would choose look as their integrals.
TEST(BlendAnything, IsTheIntegral)
{
  const auto [first, last] = Seeds();
  int compared = 0, beyondOne = 0;
  for (unsigned int seed = first; seed <= last; ++seed)
  {
    const BlendErrors errors = ErrorsOf(seed);
    compared += errors.Compared;
    beyondOne += errors.BeyondOne;
  }
  EXPECT_LE(beyondOne * 1000, compared * PixelsForOne) << "of " << compared;
}

/// So do volumes whose parts have looks of their own.
TEST(BlendAnything, WithLabelsIsTheIntegral)
{
  const auto [first, last] = Seeds();
  int compared = 0, beyondOne = 0;
  for (unsigned int seed = first; seed <= last; ++seed)
  {
    const BlendErrors errors = ErrorsOf(seed, true);
    compared += errors.Compared;
    beyondOne += errors.BeyondOne;
  }
  EXPECT_LE(beyondOne * 1000, compared * PixelsForOne) << "of " << compared;
}

/// A ray that enters a cell at a peak of opacity 1 saw nothing behind it.
TEST(BlendAnything, PeaksAtFacesAreNoWalls)
{
  ErrorsOf(11066);
  ErrorsOf(11755);
  ErrorsOf(110, true);
  ErrorsOf(1711, true);
}

}
