// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_ViewTesting_h
#define TemporalCoherence_ViewTesting_h

#include "../../Engine/Grid.h"
#include "ViewFile/ViewFile.h"
#include "ViewFile/ViewMaker.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace TemporalCoherence
{

/// A view: where its rays go, and its knots.
struct MadeView
{
  ViewGeometry Geometry;
  KnotImage Knots;
};

/// How MakeView makes a view of waves.
struct MadeViewSettings
{
  glm::ivec2 Size{ 24, 16 };
  bool IsInside = false;  ///< the camera is in the volume, so that rays also fall
  bool HasHoles = false;  ///< some samples are infinite, so that rays are unknown
  double Tolerance = 0.1; ///< in voxels
};

inline MadeView MakeView(const MadeViewSettings& settings)
{
  Grid<float> grid({ 14, 13, 12 });
  grid.Fill([](int i, int j, int k)
    { return 100.0 * std::sin(0.9 * i) * std::cos(0.7 * j) + 40.0 * std::sin(1.1 * k) + 3.0 * i; });
  if (settings.HasHoles)
  {
    grid.At(7, 6, 5) = std::numeric_limits<float>::infinity();
  }
  FrameKey key;
  key.Samples = grid.Field;
  key.View = LookAt(grid.Field.Dimensions, { 1.0, 2.0, 0.7 }, settings.Size);
  if (settings.IsInside)
  {
    const glm::dvec3 centre = 0.5 * glm::dvec3(grid.Field.Dimensions - 1);
    constexpr double near = 0.01, far = 100.0;
    TemporalCoherence::MakeView(
      glm::lookAt(centre, glm::dvec3(0.0, 1.0, 2.0), glm::dvec3(0.0, 0.0, 1.0)),
      glm::perspective(1.2, static_cast<double>(settings.Size.x) / settings.Size.y, near, far),
      { near, far }, settings.Size, key.View);
  }
  MadeView view;
  view.Geometry.Name = "View 1";
  view.Geometry.Tolerance = settings.Tolerance;
  view.Geometry.Rays = key.View;
  view.Geometry.Box = { glm::dvec3(0.0), glm::dvec3(grid.Field.Dimensions - 1) };
  std::string error;
  ViewMaker maker(settings.Tolerance);
  EXPECT_TRUE(maker.Make(key, { -80.0, 120.0 }, {}, view.Knots, error)) << error;
  return view;
}

/// Everything that a header can tell.
inline ViewDescription MakeDescription()
{
  ViewDescription description;
  description.Texts = { "Title", "A \"caption\" </script>", "Citation", "array", "HU" };
  description.Look.Surfaces = { { 10.0, glm::dvec3(0.9, 0.5, 0.1), 1.0 },
    { 50.0, glm::dvec3(0.2, 0.4, 0.6), 0.5 } };
  description.Look.Colors = { { -80.0, 0.0, 0.0, 1.0 }, { 120.0, 1.0, 0.0, 0.0 } };
  description.Look.Light.Shade = true;
  description.Look.Light.Lights = { Light() };
  description.Look.Background2 = glm::dvec3(0.3);
  description.Histogram = { { -80.0, 120.0 }, { 1, 2, 3, 4 } };
  return description;
}

/// A file with a view from outside, and one from inside with unknown pixels and a plane.
inline std::vector<std::uint8_t> MakeFile(const glm::ivec2& size = { 24, 16 })
{
  ViewFileMaker maker;
  MadeViewSettings settings;
  settings.Size = size;
  const MadeView outside = MakeView(settings);
  settings.IsInside = settings.HasHoles = true;
  MadeView inside = MakeView(settings);
  inside.Geometry.Planes = { { 1.0, 0.0, 0.0, -1.0 } };
  maker.Add(outside.Geometry, outside.Knots);
  maker.Add(inside.Geometry, inside.Knots);
  return maker.Finish(MakeDescription());
}

/// Knots without any order but the one that they must have.
class RandomKnots
{
public:
  /// \param largest  progress
  /// \param farthest distance
  RandomKnots(unsigned seed, std::uint16_t largest, std::uint32_t farthest)
    : Random(seed)
    , Largest(largest)
    , Farthest(farthest)
  {
  }

  PixelKnots Make(const glm::ivec2& size)
  {
    PixelKnots knots;
    knots.Begin.assign(1, 0);
    for (int pixel = 0; pixel < size.x * size.y; ++pixel)
    {
      this->AddPixel(knots);
    }
    return knots;
  }

private:
  /// Often none; often with the progress of the pixel before.
  void AddPixel(PixelKnots& knots)
  {
    constexpr std::uint32_t most = 9, rare = 3;
    std::vector<std::uint16_t> progress(
      knots.Progress.begin() + knots.Begin[knots.Begin.size() > 1 ? knots.Begin.size() - 2 : 0],
      knots.Progress.end());
    if (this->Below(2) == 0)
    {
      progress.clear();
      for (std::uint32_t count = this->Below(rare) == 0 ? 0 : this->Below(most); count > 0; --count)
      {
        const auto value = static_cast<std::uint16_t>(this->Below(this->Largest + 1u));
        progress.insert(progress.end(), this->Below(rare) == 0 ? 2 : 1, value);
      }
      std::sort(progress.begin(), progress.end());
    }
    for (std::size_t i = 0; i < progress.size(); ++i)
    {
      if (i < 2 || progress[i] != progress[i - 2])
      {
        this->AddKnot(progress[i], knots);
      }
    }
    knots.Begin.push_back(static_cast<std::uint32_t>(knots.Progress.size()));
  }

  void AddKnot(std::uint16_t progress, PixelKnots& knots)
  {
    constexpr std::uint32_t closeTo = 60, rare = 5;
    const std::uint32_t last = knots.Distance.empty() ? 0 : knots.Distance.back();
    const std::uint32_t choice = this->Below(rare);
    const std::uint32_t distance = choice == 0 ? this->Farthest
      : choice == 1                            ? 0
      : choice == 2                            ? this->Below(this->Farthest)
                    : std::min(last, this->Farthest - closeTo) + this->Below(closeTo);
    knots.Progress.push_back(progress);
    knots.Distance.push_back(distance);
    for (std::vector<OctahedralNormal>* normals : { &knots.Normals, &knots.Middles })
    {
      normals->push_back(
        { static_cast<std::int8_t>(this->Below(256)), static_cast<std::int8_t>(this->Below(256)) });
    }
  }

  std::uint32_t Below(std::uint32_t count)
  {
    return std::uniform_int_distribution<std::uint32_t>(0, count - 1)(this->Random);
  }

  std::mt19937 Random;
  std::uint16_t Largest;
  std::uint32_t Farthest;
};

inline void ExpectSame(const PixelKnots& a, const PixelKnots& b)
{
  EXPECT_EQ(a.Begin, b.Begin);
  EXPECT_EQ(a.Progress, b.Progress);
  EXPECT_EQ(a.Distance, b.Distance);
  EXPECT_EQ(a.Normals, b.Normals);
  EXPECT_EQ(a.Middles, b.Middles);
}

}

#endif
