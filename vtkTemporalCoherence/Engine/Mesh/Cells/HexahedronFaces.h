// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_HexahedronFaces_h
#define TemporalCoherence_HexahedronFaces_h

#include "Mesh/Cells/CornerPoints.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace TemporalCoherence
{
namespace MeshKernels
{

/// The corners of the six faces of a hexahedron, by their places in the cell. Each face lists them
/// in an order that depends on points and values alone, so that two cells that share a face compute
/// the same bits there.
struct HexahedronFaces
{
  std::array<std::array<std::uint8_t, 4>, 6> Corners; ///< (0, 0), (1, 0), (0, 1), (1, 1)

  explicit HexahedronFaces(const CornerPoints<8>& cell)
  {
    std::array<std::uint8_t, 8> rank{};
    for (std::size_t i = 0; i < 8; ++i)
    {
      for (std::size_t j = 0; j < 8; ++j)
      {
        rank[i] = static_cast<std::uint8_t>(rank[i] + IsLess(cell, j, i));
      }
    }
    for (std::size_t face = 0; face < 6; ++face)
    {
      const std::size_t axis = face / 2;
      const std::size_t a = std::size_t(1) << (axis + 1) % 3, b = std::size_t(1) << (axis + 2) % 3;
      const std::size_t first = (face & 1) << axis;
      this->Corners[face] = Least({ first, first + a, first + b, first + a + b }, rank);
    }
  }

private:
  using Order = std::array<std::uint8_t, 4>;

  static bool IsLess(const CornerPoints<8>& cell, std::size_t i, std::size_t j)
  {
    const glm::dvec3 &a = cell.Points[i], &b = cell.Points[j];
    return a.x != b.x ? a.x < b.x
      : a.y != b.y    ? a.y < b.y
      : a.z != b.z    ? a.z < b.z
                      : cell.Values[i] < cell.Values[j];
  }

  /// The listing of a face's corners with the lexicographically least ranks, of eight possible
  /// ones.
  static Order Least(
    const std::array<std::size_t, 4>& corners, const std::array<std::uint8_t, 8>& rank)
  {
    Order least{};
    unsigned int code = ~0u;
    for (std::size_t first = 0; first < 4; ++first)
    {
      for (std::size_t step = 1; step <= 2; ++step)
      {
        const std::array<std::size_t, 4> at = { corners[first], corners[first ^ step],
          corners[first ^ (3 - step)], corners[first ^ 3] };
        const unsigned int mine = static_cast<unsigned int>(
          rank[at[0]] << 9 | rank[at[1]] << 6 | rank[at[2]] << 3 | rank[at[3]]);
        if (mine < code)
        {
          code = mine;
          for (std::size_t i = 0; i < 4; ++i)
          {
            least[i] = static_cast<std::uint8_t>(at[i]);
          }
        }
      }
    }
    return least;
  }
};

}
}

#endif
