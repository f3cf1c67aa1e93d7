// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// A walk never begins in a cell whose nearer planes the ray passes only later.

#include "Lattice/CellWalk.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

using namespace TemporalCoherence;

/// Rays that run nearly along a plane between cells come to its other side by rounding, long before
/// they pass it. A walk that begins there would leave out what lies before the plane.
TEST(CellWalk, BeginsBehindNoPlaneThatIsStillAhead)
{
  constexpr double ulp = std::numeric_limits<double>::epsilon();
  constexpr int cells = 12;
  std::mt19937 engine(3);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  int roundedAcross = 0;
  for (int i = 0; i < 20000; ++i)
  {
    RayBatch rays;
    rays.Count = 1;
    for (std::size_t a = 0; a < 3; ++a)
    {
      const double plane = std::floor(share(engine) * (cells + 1));
      const double tilt = (share(engine) - 0.5) * std::pow(10.0, -18.0 * share(engine));
      rays.Origin[a][0] = plane + (share(engine) - 0.5) * 8.0 * ulp * plane;
      rays.Direction[a][0] = tilt;
      rays.Inverse[a][0] = 1.0 / tilt;
    }
    const BatchRay ray{ rays, 0 };
    const double t = 10.0 * share(engine);
    for (int axis = 0; axis < 3; ++axis)
    {
      const int behind = ray.Direction(axis) > 0.0 ? 0 : 1;
      const int cell = ray.WalkFrom(axis, t, cells);
      const bool isFirst = cell == (behind ? cells - 1 : 0);
      EXPECT_TRUE(isFirst || ray.Pass(axis, cell + behind) <= t)
        << "cell " << cell << ", direction " << ray.Direction(axis);
      const int rounded = ray.CellAt(axis, t, 0, cells - 1);
      roundedAcross += rounded != cell && ray.Pass(axis, rounded + behind) > t;
    }
  }
  EXPECT_GT(roundedAcross, 50) << "rounding is seen";
}
