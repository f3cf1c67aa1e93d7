// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Volumes/Beams/CompositeBeam.h"

#include "Lattice/KernelsBeam.h"
#include "Volumes/Medium/VolumeCell.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#ifndef TemporalCoherence_BlendRays // this file is included once for each kind of vectors
#define TemporalCoherence_BlendRays
namespace TemporalCoherence
{
namespace EmissionKernels
{

/// The rays of a beam, in its coordinates.
struct BlendRays
{
  template <typename T>
  using Array = RayBatch::Array<T>;

  std::array<Array<float>, 3> Inverse; ///< finite
  Array<float> Begin, End;             ///< t of the beam
  Array<float> Shown;                  ///< transmittance so far
  Array<float> Off;                    ///< error of the light so far
};

}
}
#endif

// This file is compiled once for each kind of vectors, and what runs is chosen by the machine.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Volumes/Beams/KernelsCompositeBeam.cxx"
#include <hwy/foreach_target.h>

#include "Lattice/KernelsBeamTree-inl.h"
#include "Lattice/KernelsHull-inl.h"
#include "Volumes/Beams/KernelsArcs-inl.h"
#include "Volumes/Beams/KernelsBeamPaths-inl.h"
#include "Volumes/Beams/KernelsEvenLight-inl.h"
#include "Volumes/Medium/KernelsHardSegments-inl.h"
#include "Volumes/Medium/KernelsSeenParts-inl.h"

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace EmissionKernels
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;
namespace beams = BeamKernels::HWY_NAMESPACE;

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

/// Adds the light of cells to the rays of a beam.
template <std::size_t Colors>
class CellBlender
{
public:
  CellBlender(const BeamVolume& volume, const LitRays& lit, const beams::UniformLattice& lattice,
    TileBeam& beam, BlendRays& rays, BlendedRays& seen)
    : Volume(volume)
    , Emitting(volume.Emitting)
    , Lattice(lattice)
    , Beam(beam)
    , Rays(rays)
    , Seen(seen)
    , PerScale(static_cast<float>(1.0 / beam.Scale))
    , Shader(volume.Emitting, lit,
        std::max({ volume.NumberOfCells.x, volume.NumberOfCells.y, volume.NumberOfCells.z }))
    , Queue(volume.Emitting, volume.Seen, lit, this->Cells.data(), this->Sums)
    , OnArcs(volume.Emitting, volume.Arcs, lit, this->Sums)
  {
  }

  /// \param cells of the leaf, one bit each; visited from front to back
  void TestCells(const glm::ivec3& leaf, std::uint64_t cells)
  {
    this->NumberOfCells = 0;
    this->NumberOfVectors = 0;
    beams::VisitInOrder(this->Lattice, this->Beam, cells, leaf, 1,
      [&](const glm::ivec3& place) HWY_ATTR { this->TestCell(leaf + place); });
    this->FinishLeaf();
  }

private:
  static constexpr std::size_t CellsOfLeaf = 64;
  /// Cells that span more arcs use the tables. CPU times with 5, 6 and 7: engine with thin peaks
  /// 956, 1325, 1339 ms, vessels with skin 846, 853, 706.
  static constexpr std::size_t MostArcsOfCell = 5;

  void TestCell(const glm::ivec3& cell)
  {
    const Floats d;
    const beams::UniformLattice::Cell box = this->Lattice.CellAt(cell);
    const beams::CellFaces faces(box, 0.0f, this->Beam.Flip);
    float enters[RayBatch::Capacity], leaves[RayBatch::Capacity];
    std::uint64_t passing = 0;
    for (std::size_t i = 0; i < RayBatch::Capacity; i += hn::Lanes(d))
    {
      const auto in = beams::FindInterval(faces, this->Beam.Origin, this->Rays.Inverse, i);
      const V enter = hn::Max(hn::LoadU(d, &this->Rays.Begin[i]), in.Enter);
      const V leave = hn::Min(hn::LoadU(d, &this->Rays.End[i]), in.Leave);
      const V shown = hn::LoadU(d, &this->Rays.Shown[i]);
      const M passes = hn::And(hn::Lt(enter, leave), hn::Gt(shown, hn::Set(d, LeastPassed)));
      passing |= beams::BitsOf(passes) << i;
      hn::StoreU(enter, d, enters + i);
      hn::StoreU(leave, d, leaves + i);
    }
    EvenCell even;
    if (passing == 0 || !this->Read(cell, even))
    {
      return;
    }
    constexpr std::size_t lanes = hn::MaxLanes(Floats());
    for (std::size_t i = 0; i < RayBatch::Capacity; i += lanes)
    {
      const std::uint64_t these = passing >> i & ((std::uint64_t(1) << lanes) - 1);
      if (these != 0)
      {
        this->AddVector(
          even, box, beams::MaskOf(these), hn::LoadU(d, enters + i), hn::LoadU(d, leaves + i), i);
      }
    }
  }

  /// \return false if the cell is invisible
  HWY_INLINE bool Read(const glm::ivec3& place, EvenCell& even)
  {
    VolumeCell& cell = this->Cells[this->NumberOfCells];
    this->Volume.Cells.Read(place, cell);
    ++this->Seen.CellsRead;
    if (!even.Set(this->Emitting, cell))
    {
      return false;
    }
    ++this->NumberOfCells;
    return true;
  }

  HWY_INLINE void AddVector(const EvenCell& cell, const beams::UniformLattice::Cell& box, M passes,
    V enter, V leave, std::size_t i)
  {
    const Floats d;
    const V none = hn::Zero(d), one = hn::Set(d, 1.0f);
    enter = hn::IfThenElse(passes, enter, none);
    leave = hn::IfThenElse(passes, leave, none);
    const V scale = hn::Set(d, this->PerScale), length = hn::Sub(leave, enter);
    CellPaths paths;
    paths.Enter = hn::Mul(hn::Sub(enter, hn::LoadU(d, &this->Rays.Begin[i])), scale);
    paths.Length = hn::Mul(length, scale);
    for (std::size_t a = 0; a < 3; ++a)
    {
      const V direction = hn::LoadU(d, &this->Beam.Direction[a][i]);
      const V origin = hn::Sub(hn::LoadU(d, &this->Beam.Origin[a][i]), hn::Set(d, box.Low(a)));
      paths.Begin[a] = hn::Add(origin, hn::Mul(enter, direction));
      paths.Across[a] = hn::Mul(length, direction);
    }
    paths.Shown = hn::LoadU(d, &this->Rays.Shown[i]);
    paths.Off = hn::LoadU(d, &this->Rays.Off[i]);
    paths.Ray = i;
    EvenLight light = this->Shader.FindLight(cell, passes, paths);
    const M isHard = hn::AndNot(light.IsRight, passes);
    const bool isAnyHard = !hn::AllFalse(d, isHard);
    const V off = hn::IfThenElseZero(hn::And(light.IsEven, passes), light.Off);
    hn::StoreU(hn::Add(paths.Off, off), d, &this->Rays.Off[i]);
    light.IsRight = hn::And(light.IsRight, passes);
    const V passed = hn::IfThenElse(hn::And(light.IsEven, passes), light.Passed, one);
    light.Passed = hn::IfThenElse(light.IsRight, light.Passed, one);
    for (V& color : light.Color)
    {
      color = hn::IfThenElseZero(light.IsRight, color);
    }
    if (isAnyHard || this->NumberOfVectors > 0)
    {
      this->Keep(cell, light, paths, isHard, isAnyHard);
    }
    else
    {
      this->Composite(light, paths);
    }
    hn::StoreU(hn::Mul(paths.Shown, passed), d, &this->Rays.Shown[i]);
  }

  /// Composite light at once, as no light waits in front of it.
  HWY_INLINE void Composite(const EvenLight& light, const CellPaths& paths)
  {
    const Floats d;
    const std::size_t i = paths.Ray;
    for (std::size_t a = 0; a < 3; ++a)
    {
      float* const color = &this->Seen.Color[a][i];
      hn::StoreU(hn::Add(hn::LoadU(d, color), hn::Mul(paths.Shown, light.Color[a])), d, color);
    }
    float* const passed = &this->Seen.Passed[i];
    hn::StoreU(hn::Mul(hn::LoadU(d, passed), light.Passed), d, passed);
    const M isFirst = hn::And(light.IsRight, IsSeenFirst(light.Depth, paths.Shown));
    if (!hn::AllFalse(d, isFirst))
    {
      this->NoteFirst(isFirst, light.CentreOf(paths), i);
    }
  }

  /// Record the first visible points of some rays of a vector.
  HWY_INLINE void NoteFirst(M which, V first, std::size_t i)
  {
    float places[WidestVector];
    hn::StoreU(first, Floats(), places);
    for (std::uint64_t left = beams::BitsOf(which); left != 0; left &= left - 1)
    {
      const std::size_t lane = hwy::Num0BitsBelowLS1Bit_Nonzero64(left);
      double& at = this->Seen.First[i + lane];
      at = std::min(at, static_cast<double>(places[lane]));
    }
  }

  static HWY_INLINE M IsSeenFirst(V depth, V shown)
  {
    const Floats d;
    return hn::And(
      hn::Gt(depth, hn::Set(d, LeastSeen)), hn::Gt(shown, hn::Set(d, 1.0f - LeastSeen)));
  }

  /// Store light until the queued paths in front of it are integrated.
  HWY_INLINE void Keep(
    const EvenCell& cell, const EvenLight& light, CellPaths& paths, M isHard, bool isAnyHard)
  {
    const Floats d;
    paths.Slot = this->NumberOfVectors * hn::Lanes(d);
    this->RaysOf[this->NumberOfVectors++] = static_cast<std::uint8_t>(paths.Ray);
    hn::StoreU(light.Passed, d, &this->Sums.Passed[paths.Slot]);
    for (std::size_t a = 0; a < 3; ++a)
    {
      hn::StoreU(light.Color[a], d, &this->Sums.Color[a][paths.Slot]);
    }
    V first = hn::Set(d, SegmentSums::Never);
    const M isFirst = hn::And(light.IsRight, IsSeenFirst(light.Depth, paths.Shown));
    if (!hn::AllFalse(d, isFirst))
    {
      first = hn::IfThenElse(isFirst, light.CentreOf(paths), first);
    }
    hn::StoreU(first, d, &this->Sums.First[paths.Slot]);
    if (isAnyHard)
    {
      paths.CellNumber = static_cast<std::int32_t>(this->NumberOfCells) - 1;
      this->AppendHard(cell, isHard, paths);
    }
  }

  /// Queue hard paths. Paths in cells with few arcs are integrated along these; where the function
  /// bends more often within a cell, tables of its integral take fewer steps.
  HWY_INLINE void AppendHard(const EvenCell& cell, M isHard, const CellPaths& paths)
  {
    const EmissionArcs& all = this->Volume.Arcs;
    const ArcRange arcs{ all.ArcOf(cell.Emitted.Low), all.ArcOf(cell.Emitted.High) };
    const bool isGradual = this->Emitting.ByGradient.Opacities.empty();
    if (isGradual && arcs.Last - arcs.First < MostArcsOfCell &&
      !all.AreRough(arcs.First, arcs.Last))
    {
      this->OnArcs.Append(isHard, cell, arcs, paths);
      return;
    }
    this->Queue.Append(isHard, paths);
  }

  /// Composite the stored light, and drop rays without transmittance left.
  void FinishLeaf()
  {
    const Floats d;
    if (this->NumberOfVectors > 0)
    {
      this->Queue.Sum();
      this->OnArcs.Sum();
      for (std::size_t vector = 0; vector < this->NumberOfVectors; ++vector)
      {
        this->CompositeKept(vector * hn::Lanes(d), this->RaysOf[vector]);
      }
      this->Rays.Shown = ShownBy(this->Seen, this->Rays);
    }
    if (this->NumberOfCells > 0)
    {
      for (std::size_t i = 0; i < RayBatch::Capacity; ++i)
      {
        this->Beam.Behind[i] =
          this->Rays.Shown[i] > LeastPassed ? this->Beam.Behind[i] : -TileBeam::Never;
      }
      beams::MoveAcrossIfNearer(this->Beam);
    }
  }

  static RayBatch::Array<float> ShownBy(const BlendedRays& seen, const BlendRays& rays)
  {
    RayBatch::Array<float> shown;
    for (std::size_t i = 0; i < shown.size(); ++i)
    {
      shown[i] = rays.Begin[i] < rays.End[i] ? seen.Passed[i] : 0.0f;
    }
    return shown;
  }

  HWY_INLINE void CompositeKept(std::size_t slot, std::size_t i)
  {
    const Floats d;
    const V shown = hn::LoadU(d, &this->Seen.Passed[i]);
    const M isOn = hn::Gt(shown, hn::Set(d, LeastPassed));
    for (std::size_t a = 0; a < 3; ++a)
    {
      float* const color = &this->Seen.Color[a][i];
      const V more = hn::Mul(shown, hn::LoadU(d, &this->Sums.Color[a][slot]));
      hn::StoreU(hn::Add(hn::LoadU(d, color), hn::IfThenElseZero(isOn, more)), d, color);
    }
    const V left = hn::Mul(shown, hn::LoadU(d, &this->Sums.Passed[slot]));
    hn::StoreU(hn::IfThenElse(isOn, left, shown), d, &this->Seen.Passed[i]);
    const V first = hn::LoadU(d, &this->Sums.First[slot]);
    const M isFirst = hn::And(
      hn::Gt(shown, hn::Set(d, 1.0f - LeastSeen)), hn::Lt(first, hn::Set(d, SegmentSums::Never)));
    this->NoteFirst(isFirst, first, i);
  }

  const BeamVolume& Volume;
  const EmittingVolume& Emitting;
  const beams::UniformLattice& Lattice;
  TileBeam& Beam;
  BlendRays& Rays;
  BlendedRays& Seen;
  float PerScale; ///< from t of the beam to t of rays
  EvenShader<Colors> Shader;

  // Work on the present leaf:
  std::size_t NumberOfCells = 0, NumberOfVectors = 0;
  std::array<VolumeCell, CellsOfLeaf> Cells;
  std::array<std::uint8_t, LeafSums::Slots / hn::MaxLanes(Floats())> RaysOf;
  LeafSums Sums;
  HardQueue<Colors> Queue;
  ArcQueue<Colors> OnArcs;
};

template <std::size_t Colors>
void BlendColors(
  const BeamVolume& volume, const LitRays& lit, TileBeam& beam, BlendRays& rays, BlendedRays& seen)
{
  using Blender = CellBlender<Colors>;
  const beams::UniformLattice lattice(beam);
  Blender blender(volume, lit, lattice, beam, rays, seen);
  beams::BeamTree<Blender, beams::UniformLattice>(
    volume.Active, volume.Cells, lattice, beam, blender)
    .Visit();
}

void Blend(
  const BeamVolume& volume, const LitRays& lit, TileBeam& beam, BlendRays& rays, BlendedRays& seen)
{
  if (volume.Emitting.HasColoredLights())
  {
    BlendColors<3>(volume, lit, beam, rays, seen);
    return;
  }
  BlendColors<1>(volume, lit, beam, rays, seen);
}

}
}
}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace TemporalCoherence
{
namespace EmissionKernels
{
HWY_EXPORT(Blend);

/// Move a coordinate on a face between cells, or on the boundary, into an adjacent cell.
/// \param first, last faces of the field
float WithinCells(float place, float first, float last, float margin)
{
  const float inside = std::min(std::max(place, first + margin), last - margin);
  return inside == std::floor(inside) ? inside + margin : inside;
}

void SetUpRays(const RayBatch& rays, std::uint64_t which, const glm::ivec3& cells,
  const BlendedRays& seen, TileBeam& beam, BlendRays& made)
{
  // A ray that runs along faces crosses none of them: a ray in a face belongs to an adjacent cell.
  constexpr float farthest = 1e25f, along = 1e6f;
  for (std::size_t i = 0; i < RayBatch::Capacity; ++i)
  {
    const bool isRay = which >> i & 1u;
    for (std::size_t a = 0; a < 3; ++a)
    {
      const auto axis = static_cast<int>(a);
      const float inverse = beam.Inverse[a][i];
      made.Inverse[a][i] = std::min(std::max(inverse, -farthest), farthest);
      if (std::abs(inverse) > along)
      {
        const auto first = static_cast<float>(-beam.Anchor[axis]);
        const auto last = static_cast<float>(cells[axis] - beam.Anchor[axis]);
        beam.Origin[a][i] = WithinCells(beam.Origin[a][i], first, last, beam.Margin);
      }
    }
    made.Begin[i] = isRay ? beam.DistanceOf(rays.Begin[i]) : 0.0f;
    made.End[i] = isRay ? beam.DistanceOf(rays.End[i]) : 0.0f;
    made.Shown[i] = isRay ? seen.Passed[i] : 0.0f;
    made.Off[i] = 0.0f;
  }
}
}

bool BlendBeam(const BeamVolume& volume, const RayBatch& rays, const BeamRays& which,
  const EmissionKernels::LitRays& lit, BlendedRays& seen)
{
  using namespace EmissionKernels;
  TileBeam beam;
  if (!SetUpBeam(rays, which.All, volume.NumberOfCells, beam) || !beam.AreAlike)
  {
    return false;
  }
  BlendRays made;
  SetUpRays(rays, which.Walking, volume.NumberOfCells, seen, beam, made);
  HWY_DYNAMIC_DISPATCH(Blend)(volume, lit, beam, made, seen);
  return true;
}

}
#endif
