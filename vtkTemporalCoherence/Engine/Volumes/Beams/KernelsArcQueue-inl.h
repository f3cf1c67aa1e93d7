// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// A queue of beam paths, to be integrated along the arcs of a transfer function in full vectors.
// Kernels include this file once for each kind of vectors, hence the toggling guard.
#if defined(TemporalCoherence_KernelsArcQueue_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef TemporalCoherence_KernelsArcQueue_inl_h
#undef TemporalCoherence_KernelsArcQueue_inl_h
#else
#define TemporalCoherence_KernelsArcQueue_inl_h
#endif

#include "Volumes/Beams/KernelsArcSteps-inl.h"
#include "Volumes/Beams/KernelsBeamPaths-inl.h"
#include "Volumes/Beams/KernelsEvenCells-inl.h"
#include "Volumes/Medium/KernelsLaneWork-inl.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace EmissionKernels
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

/// A range of arcs, the last one included.
struct ArcRange
{
  std::size_t First, Last;
};

/// Collects paths, and integrates them in full vectors.
template <std::size_t Colors>
class ArcQueue
{
public:
  /// \param sums get the light of each path in its slot; the slots of paths that add nothing stay
  ///   as they are
  ArcQueue(
    const EmittingVolume& volume, const EmissionArcs& arcs, const LitRays& rays, LeafSums& sums)
    : Volume(volume)
    , All(arcs)
    , Rays(rays)
    , Sums(sums)
    , Steps(volume, arcs)
  {
  }

  /// \param arcs that the values of the cell span
  HWY_INLINE void Append(
    M which, const EvenCell& cell, const ArcRange& arcs, const CellPaths& through)
  {
    const Floats d;
    ArcPaths paths;
    paths.EachColumn([](V& value) HWY_ATTR { value = hn::Zero(Floats()); });
    paths.Enter = through.Enter;
    paths.Length = through.Length;
    paths.Shown = through.Shown;
    paths.Values = cell.Value.Along(through.Begin, through.Across);
    if (this->Volume.Lights)
    {
      for (std::size_t a = 0; a < 3; ++a)
      {
        paths.Toward.Along[a] = cell.Toward[a].Along(through.Begin, through.Across);
      }
    }
    paths.Turning = CubicTurns(paths.Values);
    paths.Arc = hn::Set(d, static_cast<float>(arcs.First));
    for (std::size_t arc = arcs.First; arc < arcs.Last; ++arc)
    {
      const M isAbove = hn::Gt(paths.Values.C[0], hn::Set(d, this->All.High[arc]));
      paths.Arc = hn::Add(paths.Arc, hn::IfThenElseZero(isAbove, hn::Set(d, 1.0f)));
    }
    const M isSeen = hn::And(which, this->LeaveEmptyArcs(which, paths));
    std::size_t column = 0;
    paths.EachColumn([&](V value) HWY_ATTR
      { hn::StoreU(hn::Compress(value, isSeen), d, &this->Columns[column++][this->Count]); });
    AppendNumbers(isSeen, through.Ray, &this->Ray[this->Count]);
    AppendNumbers(isSeen, through.Slot, &this->Slot[this->Count]);
    this->Count += hn::CountTrue(d, isSeen);
    if (this->Count > VolumeSegments::Capacity - WidestVector)
    {
      this->Sum();
    }
  }

  /// Integrate the queued paths, and store their light in their slots.
  HWY_NOINLINE void Sum()
  {
    if (this->Count == 0)
    {
      return;
    }
    this->FillLastVector();
    this->Next = 0;
    WorkThrough([&]() HWY_ATTR { return this->Steps.IsOn; },
      [&]() { return this->Next < this->Count; }, [&]() HWY_ATTR { this->Refill(); },
      [&]() HWY_ATTR { this->Steps.AddNext(this->Vectors); });
    this->StoreDone();
    this->Count = 0;
  }

private:
  template <typename T>
  using Array = VolumeSegments::Array<T>;

  /// Move the begin of paths in an empty arc to its end.
  /// \return paths with a share left
  HWY_INLINE M LeaveEmptyArcs(M which, ArcPaths& paths) const
  {
    const Floats d;
    const Arcs arcs(this->All, paths.Arc);
    const M isEmpty = hn::And(which, arcs.AreEmpty());
    if (!hn::AllFalse(d, isEmpty))
    {
      const ArcEnd end = paths.EndOf(arcs);
      paths.Begin = hn::IfThenElse(isEmpty, end.Share, paths.Begin);
      paths.Arc = hn::IfThenElse(isEmpty, end.Next, paths.Arc);
    }
    return hn::Lt(paths.Begin, hn::Set(d, 1.0f));
  }

  /// Give the next paths to idle lanes.
  HWY_NOINLINE void Refill()
  {
    this->StoreDone();
    const LaneWork::Taken taken = this->Work.Take(&this->Slot[this->Next], this->Count - this->Next,
      [&](std::size_t i) { return this->Ray[this->Next + i]; });
    std::size_t column = 0;
    this->Steps.Now.EachColumn(
      [&](V& value) HWY_ATTR { value = taken.Load(&this->Columns[column++][this->Next], value); });
    this->Vectors = RayVectors(this->Volume, this->Rays, this->Work.Rays());
    this->Next += taken.Count;
    this->Steps.Begin(taken.Which);
  }

  HWY_INLINE void StoreDone()
  {
    this->Work.Finish(this->Steps.IsOn, this->Steps.Added, this->Steps.Now.Enter,
      this->Steps.Now.Length, this->Sums);
  }

  /// Zero the unused lanes of the last vector.
  void FillLastVector()
  {
    std::fill_n(&this->Ray[this->Count], WidestVector, 0);
    std::fill_n(&this->Slot[this->Count], WidestVector, 0);
    for (auto& column : this->Columns)
    {
      std::fill_n(&column[this->Count], WidestVector, 0.0f);
    }
  }

  const EmittingVolume& Volume;
  const EmissionArcs& All;
  const LitRays& Rays;
  LeafSums& Sums;
  std::size_t Count = 0, Next = 0;
  Array<std::int32_t> Ray, Slot;
  std::array<Array<float>, ArcPaths::Columns> Columns;
  LaneWork Work;
  RayVectors Vectors;
  ArcSteps<Colors> Steps;
};

}
}
}
HWY_AFTER_NAMESPACE();

#endif
