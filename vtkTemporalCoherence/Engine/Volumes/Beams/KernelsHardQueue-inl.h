// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// A queue of a beam's hard cell segments, to be integrated in full vectors. Kernels include this
// file once for each kind of vectors, hence the toggling guard.
#if defined(TemporalCoherence_KernelsHardQueue_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef TemporalCoherence_KernelsHardQueue_inl_h
#undef TemporalCoherence_KernelsHardQueue_inl_h
#else
#define TemporalCoherence_KernelsHardQueue_inl_h
#endif

#include "Volumes/Beams/KernelsBeamPaths-inl.h"
#include "Volumes/Medium/KernelsHardSegments-inl.h"
#include "Volumes/Medium/KernelsSeenParts-inl.h"
#include "Volumes/Medium/VolumeCell.h"

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

/// Collects segments, and integrates them in full vectors.
template <std::size_t Colors>
class HardQueue
{
public:
  HardQueue(const EmittingVolume& volume, const SegmentsKernels::SeenBins& seen,
    const LitRays& rays, const VolumeCell* cells, LeafSums& sums)
    : Volume(volume)
    , Seen(seen)
    , Rays(rays)
    , Cells(cells)
    , Sums(sums)
  {
  }

  HWY_INLINE void Append(M which, const CellPaths& paths)
  {
    const Floats d;
    const Integers di;
    const auto add = [&](V value, SegmentsKernelArray& array) HWY_ATTR
    { hn::StoreU(hn::Compress(value, which), d, &array[this->Count]); };
    add(paths.Enter, this->Enter);
    add(paths.Length, this->Length);
    add(paths.Shown, this->Shown);
    for (std::size_t a = 0; a < 3; ++a)
    {
      add(paths.Begin[a], this->Begin[a]);
      add(paths.Across[a], this->Across[a]);
    }
    AppendNumbers(which, paths.Ray, &this->Ray[this->Count]);
    AppendNumbers(which, paths.Slot, &this->Slot[this->Count]);
    hn::StoreU(hn::Set(di, paths.CellNumber), di, &this->Cell[this->Count]);
    this->Count += hn::CountTrue(d, which);
    if (this->Count > VolumeSegments::Capacity - WidestVector)
    {
      this->Sum();
    }
  }

  /// Integrate the queued segments, and store their light in their slots.
  HWY_NOINLINE void Sum()
  {
    if (this->Count == 0)
    {
      return;
    }
    VolumeSegments segments;
    this->FindSegments(segments);
    this->Count = 0;
    if (segments.Count == 0)
    {
      return;
    }
    segments.FillLastVector();
    SegmentSums sums;
    HardSegments<Colors> hard;
    const auto count = static_cast<std::size_t>(segments.Count);
    const auto placeOf = [&](std::size_t i)
    { return static_cast<std::size_t>(segments.Cell[1][i]); };
    SegmentsKernelArray ofSegments;
    for (std::size_t i = 0; i < WholeVectors(count); ++i)
    {
      ofSegments[i] = i < count ? this->Shown[placeOf(i)] : 0.0f;
    }
    for (std::size_t i = 0; i < count; i += hn::Lanes(Floats()))
    {
      const CornerGradients corners = this->Volume.HasGradients()
        ? CornerGradients(this->Cells, PlacesOf(&segments.Cell[0][i]).All)
        : CornerGradients();
      const V shown = hn::LoadU(Floats(), &ofSegments[i]);
      AddInOneStep<Colors>(this->Volume, this->Rays, segments, i, corners, shown, hard, sums);
    }
    for (std::size_t i = 0; i < hard.Count; ++i)
    {
      hard.Shown[i] = ofSegments[static_cast<std::size_t>(hard.Number[i])];
    }
    AddHard(this->Volume, this->Rays, segments, hard, sums);
    for (std::size_t i = 0; i < count; ++i)
    {
      const auto slot = static_cast<std::size_t>(this->Slot[placeOf(i)]);
      this->Sums.Passed[slot] = sums.Passed[i];
      this->Sums.First[slot] = sums.First[i];
      for (std::size_t a = 0; a < 3; ++a)
      {
        this->Sums.Color[a][slot] = sums.Color[a][i];
      }
    }
  }

private:
  using SegmentsKernelArray = VolumeSegments::Array<float>;

  /// Places of cells in their list, in floats.
  struct PlacesOf
  {
    HWY_INLINE explicit PlacesOf(const std::int32_t* cells)
    {
      constexpr auto size = static_cast<std::int32_t>(sizeof(VolumeCell) / sizeof(float));
      const Integers di;
      hn::StoreU(hn::Mul(hn::LoadU(di, cells), hn::Set(di, size)), di, this->All);
    }
    std::int32_t All[WidestVector];
  };

  /// Zero the unused lanes of the last vector.
  void FillLastVector()
  {
    const auto fill = [this](auto& array) { std::fill_n(&array[this->Count], WidestVector, 0); };
    fill(this->Ray);
    fill(this->Cell);
    fill(this->Enter);
    fill(this->Length);
    for (std::size_t a = 0; a < 3; ++a)
    {
      fill(this->Begin[a]);
      fill(this->Across[a]);
    }
  }

  /// Find the visible parts. Cell[0] of a part is the index of its cell, Cell[1] the index of its
  /// segment in the queue.
  void FindSegments(VolumeSegments& segments)
  {
    const Floats d;
    const Integers di;
    this->FillLastVector();
    for (std::size_t i = 0; i < this->Count; i += hn::Lanes(d))
    {
      SegmentsKernels::HWY_NAMESPACE::SegmentsOfCells of;
      of.Enter = hn::LoadU(d, &this->Enter[i]);
      of.Length = hn::LoadU(d, &this->Length[i]);
      for (std::size_t a = 0; a < 3; ++a)
      {
        of.Begin[a] = hn::LoadU(d, &this->Begin[a][i]);
        of.Across[a] = hn::LoadU(d, &this->Across[a][i]);
      }
      V corners[8];
      const PlacesOf places(&this->Cell[i]);
      LoadRows(this->Cells->Values.data(), places.All, corners);
      LoadRows(this->Cells->Values.data() + 4, places.All, corners + 4);
      of.Values = Cubics::HWY_NAMESPACE::CubicAlong(corners, of.Begin, of.Across);
      std::int32_t own[WidestVector];
      hn::StoreU(hn::Iota(di, static_cast<std::int32_t>(i)), di, own);
      const std::int32_t* const numbers[3] = { &this->Cell[i], own, own };
      SegmentsKernels::HWY_NAMESPACE::AppendSeen(
        hn::FirstN(d, this->Count - i), of, numbers, &this->Ray[i], this->Seen, segments);
    }
  }

  const EmittingVolume& Volume;
  const SegmentsKernels::SeenBins& Seen;
  const LitRays& Rays;
  const VolumeCell* Cells;
  LeafSums& Sums;
  std::size_t Count = 0;
  VolumeSegments::Array<std::int32_t> Ray, Slot, Cell;
  SegmentsKernelArray Enter, Length, Shown;
  std::array<SegmentsKernelArray, 3> Begin, Across;
};

}
}
}
HWY_AFTER_NAMESPACE();

#endif
