// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// No crossing lies in a pixel that the outlines of cells leave out, by a search of every cell for
// every ray.

#include "Checks/Sanitized.h"
#include "Checks/VectorTarget.h"
#include "Grid.h"
#include "Kinds/MeshKind.h"
#include "Lattice/RaySource.h"
#include "Mesh/Tiles/MeshTile.h"
#include "Mesh/Tiles/PreparedCells.h"
#include "Mesh/Tiles/SeenStrip.h"
#include "Mesh/Tiles/TileGrid.h"
#include "Mesh/Tree/MeshTrees.h"

#include <glm/gtc/matrix_transform.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

namespace
{

using namespace TemporalCoherence;
using namespace MeshTrees;

constexpr int Rounds = IsMemorySanitized ? 40 : 200;
constexpr int Pixels = 64; ///< along each side of a picture

class Outlines : public ::testing::TestWithParam<Meshes::Cells>
{
protected:
  double Around(double middle, double most)
  {
    return middle + std::uniform_real_distribution<double>(-most, most)(this->Engine);
  }
  int Below(int count) { return std::uniform_int_distribution<int>(0, count - 1)(this->Engine); }
  glm::dvec3 Point() { return { this->Around(0, 1), this->Around(0, 1), this->Around(0, 1) }; }

  /// Also flat, far away and turned.
  void MakeMesh()
  {
    Meshes::Block block;
    block.Cubes = { 1 + this->Below(4), 1 + this->Below(3), 1 + this->Below(4) };
    block.Jitter = this->Below(3) == 0 ? 0.0 : 0.2;
    block.Seed = static_cast<unsigned int>(this->Engine());
    auto arrays = Meshes::MakeBlock(this->GetParam(), block);
    const glm::dmat4 one(1.0);
    const std::array<glm::dmat4, 4> moves = { one, glm::scale(one, { 1.0, 1.0, 1e-5 }),
      glm::translate(one, { 1e6, -3e5, 2e6 }), glm::rotate(one, 1.0, this->Point()) };
    Meshes::Transform(arrays, moves[static_cast<std::size_t>(this->Below(4))]);
    // An isovalue that passes a vertex, or nearly so, makes polygons with edges of no length.
    const double value = arrays.Values[this->Engine() % arrays.Values.size()];
    const std::array<double, 4> isovalues = { this->Around(0, 0.8), value, value - 1e-15,
      this->Around(value, 3e-7) };
    this->Isovalue = isovalues[static_cast<std::size_t>(this->Below(4))];
    if (this->Below(4) == 0)
    {
      // One value is far from all others, which are all next to the isovalue.
      this->Isovalue *= 4e-6;
      for (double& each : arrays.Values)
      {
        each *= 4e-6;
      }
      arrays.Values[this->Engine() % arrays.Values.size()] = this->Below(2) == 0 ? 2.0 : -2.0;
    }
    this->Tree = TreeOf(Meshes::MeshOf(arrays));
  }

  /// From all sides, along axes, from far away, and so near that a cell fills the picture.
  View MakeRandomView()
  {
    const glm::dvec3 middle = 0.5 * glm::dvec3(this->Tree->Dimensions());
    const double radius = glm::length(middle);
    glm::dvec3 direction = glm::normalize(this->Point());
    if (this->Below(4) == 0)
    {
      direction = glm::dvec3(0.0);
      direction[this->Below(3)] = this->Below(2) == 0 ? 1.0 : -1.0;
    }
    const double distance = radius * this->Around(2.0, 1.8);
    const glm::dvec3 eye = middle + distance * direction;
    const glm::dvec3 up = std::abs(direction.z) > 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, 1);
    const double near = std::max(1e-3 * radius, distance - 2.0 * radius);
    const double far = distance + 3.0 * radius, width = radius * std::exp(this->Around(-2.0, 2.0));
    const bool isParallel = this->Below(2) == 0;
    glm::dmat4 oblique(1.0);
    if (!isParallel && this->Below(2) == 0)
    {
      // What the projection divides by is not the distance along the optical axis.
      oblique[0][2] = this->Around(0.0, 0.5);
      oblique[1][2] = this->Around(0.0, 0.5);
    }
    const glm::dmat4 projection = isParallel
      ? glm::ortho(-width, width, -width, width, near, far)
      : glm::perspective(this->Around(0.8, 0.7), 1.0, near, far) * oblique;
    View view;
    EXPECT_TRUE(
      MakeView(glm::lookAt(eye, middle, up), projection, { near, far }, { Pixels, Pixels }, view));
    return view;
  }

  /// Compare the cells of a leaf.
  void Compare(const PreparedCells& cells, const MeshTile& tile, const SeenCells& seen)
  {
    std::array<std::uint64_t, 64> pixels{};
    for (std::size_t i = 0; i < seen.Count; ++i)
    {
      pixels[seen.Cell[i]] = seen.Pixels[i];
      this->Seen += hwy::PopCount(seen.Pixels[i]);
    }
    for (std::size_t cell = 0; cell < cells.Count(); ++cell)
    {
      MeshKernels::Crossings found;
      if (cells.IsTetrahedron(cell))
      {
        MeshKernels::TetrahedronCrossings(
          cells.Tetrahedra[cell], tile.InMesh, ~std::uint64_t(0), found);
      }
      else
      {
        const PreparedHexahedron& hexahedron = cells.HexahedronAt(cell);
        MeshKernels::HexahedronCrossings(hexahedron.Functions, hexahedron.Cell,
          hexahedron.Differences, tile.InMesh, ~std::uint64_t(0), found);
      }
      for (std::size_t i = 0; i < found.Count; ++i)
      {
        this->Lost += (pixels[cell] >> found.Ray[i] & 1u) == 0;
      }
      this->Found += found.Count;
    }
  }

  /// Compare a row of tiles: strips are seen by the first one.
  void CompareRow(const RaySource& source, int y)
  {
    const BoxLevels boxes(*this->Tree);
    const auto kind = MeshKind(this->Tree, false);
    const ActiveLeaves active(*kind, *this->Tree, boxes, nullptr);
    std::vector<PreparedCells> leaves(static_cast<std::size_t>(this->Tree->NumberOfLeaves()));
    for (std::size_t leaf = 0; leaf < leaves.size(); ++leaf)
    {
      const auto number = static_cast<std::int64_t>(leaf);
      PrepareCells(*this->Tree, number, active.CellsOf(number),
        MeshDifference(this->Isovalue, { -2.0, 2.0 }), 0.0, CellPurpose::Crossings, leaves[leaf]);
    }
    for (const std::int64_t target : VectorTarget::All())
    {
      const VectorTarget vectors(target);
      SeenStrip strip;
      for (int x = 0; x < Pixels; x += 2 * TileSize)
      {
        RayBatch rays;
        source.SetUp({ x, y }, glm::ivec2(TileSize), rays);
        const MeshTile tile(rays, *this->Tree, active, RayLimits::BeginToEnd);
        for (std::size_t leaf = 0; tile.Grid.IsGrid() && leaf < leaves.size(); ++leaf)
        {
          const auto number = static_cast<std::int64_t>(leaf);
          SeenCells seen;
          if (strip.FindPixels(
                tile, number, leaves[leaf].Outlines, this->Tree->LeafBox(number), seen))
          {
            this->Compare(leaves[leaf], tile, seen);
          }
        }
      }
    }
  }

  std::mt19937_64 Engine{ 5 };
  TreePointer Tree;
  double Isovalue = 0.0;
  std::size_t Found = 0, Lost = 0, Seen = 0;
};

TEST_P(Outlines, LeaveNoCrossingOut)
{
  for (int round = 0; round < Rounds; ++round)
  {
    this->MakeMesh();
    const View view = this->MakeRandomView();
    const RaySource source(view, IndexTransform(), this->Tree->Dimensions());
    const std::size_t before = this->Lost;
    for (int y = 0; y < Pixels; y += 2 * TileSize)
    {
      this->CompareRow(source, y);
    }
    EXPECT_EQ(this->Lost, before) << "round " << round;
  }
  EXPECT_GT(this->Found, std::size_t(4 * Rounds));
  // Not many more pixels than those that see a surface.
  EXPECT_LT(this->Seen, (IsMemorySanitized ? 8 : 4) * this->Found);
}

INSTANTIATE_TEST_SUITE_P(AllCells, Outlines,
  ::testing::Values(Meshes::Cells::FiveTetrahedra, Meshes::Cells::SixTetrahedra,
    Meshes::Cells::Hexahedra, Meshes::Cells::Wedges, Meshes::Cells::Pyramids,
    Meshes::Cells::Mixed));

}
