// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// A look-up with tolerance 0 is the cold picture, byte for byte, for any isovalue, hidden cells,
// pieces of rays and magnitude of samples. With a tolerance, surfaces are that near. A limit of
// memory or a stop leaves the last frame.

#include "Checks/Sanitized.h"
#include "Grid.h"
#include "Lattice/Coordinates.h"
#include "Render/FrameRenderer.h"
#include "SameFrames.h"
#include "Scene/HiddenCells.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace
{

using namespace TemporalCoherence;

void ExpectColdPlanes(const Frame& made, const Frame& cold)
{
  EXPECT_TRUE(IsSamePlane(made.Depth, cold.Depth));
  EXPECT_TRUE(IsSamePlane(made.Normals, cold.Normals));
  EXPECT_TRUE(IsSamePlane(made.Isovalues, cold.Isovalues));
  EXPECT_TRUE(IsSamePlane(made.Colors, cold.Colors));
  EXPECT_TRUE(IsSamePlane(made.Kinds, cold.Kinds));
}

/// A view whose isovalues change, beside cold frames of the same.
class IsomapTest : public ::testing::Test
{
protected:
  template <typename T>
  static FrameKey KeyOf(const Grid<T>& grid, bool parallel = false)
  {
    FrameKey key;
    key.Samples = grid.Field;
    const glm::ivec2 size = IsMemorySanitized ? glm::ivec2(47, 36) : glm::ivec2(93, 71);
    key.View = LookAt(grid.Field.Dimensions, { 1.0, 2.0, 0.7 }, size, parallel);
    key.Appearance.Shade = true;
    key.Appearance.Lights = { Light() };
    return key;
  }

  /// Render isovalues as they come, and cold.
  void RenderBoth(FrameKey& key, const std::vector<double>& isovalues, FrameRenderer& cold)
  {
    key.EditIsosurfaces().Isovalues = isovalues;
    key.Appearance.Colors.assign(isovalues.size(), glm::dvec3(0.9, 0.6, 0.3));
    ASSERT_TRUE(this->Renderer.Render(key, this->Options));
    cold.Render(key, {});
    ASSERT_EQ(cold.Statistics().Made, Route::Cold);
  }

  void Show(FrameKey& key, const std::vector<double>& isovalues)
  {
    FrameRenderer cold;
    ASSERT_NO_FATAL_FAILURE(this->RenderBoth(key, isovalues, cold));
    SCOPED_TRACE(testing::Message()
      << "isovalue " << isovalues[0] << " route " << NameOf(this->Renderer.Statistics().Made));
    ExpectColdPlanes(this->Renderer.LastFrame(), cold.LastFrame());
  }

  /// Isovalues up and down and far away.
  void Sweep(FrameKey& key, double low, double high)
  {
    const double range = high - low;
    for (const double share : { 0.5, 0.51, 0.52, 0.6, 0.55, 0.49, 0.4, 0.1, 0.11, 0.9, 0.95, 0.0,
           1.0, -0.1, 1.1, 0.5, 0.3, 0.31 })
    {
      this->Show(key, { low + share * range });
    }
  }

  FrameRenderer Renderer;
  FrameRenderer::Options Options;
};

double Waves(int i, int j, int k)
{
  return 120.0 + 100.0 * std::sin(0.2 * i) * std::cos(0.25 * j) * std::sin(0.3 * k);
}

/// A block of hidden cells and, of all others, one in ten.
std::shared_ptr<const HiddenCells> SomeHidden(const glm::ivec3& samples)
{
  const glm::ivec3 cells = samples - 1;
  std::vector<std::uint8_t> flags;
  std::mt19937 engine(5);
  for (int k = 0; k < cells.z; ++k)
  {
    for (int j = 0; j < cells.y; ++j)
    {
      for (int i = 0; i < cells.x; ++i)
      {
        const glm::ivec3 cell(i, j, k);
        const bool isInBlock = glm::all(glm::greaterThan(cell, cells / 3)) &&
          glm::all(glm::lessThan(cell, 2 * cells / 3));
        flags.push_back(isInBlock || engine() % 10 == 0);
      }
    }
  }
  return HiddenCells::Make(samples, { flags.data(), 1, nullptr, 0 });
}

/// Caps of a picture that are not where the ray enters the field's box.
std::int64_t CapsWithin(const Frame& frame, const FrameKey& key)
{
  std::int64_t caps = 0;
  for (std::size_t i = 0; i < frame.Kinds.size(); ++i)
  {
    const int pixel = static_cast<int>(i);
    const Ray ray = key.View.RayThrough(pixel % frame.Size.x, pixel / frame.Size.x);
    const glm::dvec3 at = ray.Origin + frame.Depth[i] * ray.Direction;
    const glm::dvec3 last(key.Samples.Dimensions - 1);
    const bool isWithin =
      glm::all(glm::greaterThan(at, glm::dvec3(0.01))) && glm::all(glm::lessThan(at, last - 0.01));
    caps += frame.Kinds[i] == HitKind::Cap && isWithin;
  }
  return caps;
}

/// The isovalues of a picture are those of the cold one, and no surface is farther from it than a
/// tolerance.
void ExpectWithin(const Frame& made, const Frame& truth, double tolerance)
{
  for (std::size_t i = 0; i < truth.Depth.size(); ++i)
  {
    ASSERT_EQ(made.Isovalues[i], truth.Isovalues[i]) << i;
    if (std::isfinite(truth.Depth[i]))
    {
      ASSERT_NEAR(made.Depth[i], truth.Depth[i], tolerance) << i;
    }
  }
}

TEST_F(IsomapTest, IsTheColdPictureForAnyIsovalue)
{
  Grid<std::uint8_t> bytes(glm::ivec3(60, 50, 40));
  bytes.Fill(Waves);
  Grid<float> floats(glm::ivec3(30, 50, 40));
  floats.Fill(Waves);
  Grid<double> noise(glm::ivec3(20, 21, 22));
  noise.FillRandomly(20.0, 220.0, 3);
  for (const SurfaceMode mode : { SurfaceMode::Crossing, SurfaceMode::Threshold })
  {
    for (const Interpolation between : { Interpolation::Linear, Interpolation::Nearest })
    {
      for (FrameKey key : { KeyOf(bytes), KeyOf(floats, true), KeyOf(noise) })
      {
        SCOPED_TRACE(testing::Message()
          << "type " << static_cast<int>(key.Samples.Type) << " mode " << static_cast<int>(mode)
          << " between " << static_cast<int>(between));
        key.EditIsosurfaces().Mode = mode;
        key.Samples.Between = between;
        this->Sweep(key, 20.0, 220.0);
      }
    }
  }
}

/// Where hidden cells interrupt rays, isovalues are not met in their order.
/// Also where cropping leaves several pieces of a ray: it may enter active cells in one of them,
/// and begin inside a solid in the next.
TEST_F(IsomapTest, HiddenCellsAndPiecesOfImagesAndGrids)
{
  Grid<std::uint8_t> bytes(glm::ivec3(40, 34, 30));
  bytes.Fill(Waves);
  Grid<float> noise(glm::ivec3(20, 21, 22));
  noise.FillRandomly(20.0, 220.0, 3);
  std::int64_t capsBehind = 0;
  for (const bool isRectilinear : { false, true })
  {
    for (const SurfaceMode mode : { SurfaceMode::Crossing, SurfaceMode::Threshold })
    {
      for (const Interpolation between : { Interpolation::Linear, Interpolation::Nearest })
      {
        for (FrameKey key : { KeyOf(bytes), KeyOf(noise, true) })
        {
          SCOPED_TRACE(testing::Message()
            << "rectilinear " << isRectilinear << " mode " << static_cast<int>(mode) << " between "
            << static_cast<int>(between));
          key.Samples.Flagged = SomeHidden(key.Samples.Dimensions);
          key.Samples.Between = between;
          key.EditIsosurfaces().Mode = mode;
          if (isRectilinear)
          {
            key.Samples.Shape = RectilinearKind(Stretched(key.Samples.Dimensions, 5.0, 7));
          }
          key.Region.Crops = { { { 5.5, 12.25 }, { 6.0, 14.5 }, { 7.25, 13.0 } } };
          key.Region.Boxes = 0x5d75f77u;
          this->Sweep(key, 20.0, 220.0);
          key.Region = {};
          this->Sweep(key, 20.0, 220.0);
          this->Show(key, { 120.0, 90.0 });
          this->Show(key, { 119.0, 90.0 });
          this->Show(key, { 118.0, 91.0, 180.0 });
          const Route made = this->Renderer.Statistics().Made;
          EXPECT_TRUE(made == Route::IsomapBuild || made == Route::IsomapLookup) << NameOf(made);
          capsBehind += CapsWithin(this->Renderer.LastFrame(), key);
        }
      }
    }
  }
  EXPECT_GT(capsBehind, IsMemorySanitized ? 250 : 1000) << "that hidden cells cut open";
}

TEST_F(IsomapTest, SeveralIsovalues)
{
  Grid<std::uint8_t> bytes(glm::ivec3(60, 50, 40));
  bytes.Fill(Waves);
  for (const SurfaceMode mode : { SurfaceMode::Crossing, SurfaceMode::Threshold })
  {
    FrameKey key = KeyOf(bytes);
    key.EditIsosurfaces().Mode = mode;
    this->Show(key, { 150.0, 90.0 });
    this->Show(key, { 149.0, 90.0 });
    this->Show(key, { 148.0, 91.0, 200.0 });
    this->Show(key, { 148.0 });
  }
}

TEST_F(IsomapTest, FirstABandIsBuiltThenLookedUp)
{
  Grid<std::uint8_t> bytes(glm::ivec3(60, 50, 40));
  bytes.Fill(Waves);
  FrameKey key = KeyOf(bytes);
  this->Options.Map.Range = { 100.0, 140.0 };
  this->Show(key, { 120.0 });
  EXPECT_EQ(this->Renderer.Statistics().Made, Route::Cold);
  this->Show(key, { 121.0 });
  EXPECT_EQ(this->Renderer.Statistics().Made, Route::IsomapBuild);
  EXPECT_GT(this->Renderer.IsomapOfLastView().NumberOfKnots(), 0u);
  for (const double isovalue : { 100.0, 140.0, 119.5 })
  {
    this->Show(key, { isovalue });
    EXPECT_EQ(this->Renderer.Statistics().Made, Route::IsomapLookup);
  }
  this->Show(key, { 141.0 });
  EXPECT_EQ(this->Renderer.Statistics().Made, Route::IsomapBuild) << "outside of the range";

  // A view that comes back finds its isomap; other data does not.
  const View view = key.View;
  key.View = LookAt(bytes.Field.Dimensions, { 1.0, 1.5, 0.7 }, { 93, 71 });
  ASSERT_TRUE(this->Renderer.Render(key, this->Options));
  key.View = view;
  this->Show(key, { 110.0 });
  EXPECT_EQ(this->Renderer.Statistics().Made, Route::IsomapLookup);
  bytes.At(30, 25, 20) = 250;
  key.Samples.Stamp = 2;
  this->Show(key, { 111.0 });
  EXPECT_EQ(this->Renderer.Statistics().Made, Route::Cold);
}

TEST_F(IsomapTest, ATooSmallLimitOfMemoryMakesColdFramesUntilItIsRaised)
{
  Grid<std::uint8_t> bytes(glm::ivec3(60, 50, 40));
  bytes.Fill(Waves);
  FrameKey key = KeyOf(bytes);
  key.View = LookAt(bytes.Field.Dimensions, { 1.0, 2.0, 0.7 }, { 93, 71 });
  this->Options.Map.MemoryLimit = 100;
  for (const double isovalue : { 120.0, 121.0, 122.0, 110.0, 60.0, 180.0 })
  {
    this->Show(key, { isovalue });
    EXPECT_LE(this->Renderer.IsomapOfLastView().MemoryInBytes(), 100u);
  }
  EXPECT_EQ(this->Renderer.Statistics().Made, Route::Cold);
  this->Options.Map.MemoryLimit = std::size_t(64) << 20;
  this->Show(key, { 122.0 });
  EXPECT_EQ(this->Renderer.Statistics().Made, Route::IsomapBuild) << "a limit that is raised";
}

/// A range that is built can always be stopped; the tiles of a frame, if it reports on them.
TEST_F(IsomapTest, ABuildThatIsStoppedLeavesTheLastFrame)
{
  Grid<std::uint8_t> bytes(glm::ivec3(60, 50, 40));
  bytes.Fill(Waves);
  for (const bool hasRange : { true, false })
  {
    this->Renderer = FrameRenderer();
    this->Options.Map.Range = hasRange ? ValueBand{ 100.0, 140.0 } : ValueBand{ 1.0, 0.0 };
    this->Options.ReportsTiles = !hasRange;
    FrameKey key = KeyOf(bytes);
    this->Show(key, { 120.0 });
    const Frame before = this->Renderer.LastFrame();
    key.EditIsosurfaces().Isovalues = { 121.0 };
    EXPECT_FALSE(this->Renderer.Render(key, this->Options, [](double) { return false; }));
    EXPECT_TRUE(IsSamePlane(this->Renderer.LastFrame().Depth, before.Depth));
    EXPECT_EQ(this->Renderer.LastKey().Isosurfaces().Isovalues[0], 120.0);
    EXPECT_EQ(this->Renderer.IsomapOfLastView().MemoryInBytes(), 0u);
    this->Show(key, { 121.0 });
    EXPECT_GT(this->Renderer.IsomapOfLastView().MemoryInBytes(), 0u);
  }
}

TEST_F(IsomapTest, WithAToleranceSurfacesAreThatNear)
{
  Grid<std::uint8_t> bytes(glm::ivec3(60, 50, 40));
  bytes.Fill(Waves);
  Grid<float> noise(glm::ivec3(20, 21, 22));
  noise.FillRandomly(20.0, 220.0, 3);
  for (const SurfaceMode mode : { SurfaceMode::Crossing, SurfaceMode::Threshold })
  {
    for (FrameKey key : { KeyOf(bytes), KeyOf(noise) })
    {
      key.EditIsosurfaces().Mode = mode;
      for (const double tolerance : { 0.05, 0.3, 1.0 })
      {
        this->Options.Map.Tolerance = tolerance;
        for (const double isovalue : { 120.0, 121.0, 118.0, 90.0, 91.0, 160.0, 155.0, 30.0, 210.0 })
        {
          FrameRenderer cold;
          ASSERT_NO_FATAL_FAILURE(this->RenderBoth(key, { isovalue }, cold));
          SCOPED_TRACE(testing::Message() << "isovalue " << isovalue);
          ASSERT_NO_FATAL_FAILURE(
            ExpectWithin(this->Renderer.LastFrame(), cold.LastFrame(), tolerance));
        }
      }
    }
  }
}

TEST_F(IsomapTest, InterpolatedNormalsAreNearThoseOfTheField)
{
  Grid<std::uint8_t> bytes(glm::ivec3(60, 50, 40));
  bytes.Fill(Waves);
  FrameKey key = KeyOf(bytes);
  this->Options.Map.HasNormals = true;
  for (const double tolerance : { 0.0, 0.2 })
  {
    this->Options.Map.Tolerance = tolerance;
    for (const double isovalue : { 120.0, 121.0, 124.0, 100.0 })
    {
      FrameRenderer cold;
      ASSERT_NO_FATAL_FAILURE(this->RenderBoth(key, { isovalue }, cold));
      const Frame &made = this->Renderer.LastFrame(), &truth = cold.LastFrame();
      double sum = 0.0;
      int hits = 0;
      for (std::size_t i = 0; i < truth.Depth.size(); ++i)
      {
        if (truth.Isovalues[i] != Frame::NoSurface)
        {
          sum += static_cast<double>(glm::dot(made.Normals[i], truth.Normals[i]));
          ++hits;
        }
      }
      EXPECT_GT(sum / hits, 0.97) << "mean cosine at " << isovalue << " tolerance " << tolerance;
    }
  }
}

TEST_F(IsomapTest, InfiniteSamplesBehindSaturatedOnes)
{
  constexpr float infinity = std::numeric_limits<float>::infinity();
  Grid<float> grid(glm::ivec3(30, 30, 30));
  grid.Fill(
    [](int i, int j, int k)
    {
      const double distance = glm::length(glm::dvec3(i, j, k) - 14.5);
      return distance < 5.0 ? static_cast<double>(infinity) : distance < 9.0 ? 100.0 : 0.0;
    });
  for (const SurfaceMode mode : { SurfaceMode::Crossing, SurfaceMode::Threshold })
  {
    FrameKey key = KeyOf(grid);
    key.EditIsosurfaces().Mode = mode;
    this->Options.Map.Range = { 0.0, 200.0 };
    for (const double isovalue : { 50.0, 60.0, 150.0, 101.0, 100.0, 0.0 })
    {
      this->Show(key, { isovalue });
    }
  }
}

TEST_F(IsomapTest, AnyMagnitudeOfSamples)
{
  std::uint64_t stamp = 0;
  for (const double scale : { 1e290, 1e40, 1e-43, 1e-300 })
  {
    Grid<double> grid(glm::ivec3(25, 24, 23));
    grid.Field.Stamp = ++stamp;
    grid.Fill([scale](int i, int j, int k) { return scale * (Waves(i, j, k) - 120.0); });
    for (const SurfaceMode mode : { SurfaceMode::Crossing, SurfaceMode::Threshold })
    {
      FrameKey key = KeyOf(grid);
      key.EditIsosurfaces().Mode = mode;
      for (const double share : { 0.0, 1.0, 5.0, -3.0, 40.0, 39.0 })
      {
        this->Show(key, { scale * share });
      }
    }
  }
}

TEST_F(IsomapTest, ConstantDataWithHoles)
{
  Grid<float> grid(glm::ivec3(20, 20, 20));
  grid.Fill([](int, int, int) { return 1.0; });
  grid.At(10, 10, 10) = std::numeric_limits<float>::quiet_NaN();
  grid.At(5, 12, 10) = std::numeric_limits<float>::infinity();
  FrameKey key = KeyOf(grid);
  for (const double isovalue : { 0.5, 0.6, 1.0, 1.5, 2.0, -1.0 })
  {
    this->Show(key, { isovalue });
  }
}

TEST_F(IsomapTest, PlateausWithATolerance)
{
  // Values of five levels: isovalues on a level are where a ray leaves a plateau, not where it
  // comes to it.
  Grid<std::uint8_t> grid(glm::ivec3(24, 24, 24));
  grid.Fill([](int i, int j, int k) { return 98 + 2 * ((i / 3 + j / 4 + k / 5) % 5); });
  FrameKey key = KeyOf(grid);
  for (const double tolerance : { 0.1, 2e-3 })
  {
    this->Options.Map.Tolerance = tolerance;
    for (const double isovalue : { 101.0, 102.0, 101.5, 100.0, 104.0, 105.9 })
    {
      FrameRenderer cold;
      ASSERT_NO_FATAL_FAILURE(this->RenderBoth(key, { isovalue }, cold));
      for (std::size_t i = 0; i < cold.LastFrame().Depth.size(); ++i)
      {
        const double truth = cold.LastFrame().Depth[i], made = this->Renderer.LastFrame().Depth[i];
        ASSERT_EQ(std::isfinite(made), std::isfinite(truth)) << i << " at " << isovalue;
        if (std::isfinite(truth))
        {
          ASSERT_NEAR(made, truth, tolerance) << i << " at " << isovalue;
        }
      }
    }
  }
}

TEST_F(IsomapTest, ATooFineToleranceCountsAsNone)
{
  Grid<std::uint8_t> bytes(glm::ivec3(60, 50, 40));
  bytes.Fill(Waves);
  FrameKey key = KeyOf(bytes);
  for (const double tolerance : { 5e-4, 1e-8, 1e-16, std::numeric_limits<double>::denorm_min() })
  {
    this->Renderer = FrameRenderer();
    this->Options.Map.Tolerance = tolerance;
    for (const double isovalue : { 120.0, 121.0, 121.3, 90.0 })
    {
      this->Show(key, { isovalue });
    }
    EXPECT_EQ(this->Renderer.IsomapOfLastView().Tolerance(), 0.0);
    // What is shown is what would be asked for without a tolerance, too.
    this->Options.Map.Tolerance = 0.0;
    this->Show(key, { 90.0 });
    EXPECT_EQ(this->Renderer.Statistics().Made, Route::Redisplay);
  }
  this->Options.Map.Tolerance = Isomap::FinestTolerance;
  FrameRenderer cold;
  ASSERT_NO_FATAL_FAILURE(this->RenderBoth(key, { 130.0 }, cold));
  EXPECT_NE(this->Renderer.IsomapOfLastView().Tolerance(), 0.0);
}

/// Tolerances just above the finest one are kept, and cost what can be paid, in noise and where the
/// field is steep.
TEST_F(IsomapTest, TheFinestToleranceIsBoundedInMemory)
{
  Grid<float> noise(glm::ivec3(20, 21, 22));
  noise.FillRandomly(20.0, 220.0, 3);
  Grid<float> steep(glm::ivec3(20, 21, 22));
  steep.Fill([](int i, int, int k) { return std::pow(10.0, 2.0 * i - 0.1 * k); });
  for (FrameKey key : { KeyOf(noise), KeyOf(steep) })
  {
    this->Renderer = FrameRenderer();
    this->Options.Map.Tolerance = Isomap::FinestTolerance;
    this->Options.Map.Range = { 0.0, 1e30 };
    for (const double isovalue : { 120.0, 121.0, 30.0, 210.0 })
    {
      FrameRenderer cold;
      ASSERT_NO_FATAL_FAILURE(this->RenderBoth(key, { isovalue }, cold));
      SCOPED_TRACE(testing::Message() << "isovalue " << isovalue);
      ASSERT_NO_FATAL_FAILURE(
        ExpectWithin(this->Renderer.LastFrame(), cold.LastFrame(), Isomap::FinestTolerance));
    }
    // A kilobyte and a half for each ray.
    EXPECT_LT(this->Renderer.IsomapOfLastView().MemoryInBytes(), std::size_t(1536) * 93 * 71);
  }
}

}
