// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Beams find the extremes that walks find, bit by bit. What cannot be seen need not be found.

#include "EachTarget.h"
#include "Grid.h"
#include "Lattice/Coordinates.h"
#include "Lattice/RaySource.h"
#include "Volumes/Projections/ExtremeSearch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace
{

using namespace TemporalCoherence;

/// What a search finds.
struct Extremes
{
  Extremes()
  {
    this->Value.fill(std::numeric_limits<double>::quiet_NaN());
    this->First.fill(std::numeric_limits<double>::infinity());
  }

  RayBatch::Array<double> Value, First;
  std::int64_t CellsRead = 0;
};

template <typename T>
class ExtremeBeamsOf : public EachTarget
{
protected:
  static constexpr glm::ivec3 Dimensions{ 43, 22, 37 };
  static constexpr glm::ivec2 Size{ 44, 28 };

  ExtremeBeamsOf()
    : Samples(Dimensions)
  {
  }

  void FillWithNoise() { this->Samples.FillRandomly(0.0, 120.0, 8); }

  /// Waves that are cut off: large parts are as high as can be.
  void FillWithPlateaus()
  {
    this->Samples.Fill(
      [](int i, int j, int k)
      {
        return std::clamp(
          60.0 + 110.0 * std::sin(0.3 * i + 0.2 * j) * std::cos(0.25 * k), 0.0, 120.0);
      });
  }

  /// All extremes are asked for.
  static double LeastOf(bool isMinimum)
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    return isMinimum ? infinity : -infinity;
  }

  /// Compare beams with walks, on all kinds of vectors.
  void ExpectSame(const View& view, const GridCoordinates* grid = nullptr)
  {
    ValueRangePyramid pyramid;
    pyramid.Build(this->Samples.Field);
    const RaySource source(view, IndexTransform(), Dimensions);
    for (const bool isMinimum : { false, true })
    {
      const ExtremeTask task{ this->Samples.Field, &pyramid, grid, isMinimum, LeastOf(isMinimum),
        true };
      const auto beams = MakeExtremeSearch(task);
      const auto walks = MakeExtremeSearch(
        { this->Samples.Field, &pyramid, grid, isMinimum, LeastOf(isMinimum), false });
      for (std::int64_t tile = 0; tile < NumberOfTiles(view.Size); ++tile)
      {
        const PixelRect part = PixelsOfTile(view.Size, tile);
        RayBatch rays;
        source.SetUp(part.First, part.Size, rays);
        const Extremes expected = Search(*walks, rays);
        this->ForEachTarget(
          [&](const char* target)
          {
            const Extremes found = Search(*beams, rays);
            ASSERT_TRUE(AreIdentical(found.Value, expected.Value, rays.Count)) << target << tile;
            ASSERT_TRUE(AreIdentical(found.First, expected.First, rays.Count)) << target << tile;
          });
      }
    }
  }

  /// Search two pieces of each ray.
  static Extremes Search(const ExtremeSearch& search, const RayBatch& rays)
  {
    Extremes found;
    RayBatch part = rays;
    for (std::size_t i = 0; i < static_cast<std::size_t>(rays.Count); ++i)
    {
      part.End[i] = part.WalkEnd[i] = rays.Begin[i] + 0.3 * (rays.End[i] - rays.Begin[i]);
    }
    search.Search(part, { found.Value, found.First, found.CellsRead });
    part = rays;
    for (std::size_t i = 0; i < static_cast<std::size_t>(rays.Count); ++i)
    {
      part.Begin[i] = part.WalkBegin[i] = rays.Begin[i] + 0.4 * (rays.End[i] - rays.Begin[i]);
    }
    search.Search(part, { found.Value, found.First, found.CellsRead });
    return found;
  }

  void ExpectSameInViews(const GridCoordinates* grid = nullptr)
  {
    for (const glm::dvec3& direction : { glm::dvec3(1.0, 0.7, 0.4), glm::dvec3(-0.3, 0.5, -0.9),
           glm::dvec3(0.0, 0.0, 1.0), glm::dvec3(0.0, -1.0, 0.001) })
    {
      this->ExpectSame(LookAt(Dimensions, direction, Size), grid);
      this->ExpectSame(LookAt(Dimensions, direction, Size, true), grid);
    }
    this->ExpectSame(this->Within(), grid);
  }

  /// From within the field, with a wide angle.
  static View Within()
  {
    View view;
    const glm::dvec2 range(0.01, 100.0);
    EXPECT_TRUE(
      MakeView(glm::lookAt(glm::dvec3(20.3, 11.1, 18.2), glm::dvec3(0.0), glm::dvec3(0, 0, 1)),
        glm::perspective(2.0, 1.6, range.x, range.y), range, Size, view));
    return view;
  }

  Grid<T> Samples;
};

/// What is found if extremes up to `least` need not be: the others as if all were asked for.
inline void ExpectWhatIsSeen(
  const Extremes& found, const Extremes& all, double least, bool isMinimum, int count)
{
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
  {
    const auto isSeen = [&](double value) { return isMinimum ? value < least : value > least; };
    ASSERT_EQ(isSeen(found.Value[i]), isSeen(all.Value[i])) << i;
    if (isSeen(all.Value[i]))
    {
      ASSERT_EQ(found.Value[i], all.Value[i]) << i;
      ASSERT_EQ(found.First[i], all.First[i]) << i;
    }
  }
}

using BeamTypes = ::testing::Types<std::uint8_t, std::int16_t, float, double, std::int64_t>;
TYPED_TEST_SUITE(ExtremeBeamsOf, BeamTypes);

TYPED_TEST(ExtremeBeamsOf, FindWhatWalksFind)
{
  this->FillWithNoise();
  this->ExpectSameInViews();
  this->FillWithPlateaus();
  this->ExpectSameInViews();
}

TYPED_TEST(ExtremeBeamsOf, WhatCannotBeSeenNeedNotBeFound)
{
  this->FillWithPlateaus();
  ValueRangePyramid pyramid;
  pyramid.Build(this->Samples.Field);
  const View view = LookAt(this->Dimensions, { 1.0, 0.7, 0.4 }, this->Size);
  const RaySource source(view, IndexTransform(), this->Dimensions);
  for (const double least : { 0.0, 37.0, 70.5, 119.0, 120.0 })
  {
    for (const bool isMinimum : { false, true })
    {
      ExtremeTask task{ this->Samples.Field, &pyramid, nullptr, isMinimum, least };
      const auto search = MakeExtremeSearch(task);
      task.LeastSeen = this->LeastOf(isMinimum);
      const auto whole = MakeExtremeSearch(task);
      for (std::int64_t tile = 0; tile < NumberOfTiles(view.Size); ++tile)
      {
        const PixelRect part = PixelsOfTile(view.Size, tile);
        RayBatch rays;
        source.SetUp(part.First, part.Size, rays);
        ExpectWhatIsSeen(
          this->Search(*search, rays), this->Search(*whole, rays), least, isMinimum, rays.Count);
      }
    }
  }
}

TYPED_TEST(ExtremeBeamsOf, RectilinearGrids)
{
  const auto grid = Stretched(this->Dimensions, 8.0, 5);
  this->Samples.Field.Shape = RectilinearKind(grid);
  this->FillWithNoise();
  this->ExpectSameInViews(grid.get());
  this->FillWithPlateaus();
  this->ExpectSameInViews(grid.get());
}

TYPED_TEST(ExtremeBeamsOf, NearestInterpolation)
{
  this->Samples.Field.Between = Interpolation::Nearest;
  this->FillWithNoise();
  this->ExpectSameInViews();
  this->FillWithPlateaus();
  this->ExpectSameInViews();
}

TYPED_TEST(ExtremeBeamsOf, HiddenCells)
{
  std::vector<std::uint8_t> cells(42 * 21 * 36, 0);
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    cells[i] = i * 7919 % 5 == 0 || i / 2000 % 4 == 1;
  }
  HidingFlags flags;
  flags.OfCells = cells.data();
  flags.CellMask = 1;
  this->Samples.Field.Hidden = HiddenCells::Make(this->Dimensions, flags);
  this->FillWithPlateaus();
  this->ExpectSameInViews();
}

TYPED_TEST(ExtremeBeamsOf, ValuesThatAreNotFinite)
{
  if constexpr (std::is_floating_point_v<TypeParam>)
  {
    this->FillWithNoise();
    for (std::size_t i = 0; i < this->Samples.Samples.size(); i += 97)
    {
      constexpr double infinity = std::numeric_limits<double>::infinity();
      this->Samples.Samples[i] =
        static_cast<TypeParam>(i % 3 == 0 ? infinity : (i % 3 == 1 ? -infinity : std::nan("")));
    }
    this->ExpectSameInViews();
  }
}

}
