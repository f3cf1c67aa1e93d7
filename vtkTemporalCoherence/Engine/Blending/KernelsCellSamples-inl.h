// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// The samples around a vector of cells, and gradients made of them.
// Kernels include this file once for each kind of vectors, hence the toggling guard.
#if defined(TemporalCoherence_KernelsCellSamples_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef TemporalCoherence_KernelsCellSamples_inl_h
#undef TemporalCoherence_KernelsCellSamples_inl_h
#else
#define TemporalCoherence_KernelsCellSamples_inl_h
#endif

#include "Blending/KernelsCubic-inl.h"
#include "Blending/KernelsVectors-inl.h"
#include "Blending/VolumeSegments.h"
#include "Scene/Field.h"
#include "Shade/KernelsPacked-inl.h"

#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace EmissionKernels
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

/// Loads the samples around a vector of cells.
struct ArrayLoader
{
  using S = V;

  HWY_INLINE void Four(std::size_t row, V out[4]) const
  {
    for (std::size_t x = 0; x < 4; ++x)
    {
      out[x] = hn::LoadU(Floats(), &this->Around.Along[row][x][this->At]);
    }
  }
  HWY_INLINE void Two(std::size_t row, V out[2]) const
  {
    for (std::size_t x = 0; x < 2; ++x)
    {
      out[x] = hn::LoadU(Floats(), &this->Around.Beside[row][x][this->At]);
    }
  }
  HWY_INLINE V Minus(V a, V b) const { return hn::Sub(a, b); }

  const SamplesAround& Around;
  std::size_t At;
};

/// The same for narrow integers, whose rows are copied from where they lie. Where each lane needs
/// several numbers that lie side by side, copies are faster than gathering them one by one.
template <typename T>
class RowLoader
{
public:
  using Rows = PackedSamples::HWY_NAMESPACE::IntegerRows<T>;
  using S = typename Rows::V;

  HWY_INLINE RowLoader(const NarrowSamples<T>& samples, const VolumeSegments& segments,
    std::size_t first, std::size_t end, float perValue)
    : PerValue(perValue)
  {
    const std::size_t lanes = hn::Lanes(Floats());
    for (std::size_t lane = 0; lane < lanes; ++lane)
    {
      // Lanes behind the last segment repeat it.
      const std::size_t i = std::min(first + lane, end - 1);
      const T* const from = samples.Samples + segments.Cell[0][i] - 1 +
        static_cast<std::ptrdiff_t>(segments.Cell[1][i]) * samples.StrideY +
        static_cast<std::ptrdiff_t>(segments.Cell[2][i]) * samples.StrideZ;
      for (std::size_t row = 0; row < 12; ++row)
      {
        const T* const at = from + StepsY[row] * samples.StrideY + StepsZ[row] * samples.StrideZ;
        std::memcpy(&this->All[row][lane], at, sizeof(this->All[row][lane]));
      }
    }
  }

  HWY_INLINE void Four(std::size_t row, S out[4]) const { Rows::Load(this->All[row].data(), out); }
  HWY_INLINE void Two(std::size_t row, S out[2]) const
  {
    S four[4];
    Rows::Load(this->All[4 + row].data(), four);
    out[0] = four[1];
    out[1] = four[2];
  }
  HWY_INLINE V Minus(S a, S b) const
  {
    return hn::Mul(Rows::AsFloats(hn::Sub(a, b)), hn::Set(Floats(), this->PerValue));
  }

private:
  /// Where the rows of SamplesAround lie: its four, then its eight.
  static constexpr std::int32_t StepsY[12] = { 0, 1, 0, 1, -1, -1, 2, 2, 0, 1, 0, 1 };
  static constexpr std::int32_t StepsZ[12] = { 0, 0, 1, 1, 0, 1, 0, 1, -1, -1, 2, 2 };

  HWY_ALIGN std::array<std::array<std::array<T, 4>, WidestVector>, 12> All;
  float PerValue;
};

/// Twice the gradients of a field at the corners of a vector of cells: differences of samples two
/// steps apart.
struct CornerGradients
{
  template <typename Loader>
  HWY_INLINE explicit CornerGradients(const Loader& loader)
  {
    using S = typename Loader::S;
    S corner[8], row[4], before[2], behind[2];
    for (std::size_t yz = 0; yz < 4; ++yz)
    {
      loader.Four(yz, row);
      corner[2 * yz] = row[1];
      corner[2 * yz + 1] = row[2];
      this->Along[0][2 * yz] = loader.Minus(row[2], row[0]);
      this->Along[0][2 * yz + 1] = loader.Minus(row[3], row[1]);
    }
    for (std::size_t end = 0; end < 2; ++end)
    {
      loader.Two(end, before);
      loader.Two(2 + end, behind);
      for (std::size_t x = 0; x < 2; ++x)
      {
        this->Along[1][4 * end + x] = loader.Minus(corner[4 * end + 2 + x], before[x]);
        this->Along[1][4 * end + 2 + x] = loader.Minus(behind[x], corner[4 * end + x]);
      }
      loader.Two(4 + end, before);
      loader.Two(6 + end, behind);
      for (std::size_t x = 0; x < 2; ++x)
      {
        this->Along[2][2 * end + x] = loader.Minus(corner[4 + 2 * end + x], before[x]);
        this->Along[2][4 + 2 * end + x] = loader.Minus(behind[x], corner[2 * end + x]);
      }
    }
  }
  HWY_INLINE CornerGradients()
  {
    for (auto& corners : this->Along)
    {
      std::fill_n(corners, 8, hn::Zero(Floats()));
    }
  }

  V Along[3][8]; ///< by axis, [x + 2 y + 4 z]
};

/// Twice the gradients of a field along a vector of segments. Between corners, each of their
/// components is a trilinear function.
struct LineGradients
{
  /// \param begin, across paths through the cells
  HWY_INLINE LineGradients(const CornerGradients& corners, const V begin[3], const V across[3])
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      this->Along[axis] = Cubics::HWY_NAMESPACE::CubicAlong(corners.Along[axis], begin, across);
    }
  }

  HWY_INLINE void At(V share, V gradient[3]) const
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      gradient[axis] = this->Along[axis].At(share);
    }
  }

  Cubics::HWY_NAMESPACE::Cubic<V> Along[3];
};

}
}
}
HWY_AFTER_NAMESPACE();

#endif
