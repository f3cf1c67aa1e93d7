// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_MeshBoxes_h
#define TemporalCoherence_MeshBoxes_h

#include "Mesh/Tree/MeshCheck.h"
#include "Mesh/Tree/MeshEdges.h"
#include "Mesh/Tree/MeshOrder.h"
#include "Mesh/Tree/MeshReader.h"
#include "Scene/CellBox.h"
#include "Scene/FieldShape.h"
#include "Scene/Progress.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace TemporalCoherence
{

/// A box in index space, in single precision.
struct FloatBox
{
  glm::vec3 Low{ std::numeric_limits<float>::infinity() };
  glm::vec3 High{ -std::numeric_limits<float>::infinity() };

  glm::dvec3 Middle() const { return 0.5 * (glm::dvec3(this->Low) + glm::dvec3(this->High)); }

  void Widen(const FloatBox& box)
  {
    this->Low = glm::min(this->Low, box.Low);
    this->High = glm::max(this->High, box.High);
  }
};

/// Boxes around the cells of an order: around each leaf, node, block of 64 nodes, and so on.
///
/// Boxes lie in index space, where the mesh is in [0, Dimensions - 1]. They contain the points of
/// their cells, with a margin for the rounding of double precision: 2^-40 of the lattice.
class MeshBoxes
{
public:
  /// Read the points of all cells.
  /// \return false if a point is not finite, or if it was stopped
  /// \throws std::bad_alloc
  bool Build(const MeshReader& reader, const CellNumbers& order, const ReportProgress& progress,
    MeshProblem& problem);

  /// The box around a block of the lattice that FieldShape asks for.
  IndexBox BoxOf(const CellBox& cells) const;

  std::size_t MemoryInBytes() const;

  /// From index space to the coordinates of the mesh, and back.
  glm::dvec3 ToMesh(const glm::dvec3& index) const { return this->Low + this->Scale * index; }
  glm::dvec3 ToIndex(const glm::dvec3& point) const { return (point - this->Low) * this->PerScale; }

  glm::ivec3 Dimensions{ 1 }; ///< of the lattice, in samples: cells + 1
  double Scale = 1.0;         ///< mesh coordinates = Low + Scale * index; a power of two
  double PerScale = 1.0;      ///< 1 / Scale, exactly
  glm::dvec3 Low{ 0.0 };
  EdgeLengths Edges;
  bool HasVolume = false; ///< false if the points of each cell lie in a plane
  /// Boxes by level, from the leaves to one box around all cells. At least three levels, unless no
  /// cell exists.
  std::vector<std::vector<FloatBox>> Levels;

private:
  void Place(const PointBox& whole, std::int64_t leaves);
  FloatBox InIndexSpace(const PointBox& box) const;
  void BuildLevels(const std::vector<PointBox>& leaves);
  void WidenBy(std::size_t level, const glm::ivec3& block, const glm::ivec3& first,
    const glm::ivec3& last, FloatBox& box) const;
};

}

#endif
