// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// A defect of a mesh is reported with its cell, and harmless peculiarities are not. Trees keep to
// limits of cells and memory, and can be stopped while they are built.

#include "MeshTrees.h"

#include <algorithm>

namespace
{

using namespace MeshTrees;

TEST(MeshTree, Empty)
{
  Meshes::DoubleArrays hidden = Meshes::MakeBlock(Meshes::Cells::Hexahedra, {});
  hidden.Flags.assign(hidden.Types.size(), 1);
  for (const MeshPointer& mesh : { std::make_shared<const Mesh>(),
         Meshes::MeshOf(Meshes::DoubleArrays()), Meshes::MeshOf(hidden) })
  {
    const TreePointer tree = TreeOf(mesh);
    ASSERT_NE(tree, nullptr);
    EXPECT_EQ(tree->NumberOfCells(), 0);
    EXPECT_EQ(tree->Dimensions(), glm::ivec3(1));
    EXPECT_EQ(tree->BoxOf({ glm::ivec3(0), glm::ivec3(4) }).High, glm::dvec3(0.0));
    MeshProblem problem;
    EXPECT_NE(tree->Refit(mesh, {}, problem), nullptr);
  }
}

TEST(MeshTree, Defects)
{
  const auto good = Meshes::MakeBlock(Meshes::Cells::Mixed, {});
  const std::size_t cell = 123;
  const auto first = static_cast<std::size_t>(good.Offsets[cell]);
  const auto expect = [&](const auto& spoil, MeshDefect defect, std::int64_t point)
  {
    auto bad = good;
    spoil(bad);
    for (const MeshPointer& mesh : { Meshes::MeshOf(bad), Meshes::MeshOf(Meshes::Narrowed(bad)) })
    {
      const MeshProblem problem = ProblemOf(mesh);
      EXPECT_EQ(problem.Defect, defect);
      EXPECT_EQ(problem.Cell, static_cast<std::int64_t>(cell));
      EXPECT_EQ(problem.Point, point);
    }
  };
  const auto points = static_cast<std::int64_t>(good.Values.size());
  using Arrays = Meshes::DoubleArrays;
  expect([&](Arrays& bad) { bad.Connectivity[first + 2] = points; }, MeshDefect::PointOutOfRange,
    points);
  expect([&](Arrays& bad) { bad.Connectivity[first + 1] = -1; }, MeshDefect::PointOutOfRange, -1);
  expect([&](Arrays& bad) { bad.Offsets[cell + 1] = bad.Offsets[cell] - 1; },
    MeshDefect::OffsetsNotAscending, -1);
  expect(
    [&](Arrays& bad) { bad.Offsets[cell + 1] = 1 << 30; }, MeshDefect::OffsetsNotAscending, -1);
  expect([&](Arrays& bad) { bad.Offsets[cell + 1] += 1; }, MeshDefect::WrongNumberOfPoints, -1);
  expect(
    [&](Arrays& bad)
    {
      bad.Points.insert(bad.Points.end(), { 0.0, NaN, 0.0 });
      bad.Values.push_back(0.0);
      bad.Connectivity[first] = points;
    },
    MeshDefect::PointNotFinite, points);
  auto bad = good;
  bad.Offsets[0] = -8;
  EXPECT_EQ(ProblemOf(Meshes::MeshOf(bad)).Defect, MeshDefect::OffsetsNotAscending);
}

TEST(MeshTree, DefectsThatDoNotMatter)
{
  // Points without cells, and hidden cells, are not read.
  auto arrays = Meshes::MakeBlock(Meshes::Cells::Mixed, {});
  const auto points = static_cast<std::int64_t>(arrays.Values.size());
  arrays.Points.insert(arrays.Points.end(), { NaN, Infinity, 0.0 });
  arrays.Values.push_back(0.0);
  arrays.Flags.assign(arrays.Types.size(), 0);
  arrays.Flags[5] = 1;
  arrays.Connectivity[static_cast<std::size_t>(arrays.Offsets[5])] = points;
  EXPECT_NE(TreeOf(Meshes::MeshOf(arrays)), nullptr);
}

TEST(MeshTree, DefectsOfGrids)
{
  auto arrays = Meshes::MakeCurvilinear({});
  arrays.Points[3 * 90] = -Infinity;
  MeshProblem problem =
    ProblemOf(Meshes::MeshOf(Meshes::MakeBlock(Meshes::Cells::Hexahedra, {}), arrays));
  EXPECT_EQ(problem.Defect, MeshDefect::PointNotFinite);
  EXPECT_EQ(problem.Point, 90);
  EXPECT_GE(problem.Cell, 512);
  Mesh mesh;
  mesh.Parts = { Meshes::MakeCurvilinear({}).Part() };
  mesh.Parts[0].NumberOfPoints -= 1;
  problem = ProblemOf(std::make_shared<const Mesh>(mesh));
  EXPECT_EQ(problem.Defect, MeshDefect::WrongNumberOfPoints);
  mesh.Parts[0].NumberOfPoints += 1;
  mesh.Parts[0].NumberOfCells += 1;
  problem = ProblemOf(std::make_shared<const Mesh>(mesh));
  EXPECT_EQ(problem.Defect, MeshDefect::WrongNumberOfPoints);
}

TEST(MeshTree, TooManyCells)
{
  Mesh mesh;
  mesh.Parts.resize(3);
  for (MeshPart& part : mesh.Parts)
  {
    part.NumberOfCells = std::int64_t(1) << 31; // nothing is read
  }
  mesh.Parts[0].NumberOfCells = 0;
  EXPECT_EQ(ProblemOf(std::make_shared<const Mesh>(mesh)).Defect, MeshDefect::TooManyCells);
}

TEST(MeshTree, MemoryLimit)
{
  const MeshPointer mesh = Meshes::MeshOf(Meshes::MakeBlock(Meshes::Cells::Hexahedra, {}));
  const std::size_t needed = MeshTree::MemoryToBuild(512);
  MeshProblem problem;
  EXPECT_NE(MeshTree::Build(mesh, {}, needed, problem), nullptr);
  EXPECT_EQ(MeshTree::Build(mesh, {}, needed - 1, problem), nullptr);
  EXPECT_EQ(problem.Defect, MeshDefect::NoMemory);
}

/// Progress ascends, and each call can stop the work.
TEST(MeshTree, Progress)
{
  Meshes::Block block;
  block.Cubes = glm::ivec3(20);
  const MeshPointer mesh = Meshes::MeshOf(Meshes::MakeBlock(Meshes::Cells::SixTetrahedra, block));
  std::vector<double> shares;
  MeshProblem problem;
  const auto record = [&](double share)
  {
    shares.push_back(share);
    return true;
  };
  ASSERT_NE(MeshTree::Build(mesh, record, NoLimit, problem), nullptr);
  EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
  EXPECT_GT(shares.size(), 5u);
  EXPECT_GE(shares.front(), 0.0);
  EXPECT_LE(shares.back(), 1.0);
  for (std::size_t last = 0; last < shares.size(); ++last)
  {
    std::size_t calls = 0;
    EXPECT_EQ(MeshTree::Build(
                mesh, [&](double) { return calls++ < last; }, NoLimit, problem),
      nullptr);
    EXPECT_EQ(problem.Defect, MeshDefect::Stopped);
    EXPECT_EQ(calls, last + 1) << "nothing is asked after the stop";
  }
}

}
