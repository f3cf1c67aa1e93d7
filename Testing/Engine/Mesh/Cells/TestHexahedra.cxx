// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Crossings of hexahedra agree with brute force in extended precision: none is missed, invented or
// found twice. Tiles, single rays and all kinds of vectors find the same bits, in tetrahedra, too.

#include "CellOracle.h"
#include "Checks/Sanitized.h"
#include "EachTarget.h"
#include "RandomCells.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <vector>

namespace
{

using namespace TemporalCoherence;
using namespace TemporalCoherence::MeshKernels;

struct Crossing
{
  std::size_t Ray;
  double T;
  bool Rises;
};

std::vector<Crossing> ListOf(const Crossings& found)
{
  std::vector<Crossing> list;
  for (std::size_t i = 0; i < found.Count; ++i)
  {
    list.push_back({ found.Ray[i], found.T[i], found.Rises[i] });
  }
  std::stable_sort(list.begin(), list.end(),
    [](const Crossing& a, const Crossing& b)
    { return a.Ray != b.Ray ? a.Ray < b.Ray : a.T < b.T; });
  return list;
}

bool AreSame(const std::vector<Crossing>& a, const std::vector<Crossing>& b)
{
  return a.size() == b.size() &&
    std::equal(a.begin(), a.end(), b.begin(),
      [](const Crossing& x, const Crossing& y)
      { return x.Ray == y.Ray && !std::memcmp(&x.T, &y.T, sizeof x.T) && x.Rises == y.Rises; });
}

/// Compares crossings of a pair with the truth.
class Judge
{
public:
  Judge(const CellPairs& pairs, std::size_t i, const std::vector<Crossing>& found)
  {
    constexpr int depth = 3, finerDepth = 6;
    const auto findTruth = [&](int often)
    {
      return CellOracle::FindInHexahedron(
        pairs.Cells[i], pairs.Differences[i], CellOracle::RayOf(pairs.Rays, i), often);
    };
    const CellOracle::Roots truth = findTruth(depth);
    const double size = pairs.Scales[i];
    const glm::dvec3 eye(pairs.Rays.Origin[0][i], pairs.Rays.Origin[1][i], pairs.Rays.Origin[2][i]);
    const double far = glm::length(eye - pairs.Cells[i].Points[0]) / size;
    const double rounding = 1e-11 + 1e-14 * far;
    for (const CellOracle::Root& root : truth.All)
    {
      const auto outside = static_cast<double>(
        std::max(
          { std::abs(root.At.x - 0.5L), std::abs(root.At.y - 0.5L), std::abs(root.At.z - 0.5L) }) -
        0.5L);
      const auto condition = static_cast<double>(root.Condition);
      // In so far as it is certain that it lies in the cell and that it is a single root.
      if (condition > 1e4 || outside > -1e-9 * condition)
      {
        continue;
      }
      ++this->Certain;
      int met = 0;
      for (const Crossing& crossing : found)
      {
        const double apart = std::abs(crossing.T - static_cast<double>(root.T)) / size;
        const bool isIt = apart < rounding * (1.0 + condition);
        met += isIt && (root.Speed < 1e-6L || crossing.Rises == root.Rises);
      }
      const bool hasTwin = std::count_if(truth.All.begin(), truth.All.end(),
                             [&](const auto& other) {
                               return std::abs(static_cast<double>(other.T - root.T)) / size < 1e-6;
                             }) > 1;
      this->Missed += met == 0;
      this->Repeated += met > 1 && !hasTwin;
    }
    const auto isOneOf = [&](const CellOracle::Roots& roots, const Crossing& crossing)
    {
      return roots.IsDoubtful ||
        std::any_of(roots.All.begin(), roots.All.end(),
          [&](const CellOracle::Root& root)
          {
            const double apart = std::abs(crossing.T - static_cast<double>(root.T)) / size;
            return apart < rounding * (1.0 + static_cast<double>(root.Condition));
          });
    };
    for (const Crossing& crossing : found)
    {
      this->Invented += !isOneOf(truth, crossing) && !isOneOf(findTruth(finerDepth), crossing);
    }
    this->Doubtful = truth.IsDoubtful;
  }

  int Certain = 0, Missed = 0, Repeated = 0, Invented = 0, Doubtful = 0;
};

class Hexahedra : public EachTarget
{
};

TEST_F(Hexahedra, AgreeWithBruteForce)
{
  const int batches = IsMemorySanitized ? 100 : 4000;
  RandomCells random(20);
  std::int64_t certain = 0, doubtful = 0;
  int missed = 0, invented = 0, repeated = 0;
  for (int batch = 0; batch < batches; ++batch)
  {
    const auto pairs = std::make_unique<CellPairs>(random, false);
    const auto found = std::make_unique<Crossings>();
    pairs->FindCrossings(*found);
    const std::vector<Crossing> list = ListOf(*found);
    auto next = list.begin();
    for (std::size_t i = 0; i < 64; ++i)
    {
      std::vector<Crossing> mine;
      for (; next != list.end() && next->Ray == i; ++next)
      {
        mine.push_back(*next);
        ASSERT_TRUE(std::isfinite(next->T));
      }
      const Judge judge(*pairs, i, mine);
      certain += judge.Certain;
      doubtful += judge.Doubtful;
      missed += judge.Missed;
      invented += judge.Invented;
      repeated += judge.Repeated;
      if (judge.Missed + judge.Invented + judge.Repeated > 0 && missed + invented + repeated < 10)
      {
        ADD_FAILURE() << "batch " << batch << ", pair " << i << ": " << judge.Missed << " missed, "
                      << judge.Invented << " invented, " << judge.Repeated << " repeated";
      }
    }
  }
  EXPECT_EQ(missed, 0);
  EXPECT_EQ(invented, 0);
  EXPECT_EQ(repeated, 0);
  // So the comparison compares.
  EXPECT_GT(certain, 64 * batches / 5);
  EXPECT_LT(doubtful, 64 * batches / 10);
  RecordProperty("certain", static_cast<int>(certain));
  RecordProperty("doubtful", static_cast<int>(doubtful));
}

/// Rays of a tile that look at a cell, most of which meet it.
std::unique_ptr<MeshRays> TileAround(RandomCells& random, const MeshCell& cell)
{
  auto rays = std::make_unique<MeshRays>();
  rays->Count = static_cast<std::size_t>(1 + random.Below(64));
  for (std::size_t ray = 0; ray < rays->Count; ++ray)
  {
    glm::dvec3 origin, direction;
    random.Aim(cell, origin, direction);
    for (int a = 0; a < 3; ++a)
    {
      rays->Origin[static_cast<std::size_t>(a)][ray] = origin[a];
      rays->Direction[static_cast<std::size_t>(a)][ray] = direction[a];
    }
    rays->Begin[ray] = -1e40;
    rays->End[ray] = 1e40;
  }
  rays->Prepare();
  return rays;
}

/// Tiles, single rays, and all kinds of vectors find the same bits.
void ExpectSameBits(bool areTetrahedra,
  const std::function<void(const std::function<void(const char*)>&)>& forEachTarget)
{
  RandomCells random(21);
  std::size_t number = 0;
  for (int round = 0; round < 300; ++round)
  {
    const MeshCell cell = areTetrahedra ? random.Tetrahedron() : random.Hexahedron();
    const auto rays = TileAround(random, cell);
    const std::uint64_t which = ~std::uint64_t(0) >> random.Below(2) * 20;
    std::vector<Crossing> expected;
    forEachTarget(
      [&](const char* target)
      {
        const auto together = std::make_unique<Crossings>();
        const auto alone = std::make_unique<Crossings>();
        const std::uint64_t there =
          rays->Count == 64 ? which : which & ((std::uint64_t(1) << rays->Count) - 1);
        CellCrossings(cell, cell.Values, *rays, there, *together);
        for (std::uint64_t left = there; left != 0; left &= left - 1)
        {
          CellCrossings(cell, cell.Values, *rays, left & ~(left - 1), *alone);
        }
        const std::vector<Crossing> list = ListOf(*together);
        EXPECT_TRUE(AreSame(list, ListOf(*alone))) << target << ", round " << round;
        EXPECT_TRUE(expected.empty() || AreSame(list, expected)) << target << ", round " << round;
        expected = list;
        number += list.size();
      });
  }
  EXPECT_GT(number, 1000u);
}

TEST_F(Hexahedra, AreTheSameBitsForTilesRaysAndVectors)
{
  ExpectSameBits(false, [&](const auto& check) { this->ForEachTarget(check); });
}

TEST_F(Hexahedra, TetrahedraAreTheSameBitsForTilesRaysAndVectors)
{
  ExpectSameBits(true, [&](const auto& check) { this->ForEachTarget(check); });
}

TEST_F(Hexahedra, SpansAreTheSameBitsForTilesRaysAndVectors)
{
  RandomCells random(22);
  std::size_t number = 0;
  for (int round = 0; round < 300; ++round)
  {
    const MeshCell cell = random.Hexahedron();
    const auto rays = TileAround(random, cell);
    const std::uint64_t all = ~std::uint64_t(0) >> (64 - rays->Count);
    const auto expected = std::make_unique<CellSpans>();
    HexahedronSpans(cell, cell.Values, *rays, all, *expected);
    const auto spans = std::make_unique<CellSpans>();
    const auto expectSame = [&](std::size_t ray, const char* target)
    {
      const std::size_t count = expected->Count[ray];
      ASSERT_EQ(spans->Count[ray], count) << target;
      EXPECT_TRUE(!std::memcmp(
        spans->Spans[ray].data(), expected->Spans[ray].data(), count * sizeof(CellSpan)))
        << target;
      number += count;
    };
    this->ForEachTarget(
      [&](const char* target)
      {
        HexahedronSpans(cell, cell.Values, *rays, all, *spans);
        for (std::size_t ray = 0; ray < rays->Count; ++ray)
        {
          expectSame(ray, target);
        }
        for (std::size_t ray = 0; ray < rays->Count; ++ray)
        {
          HexahedronSpans(cell, cell.Values, *rays, std::uint64_t(1) << ray, *spans);
          expectSame(ray, target);
        }
      });
  }
  EXPECT_GT(number, 1000u);
}

/// A ray passes the isovalue in a cell as often as its spans say, but for pairs of crossings.
TEST_F(Hexahedra, SpansEndOnTheSidesThatCrossingsTell)
{
  RandomCells random(23);
  random.HasScales = false;
  int compared = 0, wrong = 0;
  for (int round = 0; round < 600; ++round)
  {
    const auto pairs = std::make_unique<CellPairs>(random, false);
    const auto found = std::make_unique<Crossings>();
    const auto spans = std::make_unique<CellSpans>();
    pairs->FindCrossings(*found);
    pairs->FindSpans(*spans);
    std::array<int, 64> crossings{};
    for (std::size_t i = 0; i < found->Count; ++i)
    {
      ++crossings[found->Ray[i]];
    }
    for (std::size_t ray = 0; ray < 64; ++ray)
    {
      if (spans->Count[ray] != 1)
      {
        continue; // a folded cell
      }
      const CellSpan& span = spans->Spans[ray][0];
      const bool isClear =
        span.Out - span.In > 1e-6 && std::abs(span.AtIn) > 1e-6 && std::abs(span.AtOut) > 1e-6;
      compared += isClear;
      wrong += isClear && ((span.AtIn < 0.0) != (span.AtOut < 0.0)) != (crossings[ray] % 2 == 1);
    }
  }
  EXPECT_GT(compared, 10000);
  // Folded cells may be left through the fold, where no face is.
  EXPECT_LT(wrong, compared / 100);
}

/// Cells all whose values, or many of them, are the isovalue: whole lines of roots.
TEST_F(Hexahedra, LinesOfRootsEnd)
{
  MeshCell cell;
  cell.Shape = MeshCellShape::Hexahedron;
  for (std::size_t c = 0; c < 8; ++c)
  {
    cell.Points[c] = glm::dvec3(c & 1, c >> 1 & 1, c >> 2);
    cell.Values[c] = (c & 1) != 0 ? 0.0 : -1.0;
  }
  MeshRays rays;
  rays.Count = 2;
  for (std::size_t ray = 0; ray < 2; ++ray)
  {
    rays.Origin[0][ray] = ray == 0 ? 1.0 : -5.0; // in the face of roots; across it
    rays.Origin[1][ray] = ray == 0 ? -5.0 : 0.5;
    rays.Origin[2][ray] = 0.5;
    rays.Direction[0][ray] = ray == 0 ? 0.0 : 1.0;
    rays.Direction[1][ray] = ray == 0 ? 1.0 : 0.0;
    rays.Direction[2][ray] = 0.0;
    rays.Begin[ray] = 0.0;
    rays.End[ray] = 100.0;
  }
  rays.Prepare();
  const auto found = std::make_unique<Crossings>();
  HexahedronCrossings(cell, cell.Values, rays, 3, *found);
  int across = 0;
  for (std::size_t i = 0; i < found->Count; ++i)
  {
    EXPECT_TRUE(found->T[i] >= 4.999 && found->T[i] <= 6.001);
    across += found->Ray[i] == 1;
    EXPECT_TRUE(found->Ray[i] == 0 || (std::abs(found->T[i] - 6.0) < 1e-12 && found->Rises[i]));
  }
  EXPECT_EQ(across, 1);
  EXPECT_LE(found->Count, 1 + Crossings::MostInCell);
}

}
