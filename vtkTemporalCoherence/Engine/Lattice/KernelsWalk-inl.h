// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// A vector of rays that walk from active cell to active cell. Kernels include this file once for
// each kind of vectors, hence the toggling guard.
#if defined(TemporalCoherence_KernelsWalk_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef TemporalCoherence_KernelsWalk_inl_h
#undef TemporalCoherence_KernelsWalk_inl_h
#else
#define TemporalCoherence_KernelsWalk_inl_h
#endif

#include "Lattice/KernelsWalk.h"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <limits>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace WalkKernels
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

using Doubles = hn::CappedTag<double, WidestVector / 2>;
using Words = hn::RebindToUnsigned<Doubles>;
using Integers = hn::RebindToSigned<Doubles>;
using V = hn::Vec<Doubles>;
using W = hn::Vec<Words>;
using I = hn::Vec<Integers>;
using M = hn::Mask<Doubles>;

/// Added to a whole number in [0, 2^52), it moves the number's bits to the double's lowest bits.
constexpr double ToBits = 4503599627370496.0;

HWY_INLINE W BitsOf(V whole)
{
  const Doubles d;
  return hn::BitCast(Words(), hn::Add(whole, hn::Set(d, ToBits)));
}

HWY_INLINE V WholeOf(W bits)
{
  const Doubles d;
  return hn::Sub(hn::BitCast(d, bits), hn::Set(d, ToBits));
}

/// Whole numbers in [0, 2^52) as positions in lists.
HWY_INLINE I IndexOf(V whole)
{
  const Words du;
  const W exponent = hn::BitCast(du, hn::Set(Doubles(), ToBits));
  return hn::BitCast(Integers(), hn::Xor(BitsOf(whole), exponent));
}

/// One bit for each lane.
HWY_INLINE std::uint64_t BitsOfMask(M mask)
{
  std::uint8_t bits[8] = { 0 };
  hn::StoreMaskBits(Doubles(), mask, bits);
  return bits[0];
}

/// x + 4 y + 16 z, where x, y and z are bits `from` and `from` + 1 of a cell's coordinates.
template <int from>
HWY_INLINE W PlaceOf(const W cell[3])
{
  const W lowestTwo = hn::Set(Words(), 3u);
  const W x = hn::And(hn::ShiftRight<from>(cell[0]), lowestTwo);
  const W y = hn::And(hn::ShiftRight<from>(cell[1]), lowestTwo);
  const W z = hn::And(hn::ShiftRight<from>(cell[2]), lowestTwo);
  return hn::Or(x, hn::Or(hn::ShiftLeft<2>(y), hn::ShiftLeft<4>(z)));
}

/// True where bit `place` of a word is 1.
HWY_INLINE M HasBit(W word, W place)
{
  const Words du;
  const W bit = hn::And(hn::Shr(word, place), hn::Set(du, 1u));
  return hn::RebindMask(Doubles(), hn::Ne(bit, hn::Zero(du)));
}

/// Gather words that other threads may be writing: one access reads each word.
HWY_INLINE W LoadShared(const std::atomic<std::uint64_t>* words, W at)
{
  const Words du;
#if HWY_ARCH_X86 && HWY_TARGET <= HWY_AVX2
  // The machine's gather reads each aligned word at once. C++ has no atomic gather, and eight
  // atomic loads in a row are measurably slower.
  static_assert(sizeof(std::atomic<std::uint64_t>) == sizeof(std::uint64_t) &&
      std::atomic<std::uint64_t>::is_always_lock_free,
    "an atomic word is a word");
  const auto* const plain = reinterpret_cast<const std::uint64_t*>(words);
  return hn::GatherIndex(du, plain, hn::BitCast(Integers(), at));
#else
  // Elsewhere Highway would gather by plain reads, which race with stores of other threads.
  const auto load = [words](std::uint64_t place) HWY_ATTR
  { return words[place].load(std::memory_order_relaxed); };
  constexpr std::size_t lanes = WidestVector / 2;
  std::uint64_t places[lanes];
  hn::StoreU(at, du, places);
  if (hn::Lanes(du) == 1)
  {
    return hn::Set(du, load(places[0]));
  }
  std::uint64_t loaded[lanes];
  for (std::size_t i = 0; i < hn::Lanes(du); ++i)
  {
    loaded[i] = load(places[i]);
  }
  return hn::LoadU(du, loaded);
#endif
}

/// Bound of a point's rounding error, relative to the largest coordinate along its ray.
constexpr double Rounding = 16.0 * std::numeric_limits<double>::epsilon();

/// Compute the words of leaves that are not known yet.
inline HWY_NOINLINE W MakeCellsOf(const LeafSource& leaves, M isNew, I node, V x, V y, V z, W cells)
{
  const Doubles d;
  constexpr std::size_t lanes = WidestVector / 2;
  std::int64_t nodes[lanes];
  std::uint64_t words[lanes];
  double at[3][lanes];
  hn::StoreU(node, Integers(), nodes);
  hn::StoreU(cells, Words(), words);
  hn::StoreU(x, d, at[0]);
  hn::StoreU(y, d, at[1]);
  hn::StoreU(z, d, at[2]);
  const std::uint64_t which = BitsOfMask(isNew);
  for (std::size_t i = 0; i < hn::Lanes(d); ++i)
  {
    if (which >> i & 1u)
    {
      words[i] = leaves.CellsOf(nodes[i] / 2, glm::ivec3(at[0][i], at[1][i], at[2][i]));
    }
  }
  return hn::LoadU(Words(), words);
}

/// A vector of walking rays.
class WalkVector
{
public:
  /// \param first ray of the vector
  HWY_INLINE WalkVector(const WalkScene& scene, const RayBatch& rays, std::size_t first)
    : Scene(scene)
    , Live(hn::FirstN(Doubles(), static_cast<std::size_t>(rays.Count) - first))
  {
    this->End = this->LoadLive(rays.WalkEnd, first);
    for (std::size_t a = 0; a < 3; ++a)
    {
      this->Origin[a] = this->LoadLive(rays.Origin[a], first);
      this->Direction[a] = this->LoadLive(rays.Direction[a], first);
      this->Inverse[a] = this->LoadLive(rays.Inverse[a], first);
      this->Ahead[a] = hn::Gt(this->Direction[a], Zero());
      this->Last[a] = hn::Set(Doubles(), scene.Cells[static_cast<int>(a)] - 1);
      const V farthest = hn::Add(hn::Abs(this->Origin[a]), hn::Add(this->Last[a], One()));
      this->Margin[a] = hn::Mul(hn::Set(Doubles(), Rounding), farthest);
    }
  }

  /// Start where the walks of the rays begin.
  HWY_INLINE void Begin(const RayBatch& rays, std::size_t first)
  {
    const V begin = this->LoadLive(rays.WalkBegin, first);
    for (std::size_t a = 0; a < 3; ++a)
    {
      this->Cell[a] = this->WalkFrom(a, begin);
    }
  }

  /// Leave the cells in which the rays were last. Rays with a hit stop.
  HWY_INLINE void GoOn(const RayWalks& walks, std::size_t first)
  {
    W bits[3];
    for (std::size_t a = 0; a < 3; ++a)
    {
      this->Cell[a] = this->LoadLive(walks.Cell[a], first);
      bits[a] = BitsOf(this->Cell[a]);
    }
    const V infinity = hn::Set(Doubles(), std::numeric_limits<double>::infinity());
    const V distance = this->LoadLive(walks.Distance, first);
    this->Live = hn::And(this->Live, hn::Eq(distance, infinity));
    this->LeaveBlocks(bits, Zero());
  }

  /// Go from active cell to active cell.
  /// \param meet called with the lanes that are in an active cell; returns the lanes that stop
  template <typename Meet>
  HWY_INLINE void Walk(const Meet& meet)
  {
    const Words du;
    while (!hn::AllFalse(Doubles(), this->Live))
    {
      const W cell[3] = { BitsOf(this->Cell[0]), BitsOf(this->Cell[1]), BitsOf(this->Cell[2]) };
      const I node = this->NodeAt(cell);
      const W leaves = this->WordsAt(this->Scene.Active.Nodes(), node);
      const W leaf = PlaceOf<ActiveCells::LeafBits>(cell);
      const M inLeaf = hn::And(this->Live, HasBit(leaves, leaf));
      // Edge - 1 of the block that each lane leaves: a node without active leaves, a leaf, or a
      // cell.
      V below = hn::IfThenElse(hn::RebindMask(Doubles(), hn::Eq(leaves, hn::Zero(du))),
        hn::Set(Doubles(), ActiveCells::NodeSize - 1),
        hn::Set(Doubles(), ActiveCells::LeafSize - 1));
      if (!hn::AllFalse(Doubles(), inLeaf))
      {
        const W cells = this->CellsOfLeaves(inLeaf, node, leaf);
        const M isActive = hn::And(inLeaf, HasBit(cells, PlaceOf<0>(cell)));
        this->Live = hn::AndNot(meet(isActive), this->Live);
        below = hn::IfThenElse(inLeaf, Zero(), below);
      }
      this->LeaveBlocks(cell, below);
    }
  }

  HWY_INLINE V CellOf(std::size_t axis) const { return this->Cell[axis]; }

private:
  /// The numbers of live lanes; 1 in the others.
  HWY_INLINE V LoadLive(const RayBatch::Array<double>& array, std::size_t first) const
  {
    return hn::IfThenElse(this->Live, hn::LoadU(Doubles(), &array[first]), One());
  }
  static HWY_INLINE V Zero() { return hn::Zero(Doubles()); }
  static HWY_INLINE V One() { return hn::Set(Doubles(), 1.0); }

  /// BatchRay::CellAt.
  HWY_INLINE V CellAt(std::size_t axis, V t, V low, V high) const
  {
    const V x = hn::Add(this->Origin[axis], hn::Mul(t, this->Direction[axis]));
    return hn::Min(hn::Max(hn::Trunc(x), low), high);
  }

  /// True where a point lies so close to a plane between cells that rounding may move it across.
  HWY_INLINE M IsNextToPlane(std::size_t axis, V t) const
  {
    const V x = hn::Add(this->Origin[axis], hn::Mul(t, this->Direction[axis]));
    const V share = hn::Sub(x, hn::Trunc(x));
    return hn::Or(
      hn::Lt(share, this->Margin[axis]), hn::Gt(share, hn::Sub(One(), this->Margin[axis])));
  }

  /// CellWalk::Land.
  HWY_NOINLINE V Land(std::size_t a, V t, V cell, V low, V high, const M exits[3]) const
  {
    const M never = hn::Lt(Zero(), Zero());
    const M isBehindExit = a == 0 ? never : a == 1 ? exits[0] : hn::Or(exits[0], exits[1]);
    const M isBeforeExit = a == 0 ? hn::Or(exits[1], exits[2]) : a == 1 ? exits[2] : never;
    const M ahead = this->Ahead[a];
    const V above = hn::Add(cell, One()), below = hn::Sub(cell, One());
    const V ofCell = hn::Mul(hn::Sub(cell, this->Origin[a]), this->Inverse[a]);
    const V ofAbove = hn::Mul(hn::Sub(above, this->Origin[a]), this->Inverse[a]);
    const V enter = hn::IfThenElse(ahead, ofCell, ofAbove);
    const V leave = hn::IfThenElse(ahead, ofAbove, ofCell);
    const M isFirst = hn::Eq(cell, hn::IfThenElse(ahead, low, high));
    const M isLast = hn::Eq(cell, hn::IfThenElse(ahead, high, low));
    const M isNotYet = hn::Or(hn::Gt(enter, t), hn::And(isBehindExit, hn::Eq(enter, t)));
    const M isPassed = hn::Or(hn::Lt(leave, t), hn::And(isBeforeExit, hn::Eq(leave, t)));
    const V back = hn::IfThenElse(ahead, below, above);
    const V on = hn::IfThenElse(ahead, above, below);
    const V kept = hn::IfThenElse(hn::AndNot(isLast, isPassed), on, cell);
    return hn::IfThenElse(hn::AndNot(isFirst, isNotYet), back, kept);
  }

  /// BatchRay::WalkFrom.
  HWY_INLINE V WalkFrom(std::size_t axis, V t) const
  {
    const V cell = this->CellAt(axis, t, Zero(), this->Last[axis]);
    const V before = hn::IfThenElse(this->Ahead[axis], hn::Sub(cell, One()), hn::Add(cell, One()));
    const V pass = hn::Mul(hn::Sub(hn::Max(cell, before), this->Origin[axis]), this->Inverse[axis]);
    const M isAhead = hn::And(hn::Ne(this->Direction[axis], Zero()), hn::Gt(pass, t));
    const M isThere = hn::And(hn::Ge(before, Zero()), hn::Le(before, this->Last[axis]));
    return hn::IfThenElse(hn::And(isAhead, isThere), before, cell);
  }

  /// Position of the first word of each cell's node.
  HWY_INLINE I NodeAt(const W cell[3]) const
  {
    const Doubles d;
    const glm::ivec3& nodes = this->Scene.Active.NodeDimensions();
    const W inNode = hn::Set(Words(), ~static_cast<std::uint64_t>(ActiveCells::NodeSize - 1));
    const V row = hn::Set(d, nodes.x);
    const V slice = hn::Set(d, static_cast<double>(nodes.x) * nodes.y);
    const V first = hn::Add(WholeOf(hn::And(cell[0], inNode)),
      hn::Add(hn::Mul(WholeOf(hn::And(cell[1], inNode)), row),
        hn::Mul(WholeOf(hn::And(cell[2], inNode)), slice)));
    const V word = hn::Mul(first, hn::Set(d, 2.0 / ActiveCells::NodeSize));
    return IndexOf(word);
  }

  /// Load words of a list for live lanes. Neighbouring rays often share a node, which needs one
  /// load.
  HWY_INLINE W WordsAt(const std::uint64_t* words, I at) const
  {
    const Integers di;
    const std::int64_t first = hn::GetLane(at);
    const M isFirst = hn::RebindMask(Doubles(), hn::Eq(at, hn::Set(di, first)));
    if (hn::AllFalse(Doubles(), hn::AndNot(isFirst, this->Live)))
    {
      return hn::Set(Words(), words[first]);
    }
    return hn::GatherIndex(Words(), words, at);
  }

  /// The active cells, one bit each, of the leaves that lanes `inLeaf` are in.
  HWY_INLINE W CellsOfLeaves(M inLeaf, I node, W leaf) const
  {
    const Words du;
    const ActiveCells& active = this->Scene.Active;
    const W first = this->WordsAt(active.Nodes() + 1, node);
    const W word = hn::IfThenElseZero(hn::RebindMask(du, inLeaf), hn::Add(first, leaf));
    W cells = LoadShared(active.Cells(), word);
    const M isNew = hn::And(inLeaf, hn::RebindMask(Doubles(), hn::Eq(cells, hn::Zero(du))));
    if (!hn::AllFalse(Doubles(), isNew))
    {
      cells = MakeCellsOf(
        this->Scene.Leaves, isNew, node, this->Cell[0], this->Cell[1], this->Cell[2], cells);
    }
    return cells;
  }

  /// CellWalk::LeaveBlock: leave the aligned blocks around the present cells, below + 1 cells along
  /// each edge. Lanes whose walk ends first are no longer live.
  HWY_INLINE void LeaveBlocks(const W cell[3], V below)
  {
    const W inBlock = BitsOf(below);
    const V size = hn::Add(below, One());
    V first[3], beyond[3], leave[3];
    for (std::size_t a = 0; a < 3; ++a)
    {
      first[a] = hn::Sub(this->Cell[a], WholeOf(hn::And(cell[a], inBlock)));
      const V plane = hn::Add(first[a], hn::IfThenElseZero(this->Ahead[a], size));
      leave[a] = hn::Mul(hn::Sub(plane, this->Origin[a]), this->Inverse[a]);
      beyond[a] = hn::IfThenElse(this->Ahead[a], plane, hn::Sub(plane, One()));
    }
    const M isY = hn::Lt(leave[1], leave[0]);
    const V leaveXY = hn::IfThenElse(isY, leave[1], leave[0]);
    const M isZ = hn::Lt(leave[2], leaveXY);
    const V t = hn::IfThenElse(isZ, leave[2], leaveXY);
    const M exits[3] = { hn::Not(hn::Or(isY, isZ)), hn::AndNot(isZ, isY), isZ };

    const V next = hn::IfThenElse(isZ, beyond[2], hn::IfThenElse(isY, beyond[1], beyond[0]));
    const V last =
      hn::IfThenElse(isZ, this->Last[2], hn::IfThenElse(isY, this->Last[1], this->Last[0]));
    const M isInside = hn::And(hn::Ge(next, Zero()), hn::Le(next, last));
    this->Live = hn::And(this->Live, hn::And(hn::Lt(t, this->End), isInside));
    const M isLeap = hn::And(this->Live, hn::Gt(below, Zero()));
    for (std::size_t a = 0; a < 3; ++a)
    {
      const V high = hn::Add(first[a], below);
      V at = this->CellAt(a, t, first[a], high);
      const M isNext = hn::AndNot(exits[a], this->IsNextToPlane(a, t));
      if (!hn::AllFalse(Doubles(), hn::And(isNext, isLeap)))
      {
        at = this->Land(a, t, at, first[a], high, exits);
      }
      const V to = hn::IfThenElse(exits[a], next, at);
      this->Cell[a] = hn::IfThenElse(this->Live, to, this->Cell[a]);
    }
  }

  const WalkScene& Scene;
  M Live;
  V Origin[3], Direction[3], Inverse[3], End, Last[3], Cell[3];
  V Margin[3]; ///< distance from a plane within which rounding may move a point across
  M Ahead[3];  ///< the ray runs towards higher cells
};

}
}
}
HWY_AFTER_NAMESPACE();

#endif
