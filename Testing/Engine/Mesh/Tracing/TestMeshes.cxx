// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// The meshes that other tests draw are sound: cells have positive volumes that add up to the
// block's, and each inner face has two sides.

#include "Volumes/Meshes.h"
#include "Volumes/ReadCell.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

namespace
{

using namespace TemporalCoherence;
using Corner = std::array<double, 3>;

/// The volume of a cell and its faces, each as its corners in order.
double VolumeOf(const MeshCell& cell)
{
  if (cell.Shape == MeshCellShape::Tetrahedron)
  {
    const glm::dmat3 edges(cell.Points[1] - cell.Points[0], cell.Points[2] - cell.Points[0],
      cell.Points[3] - cell.Points[0]);
    return glm::determinant(edges) / 6.0;
  }
  // Two points along each axis integrate the determinant of a trilinear map exactly.
  double volume = 0.0;
  const double near = 0.5 - std::sqrt(1.0 / 12.0);
  for (int sample = 0; sample < 8; ++sample)
  {
    const glm::dvec3 at(sample & 1 ? near : 1.0 - near, sample & 2 ? near : 1.0 - near,
      sample & 4 ? near : 1.0 - near);
    glm::dmat3 edges(0.0);
    for (int i = 0; i < 8; ++i)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        double weight = 1.0;
        for (int other = 0; other < 3; ++other)
        {
          const bool isHigh = (i >> other & 1) != 0;
          weight *= other == axis ? (isHigh ? 1.0 : -1.0) : isHigh ? at[other] : 1.0 - at[other];
        }
        edges[axis] += weight * cell.Points[static_cast<std::size_t>(i)];
      }
    }
    volume += glm::determinant(edges) / 8.0;
  }
  return volume;
}

using FaceCorners = std::vector<Corner>;

std::vector<FaceCorners> CornersOfFaces(const MeshCell& cell)
{
  const auto face = [&](std::initializer_list<std::size_t> corners)
  {
    FaceCorners points;
    for (const std::size_t i : corners)
    {
      points.push_back({ cell.Points[i].x, cell.Points[i].y, cell.Points[i].z });
    }
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    return points;
  };
  if (cell.Shape == MeshCellShape::Tetrahedron)
  {
    return { face({ 0, 1, 2 }), face({ 0, 1, 3 }), face({ 0, 2, 3 }), face({ 1, 2, 3 }) };
  }
  return { face({ 0, 2, 4, 6 }), face({ 1, 3, 5, 7 }), face({ 0, 1, 4, 5 }), face({ 2, 3, 6, 7 }),
    face({ 0, 1, 2, 3 }), face({ 4, 5, 6, 7 }) };
}

class MeshesOf : public ::testing::TestWithParam<Meshes::Cells>
{
};

/// Cells have positive volumes whose sum is that of the block, and each inner face has two sides.
TEST_P(MeshesOf, Conforming)
{
  Meshes::Block block;
  block.Cubes = { 4, 6, 4 };
  const auto arrays = Meshes::MakeBlock(this->GetParam(), block);
  const MeshPart part = arrays.Part();
  double volume = 0.0;
  std::map<FaceCorners, int> sides;
  for (std::int64_t i = 0; i < part.NumberOfCells; ++i)
  {
    MeshCell cell;
    ReadCell(part, i, cell);
    ASSERT_NE(cell.Shape, MeshCellShape::None);
    const double own = VolumeOf(cell);
    EXPECT_GT(own, 0.0);
    volume += own;
    for (const FaceCorners& face : CornersOfFaces(cell))
    {
      sides[face] += face.size() > 2 ? 1 : 0;
    }
  }
  if (this->GetParam() != Meshes::Cells::Mixed)
  {
    EXPECT_NEAR(volume, 1.0, 1e-12);
  }
  for (const auto& [face, count] : sides)
  {
    EXPECT_LE(count, 2);
    const auto isInside = [](double number) { return number > 0.0 && number < 1.0; };
    glm::dvec3 centre(0.0);
    for (const Corner& corner : face)
    {
      centre += glm::dvec3(corner[0], corner[1], corner[2]) / double(face.size());
    }
    const bool isInner = isInside(centre.x) && isInside(centre.y) && isInside(centre.z);
    // In a mixed block, there are faces between cells and nothing.
    if (face.size() > 2 && isInner && this->GetParam() != Meshes::Cells::Mixed)
    {
      EXPECT_EQ(count, 2);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, MeshesOf,
  ::testing::Values(Meshes::Cells::FiveTetrahedra, Meshes::Cells::SixTetrahedra,
    Meshes::Cells::Hexahedra, Meshes::Cells::Wedges, Meshes::Cells::Pyramids,
    Meshes::Cells::Mixed));

TEST(Meshes, MixedHasAllCells)
{
  const auto arrays = Meshes::MakeBlock(Meshes::Cells::Mixed, {});
  for (const MeshCellType type : { MeshCellType::Tetrahedron, MeshCellType::Hexahedron,
         MeshCellType::Wedge, MeshCellType::Pyramid })
  {
    EXPECT_GT(
      std::count(arrays.Types.begin(), arrays.Types.end(), static_cast<std::uint8_t>(type)), 0);
  }
}

TEST(Meshes, CurvilinearIsTheSameAsHexahedra)
{
  const auto hexahedra = Meshes::MakeBlock(Meshes::Cells::Hexahedra, {});
  const auto grid = Meshes::MakeCurvilinear({});
  ASSERT_EQ(hexahedra.NumberOfCells(), grid.NumberOfCells());
  for (std::int64_t i = 0; i < grid.NumberOfCells(); ++i)
  {
    MeshCell a, b;
    ReadCell(hexahedra.Part(), i, a);
    ReadCell(grid.Part(), i, b);
    EXPECT_EQ(a.Points, b.Points);
    EXPECT_EQ(a.Values, b.Values);
  }
}

TEST(Meshes, GradedSizes)
{
  Meshes::Block block;
  block.Cubes = glm::ivec3(32);
  block.Grading = 1000.0;
  block.Jitter = 0.0;
  const auto arrays = Meshes::MakeBlock(Meshes::Cells::Hexahedra, block);
  double smallest = 1.0, largest = 0.0;
  for (std::int64_t i = 0; i < arrays.NumberOfCells(); ++i)
  {
    MeshCell cell;
    ReadCell(arrays.Part(), i, cell);
    const double edge = glm::length(cell.Points[1] - cell.Points[0]);
    smallest = std::min(smallest, edge);
    largest = std::max(largest, edge);
  }
  EXPECT_GT(largest / smallest, 900.0);
  EXPECT_LT(largest, 0.5);
}

}
