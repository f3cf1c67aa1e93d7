// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Lattice/KernelsBeam.h"

#include <cmath>

// This file is compiled once for each kind of vectors, and what runs is chosen by the machine.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Lattice/KernelsBeam.cxx"
#include <hwy/foreach_target.h>

#include "Lattice/CellCubics-inl.h"
#include "Lattice/KernelsBeamTree-inl.h"
#include "Lattice/KernelsHull-inl.h"
#include "Lattice/KernelsLattice-inl.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace BeamKernels
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

/// Tests cells against the rays of a beam, and records certain hits and open cells.
/// \tparam IsPlain TileBeam::IsPlain
/// \tparam Lattice tells where cells lie (KernelsLattice-inl.h)
template <bool IsPlain, class Lattice>
class CellSearch
{
public:
  using Box = typename Lattice::Cell;

  CellSearch(const BeamTask& task, const Lattice& places, BeamScene& scene, TileBeam& beam)
    : Task(task)
    , Places(places)
    , Scene(scene)
    , Beam(beam)
  {
  }

  /// Test cells of a leaf, one bit each in the order in which the beam meets them.
  HWY_INLINE void TestCells(const glm::ivec3& leaf, std::uint64_t cells)
  {
    VisitInOrder(this->Places, this->Beam, cells, leaf, 1,
      [&](const glm::ivec3& place) HWY_ATTR { this->TestCell(leaf + place); });
  }

  /// Let the scene decide the remaining cells.
  void Decide() { this->Scene.Decide(this->Open, this->Beam); }

private:
  /// Find the rays that pass a cell in front of their certain hits, and search the cell for them.
  void TestCell(const glm::ivec3& cell)
  {
    TileBeam& beam = this->Beam;
    const Box box = this->Places.CellAt(cell);
    const CellFaces faces(box, beam.Margin, beam.Flip);
    // Test all vectors first, without branches, which would be hard to predict.
    float enter[RayBatch::Capacity], leave[RayBatch::Capacity];
    std::uint64_t passing = 0;
    for (std::size_t i = 0; i < RayBatch::Capacity; i += hn::Lanes(Floats()))
    {
      Interval passed = this->Pass(faces, i);
      passing |= BitsOf(this->Passes(passed, i)) << i;
      hn::StoreU(passed.Enter, Floats(), enter + i);
      hn::StoreU(passed.Leave, Floats(), leave + i);
    }
    if (passing == 0)
    {
      return;
    }
    CellValues values;
    const std::int32_t number = this->Scene.Read(cell, values);
    // Single precision decides nothing in a cell that is too thin.
    constexpr float most = 0x1p-5f;
    if (!(beam.Margin * box.LargestShare() < most))
    {
      values.SetUnknown();
    }
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
      isMet |= this->SearchCell(values, box, passed, isPassed, number, i);
    }
    if (number == BeamScene::MostCells - 1 || this->Open.Count > RayBatch::Capacity)
    {
      this->Scene.Decide(this->Open, beam);
      isMet = true;
    }
    if (isMet)
    {
      MoveAcrossIfNearer(beam);
    }
  }

  /// The intervals of a vector of rays in a cell. A ray that begins or ends inside the cell gets
  /// the interval of the infinite line.
  HWY_INLINE Interval Pass(const CellFaces& faces, std::size_t i) const
  {
    const TileBeam& beam = this->Beam;
    return IsPlain ? FindPlainInterval(faces, beam, i)
                   : FindInterval<false>(faces, beam.Origin, beam.Inverse, i);
  }

  /// Selects the rays of a vector that pass a cell in front of their certain hits.
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

  /// Search a cell for some rays.
  /// \return true if a ray has a certain hit in the cell
  HWY_INLINE bool SearchCell(const CellValues& values, const Box& box, const Interval& passed,
    M isPassed, std::int32_t number, std::size_t i)
  {
    const TileBeam& beam = this->Beam;
    const V zero = hn::Zero(Floats());
    const V enter = hn::IfThenElse(isPassed, passed.Enter, zero);
    const V leave = hn::IfThenElse(isPassed, passed.Leave, zero);
    V at[3], step[3];
    FindPathsIn(box, beam, enter, leave, i, at, step);
    const Coefficients b = CubicsAlong(values, at, step);
    M isOpen = hn::Lt(zero, zero);
    for (const float isovalue : this->Task.Isovalues)
    {
      const float error = this->ErrorIn(values, box, isovalue);
      const M isBelow = hn::Lt(b.Largest, Set(isovalue - error));
      const M isAbove =
        this->Task.IsSolid ? hn::Lt(zero, zero) : hn::Gt(b.Smallest, Set(isovalue + error));
      isOpen = hn::Or(isOpen, hn::AndNot(hn::Or(isBelow, isAbove), isPassed));
    }
    if (hn::AllFalse(Floats(), isOpen))
    {
      return false;
    }
    return this->KeepCell(b, values, box, { enter, leave }, isOpen, number, i);
  }

  /// Error bound of the coefficients in a cell. A coefficient is a mean of interpolant values at
  /// points that take each coordinate from the path's begin or end. Coordinates err by at most the
  /// margin. For begin and end alike, an error changes the value by at most twice the largest
  /// corner along each of three axes. Rounding adds 2^-24 of numbers below 27 times the largest
  /// corner in 30 operations. Full precision and the conversion to single lose less than that
  /// again.
  HWY_INLINE float ErrorIn(const CellValues& values, const Box& box, float isovalue) const
  {
    const float margin = this->Beam.Margin * box.LargestShare();
    return (values.Largest + std::abs(isovalue)) * (16.0f * margin + 0x1p-13f) + 1e-30f;
  }

  /// Record a cell in which rays may meet a surface, as certain hits and open cells.
  HWY_INLINE bool KeepCell(const Coefficients& b, const CellValues& values, const Box& box,
    const Interval& searched, M isOpen, std::int32_t number, std::size_t i)
  {
    TileBeam& beam = this->Beam;
    const Floats d;
    const Integers di;
    const V margin = Set(2.0f * beam.Margin);
    // Inner bounds: the true entry and exit lie between them and the searched interval's ends.
    Interval sure;
    if (IsPlain)
    {
      const V slack = Load(&beam.Slack[i]);
      sure = { hn::Add(searched.Enter, slack), hn::Sub(searched.Leave, slack) };
    }
    else
    {
      sure = this->Pass(CellFaces(box, -beam.Margin, beam.Flip), i);
    }
    sure.Enter = hn::Max(sure.Enter, hn::Add(Load(&beam.Begin[i]), margin));
    sure.Leave = hn::Min(sure.Leave, hn::Sub(Load(&beam.End[i]), margin));
    // Along an axis of the cell the interpolant changes by at most twice the largest corner, and by
    // little more outside.
    const V slope = Set(2.25f * beam.Steepest * values.Largest * box.LargestShare());
    const V firstMoved = hn::Mul(slope, hn::Sub(sure.Enter, searched.Enter));
    const V lastMoved = hn::Mul(slope, hn::Sub(searched.Leave, sure.Leave));
    M isCrossed = hn::Lt(margin, margin);
    for (const float isovalue : this->Task.Isovalues)
    {
      const V error = Set(this->ErrorIn(values, box, isovalue)), level = Set(isovalue);
      const V firstError = hn::Add(error, firstMoved), lastError = hn::Add(error, lastMoved);
      const M beginsIn = hn::Gt(b.First, hn::Add(level, firstError));
      const M endsIn = hn::Gt(b.Last, hn::Add(level, lastError));
      const M beginsOut = hn::Lt(b.First, hn::Sub(level, firstError));
      const M endsOut = hn::Lt(b.Last, hn::Sub(level, lastError));
      const M falls = this->Task.IsSolid ? beginsIn : hn::And(beginsIn, endsOut);
      isCrossed = hn::Or(isCrossed, hn::Or(hn::And(beginsOut, endsIn), falls));
    }
    M isSure = hn::Lt(sure.Enter, sure.Leave);
    const V behind = Load(&beam.Behind[i]);
    if (!IsPlain)
    {
      // The walk must surely begin before the cell's exit and end after the cell's entry.
      const V begin = hn::Add(Load(&beam.WalkBegin[i]), margin);
      isSure = hn::And(
        isSure, hn::And(hn::Lt(begin, sure.Leave), hn::Lt(hn::Add(sure.Enter, margin), behind)));
    }
    const M isMet = hn::And(isOpen, hn::And(isCrossed, isSure));
    // Two certain hits are ordered by entry: the ray leaves one cell before it enters the other.
    const M isFirst = hn::And(isMet, hn::Lt(sure.Enter, behind));
    this->NoteOpen(BitsOf(hn::AndNot(isMet, isOpen)), searched.Enter, number, i);
    if (hn::AllFalse(d, isFirst))
    {
      return false;
    }
    // The first cell with a surface holds the hit, so cells entered later lie behind it.
    hn::StoreU(hn::IfThenElse(isFirst, sure.Enter, behind), d, &beam.Behind[i]);
    hn::StoreU(hn::IfThenElse(
                 hn::RebindMask(di, isFirst), hn::Set(di, number), hn::LoadU(di, &beam.Cell[i])),
      di, &beam.Cell[i]);
    return true;
  }

  /// Add cells that single precision cannot decide to the scene's list.
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

  const BeamTask& Task;
  const Lattice& Places;
  BeamScene& Scene;
  TileBeam& Beam;
  OpenCells Open;
};

template <bool IsPlain, class Lattice>
void SearchIn(const Lattice& lattice, const BeamTask& task, BeamScene& scene, TileBeam& beam)
{
  using Cells = CellSearch<IsPlain, Lattice>;
  Cells cells(task, lattice, scene, beam);
  BeamTree<Cells, Lattice>(task.Active, scene, lattice, beam, cells).Visit();
  cells.Decide();
}

template <class Lattice>
void SearchAny(const Lattice& lattice, const BeamTask& task, BeamScene& scene, TileBeam& beam)
{
  if (beam.IsPlain)
  {
    SearchIn<true>(lattice, task, scene, beam);
    return;
  }
  SearchIn<false>(lattice, task, scene, beam);
}

void Search(const BeamTask& task, BeamScene& scene, TileBeam& beam)
{
  if (task.Grid)
  {
    SearchAny(RectilinearLattice(beam, *task.Grid), task, scene, beam);
    return;
  }
  SearchAny(UniformLattice(beam), task, scene, beam);
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
