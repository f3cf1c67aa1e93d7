// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_RootItems_h
#define TemporalCoherence_RootItems_h

#include "Mesh/Cells/HexahedronRoots.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace TemporalCoherence
{
namespace MeshKernels
{

/// Cut a box to a part, given in the box's coordinates. Keeps a little more where the box would get
/// so thin that rounding errors matter.
/// \return true if an edge was cut to less than EnoughCut of its length
inline bool CutBox(std::array<double, 3> part, std::array<double, 3> share,
  std::array<double, 3>& middle, std::array<double, 3>& half)
{
  double longest = 0.0;
  for (std::size_t a = 0; a < 3; ++a)
  {
    longest = std::max(longest, share[a] * half[a]);
  }
  bool isShort = false;
  for (std::size_t a = 0; a < 3; ++a)
  {
    const double least = Thinnest * longest;
    if (share[a] * half[a] < least)
    {
      share[a] = std::min(least / half[a], 1.0);
      part[a] = std::min(std::max(part[a], share[a] - 1.0), 1.0 - share[a]);
    }
    middle[a] += part[a] * half[a];
    half[a] *= share[a];
    isShort = isShort || share[a] < EnoughCut;
  }
  return isShort;
}

/// Boxes of many rays that are still to be searched for roots, as arrays over boxes.
struct RootItems
{
  /// A ray with more boxes is searched alone.
  static constexpr std::size_t MostOfRay = 8;
  static constexpr std::size_t Capacity = MostOfRay * MeshRays::Capacity;

  /// Repeat the last box up to the end of the last vector, so that no lane is uninitialised.
  void FillUp()
  {
    for (std::size_t i = this->Count; i > 0 && i < WholeVectors(this->Count); ++i)
    {
      this->Ray[i] = this->Ray[i - 1];
      for (std::size_t a = 0; a < 3; ++a)
      {
        this->Middle[a][i] = this->Middle[a][i - 1];
        this->Half[a][i] = this->Half[a][i - 1];
      }
    }
  }

  std::size_t Count = 0;
  std::array<std::int64_t, Capacity> Ray;
  std::array<std::array<double, Capacity>, 3> Middle, Half;
};

/// Roots of rays that were searched in several boxes.
struct FoundRoots
{
  std::uint64_t Rays = 0; ///< with an entry below
  TileArray<HexahedronRoots> Of;

  HexahedronRoots& Begin(std::size_t ray)
  {
    if ((this->Rays >> ray & 1u) == 0)
    {
      this->Rays |= std::uint64_t(1) << ray;
      this->Of[ray].Count = 0;
    }
    return this->Of[ray];
  }
};

/// Add a root, unless it is there: a root on the common face of two boxes lies in both.
inline void AddRoot(const HexahedronRoot& root, HexahedronRoots& roots)
{
  for (std::size_t i = 0; i < roots.Count; ++i)
  {
    const HexahedronRoot& other = roots.Roots[i];
    double distant = 0.0;
    for (std::size_t a = 0; a < 3; ++a)
    {
      distant = std::max(distant, std::abs(other.At[a] - root.At[a]));
    }
    if (distant <= 10.0 * SmallestBox && other.Rises == root.Rises)
    {
      return;
    }
  }
  if (roots.Count < roots.Roots.size())
  {
    roots.Roots[roots.Count++] = root;
  }
}

}
}

#endif
