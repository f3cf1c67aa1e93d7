// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_MeshEdges_h
#define TemporalCoherence_MeshEdges_h

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

namespace TemporalCoherence
{

/// Lengths of the edges of cells, in the coordinates of the mesh. Edges of length 0 do not count.
struct EdgeLengths
{
  double Shortest = 0.0, Mean = 0.0, Longest = 0.0;
};

/// Corners at the ends of edges.
constexpr std::array<std::array<std::uint8_t, 2>, 6> TetrahedronEdges = { { { 0, 1 }, { 0, 2 },
  { 0, 3 }, { 1, 2 }, { 1, 3 }, { 2, 3 } } };
constexpr std::array<std::array<std::uint8_t, 2>, 12> HexahedronEdges = { { { 0, 1 }, { 2, 3 },
  { 4, 5 }, { 6, 7 }, { 0, 2 }, { 1, 3 }, { 4, 6 }, { 5, 7 }, { 0, 4 }, { 1, 5 }, { 2, 6 },
  { 3, 7 } } };

/// Squares of the shortest and the longest length of edges, and the sum of lengths in a sample.
struct EdgeSums
{
  double Shortest = std::numeric_limits<double>::infinity(), Longest = 0.0, Sum = 0.0;
  std::int64_t Count = 0;

  template <typename Edges>
  void Add(const std::array<glm::dvec3, 8>& points, const Edges& edges, bool isSample)
  {
    for (const auto& edge : edges)
    {
      const glm::dvec3 along = points[edge[1]] - points[edge[0]];
      const double square = glm::dot(along, along);
      this->Shortest = square > 0.0 ? std::min(this->Shortest, square) : this->Shortest;
      this->Longest = std::max(this->Longest, square);
      if (isSample && square > 0.0)
      {
        this->Sum += std::sqrt(square);
        ++this->Count;
      }
    }
  }

  void Add(const EdgeSums& sums)
  {
    this->Shortest = std::min(this->Shortest, sums.Shortest);
    this->Longest = std::max(this->Longest, sums.Longest);
    this->Sum += sums.Sum;
    this->Count += sums.Count;
  }

  EdgeLengths Lengths() const
  {
    const double longest = std::sqrt(this->Longest);
    const double shortest = this->Longest > 0.0 ? std::sqrt(this->Shortest) : 0.0;
    return { shortest, this->Count > 0 ? this->Sum / static_cast<double>(this->Count) : longest,
      longest };
  }
};

}

#endif
