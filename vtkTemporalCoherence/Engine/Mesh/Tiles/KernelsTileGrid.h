// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_KernelsTileGrid_h
#define TemporalCoherence_KernelsTileGrid_h

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace TemporalCoherence
{

/// The 64 boxes of a block, as middles and half edges by axis. Missing boxes have negative edges.
struct alignas(64) BoxLanes
{
  void Set(std::size_t lane, const glm::dvec3& low, const glm::dvec3& high)
  {
    for (std::size_t a = 0; a < 3; ++a)
    {
      const auto axis = static_cast<int>(a);
      this->Middle[a][lane] = static_cast<float>(0.5 * (low[axis] + high[axis]));
      this->Half[a][lane] = static_cast<float>(0.5 * (high[axis] - low[axis]));
    }
  }

  /// How far single precision may move a box, as a share of the lattice.
  static constexpr double Rounding = 0x1p-20;

  std::array<std::array<float, 64>, 3> Middle, Half;
};

/// Lanes without a box.
inline BoxLanes NoBoxes()
{
  BoxLanes lanes{};
  for (std::array<float, 64>& half : lanes.Half)
  {
    half.fill(-1.0f);
  }
  return lanes;
}

/// Four planes around a tile of rays: Normal . point + Offset >= 0 on their side. By coefficient
/// and plane.
struct TilePlanes
{
  std::array<std::array<float, 4>, 3> Normal;
  std::array<float, 4> Offset;
};

/// Bits of the boxes that no plane excludes.
std::uint64_t BoxesWithin(const TilePlanes& planes, const BoxLanes& boxes);

}

#endif
