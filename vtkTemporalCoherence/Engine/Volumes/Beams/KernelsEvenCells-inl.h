// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Cells in which emission is linear in the value. Kernels include this file once for each kind of
// vectors, hence the toggling guard.
#if defined(TemporalCoherence_KernelsEvenCells_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef TemporalCoherence_KernelsEvenCells_inl_h
#undef TemporalCoherence_KernelsEvenCells_inl_h
#else
#define TemporalCoherence_KernelsEvenCells_inl_h
#endif

#include "Volumes/Medium/KernelsCubic-inl.h"
#include "Volumes/Medium/KernelsEmission.h"
#include "Volumes/Medium/KernelsVectors-inl.h"
#include "Volumes/Medium/TransferTables.h"
#include "Volumes/Medium/VolumeCell.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace EmissionKernels
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

/// A trilinear function: coefficients of 1, x, y, xy, z, xz, yz, xyz.
struct Trilinear
{
  void Set(const std::array<float, 8>& v)
  {
    const float x0 = v[1] - v[0], x1 = v[3] - v[2], x2 = v[5] - v[4], x3 = v[7] - v[6];
    const float y0 = v[2] - v[0], y1 = v[6] - v[4];
    this->C = { v[0], x0, y0, x1 - x0, v[4] - v[0], x2 - x0, y1 - y0, (x3 - x2) - (x1 - x0) };
  }

  HWY_INLINE V At(const V x[3]) const
  {
    const Floats d;
    const auto along = [&](std::size_t row) HWY_ATTR
    { return hn::Add(hn::Set(d, this->C[row]), hn::Mul(x[0], hn::Set(d, this->C[row + 1]))); };
    const V low = hn::Add(along(0), hn::Mul(x[1], along(2)));
    const V high = hn::Add(along(4), hn::Mul(x[1], along(6)));
    return hn::Add(low, hn::Mul(x[2], high));
  }

  /// The function along paths, as cubics.
  HWY_INLINE Cubics::HWY_NAMESPACE::Cubic<V> Along(const V begin[3], const V across[3]) const
  {
    const Floats d;
    const auto row = [&](std::size_t at, V& value, V& slope) HWY_ATTR
    {
      const V rise = hn::Set(d, this->C[at + 1]);
      value = hn::Add(hn::Set(d, this->C[at]), hn::Mul(begin[0], rise));
      slope = hn::Mul(across[0], rise);
    };
    V first[2], second[2], third[2];
    for (std::size_t z = 0; z < 2; ++z)
    {
      V value[2], slope[2];
      row(4 * z, value[0], slope[0]);
      row(4 * z + 2, value[1], slope[1]);
      first[z] = hn::Add(value[0], hn::Mul(begin[1], value[1]));
      second[z] =
        hn::Add(hn::Add(slope[0], hn::Mul(begin[1], slope[1])), hn::Mul(across[1], value[1]));
      third[z] = hn::Mul(across[1], slope[1]);
    }
    return { { hn::Add(first[0], hn::Mul(begin[2], first[1])),
      hn::Add(hn::Add(second[0], hn::Mul(begin[2], second[1])), hn::Mul(across[2], first[1])),
      hn::Add(hn::Add(third[0], hn::Mul(begin[2], third[1])), hn::Mul(across[2], second[1])),
      hn::Mul(across[2], third[1]) } };
  }

  std::array<float, 8> C;
};

/// The emission of a cell as a linear function of the value.
struct EvenEmission
{
  /// \return false if the cell is invisible
  bool Set(const TransferTables& tables, const std::array<float, 8>& values)
  {
    // Test for NaN first: minima and maxima ignore it.
    constexpr float largest = 1e30f;
    if (!std::all_of(
          values.begin(), values.end(), [](float value) { return std::abs(value) < largest; }))
    {
      return false;
    }
    const auto ends = std::minmax_element(values.begin(), values.end());
    const float low = this->Low = *ends.first, high = this->High = *ends.second;
    const Emission atLow = tables.At(low), atHigh = tables.At(high);
    const float width = high - low;
    this->Off = tables.OffLine(low, high);
    const float perWidth = width > 1e-30f ? 1.0f / width : 0.0f;
    for (std::size_t i = 0; i < 4; ++i)
    {
      this->Rise[i] = (atHigh[i] - atLow[i]) * perWidth;
      this->AtZero[i] = atLow[i] - this->Rise[i] * low;
    }
    return this->Off > 0.0f || atLow[0] > 0.0f || atHigh[0] > 0.0f;
  }

  HWY_INLINE V At(std::size_t channel, V value) const
  {
    const Floats d;
    return hn::Add(
      hn::Set(d, this->AtZero[channel]), hn::Mul(value, hn::Set(d, this->Rise[channel])));
  }

  Emission AtZero, Rise;
  float Low, High; ///< of the values
  float Off;       ///< error of the emission, at most
};

/// Data of a cell that all rays of a beam share.
struct EvenCell
{
  /// \return false if the cell is invisible
  bool Set(const EmittingVolume& volume, const VolumeCell& cell)
  {
    if (!this->Emitted.Set(volume.Tables, cell.Values))
    {
      return false;
    }
    this->Value.Set(cell.Values);
    if (volume.Lights)
    {
      Trilinear gradients[3];
      for (std::size_t a = 0; a < 3; ++a)
      {
        gradients[a].Set(cell.Gradients[a]);
      }
      const glm::mat3& m = volume.WorldFromGradient;
      for (int a = 0; a < 3; ++a)
      {
        for (std::size_t i = 0; i < 8; ++i)
        {
          this->Toward[a].C[i] = -(m[0][a] * gradients[0].C[i] + m[1][a] * gradients[1].C[i] +
            m[2][a] * gradients[2].C[i]);
        }
      }
    }
    return true;
  }

  EvenEmission Emitted;
  Trilinear Value;     ///< in bins
  Trilinear Toward[3]; ///< towards lower values, in the world; only with lights
};

}
}
}
HWY_AFTER_NAMESPACE();

#endif
