// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_SlabOutlines_h
#define TemporalCoherence_SlabOutlines_h

#include "Scene/RayBatch.h"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <vector>

namespace TemporalCoherence
{

/// Where the tetrahedra of a leaf have values of a band, as arrays over cells: what a tile needs to
/// know which of its rays can meet the band in each.
///
/// Of each cell there are its four vertices, and then up to eight corners of its part between the
/// lowest and the highest value of the band, its slab; the last one is repeated. The first four of
/// these go around the slab, if it is thin. Points are relative to the middle of the leaf's box, in
/// index space, in single precision.
struct SlabOutlines
{
  static constexpr std::size_t Vertices = 4, SlabCorners = 8, Corners = Vertices + SlabCorners;
  using Points = std::array<glm::dvec3, Corners>;

  /// Make room for so many cells.
  /// \throws std::bad_alloc
  void Resize(std::size_t count)
  {
    this->Count = count;
    this->Lanes = WholeVectors(count);
    this->At.resize(3 * Corners * this->Lanes);
  }

  void Set(std::size_t cell, const Points& points)
  {
    for (std::size_t a = 0; a < 3; ++a)
    {
      for (std::size_t corner = 0; corner < Corners; ++corner)
      {
        this->At[this->PlaceOf(a, corner) + cell] =
          static_cast<float>(points[corner][static_cast<glm::length_t>(a)]);
      }
    }
  }

  /// Where a coordinate of a corner of all cells begins.
  std::size_t PlaceOf(std::size_t axis, std::size_t corner) const
  {
    return (axis * Corners + corner) * this->Lanes;
  }

  std::size_t SizeInBytes() const { return sizeof(float) * this->At.capacity(); }

  std::size_t Count = 0; ///< cells
  std::size_t Lanes = 0; ///< the same in whole vectors; those beyond Count have no meaning
  std::vector<float> At;
};

/// Find the corners of the part of a tetrahedron between two values.
/// \param corners gets eight points in index space, the last one repeated
/// \return false if no part of it lies there
bool FindSlab(const glm::dvec3* vertices, const std::array<double, 4>& values, double low,
  double high, glm::dvec3* corners);

}

#endif
