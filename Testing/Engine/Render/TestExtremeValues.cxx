// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Which side of an isovalue a sample is on is never lost, whatever the type, the kind of vectors,
// the mode and the route, for samples and isovalues as large and as small as numbers get, beside 0,
// infinities and NaN.

#include "EachTarget.h"
#include "Grid.h"
#include "Kinds/RectilinearKind.h"
#include "Lattice/CellRoot.h"
#include "RandomExtremes.h"
#include "Render/FrameRenderer.h"
#include "SameFrames.h"
#include "Scene/Difference.h"

#include <vtkSMPTools.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace
{

using namespace TemporalCoherence;

void ExpectSame(const Frame& made, const Frame& expected, const char* what)
{
  EXPECT_TRUE(IsSamePlane(made.Depth, expected.Depth)) << what;
  EXPECT_TRUE(IsSamePlane(made.Isovalues, expected.Isovalues)) << what;
  EXPECT_TRUE(IsSamePlane(made.Normals, expected.Normals)) << what;
  EXPECT_TRUE(IsSamePlane(made.Colors, expected.Colors)) << what;
}

std::size_t HitsOf(const Frame& frame)
{
  return frame.Depth.size() -
    static_cast<std::size_t>(
      std::count(frame.Isovalues.begin(), frame.Isovalues.end(), Frame::NoSurface));
}

template <typename T>
FrameKey KeyOf(const Grid<T>& grid, const glm::dvec3& from, const glm::ivec2& size)
{
  FrameKey key;
  key.Samples = grid.Field;
  key.View = LookAt(grid.Field.Dimensions, from, size);
  key.Appearance.Shade = true;
  key.Appearance.Lights = { Light() };
  return key;
}

void SetIsovalues(FrameKey& key, const std::vector<double>& isovalues)
{
  key.EditIsosurfaces().Isovalues = isovalues;
  key.Appearance.Colors.assign(isovalues.size(), glm::dvec3(0.9, 0.6, 0.3));
  if (!key.Isosurfaces().Opacities.empty())
  {
    key.EditIsosurfaces().Opacities.assign(isovalues.size(), 0.5);
  }
}

/// A cold frame, every cell of whose rays is read.
void RenderPlainly(const FrameKey& key, FrameRenderer& renderer)
{
  FrameRenderer::Options options;
  options.SpaceLeaping = false;
  ASSERT_TRUE(renderer.Render(key, options));
}

std::shared_ptr<const GridCoordinates> UnevenGrid(const glm::ivec3& dimensions)
{
  auto grid = std::make_shared<GridCoordinates>();
  for (int axis = 0; axis < 3; ++axis)
  {
    const double last = dimensions[axis] - 1;
    for (int i = 0; i <= dimensions[axis] - 1; ++i)
    {
      grid->Along[static_cast<std::size_t>(axis)].push_back(last * std::pow(i / last, 1.3));
    }
  }
  return grid;
}

class ExtremeValues : public EachTarget
{
protected:
  /// A random field of extreme numbers, in every mode: leaping and every kind of vectors show what
  /// is seen without, and so does an isomap.
  template <typename T>
  void TryAll(unsigned int seed)
  {
    RandomExtremes random(seed);
    const glm::ivec3 dimensions(2 + static_cast<int>(random.Below(8)),
      2 + static_cast<int>(random.Below(8)), 2 + static_cast<int>(random.Below(8)));
    Grid<T> grid(dimensions);
    grid.Field.Stamp = seed;
    const bool hasHoles = random.IsOneOf(2), isSparse = random.IsOneOf(2);
    for (T& sample : grid.Samples)
    {
      sample = isSparse && !random.IsOneOf(5) ? T(0) : random.template Sample<T>(hasHoles);
    }
    FrameKey key = KeyOf(grid, { 1.0, 2.0, 0.7 }, { 19, 17 });
    key.EditIsosurfaces().Mode = random.IsOneOf(2) ? SurfaceMode::Crossing : SurfaceMode::Threshold;
    key.Samples.Between = random.IsOneOf(3) ? Interpolation::Nearest : Interpolation::Linear;
    if (random.IsOneOf(3))
    {
      key.Samples.Shape = RectilinearKind(UnevenGrid(dimensions));
    }
    if (random.IsOneOf(3))
    {
      key.EditIsosurfaces().Opacities = { 0.5 };
    }
    SCOPED_TRACE(testing::Message()
      << "seed " << seed << " type " << static_cast<int>(Grid<T>::Type()) << " mode "
      << static_cast<int>(key.Isosurfaces().Mode) << " between "
      << static_cast<int>(key.Samples.Between) << " grid "
      << (key.Samples.Shape != UniformShape()));
    FrameRenderer::Options options;
    options.Reuse.Frames = false;
    if (random.IsOneOf(2))
    {
      const double a = random.Finite(), b = random.Finite();
      options.Map.Range = { std::min(a, b), std::max(a, b) };
    }
    FrameRenderer reusing;
    for (int frame = 0; frame < 6; ++frame)
    {
      std::vector<double> isovalues = { random.Finite() };
      for (std::size_t more = random.IsOneOf(3) ? random.Below(3) : 0; more > 0; --more)
      {
        const double another = random.Finite();
        if (std::find(isovalues.begin(), isovalues.end(), another) == isovalues.end())
        {
          isovalues.push_back(another);
        }
      }
      SetIsovalues(key, isovalues);
      SCOPED_TRACE(testing::Message()
        << "isovalue " << isovalues[0] << " of " << isovalues.size() << " range "
        << options.Map.Range.Low << " to " << options.Map.Range.High << " frame " << frame);
      FrameRenderer plain;
      ASSERT_NO_FATAL_FAILURE(RenderPlainly(key, plain));
      ASSERT_TRUE(reusing.Render(key, options));
      ExpectSame(reusing.LastFrame(), plain.LastFrame(), NameOf(reusing.Statistics().Made));
      if (frame == 0)
      {
        this->ForEachTarget(
          [&](const char* target)
          {
            FrameRenderer leaping;
            ASSERT_TRUE(leaping.Render(key, options));
            ExpectSame(leaping.LastFrame(), plain.LastFrame(), target);
          });
      }
      if (HasFailure())
      {
        return;
      }
    }
  }

  /// One cell in higher precision and range: does a ray through it from side to side change sides?
  template <typename T>
  void TryCell(unsigned int seed);

  std::size_t Checked = 0;
};

TEST_F(ExtremeValues, EveryRouteIsTheColdPicture)
{
  for (unsigned int seed = 1; seed <= 60 && !HasFailure(); ++seed)
  {
    this->TryAll<std::int8_t>(seed);
    this->TryAll<std::uint8_t>(seed);
    this->TryAll<std::int16_t>(seed);
    this->TryAll<std::uint16_t>(seed);
    this->TryAll<std::int32_t>(seed);
    this->TryAll<std::uint32_t>(seed);
    this->TryAll<std::int64_t>(seed);
    this->TryAll<std::uint64_t>(seed);
    this->TryAll<float>(seed);
    this->TryAll<double>(seed);
    this->TryAll<double>(1000 + seed);
    this->TryAll<double>(2000 + seed);
  }
}

/// Differences of a cell's samples in a type that neither overflows nor underflows here.
template <typename T>
void ExtremeValues::TryCell(unsigned int seed)
{
  RandomExtremes random(seed);
  std::array<T, 8> samples;
  double low = Huge, high = -Huge;
  for (T& sample : samples)
  {
    sample = random.template Sample<T>(false);
    low = std::min(low, static_cast<double>(sample));
    high = std::max(high, static_cast<double>(sample));
  }
  const double isovalue = random.Finite();
  const Difference<T> difference(isovalue, { low, high });
  using Real = RealOf<T>;
  Corners<Real> corners;
  Corners<long double> truths;
  for (std::size_t i = 0; i < 8; ++i)
  {
    corners[i] = difference(samples[i]);
    truths[i] = static_cast<long double>(static_cast<double>(samples[i])) -
      static_cast<long double>(isovalue);
    ASSERT_EQ(IsInside(corners[i]), static_cast<double>(samples[i]) >= isovalue)
      << "seed " << seed << " sample " << static_cast<double>(samples[i]) << " of " << isovalue;
  }
  const auto inside = std::count_if(corners.begin(), corners.end(), IsInside<Real>);
  for (int way = 0; way < 20; ++way)
  {
    CellPath<Real> path;
    CellPath<long double> truePath;
    for (std::size_t a = 0; a < 3; ++a)
    {
      path.Begin[a] = static_cast<Real>(random.Below(65)) / Real(64);
      path.End[a] = static_cast<Real>(random.Below(65)) / Real(64);
      truePath.Begin[a] = static_cast<long double>(path.Begin[a]);
      truePath.End[a] = static_cast<long double>(path.End[a]);
    }
    const Cubic<Real> cubic = CubicAlong(corners, path);
    Real share = Real(-1);
    const bool isFound = FirstCrossing(cubic, share);
    if (inside == 0 || inside == 8)
    {
      ASSERT_FALSE(isFound) << "seed " << seed;
      ASSERT_EQ(IsInside(cubic[0]), inside == 8) << "seed " << seed;
      continue;
    }
    // Where there is one change of sides, plainly, the root is where it is.
    const Cubic<long double> truth = CubicAlong(truths, truePath);
    const long double largest = std::max(
      { std::fabs(truth[0]), std::fabs(truth[1]), std::fabs(truth[2]), std::fabs(truth[3]) });
    const bool isPlain = std::all_of(truth.begin(), truth.end(),
      [&](long double coefficient) { return std::fabs(coefficient) > 1e-4L * largest; });
    const int changes = (IsInside(truth[0]) != IsInside(truth[1])) +
      (IsInside(truth[1]) != IsInside(truth[2])) + (IsInside(truth[2]) != IsInside(truth[3]));
    if (isPlain && changes < 2)
    {
      ++this->Checked;
      ASSERT_EQ(isFound, changes == 1) << "seed " << seed;
      if (isFound)
      {
        const long double root = RefineCrossing(truth, 0.0L, 1.0L);
        ASSERT_NEAR(static_cast<double>(share), static_cast<double>(root), 1e-4)
          << "seed " << seed << " isovalue " << isovalue << " from " << low << " to " << high;
      }
    }
  }
}

TEST_F(ExtremeValues, SidesAndRootsAreThoseOfHigherPrecision)
{
  if (std::numeric_limits<long double>::max_exponent <= std::numeric_limits<double>::max_exponent)
  {
    GTEST_SKIP() << "long double has no more range than double here";
  }
  for (unsigned int seed = 1; seed <= 3000 && !HasFatalFailure(); ++seed)
  {
    this->TryCell<std::uint8_t>(seed);
    this->TryCell<std::int16_t>(seed);
    this->TryCell<std::int32_t>(seed);
    this->TryCell<std::uint64_t>(seed);
    this->TryCell<float>(seed);
    this->TryCell<double>(seed);
  }
  EXPECT_GT(this->Checked, 50000u);
}

/// A mask, and what is above 0 of it: isovalues that single precision takes for 0.
TEST_F(ExtremeValues, WhateverIsAboveZeroOfAMask)
{
  Grid<std::uint8_t> mask(glm::ivec3(12, 13, 14));
  mask.Fill([](int i, int j, int k)
    { return glm::length(glm::dvec3(i - 5.5, j - 6.0, k - 6.5)) < 4.0 ? 1 : 0; });
  Grid<std::int16_t> shorts(mask.Field.Dimensions);
  shorts.Fill([&](int i, int j, int k) { return -static_cast<int>(mask.At(i, j, k)); });
  for (FrameKey key :
    { KeyOf(mask, { 1.0, 2.0, 0.7 }, { 40, 30 }), KeyOf(shorts, { 1.0, 2.0, 0.7 }, { 40, 30 }) })
  {
    const double sign = key.Samples.Type == ScalarType::UInt8 ? 1.0 : -1.0;
    for (const SurfaceMode mode : { SurfaceMode::Crossing, SurfaceMode::Threshold })
    {
      key.EditIsosurfaces().Mode = mode;
      FrameRenderer larger;
      SetIsovalues(key, { sign * 1e-6 });
      RenderPlainly(key, larger);
      EXPECT_GT(HitsOf(larger.LastFrame()), 100u);
      for (const double tiny :
        { 1e-30, 1e-40, 1e-45, 1e-46, std::numeric_limits<double>::min(), 1e-310, Denormal })
      {
        SCOPED_TRACE(
          testing::Message() << "isovalue " << sign * tiny << " mode " << static_cast<int>(mode));
        SetIsovalues(key, { sign * tiny });
        FrameRenderer plain, leaping;
        RenderPlainly(key, plain);
        ASSERT_TRUE(leaping.Render(key, {}));
        ExpectSame(leaping.LastFrame(), plain.LastFrame(), "leaping");
        EXPECT_EQ(HitsOf(plain.LastFrame()), HitsOf(larger.LastFrame()));
      }
    }
  }
}

/// All of double's range in one field, and an isomap of all of it.
TEST_F(ExtremeValues, AnIsomapOfAllThereIs)
{
  for (const double scale : { 1e300, 1.7e308 })
  {
    Grid<double> grid(glm::ivec3(18, 17, 16));
    grid.Field.Stamp = static_cast<std::uint64_t>(scale / 1e300);
    grid.Fill([scale](int i, int j, int k)
      { return scale * std::sin(0.7 * i) * std::cos(0.5 * j) * std::sin(0.6 * k + 0.3); });
    grid.At(5, 5, 5) = std::numeric_limits<double>::quiet_NaN();
    grid.At(12, 9, 4) = Infinity;
    grid.At(3, 11, 9) = -Infinity;
    for (const SurfaceMode mode : { SurfaceMode::Crossing, SurfaceMode::Threshold })
    {
      for (const bool isAskedFor : { true, false })
      {
        FrameKey key = KeyOf(grid, { 1.0, 2.0, 0.7 }, { 60, 50 });
        key.EditIsosurfaces().Mode = mode;
        FrameRenderer::Options options;
        options.Reuse.Frames = false;
        if (isAskedFor)
        {
          options.Map.Range = { -scale, scale };
        }
        FrameRenderer reusing;
        for (const double share : { 0.2, 0.9, -0.5, 0.5, 1.0, -0.95, 0.0, 1e-300 })
        {
          SCOPED_TRACE(testing::Message() << "isovalue " << share << " times " << scale);
          SetIsovalues(key, { share * scale });
          ASSERT_TRUE(reusing.Render(key, options));
          FrameRenderer plain;
          RenderPlainly(key, plain);
          ExpectSame(reusing.LastFrame(), plain.LastFrame(), NameOf(reusing.Statistics().Made));
        }
        if (isAskedFor)
        {
          EXPECT_EQ(reusing.Statistics().Made, Route::IsomapLookup);
        }
      }
    }
  }
}

/// From so far away that points on a ray are rounded, and farther, where nothing is seen.
TEST_F(ExtremeValues, CamerasFarAway)
{
  Grid<std::uint8_t> ball(glm::ivec3(22, 23, 24));
  ball.Fill([](int i, int j, int k)
    { return std::min(20.0 * glm::length(glm::dvec3(i - 10.5, j - 11.0, k - 11.5)), 255.0); });
  for (const double distance : { 1e3, 1e10, 1e12, 1e13, 1e14, 1e16, 1e20, 1e30, 1e100 })
  {
    FrameKey key = KeyOf(ball, { 1.0, 2.0, 0.7 }, { 40, 30 });
    SetIsovalues(key, { 120.0 });
    const glm::dvec3 centre = 0.5 * glm::dvec3(ball.Field.Dimensions - 1);
    const glm::dvec3 eye = centre + distance * glm::normalize(glm::dvec3(1.0, 2.0, 0.7));
    const double near = 0.5 * distance, far = 2.0 * distance;
    if (!MakeView(glm::lookAt(eye, centre, glm::dvec3(0.0, 0.0, 1.0)),
          glm::ortho(-20.0, 20.0, -15.0, 15.0, near, far), { near, far }, { 40, 30 }, key.View))
    {
      continue;
    }
    SCOPED_TRACE(distance);
    FrameRenderer plain;
    RenderPlainly(key, plain);
    const auto& seen = plain.LastFrame().Isovalues;
    const bool isSeen =
      std::any_of(seen.begin(), seen.end(), [](int s) { return s != Frame::NoSurface; });
    EXPECT_EQ(isSeen, distance < 1.5e13);
    this->ForEachTarget(
      [&](const char* target)
      {
        FrameRenderer leaping;
        ASSERT_TRUE(leaping.Render(key, {}));
        ExpectSame(leaping.LastFrame(), plain.LastFrame(), target);
      });
  }
}

#if defined(__SSE2__)
/// A host that was linked with -ffast-math may have denormal numbers taken for 0, for all of us.
class DenormalsAreZero
{
public:
  DenormalsAreZero()
    : Before(_mm_getcsr())
  {
    constexpr unsigned int flushToZero = 0x8000, denormalsAreZero = 0x0040;
    _mm_setcsr(this->Before | flushToZero | denormalsAreZero);
  }
  ~DenormalsAreZero() { _mm_setcsr(this->Before); }
  DenormalsAreZero(const DenormalsAreZero&) = delete;
  void operator=(const DenormalsAreZero&) = delete;

private:
  unsigned int Before;
};

TEST_F(ExtremeValues, RoutesAgreeWhereDenormalsAreZero)
{
  // In this thread alone.
  const std::string before = vtkSMPTools::GetBackend();
  vtkSMPTools::SetBackend("Sequential");
  {
    const DenormalsAreZero here;
    for (unsigned int seed = 1; seed <= 40 && !HasFailure(); ++seed)
    {
      this->TryAll<std::uint8_t>(seed);
      this->TryAll<std::int16_t>(seed);
      this->TryAll<std::int64_t>(seed);
      this->TryAll<float>(seed);
      this->TryAll<double>(seed);
    }
  }
  vtkSMPTools::SetBackend(before.c_str());
}
#endif

}
