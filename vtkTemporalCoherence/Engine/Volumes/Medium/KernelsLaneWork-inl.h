// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Distributes items that take different numbers of steps to the lanes of a vector. Kernels include
// this file once for each kind of vectors, hence the toggling guard.
#if defined(TemporalCoherence_KernelsLaneWork_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef TemporalCoherence_KernelsLaneWork_inl_h
#undef TemporalCoherence_KernelsLaneWork_inl_h
#else
#define TemporalCoherence_KernelsLaneWork_inl_h
#endif

#include "Volumes/Medium/KernelsEmission.h"
#include "Volumes/Medium/KernelsSteps-inl.h"

#include <algorithm>
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

/// Call addNext until all lanes are idle. Refill them whenever half of them are.
/// \param isOn    gives the mask of busy lanes
/// \param hasMore true while items are left
template <class IsOn, class HasMore, class Refill, class AddNext>
HWY_INLINE void WorkThrough(
  const IsOn& isOn, const HasMore& hasMore, const Refill& refill, const AddNext& addNext)
{
  const Floats d;
  const std::size_t few = hn::Lanes(d) / 2;
  while (true)
  {
    if (hasMore() && hn::CountTrue(d, isOn()) <= few)
    {
      refill();
    }
    if (hn::AllFalse(d, isOn()))
    {
      break;
    }
    addNext();
  }
}

/// Assigns the items of a list to the lanes of a vector, in order.
class LaneWork
{
public:
  LaneWork()
  {
    std::fill_n(this->Number, WidestVector, None);
    std::fill_n(this->RayOf, WidestVector, 0);
  }

  /// Store the light of finished lanes, and free these lanes.
  /// \param isOn busy lanes
  /// \param enter, length of the segments in the lanes
  /// \param sums has a place for each item
  template <class Sums>
  HWY_INLINE void Finish(M isOn, const AddedLight& added, V enter, V length, Sums& sums)
  {
    const Floats d;
    float passed[WidestVector], first[WidestVector], color[3][WidestVector];
    std::uint8_t isBusy[8] = {};
    hn::StoreMaskBits(d, isOn, isBusy);
    hn::StoreU(added.Passed, d, passed);
    hn::StoreU(added.FirstIn(enter, length), d, first);
    for (std::size_t a = 0; a < 3; ++a)
    {
      hn::StoreU(added.Color[a], d, color[a]);
    }
    for (std::size_t lane = 0; lane < hn::Lanes(d); ++lane)
    {
      if (this->Number[lane] == None || (isBusy[lane / 8] >> lane % 8 & 1u) != 0)
      {
        continue;
      }
      const auto number = static_cast<std::size_t>(this->Number[lane]);
      sums.Passed[number] = passed[lane];
      sums.First[number] = first[lane];
      for (std::size_t a = 0; a < 3; ++a)
      {
        sums.Color[a][number] = color[a][lane];
      }
      this->Number[lane] = None;
    }
  }

  /// New items of lanes.
  struct Taken
  {
    /// \param next  items in a column of the list
    /// \param value present column of the lanes
    HWY_INLINE V Load(const float* next, V value) const
    {
      const V all = hn::TableLookupLanes(hn::LoadU(Floats(), next), this->Ranks);
      return hn::IfThenElse(this->Which, all, value);
    }

    M Which; ///< lanes
    decltype(hn::SetTableIndices(Floats(), static_cast<const std::int32_t*>(nullptr))) Ranks;
    std::size_t Count;
  };

  /// Give the next items of the list to free lanes.
  /// \param numbers of the next items
  /// \param count   of items left
  /// \param rayOf   finds the ray of an item, by its index in `numbers`
  template <class RayOf>
  HWY_INLINE Taken Take(const std::int32_t* numbers, std::size_t count, const RayOf& rayOf)
  {
    const Floats d;
    std::int32_t ranks[WidestVector];
    std::uint8_t isNew[8] = {};
    std::size_t taken = 0;
    for (std::size_t lane = 0; lane < hn::Lanes(d); ++lane)
    {
      ranks[lane] = 0;
      if (this->Number[lane] == None && taken < count)
      {
        this->Number[lane] = numbers[taken];
        this->RayOf[lane] = rayOf(taken);
        ranks[lane] = static_cast<std::int32_t>(taken++);
        isNew[lane / 8] = static_cast<std::uint8_t>(isNew[lane / 8] | 1u << lane % 8);
      }
    }
    return { hn::LoadMaskBits(d, isNew), hn::SetTableIndices(d, ranks), taken };
  }

  /// The ray of each lane.
  const std::int32_t* Rays() const { return this->RayOf; }

private:
  static constexpr std::int32_t None = -1;

  std::int32_t Number[WidestVector], RayOf[WidestVector];
};

}
}
}
HWY_AFTER_NAMESPACE();

#endif
