// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Crossings of tetrahedra agree with brute force. In blocks of them, a ray leaves a cell where it
// enters the next one, with the same bits.

#include "CellOracle.h"
#include "Checks/Sanitized.h"
#include "EachTarget.h"
#include "Mesh/Cells/KernelsKnownTetrahedra.h"
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

TEST(Tetrahedra, AgreeWithBruteForce)
{
  const int batches = IsMemorySanitized ? 200 : 5000;
  RandomCells random(30);
  int met = 0, crossed = 0, wrong = 0;
  const auto found = std::make_unique<Crossings>();
  const auto spans = std::make_unique<CellSpans>();
  for (int batch = 0; batch < batches; ++batch)
  {
    const auto pairs = std::make_unique<CellPairs>(random, true);
    pairs->FindCrossings(*found);
    pairs->FindSpans(*spans);
    std::array<int, 64> count{}, which{};
    for (std::size_t i = 0; i < found->Count; ++i)
    {
      ++count[found->Ray[i]];
      which[found->Ray[i]] = static_cast<int>(i);
      ASSERT_TRUE(std::isfinite(found->T[i]));
    }
    for (std::size_t ray = 0; ray < 64; ++ray)
    {
      const CellOracle::Span truth = CellOracle::FindInTetrahedron(
        pairs->Cells[ray], pairs->Differences[ray], CellOracle::RayOf(pairs->Rays, ray));
      const double size = pairs->Scales[ray], clear = 1e-6;
      ASSERT_LE(count[ray], 1);
      ASSERT_LE(spans->Count[ray], 1);
      if (truth.IsFlat || std::abs(static_cast<double>(truth.Out - truth.In)) < clear * size)
      {
        continue;
      }
      wrong += truth.IsHit != (spans->Count[ray] == 1);
      if (!truth.IsHit || spans->Count[ray] != 1)
      {
        continue;
      }
      ++met;
      const CellSpan& span = spans->Spans[ray][0];
      wrong += std::abs(span.In - static_cast<double>(truth.In)) > clear * size;
      wrong += std::abs(span.Out - static_cast<double>(truth.Out)) > clear * size;
      const auto atIn = static_cast<double>(truth.AtIn), atOut = static_cast<double>(truth.AtOut);
      if (std::min(std::abs(atIn), std::abs(atOut)) < clear)
      {
        continue;
      }
      const bool isCrossed = (atIn < 0.0) != (atOut < 0.0);
      crossed += isCrossed;
      wrong += isCrossed != (count[ray] == 1);
      if (isCrossed && count[ray] == 1)
      {
        const auto at = static_cast<std::size_t>(which[ray]);
        const double share = atIn / (atIn - atOut);
        const double t =
          static_cast<double>(truth.In) + share * static_cast<double>(truth.Out - truth.In);
        wrong += found->Rises[at] != (atIn < 0.0);
        wrong += std::abs(found->T[at] - t) > clear * size;
      }
    }
  }
  EXPECT_EQ(wrong, 0);
  EXPECT_GT(met, 64 * batches / 4);
  EXPECT_GT(crossed, 64 * batches / 8);
}

/// A block of cubes, each cut into five or six tetrahedra; inner points are moved about.
class TetrahedronBlock
{
public:
  static constexpr int Edge = 5;

  TetrahedronBlock(RandomCells& random, bool isMoved, bool areFive)
  {
    for (int p = 0; p < (Edge + 1) * (Edge + 1) * (Edge + 1); ++p)
    {
      const glm::ivec3 at(p % (Edge + 1), p / (Edge + 1) % (Edge + 1), p / (Edge + 1) / (Edge + 1));
      const bool isInner = glm::all(glm::greaterThan(at, glm::ivec3(0))) &&
        glm::all(glm::lessThan(at, glm::ivec3(Edge)));
      this->Points.push_back(glm::dvec3(at) + (isMoved && isInner ? 0.2 : 0.0) * random.Point());
      this->Values.push_back(random.Below(4) == 0 ? 0.0 : random.Around());
    }
    // Diagonals of faces are the same from both sides: of five, by turns; of six, all alike.
    const int five[2][5][4] = { { { 0, 1, 2, 4 }, { 3, 1, 2, 7 }, { 5, 1, 4, 7 }, { 6, 2, 4, 7 },
                                  { 1, 2, 4, 7 } },
      { { 1, 0, 3, 5 }, { 2, 0, 3, 6 }, { 4, 0, 5, 6 }, { 7, 3, 5, 6 }, { 0, 3, 5, 6 } } };
    const int six[6][4] = { { 0, 1, 3, 7 }, { 0, 1, 5, 7 }, { 0, 2, 3, 7 }, { 0, 2, 6, 7 },
      { 0, 4, 5, 7 }, { 0, 4, 6, 7 } };
    for (int c = 0; c < Edge * Edge * Edge; ++c)
    {
      const glm::ivec3 cube(c % Edge, c / Edge % Edge, c / Edge / Edge);
      const int parity = (cube.x + cube.y + cube.z) % 2;
      for (int part = 0; part < (areFive ? 5 : 6); ++part)
      {
        this->Add(cube, areFive ? five[parity][part] : six[part]);
      }
    }
  }

  std::vector<glm::dvec3> Points;
  std::vector<double> Values;
  std::vector<MeshCell> Cells;

private:
  void Add(const glm::ivec3& cube, const int corners[4])
  {
    MeshCell cell;
    cell.Shape = MeshCellShape::Tetrahedron;
    for (std::size_t i = 0; i < 4; ++i)
    {
      const glm::ivec3 at = cube + glm::ivec3(corners[i] & 1, corners[i] >> 1 & 1, corners[i] >> 2);
      const auto p = static_cast<std::size_t>(at.x + (Edge + 1) * (at.y + (Edge + 1) * at.z));
      cell.Points[i] = this->Points[p];
      cell.Values[i] = this->Values[p];
    }
    this->Cells.push_back(cell);
  }
};

struct Piece
{
  CellSpan Span;
  std::size_t Cell;
};

class TetrahedronBlocks : public EachTarget
{
protected:
  /// Rays through points, edges and anything else of a block, along axes, diagonals or anywhere.
  static void Aim(RandomCells& random, const TetrahedronBlock& block, MeshRays& rays)
  {
    TileAim aim = random.Aim(4.0 * TetrahedronBlock::Edge);
    aim.Along += random.Below(2) == 0 ? glm::dvec3(0.0) : glm::dvec3(1.0, 0.5, 0.25);
    aim.At(
      [&]
      {
        const MeshCell& cell =
          block.Cells[static_cast<std::size_t>(random.Below(static_cast<int>(block.Cells.size())))];
        const glm::dvec3 middle =
          0.25 * (cell.Points[0] + cell.Points[1] + cell.Points[2] + cell.Points[3]);
        const int special = random.Below(4);
        return special == 0 ? cell.Points[0]
          : special == 1    ? 0.5 * (cell.Points[0] + cell.Points[1])
          : special == 2    ? middle + 0.1 * random.Point()
                            : middle;
      },
      rays);
  }
};

TEST_F(TetrahedronBlocks, RaysLeaveACellWhereTheyEnterTheNext)
{
  RandomCells random(31);
  int chains = 0, links = 0, crossings = 0;
  const auto found = std::make_unique<Crossings>();
  const auto spans = std::make_unique<CellSpans>();
  for (int round = 0; round < 40; ++round)
  {
    const TetrahedronBlock block(random, round % 4 != 0, round % 2 == 0);
    const auto rays = std::make_unique<MeshRays>();
    Aim(random, block, *rays);
    std::vector<std::vector<Piece>> pieces(MeshRays::Capacity);
    std::vector<std::vector<std::pair<double, bool>>> met(MeshRays::Capacity);
    for (std::size_t c = 0; c < block.Cells.size(); ++c)
    {
      const MeshCell& cell = block.Cells[c];
      TetrahedronSpans(cell, cell.Values, *rays, ~std::uint64_t(0), *spans);
      found->Count = 0;
      TetrahedronCrossings(cell, cell.Values, *rays, ~std::uint64_t(0), *found);
      for (std::size_t i = 0; i < found->Count; ++i)
      {
        met[found->Ray[i]].emplace_back(found->T[i], found->Rises[i]);
      }
      for (std::size_t ray = 0; ray < MeshRays::Capacity; ++ray)
      {
        if (spans->Count[ray] == 1)
        {
          pieces[ray].push_back({ spans->Spans[ray][0], c });
        }
      }
    }
    for (std::size_t ray = 0; ray < MeshRays::Capacity; ++ray)
    {
      std::vector<Piece>& chain = pieces[ray];
      std::sort(chain.begin(), chain.end(),
        [](const Piece& a, const Piece& b) { return a.Span.In < b.Span.In; });
      chains += !chain.empty();
      for (std::size_t i = 0; i < chain.size(); ++i)
      {
        const CellSpan& span = chain[i].Span;
        if (span.In - chain[0].Span.In < 1e-12)
        {
          continue; // cells side by side at the beginning
        }
        // Some other cell ends with the same bits; along edges and faces several cells do. Between
        // cells that are as thin as rounding errors only values must be the same.
        const auto isThin = [](const CellSpan& of) { return of.Out - of.In < 1e-12; };
        const bool isLinked = isThin(span) ||
          std::any_of(chain.begin(), chain.end(),
            [&](const Piece& other)
            {
              const bool isSame = other.Span.Out == span.In ||
                (isThin(other.Span) && std::abs(other.Span.Out - span.In) < 1e-12);
              return isSame && other.Span.AtOut == span.AtIn;
            });
        EXPECT_TRUE(isLinked) << "round " << round << ", ray " << ray << ": a gap at " << span.In;
        ++links;
      }
      // Every change of sides between the ends of spans is a crossing.
      for (const Piece& piece : chain)
      {
        const bool rises = piece.Span.AtIn < 0.0;
        if (rises != (piece.Span.AtOut < 0.0))
        {
          const bool isMet = std::any_of(met[ray].begin(), met[ray].end(),
            [&](const auto& crossing)
            {
              return crossing.second == rises && crossing.first >= piece.Span.In &&
                (rises && piece.Span.In < piece.Span.Out ? crossing.first < piece.Span.Out
                                                         : crossing.first <= piece.Span.Out);
            });
          EXPECT_TRUE(isMet) << "round " << round << ", ray " << ray;
          ++crossings;
        }
      }
    }
  }
  EXPECT_GT(chains, 40 * 64 / 2);
  EXPECT_GT(links, 10000);
  EXPECT_GT(crossings, 5000);
}

TEST_F(TetrahedronBlocks, KnownCellsHoldTheSameCrossings)
{
  RandomCells random(32);
  std::size_t crossings = 0;
  const auto found = std::make_unique<Crossings>(), expected = std::make_unique<Crossings>();
  for (int round = 0; round < 40; ++round)
  {
    const TetrahedronBlock block(random, round % 4 != 0, round % 2 == 0);
    const auto rays = std::make_unique<MeshRays>();
    Aim(random, block, *rays);
    // Each ray is searched in one of the cells that it crosses, if there is any.
    const auto known = std::make_unique<SortedTetrahedra>();
    TileArray<std::uint64_t> ofCells;
    std::size_t cells = 0;
    std::uint64_t searched = 0;
    expected->Count = 0;
    for (const MeshCell& cell : block.Cells)
    {
      found->Count = 0;
      TetrahedronCrossings(cell, cell.Values, *rays, ~searched, *found);
      std::uint64_t met = 0;
      for (std::size_t i = 0; i < found->Count; ++i)
      {
        met |= std::uint64_t(1) << found->Ray[i];
        expected->Append(found->Ray[i], found->T[i], found->Rises[i]);
      }
      if (met != 0)
      {
        known->Set(cells, TetrahedronPoints(cell, cell.Values));
        ofCells[cells++] = met;
        searched |= met;
      }
    }
    ASSERT_NE(searched, 0u);
    crossings += expected->Count;
    this->ForEachTarget(
      [&](const char* target)
      {
        KnownCrossings crossing;
        FindKnownCrossings(*known, ofCells, cells, *rays, crossing);
        ASSERT_EQ(crossing.Met, searched) << target;
        for (std::size_t i = 0; i < expected->Count; ++i)
        {
          const std::uint8_t ray = expected->Ray[i];
          EXPECT_EQ(crossing.T[ray], expected->T[i]) << target;
          EXPECT_EQ((crossing.Rising >> ray & 1u) != 0, expected->Rises[i]) << target;
        }
      });
  }
  EXPECT_GT(crossings, 1000u);
}

}
