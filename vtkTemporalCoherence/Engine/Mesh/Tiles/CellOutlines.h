// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_CellOutlines_h
#define TemporalCoherence_CellOutlines_h

#include "Scene/RayBatch.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <vector>

namespace TemporalCoherence
{

/// Some points of each of many cells, as arrays over cells. Points are relative to the middle of
/// the leaf's box, in index space, in single precision.
struct OutlinePoints
{
  /// Make room for so many cells.
  /// \throws std::bad_alloc
  void Resize(std::size_t count, std::size_t corners)
  {
    this->Count = count;
    this->Corners = corners;
    this->Lanes = WholeVectors(count);
    this->At.resize(3 * corners * this->Lanes);
  }

  /// \param points one for each corner
  void Set(std::size_t cell, const glm::dvec3* points)
  {
    for (std::size_t a = 0; a < 3; ++a)
    {
      for (std::size_t corner = 0; corner < this->Corners; ++corner)
      {
        this->At[this->PlaceOf(a, corner) + cell] =
          static_cast<float>(points[corner][static_cast<glm::length_t>(a)]);
      }
    }
  }

  /// Index of one coordinate of one corner of cell 0; the other cells follow.
  std::size_t PlaceOf(std::size_t axis, std::size_t corner) const
  {
    return (axis * this->Corners + corner) * this->Lanes;
  }

  std::size_t Count = 0; ///< cells
  std::size_t Corners = 0;
  std::size_t Lanes = 0; ///< Count in whole vectors; lanes beyond Count have no meaning
  std::vector<float> At;
};

/// Outlines of a leaf's cells, from which a tile finds the rays that can meet a surface in each
/// cell. Cells with polygons come first, then cells with slabs, then cells with hulls.
struct CellOutlines
{
  /// The four vertices of a tetrahedron, and then the corners of the flat polygon in which the
  /// surface cuts it, in their order around it; a triangle repeats its third corner.
  OutlinePoints Polygons;

  /// The four vertices of a tetrahedron, and then points whose convex hull is its part within a
  /// band.
  OutlinePoints Slabs;

  /// Points whose convex hull holds the surface in a cell.
  OutlinePoints Hulls;

  std::size_t SizeInBytes() const
  {
    return sizeof(float) *
      (this->Polygons.At.capacity() + this->Slabs.At.capacity() + this->Hulls.At.capacity());
  }
};

}

#endif
