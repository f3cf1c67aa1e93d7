// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Fields/BandBeam.h"

#include <algorithm>
#include <array>

// This file is compiled once for each kind of vectors, and what runs is chosen by the machine.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Fields/KernelsBandBeam.cxx"
#include <hwy/foreach_target.h>

#include "Fields/KernelsBeamTree-inl.h"

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace BeamKernels
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

/// The faces of a cell: of each axis the nearer one first.
struct CellFaces
{
  float Near[3], Far[3];
};

/// Distances between which rays are in a cell.
struct Passage
{
  V Enter, Leave;
};

/// Tests the cells of leaves against the rays of a beam, and notes those that may bring rays on.
class BandSearch
{
public:
  BandSearch(BandBeamScene& scene, BandReach& reach, TileBeam& beam)
    : Scene(scene)
    , Reached(reach)
    , Beam(beam)
    , ErrorPerValue(16.0f * beam.Margin + 0x1p-13f)
  {
  }

  /// \param cells one bit for each, from front to back
  void TestCells(const glm::ivec3& leaf, std::uint64_t cells)
  {
    this->FindPassed(leaf, cells);
    if (this->NumberOfPairs == 0)
    {
      return;
    }
    if (this->NumberOfRead + this->NumberOfPassed > BandBeamScene::MostCells)
    {
      this->Finish();
    }
    this->Scene.Read(this->Places, this->NumberOfPassed, this->NumberOfRead, this->Cells);
    for (std::size_t pair = 0; pair < this->NumberOfPairs; ++pair)
    {
      this->SearchCell(this->Pairs[pair]);
      if (this->Noted.Count >= RayBatch::Capacity)
      {
        this->Measure(RayBatch::Capacity);
      }
    }
    this->NumberOfRead += this->NumberOfPassed;
    if (this->IsNearer)
    {
      this->FindDepth();
    }
  }

  /// Measure all that is noted.
  void Finish()
  {
    this->Measure(this->Noted.Count);
    this->NumberOfRead = 0;
  }

private:
  static constexpr std::size_t CellsOfLeaf = 64;

  /// A cell, and a vector of rays some of which pass it.
  struct Pair
  {
    std::uint8_t Cell, Rays;
    std::uint16_t Which; ///< one bit for each of the rays
  };

  /// Note the cells that rays pass. One step for all cells after the other, so that hardly a branch
  /// depends on what is in a cell.
  HWY_INLINE void FindPassed(const glm::ivec3& leaf, std::uint64_t cells)
  {
    const glm::ivec3 from = leaf - this->Beam.Anchor;
    this->NumberOfPassed = this->NumberOfPairs = 0;
    std::int64_t passing = 0;
    for (; cells != 0; cells &= cells - 1)
    {
      const int number =
        static_cast<int>(hwy::Num0BitsBelowLS1Bit_Nonzero64(cells)) ^ this->Beam.Flip;
      const glm::ivec3 place(number & 3, number >> 2 & 3, number >> 4);
      this->Places[this->NumberOfPassed] = leaf + place;
      this->First[this->NumberOfPassed] = glm::vec3(from + place);
      const CellFaces faces = this->FacesOf(this->First[this->NumberOfPassed], this->Beam.Margin);
      const std::size_t before = this->NumberOfPairs;
      for (std::size_t i = 0; i < RayBatch::Capacity; i += hn::Lanes(Floats()))
      {
        const std::uint64_t which = BitsOf(this->Passes(this->Pass(faces, i), i));
        this->Pairs[this->NumberOfPairs] = { static_cast<std::uint8_t>(this->NumberOfPassed),
          static_cast<std::uint8_t>(i), static_cast<std::uint16_t>(which) };
        this->NumberOfPairs += which != 0;
        passing += static_cast<std::int64_t>(hwy::PopCount(which));
      }
      this->NumberOfPassed += this->NumberOfPairs != before;
    }
    this->Beam.CellsPassed += passing;
  }

  HWY_INLINE CellFaces FacesOf(const glm::vec3& first, float margin) const
  {
    CellFaces faces;
    for (int a = 0; a < 3; ++a)
    {
      const bool isBack = this->Beam.Flip >> (2 * a) & 1;
      const float low = first[a] - margin, high = first[a] + 1.0f + margin;
      faces.Near[a] = isBack ? high : low;
      faces.Far[a] = isBack ? low : high;
    }
    return faces;
  }

  /// Where a vector of rays passes a cell, given its faces.
  HWY_INLINE Passage Pass(const CellFaces& faces, std::size_t i) const
  {
    const TileBeam& beam = this->Beam;
    Passage passed;
    passed.Enter = Load(&beam.Begin[i]);
    passed.Leave = Load(&beam.End[i]);
    for (std::size_t a = 0; a < 3; ++a)
    {
      const V origin = Load(&beam.Origin[a][i]), inverse = Load(&beam.Inverse[a][i]);
      passed.Enter = hn::Max(passed.Enter, hn::Mul(hn::Sub(Set(faces.Near[a]), origin), inverse));
      passed.Leave = hn::Min(passed.Leave, hn::Mul(hn::Sub(Set(faces.Far[a]), origin), inverse));
    }
    return passed;
  }

  /// Those of some rays that pass a cell on their walk, before they are done.
  HWY_INLINE M Passes(const Passage& passed, std::size_t i) const
  {
    const V behind = Load(&this->Beam.Behind[i]), begin = Load(&this->Beam.WalkBegin[i]);
    return hn::And(
      hn::Le(passed.Enter, hn::Min(passed.Leave, behind)), hn::Ge(passed.Leave, begin));
  }

  /// Note a cell for those of some rays that it may bring on.
  HWY_INLINE void SearchCell(const Pair& pair)
  {
    const BandCell& cell = this->Cells[pair.Cell];
    const std::size_t i = pair.Rays;
    const M mayRise = hn::Lt(Load(&this->Reached.Rising[i]), Set(cell.ToRise));
    const M mayFall = hn::Lt(Load(&this->Reached.Falling[i]), Set(cell.ToFall));
    const M isNoted = hn::And(MaskOf(pair.Which), hn::Or(mayRise, mayFall));
    const std::uint64_t noted = BitsOf(isNoted);
    if (noted == 0)
    {
      return;
    }
    const std::size_t number = this->NumberOfRead + pair.Cell;
    for (std::uint64_t left = noted; left != 0; left &= left - 1)
    {
      const std::size_t at = this->Noted.Count++;
      this->Noted.Ray[at] = static_cast<std::uint8_t>(i + hwy::Num0BitsBelowLS1Bit_Nonzero64(left));
      this->Noted.Cell[at] = static_cast<std::uint8_t>(number);
    }
    if (cell.IsFinite)
    {
      this->BringOn(cell, this->First[pair.Cell], isNoted, i);
    }
    this->Reached.Entered |= noted << i;
  }

  /// Where rays enter and leave a cell at most and at least, if they pass it for sure.
  HWY_INLINE Passage FindSure(const Passage& passed, const glm::vec3& first, std::size_t i) const
  {
    const TileBeam& beam = this->Beam;
    const V margin = Set(2.0f * beam.Margin);
    Passage sure;
    if (beam.IsSteep)
    {
      sure = this->Pass(this->FacesOf(first, -beam.Margin), i);
    }
    else
    {
      const V slack = Load(&beam.Slack[i]);
      sure = { hn::Add(passed.Enter, slack), hn::Sub(passed.Leave, slack) };
    }
    sure.Enter = hn::Max(sure.Enter, hn::Add(Load(&beam.Begin[i]), margin));
    sure.Leave = hn::Min(sure.Leave, hn::Sub(Load(&beam.End[i]), margin));
    return sure;
  }

  /// Bring some rays on by what they reach in a cell for sure.
  HWY_INLINE void BringOn(const BandCell& cell, const glm::vec3& first, M isNoted, std::size_t i)
  {
    TileBeam& beam = this->Beam;
    const V zero = hn::Zero(Floats());
    Passage passed = this->Pass(this->FacesOf(first, beam.Margin), i);
    passed.Enter = hn::IfThenElse(isNoted, passed.Enter, zero);
    passed.Leave = hn::IfThenElse(isNoted, passed.Leave, zero);
    const V length = hn::Sub(passed.Leave, passed.Enter);
    V at[3], step[3];
    for (std::size_t a = 0; a < 3; ++a)
    {
      const V direction = Load(&beam.Direction[a][i]);
      const V origin = hn::Sub(Load(&beam.Origin[a][i]), Set(first[static_cast<int>(a)]));
      at[a] = hn::Add(origin, hn::Mul(passed.Enter, direction));
      step[a] = hn::Mul(length, direction);
    }
    CellValues values;
    values.Set(cell.Corners);
    const Coefficients b = CubicsAlong(values, at, step);
    const Passage sure = this->FindSure(passed, first, i);
    const V margin = Set(2.0f * beam.Margin), behind = Load(&beam.Behind[i]);
    // The walk begins before the cell is left, and ends after it is entered.
    M isSure = hn::And(isNoted, hn::Lt(sure.Enter, sure.Leave));
    isSure = hn::And(isSure, hn::Lt(hn::Add(Load(&beam.WalkBegin[i]), margin), sure.Leave));
    isSure = hn::And(isSure, hn::Lt(hn::Add(sure.Enter, margin), behind));
    // As in cold beams: the interpolant changes by twice the largest corner along an axis, and
    // little more outside.
    const V slope = Set(2.25f * beam.Steepest * values.Largest);
    const V error = Set((values.Largest + this->Reached.Span) * this->ErrorPerValue + 1e-30f);
    const V firstError = hn::MulAdd(slope, hn::Sub(sure.Enter, passed.Enter), error);
    const V lastError = hn::MulAdd(slope, hn::Sub(passed.Leave, sure.Leave), error);
    this->Keep({ hn::Sub(b.First, firstError), hn::Sub(b.Last, lastError) },
      { hn::Add(b.First, firstError), hn::Add(b.Last, lastError) }, isSure, i);
    const M isDone = hn::And(isNoted,
      hn::Ge(hn::Min(Load(&this->Reached.Rising[i]), Load(&this->Reached.Falling[i])),
        Set(BandReach::Done)));
    if (!hn::AllFalse(Floats(), isDone))
    {
      hn::StoreU(
        hn::IfThenElse(isDone, hn::Min(behind, passed.Leave), behind), Floats(), &beam.Behind[i]);
      this->IsNearer = true;
    }
  }

  /// Values at the ends of passages.
  struct EndValues
  {
    V First, Last;
  };

  /// Keep what rays reach for sure.
  HWY_INLINE void Keep(const EndValues& least, const EndValues& most, M isSure, std::size_t i)
  {
    const Floats d;
    const V span = Set(this->Reached.Span), zero = hn::Zero(d), done = Set(BandReach::Done);
    V rising = Load(&this->Reached.Rising[i]), falling = Load(&this->Reached.Falling[i]);
    const V rises = hn::Max(least.First, least.Last);
    const V falls = hn::Sub(span, hn::Min(most.First, most.Last));
    rising = hn::IfThenElse(isSure, hn::Max(rising, rises), rising);
    falling = hn::IfThenElse(isSure, hn::Max(falling, falls), falling);
    // A ray that begins above the band does not rise, one below does not fall.
    const M begins = hn::AndNot(MaskOf(this->Reached.Entered >> i), isSure);
    const M beginsAbove = hn::And(begins, hn::Gt(least.First, span));
    const M beginsBelow = hn::And(begins, hn::Lt(most.First, zero));
    rising = hn::IfThenElse(hn::Or(beginsAbove, hn::Gt(rising, span)), done, rising);
    falling = hn::IfThenElse(hn::Or(beginsBelow, hn::Gt(falling, span)), done, falling);
    hn::StoreU(rising, d, &this->Reached.Rising[i]);
    hn::StoreU(falling, d, &this->Reached.Falling[i]);
  }

  void Measure(std::size_t count)
  {
    NotedCells& noted = this->Noted;
    if (count == 0)
    {
      return;
    }
    this->Scene.Measure(noted, count, this->Reached, this->Beam);
    noted.Count -= count;
    std::copy_n(noted.Ray.begin() + count, noted.Count, noted.Ray.begin());
    std::copy_n(noted.Cell.begin() + count, noted.Count, noted.Cell.begin());
    this->IsNearer = true;
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

  BandBeamScene& Scene;
  BandReach& Reached;
  TileBeam& Beam;
  const float ErrorPerValue; ///< as in cold beams
  bool IsNearer = false;     ///< what matters ends before the plane across the beam

  // Of the present leaf: cells that rays pass.
  std::size_t NumberOfPassed = 0, NumberOfPairs = 0;
  glm::ivec3 Places[CellsOfLeaf];
  glm::vec3 First[CellsOfLeaf]; ///< their first corners
  BandCell Cells[CellsOfLeaf];
  Pair Pairs[CellsOfLeaf * RayBatch::Capacity / hn::MaxLanes(Floats()) + 1];

  std::size_t NumberOfRead = 0; ///< cells that the scene remembers of leaves before
  NotedCells Noted;
};

bool AreAlike(const TileBeam& beam)
{
  M isAlike = hn::Eq(hn::Zero(Floats()), hn::Zero(Floats()));
  for (std::size_t i = 0; i < beam.Count; i += hn::Lanes(Floats()))
  {
    for (std::size_t a = 0; a < 3; ++a)
    {
      const V inverse = Load(&beam.Inverse[a][i]);
      const V ahead = beam.Flip >> (2 * a) & 1 ? hn::Neg(inverse) : inverse;
      isAlike = hn::And(isAlike, hn::Gt(ahead, hn::Zero(Floats())));
    }
  }
  return hn::AllTrue(Floats(), isAlike);
}

void SearchIn(const ActiveCells& active, BandBeamScene& scene, BandReach& reach, TileBeam& beam)
{
  BandSearch search(scene, reach, beam);
  BeamTree<BandSearch>(active, scene, beam, search).Visit();
  search.Finish();
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
HWY_EXPORT(AreAlike);
HWY_EXPORT(SearchIn);
}

bool AreRaysAlike(const TileBeam& beam)
{
  using namespace BeamKernels;
  return HWY_DYNAMIC_DISPATCH(AreAlike)(beam);
}

void SearchBand(const ActiveCells& active, BandBeamScene& scene, BandReach& reach, TileBeam& beam)
{
  using namespace BeamKernels;
  HWY_DYNAMIC_DISPATCH(SearchIn)(active, scene, reach, beam);
}

}
#endif
