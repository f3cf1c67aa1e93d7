// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_CellOutlines_h
#define TemporalCoherence_CellOutlines_h

#include "Scene/RayBatch.h"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <vector>

namespace TemporalCoherence
{

/// Where the cells of a leaf lie, as arrays over cells: what a tile needs to know which of its rays
/// can meet a surface in each.
///
/// Eight points surround a cell. Those of a tetrahedron are its four vertices, and then the corners
/// of the flat polygon in which it is cut by the surface, in their order around it; those of a
/// triangle end with the third one twice. If it is not cut, the vertices come twice. Points are
/// relative to the middle of the leaf's box, in index space, in single precision.
struct CellOutlines
{
  static constexpr std::size_t Corners = 8;
  using Points = std::array<glm::dvec3, Corners>;

  /// Make room for so many cells.
  /// \throws std::bad_alloc
  void Resize(std::size_t count)
  {
    this->Count = count;
    this->Lanes = WholeVectors(count);
    this->At.resize(3 * Corners * this->Lanes);
    this->IsCut.resize(this->Lanes);
  }

  /// \param isCut the last four points are those of a polygon
  void Set(std::size_t cell, const Points& points, bool isCut)
  {
    for (std::size_t a = 0; a < 3; ++a)
    {
      for (std::size_t corner = 0; corner < Corners; ++corner)
      {
        this->At[this->PlaceOf(a, corner) + cell] =
          static_cast<float>(points[corner][static_cast<glm::length_t>(a)]);
      }
    }
    this->IsCut[cell] = isCut ? 1.0f : 0.0f;
  }

  /// Where a coordinate of a corner of all cells begins.
  std::size_t PlaceOf(std::size_t axis, std::size_t corner) const
  {
    return (axis * Corners + corner) * this->Lanes;
  }

  std::size_t SizeInBytes() const { return sizeof(float) * (this->At.size() + this->IsCut.size()); }

  std::size_t Count = 0; ///< cells
  std::size_t Lanes = 0; ///< the same in whole vectors; those beyond Count have no meaning
  std::vector<float> At;
  std::vector<float> IsCut; ///< 1 for each cell with a polygon
};

}

#endif
