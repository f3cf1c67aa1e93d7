// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Traversal of the tree of active cells by a beam. Included by kernels once for each kind of
// vectors, hence the toggling guard.
#if defined(TemporalCoherence_KernelsBeamTree_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef TemporalCoherence_KernelsBeamTree_inl_h
#undef TemporalCoherence_KernelsBeamTree_inl_h
#else
#define TemporalCoherence_KernelsBeamTree_inl_h
#endif

#include "Lattice/TileBeam.h"

#include "Lattice/KernelsLattice-inl.h"

#include <atomic>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace BeamKernels
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

/// The bits of a block's children in the order in which a beam meets them: bit i becomes i ^ flip.
HWY_INLINE std::uint64_t InOrder(std::uint64_t word, int flip)
{
  if (flip & 3)
  {
    word = (word & 0x5555555555555555u) << 1 | (word >> 1 & 0x5555555555555555u);
    word = (word & 0x3333333333333333u) << 2 | (word >> 2 & 0x3333333333333333u);
  }
  if (flip & 12)
  {
    word = (word & 0x0f0f0f0f0f0f0f0fu) << 4 | (word >> 4 & 0x0f0f0f0f0f0f0f0fu);
    word = (word & 0x00ff00ff00ff00ffu) << 8 | (word >> 8 & 0x00ff00ff00ff00ffu);
  }
  if (flip & 48)
  {
    word = (word & 0x0000ffff0000ffffu) << 16 | (word >> 16 & 0x0000ffff0000ffffu);
    word = word << 32 | word >> 32;
  }
  return word;
}

/// Takes a beam from leaf to leaf, from front to back.
/// \tparam LeafSearch has TestCells(leaf, cells), called with a leaf's first cell and one bit, in
///                    the order of InOrder, for each active cell that the beam may pass
/// \tparam Lattice    tells where blocks lie (KernelsLattice-inl.h)
template <class LeafSearch, class Lattice>
class BeamTree
{
public:
  BeamTree(const ActiveCells& active, const LeafSource& leaves, const Lattice& blocks,
    const TileBeam& beam, LeafSearch& search)
    : Active(active)
    , Leaves(leaves)
    , Blocks(blocks)
    , Beam(beam)
    , Search(search)
  {
  }

  void Visit() { this->VisitLevel(this->Active.LevelsAbove().size() - 1, glm::ivec3(0)); }

private:
  /// Call visit(place) from front to back for each set child that the beam may pass. `place` is the
  /// child's position in the block.
  template <typename Visitor>
  HWY_INLINE void VisitChildren(
    std::uint64_t word, const glm::ivec3& first, int size, const Visitor& visit)
  {
    word = InOrder(word & this->Blocks.Cull(first, size), this->Beam.Flip);
    VisitInOrder(this->Blocks, this->Beam, word, first, size, visit);
  }

  void VisitLevel(std::size_t level, const glm::ivec3& block)
  {
    const int bits = ActiveCells::NodeBits + 2 * static_cast<int>(level);
    this->VisitChildren(this->Active.LevelsAbove()[level].WordOf(block), block << (bits + 2),
      1 << bits,
      [&](const glm::ivec3& child) HWY_ATTR
      {
        if (level > 0)
        {
          this->VisitLevel(level - 1, 4 * block + child);
        }
        else
        {
          this->VisitNode(4 * block + child);
        }
      });
  }

  void VisitNode(const glm::ivec3& place)
  {
    const glm::ivec3 first = ActiveCells::NodeSize * place;
    const std::int64_t node = this->Active.NodeOf(first);
    const std::uint64_t* const words = this->Active.Nodes() + 2 * node;
    this->VisitChildren(words[0], first, ActiveCells::LeafSize,
      [&](const glm::ivec3& child) HWY_ATTR
      {
        const glm::ivec3 leaf = first + ActiveCells::LeafSize * child;
        std::uint64_t cells =
          this->Active.Cells()[words[1] + static_cast<std::size_t>(ActiveCells::LeafOf(leaf))].load(
            std::memory_order_relaxed);
        if (cells == 0)
        {
          cells = this->Leaves.CellsOf(node, leaf);
        }
        this->Search.TestCells(leaf, InOrder(cells & this->Blocks.Cull(leaf, 1), this->Beam.Flip));
      });
  }

  const ActiveCells& Active;
  const LeafSource& Leaves;
  const Lattice& Blocks;
  const TileBeam& Beam;
  LeafSearch& Search;
};

}
}
}
HWY_AFTER_NAMESPACE();

#endif
