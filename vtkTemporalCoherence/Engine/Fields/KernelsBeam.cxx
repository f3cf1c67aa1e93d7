// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Fields/KernelsBeam.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>

// This file is compiled once for each kind of vectors, and what runs is chosen by the machine.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Fields/KernelsBeam.cxx"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace BeamKernels
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::CappedTag<float, WidestVector>;
using Integers = hn::RebindToSigned<Floats>;
using V = hn::Vec<Floats>;
using M = hn::Mask<Floats>;

HWY_INLINE V Load(const float* from)
{
  return hn::LoadU(Floats(), from);
}

HWY_INLINE V Set(float value)
{
  return hn::Set(Floats(), value);
}

/// One bit for each lane.
HWY_INLINE std::uint64_t BitsOf(M mask)
{
  std::uint8_t bits[8] = { 0 };
  hn::StoreMaskBits(Floats(), mask, bits);
  return static_cast<std::uint64_t>(bits[0]) | static_cast<std::uint64_t>(bits[1]) << 8;
}

HWY_INLINE M MaskOf(std::uint64_t which)
{
  const std::uint8_t bits[8] = { static_cast<std::uint8_t>(which),
    static_cast<std::uint8_t>(which >> 8) };
  return hn::LoadMaskBits(Floats(), bits);
}

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

/// The trilinear interpolant of a cell, by differences along x.
struct CellValues
{
  HWY_INLINE void Set(const std::array<float, 8>& corners)
  {
    float largest[4];
    for (std::size_t row = 0; row < 4; ++row)
    {
      const float low = corners[2 * row], high = corners[2 * row + 1];
      this->Low[row] = low;
      this->Step[row] = high - low;
      largest[row] = std::max(std::abs(low), std::abs(high));
    }
    this->Largest = std::max(std::max(largest[0], largest[1]), std::max(largest[2], largest[3]));
  }

  float Low[4], Step[4];
  float Largest;
};

/// Bernstein coefficients, of which the smallest and largest bound the cubic.
struct Coefficients
{
  V First, Last, Smallest, Largest;
};

/// The cubic along paths from `at` on, in cell coordinates.
HWY_INLINE Coefficients CubicsAlong(const CellValues& cell, const V at[3], const V step[3])
{
  // Powers of the share of the path: linear along x, quadratic along x and y, then cubic.
  V line0[4], line1[4], square0[2], square1[2], square2[2];
  for (std::size_t row = 0; row < 4; ++row)
  {
    const V slope = Set(cell.Step[row]);
    line0[row] = hn::MulAdd(slope, at[0], Set(cell.Low[row]));
    line1[row] = hn::Mul(slope, step[0]);
  }
  for (std::size_t z = 0; z < 2; ++z)
  {
    const V rise0 = hn::Sub(line0[2 * z + 1], line0[2 * z]);
    const V rise1 = hn::Sub(line1[2 * z + 1], line1[2 * z]);
    square0[z] = hn::MulAdd(at[1], rise0, line0[2 * z]);
    square1[z] = hn::MulAdd(step[1], rise0, hn::MulAdd(at[1], rise1, line1[2 * z]));
    square2[z] = hn::Mul(step[1], rise1);
  }
  const V rise0 = hn::Sub(square0[1], square0[0]), rise1 = hn::Sub(square1[1], square1[0]);
  const V rise2 = hn::Sub(square2[1], square2[0]);
  const V c0 = hn::MulAdd(at[2], rise0, square0[0]);
  const V c1 = hn::MulAdd(step[2], rise0, hn::MulAdd(at[2], rise1, square1[0]));
  const V c2 = hn::MulAdd(step[2], rise1, hn::MulAdd(at[2], rise2, square2[0]));
  const V c3 = hn::Mul(step[2], rise2);

  const V third = Set(1.0f / 3.0f);
  const V b1 = hn::MulAdd(c1, third, c0);
  const V b2 = hn::MulAdd(hn::Add(c1, c2), third, b1);
  const V b3 = hn::Add(hn::Add(c0, c1), hn::Add(c2, c3));
  return { c0, b3, hn::Min(hn::Min(c0, b1), hn::Min(b2, b3)),
    hn::Max(hn::Max(c0, b1), hn::Max(b2, b3)) };
}

/// Distances between which rays are in a box.
struct Interval
{
  V Enter, Leave;
};

/// \tparam IsPlain that of the beam
template <bool IsPlain>
class BeamSearch
{
public:
  BeamSearch(const BeamTask& task, BeamScene& scene, TileBeam& beam)
    : Task(task)
    , Scene(scene)
    , Beam(beam)
  {
  }

  void Search()
  {
    const std::vector<ActiveCells::Level>& levels = this->Task.Active.LevelsAbove();
    this->VisitLevel(levels.size() - 1, glm::ivec3(0));
    this->Scene.Decide(this->Open, this->Beam);
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
        this->VisitChildren(
          cells, leaf, 1, [&](const glm::ivec3& cell) HWY_ATTR { this->TestCell(leaf + cell); });
        if (this->IsNearer)
        {
          this->FindDepth();
        }
      });
  }

  /// The faces of a cell, moved outwards: of each axis the nearer one first.
  HWY_INLINE void FindPlanes(const float first[3], float margin, float planes[2][3]) const
  {
    for (int a = 0; a < 3; ++a)
    {
      const bool isBack = this->Beam.Flip >> (2 * a) & 1;
      const float low = first[a] - margin, high = first[a] + 1.0f + margin;
      planes[0][a] = isBack ? high : low;
      planes[1][a] = isBack ? low : high;
    }
  }

  /// Where a vector of rays passes a cell, given its faces. Of one that begins or ends in the cell
  /// that is more than it does.
  HWY_INLINE Interval Pass(const float planes[2][3], std::size_t i) const
  {
    const TileBeam& beam = this->Beam;
    Interval passed;
    for (std::size_t a = 0; a < 3; ++a)
    {
      const V origin = Load(&beam.Origin[a][i]), inverse = Load(&beam.Inverse[a][i]);
      const V one = hn::Mul(hn::Sub(Set(planes[0][a]), origin), inverse);
      const V other = hn::Mul(hn::Sub(Set(planes[1][a]), origin), inverse);
      const V enter = IsPlain ? one : hn::Min(one, other);
      const V leave = IsPlain ? other : hn::Max(one, other);
      passed.Enter = a == 0 ? enter : hn::Max(passed.Enter, enter);
      passed.Leave = a == 0 ? leave : hn::Min(passed.Leave, leave);
    }
    return passed;
  }

  /// Those of some rays that pass a cell before what they are known to meet.
  HWY_INLINE M Passes(Interval& passed, std::size_t i) const
  {
    const TileBeam& beam = this->Beam;
    if (!IsPlain)
    {
      passed.Enter = hn::Max(passed.Enter, Load(&beam.Begin[i]));
    }
    const V behind = Load(&beam.Behind[i]);
    const M isPassed = hn::Lt(passed.Enter, hn::Min(passed.Leave, behind));
    return IsPlain ? isPassed : hn::And(isPassed, hn::Gt(passed.Leave, Load(&beam.WalkBegin[i])));
  }

  /// Find the rays that pass a cell before what they are known to meet, and search it for them.
  void TestCell(const glm::ivec3& cell)
  {
    TileBeam& beam = this->Beam;
    const float first[3] = { static_cast<float>(cell.x - beam.Anchor.x),
      static_cast<float>(cell.y - beam.Anchor.y), static_cast<float>(cell.z - beam.Anchor.z) };
    float planes[2][3];
    this->FindPlanes(first, beam.Margin, planes);
    // First all vectors, without a branch: which rays pass a cell is hard to foresee.
    float enter[RayBatch::Capacity], leave[RayBatch::Capacity];
    std::uint64_t passing = 0;
    for (std::size_t i = 0; i < RayBatch::Capacity; i += hn::Lanes(Floats()))
    {
      Interval passed = this->Pass(planes, i);
      passing |= BitsOf(this->Passes(passed, i)) << i;
      hn::StoreU(passed.Enter, Floats(), enter + i);
      hn::StoreU(passed.Leave, Floats(), leave + i);
    }
    if (passing == 0)
    {
      return;
    }
    CellValues values;
    std::array<float, 8> corners;
    const std::int32_t number = this->Scene.Read(cell, corners);
    values.Set(corners);
    beam.CellsPassed += static_cast<std::int64_t>(hwy::PopCount(passing));
    bool isMet = false;
    while (passing != 0)
    {
      constexpr std::size_t lanes = hn::MaxLanes(Floats());
      const std::size_t i = hwy::Num0BitsBelowLS1Bit_Nonzero64(passing) & ~(lanes - 1);
      const std::uint64_t these = lanes == 64 ? ~std::uint64_t(0) : (std::uint64_t(1) << lanes) - 1;
      const M isPassed = MaskOf(passing >> i);
      passing &= ~(these << i);
      const Interval passed{ Load(enter + i), Load(leave + i) };
      this->KeepContacts(passed.Enter, isPassed, number, i);
      isMet |= this->SearchCell(values, first, passed, isPassed, number, i);
    }
    if (number == BeamScene::MostCells - 1 || this->Open.Count > RayBatch::Capacity)
    {
      this->Scene.Decide(this->Open, beam);
      for (std::int32_t& contact : beam.ContactCell)
      {
        contact = contact == TileBeam::NoCell ? contact : TileBeam::ForgottenCell;
      }
      isMet = true;
    }
    this->IsNearer |= isMet;
  }

  HWY_INLINE void KeepContacts(V enter, M isPassed, std::int32_t number, std::size_t i)
  {
    TileBeam& beam = this->Beam;
    const Floats d;
    const Integers di;
    const V here = hn::IfThenElse(isPassed, enter, Set(TileBeam::Never));
    const V contact = Load(&beam.Contact[i]);
    hn::StoreU(hn::Min(here, contact), d, &beam.Contact[i]);
    if (!this->Task.AreContactsExact)
    {
      return;
    }
    const V next = Load(&beam.NextContact[i]);
    const auto isFirst = hn::RebindMask(di, hn::Lt(here, contact));
    const auto cell = hn::LoadU(di, &beam.ContactCell[i]);
    hn::StoreU(hn::Min(next, hn::Max(here, contact)), d, &beam.NextContact[i]);
    hn::StoreU(hn::IfThenElse(isFirst, hn::Set(di, number), cell), di, &beam.ContactCell[i]);
  }

  /// Search a cell for some rays.
  /// \return true if one of them meets a surface in it for sure
  HWY_INLINE bool SearchCell(const CellValues& values, const float first[3], const Interval& passed,
    M isPassed, std::int32_t number, std::size_t i)
  {
    const TileBeam& beam = this->Beam;
    const V zero = hn::Zero(Floats());
    const V enter = hn::IfThenElse(isPassed, passed.Enter, zero);
    const V leave = hn::IfThenElse(isPassed, passed.Leave, zero);
    const V length = hn::Sub(leave, enter);
    V at[3], step[3];
    for (std::size_t a = 0; a < 3; ++a)
    {
      const V direction = Load(&beam.Direction[a][i]);
      const V origin = hn::Sub(Load(&beam.Origin[a][i]), Set(first[a]));
      at[a] = hn::Add(origin, hn::Mul(enter, direction));
      step[a] = hn::Mul(length, direction);
    }
    const Coefficients b = CubicsAlong(values, at, step);
    const float error = values.Largest * (16.0f * beam.Margin + 0x1p-13f) + 1e-30f;
    const M isBelow = hn::Lt(b.Largest, Set(-error));
    const M isAbove = this->Task.IsSolid ? hn::Lt(zero, zero) : hn::Gt(b.Smallest, Set(error));
    const M isOpen = hn::AndNot(hn::Or(isBelow, isAbove), isPassed);
    if (hn::AllFalse(Floats(), isOpen))
    {
      return false;
    }
    return this->KeepCell(b, values.Largest, error, first, { enter, leave }, isOpen, number, i);
  }

  /// Keep a cell that rays may meet a surface in.
  HWY_INLINE bool KeepCell(const Coefficients& b, float largest, float error,
    const float first[3], const Interval& searched, M isOpen, std::int32_t number, std::size_t i)
  {
    TileBeam& beam = this->Beam;
    const Floats d;
    const Integers di;
    const V margin = Set(2.0f * beam.Margin), most = Set(error),
            per = Set(2.25f * beam.Steepest * largest);
    // The ray enters and leaves between these and those that were searched.
    Interval sure;
    if (beam.IsSteep)
    {
      float planes[2][3];
      this->FindPlanes(first, -beam.Margin, planes);
      sure = this->Pass(planes, i);
    }
    else
    {
      const V slack = Load(&beam.Slack[i]);
      sure = { hn::Add(searched.Enter, slack), hn::Sub(searched.Leave, slack) };
    }
    sure.Enter = hn::Max(sure.Enter, hn::Add(Load(&beam.Begin[i]), margin));
    sure.Leave = hn::Min(sure.Leave, hn::Sub(Load(&beam.End[i]), margin));
    const V firstError = hn::Add(most, hn::Mul(per, hn::Sub(sure.Enter, searched.Enter)));
    const V lastError = hn::Add(most, hn::Mul(per, hn::Sub(searched.Leave, sure.Leave)));
    const M beginsIn = hn::Gt(b.First, firstError), endsIn = hn::Gt(b.Last, lastError);
    const M beginsOut = hn::Lt(hn::Add(b.First, firstError), hn::Zero(d));
    const M endsOut = hn::Lt(hn::Add(b.Last, lastError), hn::Zero(d));
    const M rises = hn::And(beginsOut, endsIn);
    const M isCrossed = hn::Or(rises, this->Task.IsSolid ? beginsIn : hn::And(beginsIn, endsOut));
    M isSure = hn::Lt(sure.Enter, sure.Leave);
    const V behind = Load(&beam.Behind[i]);
    if (!IsPlain)
    {
      // And where the walk ends for sure after the cell is entered, and begins before it is left.
      const V begin = hn::Add(Load(&beam.WalkBegin[i]), margin);
      isSure = hn::And(isSure,
        hn::And(hn::Lt(begin, sure.Leave), hn::Lt(hn::Add(sure.Enter, margin), behind)));
    }
    const M isMet = hn::And(isOpen, hn::And(isCrossed, isSure));
    const V before = Load(&beam.Enter[i]);
    const M isFirst = hn::And(isMet, hn::Lt(sure.Enter, before));
    this->NoteOpen(BitsOf(hn::AndNot(isMet, isOpen)), searched.Enter, number, i);
    if (hn::AllFalse(d, isFirst))
    {
      return false;
    }
    hn::StoreU(
      hn::IfThenElse(isFirst, hn::Min(behind, searched.Leave), behind), d, &beam.Behind[i]);
    hn::StoreU(hn::IfThenElse(isFirst, sure.Enter, before), d, &beam.Enter[i]);
    hn::StoreU(hn::IfThenElse(
                 hn::RebindMask(di, isFirst), hn::Set(di, number), hn::LoadU(di, &beam.Cell[i])),
      di, &beam.Cell[i]);
    return true;
  }

  /// Let the scene decide what single precision cannot.
  HWY_INLINE void NoteOpen(std::uint64_t which, V enter, std::int32_t number, std::size_t i)
  {
    float enters[WidestVector];
    hn::StoreU(enter, Floats(), enters);
    for (; which != 0; which &= which - 1)
    {
      const std::size_t lane = hwy::Num0BitsBelowLS1Bit_Nonzero64(which);
      const std::size_t at = this->Open.Count++;
      this->Open.Ray[at] = static_cast<std::uint8_t>(i + lane);
      this->Open.Cell[at] = number;
      this->Open.Enter[at] = enters[lane];
    }
  }

  void FindDepth()
  {
    this->IsNearer = false;
    TileBeam& beam = this->Beam;
    V depth = Set(-1e30f);
    for (std::size_t i = 0; i < beam.Count; i += hn::Lanes(Floats()))
    {
      const V along = hn::Mul(Load(&beam.Behind[i]), Load(&beam.PerDepth[i]));
      depth = hn::Max(depth, hn::Add(Load(&beam.AtDepth[i]), along));
    }
    beam.Around.Offset[TileBeam::Across] =
      -(hn::GetLane(hn::MaxOfLanes(Floats(), depth)) + 4.0f * beam.Margin);
  }

  const BeamTask& Task;
  BeamScene& Scene;
  TileBeam& Beam;
  OpenCells Open;
  bool IsNearer = false; ///< what matters ends before the plane across the beam
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
