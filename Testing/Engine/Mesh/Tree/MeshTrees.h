// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_MeshTrees_h
#define Testing_MeshTrees_h

#include "Checks/Infinity.h"
#include "Mesh/Tree/MeshTree.h"
#include "Volumes/Meshes.h"
#include "Volumes/ReadCell.h"

#include <gtest/gtest.h>

#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

/// Trees of all kinds of meshes.
namespace MeshTrees
{

using namespace TemporalCoherence;
using MeshPointer = std::shared_ptr<const Mesh>;
using TreePointer = std::shared_ptr<const MeshTree>;

constexpr std::size_t NoLimit = std::numeric_limits<std::size_t>::max();
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

inline TreePointer TreeOf(const MeshPointer& mesh)
{
  MeshProblem problem;
  const TreePointer tree = MeshTree::Build(mesh, {}, NoLimit, problem);
  EXPECT_EQ(problem.Defect, MeshDefect::None);
  return tree;
}

inline MeshProblem ProblemOf(const MeshPointer& mesh)
{
  MeshProblem problem;
  EXPECT_EQ(MeshTree::Build(mesh, {}, NoLimit, problem), nullptr);
  return problem;
}

/// A cell as ReadCell reads it, by its number through all parts.
inline MeshCell ReadPlainly(const Mesh& mesh, std::int64_t number)
{
  MeshCell cell;
  for (const MeshPart& part : mesh.Parts)
  {
    if (number < part.NumberOfCells)
    {
      ReadCell(part, number, cell);
      return cell;
    }
    number -= part.NumberOfCells;
  }
  return cell;
}

/// All shapes of meshes that the tests below look at.
inline std::vector<std::pair<std::string, MeshPointer>> AllMeshes()
{
  using namespace Meshes;
  Block block;
  block.Cubes = { 11, 9, 10 };
  Block graded;
  graded.Cubes = glm::ivec3(14);
  graded.Grading = 1000.0;
  auto far = MakeBlock(Cells::SixTetrahedra, block);
  Transform(far, { { 1e-3, 0, 0, 0 }, { 0, 3e-3, 0, 0 }, { 0, 0, 1e-3, 0 }, { 5e6, -3e6, 7, 1 } });
  auto hidden = MakeBlock(Cells::Mixed, block);
  hidden.Flags.assign(hidden.Types.size(), 0);
  for (std::size_t i = 0; i < hidden.Flags.size(); i += 3)
  {
    hidden.Flags[i] = 4;
    hidden.Types[i + 1] = 5; // a triangle
  }
  Block other = block;
  other.Seed = 2;
  auto moved = MakeBlock(Cells::Pyramids, other);
  Transform(moved, { { 1, 0, 0, 0 }, { 0, 1, 0, 0 }, { 0, 0, 1, 0 }, { 1, 0, 0, 1 } });
  auto flat = MakeBlock(Cells::FiveTetrahedra, block);
  Transform(flat, { { 1, 0, 0, 0 }, { 0, 1, 0, 0 }, { 0, 0, 0, 0 }, { 0, 0, 4, 1 } });
  auto point = MakeBlock(Cells::Hexahedra, block);
  Transform(point, { { 0, 0, 0, 0 }, { 0, 0, 0, 0 }, { 0, 0, 0, 0 }, { 1, 2, 3, 1 } });
  auto tiny = MakeBlock(Cells::Wedges, block);
  Transform(tiny, glm::dmat4(glm::dmat3(1e-290)));
  auto huge = MakeBlock(Cells::Wedges, block);
  Transform(huge, glm::dmat4(glm::dmat3(9e99)));
  Block one;
  one.Cubes = glm::ivec3(1);
  return { { "five", MeshOf(MakeBlock(Cells::FiveTetrahedra, block)) },
    { "narrow", MeshOf(Narrowed(MakeBlock(Cells::SixTetrahedra, block))) },
    { "hexahedra", MeshOf(MakeBlock(Cells::Hexahedra, block)) },
    { "wedges", MeshOf(MakeBlock(Cells::Wedges, block)) },
    { "pyramids", MeshOf(MakeBlock(Cells::Pyramids, block)) },
    { "mixed", MeshOf(Narrowed(MakeBlock(Cells::Mixed, block))) },
    { "curvilinear", MeshOf(MakeCurvilinear(block)) }, { "hidden", MeshOf(hidden) },
    { "graded", MeshOf(MakeBlock(Cells::SixTetrahedra, graded)) }, { "far", MeshOf(far) },
    { "parts",
      MeshOf(MakeCurvilinear(block), DoubleArrays(), moved, Narrowed(MakeCurvilinear(other))) },
    { "flat", MeshOf(flat) }, { "point", MeshOf(point) }, { "tiny", MeshOf(tiny) },
    { "huge", MeshOf(huge) }, { "one", MeshOf(MakeBlock(Cells::Hexahedra, one)) } };
}

}

#endif
