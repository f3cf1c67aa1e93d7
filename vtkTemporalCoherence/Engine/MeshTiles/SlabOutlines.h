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

/// The vertices of the tetrahedra of a leaf and their values, as arrays over cells: what a tile
/// needs to know which of its rays can meet a band in each. In single precision.
struct SlabOutlines
{
  static constexpr std::size_t Vertices = 4;
  using Points = std::array<glm::dvec3, Vertices>;

  /// Make room for so many cells.
  /// \throws std::bad_alloc
  void Resize(std::size_t count)
  {
    this->Count = count;
    this->Lanes = WholeVectors(count);
    this->At.resize(4 * Vertices * this->Lanes);
  }

  /// \param points relative to the middle of the leaf's box, in index space
  /// \param values differences from the lowest value of the band
  void Set(std::size_t cell, const Points& points, const std::array<double, Vertices>& values)
  {
    for (std::size_t vertex = 0; vertex < Vertices; ++vertex)
    {
      for (std::size_t a = 0; a < 3; ++a)
      {
        this->At[this->PlaceOf(a, vertex) + cell] =
          static_cast<float>(points[vertex][static_cast<glm::length_t>(a)]);
      }
      this->At[this->PlaceOf(3, vertex) + cell] = static_cast<float>(values[vertex]);
    }
  }

  /// Where a coordinate of a vertex of all cells begins, or (axis 3) its value.
  std::size_t PlaceOf(std::size_t axis, std::size_t vertex) const
  {
    return (axis * Vertices + vertex) * this->Lanes;
  }

  std::size_t SizeInBytes() const { return sizeof(float) * this->At.capacity(); }

  std::size_t Count = 0; ///< cells
  std::size_t Lanes = 0; ///< the same in whole vectors; those beyond Count have no meaning
  std::vector<float> At;
};

}

#endif
