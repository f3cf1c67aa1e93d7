// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// In blocks of hexahedra, the crossings of a ray rise and fall by turns, and its parts in cells
// leave no gaps.

#include "RandomCells.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

namespace
{

using namespace TemporalCoherence;
using namespace TemporalCoherence::MeshKernels;

constexpr int Edge = 4;

/// Hexahedra that share their points, as a curvilinear grid has them.
std::vector<MeshCell> MakeBlock(RandomCells& random, double moved)
{
  std::vector<glm::dvec3> points;
  std::vector<double> values;
  constexpr int row = Edge + 1;
  for (int p = 0; p < row * row * row; ++p)
  {
    points.push_back(glm::dvec3(p % row, p / row % row, p / row / row) + moved * random.Point());
    values.push_back(random.Around() + 0.01);
  }
  std::vector<MeshCell> cells;
  for (int c = 0; c < Edge * Edge * Edge; ++c)
  {
    MeshCell cell;
    cell.Shape = MeshCellShape::Hexahedron;
    const int first = c % Edge + row * (c / Edge % Edge + row * (c / Edge / Edge));
    // Some cells have their points in another order, as in an unstructured grid.
    const std::size_t turn = static_cast<std::size_t>(random.Below(8));
    for (std::size_t i = 0; i < 8; ++i)
    {
      const auto corner = static_cast<int>(i);
      const auto p = static_cast<std::size_t>(
        first + (corner & 1) + row * ((corner >> 1 & 1) + row * (corner >> 2)));
      cell.Points[i ^ turn] = points[p];
      cell.Values[i ^ turn] = values[p];
    }
    cells.push_back(cell);
  }
  return cells;
}

/// Rays through points and edges of a block, and anywhere.
void Aim(RandomCells& random, const std::vector<MeshCell>& cells, MeshRays& rays)
{
  TileAim aim = random.Aim(4.0 * Edge);
  aim.Eye += 20.0;
  aim.At(
    [&]
    {
      const MeshCell& cell =
        cells[static_cast<std::size_t>(random.Below(static_cast<int>(cells.size())))];
      const auto corner = static_cast<std::size_t>(random.Below(8));
      const glm::dvec3 middle = 0.5 * (cell.Points[corner] + cell.Points[corner ^ 1]);
      const int special = random.Below(3);
      return special == 0 ? cell.Points[corner]
        : special == 1    ? middle
                          : middle + 0.3 * random.Point();
    },
    rays);
}

/// What rays meet and where they are, in all cells of a block.
struct Passages
{
  std::vector<std::vector<std::pair<double, bool>>> Met{ MeshRays::Capacity };
  std::vector<std::vector<CellSpan>> Spans{ MeshRays::Capacity };

  Passages(const std::vector<MeshCell>& cells, const MeshRays& rays)
  {
    const auto found = std::make_unique<Crossings>();
    const auto spans = std::make_unique<CellSpans>();
    for (const MeshCell& cell : cells)
    {
      found->Count = 0;
      HexahedronCrossings(cell, cell.Values, rays, ~std::uint64_t(0), *found);
      HexahedronSpans(cell, cell.Values, rays, ~std::uint64_t(0), *spans);
      for (std::size_t i = 0; i < found->Count; ++i)
      {
        this->Met[found->Ray[i]].emplace_back(found->T[i], found->Rises[i]);
      }
      for (std::size_t ray = 0; ray < MeshRays::Capacity; ++ray)
      {
        for (std::size_t i = 0; i < spans->Count[ray]; ++i)
        {
          this->Spans[ray].push_back(spans->Spans[ray][i]);
        }
      }
    }
    for (std::size_t ray = 0; ray < MeshRays::Capacity; ++ray)
    {
      std::sort(this->Met[ray].begin(), this->Met[ray].end());
      std::sort(this->Spans[ray].begin(), this->Spans[ray].end(),
        [](const CellSpan& a, const CellSpan& b) { return a.In < b.In; });
    }
  }
};

/// Cells that share a face, an edge or a point may each report a crossing there: the same one.
std::vector<std::pair<double, bool>> WithoutRepeats(const std::vector<std::pair<double, bool>>& met)
{
  std::vector<std::pair<double, bool>> once;
  for (const auto& crossing : met)
  {
    const bool isRepeated = !once.empty() && crossing.first - once.back().first < 1e-9 &&
      crossing.second == once.back().second;
    if (!isRepeated)
    {
      once.push_back(crossing);
    }
  }
  return once;
}

TEST(HexahedronBlocks, CrossingsRiseAndFallByTurns)
{
  RandomCells random(40);
  int crossings = 0, rays = 0, wrong = 0;
  for (int round = 0; round < 60; ++round)
  {
    const std::vector<MeshCell> cells = MakeBlock(random, round % 3 == 0 ? 0.0 : 0.15);
    const auto batch = std::make_unique<MeshRays>();
    Aim(random, cells, *batch);
    const Passages passages(cells, *batch);
    for (std::size_t ray = 0; ray < MeshRays::Capacity; ++ray)
    {
      const auto met = WithoutRepeats(passages.Met[ray]);
      // The block's outside is bent where points are moved: a ray may leave it and come back.
      bool isOnePiece = !passages.Spans[ray].empty();
      double end = isOnePiece ? passages.Spans[ray][0].Out : 0.0;
      for (const CellSpan& span : passages.Spans[ray])
      {
        isOnePiece = isOnePiece && span.In < end + 1e-9;
        end = std::max(end, span.Out);
      }
      if (!isOnePiece)
      {
        continue;
      }
      ++rays;
      for (std::size_t i = 0; i < met.size(); ++i)
      {
        wrong += i > 0 && met[i].second == met[i - 1].second;
      }
      const bool begins = passages.Spans[ray][0].AtIn >= 0.0;
      wrong += !met.empty() && met[0].second == begins;
      crossings += static_cast<int>(met.size());
    }
  }
  EXPECT_EQ(wrong, 0);
  EXPECT_GT(rays, 60 * 64 / 2);
  EXPECT_GT(crossings, 5000);
}

TEST(HexahedronBlocks, SpansLeaveNoGaps)
{
  RandomCells random(41);
  int links = 0, same = 0;
  for (int round = 0; round < 60; ++round)
  {
    const std::vector<MeshCell> cells = MakeBlock(random, round % 3 == 0 ? 0.0 : 0.1);
    const auto batch = std::make_unique<MeshRays>();
    Aim(random, cells, *batch);
    const Passages passages(cells, *batch);
    for (std::size_t ray = 0; ray < MeshRays::Capacity; ++ray)
    {
      const std::vector<CellSpan>& spans = passages.Spans[ray];
      for (const CellSpan& span : spans)
      {
        // Inner cells: some other cell ends there. The block is about 4 long.
        const bool isFirst = span.In - spans[0].In < 1e-9;
        const bool isLinked = std::any_of(spans.begin(), spans.end(),
          [&](const CellSpan& other) { return std::abs(other.Out - span.In) < 1e-9; });
        links += !isFirst && isLinked;
        same += !isFirst &&
          std::any_of(spans.begin(), spans.end(),
            [&](const CellSpan& other)
            { return other.Out == span.In && other.AtOut == span.AtIn; });
        const glm::dvec3 at(batch->Origin[0][ray] + span.In * batch->Direction[0][ray],
          batch->Origin[1][ray] + span.In * batch->Direction[1][ray],
          batch->Origin[2][ray] + span.In * batch->Direction[2][ray]);
        const double inside =
          2.0 - std::max({ std::abs(at.x - 2.0), std::abs(at.y - 2.0), std::abs(at.z - 2.0) });
        EXPECT_TRUE(isFirst || isLinked || inside < 0.2) << "round " << round << ", ray " << ray;
      }
    }
  }
  EXPECT_GT(links, 5000);
  // Through faces, with the same bits from both sides; edges and points are met in several faces.
  EXPECT_GT(same, links / 2);
}

}
