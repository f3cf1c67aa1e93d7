// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// The extreme of a ray is that of the interpolant in each of its cells, by any interpolation, on
// images and rectilinear grids. Hidden cells and cells that are not finite hold none.

#include "Checks/Infinity.h"
#include "EachTarget.h"
#include "Grid.h"
#include "Kinds/FieldKind.h"
#include "Lattice/Coordinates.h"
#include "Lattice/RaySource.h"
#include "Volumes/Medium/BlendRays.h"
#include "Volumes/Medium/BlendTracer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace
{

using namespace TemporalCoherence;

constexpr glm::ivec2 Size(24, 16);

/// A transfer function of two nodes.
ComponentLook Look(const glm::dvec2& range, const glm::dvec4& low, const glm::dvec4& high)
{
  ComponentLook look;
  look.Transfer.Range = range;
  look.Transfer.Nodes = { low, high };
  return look;
}

/// A scene of one field, seen by its extremes.
template <typename T>
struct ExtremeScene
{
  ExtremeScene(const Grid<T>& grid, bool isMinimum)
  {
    this->Key.Samples = grid.Field;
    this->Key.Shown.emplace<Blending>().Mode = isMinimum ? BlendMode::Minimum : BlendMode::Maximum;
    this->Key.Blended().Looks = { Look(
      { 0.0, 200.0 }, { 1.0, 0.5, 0.0, 0.0 }, { 0.0, 0.5, 1.0, 1.0 }) };
  }

  BlendedRays Trace(const RayBatch& rays) const
  {
    ValueRangePyramid pyramid;
    pyramid.Build(this->Key.Samples);
    const auto tracer = MakeBlendTracer({ this->Key, nullptr, &pyramid });
    BlendedRays seen;
    WorldDirections world;
    tracer->Begin(seen);
    tracer->Trace(rays, world, seen);
    tracer->Finish(rays, world, seen);
    return seen;
  }

  FrameKey Key;
};

/// The extreme of the field in one cell along a ray: dense samples, and then bisection.
template <typename T>
double LargestIn(const PlainField<T>& field, const RayBatch& rays, std::size_t ray,
  const glm::ivec3& cell, double enter, double leave, double sign)
{
  const auto at = [&](double t)
  { return sign * field.ValueAt(cell, PlainField<T>::PointOf(rays, ray, t)); };
  constexpr int steps = 48;
  const double step = (leave - enter) / steps;
  int best = 0;
  for (int i = 1; i <= steps; ++i)
  {
    best = at(enter + i * step) > at(enter + best * step) ? i : best;
  }
  double low = std::max(enter, enter + (best - 1) * step);
  double high = std::min(leave, enter + (best + 1) * step);
  double largest = at(enter + best * step);
  for (int i = 0; i < 60 && field.Field.Between == Interpolation::Linear; ++i)
  {
    const double first = low + (high - low) / 3.0, second = high - (high - low) / 3.0;
    (at(first) < at(second) ? low : high) = at(first) < at(second) ? first : second;
    largest = std::max({ largest, at(first), at(second) });
  }
  return largest;
}

/// The same along the whole ray; minus infinity if it meets no cell.
template <typename T>
double Largest(const PlainField<T>& field, const RayBatch& rays, std::size_t ray, double sign)
{
  double largest = -Infinity;
  field.ForEachCell(rays, ray,
    [&](const glm::ivec3& cell, double enter, double leave)
    { largest = std::max(largest, LargestIn(field, rays, ray, cell, enter, leave, sign)); });
  return largest;
}

template <typename T>
class ExtremesOf : public EachTarget
{
protected:
  static constexpr glm::ivec3 Dimensions{ 9, 7, 6 };

  ExtremesOf()
    : Samples(Dimensions)
  {
    this->Samples.FillRandomly(0.0, 120.0, 3);
  }

  /// Compare what tiles of a view see with the truth.
  void ExpectTruth(const glm::dvec3& direction, bool isMinimum,
    const GridCoordinates* grid = nullptr, bool isParallel = false)
  {
    const View view = LookAt(Dimensions, direction, Size, isParallel);
    const RaySource source(view, IndexTransform(), Dimensions);
    const ExtremeScene<T> scene(this->Samples, isMinimum);
    const PlainField<T> truth{ this->Samples.Field, grid };
    for (std::int64_t tile = 0; tile < NumberOfTiles(Size); ++tile)
    {
      const PixelRect part = PixelsOfTile(Size, tile);
      RayBatch rays;
      source.SetUp(part.First, part.Size, rays);
      const BlendedRays seen = scene.Trace(rays);
      for (std::size_t ray = 0; ray < static_cast<std::size_t>(rays.Count); ++ray)
      {
        this->ExpectRay(truth, rays, ray, isMinimum ? -1.0 : 1.0, seen);
      }
    }
    EXPECT_GT(this->Met, 30);
  }

  void ExpectRay(const PlainField<T>& truth, const RayBatch& rays, std::size_t ray, double sign,
    const BlendedRays& seen)
  {
    const double expected = Largest(truth, rays, ray, sign);
    ASSERT_EQ(std::isnan(seen.Value[ray]), expected == -Infinity) << ray;
    if (expected == -Infinity)
    {
      EXPECT_EQ(seen.Passed[ray], 1.0f);
      EXPECT_EQ(seen.First[ray], Infinity);
      return;
    }
    ++this->Met;
    // 32-bit numbers hold samples of 16 bits and eight bits more.
    EXPECT_NEAR(sign * seen.Value[ray], expected, 1e-4) << ray;
    EXPECT_GE(seen.First[ray], rays.Begin[ray]);
    EXPECT_LE(seen.First[ray], rays.End[ray]);
    const double alpha = std::clamp(sign * expected / 200.0, 0.0, 1.0);
    EXPECT_NEAR(1.0f - seen.Passed[ray], alpha, 1e-5);
    EXPECT_NEAR(seen.Color[0][ray], (1.0 - alpha) * alpha, 1e-5);
    EXPECT_NEAR(seen.Color[1][ray], 0.5 * alpha, 1e-5);
  }

  Grid<T> Samples;
  int Met = 0; ///< rays that meet something
};

using ProjectedTypes = ::testing::Types<std::int8_t, std::uint8_t, std::int16_t, std::uint16_t,
  std::int32_t, std::uint64_t, float, double>;
TYPED_TEST_SUITE(ExtremesOf, ProjectedTypes);

TYPED_TEST(ExtremesOf, Linear)
{
  this->ExpectTruth({ 1.0, 0.7, 0.4 }, false);
  this->ExpectTruth({ -1.0, 0.2, -0.4 }, true);
}

TYPED_TEST(ExtremesOf, AlongAxes)
{
  this->ExpectTruth({ 0.0, 0.0, 1.0 }, false, nullptr, true);
  this->ExpectTruth({ 0.0, -1.0, 0.0 }, false);
  this->ExpectTruth({ 1.0, 0.0, 0.0 }, true, nullptr, true);
}

TYPED_TEST(ExtremesOf, Nearest)
{
  this->Samples.Field.Between = Interpolation::Nearest;
  this->ExpectTruth({ 0.3, 0.7, -0.4 }, false);
  this->ExpectTruth({ 0.3, -0.7, -0.4 }, true);
}

TYPED_TEST(ExtremesOf, Rectilinear)
{
  const auto grid = Stretched(this->Dimensions, 5.0, 2);
  this->Samples.Field.Shape = RectilinearKind(grid);
  this->ExpectTruth({ 0.3, 0.7, -0.4 }, false, grid.get());
  this->ExpectTruth({ -0.3, 0.7, 0.9 }, true, grid.get());
  this->Samples.Field.Between = Interpolation::Nearest;
  this->ExpectTruth({ 0.3, 0.7, -0.4 }, false, grid.get());
}

TYPED_TEST(ExtremesOf, HiddenCells)
{
  std::vector<std::uint8_t> cells(8 * 6 * 5, 0);
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    cells[i] = i * 7919 % 3 == 0;
  }
  HidingFlags flags;
  flags.OfCells = cells.data();
  flags.CellMask = 1;
  this->Samples.Field.Hidden = HiddenCells::Make(this->Dimensions, flags);
  this->ExpectTruth({ 0.3, 0.7, -0.4 }, false);
  this->Samples.Field.Between = Interpolation::Nearest;
  this->ExpectTruth({ 0.3, 0.7, -0.4 }, true);
}

class FloatExtremes : public ExtremesOf<float>
{
};

TEST_F(FloatExtremes, CellsThatAreNotFiniteHoldNothing)
{
  this->Samples.At(3, 3, 2) = std::numeric_limits<float>::quiet_NaN();
  this->Samples.At(6, 1, 4) = std::numeric_limits<float>::infinity();
  this->Samples.At(1, 5, 1) = -std::numeric_limits<float>::infinity();
  this->ExpectTruth({ 0.3, 0.7, -0.4 }, false);
  this->ExpectTruth({ 0.3, 0.7, -0.4 }, true);
}

}
