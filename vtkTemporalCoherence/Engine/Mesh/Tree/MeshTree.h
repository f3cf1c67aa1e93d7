// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_MeshTree_h
#define TemporalCoherence_MeshTree_h

#include "Mesh/Cells/Mesh.h"
#include "Mesh/Tree/MeshBoxes.h"
#include "Mesh/Tree/MeshCheck.h"
#include "Mesh/Tree/MeshLattice.h"
#include "Mesh/Tree/MeshOrder.h"
#include "Mesh/Tree/MeshRanges.h"
#include "Mesh/Tree/MeshReader.h"
#include "Scene/LayerBatch.h"
#include "Scene/Progress.h"
#include "Scene/Surfaces.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include <hwy/cache_control.h>

namespace TemporalCoherence
{

/// A tree over the cells of a mesh, laid into the lattice that frames ask for.
///
/// Cells with volume that are not hidden are sorted along a curve through space. The *rank* of a
/// cell is its place in this order. 64 consecutive cells are a leaf, 64 leaves a node, and so on,
/// each with a box around its cells. Boxes of different leaves may overlap, but each cell is in one
/// leaf. MeshLattice tells where ranks, leaves and nodes lie in the lattice.
///
/// A tree is immutable. It reads the cells from the mesh, and keeps the mesh alive.
class MeshTree
{
public:
  /// Check the mesh and order its cells, in parallel. A mesh without cells has an empty tree.
  /// \param progress    asked now and then by the calling thread
  /// \param memoryLimit of building the tree, in bytes
  /// \return null if there is a problem
  /// \throws std::bad_alloc
  static std::shared_ptr<const MeshTree> Build(const std::shared_ptr<const Mesh>& mesh,
    const ReportProgress& progress, std::size_t memoryLimit, MeshProblem& problem);

  /// Peak memory of building a tree of this many cells.
  static std::size_t MemoryToBuild(std::int64_t cells);

  /// A tree for the same cells and other points, in the same order, with new boxes.
  /// \pre the mesh has equal cells: CellStamp
  std::shared_ptr<const MeshTree> Refit(const std::shared_ptr<const Mesh>& mesh,
    const ReportProgress& progress, MeshProblem& problem) const;

  /// Make a copy of this tree for the values of another mesh. Reads nothing.
  /// \pre the mesh has equal cells and points: CellStamp and PointStamp
  std::shared_ptr<const MeshTree> WithValuesOf(const std::shared_ptr<const Mesh>& mesh) const;

  const Mesh& TheMesh() const { return *this->Source; }
  const MeshReader& Reader() const { return this->Cells; }

  /// Dimensions of the lattice in samples: cells + 1; 1 without any cell.
  const glm::ivec3& Dimensions() const { return this->Boxes->Dimensions; }

  /// mesh coordinates = Low + Scale * index. The scale is a power of two.
  double Scale() const { return this->Boxes->Scale; }
  const glm::dvec3& Low() const { return this->Boxes->Low; }
  glm::dvec3 ToMesh(const glm::dvec3& index) const { return this->Boxes->ToMesh(index); }
  glm::dvec3 ToIndex(const glm::dvec3& point) const { return this->Boxes->ToIndex(point); }

  /// Edge lengths of the cells in the tree.
  const EdgeLengths& Edges() const { return this->Boxes->Edges; }

  /// False if the points of each cell lie in a plane.
  bool HasVolume() const { return this->Boxes->HasVolume; }

  /// Cells in the tree: all cells with volume that are not hidden.
  std::int64_t NumberOfCells() const { return static_cast<std::int64_t>(this->Order->size()); }
  std::int64_t NumberOfLeaves() const { return (this->NumberOfCells() + 63) / 64; }
  /// The rank behind the last cell of a leaf. A leaf begins with rank 64 * leaf. An empty leaf ends
  /// there or before.
  std::int64_t EndOfLeaf(std::int64_t leaf) const
  {
    return std::min(64 * leaf + 64, this->NumberOfCells());
  }

  /// The rank at a cell of the lattice; NumberOfCells or more if the lattice cell is empty.
  static std::int64_t RankOf(const glm::ivec3& latticeCell)
  {
    return MeshLattice::NumberOf(latticeCell);
  }
  static glm::ivec3 PlaceOf(std::int64_t rank) { return MeshLattice::PlaceOf(rank); }

  /// The number of a cell of the mesh through all parts, given its rank.
  std::uint32_t CellAt(std::int64_t rank) const
  {
    return (*this->Order)[static_cast<std::size_t>(rank)];
  }

  /// Prefetch the data of CellAt.
  void PrefetchCellAt(std::int64_t rank) const { hwy::Prefetch(this->Order->data() + rank); }

  /// Boxes in index space. Leaf n holds the ranks from 64 n on, node n the leaves from 64 n on, and
  /// block n of a level the blocks from 64 n on of the level below. Level 0 are leaves, 1 nodes,
  /// and level 2 + i are the blocks of ActiveCells::LevelsAbove()[i]; the last level is one block.
  const FloatBox& LeafBox(std::int64_t leaf) const { return this->BlockBox(0, leaf); }
  const FloatBox& BlockBox(std::size_t level, std::int64_t block) const
  {
    return this->Boxes->Levels[level][static_cast<std::size_t>(block)];
  }
  /// The box of a block, by its place among the blocks of its level.
  /// \pre it holds cells
  const FloatBox& BlockBox(std::size_t level, const glm::ivec3& block) const
  {
    return this->BlockBox(level, MeshLattice::NumberOf(block));
  }
  std::size_t NumberOfLevels() const { return this->Boxes->Levels.size(); }
  std::int64_t NumberOfBlocks(std::size_t level) const
  {
    return static_cast<std::int64_t>(this->Boxes->Levels[level].size());
  }

  /// One bit for each child of a block. Children are blocks of the level below, or cells of a leaf.
  std::uint64_t ChildrenOf(std::size_t level, std::int64_t block) const
  {
    const std::int64_t all = level > 0 ? this->NumberOfBlocks(level - 1) : this->NumberOfCells();
    const std::int64_t left = all - MeshLattice::SizeOfBlock * block;
    return left >= MeshLattice::SizeOfBlock
      ? ~std::uint64_t(0)
      : (std::uint64_t(1) << std::max<std::int64_t>(left, 0)) - 1;
  }

  /// Call visit(leaf) for leaves of the tree, going down from the root.
  /// \param childrenOf childrenOf(level, block) tells which children of a block to go to, one bit
  ///                   each
  template <typename ChildrenToVisit, typename Visit>
  void VisitLeaves(const ChildrenToVisit& childrenOf, const Visit& visit) const
  {
    struct Block
    {
      std::size_t Level;
      std::int64_t Number;
    };
    if (this->NumberOfCells() == 0)
    {
      return;
    }
    constexpr std::size_t mostLevels = 12;
    std::array<Block, mostLevels * MeshLattice::SizeOfBlock> open;
    std::size_t count = 0;
    open[count++] = { this->NumberOfLevels() - 1, 0 };
    while (count > 0)
    {
      const Block block = open[--count];
      if (block.Level == 0)
      {
        visit(block.Number);
        continue;
      }
      ForEachRay(childrenOf(block.Level, block.Number),
        [&](std::size_t bit)
        {
          open[count++] = { block.Level - 1,
            MeshLattice::SizeOfBlock * block.Number + static_cast<std::int64_t>(bit) };
        });
    }
  }

  /// The box around a block of cells of the lattice. A part of a leaf has the leaf's box; a block
  /// without cells is a point.
  IndexBox BoxOf(const CellBox& cells) const { return this->Boxes->BoxOf(cells); }

  /// Read the range of a leaf's values from the mesh. Cells with a NaN value are ignored. A leaf
  /// without other cells has Min > Max.
  /// \param finite result: the range of the finite values; may be null
  CellRange RangeOfLeaf(std::int64_t leaf, CellRange* finite = nullptr) const;

  /// One bit for each cell of a leaf that an isovalue of the bands passes. After RangeOfLeaf of the
  /// leaf, this reads no value, and also sets cells that an isovalue nearly passes.
  std::uint64_t CellsIn(std::int64_t leaf, const std::vector<ValueBand>& bands) const;

  std::size_t MemoryInBytes() const;

private:
  explicit MeshTree(std::shared_ptr<const Mesh> mesh)
    : Source(std::move(mesh))
    , Cells(*this->Source)
  {
  }

  std::shared_ptr<const Mesh> Source;
  MeshReader Cells;
  std::shared_ptr<const CellNumbers> Order; ///< numbers of cells by rank
  std::shared_ptr<const MeshBoxes> Boxes;
  std::unique_ptr<MeshRanges> Ranges; ///< of leaves that RangeOfLeaf has read
};

}

#endif
