// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// The crossing in a cell is the first change of side of the trilinear interpolant along a path, for
// values of any magnitude, in single and double precision. On a face, both of its cells compute the
// same bits.

#include "Lattice/CellRoot.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace
{

using namespace TemporalCoherence;

template <typename Real>
Real Trilinear(const Corners<Real>& v, const std::array<Real, 3>& p)
{
  return CubicAlong(v, CellPath<Real>{ p, p })[0];
}

template <typename Real>
std::array<Real, 3> PointAt(const CellPath<Real>& path, Real s)
{
  return { Mix(path.Begin[0], path.End[0], s), Mix(path.Begin[1], path.End[1], s),
    Mix(path.Begin[2], path.End[2], s) };
}

class RandomCells
{
public:
  Corners<double> NextCorners(bool integers)
  {
    Corners<double> v;
    for (double& value : v)
    {
      value = integers ? std::floor(5.0 * this->Uniform(this->Engine)) - 2.0
                       : 2.0 * this->Uniform(this->Engine) - 1.0;
    }
    return v;
  }
  CellPath<double> NextPath()
  {
    CellPath<double> path;
    for (std::size_t a = 0; a < 3; ++a)
    {
      path.Begin[a] = this->Uniform(this->Engine);
      path.End[a] = this->Uniform(this->Engine);
    }
    return path;
  }

private:
  std::mt19937 Engine{ 7 };
  std::uniform_real_distribution<double> Uniform{ 0.0, 1.0 };
};

/// First change of side among many samples of the interpolant itself.
bool FirstCrossingBySampling(
  const Corners<double>& v, const CellPath<double>& path, int samples, double& s)
{
  const bool begin = IsInside(Trilinear(v, path.Begin));
  for (int i = 1; i <= samples; ++i)
  {
    s = static_cast<double>(i) / samples;
    if (IsInside(Trilinear(v, PointAt(path, s))) != begin)
    {
      return true;
    }
  }
  return false;
}

TEST(CellRoot, CubicIsTheInterpolantAlongThePath)
{
  RandomCells cells;
  for (int trial = 0; trial < 1000; ++trial)
  {
    const Corners<double> v = cells.NextCorners(false);
    const CellPath<double> path = cells.NextPath();
    const Cubic<double> cubic = CubicAlong(v, path);
    for (const double s : { 0.0, 0.2, 0.5, 0.9, 1.0 })
    {
      EXPECT_NEAR(Evaluate(cubic, s), Trilinear(v, PointAt(path, s)), 1e-14);
    }
  }
}

TEST(CellRoot, FirstCrossingIsThatOfDenseSampling)
{
  constexpr int Samples = 4000;
  RandomCells cells;
  int found = 0, doubles = 0;
  for (int trial = 0; trial < 4000; ++trial)
  {
    const Corners<double> v = cells.NextCorners(false);
    const CellPath<double> path = cells.NextPath();
    double sampled, s;
    const bool expected = FirstCrossingBySampling(v, path, Samples, sampled);
    const bool got = FirstCrossing(CubicAlong(v, path), s);
    if (expected)
    {
      ASSERT_TRUE(got) << trial;
      ASSERT_LE(s, sampled + 1e-9) << trial;
      // Sampling may jump over an earlier pair of crossings, never over a later one.
      if (sampled - s > 1.0 / Samples + 1e-9)
      {
        EXPECT_NEAR(Trilinear(v, PointAt(path, s)), 0.0, 1e-6) << trial;
      }
      ++found;
      doubles += IsInside(Trilinear(v, path.Begin)) == IsInside(Trilinear(v, path.End));
    }
    else if (got)
    {
      // A pair of crossings closer than the samples: the interpolant must touch zero there.
      EXPECT_NEAR(Trilinear(v, PointAt(path, s)), 0.0, 1e-6) << trial;
    }
  }
  EXPECT_GT(found, 500);
  EXPECT_GT(doubles, 20) << "no double crossing was tried";
}

/// Neither squares that are infinite nor squares that are 0 hide a pair of crossings.
TEST(CellRoot, AnyMagnitudeOfValues)
{
  RandomCells cells;
  int several = 0;
  for (int trial = 0; trial < 2000; ++trial)
  {
    const Corners<double> v = cells.NextCorners(false);
    const CellPath<double> path = cells.NextPath();
    const auto crossingsOf = [&](int exponent)
    {
      Corners<double> scaled;
      for (std::size_t i = 0; i < 8; ++i)
      {
        scaled[i] = std::ldexp(v[i], exponent);
      }
      std::vector<double> crossings;
      VisitCrossings(CubicAlong(scaled, path),
        [&](double s)
        {
          crossings.push_back(s);
          return false;
        });
      return crossings;
    };
    const std::vector<double> expected = crossingsOf(0);
    several += expected.size() > 1;
    for (const int exponent : { -900, -600, 600, 1000 })
    {
      ASSERT_EQ(crossingsOf(exponent), expected) << trial << ", 2^" << exponent;
    }
  }
  EXPECT_GT(several, 20) << "no double crossing was tried";
}

TEST(CellRoot, SingleAndDoublePrecisionAgree)
{
  RandomCells cells;
  for (int trial = 0; trial < 4000; ++trial)
  {
    const Corners<double> v = cells.NextCorners(false);
    const CellPath<double> path = cells.NextPath();
    Corners<float> vf;
    CellPath<float> pathf;
    std::copy(v.begin(), v.end(), vf.begin());
    std::copy(path.Begin.begin(), path.Begin.end(), pathf.Begin.begin());
    std::copy(path.End.begin(), path.End.end(), pathf.End.begin());
    double s;
    float sf;
    const bool inDouble = FirstCrossing(CubicAlong(v, path), s);
    const bool inFloat = FirstCrossing(CubicAlong(vf, pathf), sf);
    if (inDouble && inFloat)
    {
      EXPECT_NEAR(Trilinear(v, PointAt(path, static_cast<double>(sf))), 0.0, 2e-6);
    }
    else
    {
      EXPECT_EQ(inDouble, inFloat) << trial;
    }
  }
}

TEST(CellRoot, RootsAtTheEndsDoNotHideTheCrossing)
{
  // Zero at the begin, then inside, then outside from 1/2: coefficients of s (1/2 - s).
  double s;
  ASSERT_TRUE(FirstCrossing(Cubic<double>{ 0.0, 1.0 / 6.0, 0.0, -0.5 }, s));
  EXPECT_NEAR(s, 0.5, 1e-9);
  // Outside, inside from 1/2, zero at the end: (s - 1/2) (1 - s).
  ASSERT_TRUE(FirstCrossing(Cubic<double>{ -0.5, 0.0, 1.0 / 6.0, 0.0 }, s));
  EXPECT_NEAR(s, 0.5, 1e-9);
  // Outside and only touching zero at the end: the touch counts, since zero is inside.
  ASSERT_TRUE(FirstCrossing(Cubic<double>{ -1.0, -0.6, -0.3, 0.0 }, s));
  EXPECT_NEAR(s, 1.0, 1e-6);
  // Inside throughout, touching zero at both ends: no crossing.
  EXPECT_FALSE(FirstCrossing(Cubic<double>{ 0.0, 1.0, 1.0, 0.0 }, s));
}

TEST(CellRoot, ValuesOnASharedFaceAreTheSameBits)
{
  RandomCells cells;
  for (int trial = 0; trial < 1000; ++trial)
  {
    Corners<float> left, right;
    const Corners<double> a = cells.NextCorners(trial % 2), b = cells.NextCorners(trial % 2);
    std::copy(a.begin(), a.end(), left.begin());
    std::copy(b.begin(), b.end(), right.begin());
    for (std::size_t row = 0; row < 8; row += 2)
    {
      right[row] = left[row + 1];
    }
    const CellPath<double> path = cells.NextPath();
    const auto y = static_cast<float>(path.Begin[1]), z = static_cast<float>(path.Begin[2]);
    EXPECT_EQ(Trilinear(left, { 1.0f, y, z }), Trilinear(right, { 0.0f, y, z }));
  }
}

TEST(CellRoot, InterpolationKeepsTheSignOfEqualSigns)
{
  RandomCells cells;
  for (int trial = 0; trial < 1000; ++trial)
  {
    Corners<float> v;
    const Corners<double> random = cells.NextCorners(true);
    const float sign = trial % 2 ? 1.0f : -1.0f;
    for (std::size_t i = 0; i < 8; ++i)
    {
      // Never 0 on the negative side: 0 is inside.
      v[i] = sign * (static_cast<float>(std::abs(random[i])) + (sign < 0.0f ? 1e-6f : 0.0f));
    }
    const CellPath<double> random2 = cells.NextPath();
    CellPath<float> path;
    std::copy(random2.Begin.begin(), random2.Begin.end(), path.Begin.begin());
    std::copy(random2.End.begin(), random2.End.end(), path.End.begin());
    for (const float coefficient : CubicAlong(v, path))
    {
      EXPECT_EQ(IsInside(coefficient), sign > 0.0f);
    }
  }
}

TEST(CellRoot, NearestCrossingIsHalfWay)
{
  const Corners<float> v = { -1.0f, 1.0f, -1.0f, 1.0f, -1.0f, 1.0f, -1.0f, 1.0f };
  const CellPath<float> path{ { 0.0f, 0.1f, 0.2f }, { 1.0f, 0.3f, 0.4f } };
  double s;
  ASSERT_TRUE(FirstNearestCrossing(v, FindNearestPath(path, { 0.5, -1.0, -1.0 }), s));
  EXPECT_DOUBLE_EQ(s, 0.5);
  const CellPath<float> beside{ { 0.0f, 0.1f, 0.2f }, { 0.4f, 0.3f, 0.4f } };
  EXPECT_FALSE(FirstNearestCrossing(v, FindNearestPath(beside, { 1.25, -1.0, -1.0 }), s));
}

}
