// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// What a tree tells of its mesh does not depend on the order of its cells, which a refit keeps.

#include "Mesh/Tracing/MeshGradients.h"
#include "Mesh/Tree/MeshTree.h"
#include "Volumes/Meshes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <memory>

namespace
{

using namespace TemporalCoherence;

class MeshRefit : public ::testing::TestWithParam<Meshes::Cells>
{
protected:
  using TreePointer = std::shared_ptr<const MeshTree>;

  MeshRefit()
  {
    auto first = Meshes::MakeBlock(this->GetParam(), {});
    auto second = first;
    Meshes::Transform(second, { { 1, 0, 0, 0 }, { 0, 1, 0, 0 }, { 0, 0, 1, 0 }, { 1, 0, 0, 1 } });
    for (std::size_t cell = 0; cell < 40; ++cell)
    {
      second.Flags.push_back(1);
    }
    second.Flags.resize(static_cast<std::size_t>(second.NumberOfCells()), 0);
    MeshProblem problem;
    const TreePointer before =
      MeshTree::Build(Meshes::MeshOf(first, second), {}, ~std::size_t(0), problem);
    for (auto* const part : { &first, &second })
    {
      for (std::size_t i = 0; i < part->Points.size(); i += 3)
      {
        part->Points[i] += 0.3 * std::sin(5.0 * part->Points[i + 1]);
      }
    }
    const auto moved = Meshes::MeshOf(first, second);
    this->Refitted = before->Refit(moved, {}, problem);
    this->Fresh = MeshTree::Build(moved, {}, ~std::size_t(0), problem);
  }

  bool HaveTheSameOrder() const
  {
    std::int64_t same = 0;
    for (std::int64_t rank = 0; rank < this->Fresh->NumberOfCells(); ++rank)
    {
      same += this->Fresh->CellAt(rank) == this->Refitted->CellAt(rank);
    }
    return same == this->Fresh->NumberOfCells();
  }

  TreePointer Refitted, Fresh;
};

TEST_P(MeshRefit, EdgesAreThoseOfANewTree)
{
  ASSERT_FALSE(this->HaveTheSameOrder());
  const EdgeLengths &refitted = this->Refitted->Edges(), &fresh = this->Fresh->Edges();
  EXPECT_EQ(refitted.Shortest, fresh.Shortest);
  EXPECT_EQ(refitted.Mean, fresh.Mean);
  EXPECT_EQ(refitted.Longest, fresh.Longest);
  EXPECT_GT(fresh.Mean, fresh.Shortest);
  EXPECT_LT(fresh.Mean, fresh.Longest);
}

TEST_P(MeshRefit, AveragedGradientsAreThoseOfANewTree)
{
  ASSERT_FALSE(this->HaveTheSameOrder());
  EXPECT_TRUE(
    PointGradients::Make(*this->Refitted)->Parts == PointGradients::Make(*this->Fresh)->Parts);
}

INSTANTIATE_TEST_SUITE_P(AllCells, MeshRefit,
  ::testing::Values(Meshes::Cells::FiveTetrahedra, Meshes::Cells::SixTetrahedra,
    Meshes::Cells::Hexahedra, Meshes::Cells::Wedges, Meshes::Cells::Pyramids,
    Meshes::Cells::Mixed));

}
