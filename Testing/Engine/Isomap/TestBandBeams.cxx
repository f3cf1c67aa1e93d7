// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Beams find the knots that walks find, byte by byte, on any field, from anywhere, on every kind of
// vectors. Keys of knots ascend.
#include "Acceleration/ActiveCells.h"
#include "Checks/Sanitized.h"
#include "EachTarget.h"
#include "Grid.h"
#include "Isomap/BandTracer.h"
#include "Kinds/FieldKind.h"
#include "Lattice/BeamCameras.h"
#include "Lattice/RaySource.h"
#include "Lattice/Waves.h"
#include "Scene/Tiles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <memory>
#include <random>
#include <vector>

namespace
{

using namespace TemporalCoherence;

/// A search for a key needs keys in their order.
bool AreAscending(const CellKnots& knots)
{
  bool areAscending = true;
  for (std::size_t ray = 0; ray < RayBatch::Capacity && !knots.IsEmpty(); ++ray)
  {
    const std::size_t begin = knots.Begin(ray), end = knots.Begin(ray + 1);
    areAscending = areAscending && std::is_sorted(knots.Get<0>() + begin, knots.Get<0>() + end);
  }
  return areAscending;
}

template <std::size_t Column, typename... Columns>
bool IsSameColumn(const RayTable<Columns...>& a, const RayTable<Columns...>& b)
{
  using Type = typename RayTable<Columns...>::template TypeOf<Column>;
  return std::memcmp(a.template Get<Column>(), b.template Get<Column>(),
           a.NumberOfRows() * sizeof(Type)) == 0;
}

template <typename... Columns, std::size_t... Column>
bool IsSameTable(
  const RayTable<Columns...>& a, const RayTable<Columns...>& b, std::index_sequence<Column...>)
{
  if (a.IsEmpty() || b.IsEmpty())
  {
    return a.IsEmpty() == b.IsEmpty();
  }
  for (std::size_t ray = 0; ray <= RayBatch::Capacity; ++ray)
  {
    if (a.Begin(ray) != b.Begin(ray))
    {
      return false;
    }
  }
  return (IsSameColumn<Column>(a, b) && ...);
}

template <typename... Columns>
bool IsSame(const RayTable<Columns...>& a, const RayTable<Columns...>& b)
{
  return IsSameTable(a, b, std::index_sequence_for<Columns...>());
}

bool AreSame(const TileKnots& a, const TileKnots& b)
{
  bool areSame = a.Entries == b.Entries && a.Unresolved == b.Unresolved;
  for (std::size_t direction = 0; direction < NumberOfDirections; ++direction)
  {
    areSame = areSame && IsSame(a.Cells[direction], b.Cells[direction]) &&
      IsSame(a.Fitted[direction], b.Fitted[direction]) &&
      IsSame(a.Normals[direction], b.Normals[direction]);
  }
  return areSame;
}

/// Builds the knots of tiles both ways, and compares.
class KnotsBothWays
{
public:
  template <typename T>
  KnotsBothWays(Grid<T>& grid, const ValueBand& band, SurfaceMode mode, const KnotForm& form)
    : Dimensions(grid.Field.Dimensions)
  {
    this->Pyramid.Build(grid.Field);
    this->Active.Build(grid.Field, this->Pyramid, band, mode);
    BandScene scene;
    scene.Samples = grid.Field;
    scene.FiniteRange = this->Pyramid.FiniteRange();
    scene.Pyramid = &this->Pyramid;
    scene.Active = &this->Active;
    scene.Band = band;
    scene.Mode = mode;
    scene.Form = form;
    scene.By = Traversal::Walks;
    this->Walks = MakeBandTracer(scene);
    scene.By = Traversal::Beams;
    this->Beams = MakeBandTracer(scene);
  }

  /// All tiles of a view.
  /// \param areCut rays begin and end anywhere, and walk a part of that
  void Compare(const View& view, bool areCut)
  {
    const RaySource source(view, IndexTransform(), this->Dimensions);
    for (std::int64_t tile = 0; tile < NumberOfTiles(view.Size); ++tile)
    {
      const PixelRect part = PixelsOfTile(view.Size, tile);
      RayBatch rays;
      source.SetUp(part.First, part.Size, rays);
      for (int i = 0; i < rays.Count && areCut; ++i)
      {
        this->Cut(static_cast<std::size_t>(i), rays);
      }
      TileKnots walked, beamed;
      this->Walks->Trace(rays, walked);
      this->Beams->Trace(rays, beamed);
      this->Knots += walked.NumberOfKnots();
      ASSERT_TRUE(AreSame(walked, beamed)) << "tile " << tile;
      ASSERT_TRUE(AreAscending(walked.Cells[0]) && AreAscending(walked.Cells[1]));
    }
  }

  std::size_t Knots = 0;

private:
  void Cut(std::size_t i, RayBatch& rays)
  {
    const double length = rays.End[i] - rays.Begin[i];
    const auto cut = [&] { return std::max(0.5 * this->Share(this->Random) * length, 0.0); };
    rays.WalkBegin[i] = rays.Begin[i] += cut();
    rays.WalkEnd[i] = rays.End[i] -= cut();
    rays.WalkBegin[i] += cut();
    rays.WalkEnd[i] -= cut();
  }

  glm::ivec3 Dimensions;
  ValueRangePyramid Pyramid;
  ActiveCells Active;
  std::shared_ptr<const BandTracer> Walks, Beams;
  std::mt19937 Random{ 7 };
  std::uniform_real_distribution<double> Share{ -0.3, 1.0 };
};

class BandBeams : public EachTarget
{
protected:
  /// All forms of knots, in both modes, from everywhere.
  template <typename T>
  void Compare(
    Grid<T>& grid, const std::vector<ValueBand>& bands, int pixels = IsMemorySanitized ? 8 : 24)
  {
    for (const SurfaceMode mode : { SurfaceMode::Crossing, SurfaceMode::Threshold })
    {
      for (const KnotForm& form :
        { KnotForm{ 0.0, false }, KnotForm{ 0.0, true }, KnotForm{ 0.01, true } })
      {
        std::size_t knots = 0;
        for (const ValueBand& band : bands)
        {
          KnotsBothWays ways(grid, band, mode, form);
          bool isCut = false;
          for (const Camera& camera : CamerasFor(grid.Field.Dimensions))
          {
            SCOPED_TRACE(testing::Message()
              << "band " << band.Low << " to " << band.High << " tolerance " << form.Tolerance
              << " mode " << static_cast<int>(mode));
            ASSERT_NO_FATAL_FAILURE(ways.Compare(ViewFrom(camera, pixels), isCut));
            isCut = !isCut;
          }
          knots += ways.Knots;
        }
        EXPECT_GT(knots, IsMemorySanitized ? 100u : 1000u);
      }
    }
  }
};

TEST_F(BandBeams, LeaveTheKnotsOfWalksInSmoothFields)
{
  Grid<std::uint8_t> bytes(glm::ivec3(50, 41, 37));
  bytes.Fill([](int i, int j, int k) { return 120.0 + 80.0 * Wave(i, j, k); });
  this->Compare(bytes, { { 120.0, 121.0 }, { 150.25, 158.5 }, { 0.0, 255.0 } });
  Grid<float> floats(glm::ivec3(30, 41, 37));
  floats.Fill(Wave);
  this->Compare(floats, { { 0.1, 0.11 }, { -0.5, 0.9 } });
}

TEST_F(BandBeams, LeaveTheKnotsOfWalksAtSamplesEqualToIsovalues)
{
  Grid<std::int16_t> ball(glm::ivec3(31, 31, 31));
  ball.Fill([](int i, int j, int k)
    { return 16.0 * std::round(glm::length(glm::dvec3(i - 15.0, j - 15.0, k - 15.0))); });
  this->Compare(ball, { { 160.0, 176.0 }, { 160.0, 160.0 }, { 100.0, 240.0 } });
  Grid<std::uint8_t> steps(glm::ivec3(33, 34, 35));
  steps.Fill([](int i, int j, int k) { return (i / 3 + j / 4 + k / 5) % 5; });
  this->Compare(steps, { { 2.0, 3.0 }, { 2.0, 2.0 }, { 1.0, 4.0 } });
}

TEST_F(BandBeams, LeaveTheKnotsOfWalksInNoise)
{
  Grid<double> doubles(glm::ivec3(20, 21, 22));
  doubles.FillRandomly(-1.0, 1.0, 10);
  this->Compare(doubles, { { 0.7, 0.71 }, { -0.2, 0.9 } });
  // Rounding errors differ much from cell to cell.
  Grid<std::uint16_t> steep(glm::ivec3(20, 20, 25));
  steep.FillRandomly(0.0, 60000.0, 12);
  this->Compare(steep, { { 59000.0, 59001.0 }, { 30000.0, 30000.01 } });
  Grid<std::int8_t> bytes(glm::ivec3(20, 20, 25));
  bytes.FillRandomly(-100.0, 100.0, 11);
  this->Compare(bytes, { { 60.5, 61.5 }, { -20.0, 80.0 } });
}

TEST_F(BandBeams, LeaveTheKnotsOfWalksOfAnyType)
{
  const auto compare = [this](auto sample, double unit)
  {
    Grid<decltype(sample)> waves(glm::ivec3(17, 19, 18));
    waves.Fill([unit](int i, int j, int k) { return unit * (1.5 + Wave(i, j, k)); });
    this->Compare(waves, { { 1.5 * unit, 1.51 * unit }, { unit, 2.0 * unit } }, 16);
  };
  compare(std::uint16_t(), 20000.0);
  compare(std::int32_t(), 5e8);
  compare(std::uint32_t(), 1e9);
  compare(std::int64_t(), 2e18);
  compare(std::uint64_t(), 5e18);
  compare(double(), 1e300);
  compare(double(), 1e-300);
}

TEST_F(BandBeams, LeaveTheKnotsOfWalksAtSamplesThatAreNotFinite)
{
  Grid<float> holes(glm::ivec3(24, 21, 27));
  holes.Fill(
    [](int i, int j, int k)
    {
      const double infinity = std::numeric_limits<double>::infinity();
      return j % 9 == 0 && i % 3 == 0 ? infinity
        : k % 11 == 0 && i % 3 == 1   ? -infinity
                                      : Wave(i, j, k);
    });
  this->Compare(holes, { { 0.1, 0.11 }, { -0.5, 0.9 } });
}

TEST_F(BandBeams, LeaveTheSameKnotsOnEveryKindOfVectors)
{
  Grid<std::uint8_t> bytes(glm::ivec3(30, 31, 27));
  bytes.Fill([](int i, int j, int k) { return 120.0 + 80.0 * Wave(i, j, k); });
  Grid<double> noise(glm::ivec3(12, 13, 14));
  noise.FillRandomly(-1.0, 1.0, 10);
  this->ForEachTarget(
    [&](const char* target)
    {
      SCOPED_TRACE(target);
      this->Compare(bytes, { { 120.0, 121.0 }, { 100.0, 150.0 } }, 16);
      this->Compare(noise, { { 0.6, 0.7 } }, 16);
    });
}

TEST_F(BandBeams, GoOnPastManyCells)
{
  // More cells than a beam remembers, and none that ends the way of a ray.
  Grid<float> checks(glm::ivec3(64, 64, 64));
  checks.Fill([](int i, int j, int k) { return (i + j + k) % 2 ? 1e-3 * (i + k) : -1.0; });
  this->Compare(checks, { { 0.0, 1.0 } }, 16);
}

}
