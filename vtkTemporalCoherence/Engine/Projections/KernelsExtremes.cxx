// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Projections/KernelsExtremes.h"

#include "Beams/KernelsBeam.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

// This file is compiled once for each kind of vectors, and what runs is chosen by the machine.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Projections/KernelsExtremes.cxx"
#include <hwy/foreach_target.h>

#include "Beams/KernelsHull-inl.h"
#include "Beams/KernelsLattice-inl.h"
#include "Projections/KernelsCellStay-inl.h"
#include "Projections/KernelsLargest-inl.h"

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace ExtremeKernels
{
namespace HWY_NAMESPACE
{

/// Searches the blocks that a beam passes, the most promising ones first. What cannot be more than
/// rays have met, nor as much and nearer, is left out.
template <typename Real, class Planes>
class ExtremeBeam
{
public:
  ExtremeBeam(const ExtremeBlocks<Real>& blocks, const Planes& planes,
    const CellMeeting<Real>* meeting, const RayBatch& rays, std::uint64_t which, TileBeam& beam,
    BeamExtremes<Real>& found)
    : Blocks(blocks)
    , Meeting(meeting)
    , Between(planes)
    , Lattice(Planes::LatticeFor(beam, planes.Grid))
    , Rays(rays)
    , Beam(beam)
    , Found(found)
    , Wanted(which)
  {
    for (std::size_t i = 0; i < RayBatch::Capacity; ++i)
    {
      this->NoteReached(i);
    }
    this->Least = this->LeastOf(which);
  }

  void Search()
  {
    std::vector<ExtremeBlock> nodes;
    nodes.reserve(64);
    this->CollectNodes(nodes);
    std::sort(nodes.begin(), nodes.end());
    // The most promising node alone, so that it rules out many, and then all leaves of the others.
    std::vector<ExtremeBlock> leaves;
    leaves.reserve(256);
    bool isFirst = true;
    for (const ExtremeBlock& node : nodes)
    {
      if (!this->IsWorth(node.Bound))
      {
        break;
      }
      if (this->FindWidened(
            node.Place * ValueRangePyramid::NodeSize, ValueRangePyramid::NodeSize, node.Bound) != 0)
      {
        this->CollectLeaves(node, leaves);
        if (isFirst)
        {
          this->SearchLeaves(leaves);
          isFirst = false;
        }
      }
    }
    this->SearchLeaves(leaves);
  }

private:
  static constexpr int GroupSize = 4 * ValueRangePyramid::NodeSize;

  /// What a ray has met, for blocks: rounded down, and its distance in the beam.
  void NoteReached(std::size_t ray)
  {
    this->Reached[ray] = RoundedDown(this->Found.Value[ray]);
    const double first = this->Found.First[ray];
    this->At[ray] =
      std::isfinite(first) ? this->Beam.DistanceOf(first) + this->Beam.Margin : TileBeam::Never;
  }

  /// The least that one of some rays, one bit each, has met.
  float LeastOf(std::uint64_t rays) const
  {
    const V infinity = Set(std::numeric_limits<float>::infinity());
    V least = infinity;
    for (std::size_t i = 0; i < RayBatch::Capacity; i += hn::Lanes(Floats()))
    {
      const M isRay = beams::MaskOf(rays >> i);
      least = hn::Min(least, hn::IfThenElse(isRay, Load(&this->Reached[i]), infinity));
    }
    return hn::GetLane(hn::MinOfLanes(Floats(), least));
  }

  /// False if no ray can meet more in a block, or if there is nothing in it.
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

  void CollectNodes(std::vector<ExtremeBlock>& nodes)
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

  void CollectIn(const glm::ivec3& group, std::vector<ExtremeBlock>& nodes)
  {
    const auto& all = this->Blocks.Nodes();
    this->ForEachChild(GroupSize * group, ValueRangePyramid::NodeSize,
      [&](const glm::ivec3& child, int) HWY_ATTR
      {
        const glm::ivec3 node = 4 * group + child;
        if (glm::all(glm::lessThan(node, all.Dimensions)) && this->IsWorth(all.BoundOf(node)))
        {
          nodes.push_back(
            { node, all.BoundOf(node), DepthOf(this->Beam, node, ValueRangePyramid::NodeSize) });
        }
      });
  }

  /// Where a vector of rays passes a box, and those that may meet more in it.
  struct Passage
  {
    V Enter, Leave;
    M Widens;
  };

  HWY_INLINE Passage Pass(const beams::CellFaces& faces, float bound, std::size_t i) const
  {
    const TileBeam& beam = this->Beam;
    Passage passed{ Set(-TileBeam::Never), Set(TileBeam::Never), {} };
    for (std::size_t a = 0; a < 3; ++a)
    {
      const V origin = Load(&beam.Origin[a][i]), inverse = Load(&beam.Inverse[a][i]);
      passed.Enter = hn::Max(passed.Enter, hn::Mul(hn::Sub(Set(faces.Near[a]), origin), inverse));
      passed.Leave = hn::Min(passed.Leave, hn::Mul(hn::Sub(Set(faces.Far[a]), origin), inverse));
    }
    const V behind = Load(&beam.Behind[i]), begin = Load(&beam.WalkBegin[i]);
    const M passes =
      hn::And(hn::Le(passed.Enter, hn::Min(passed.Leave, behind)), hn::Ge(passed.Leave, begin));
    const V reached = Load(&this->Reached[i]), all = Set(bound);
    const M isAsMuch = hn::And(hn::Eq(reached, all), hn::Le(passed.Enter, Load(&this->At[i])));
    passed.Widens = hn::And(passes, hn::Or(hn::Lt(reached, all), isAsMuch));
    return passed;
  }

  /// The wanted rays, one bit each, that may pass a block on their walk and meet more in it.
  HWY_INLINE std::uint64_t FindWidened(const glm::ivec3& first, int size, float bound) const
  {
    const beams::CellFaces faces(
      BoxOf(this->Between, this->Beam, this->Blocks.Cells(), first, size), this->Beam.Margin,
      this->Beam.Flip);
    std::uint64_t widened = 0;
    for (std::size_t i = 0; i < RayBatch::Capacity; i += hn::Lanes(Floats()))
    {
      widened |= BitsOf(this->Pass(faces, bound, i).Widens) << i;
    }
    return widened & this->Wanted;
  }

  /// Those of some rays that may pass a cell and meet more in it, by the cubic along them in single
  /// precision.
  HWY_INLINE std::uint64_t FindWidened(const ExtremeCell<Real>& cell, std::uint64_t which) const
  {
    const TileBeam& beam = this->Beam;
    const auto box = this->Lattice.CellAt(cell.Place);
    const beams::CellFaces faces(box, beam.Margin, beam.Flip);
    CellValues values;
    for (std::size_t row = 0; row < 4; ++row)
    {
      values.Set(row, static_cast<float>(cell.Samples[2 * row]),
        static_cast<float>(cell.Samples[2 * row + 1]));
    }
    const float margin = beam.Margin * box.LargestShare();
    // As for isosurfaces (CellSearch::ErrorIn). In a cell that is too thin nothing is told.
    const float error = margin < 0x1p-5f ? values.Largest * (16.0f * margin + 0x1p-13f) + 1e-30f
                                         : std::numeric_limits<float>::infinity();
    std::uint64_t widened = 0;
    constexpr std::uint64_t vector = (std::uint64_t(1) << hn::MaxLanes(Floats())) - 1;
    for (std::size_t i = 0; i < RayBatch::Capacity; i += hn::Lanes(Floats()))
    {
      if ((which >> i & vector) == 0)
      {
        continue;
      }
      const Passage passed = this->Pass(faces, cell.Bound, i);
      if (this->Meeting)
      {
        widened |= BitsOf(passed.Widens) << i;
      }
      else if (!hn::AllFalse(Floats(), passed.Widens))
      {
        V at[3], step[3];
        beams::FindPathsIn(box, beam, hn::Max(passed.Enter, Load(&beam.Begin[i])),
          hn::Min(passed.Leave, Load(&beam.End[i])), i, at, step);
        const V most = beams::CubicsAlong(values, at, step).Largest;
        const M isLess = hn::Lt(hn::Add(most, Set(error)), Load(&this->Reached[i]));
        widened |= BitsOf(hn::AndNot(isLess, passed.Widens)) << i;
      }
    }
    return widened & which;
  }

  void CollectLeaves(const ExtremeBlock& node, std::vector<ExtremeBlock>& leaves)
  {
    const auto& dimensions = this->Blocks.Nodes().Dimensions;
    this->Blocks.BoundLeaves(node.Place.x +
        static_cast<std::int64_t>(dimensions.x) *
          (node.Place.y + static_cast<std::int64_t>(dimensions.y) * node.Place.z),
      this->Bounds);
    this->ForEachChild(ValueRangePyramid::NodeSize * node.Place, ValueRangePyramid::LeafSize,
      [&](const glm::ivec3& child, int number) HWY_ATTR
      {
        const float bound = this->Bounds[static_cast<std::size_t>(number)];
        if (this->IsWorth(bound))
        {
          const glm::ivec3 leaf = 4 * node.Place + child;
          leaves.push_back({ leaf, bound, DepthOf(this->Beam, leaf, ValueRangePyramid::LeafSize) });
        }
      });
  }

  /// Search leaves, and forget them.
  void SearchLeaves(std::vector<ExtremeBlock>& leaves)
  {
    std::sort(leaves.begin(), leaves.end());
    for (const ExtremeBlock& leaf : leaves)
    {
      if (!this->IsWorth(leaf.Bound))
      {
        break;
      }
      const glm::ivec3 first = ValueRangePyramid::LeafSize * leaf.Place;
      const std::uint64_t rays = this->FindWidened(first, ValueRangePyramid::LeafSize, leaf.Bound);
      if (rays != 0)
      {
        this->SearchLeaf(first, rays);
      }
    }
    leaves.clear();
  }

  void SearchLeaf(const glm::ivec3& leaf, std::uint64_t rays)
  {
    const std::size_t count = this->Blocks.Read(leaf, this->Lattice.Cull(leaf, 1), this->Cells);
    const float least = this->LeastOf(rays);
    for (std::size_t i = 0; i < count; ++i)
    {
      const ExtremeCell<Real>& cell = this->Cells[i];
      if (cell.Bound >= least)
      {
        const std::uint64_t widens = this->FindWidened(cell, rays);
        if (widens != 0)
        {
          this->SearchCell(cell, widens);
        }
      }
    }
    this->Least = this->LeastOf(this->Wanted);
  }

  /// Let rays, one bit each, meet a cell one by one.
  void MeetCell(const ExtremeCell<Real>& cell, std::uint64_t rays)
  {
    this->Found.CellsRead += static_cast<std::int64_t>(hwy::PopCount(rays));
    for (; rays != 0; rays &= rays - 1)
    {
      const std::size_t ray = hwy::Num0BitsBelowLS1Bit_Nonzero64(rays);
      Real value;
      double at;
      if (this->Meeting->Meet(this->Rays, ray, cell, value, at))
      {
        this->Keep(ray, value, at);
      }
    }
  }

  void SearchCell(const ExtremeCell<Real>& cell, std::uint64_t rays)
  {
    if (this->Meeting)
    {
      this->MeetCell(cell, rays);
      return;
    }
    constexpr std::size_t lanes = hn::MaxLanes(hn::CappedTag<Real, WidestVector>());
    while (rays != 0)
    {
      const std::size_t i = hwy::Num0BitsBelowLS1Bit_Nonzero64(rays) & ~(lanes - 1);
      const std::uint64_t these = (std::uint64_t(1) << lanes) - 1;
      this->SearchVector(cell, i, rays >> i & these);
      rays &= ~(these << i);
    }
  }

  /// Let a vector of rays, some of which, one bit each, may meet more, meet a cell.
  HWY_INLINE void SearchVector(
    const ExtremeCell<Real>& cell, std::size_t first, std::uint64_t which)
  {
    CellStay<Real> stays;
    which &= FindStay(this->Between, cell.Place, this->Rays, first, stays);
    this->Found.CellsRead += static_cast<std::int64_t>(hwy::PopCount(which));
    if (which == 0)
    {
      return;
    }
    const hn::CappedTag<Real, WidestVector> d;
    using Vector = hn::Vec<decltype(d)>;
    Vector corners[8], begin[3], end[3], b[4];
    for (std::size_t corner = 0; corner < 8; ++corner)
    {
      corners[corner] = hn::Set(d, cell.Samples[corner]);
    }
    for (std::size_t a = 0; a < 3; ++a)
    {
      begin[a] = hn::LoadU(d, stays.Begin[a]);
      end[a] = hn::LoadU(d, stays.End[a]);
    }
    segments::CubicsBetween(d, corners, begin, end, b);
    const Vector reached = hn::LoadU(d, &this->Found.Value[first]);
    const Vector most = hn::Max(hn::Max(b[0], b[1]), hn::Max(b[2], b[3]));
    if (hn::AllFalse(d, hn::Ge(most, reached)) &&
      hn::AllFalse(d, hn::Ge(hn::Set(d, cell.Smallest), reached)))
    {
      return;
    }
    Vector value, share;
    LargestOf(d, b, most, value, share);
    value = hn::Min(hn::Max(value, hn::Set(d, cell.Smallest)), hn::Set(d, cell.Largest));
    which &= BitsIn(d, hn::Ge(value, reached));
    alignas(64) Real values[WidestVector], shares[WidestVector];
    hn::Store(value, d, values);
    hn::Store(share, d, shares);
    this->Keep(first, which, stays, values, shares);
  }

  HWY_INLINE void Keep(std::size_t first, std::uint64_t which, const CellStay<Real>& stays,
    const Real* values, const Real* shares)
  {
    for (; which != 0; which &= which - 1)
    {
      const std::size_t i = hwy::Num0BitsBelowLS1Bit_Nonzero64(which), ray = first + i;
      const double at =
        stays.Enter[i] + static_cast<double>(shares[i]) * (stays.Leave[i] - stays.Enter[i]);
      this->Keep(ray, values[i], at);
    }
  }

  HWY_INLINE void Keep(std::size_t ray, Real value, double at)
  {
    const Real before = this->Found.Value[ray];
    if (value > before || (value == before && at < this->Found.First[ray]))
    {
      this->Found.Value[ray] = value;
      this->Found.First[ray] = at;
      this->NoteReached(ray);
    }
  }

  const ExtremeBlocks<Real>& Blocks;
  const CellMeeting<Real>* Meeting; ///< with nearest interpolation
  Planes Between;
  typename Planes::Lattice Lattice;
  const RayBatch& Rays;
  const TileBeam& Beam;
  BeamExtremes<Real>& Found;
  std::uint64_t Wanted;                                  ///< one bit for each ray
  float Least = -std::numeric_limits<float>::infinity(); ///< that a ray has met
  alignas(64) std::array<float, 64> Reached, At;
  typename ExtremeBlocks<Real>::Children Bounds;
  ExtremeCell<Real> Cells[64];
};

template <typename Real>
void FindAll(const ExtremeBlocks<Real>& blocks, const CellMeeting<Real>* meeting,
  const GridCoordinates* grid, const RayBatch& rays, std::uint64_t which, TileBeam& beam,
  BeamExtremes<Real>& found)
{
  if (grid)
  {
    const RectilinearPlanes planes{ grid };
    ExtremeBeam<Real, RectilinearPlanes>(blocks, planes, meeting, rays, which, beam, found)
      .Search();
  }
  else
  {
    const UniformPlanes planes{ nullptr };
    ExtremeBeam<Real, UniformPlanes>(blocks, planes, meeting, rays, which, beam, found).Search();
  }
}

void FindFloat(const ExtremeBlocks<float>& blocks, const CellMeeting<float>* meeting,
  const GridCoordinates* grid, const RayBatch& rays, std::uint64_t which, TileBeam& beam,
  BeamExtremes<float>& found)
{
  FindAll(blocks, meeting, grid, rays, which, beam, found);
}

void FindDouble(const ExtremeBlocks<double>& blocks, const CellMeeting<double>* meeting,
  const GridCoordinates* grid, const RayBatch& rays, std::uint64_t which, TileBeam& beam,
  BeamExtremes<double>& found)
{
  FindAll(blocks, meeting, grid, rays, which, beam, found);
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

bool FindExtremes(const ExtremeBlocks<float>& blocks, const CellMeeting<float>* meeting,
  const GridCoordinates* grid, const RayBatch& rays, std::uint64_t which,
  BeamExtremes<float>& found)
{
  using namespace ExtremeKernels;
  TileBeam beam;
  if (!SetUpBeam(rays, which, blocks.Cells(), beam) || !beam.AreAlike)
  {
    return false;
  }
  HWY_DYNAMIC_DISPATCH(FindFloat)(blocks, meeting, grid, rays, which, beam, found);
  return true;
}

bool FindExtremes(const ExtremeBlocks<double>& blocks, const CellMeeting<double>* meeting,
  const GridCoordinates* grid, const RayBatch& rays, std::uint64_t which,
  BeamExtremes<double>& found)
{
  using namespace ExtremeKernels;
  TileBeam beam;
  if (!SetUpBeam(rays, which, blocks.Cells(), beam) || !beam.AreAlike)
  {
    return false;
  }
  HWY_DYNAMIC_DISPATCH(FindDouble)(blocks, meeting, grid, rays, which, beam, found);
  return true;
}

}
#endif
