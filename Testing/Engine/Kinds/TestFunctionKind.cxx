// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// A kind of field that the engine does not know, and that has no samples, takes every route that it
// says it can: no part of the engine asks which kind a field is.

#include "Checks/Infinity.h"
#include "Grid.h"
#include "Kinds/FunctionKind.h"
#include "Render/FrameRenderer.h"
#include "SameFrames.h"

#include <vtkSMPTools.h>

#include <gtest/gtest.h>

#include <cmath>
#include <new>
#include <string>
#include <vector>

namespace
{

using namespace TemporalCoherence;

constexpr double LargestGradient = 0.36; ///< of Waves

SmoothFunction Waves()
{
  return { [](const glm::dvec3& p)
    { return std::sin(0.2 * p.x) * std::cos(0.25 * p.y) + 0.5 * std::sin(0.3 * p.z); },
    [](const glm::dvec3& p)
    {
      return glm::dvec3(0.2 * std::cos(0.2 * p.x) * std::cos(0.25 * p.y),
        -0.25 * std::sin(0.2 * p.x) * std::sin(0.25 * p.y), 0.15 * std::cos(0.3 * p.z));
    },
    LargestGradient };
}

class FunctionFrames : public ::testing::Test
{
protected:
  FunctionFrames()
  {
    this->Key.Samples.Type = ScalarType::Float64;
    this->Key.Samples.Dimensions = { 60, 50, 43 };
    this->Key.Samples.Shape = std::make_shared<FunctionKind>(Waves());
    this->Key.EditIsosurfaces().Isovalues = { 0.5 };
    this->Key.Appearance.Colors = { { 1.0, 0.5, 0.2 } };
    this->Key.Appearance.Shade = true;
    this->Key.Appearance.Lights = { Light() };
    this->LookFrom({ 1.0, 2.0, 0.7 });
  }

  void LookFrom(
    const glm::dvec3& direction, bool parallel = false, const glm::ivec2& size = { 83, 61 })
  {
    this->Key.View = LookAt(this->Key.Samples.Dimensions, direction, size, parallel);
  }

  Frame Cold(const FrameRenderer::Options& options = {}) const
  {
    FrameRenderer renderer;
    renderer.Render(this->Key, options);
    EXPECT_EQ(renderer.Statistics().Made, Route::Cold);
    return renderer.LastFrame();
  }

  /// Where a ray passes the isovalue, by small steps.
  struct Met
  {
    std::vector<double> Crossings; ///< entries only for THRESHOLD
    bool BeginsInside = false;
    double Begin = Infinity;
    bool IsTouched = false; ///< it may pass it twice within a step
  };

  Met MeetByForce(int x, int y) const
  {
    const Ray ray = this->Key.View.RayThrough(x, y);
    const double perDepth = 1.0 / glm::dot(ray.Direction, this->Key.View.Forward);
    glm::dvec2 ends(this->Key.View.Near * perDepth, this->Key.View.Far * perDepth);
    for (int axis = 0; axis < 3; ++axis)
    {
      const double a = -ray.Origin[axis] / ray.Direction[axis];
      const double b =
        (this->Key.Samples.Dimensions[axis] - 1 - ray.Origin[axis]) / ray.Direction[axis];
      ends = { std::max(ends.x, std::min(a, b)), std::min(ends.y, std::max(a, b)) };
    }
    Met met;
    if (!(ends.x < ends.y))
    {
      return met;
    }
    constexpr int steps = 3000;
    met.Begin = ends.x;
    const double step = (ends.y - ends.x) / steps;
    const SmoothFunction waves = Waves();
    const auto at = [&](double t)
    { return waves.Value(ray.Origin + t * ray.Direction) - this->Key.Isosurfaces().Isovalues[0]; };
    met.BeginsInside = at(ends.x) >= 0.0;
    double before = at(ends.x), here = before;
    for (int i = 0; i < steps; ++i)
    {
      double low = ends.x + i * step, high = ends.x + (i + 1) * step;
      const double next = at(high);
      const bool inside = here >= 0.0;
      if ((next >= 0.0) == inside && (before >= 0.0) == inside)
      {
        const bool isNearest = std::abs(here) <= std::min(std::abs(before), std::abs(next));
        met.IsTouched |= isNearest && std::abs(here) < LargestGradient * step;
      }
      if ((next >= 0.0) != inside)
      {
        for (int halving = 0; halving < 50; ++halving)
        {
          const double middle = 0.5 * (low + high);
          ((at(middle) >= 0.0) == inside ? low : high) = middle;
        }
        if (!inside || this->Key.Isosurfaces().Mode == SurfaceMode::Crossing)
        {
          met.Crossings.push_back(high);
        }
      }
      before = here;
      here = next;
    }
    return met;
  }

  FrameKey Key;
};

TEST_F(FunctionFrames, ColdIsBruteForce)
{
  for (const SurfaceMode mode : { SurfaceMode::Crossing, SurfaceMode::Threshold })
  {
    this->Key.EditIsosurfaces().Mode = mode;
    for (const bool parallel : { false, true })
    {
      this->LookFrom({ 1.0, 2.0, 0.7 }, parallel);
      const Frame frame = this->Cold();
      int hits = 0, misses = 0, caps = 0, touched = 0;
      for (int pixel = 0; pixel < frame.Size.x * frame.Size.y; ++pixel)
      {
        const Met met = this->MeetByForce(pixel % frame.Size.x, pixel / frame.Size.x);
        const auto at = static_cast<std::size_t>(pixel);
        const bool isCapped = mode == SurfaceMode::Threshold && met.BeginsInside;
        EXPECT_EQ(frame.Kinds[at] == HitKind::Cap, isCapped) << pixel;
        double expected = met.Crossings.empty() ? Infinity : met.Crossings[0];
        expected = isCapped ? met.Begin : expected;
        if (expected < Infinity && std::isfinite(frame.Depth[at]))
        {
          const double error = std::abs(frame.Depth[at] - expected);
          EXPECT_TRUE(error < 1e-6 || (met.IsTouched && frame.Depth[at] < expected)) << pixel;
        }
        else
        {
          EXPECT_TRUE(expected == frame.Depth[at] || met.IsTouched) << pixel;
        }
        touched += met.IsTouched;
        hits += expected < Infinity;
        misses += expected == Infinity;
        caps += isCapped;
      }
      EXPECT_LT(touched, 50);
      EXPECT_GT(hits, 800);
      EXPECT_GT(misses, 800);
      EXPECT_EQ(caps > 100, mode == SurfaceMode::Threshold);
    }
  }
}

TEST_F(FunctionFrames, NormalsAreGradients)
{
  const Frame frame = this->Cold();
  for (int pixel = 0; pixel < frame.Size.x * frame.Size.y; ++pixel)
  {
    const auto at = static_cast<std::size_t>(pixel);
    if (frame.Isovalues[at] != Frame::NoSurface)
    {
      const Ray ray = this->Key.View.RayThrough(pixel % frame.Size.x, pixel / frame.Size.x);
      const glm::dvec3 gradient =
        glm::normalize(Waves().Gradient(ray.Origin + frame.Depth[at] * ray.Direction));
      const double facing = glm::dot(gradient, ray.Direction) > 0.0 ? -1.0 : 1.0;
      EXPECT_LT(glm::distance(facing * gradient, glm::dvec3(frame.Normals[at])), 1e-5) << pixel;
    }
  }
}

TEST_F(FunctionFrames, LeapingChangesNothing)
{
  FrameRenderer::Options plain;
  plain.SpaceLeaping = false;
  this->Key.EditIsosurfaces().Isovalues = { 0.5, -0.3 };
  this->Key.Appearance.Colors.resize(2);
  for (const SurfaceMode mode : { SurfaceMode::Crossing, SurfaceMode::Threshold })
  {
    this->Key.EditIsosurfaces().Mode = mode;
    EXPECT_TRUE(ShowTheSame(this->Cold(), this->Cold(plain)));
  }
}

TEST_F(FunctionFrames, RoutesGiveTheColdPicture)
{
  FrameRenderer renderer;
  FrameRenderer::Options exact;
  exact.Accuracy = ReuseAccuracy::Exact;
  const auto expectRoute = [&](Route route)
  {
    renderer.Render(this->Key, exact);
    EXPECT_EQ(renderer.Statistics().Made, route) << NameOf(renderer.Statistics().Made);
    EXPECT_TRUE(ShowTheSame(renderer.LastFrame(), this->Cold()));
  };
  for (const SurfaceMode mode : { SurfaceMode::Crossing, SurfaceMode::Threshold })
  {
    this->Key.EditIsosurfaces().Mode = mode;
    expectRoute(Route::Cold);
    expectRoute(Route::Redisplay);
    this->Key.Appearance.Ambient += 0.1;
    expectRoute(Route::Reshade);
    this->Key.EditIsosurfaces().Isovalues[0] += 0.05;
    expectRoute(Route::Cold);
    this->Key.EditIsosurfaces().Isovalues[0] -= 0.1;
    expectRoute(Route::Cold);
    this->LookFrom({ 1.0, 1.8, mode == SurfaceMode::Crossing ? 0.7 : 0.8 });
    expectRoute(Route::Cold);
  }
  EXPECT_EQ(renderer.BuildIsomap(this->Key, exact), Isomap::Outcome::Impossible);
}

TEST_F(FunctionFrames, DataThatMemoryEndsForLeavesTheOldToBeDrawn)
{
  const std::string before = vtkSMPTools::GetBackend();
  vtkSMPTools::SetBackend("Sequential"); // through which exceptions pass
  Grid<float> grid(glm::ivec3(30));
  grid.Fill([](int i, int j, int k) { return i + 0.5 * j + 0.2 * k; });
  FrameKey failing = this->Key;
  SmoothFunction nothing = Waves();
  nothing.Value = [](const glm::dvec3&) -> double { throw std::bad_alloc(); };
  failing.Samples.Shape = std::make_shared<FunctionKind>(nothing);
  this->Key.Samples = grid.Field;
  this->Key.EditIsosurfaces().Isovalues = { 15.0 };
  FrameRenderer::Options options;
  options.Map.Range = { 10.0, 20.0 };
  FrameRenderer renderer;
  renderer.Render(this->Key, options);
  this->Key.EditIsosurfaces().Isovalues[0] = 15.5;
  renderer.Render(this->Key, options);
  EXPECT_EQ(renderer.Statistics().Made, Route::IsomapBuild);
  EXPECT_THROW(renderer.Render(failing, options), std::bad_alloc);
  this->Key.EditIsosurfaces().Isovalues[0] = 16.0;
  renderer.Render(this->Key, options);
  const Frame cold = this->Cold();
  EXPECT_EQ(renderer.LastFrame().Depth, cold.Depth);
  EXPECT_EQ(renderer.LastFrame().Colors, cold.Colors);
  vtkSMPTools::SetBackend(before.c_str());
}

TEST_F(FunctionFrames, MovingCameraUsesTheLastPicture)
{
  FrameRenderer renderer;
  FrameRenderer::Options paper;
  paper.Accuracy = ReuseAccuracy::Paper;
  const glm::ivec2 fine(166, 122);
  this->LookFrom({ 1.0, 2.0, 0.7 }, false, fine);
  renderer.Render(this->Key, paper);
  for (int step = 1; step <= 20; ++step)
  {
    this->LookFrom({ 1.0, 2.0 - 0.02 * step, 0.7 }, false, fine);
    renderer.Render(this->Key, paper);
    ASSERT_EQ(renderer.Statistics().Made, Route::ImageCache);
    const Frame cold = this->Cold();
    int wrong = 0;
    for (std::size_t pixel = 0; pixel < cold.Depth.size(); ++pixel)
    {
      wrong += renderer.LastFrame().Isovalues[pixel] != cold.Isovalues[pixel];
    }
    EXPECT_LE(wrong, 30 * step) << "silhouettes erode by 0.15 % of the pixels a frame at most";
  }
  EXPECT_GT(renderer.Statistics().DefiniteMisses, 500);
}

TEST_F(FunctionFrames, LayersAreAllCrossings)
{
  this->Key.EditIsosurfaces().Opacities = { 0.01 };
  const Frame frame = this->Cold();
  std::vector<std::size_t> layers(frame.Depth.size(), 0);
  for (const std::vector<LayerHit>& tile : frame.Layers)
  {
    for (const LayerHit& layer : tile)
    {
      ++layers[static_cast<std::size_t>(layer.Pixel)];
    }
  }
  int several = 0;
  for (std::size_t pixel = 0; pixel < layers.size(); ++pixel)
  {
    const int x = static_cast<int>(pixel) % frame.Size.x,
              y = static_cast<int>(pixel) / frame.Size.x;
    const Met met = this->MeetByForce(x, y);
    EXPECT_TRUE(layers[pixel] == met.Crossings.size() || met.IsTouched)
      << pixel << ": " << layers[pixel] << ", not " << met.Crossings.size();
    several += layers[pixel] > 2;
  }
  EXPECT_GT(several, 200);
}

}
