// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Passages/PassageBeam.h"

#include "Isomap/Knots.h"

#include <algorithm>
#include <limits>

// This file is compiled once for each kind of vectors, and what runs is chosen by the machine.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Passages/KernelsPassageBeam.cxx"
#include <hwy/foreach_target.h>

#include "Beams/KernelsBeamTree-inl.h"
#include "Beams/KernelsCellStays-inl.h"
#include "Beams/KernelsHull-inl.h"

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace BeamKernels
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

/// Finds passages of the rays of a beam in cells.
/// \tparam IsPlain that of the beam
/// \tparam Lattice tells where cells lie (KernelsLattice-inl.h)
template <bool IsPlain, class Lattice>
class PassageCells
{
public:
  PassageCells(const PassageTask& task, const Lattice& places, PassageScene& scene, TileBeam& beam)
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

private:
  void TestCell(const glm::ivec3& cell)
  {
    const typename Lattice::Cell box = this->Places.CellAt(cell);
    const std::uint64_t passing = FindStays<IsPlain>(box, this->Beam, this->Stays);
    if (passing == 0)
    {
      return;
    }
    this->Beam.CellsPassed += static_cast<std::int64_t>(hwy::PopCount(passing));
    this->Scene.Read(cell, this->Values);
    const std::uint64_t found = this->FindKeys(box, passing);
    const std::uint64_t done = found != 0 ? this->Scene.Store(cell, found, this->Keys) : 0;
    for (std::uint64_t left = done; left != 0; left &= left - 1)
    {
      this->Beam.Behind[hwy::Num0BitsBelowLS1Bit_Nonzero64(left)] = -TileBeam::Never;
    }
    if (done != 0)
    {
      MoveAcrossIfNearer(this->Beam);
    }
  }

  /// Find the keys of the lowest and highest value of some rays in a cell, rounded outwards.
  /// \return one bit for each ray that may pass an isovalue of the band
  HWY_INLINE std::uint64_t FindKeys(const typename Lattice::Cell& box, std::uint64_t passing)
  {
    const float margin = this->Beam.Margin * box.LargestShare();
    constexpr float most = 0x1p-5f;
    if (this->Values.IsAny || this->Task.HasCaps || !(margin < most))
    {
      this->Keys.Low.fill(0);
      this->Keys.High.fill(std::numeric_limits<PassageKey>::max());
      return passing;
    }
    // What LayerCells allows for each isovalue, and more for the rounding of differences between
    // isovalues.
    const float error = 16.0f * margin + 0x1.2p-13f;
    std::uint64_t found = 0;
    for (std::size_t i = 0; i < RayBatch::Capacity; i += hn::Lanes(Floats()))
    {
      constexpr std::size_t lanes = hn::MaxLanes(Floats());
      const std::uint64_t which = passing >> i & ((std::uint64_t(1) << lanes) - 1);
      if (which != 0)
      {
        found |= this->FindKeysOf(box, MaskOf(which), Set(error), i) << i;
      }
    }
    return found;
  }

  HWY_INLINE std::uint64_t FindKeysOf(
    const typename Lattice::Cell& box, M isPassed, V error, std::size_t i)
  {
    const V enter = hn::IfThenElseZero(isPassed, Load(this->Stays.Enter + i));
    const V leave = hn::IfThenElseZero(isPassed, Load(this->Stays.Leave + i));
    V at[3], step[3];
    FindPathsIn(box, this->Beam, enter, leave, i, at, step);
    const Coefficients b = CubicsAlong(this->Values.Values, at, step);
    constexpr auto slack = static_cast<float>(KeySlack);
    constexpr auto last = static_cast<float>(BandScale::LargestInKeys);
    const V keys = Set(this->Values.KeysPerUnit), zero = Set(0.0f);
    const V low = hn::Sub(hn::Mul(hn::Sub(b.Smallest, error), keys), Set(slack));
    const V high = hn::Add(hn::Mul(hn::Add(b.Largest, error), keys), Set(slack));
    const M isOutside = hn::Or(hn::Lt(high, zero), hn::Gt(low, Set(last)));
    M isFound = hn::AndNot(isOutside, isPassed);
    if (IsPlain && this->Task.IsSolid)
    {
      isFound = hn::AndNot(CanOnlyExit(this->Beam, b, error, enter, leave, i), isFound);
    }
    const Integers d;
    hn::StoreU(hn::ConvertTo(d, hn::Min(hn::Max(low, zero), Set(last))), d, &this->Keys.Low[i]);
    hn::StoreU(hn::ConvertTo(d, hn::Min(hn::Max(high, zero), Set(last))), d, &this->Keys.High[i]);
    return BitsOf(isFound);
  }

  const PassageTask& Task;
  const Lattice& Places;
  PassageScene& Scene;
  TileBeam& Beam;

  // Of the present cell:
  PassedCell Values;
  PassedKeys Keys;
  CellStays Stays;
};

template <bool IsPlain, class Lattice>
void SearchPassagesIn(
  const Lattice& lattice, const PassageTask& task, PassageScene& scene, TileBeam& beam)
{
  using Search = PassageCells<IsPlain, Lattice>;
  Search search(task, lattice, scene, beam);
  BeamTree<Search, Lattice>(task.Active, scene, lattice, beam, search).Visit();
}

void SearchPassages(const PassageTask& task, PassageScene& scene, TileBeam& beam)
{
  if (task.Grid)
  {
    SearchPassagesIn<false>(RectilinearLattice(beam, *task.Grid), task, scene, beam);
    return;
  }
  const UniformLattice lattice(beam);
  beam.IsPlain ? SearchPassagesIn<true>(lattice, task, scene, beam)
               : SearchPassagesIn<false>(lattice, task, scene, beam);
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
HWY_EXPORT(SearchPassages);
}

void FindPassages(const PassageTask& task, PassageScene& scene, TileBeam& beam)
{
  using namespace BeamKernels;
  HWY_DYNAMIC_DISPATCH(SearchPassages)(task, scene, beam);
}

}
#endif
