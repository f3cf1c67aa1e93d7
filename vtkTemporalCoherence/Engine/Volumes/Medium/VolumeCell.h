// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_VolumeCell_h
#define TemporalCoherence_VolumeCell_h

#include "Lattice/KernelsWalk.h"
#include "Scene/Field.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

#include <hwy/base.h>

namespace TemporalCoherence
{

/// Data of a cell for kernels. Corners lie at [x + 2 y + 4 z].
struct alignas(64) VolumeCell
{
  std::array<float, 8> Values; ///< in bins
  /// By axis: the difference of the samples on both sides of a corner, in bins, twice the gradient.
  /// Beside a sample that is not finite, gradients are one-sided.
  std::array<std::array<float, 8>, 3> Gradients;
};

/// The cells of a volume.
class VolumeCells : public LeafSource
{
public:
  virtual void Read(const glm::ivec3& cell, VolumeCell& read) const = 0;
};

/// Reads cells of images.
template <typename T>
class CellReader
{
public:
  /// \param low value at which bins begin
  CellReader(const Field& samples, double low, double perValue)
    : Samples(samples)
    , Low(low)
    , PerValue(perValue)
    , Scale(static_cast<float>(perValue))
    , Shift(static_cast<float>(-low * perValue))
  {
  }

  void Read(const glm::ivec3& cell, VolumeCell& read) const
  {
    Around around;
    const glm::ivec3 last = this->Samples.Dimensions - 2;
    const bool isInside = cell.x > 0 && cell.y > 0 && cell.z > 0 && cell.x < last.x &&
      cell.y < last.y && cell.z < last.z;
    if (isInside && this->Samples.Strides.x == 1)
    {
      this->ReadInside(cell, around);
    }
    else
    {
      this->ReadAnywhere(cell, around);
    }
    around.Store(read);
    if (!std::is_integral_v<T> && !AreFinite(read))
    {
      around.MakeOneSided();
      around.Store(read);
    }
  }

private:
  /// A block of 4^3 samples with the cell in its middle.
  struct alignas(64) Around
  {
    HWY_INLINE void Store(VolumeCell& read) const
    {
      // The two rows of the cell in a slice are adjacent: eight numbers.
      float along[3][16];
      for (std::size_t z = 0; z < 2; ++z)
      {
        const float* const own = this->All + 20 + 16 * z;
        for (std::size_t i = 0; i < 8; ++i)
        {
          along[0][8 * z + i] = own[i + 1] - own[i - 1];
        }
        for (std::size_t i = 0; i < 8; ++i)
        {
          along[1][8 * z + i] = own[i + 4] - own[i - 4];
          along[2][8 * z + i] = own[i + 16] - own[i - 16];
        }
      }
      constexpr std::size_t two = 2 * sizeof(float);
      for (std::size_t yz = 0; yz < 4; ++yz)
      {
        std::memcpy(&read.Values[2 * yz], this->All + 21 + 4 * (yz & 1u) + 16 * (yz >> 1u), two);
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
          std::memcpy(&read.Gradients[axis][2 * yz], along[axis] + 4 * yz + 1, two);
        }
      }
    }

    /// Extrapolate samples beside the cell that are not finite, so that differences over two steps
    /// become twice the differences over the inner step. (Cells with such a corner are invisible.)
    void MakeOneSided()
    {
      constexpr int steps[3] = { 1, 4, 16 };
      for (int corner = 0; corner < 8; ++corner)
      {
        const int sides[3] = { corner & 1, corner >> 1 & 1, corner >> 2 };
        const int inner = 21 + sides[0] * steps[0] + sides[1] * steps[1] + sides[2] * steps[2];
        for (int axis = 0; axis < 3; ++axis)
        {
          const int outwards = sides[axis] == 0 ? -steps[axis] : steps[axis];
          float& outer = this->All[inner + outwards];
          outer =
            std::isfinite(outer) ? outer : 2.0f * this->All[inner] - this->All[inner - outwards];
        }
      }
    }

    float All[64]; ///< [x + 4 y + 16 z]
  };

  /// True if all gradients of a cell are finite, by their largest bits: bits order like magnitudes.
  static bool AreFinite(const VolumeCell& read)
  {
    std::uint32_t largest = 0;
    for (const auto& along : read.Gradients)
    {
      for (const float gradient : along)
      {
        std::uint32_t bits = 0;
        std::memcpy(&bits, &gradient, sizeof(bits));
        largest = std::max(largest, bits & 0x7fffffffu);
      }
    }
    return largest < 0x7f800000u;
  }

  HWY_INLINE float BinOf(T sample) const
  {
    if constexpr (sizeof(T) <= 2)
    {
      return static_cast<float>(sample) * this->Scale + this->Shift;
    }
    else
    {
      return static_cast<float>((static_cast<double>(sample) - this->Low) * this->PerValue);
    }
  }

  /// Read some rows of a slice.
  template <std::size_t First, std::size_t Last>
  HWY_INLINE void ReadRows(const T* from, float* slice) const
  {
    for (std::size_t y = First; y <= Last; ++y)
    {
      T samples[4];
      std::memcpy(
        samples, from + static_cast<std::int64_t>(y) * this->Samples.Strides.y, sizeof(samples));
      for (std::size_t x = 0; x < 4; ++x)
      {
        slice[4 * y + x] = this->BinOf(samples[x]);
      }
    }
  }

  HWY_INLINE void ReadInside(const glm::ivec3& cell, Around& around) const
  {
    const std::int64_t slice = this->Samples.Strides.z;
    const T* const from = this->Samples.At(cell) - 1 - this->Samples.Strides.y - slice;
    // No gradient needs the edges of the block.
    this->template ReadRows<1, 2>(from, around.All);
    this->template ReadRows<0, 3>(from + slice, around.All + 16);
    this->template ReadRows<0, 3>(from + 2 * slice, around.All + 32);
    this->template ReadRows<1, 2>(from + 3 * slice, around.All + 48);
  }

  /// Extrapolate samples beyond the boundary, so that central differences become one-sided there.
  void ReadAnywhere(const glm::ivec3& cell, Around& around) const
  {
    const glm::ivec3 last = this->Samples.Dimensions - 1;
    for (int i = 0; i < 64; ++i)
    {
      const glm::ivec3 place = cell - 1 + glm::ivec3(i & 3, i >> 2 & 3, i >> 4);
      const glm::ivec3 near = glm::clamp(place, glm::ivec3(0), last);
      const glm::ivec3 mirrored = glm::clamp(2 * near - place, glm::ivec3(0), last);
      const float value = this->BinOf(*this->Samples.At(near));
      const float beyond = 2.0f * value - this->BinOf(*this->Samples.At(mirrored));
      around.All[i] = place == near ? value : beyond;
    }
  }

  TypedField<T> Samples;
  double Low, PerValue;
  float Scale, Shift; ///< a bin is sample * Scale + Shift
};

}

#endif
