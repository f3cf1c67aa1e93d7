// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Flags, masks and NaN hide cells. Hidden cells are not active. With THRESHOLD, solids are capped
// at them with the normals of their faces.

#include "Acceleration/ActiveCells.h"
#include "Grid.h"
#include "Kinds/FieldKind.h"
#include "Lattice/SurfaceTracer.h"
#include "Scene/HiddenCells.h"
#include "Shade/CapNormal.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace
{

using namespace TemporalCoherence;

/// Flags at random, of which some have bits that hide nothing.
std::vector<std::uint8_t> RandomFlags(const glm::ivec3& count, double share, unsigned seed)
{
  std::vector<std::uint8_t> flags(static_cast<std::size_t>(count.x * count.y * count.z));
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> chance(0.0, 1.0);
  for (std::uint8_t& flag : flags)
  {
    flag = static_cast<std::uint8_t>((chance(engine) < share ? 4 : 0) | (engine() % 4));
  }
  return flags;
}

std::uint8_t FlagAt(
  const std::vector<std::uint8_t>& flags, const glm::ivec3& place, const glm::ivec3& count)
{
  return flags[static_cast<std::size_t>((place.z * count.y + place.y) * count.x + place.x)];
}

glm::ivec3 Corner(int corner)
{
  return { corner & 1, corner >> 1 & 1, corner >> 2 };
}

template <typename Visit>
void ForEach(const glm::ivec3& count, const Visit& visit)
{
  for (int i = 0; i < count.x * count.y * count.z; ++i)
  {
    visit(glm::ivec3(i % count.x, i / count.x % count.y, i / count.x / count.y));
  }
}

bool TouchesHidden(const HiddenCells& hidden, const glm::ivec3& cell)
{
  bool touches = false;
  ForEach(glm::ivec3(3),
    [&](const glm::ivec3& step) { touches = touches || hidden.IsHidden(cell + step - 1); });
  return touches;
}

TEST(HiddenCells, AreThoseWhoseFlagsTell)
{
  unsigned seed = 1;
  for (const glm::ivec3 samples :
    { glm::ivec3(37, 18, 9), glm::ivec3(2, 2, 2), glm::ivec3(17, 5, 34), glm::ivec3(6, 33, 4) })
  {
    const glm::ivec3 cells = samples - 1;
    const std::vector<std::uint8_t> ofCells = RandomFlags(cells, 0.2, ++seed);
    const std::vector<std::uint8_t> ofSamples = RandomFlags(samples, 0.04, ++seed);
    std::vector<std::uint8_t> shown = RandomFlags(samples, 0.1, ++seed);
    for (std::uint8_t& flag : shown)
    {
      flag &= 4;
    }
    for (int which = 1; which < 8; ++which)
    {
      HidingFlags flags;
      flags.OfCells = which & 1 ? ofCells.data() : nullptr;
      flags.OfSamples = which & 2 ? ofSamples.data() : nullptr;
      flags.Shown = which & 4 ? shown.data() : nullptr;
      flags.CellMask = flags.SampleMask = 4 | 8;
      const std::shared_ptr<const HiddenCells> hidden = HiddenCells::Make(samples, flags);
      ForEach(cells,
        [&](const glm::ivec3& cell)
        {
          bool isHidden = flags.OfCells && (FlagAt(ofCells, cell, cells) & 4);
          bool isShown = false;
          for (int corner = 0; corner < 8; ++corner)
          {
            const glm::ivec3 place = cell + Corner(corner);
            isHidden = isHidden || (flags.OfSamples && (FlagAt(ofSamples, place, samples) & 4));
            isShown = isShown || FlagAt(shown, place, samples) != 0;
          }
          isHidden = isHidden || (flags.Shown && !isShown);
          ASSERT_EQ(hidden && hidden->IsHidden(cell), isHidden);
        });
      if (hidden)
      {
        EXPECT_FALSE(hidden->IsHidden(glm::ivec3(-1, 0, 0)));
        EXPECT_FALSE(hidden->IsHidden(glm::ivec3(0, cells.y, 0)));
      }
    }
  }
}

TEST(HiddenCells, ThereAreNoneWhereNothingIsHidden)
{
  const glm::ivec3 samples(20, 9, 7);
  const std::vector<std::uint8_t> flags = RandomFlags(samples, 0.0, 3);
  EXPECT_FALSE(HiddenCells::Make(samples, {}));
  EXPECT_FALSE(HiddenCells::Make(samples, { flags.data(), 4, flags.data(), 4 }));
  EXPECT_TRUE(HiddenCells::Make(samples, { flags.data(), 4, flags.data(), 1 }));
  const std::vector<std::uint8_t> ones(flags.size(), 1);
  EXPECT_FALSE(HiddenCells::Make(samples, { nullptr, 0, nullptr, 0, ones.data() }));
}

template <typename T>
void ExpectHiddenAroundNaN(const glm::ivec3& samples, int components, double chance)
{
  Grid<T> grid(samples, components, components - 1);
  grid.FillRandomly(-1.0, 1.0, 7);
  std::mt19937 engine(9);
  ForEach(samples,
    [&](const glm::ivec3& place)
    {
      const double random = static_cast<double>(engine() % 10000u) / 10000.0;
      T& sample = grid.At(place.x, place.y, place.z);
      sample = random < chance  ? std::numeric_limits<T>::quiet_NaN()
        : random < 2.0 * chance ? -std::numeric_limits<T>::infinity()
                                : sample;
    });
  const glm::ivec3 cells = samples - 1;
  const std::vector<std::uint8_t> flags = RandomFlags(cells, 0.1, 4);
  for (const bool areFlagged : { false, true })
  {
    grid.Field.Flagged =
      areFlagged ? HiddenCells::Make(samples, { flags.data(), 4, nullptr, 0 }) : nullptr;
    ValueRangePyramid pyramid;
    pyramid.Build(grid.Field);
    const auto hidden = HiddenCells::WithoutNaN(grid.Field, pyramid.LeavesWithNaN());
    bool isAnyHidden = false;
    ForEach(cells,
      [&](const glm::ivec3& cell)
      {
        bool isHidden = areFlagged && (FlagAt(flags, cell, cells) & 4);
        for (int corner = 0; corner < 8; ++corner)
        {
          const glm::ivec3 place = cell + Corner(corner);
          isHidden = isHidden || std::isnan(grid.At(place.x, place.y, place.z));
        }
        isAnyHidden = isAnyHidden || isHidden;
        ASSERT_EQ(hidden && hidden->IsHidden(cell), isHidden);
      });
    EXPECT_EQ(hidden != nullptr, isAnyHidden);
  }
}

TEST(HiddenCells, AreThoseAroundNaN)
{
  for (const double chance : { 0.0, 0.001, 0.1 })
  {
    for (const glm::ivec3 samples :
      { glm::ivec3(37, 18, 9), glm::ivec3(2, 2, 2), glm::ivec3(17, 5, 34), glm::ivec3(65, 6, 33) })
    {
      ExpectHiddenAroundNaN<float>(samples, 1, chance);
      ExpectHiddenAroundNaN<double>(samples, 2, chance);
    }
  }
}

TEST(HiddenCells, AroundAreThoseThatTouchThem)
{
  const glm::ivec3 samples(38, 21, 10);
  const std::vector<std::uint8_t> flags = RandomFlags(samples - 1, 0.01, 5);
  const std::shared_ptr<const HiddenCells> hidden =
    HiddenCells::Make(samples, { flags.data(), 4, nullptr, 0 });
  ForEach(samples - 1,
    [&](const glm::ivec3& cell)
    {
      const bool isAround = hidden->Around(cell & ~3) >> ActiveCells::BitOf(cell) & 1u;
      ASSERT_EQ(isAround, TouchesHidden(*hidden, cell));
    });
}

/// Some cells of a grid are hidden at random.
template <typename T>
void Hide(Grid<T>& grid, double share, unsigned seed)
{
  const std::vector<std::uint8_t> flags = RandomFlags(grid.Field.Dimensions - 1, share, seed);
  grid.Field.Hidden = HiddenCells::Make(grid.Field.Dimensions, { flags.data(), 4, nullptr, 0 });
}

template <typename T>
void ExpectActive(Grid<T>& grid, const Surfaces& surfaces)
{
  ValueRangePyramid pyramid;
  pyramid.Build(grid.Field);
  ActiveCells active;
  active.Build(grid.Field, pyramid, surfaces);
  const TypedField<T> field(grid.Field);
  const HiddenCells& hidden = *grid.Field.Hidden;
  ForEach(grid.Field.Dimensions - 1,
    [&](const glm::ivec3& cell)
    {
      bool isActive = false;
      for (const double isovalue : surfaces.Isovalues)
      {
        int inside = 0;
        for (int corner = 0; corner < 8; ++corner)
        {
          inside += static_cast<double>(*field.At(cell + Corner(corner))) >= isovalue;
        }
        const bool isCapped =
          surfaces.Mode == SurfaceMode::Threshold && TouchesHidden(hidden, cell);
        isActive = isActive || (inside > 0 && (inside < 8 || isCapped));
      }
      const std::int64_t node = active.NodeOf(cell);
      const bool isLeaf = active.LeavesOf(node) >> ActiveCells::LeafOf(cell) & 1u;
      const std::uint64_t cells = isLeaf ? active.CellsOf(field, node, cell) : 0;
      ASSERT_EQ((cells >> ActiveCells::BitOf(cell) & 1u) != 0, isActive && !hidden.IsHidden(cell))
        << cell.x << ' ' << cell.y << ' ' << cell.z;
      // A word of 0 is one that is not known yet.
      ASSERT_EQ(isLeaf, cells != 0);
    });
}

TEST(HiddenCells, AreNotActive)
{
  for (const double share : { 0.01, 0.4, 0.97, 1.0 })
  {
    Grid<std::uint8_t> bytes(glm::ivec3(37, 18, 9));
    bytes.FillRandomly(0.0, 20.0, 1);
    Hide(bytes, share, 7);
    Grid<float> smooth(glm::ivec3(33, 30, 35));
    smooth.Fill([](int i, int j, int k) { return 0.5 * i - 0.25 * j + k; });
    Hide(smooth, share, 8);
    for (const SurfaceMode mode : { SurfaceMode::Crossing, SurfaceMode::Threshold })
    {
      ExpectActive(bytes, { { 10.0 }, mode });
      ExpectActive(bytes, { { 19.0, 2.0 }, mode });
      ExpectActive(bytes, { { -5.0 }, mode });
      ExpectActive(bytes, { { 300.0 }, mode });
      ExpectActive(bytes, { {}, mode });
      ExpectActive(smooth, { { 14.0 }, mode });
      ExpectActive(smooth, { { 1.0, 20.0, 30.0 }, mode });
    }
  }
}

/// The hits of parallel rays along x through the middle of cells.
HitBatch TraceAlongX(const Field& field, const Surfaces& surfaces, bool leaps, double begin)
{
  ValueRangePyramid pyramid;
  pyramid.Build(field);
  ActiveCells active;
  active.Build(field, pyramid, surfaces);
  RayBatch rays;
  for (int i = 0; i < 10; ++i)
  {
    const auto at = static_cast<std::size_t>(rays.Count++);
    const glm::dvec3 origin(-1.0, 1.5 + i, 4.3), direction(1.0, 1e-9, 1e-9);
    for (std::size_t a = 0; a < 3; ++a)
    {
      rays.Origin[a][at] = origin[static_cast<int>(a)];
      rays.Direction[a][at] = direction[static_cast<int>(a)];
      rays.Inverse[a][at] = 1.0 / direction[static_cast<int>(a)];
    }
    rays.Begin[at] = rays.WalkBegin[at] = begin;
    rays.End[at] = rays.WalkEnd[at] = 1.0 + field.Dimensions.x - 1;
  }
  HitBatch hits;
  MakeSurfaceTracer({ field, surfaces, pyramid.FiniteRange(), leaps ? &active : nullptr })
    ->Trace(rays, hits);
  return hits;
}

TEST(HiddenCells, CutSolidsOpenWhichAreCapped)
{
  // A solid everywhere, of which the cells 4 <= x < 9 are hidden.
  Grid<std::int16_t> grid(glm::ivec3(17, 14, 12));
  grid.Fill([](int i, int, int) { return 10 + i; });
  const glm::ivec3 cells = grid.Field.Dimensions - 1;
  std::vector<std::uint8_t> flags;
  ForEach(cells, [&](const glm::ivec3& cell) { flags.push_back(cell.x >= 4 && cell.x < 9); });
  grid.Field.Hidden = HiddenCells::Make(grid.Field.Dimensions, { flags.data(), 1, nullptr, 0 });
  for (const bool leaps : { false, true })
  {
    for (const Interpolation between : { Interpolation::Linear, Interpolation::Nearest })
    {
      grid.Field.Between = between;
      const auto expectAll =
        [&](const Surfaces& surfaces, double begin, double x, int surface, HitKind kind)
      {
        const HitBatch hits = TraceAlongX(grid.Field, surfaces, leaps, begin);
        for (std::size_t i = 0; i < 10; ++i)
        {
          EXPECT_EQ(hits.Kind[i], kind);
          EXPECT_EQ(hits.Surface[i], surface);
          if (surface >= 0)
          {
            EXPECT_NEAR(hits.Depth[i], 1.0 + x, 1e-6);
          }
        }
      };
      const auto solid = [](std::vector<double> isovalues) {
        return Surfaces{ std::move(isovalues), SurfaceMode::Threshold };
      };
      // It begins outside of hidden cells: the cap is where it begins.
      expectAll(solid({ 5.0 }), 1.0, 0.0, 0, HitKind::Cap);
      expectAll(solid({ 5.0, 8.0, 6.0 }), 3.0, 2.0, 1, HitKind::Cap);
      // It begins in a hidden cell: the cap is where these end, that of the highest there.
      expectAll(solid({ 5.0 }), 7.5, 9.0, 0, HitKind::Cap);
      expectAll(solid({ 5.0, 18.5, 25.0, 17.0 }), 7.5, 9.0, 1, HitKind::Cap);
      // The solid begins in hidden cells: it is capped behind.
      expectAll(solid({ 16.0 }), 1.0, 9.0, 0, HitKind::Cap);
      expectAll(
        solid({ 20.5 }), 1.0, between == Interpolation::Linear ? 10.5 : 10.5, 0, HitKind::Entry);
      // Open, there is nothing but what is met in cells that are not hidden.
      expectAll({ { 16.0 }, SurfaceMode::Crossing }, 1.0, 0.0, -1, HitKind::None);
      expectAll({ { 16.0, 20.5 }, SurfaceMode::Crossing }, 1.0, 10.5, 1, HitKind::Entry);
    }
  }
}

TEST(HiddenCells, CapsHaveTheNormalsOfTheirFaces)
{
  Field field;
  field.Dimensions = glm::ivec3(17, 14, 12);
  std::vector<std::uint8_t> flags;
  ForEach(field.Dimensions - 1,
    [&](const glm::ivec3& cell) { flags.push_back(cell.x >= 4 && cell.x < 9 && cell.y >= 6); });
  field.Hidden = HiddenCells::Make(field.Dimensions, { flags.data(), 1, nullptr, 0 });
  const auto expect = [&](const glm::dvec3& point, const glm::dvec3& direction,
                        const glm::dvec3& normal) {
    EXPECT_EQ(CapNormal({ point, direction }, field, KindOf(field), {}), normal);
  };
  expect({ 9.0, 7.3, 2.2 }, { 1.0, 0.5, 0.2 }, { -1.0, 0.0, 0.0 });
  expect({ 4.0, 7.3, 2.2 }, { -1.0, 0.5, 0.2 }, { 1.0, 0.0, 0.0 });
  expect({ 5.5, 6.0, 2.2 }, { 1.0, -0.5, 0.2 }, { 0.0, 1.0, 0.0 });
  // No hidden cell before it, or no plane: nothing that a normal could come from.
  expect({ 9.0, 7.3, 2.2 }, { -1.0, 0.5, 0.2 }, glm::dvec3(0.0));
  expect({ 9.5, 7.3, 2.2 }, { 1.0, 0.5, 0.2 }, glm::dvec3(0.0));
}

}
