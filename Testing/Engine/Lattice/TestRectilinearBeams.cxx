// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// In rectilinear fields, beams meet what walks meet, bit by bit, on every kind of vectors, also in
// cells too thin for single precision.
#include "Checks/Sanitized.h"
#include "EachTarget.h"
#include "Lattice/BeamCameras.h"
#include "Lattice/BothWays.h"
#include "Lattice/Coordinates.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

namespace
{

using namespace TemporalCoherence;

using Coordinates = std::shared_ptr<const GridCoordinates>;

class RectilinearBeams : public EachTarget
{
protected:
  template <typename T>
  void Compare(Grid<T>& grid, const Coordinates& coordinates, const std::vector<double>& isovalues,
    int pixels = IsMemorySanitized ? 16 : 40)
  {
    grid.Field.Shape = RectilinearKind(coordinates);
    for (const SurfaceMode mode : { SurfaceMode::Crossing, SurfaceMode::Threshold })
    {
      BothWays<T> ways(grid, isovalues, mode);
      for (const Camera& camera : CamerasFor(grid.Field.Dimensions))
      {
        // Where a walk goes in a plane between cells, it may go on either side.
        const glm::dvec3 off(0.0137, 0.0071, 0.0093);
        ways.Compare(ViewFrom(
          { camera.Eye + 7.0 * off, camera.Towards + off, camera.Pixel, camera.Parallel }, pixels));
        ASSERT_FALSE(this->HasFatalFailure());
      }
      EXPECT_GT(ways.Hits, ways.Rays / 50);
    }
  }
};

double Wave(const glm::dvec3& at)
{
  return 120.0 +
    80.0 * (std::sin(0.4 * at.x) * std::cos(0.3 * at.y + 0.2 * at.z) + 0.3 * std::sin(0.9 * at.z));
}

constexpr glm::ivec3 Size(50, 41, 37);

/// Some cells as thin as doubles allow, beside large ones.
Coordinates WithThinCells(const glm::ivec3& dimensions)
{
  auto grid = std::make_shared<GridCoordinates>(*Stretched(dimensions, 3.0, 4));
  for (std::vector<double>& along : grid->Along)
  {
    double thickness = 1e-300;
    for (std::size_t i = 1; i + 1 < along.size() && thickness < 1.0; i += 2)
    {
      along[i] = std::max(
        along[i - 1] + thickness, std::nextafter(along[i - 1], std::numeric_limits<double>::max()));
      thickness *= i == 1 ? 1e285 : 10.0;
    }
  }
  return grid;
}

TEST_F(RectilinearBeams, MeetWhatWalksMeetInCellsOfAllSizes)
{
  for (const double ratio : { 1.2, 5.0, 300.0, 1e5 })
  {
    SCOPED_TRACE(ratio);
    const Coordinates coordinates = Stretched(Size, ratio, 3);
    Grid<std::uint8_t> smooth(Size);
    FillByPlace(smooth, *coordinates, Wave);
    this->Compare(smooth, coordinates, { 120.0 });
    Grid<double> noise(glm::ivec3(20, 21, 22));
    noise.FillRandomly(-1.0, 1.0, 10);
    this->Compare(noise, Stretched(noise.Field.Dimensions, ratio, 5), { 0.7 });
  }
}

TEST_F(RectilinearBeams, MeetWhatWalksMeetInThinCells)
{
  const Coordinates coordinates = WithThinCells(Size);
  Grid<float> smooth(Size);
  FillByPlace(smooth, *coordinates, Wave);
  this->Compare(smooth, coordinates, { 120.0 });
  Grid<std::int16_t> noise(Size);
  noise.FillRandomly(-1000.0, 1000.0, 11);
  this->Compare(noise, coordinates, { 900.0 });
}

TEST_F(RectilinearBeams, MeetTheFirstOfSeveralIsovalues)
{
  const Coordinates coordinates = Stretched(Size, 20.0, 6);
  Grid<std::uint8_t> smooth(Size);
  FillByPlace(smooth, *coordinates, Wave);
  this->Compare(smooth, coordinates, { 120.0, 60.0, 180.0 });
  this->Compare(smooth, coordinates, { 1e300, 120.0, 120.5, 121.0, -1e300 });
  Grid<float> holes(Size);
  FillByPlace(holes, *coordinates, Wave);
  for (std::size_t i = 0; i < holes.Samples.size(); i += 7)
  {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    holes.Samples[i] = i % 3 == 0 ? std::numeric_limits<float>::quiet_NaN() : infinity;
  }
  this->Compare(holes, coordinates, { 120.0 });
  this->Compare(holes, coordinates, { 120.0, 60.0, 180.0 });
}

TEST_F(RectilinearBeams, MeetWhatWalksMeetOnPartsOfRaysAndBesideHiddenCells)
{
  const Coordinates coordinates = Stretched(Size, 8.0, 7);
  Grid<std::uint8_t> smooth(Size);
  FillByPlace(smooth, *coordinates, Wave);
  smooth.Field.Shape = RectilinearKind(coordinates);
  for (const SurfaceMode mode : { SurfaceMode::Crossing, SurfaceMode::Threshold })
  {
    BothWays<std::uint8_t> ways(smooth, { 120.0 }, mode);
    for (const Camera& camera : CamerasFor(Size))
    {
      const glm::dvec3 off(0.0137, 0.0071, 0.0093);
      ways.CompareCut(ViewFrom(
        { camera.Eye + 7.0 * off, camera.Towards + off, camera.Pixel, camera.Parallel }, 40));
      ASSERT_FALSE(this->HasFatalFailure());
    }
    EXPECT_GT(ways.Hits, ways.Rays / 20);
  }
  const glm::ivec3 cells = Size - 1;
  std::vector<std::uint8_t> flags(static_cast<std::size_t>(cells.x * cells.y * cells.z));
  for (std::size_t i = 0; i < flags.size(); ++i)
  {
    flags[i] = i % 16 == 0 || i % 200 < 60;
  }
  smooth.Field.Hidden = HiddenCells::Make(Size, { flags.data(), 1 });
  this->Compare(smooth, coordinates, { 120.0 });
  this->Compare(smooth, coordinates, { 120.0, 60.0, 180.0 });
}

TEST_F(RectilinearBeams, MeetTheSameOnEveryKindOfVectors)
{
  const Coordinates coordinates = Stretched(Size, 8.0, 9);
  Grid<std::uint8_t> smooth(Size);
  FillByPlace(smooth, *coordinates, Wave);
  this->ForEachTarget(
    [&](const char* target)
    {
      SCOPED_TRACE(target);
      this->Compare(smooth, coordinates, { 120.0 }, 24);
    });
}

}
