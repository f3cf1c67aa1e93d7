// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Fields/KernelsBeam.h"

#include <algorithm>
#include <array>
#include <atomic>

// This file is compiled once for each kind of vectors, and what runs is chosen by the machine.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Fields/KernelsBeam.cxx"
#include <hwy/foreach_target.h>

#include "Fields/KernelsBeam-inl.h"

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace BeamKernels
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;
/// The bits of a block's children in the order in which a beam meets them: bit i becomes i ^ flip.
HWY_INLINE std::uint64_t FlipBits(std::uint64_t word, int flip)
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

/// Goes through the tree of active cells with a beam.
/// \tparam IsPlain that of the beam
template <bool IsPlain>
class BeamSearch
{
public:
  BeamSearch(const BeamTask& task, BeamScene& scene, TileBeam& beam)
    : Task(task)
    , Scene(scene)
    , Beam(beam)
    , Cells(task, scene, beam)
  {
  }

  void Search()
  {
    const std::vector<ActiveCells::Level>& levels = this->Task.Active.LevelsAbove();
    this->VisitLevel(levels.size() - 1, glm::ivec3(0));
    this->Cells.Decide();
  }

private:
  /// The children of a block that the beam may meet something in.
  /// \param first cell of the block, and cells along an edge of a child
  HWY_INLINE std::uint64_t CullChildren(const glm::ivec3& first, int size) const
  {
    const hn::CappedTag<float, 8> d;
    const TileBeam::Hull& hull = this->Beam.Around;
    const glm::vec3 corner(first - this->Beam.Anchor);
    const auto perSize = hn::Set(d, 1.0f / static_cast<float>(size));
    TileBeam::OfPlanes least;
    for (std::size_t i = 0; i < least.size(); i += hn::Lanes(d))
    {
      auto left = hn::LoadU(d, &hull.Offset[i]);
      for (std::size_t a = 0; a < 3; ++a)
      {
        const auto at = hn::Set(d, corner[static_cast<int>(a)]);
        left = hn::Sub(left, hn::Mul(hn::LoadU(d, &hull.Normal[a][i]), at));
      }
      const auto reach = hn::LoadU(d, &hull.Reach[i]);
      hn::StoreU(hn::Sub(hn::Mul(left, perSize), reach), d, &least[i]);
    }
    std::uint64_t kept = 0;
    for (std::size_t i = 0; i < 64; i += hn::Lanes(Floats()))
    {
      M isKept = hn::Ge(Load(&hull.Children[0][i]), Set(least[0]));
      for (std::size_t plane = 1; plane < TileBeam::Planes; ++plane)
      {
        isKept = hn::And(isKept, hn::Ge(Load(&hull.Children[plane][i]), Set(least[plane])));
      }
      kept |= BitsOf(isKept) << i;
    }
    return kept;
  }

  /// Call visit(place) for each child of a block whose bit is set, as it lies in the block, from
  /// front to back.
  template <typename Visit>
  HWY_INLINE void VisitChildren(
    std::uint64_t word, const glm::ivec3& first, int size, const Visit& visit)
  {
    const TileBeam& beam = this->Beam;
    word &= this->CullChildren(first, size);
    word = FlipBits(word, beam.Flip);
    const TileBeam::Hull& hull = beam.Around;
    constexpr std::size_t across = TileBeam::Across;
    const glm::vec3 normal(-beam.Forward);
    const float edge = static_cast<float>(size);
    const float atFirst =
      glm::dot(normal, glm::vec3(first - beam.Anchor)) + edge * hull.Reach[across];
    while (word != 0)
    {
      const auto child = static_cast<int>(hwy::Num0BitsBelowLS1Bit_Nonzero64(word)) ^ beam.Flip;
      word &= word - 1;
      // What has been found since may hide it.
      const float at = atFirst + edge * hull.Children[across][static_cast<std::size_t>(child)];
      if (at >= hull.Offset[across])
      {
        visit(glm::ivec3(child & 3, child >> 2 & 3, child >> 4));
      }
    }
  }

  void VisitLevel(std::size_t level, const glm::ivec3& block)
  {
    const std::vector<ActiveCells::Level>& levels = this->Task.Active.LevelsAbove();
    const int bits = ActiveCells::NodeBits + 2 * static_cast<int>(level);
    this->VisitChildren(levels[level].WordOf(block), block << (bits + 2), 1 << bits,
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
    const ActiveCells& active = this->Task.Active;
    const glm::ivec3 first = ActiveCells::NodeSize * place;
    const std::int64_t node = active.NodeOf(first);
    const std::uint64_t* const words = active.Nodes() + 2 * node;
    this->VisitChildren(words[0], first, ActiveCells::LeafSize,
      [&](const glm::ivec3& child) HWY_ATTR
      {
        const glm::ivec3 leaf = first + ActiveCells::LeafSize * child;
        std::uint64_t cells =
          active.Cells()[words[1] + static_cast<std::size_t>(ActiveCells::LeafOf(leaf))].load(
            std::memory_order_relaxed);
        if (cells == 0)
        {
          cells = this->Scene.CellsOf(node, leaf);
        }
        this->VisitChildren(cells, leaf, 1,
          [&](const glm::ivec3& cell) HWY_ATTR { this->Cells.TestCell(leaf + cell); });
      });
  }

  const BeamTask& Task;
  BeamScene& Scene;
  TileBeam& Beam;
  CellSearch<IsPlain> Cells;
};

void Search(const BeamTask& task, BeamScene& scene, TileBeam& beam)
{
  if (beam.IsPlain)
  {
    BeamSearch<true>(task, scene, beam).Search();
    return;
  }
  BeamSearch<false>(task, scene, beam).Search();
}

}
}
}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace TemporalCoherence
{
namespace BeamKernels
{
HWY_EXPORT(Search);
}

void SearchBeam(const BeamTask& task, BeamScene& scene, TileBeam& beam)
{
  using namespace BeamKernels;
  HWY_DYNAMIC_DISPATCH(Search)(task, scene, beam);
}

}
#endif
