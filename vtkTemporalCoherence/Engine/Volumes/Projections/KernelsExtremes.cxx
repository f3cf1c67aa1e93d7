// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Volumes/Projections/KernelsExtremes.h"

#include "Lattice/KernelsBeam.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#ifndef TemporalCoherence_BlockQueue // this file is included once for each kind of vectors
#define TemporalCoherence_BlockQueue
namespace TemporalCoherence
{

/// A priority queue of blocks. A search ends early, so blocks are sorted only as far as it gets.
class BlockQueue
{
public:
  explicit BlockQueue(std::size_t usual) { this->Blocks.reserve(usual); }

  void Add(const ExtremeBlock& block) { this->Blocks.push_back(block); }

  /// Call search(block) for blocks in order until it returns false, then clear the queue.
  template <typename Search>
  void Empty(const Search& search)
  {
    const Buckets ends = this->Distribute();
    std::size_t begin = 0;
    for (const std::size_t end : ends)
    {
      const auto first = this->Ordered.begin() + static_cast<std::ptrdiff_t>(begin);
      const auto last = this->Ordered.begin() + static_cast<std::ptrdiff_t>(end);
      std::sort(first, last);
      if (!std::all_of(first, last, search))
      {
        break;
      }
      begin = end;
    }
    this->Blocks.clear();
  }

private:
  using Buckets = std::array<std::size_t, 64>;

  /// Put blocks into buckets by their bounds, the largest ones first.
  /// \return where each bucket ends
  Buckets Distribute()
  {
    this->Ordered.resize(this->Blocks.size());
    const auto ends = std::minmax_element(this->Blocks.begin(), this->Blocks.end(),
      [](const ExtremeBlock& a, const ExtremeBlock& b) { return a.Bound < b.Bound; });
    const float most = this->Blocks.empty() ? 0.0f : ends.second->Bound;
    const float range = this->Blocks.empty() ? 0.0f : most - ends.first->Bound;
    constexpr float last = static_cast<float>(std::tuple_size_v<Buckets> - 1);
    // Bounds may be infinite.
    const bool areApart = range > last * 1e-30f && range < 1e30f;
    const float scale = areApart ? last / range : 0.0f;
    const auto bucketOf = [&](const ExtremeBlock& block) {
      return areApart ? static_cast<std::size_t>(std::min((most - block.Bound) * scale, last)) : 0;
    };
    Buckets begins{};
    for (const ExtremeBlock& block : this->Blocks)
    {
      ++begins[bucketOf(block)];
    }
    std::size_t sum = 0;
    for (std::size_t& begin : begins)
    {
      sum += begin;
      begin = sum - begin;
    }
    for (const ExtremeBlock& block : this->Blocks)
    {
      this->Ordered[begins[bucketOf(block)]++] = block;
    }
    return begins;
  }

  std::vector<ExtremeBlock> Blocks, Ordered;
};

}
#endif

// This file is compiled once for each kind of vectors, and what runs is chosen by the machine.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Volumes/Projections/KernelsExtremes.cxx"
#include <hwy/foreach_target.h>

#include "Lattice/KernelsHull-inl.h"
#include "Lattice/KernelsLattice-inl.h"
#include "Volumes/Projections/KernelsCellBounds-inl.h"
#include "Volumes/Projections/KernelsCellStay-inl.h"
#include "Volumes/Projections/KernelsExactSearch-inl.h"
#include "Volumes/Projections/KernelsLargest-inl.h"

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace ExtremeKernels
{
namespace HWY_NAMESPACE
{

/// Searches the blocks that a beam passes, the largest bounds first. It skips blocks and cells that
/// cannot raise the extreme of a ray, or move it nearer.
template <typename Real, class Planes>
class ExtremeBeam
{
public:
  ExtremeBeam(const BeamSearch<Real>& search, const Planes& planes, const RayBatch& rays,
    std::uint64_t which, TileBeam& beam, BeamExtremes<Real>& found)
    : Blocks(search.Blocks)
    , IsNearest(search.Meeting)
    , Between(planes)
    , Lattice(Planes::LatticeFor(beam, planes.Grid))
    , Beam(beam)
    , Found(found)
    , Exactly(planes, search.Meeting, rays, found)
    , Wanted(which)
  {
    this->Reached.fill(search.Least);
    this->At.fill(TileBeam::Never);
    this->NoteReached(which);
    this->Least = this->LeastOf(which);
  }

  void Search()
  {
    BlockQueue nodes(64), leaves(256);
    this->CollectNodes(nodes);
    // Search the most promising node first, as its values rule out many blocks; then search the
    // leaves of the other nodes together.
    bool isFirst = true;
    nodes.Empty(
      [&](const ExtremeBlock& node) HWY_ATTR
      {
        if (!this->IsWorth(node.Bound))
        {
          return false;
        }
        if (this->FindWidened(node.Place * ValueRangePyramid::NodeSize, ValueRangePyramid::NodeSize,
              node.Bound) != 0)
        {
          this->CollectLeaves(node, leaves);
          if (isFirst)
          {
            this->SearchLeaves(leaves);
            isFirst = false;
          }
        }
        return true;
      });
    this->SearchLeaves(leaves);
    this->Decide();
  }

private:
  static constexpr int GroupSize = 4 * ValueRangePyramid::NodeSize;

  static constexpr std::size_t Lanes = hn::MaxLanes(Floats());

  /// Passage of a vector of rays through the present cell.
  struct alignas(64) Passed
  {
    float Enter[Lanes], Leave[Lanes];
    std::uint64_t Which; ///< one bit for each ray that may have its largest value there
    float LeastReached;  ///< smallest Reached of the rays that pass the leaf
  };

  /// A cell in which some rays of a vector may have their largest value.
  struct alignas(64) OpenCell
  {
    float Most[Lanes], Enter[Lanes];
    std::uint64_t Which; ///< one bit for each of these rays
    std::size_t First;   ///< first ray of the vector
    std::size_t Cell;    ///< index in Cells
  };

  /// Update Reached and At of some rays, one bit each, from their exact extremes: values rounded
  /// down, and distances in the beam.
  void NoteReached(std::uint64_t rays)
  {
    for (; rays != 0; rays &= rays - 1)
    {
      const std::size_t ray = hwy::Num0BitsBelowLS1Bit_Nonzero64(rays);
      const float value = RoundedDown(this->Found.Value[ray]);
      const double first = this->Found.First[ray];
      if (value >= this->Reached[ray] && std::isfinite(first))
      {
        const float at = this->Beam.DistanceOf(first) + this->Beam.Margin;
        this->At[ray] = value > this->Reached[ray] ? at : std::min(at, this->At[ray]);
        this->Reached[ray] = value;
      }
    }
  }

  /// The smallest Reached of some rays, one bit each.
  float LeastOf(std::uint64_t rays) const
  {
    V least = this->LeastIn(rays, 0);
    for (std::size_t i = Lanes; i < RayBatch::Capacity; i += Lanes)
    {
      least = hn::Min(least, this->LeastIn(rays, i));
    }
    return hn::GetLane(hn::MinOfLanes(Floats(), least));
  }

  /// Reached in the lanes selected by `rays`; infinity in the others.
  HWY_INLINE V LeastIn(std::uint64_t rays, std::size_t i) const
  {
    const V infinity = Set(std::numeric_limits<float>::infinity());
    return hn::IfThenElse(beams::MaskOf(rays >> i), Load(&this->Reached[i]), infinity);
  }

  /// True if a block has values, and one of them may reach the smallest extreme of the rays.
  bool IsWorth(float bound) const
  {
    return bound >= this->Least && bound > -std::numeric_limits<float>::infinity();
  }

  /// Call visit(place) for the children of a block that the beam passes.
  template <typename Visit>
  HWY_INLINE void ForEachChild(const glm::ivec3& first, int size, const Visit& visit) const
  {
    for (std::uint64_t left = this->Lattice.Cull(first, size); left != 0; left &= left - 1)
    {
      const int child = static_cast<int>(hwy::Num0BitsBelowLS1Bit_Nonzero64(left));
      visit(glm::ivec3(child & 3, child >> 2 & 3, child >> 4), child);
    }
  }

  void CollectNodes(BlockQueue& nodes)
  {
    const auto& groups = this->Blocks.Groups();
    const glm::ivec3 tops = (groups.Dimensions + 3) / 4;
    for (int top = 0; top < tops.x * tops.y * tops.z; ++top)
    {
      const glm::ivec3 place(top % tops.x, top / tops.x % tops.y, top / (tops.x * tops.y));
      this->ForEachChild(4 * GroupSize * place, GroupSize,
        [&](const glm::ivec3& child, int) HWY_ATTR
        {
          const glm::ivec3 group = 4 * place + child;
          if (glm::all(glm::lessThan(group, groups.Dimensions)) &&
            this->IsWorth(groups.BoundOf(group)))
          {
            this->CollectIn(group, nodes);
          }
        });
    }
  }

  void CollectIn(const glm::ivec3& group, BlockQueue& nodes)
  {
    const auto& all = this->Blocks.Nodes();
    this->ForEachChild(GroupSize * group, ValueRangePyramid::NodeSize,
      [&](const glm::ivec3& child, int) HWY_ATTR
      {
        const glm::ivec3 node = 4 * group + child;
        if (glm::all(glm::lessThan(node, all.Dimensions)) && this->IsWorth(all.BoundOf(node)))
        {
          nodes.Add(
            { node, all.BoundOf(node), DepthOf(this->Beam, node, ValueRangePyramid::NodeSize) });
        }
      });
  }

  /// The rays of a vector that may have their largest value in a box.
  HWY_INLINE M MayWiden(const Interval& passage, V bound, std::size_t i) const
  {
    const V behind = Load(&this->Beam.Behind[i]), begin = Load(&this->Beam.WalkBegin[i]);
    const M passes =
      hn::And(hn::Le(passage.Enter, hn::Min(passage.Leave, behind)), hn::Ge(passage.Leave, begin));
    return hn::And(passes, this->IsOpen(passage.Enter, bound, i));
  }

  /// The rays of a vector whose extreme is smaller than a bound, or equal but farther away.
  HWY_INLINE M IsOpen(V enter, V bound, std::size_t i) const
  {
    const V reached = Load(&this->Reached[i]);
    const M isAsMuch = hn::And(hn::Eq(reached, bound), hn::Le(enter, Load(&this->At[i])));
    return hn::Or(hn::Lt(reached, bound), isAsMuch);
  }

  /// The wanted rays, one bit each, that may find a new extreme in a block on their walk.
  HWY_INLINE std::uint64_t FindWidened(const glm::ivec3& first, int size, float bound) const
  {
    const beams::CellFaces faces(
      BoxOf(this->Between, this->Beam, this->Blocks.Cells(), first, size), this->Beam.Margin,
      this->Beam.Flip);
    std::uint64_t widened = 0;
    for (std::size_t i = 0; i < RayBatch::Capacity; i += hn::Lanes(Floats()))
    {
      const Interval passage = beams::FindInterval(faces, this->Beam.Origin, this->Beam.Inverse, i);
      widened |= BitsOf(this->MayWiden(passage, Set(bound), i)) << i;
    }
    return widened & this->Wanted;
  }

  void CollectLeaves(const ExtremeBlock& node, BlockQueue& leaves)
  {
    const auto& dimensions = this->Blocks.Nodes().Dimensions;
    this->Blocks.BoundLeaves(node.Place.x +
        static_cast<std::int64_t>(dimensions.x) *
          (node.Place.y + static_cast<std::int64_t>(dimensions.y) * node.Place.z),
      this->Bounds);
    std::uint64_t children = FindAtLeast(this->Bounds, this->Least);
    children &=
      this->Lattice.Cull(ValueRangePyramid::NodeSize * node.Place, ValueRangePyramid::LeafSize);
    for (; children != 0; children &= children - 1)
    {
      const int number = static_cast<int>(hwy::Num0BitsBelowLS1Bit_Nonzero64(children));
      const glm::ivec3 leaf = 4 * node.Place + glm::ivec3(number & 3, number >> 2 & 3, number >> 4);
      leaves.Add({ leaf, this->Bounds[static_cast<std::size_t>(number)],
        DepthOf(this->Beam, leaf, ValueRangePyramid::LeafSize) });
    }
  }

  /// Search leaves, and clear their queue.
  void SearchLeaves(BlockQueue& leaves)
  {
    leaves.Empty(
      [&](const ExtremeBlock& leaf) HWY_ATTR
      {
        if (!this->IsWorth(leaf.Bound))
        {
          return false;
        }
        const glm::ivec3 first = ValueRangePyramid::LeafSize * leaf.Place;
        const std::uint64_t rays =
          this->FindWidened(first, ValueRangePyramid::LeafSize, leaf.Bound);
        if (rays != 0)
        {
          this->SearchLeaf(first, rays);
        }
        return true;
      });
  }

  void SearchLeaf(const glm::ivec3& first, std::uint64_t rays)
  {
    this->Blocks.Read(first, this->Leaf);
    FindEnds(this->Leaf, this->Ends, this->Bounds);
    float least = std::numeric_limits<float>::infinity();
    for (std::size_t i = 0; i < RayBatch::Capacity; i += Lanes)
    {
      Passed& passed = this->OfCell[i / Lanes];
      passed.LeastReached = hn::GetLane(hn::MinOfLanes(Floats(), this->LeastIn(rays, i)));
      least = std::min(least, passed.LeastReached);
    }
    std::uint64_t cells = this->Leaf.Cells & FindAtLeast(this->Bounds, least);
    cells &= cells != 0 ? this->Lattice.Cull(first, 1) : 0;
    for (; cells != 0; cells &= cells - 1)
    {
      const int number = static_cast<int>(hwy::Num0BitsBelowLS1Bit_Nonzero64(cells));
      const glm::ivec3 place = first + glm::ivec3(number & 3, number >> 2 & 3, number >> 4);
      const auto box = this->Lattice.CellAt(place);
      if (this->FindPassed(box, this->Bounds[static_cast<std::size_t>(number)], rays))
      {
        this->SearchCell(place, box, number);
      }
    }
    this->Least = this->LeastOf(this->Wanted);
  }

  /// Find the rays that may have their largest value in a cell, by its bound.
  /// \param rays candidates, one bit each
  /// \return false if no candidate is left
  template <class Box>
  HWY_INLINE bool FindPassed(const Box& box, float bound, std::uint64_t rays)
  {
    const beams::CellFaces faces(box, this->Beam.Margin, this->Beam.Flip);
    std::uint64_t any = 0;
    for (std::size_t i = 0; i < RayBatch::Capacity; i += Lanes)
    {
      Passed& passed = this->OfCell[i / Lanes];
      passed.Which = 0;
      if (bound >= passed.LeastReached)
      {
        const Interval passage =
          beams::FindInterval(faces, this->Beam.Origin, this->Beam.Inverse, i);
        passed.Which = BitsOf(this->MayWiden(passage, Set(bound), i)) & rays >> i;
        hn::StoreU(passage.Enter, Floats(), passed.Enter);
        hn::StoreU(passage.Leave, Floats(), passed.Leave);
        any |= passed.Which;
      }
    }
    return any != 0;
  }

  /// Search a cell of the leaf for the rays that pass it.
  template <class Box>
  HWY_INLINE void SearchCell(const glm::ivec3& place, const Box& box, int number)
  {
    const auto at = static_cast<std::size_t>(number);
    ExtremeCell<Real>& cell = this->Cells[this->NumberOfCells];
    cell.Place = place;
    cell.Samples = this->Leaf.CornersOf(number);
    cell.Smallest = this->Ends.Smallest[at];
    cell.Largest = this->Ends.Largest[at];
    const BoundedCell<Real, Box> bounded(cell, this->Bounds[at], box, this->Beam);
    bool isOpen = false;
    for (std::size_t i = 0; i < RayBatch::Capacity; i += Lanes)
    {
      const Passed& passed = this->OfCell[i / Lanes];
      this->Found.CellsRead += static_cast<std::int64_t>(hwy::PopCount(passed.Which));
      if (passed.Which != 0 && this->IsNearest)
      {
        this->NoteReached(this->Exactly.Search(cell, i, passed.Which));
      }
      else if (passed.Which != 0)
      {
        const Interval passage{ Load(passed.Enter), Load(passed.Leave) };
        const MetValues met = bounded.Meet(passage, Load(&this->Reached[i]), i);
        const std::uint64_t open = passed.Which & BitsOf(this->IsOpen(passage.Enter, met.Most, i));
        if (open != 0)
        {
          this->NoteLeast(passage, met.Least, beams::MaskOf(open), i);
          this->Append(passage, met.Most, open, i);
          isOpen = true;
        }
      }
    }
    this->NumberOfCells += isOpen ? 1 : 0;
    if (this->NumberOfCells == MostCells)
    {
      this->Decide();
    }
  }

  /// Take lower bounds of the largest values on a passage into account.
  HWY_INLINE void NoteLeast(const Interval& passage, V least, M which, std::size_t i)
  {
    const V reached = Load(&this->Reached[i]), at = Load(&this->At[i]);
    const M isMore = hn::And(which, hn::Gt(least, reached));
    const M isNearer = hn::And(which, hn::And(hn::Eq(least, reached), hn::Lt(passage.Leave, at)));
    hn::StoreU(hn::IfThenElse(isMore, least, reached), Floats(), &this->Reached[i]);
    hn::StoreU(hn::IfThenElse(hn::Or(isMore, isNearer), passage.Leave, at), Floats(), &this->At[i]);
  }

  HWY_INLINE void Append(const Interval& passage, V most, std::uint64_t which, std::size_t i)
  {
    OpenCell& open = this->Open[this->NumberOpen++];
    hn::StoreU(most, Floats(), open.Most);
    hn::StoreU(passage.Enter, Floats(), open.Enter);
    open.Which = which;
    open.First = i;
    open.Cell = this->NumberOfCells;
  }

  /// Search open cells in full precision, and clear the list.
  void Decide()
  {
    for (std::size_t number = 0; number < this->NumberOpen; ++number)
    {
      const OpenCell& open = this->Open[number];
      const M isOpen = this->IsOpen(Load(open.Enter), Load(open.Most), open.First);
      const std::uint64_t which = open.Which & BitsOf(isOpen);
      if (which != 0)
      {
        this->NoteReached(this->Exactly.Search(this->Cells[open.Cell], open.First, which));
      }
    }
    this->NumberOpen = this->NumberOfCells = 0;
  }

  /// Capacity for open cells, and for vectors of rays in them.
  static constexpr std::size_t MostCells = 64;
  static constexpr std::size_t MostOpen = MostCells * RayBatch::Capacity / Lanes;

  const ExtremeBlocks<Real>& Blocks;
  bool IsNearest; ///< nearest interpolation: cells are searched in full precision at once
  Planes Between;
  typename Planes::Lattice Lattice;
  const TileBeam& Beam;
  BeamExtremes<Real>& Found;
  ExactSearch<Real, Planes> Exactly;
  std::uint64_t Wanted;                                  ///< one bit for each ray
  float Least = -std::numeric_limits<float>::infinity(); ///< smallest Reached of the wanted rays
  /// Lower bounds of the extremes that count, and the distances at which rays reach them, at most.
  alignas(64) std::array<float, 64> Reached, At;
  alignas(64)
    typename ExtremeBlocks<Real>::Children Bounds; ///< of a node's leaves, or a leaf's cells
  ExtremeLeaf<Real> Leaf;
  CellEnds<Real> Ends; ///< of the cells of the leaf
  Passed OfCell[RayBatch::Capacity / Lanes];
  std::size_t NumberOfCells = 0, NumberOpen = 0;
  ExtremeCell<Real> Cells[MostCells]; ///< open cells, and the present one
  OpenCell Open[MostOpen];
};

template <typename Real>
void FindAll(const BeamSearch<Real>& search, const RayBatch& rays, std::uint64_t which,
  TileBeam& beam, BeamExtremes<Real>& found)
{
  if (search.Grid)
  {
    const RectilinearPlanes planes{ search.Grid };
    ExtremeBeam<Real, RectilinearPlanes>(search, planes, rays, which, beam, found).Search();
  }
  else
  {
    const UniformPlanes planes{ nullptr };
    ExtremeBeam<Real, UniformPlanes>(search, planes, rays, which, beam, found).Search();
  }
}

void FindFloat(const BeamSearch<float>& search, const RayBatch& rays, std::uint64_t which,
  TileBeam& beam, BeamExtremes<float>& found)
{
  FindAll(search, rays, which, beam, found);
}

void FindDouble(const BeamSearch<double>& search, const RayBatch& rays, std::uint64_t which,
  TileBeam& beam, BeamExtremes<double>& found)
{
  FindAll(search, rays, which, beam, found);
}

}
}
}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace TemporalCoherence
{
namespace ExtremeKernels
{
HWY_EXPORT(FindFloat);
HWY_EXPORT(FindDouble);
}

bool FindExtremes(const BeamSearch<float>& search, const RayBatch& rays, std::uint64_t which,
  BeamExtremes<float>& found)
{
  using namespace ExtremeKernels;
  TileBeam beam;
  if (!SetUpBeam(rays, which, search.Blocks.Cells(), beam) || !beam.AreAlike)
  {
    return false;
  }
  HWY_DYNAMIC_DISPATCH(FindFloat)(search, rays, which, beam, found);
  return true;
}

bool FindExtremes(const BeamSearch<double>& search, const RayBatch& rays, std::uint64_t which,
  BeamExtremes<double>& found)
{
  using namespace ExtremeKernels;
  TileBeam beam;
  if (!SetUpBeam(rays, which, search.Blocks.Cells(), beam) || !beam.AreAlike)
  {
    return false;
  }
  HWY_DYNAMIC_DISPATCH(FindDouble)(search, rays, which, beam, found);
  return true;
}

}
#endif
