// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// View files with random changes are read, or refused with a sentence. Nothing crashes, memory
// stays bounded, and what can be read can be looked up.

#include "../VolumeFiles/Mutations.h"
#include "Checks/ProcessMemory.h"
#include "Checks/Sanitized.h"
#include "ViewFile/ViewLookUp.h"
#include "ViewMutator.h"
#include "ViewTesting.h"

#include <iostream>

namespace
{

using namespace TemporalCoherence;

constexpr int UsualMutations = 12000;

/// Look up isovalues of all views, and what is none.
void LookUpAll(const LoadedViews& views)
{
  constexpr int mostPixels = 1 << 16;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Frame frame;
  for (std::size_t view = 0; view < views.Knots.size(); ++view)
  {
    const KnotImage& knots = views.Knots[view];
    const ValueBand& range = knots.Values;
    if (knots.Size.x * knots.Size.y > mostPixels)
    {
      continue;
    }
    for (const double isovalue :
      { range.Low, 0.5 * (range.Low + range.High), range.High, 1e300, nan })
    {
      LookUpView(views.Header.Views[view].Geometry, knots, isovalue, frame);
    }
  }
}

TEST(ViewMutations, AreReadOrRefused)
{
  ViewMutator mutator(MakeFile());
  int refused = 0, damaged = 0;
  const int count = NumberOfMutations(UsualMutations);
  const double before = ProcessMemory::Resident();
  const bool isMeasured = !IsMemorySanitized && ProcessMemory::ResetPeak();
  for (int i = 0; i < count; ++i)
  {
    LoadedViews views;
    const std::string error = ReadViews(mutator.Make(static_cast<unsigned>(i)), views);
    if (error.empty())
    {
      LookUpAll(views);
      continue;
    }
    ASSERT_EQ(error.back(), '.') << i << error;
    ++refused;
    damaged += error.find("a knot is impossible") != std::string::npos;
  }
  // All levels are reached.
  EXPECT_GT(refused, count / 4);
  EXPECT_LT(refused, count);
  EXPECT_GT(damaged, count / 100);
  // Tables of 2^26 pixels, which few bytes may ask for.
  const double grown = ProcessMemory::Peak() - before;
  EXPECT_FALSE(isMeasured && grown > 2e9);
  std::cout << count << " mutations: " << refused << " refused, " << damaged
            << " of them in a chunk, " << grown << " bytes of memory\n";
}

}
