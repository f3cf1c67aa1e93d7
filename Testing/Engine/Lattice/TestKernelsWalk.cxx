// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Rays that walk in vectors visit the cells of a walk one by one, on every kind of vectors. Threads
// may ask for the same leaves at the same time.

#include "Checks/Infinity.h"
#include "EachTarget.h"
#include "Grid.h"
#include "Lattice/CellWalk.h"
#include "Lattice/KernelsWalk.h"
#include "Lattice/RaySource.h"

#include <gtest/gtest.h>

#include <array>
#include <thread>
#include <vector>

namespace
{

using namespace TemporalCoherence;

/// The active cells that each ray of a batch visits, in order.
using Visits = std::vector<std::vector<glm::ivec3>>;

template <typename T>
class Leaves final : public LeafSource
{
public:
  Leaves(const ActiveCells& active, const Field& field)
    : Active(active)
    , Samples(field)
  {
  }

  std::uint64_t CellsOf(std::int64_t node, const glm::ivec3& cell) const override
  {
    return this->Active.CellsOf(this->Samples, node, cell);
  }

private:
  const ActiveCells& Active;
  TypedField<T> Samples;
};

template <typename T>
Visits VisitOneByOne(const RayBatch& rays, const ActiveCells& active, const Field& field)
{
  const TypedField<T> samples(field);
  Visits visits(static_cast<std::size_t>(rays.Count));
  for (std::size_t ray = 0; ray < visits.size(); ++ray)
  {
    if (rays.WalkBegin[ray] < rays.WalkEnd[ray])
    {
      CellWalk walk;
      walk.Begin(BatchRay{ rays, ray }, field.Dimensions - 1);
      while (walk.FindActive(BatchRay{ rays, ray }, active, samples))
      {
        visits[ray].push_back(walk.Here());
      }
    }
  }
  return visits;
}

/// \param most a ray that has visited so many cells has found something there
template <typename T>
Visits VisitInVectors(
  const RayBatch& rays, const ActiveCells& active, const Field& field, std::size_t most)
{
  const Leaves<T> leaves(active, field);
  std::uint64_t wanted = 0;
  for (std::size_t ray = 0; ray < static_cast<std::size_t>(rays.Count); ++ray)
  {
    wanted |= static_cast<std::uint64_t>(rays.WalkBegin[ray] < rays.WalkEnd[ray]) << ray;
  }
  Visits visits(static_cast<std::size_t>(rays.Count));
  RayWalks walks(rays, wanted);
  while (walks.Rays.Count > 0)
  {
    FindActiveCells({ active, leaves, field.Dimensions - 1 }, walks);
    for (std::size_t i = 0; i < static_cast<std::size_t>(walks.Rays.Count); ++i)
    {
      const auto ray = static_cast<std::size_t>(walks.From[i]);
      visits[ray].emplace_back(walks.Cell[0][i], walks.Cell[1][i], walks.Cell[2][i]);
      walks.Distance[i] = visits[ray].size() == most ? 1.0 : Infinity;
      EXPECT_EQ(walks.Rays.Begin[i], rays.Begin[ray]);
      EXPECT_EQ(walks.Rays.Origin[1][i], rays.Origin[1][ray]);
    }
  }
  return visits;
}

class KernelsWalk : public EachTarget
{
protected:
  /// Walk through a grid from all sides.
  template <typename T>
  void Compare(Grid<T>& grid, double isovalue)
  {
    ValueRangePyramid pyramid;
    pyramid.Build(grid.Field);
    const glm::ivec2 size(29, 23);
    std::size_t visited = 0;
    for (const glm::dvec3 direction : { glm::dvec3(-1.0, -2.0, 0.8), glm::dvec3(1.0, 0.3, -0.6),
           glm::dvec3(0.0, 0.0, 1.0), glm::dvec3(0.0, -1.0, 0.0) })
    {
      for (const bool parallel : { false, true })
      {
        const View view = LookAt(grid.Field.Dimensions, direction, size, parallel);
        const RaySource source(view, IndexTransform(), grid.Field.Dimensions);
        for (std::int64_t tile = 0; tile < NumberOfTiles(size); ++tile)
        {
          const PixelRect part = PixelsOfTile(size, tile);
          RayBatch rays;
          source.SetUp(part.First, part.Size, rays);
          visited += this->CompareTile(rays, grid, pyramid, isovalue);
          CutShort(rays);
          visited += this->CompareTile(rays, grid, pyramid, isovalue);
        }
      }
    }
    EXPECT_GT(visited, 1000u);
  }

private:
  /// Let walks begin and end on the way.
  static void CutShort(RayBatch& rays)
  {
    for (std::size_t i = 0; i < static_cast<std::size_t>(rays.Count); ++i)
    {
      const double length = rays.End[i] - rays.Begin[i];
      rays.WalkBegin[i] += 0.04 * static_cast<double>(i % 11) * length;
      rays.WalkEnd[i] -= 0.05 * static_cast<double>(i % 13) * length;
    }
  }

  template <typename T>
  std::size_t CompareTile(
    const RayBatch& rays, Grid<T>& grid, const ValueRangePyramid& pyramid, double isovalue)
  {
    // The words of leaves are made anew, as the first ray makes them.
    const auto find = [&]
    {
      ActiveCells active;
      active.Build(grid.Field, pyramid, Surfaces{ { isovalue }, SurfaceMode::Crossing });
      return active;
    };
    constexpr std::size_t most = 5;
    const Visits all = VisitOneByOne<T>(rays, find(), grid.Field);
    Visits some = all;
    std::size_t visited = 0;
    for (std::vector<glm::ivec3>& cells : some)
    {
      visited += cells.size();
      cells.resize(std::min(cells.size(), most));
    }
    this->ForEachTarget(
      [&](const char* target)
      {
        EXPECT_EQ(VisitInVectors<T>(rays, find(), grid.Field, 0), all) << target;
        EXPECT_EQ(VisitInVectors<T>(rays, find(), grid.Field, most), some) << target;
      });
    return visited;
  }
};

/// Words of leaves are made by whoever asks first, while others read them: what thread sanitizer
/// looks at here, on every kind of vectors.
TEST_F(KernelsWalk, ManyThreadsMayAskForTheSameLeaves)
{
  Grid<std::uint8_t> noise(glm::ivec3(37, 18, 22));
  noise.FillRandomly(0.0, 20.0, 5);
  ValueRangePyramid pyramid;
  pyramid.Build(noise.Field);
  const Surfaces surfaces{ { 18.5 }, SurfaceMode::Crossing };
  const View view = LookAt(noise.Field.Dimensions, glm::dvec3(-1.0, -2.0, 0.8), { 8, 8 });
  RayBatch rays;
  RaySource(view, IndexTransform(), noise.Field.Dimensions).SetUp({ 0, 0 }, { 8, 8 }, rays);
  ActiveCells alone;
  alone.Build(noise.Field, pyramid, surfaces);
  const Visits expected = VisitOneByOne<std::uint8_t>(rays, alone, noise.Field);
  this->ForEachTarget(
    [&](const char* target)
    {
      for (int round = 0; round < 20; ++round)
      {
        ActiveCells active;
        active.Build(noise.Field, pyramid, surfaces);
        std::array<Visits, 4> visits;
        std::vector<std::thread> threads;
        for (Visits& found : visits)
        {
          threads.emplace_back(
            [&] { found = VisitInVectors<std::uint8_t>(rays, active, noise.Field, 0); });
        }
        for (std::thread& thread : threads)
        {
          thread.join();
        }
        for (const Visits& found : visits)
        {
          EXPECT_EQ(found, expected) << target;
        }
      }
    });
}

TEST_F(KernelsWalk, VisitsTheCellsOfAWalk)
{
  Grid<std::uint8_t> noise(glm::ivec3(37, 18, 22));
  noise.FillRandomly(0.0, 20.0, 5);
  this->Compare(noise, 18.5);
}

TEST_F(KernelsWalk, LeapsOverLeavesAndNodes)
{
  Grid<float> shell(glm::ivec3(70, 50, 41));
  shell.Fill([](int i, int j, int k)
    { return glm::length(glm::dvec3(i - 30.0, j - 25.0, k - 20.0)) - 18.0; });
  this->Compare(shell, 0.0);
}

}
