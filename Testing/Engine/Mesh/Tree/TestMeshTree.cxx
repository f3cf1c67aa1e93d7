// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Each cell of a mesh is once in the tree, within boxes that are tight. Its ranges tell all active
// cells. Arrays of any type, any number of threads, new values and moved points are right.

#include "Acceleration/ActiveCells.h"
#include "Checks/Sanitized.h"
#include "Mesh/Tree/HilbertCurve.h"
#include "MeshTrees.h"

#include <hwy/base.h>

#include <vtkSMPTools.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace
{

using namespace MeshTrees;

void ExpectInside(const FloatBox& box, const glm::dvec3& point)
{
  EXPECT_TRUE(glm::all(glm::lessThan(glm::dvec3(box.Low), point)));
  EXPECT_TRUE(glm::all(glm::greaterThan(glm::dvec3(box.High), point)));
}

/// A cell's points in index space.
std::vector<glm::dvec3> IndexPoints(const MeshTree& tree, std::int64_t rank)
{
  const MeshCell cell = ReadPlainly(tree.TheMesh(), tree.CellAt(rank));
  std::vector<glm::dvec3> points;
  for (int i = 0; i < cell.NumberOfPoints(); ++i)
  {
    points.push_back(tree.ToIndex(cell.Points[static_cast<std::size_t>(i)]));
  }
  return points;
}

TEST(MeshReader, ReadsAsReadCell)
{
  for (const auto& [name, mesh] : AllMeshes())
  {
    SCOPED_TRACE(name);
    const MeshReader reader(*mesh);
    for (std::int64_t i = 0; i < mesh->NumberOfCells(); ++i)
    {
      const MeshCell expected = ReadPlainly(*mesh, i);
      MeshCell cell;
      reader.Read(i, cell);
      ASSERT_EQ(cell.Shape, expected.Shape);
      const int count = expected.NumberOfPoints();
      ASSERT_TRUE(
        std::equal(cell.Points.begin(), cell.Points.begin() + count, expected.Points.begin()));
      ASSERT_TRUE(
        std::equal(cell.Values.begin(), cell.Values.begin() + count, expected.Values.begin()));
    }
  }
}

/// Arrays of any types and steps.
TEST(MeshReader, ReadsAnyArrays)
{
  const auto arrays = Meshes::MakeBlock(Meshes::Cells::Mixed, {});
  const auto points = static_cast<std::int64_t>(arrays.Values.size());
  std::vector<std::int16_t> values;
  std::vector<float> y;
  for (std::int64_t i = 0; i < points; ++i)
  {
    values.insert(values.end(), { static_cast<std::int16_t>(i), -1 });
    y.push_back(static_cast<float>(arrays.Points[static_cast<std::size_t>(3 * i + 1)]));
  }
  const std::vector<std::int32_t> offsets(arrays.Offsets.begin(), arrays.Offsets.end());
  MeshPart part = arrays.Part();
  part.Values = { values.data(), ScalarType::Int16, 2 };
  part.Coordinates[1] = { y.data(), ScalarType::Float32, 1 };
  part.Offsets = { offsets.data(), ScalarType::Int32, 1 };
  Mesh mesh;
  mesh.Parts = { part };
  const MeshReader reader(mesh);
  for (std::int64_t i = 0; i < part.NumberOfCells; ++i)
  {
    const MeshCell expected = ReadPlainly(mesh, i);
    MeshCell cell;
    reader.Read(i, cell);
    ASSERT_EQ(cell.Shape, expected.Shape);
    for (std::size_t p = 0; p < static_cast<std::size_t>(cell.NumberOfPoints()); ++p)
    {
      ASSERT_EQ(cell.Points[p], expected.Points[p]);
      ASSERT_EQ(cell.Values[p], expected.Values[p]);
    }
  }
}

TEST(MeshLattice, RanksAndPlaces)
{
  for (std::int64_t rank = 0; rank < 100000; ++rank)
  {
    const glm::ivec3 place = MeshTree::PlaceOf(rank);
    ASSERT_EQ(MeshTree::RankOf(place), rank);
    ASSERT_EQ(ActiveCells::BitOf(place), rank & 63);
    ASSERT_EQ(ActiveCells::LeafOf(place), rank >> 6 & 63);
    ASSERT_EQ(MeshTree::PlaceOf(rank >> 6), place / 4);
  }
  const std::int64_t last = (std::int64_t(1) << 32) - 3;
  EXPECT_EQ(MeshTree::RankOf(MeshTree::PlaceOf(last)), last);
  glm::ivec3 farthest(0);
  for (std::int64_t count = 1; count < 20000; ++count)
  {
    farthest = glm::max(farthest, MeshLattice::PlaceOf(count - 1));
    ASSERT_EQ(MeshLattice::SizeFor(count), farthest + 1);
    const auto places =
      static_cast<std::int64_t>(farthest.x + 1) * (farthest.y + 1) * (farthest.z + 1);
    ASSERT_LT(places, 2 * count + 2) << "few places are empty";
  }
}

/// Each step of the curve goes to a neighbour, and the curve passes every place once.
TEST(HilbertCurve, StepsToNeighbours)
{
  for (const int bits : { 1, 2, 3, 4 })
  {
    const int size = 1 << bits;
    std::vector<glm::ivec3> places(static_cast<std::size_t>(size * size * size), glm::ivec3(-1));
    for (std::uint32_t i = 0; i < places.size(); ++i)
    {
      const std::uint32_t mask = (1u << bits) - 1;
      const std::uint32_t x = i & mask, y = i >> bits & mask, z = i >> 2 * bits;
      places[HilbertCurve::NumberOf(x, y, z, bits)] = glm::ivec3(x, y, z);
    }
    EXPECT_EQ(places[0], glm::ivec3(0));
    for (std::size_t i = 1; i < places.size(); ++i)
    {
      ASSERT_GE(places[i].x, 0);
      const glm::ivec3 step = glm::abs(places[i] - places[i - 1]);
      ASSERT_EQ(step.x + step.y + step.z, 1);
    }
  }
}

TEST(MeshTree, EachCellOnce)
{
  for (const auto& [name, mesh] : AllMeshes())
  {
    SCOPED_TRACE(name);
    const TreePointer tree = TreeOf(mesh);
    std::vector<bool> found(static_cast<std::size_t>(mesh->NumberOfCells()));
    for (std::int64_t rank = 0; rank < tree->NumberOfCells(); ++rank)
    {
      const std::uint32_t cell = tree->CellAt(rank);
      EXPECT_FALSE(found[cell]);
      found[cell] = true;
      EXPECT_TRUE(glm::all(glm::lessThan(MeshTree::PlaceOf(rank), tree->Dimensions() - 1)));
    }
    for (std::size_t i = 0; i < found.size(); ++i)
    {
      const MeshCell cell = ReadPlainly(*mesh, static_cast<std::int64_t>(i));
      EXPECT_EQ(found[i], cell.Shape != MeshCellShape::None);
    }
  }
}

TEST(MeshTree, BoxesHoldTheirCells)
{
  for (const auto& [name, mesh] : AllMeshes())
  {
    SCOPED_TRACE(name);
    const TreePointer tree = TreeOf(mesh);
    const std::size_t levels = tree->NumberOfLevels();
    ASSERT_GE(levels, 3u);
    std::int64_t blocks = tree->NumberOfLeaves();
    for (std::size_t level = 0; level < levels; ++level, blocks = (blocks + 63) / 64)
    {
      EXPECT_EQ(tree->NumberOfBlocks(level), blocks);
    }
    EXPECT_EQ(tree->NumberOfBlocks(levels - 1), 1);
    const FloatBox& whole = tree->BlockBox(levels - 1, 0);
    EXPECT_TRUE(glm::all(glm::greaterThanEqual(whole.Low, glm::vec3(0.0f))));
    EXPECT_TRUE(glm::all(glm::lessThanEqual(whole.High, glm::vec3(tree->Dimensions() - 1))));
    for (std::int64_t rank = 0; rank < tree->NumberOfCells(); ++rank)
    {
      const glm::ivec3 place = MeshTree::PlaceOf(rank);
      for (const glm::dvec3& point : IndexPoints(*tree, rank))
      {
        for (std::size_t level = 0; level < levels; ++level)
        {
          const int bits = 2 * static_cast<int>(level) + 2;
          ExpectInside(tree->BlockBox(level, rank >> 3 * bits), point);
          ExpectInside(
            tree->BlockBox(level, { place.x >> bits, place.y >> bits, place.z >> bits }), point);
        }
      }
      if (::testing::Test::HasFailure())
      {
        return;
      }
    }
  }
}

/// Boxes are not much larger than their cells.
TEST(MeshTree, BoxesAreTight)
{
  for (const auto& [name, mesh] : AllMeshes())
  {
    SCOPED_TRACE(name);
    const TreePointer tree = TreeOf(mesh);
    for (std::int64_t leaf = 0; leaf < tree->NumberOfLeaves(); ++leaf)
    {
      glm::dvec3 low(Infinity), high(-Infinity);
      for (std::int64_t rank = 64 * leaf; rank < tree->EndOfLeaf(leaf); ++rank)
      {
        for (const glm::dvec3& point : IndexPoints(*tree, rank))
        {
          low = glm::min(low, point);
          high = glm::max(high, point);
        }
      }
      const FloatBox& box = tree->LeafBox(leaf);
      const double slack =
        1e-7 * std::max({ tree->Dimensions().x, tree->Dimensions().y, tree->Dimensions().z });
      EXPECT_TRUE(glm::all(glm::lessThan(low - glm::dvec3(box.Low), glm::dvec3(slack))));
      EXPECT_TRUE(glm::all(glm::lessThan(glm::dvec3(box.High) - high, glm::dvec3(slack))));
    }
  }
}

TEST(MeshTree, BoxesOfAnyBlock)
{
  Meshes::Block block;
  block.Cubes = glm::ivec3(16);
  const TreePointer tree =
    TreeOf(Meshes::MeshOf(Meshes::MakeBlock(Meshes::Cells::Pyramids, block)));
  const glm::ivec3 cells = tree->Dimensions() - 1;
  std::mt19937 numbers(7);
  for (int i = 0; i < 500; ++i)
  {
    CellBox box;
    for (int axis = 0; axis < 3; ++axis)
    {
      std::uniform_int_distribution<int> first(0, cells[axis] - 1);
      box.First[axis] = first(numbers);
      std::uniform_int_distribution<int> size(1, cells[axis] - box.First[axis] + 3);
      box.Size[axis] = i % 3 == 0 ? std::min(4, size(numbers)) : size(numbers);
    }
    // The union of the boxes of all leaves that it meets.
    FloatBox expected;
    for (std::int64_t leaf = 0; leaf < tree->NumberOfLeaves(); ++leaf)
    {
      const glm::ivec3 begin = 4 * MeshLattice::PlaceOf(leaf);
      if (glm::all(glm::lessThan(begin, box.First + box.Size)) &&
        glm::all(glm::lessThan(box.First, begin + 4)))
      {
        expected.Widen(tree->LeafBox(leaf));
      }
    }
    const IndexBox found = tree->BoxOf(box);
    const bool isEmpty = expected.Low.x > expected.High.x;
    EXPECT_EQ(found.Low, isEmpty ? glm::dvec3(0.0) : glm::dvec3(expected.Low));
    EXPECT_EQ(found.High, isEmpty ? glm::dvec3(0.0) : glm::dvec3(expected.High));
  }
}

/// Every leaf and every cell against the values of the cells, one by one.
void ExpectRanges(const MeshTree& tree, const std::vector<ValueBand>& bands)
{
  const auto mesh = std::make_shared<const Mesh>(tree.TheMesh());
  const TreePointer fresh = tree.WithValuesOf(mesh);
  std::size_t tooMany = 0;
  for (std::int64_t leaf = 0; leaf < tree.NumberOfLeaves(); ++leaf)
  {
    double least = Infinity, most = -Infinity;
    CellRange finite, foundFinite;
    std::uint64_t active = 0;
    for (std::int64_t rank = 64 * leaf; rank < tree.EndOfLeaf(leaf); ++rank)
    {
      const MeshCell cell = ReadPlainly(tree.TheMesh(), tree.CellAt(rank));
      const auto count = static_cast<std::size_t>(cell.NumberOfPoints());
      const bool areNumbers = std::none_of(cell.Values.data(), cell.Values.data() + count,
        [](double value) { return std::isnan(value); });
      for (std::size_t i = 0; i < count; ++i)
      {
        const double value = cell.Values[i];
        least = areNumbers ? std::min(least, value) : least;
        most = areNumbers ? std::max(most, value) : most;
        const bool isFinite = areNumbers && std::isfinite(value);
        finite.Min = isFinite ? std::min(finite.Min, value) : finite.Min;
        finite.Max = isFinite ? std::max(finite.Max, value) : finite.Max;
      }
      for (const ValueBand& band : bands)
      {
        const auto* const end = cell.Values.data() + count;
        const bool isAnyInside =
          std::any_of(cell.Values.data(), end, [&](double value) { return value >= band.Low; });
        const bool isAnyOutside =
          std::any_of(cell.Values.data(), end, [&](double value) { return !(value >= band.High); });
        const std::uint64_t bit = std::uint64_t(1) << (rank & 63);
        active |= isAnyInside && isAnyOutside && areNumbers ? bit : 0;
      }
    }
    EXPECT_EQ(fresh->CellsIn(leaf, bands), active);
    const CellRange range = tree.RangeOfLeaf(leaf, &foundFinite);
    EXPECT_EQ(range.Min, least);
    EXPECT_EQ(range.Max, most);
    EXPECT_EQ(foundFinite.Min, finite.Min);
    EXPECT_EQ(foundFinite.Max, finite.Max);
    // Once ranges are known, they are asked for, which are rounded.
    const std::uint64_t known = tree.CellsIn(leaf, bands);
    EXPECT_EQ(active & ~known, 0u);
    tooMany += hwy::PopCount(known & ~active);
  }
  EXPECT_LE(tooMany, static_cast<std::size_t>(1 + tree.NumberOfCells() / 20));
}

TEST(MeshTree, RangesAndActiveCells)
{
  for (const auto& [name, mesh] : AllMeshes())
  {
    SCOPED_TRACE(name);
    const TreePointer tree = TreeOf(mesh);
    ExpectRanges(*tree, { { 0.1, 0.1 } });
    ExpectRanges(*tree, { { -0.5, -0.5 }, { 1.0, 1.2 } });
    ExpectRanges(*tree, {});
    EXPECT_EQ(tree->RangeOfLeaf(tree->NumberOfLeaves()).Min, Infinity) << "no cells";
    EXPECT_EQ(tree->CellsIn(tree->NumberOfLeaves(), { { 0.1, 0.1 } }), 0u);
  }
}

TEST(MeshTree, ValuesThatAreNotFinite)
{
  auto arrays = Meshes::MakeBlock(Meshes::Cells::Mixed, {});
  for (std::size_t i = 0; i < arrays.Values.size(); i += 17)
  {
    arrays.Values[i] = i % 3 == 0 ? NaN : i % 3 == 1 ? Infinity : -Infinity;
  }
  ExpectRanges(*TreeOf(Meshes::MeshOf(arrays)), { { 0.1, 0.1 } });
  arrays.Values.assign(arrays.Values.size(), NaN);
  const TreePointer tree = TreeOf(Meshes::MeshOf(arrays));
  ExpectRanges(*tree, { { 0.1, 0.1 } });
  EXPECT_EQ(tree->RangeOfLeaf(0).Max, -Infinity);
}

TEST(MeshTree, NewValues)
{
  auto arrays = Meshes::MakeBlock(Meshes::Cells::Mixed, {});
  const TreePointer tree = TreeOf(Meshes::MeshOf(arrays));
  std::reverse(arrays.Values.begin(), arrays.Values.end());
  const MeshPointer mesh = Meshes::MeshOf(arrays);
  const TreePointer other = tree->WithValuesOf(mesh);
  EXPECT_EQ(&other->TheMesh(), mesh.get());
  EXPECT_EQ(&other->LeafBox(0), &tree->LeafBox(0));
  ExpectRanges(*other, { { 0.3, 0.3 } });
}

TEST(MeshTree, EdgeLengths)
{
  Meshes::Block block;
  block.Cubes = { 10, 20, 40 };
  block.Jitter = 0.0;
  for (const auto cells : { Meshes::Cells::Hexahedra, Meshes::Cells::Wedges })
  {
    const TreePointer tree = TreeOf(Meshes::MeshOf(Meshes::MakeBlock(cells, block)));
    EXPECT_NEAR(tree->Edges().Shortest, 1.0 / 40, 1e-12);
    EXPECT_GT(tree->Edges().Mean, 1.0 / 40);
    EXPECT_LT(tree->Edges().Mean, 1.0 / 10);
    EXPECT_NEAR(
      tree->Edges().Longest, cells == Meshes::Cells::Wedges ? std::hypot(0.1, 0.05) : 0.1, 1e-12);
  }
}

void ExpectSameTree(const MeshTree& a, const MeshTree& b)
{
  ASSERT_EQ(a.NumberOfCells(), b.NumberOfCells());
  for (std::int64_t rank = 0; rank < a.NumberOfCells(); ++rank)
  {
    ASSERT_EQ(a.CellAt(rank), b.CellAt(rank));
  }
  EXPECT_EQ(a.Dimensions(), b.Dimensions());
  EXPECT_EQ(a.Low(), b.Low());
  EXPECT_EQ(a.Scale(), b.Scale());
  EXPECT_EQ(a.Edges().Shortest, b.Edges().Shortest);
  EXPECT_EQ(a.Edges().Mean, b.Edges().Mean);
  EXPECT_EQ(a.Edges().Longest, b.Edges().Longest);
  ASSERT_EQ(a.NumberOfLevels(), b.NumberOfLevels());
  for (std::size_t level = 0; level < a.NumberOfLevels(); ++level)
  {
    ASSERT_EQ(a.NumberOfBlocks(level), b.NumberOfBlocks(level));
    for (std::int64_t i = 0; i < a.NumberOfBlocks(level); ++i)
    {
      ASSERT_EQ(a.BlockBox(level, i).Low, b.BlockBox(level, i).Low);
      ASSERT_EQ(a.BlockBox(level, i).High, b.BlockBox(level, i).High);
    }
  }
}

TEST(MeshTree, AnyNumberOfThreads)
{
  Meshes::Block block;
  block.Cubes = glm::ivec3(IsMemorySanitized ? 12 : 32);
  const MeshPointer mesh = Meshes::MeshOf(Meshes::MakeBlock(Meshes::Cells::SixTetrahedra, block));
  vtkSMPTools::Initialize(1);
  const TreePointer alone = TreeOf(mesh);
  for (const int threads : { 2, 3, 8 })
  {
    vtkSMPTools::Initialize(threads);
    ExpectSameTree(*TreeOf(mesh), *alone);
  }
  vtkSMPTools::Initialize(0);
}

/// Cells that are close together, as seen from the whole mesh, are told apart by finer curves.
TEST(MeshTree, DenseCorner)
{
  Meshes::Block block;
  block.Cubes = glm::ivec3(IsMemorySanitized ? 16 : 40);
  const auto tetrahedra = Meshes::Cells::SixTetrahedra;
  const auto plain = Meshes::MakeBlock(tetrahedra, block);
  auto dense = plain;
  Meshes::Transform(dense, glm::dmat4(glm::dmat3(1e-6)));
  Meshes::Block one;
  one.Cubes = glm::ivec3(1);
  const MeshPointer mesh = Meshes::MeshOf(dense, Meshes::MakeBlock(tetrahedra, one));
  const auto sizesOf = [](const MeshTree& tree)
  {
    double sum = 0.0;
    for (std::int64_t leaf = 0; leaf + 1 < tree.NumberOfLeaves(); ++leaf)
    {
      const FloatBox& box = tree.LeafBox(leaf);
      sum += tree.Scale() * static_cast<double>(glm::length(box.High - box.Low));
    }
    return sum;
  };
  const double sizes = sizesOf(*TreeOf(Meshes::MeshOf(plain)));
  EXPECT_LT(sizesOf(*TreeOf(mesh)), 1.3e-6 * sizes + 2.0);
}

/// Many cells at one place end the search for finer curves.
TEST(MeshTree, EqualCells)
{
  Meshes::Block one;
  one.Cubes = glm::ivec3(1);
  auto arrays = Meshes::MakeBlock(Meshes::Cells::Hexahedra, one);
  const auto cell = arrays.Connectivity;
  const int count = IsMemorySanitized ? 10000 : 300000;
  for (int i = 1; i < count; ++i)
  {
    arrays.Connectivity.insert(arrays.Connectivity.end(), cell.begin(), cell.end());
    arrays.Offsets.push_back(static_cast<std::int64_t>(arrays.Connectivity.size()));
  }
  arrays.Types.clear();
  const TreePointer tree = TreeOf(Meshes::MeshOf(arrays));
  EXPECT_EQ(tree->NumberOfCells(), count);
  for (std::int64_t rank = 0; rank < count; ++rank)
  {
    ASSERT_EQ(tree->CellAt(rank), rank);
  }
}

TEST(MeshTree, Refit)
{
  auto arrays = Meshes::MakeBlock(Meshes::Cells::Mixed, {});
  const TreePointer tree = TreeOf(Meshes::MeshOf(arrays));
  Meshes::Transform(
    arrays, { { 2, 1, 0, 0 }, { 0, 1, 0, 0 }, { 0.5, 0, 1, 0 }, { 1e3, 0, -7, 1 } });
  const MeshPointer moved = Meshes::MeshOf(arrays);
  MeshProblem problem;
  const TreePointer refit = tree->Refit(moved, {}, problem);
  ASSERT_NE(refit, nullptr);
  for (std::int64_t rank = 0; rank < refit->NumberOfCells(); ++rank)
  {
    ASSERT_EQ(refit->CellAt(rank), tree->CellAt(rank));
    for (const glm::dvec3& point : IndexPoints(*refit, rank))
    {
      ExpectInside(refit->LeafBox(rank / 64), point);
    }
  }
  MeshProblem none;
  // Back where they were, boxes are those of Build.
  const MeshPointer back = Meshes::MeshOf(Meshes::MakeBlock(Meshes::Cells::Mixed, {}));
  ExpectSameTree(*refit->Refit(back, {}, none), *tree);
  arrays.Points[3 * 100 + 1] = NaN;
  EXPECT_EQ(tree->Refit(Meshes::MeshOf(arrays), {}, problem), nullptr);
  EXPECT_EQ(problem.Defect, MeshDefect::PointNotFinite);
  EXPECT_EQ(problem.Point, 100);
}

}
