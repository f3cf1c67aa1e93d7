// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Solids whose values are all infinite are capped where rays enter them.

#include "Grid.h"
#include "Kinds/MeshKind.h"
#include "Mesh/Tree/MeshTree.h"
#include "Render/FrameRenderer.h"
#include "SameFrames.h"
#include "Volumes/Meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <utility>

namespace
{

using namespace TemporalCoherence;

class InfiniteSolids : public ::testing::TestWithParam<Meshes::Cells>
{
};

Frame Draw(const FrameKey& key, bool leaps)
{
  FrameOptions options;
  options.SpaceLeaping = leaps;
  FrameRenderer renderer;
  EXPECT_TRUE(renderer.Render(key, options));
  return renderer.LastFrame();
}

/// A solid is capped where rays enter it, also where all of it is infinite.
TEST_P(InfiniteSolids, AreCapped)
{
  Meshes::DoubleArrays arrays = Meshes::MakeBlock(this->GetParam(), {});
  std::fill(arrays.Values.begin(), arrays.Values.end(), std::numeric_limits<double>::infinity());
  MeshProblem problem;
  const std::shared_ptr<const MeshTree> tree =
    MeshTree::Build(Meshes::MeshOf(std::move(arrays)), nullptr, ~std::size_t(0), problem);
  ASSERT_TRUE(tree);
  FrameKey key;
  key.Samples = MeshField(*tree, MeshKind(tree, false));
  key.EditIsosurfaces() = { { 0.3 }, SurfaceMode::Threshold };
  key.Appearance.Colors = { glm::dvec3(1.0) };
  const glm::ivec3 box(glm::ceil(glm::dvec3(1.0 / tree->Scale())));
  key.View = LookAt(box + 1, { 1.0, 2.0, 0.7 }, { 61, 47 });
  const Frame frame = Draw(key, true);
  EXPECT_TRUE(ShowTheSame(Draw(key, false), frame));
  EXPECT_GT(std::count(frame.Kinds.begin(), frame.Kinds.end(), HitKind::Cap), 200);
}

INSTANTIATE_TEST_SUITE_P(AllCells, InfiniteSolids,
  ::testing::Values(Meshes::Cells::FiveTetrahedra, Meshes::Cells::SixTetrahedra,
    Meshes::Cells::Hexahedra, Meshes::Cells::Wedges, Meshes::Cells::Pyramids,
    Meshes::Cells::Mixed));

}
