// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_MeshCheck_h
#define TemporalCoherence_MeshCheck_h

#include "Mesh/Cells/Mesh.h"
#include "Scene/Progress.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <limits>
#include <vector>

namespace TemporalCoherence
{

/// Reasons why a mesh gets no tree.
enum class MeshDefect
{
  None,
  TooManyCells,        ///< more than 2^32 - 2
  PointOutOfRange,     ///< a cell names a point that is not there
  OffsetsNotAscending, ///< or they go beyond the connectivity
  WrongNumberOfPoints, ///< of a cell, for its type, or of a curvilinear grid
  PointNotFinite,      ///< a point of a cell is not finite, or farther than FarthestPoint
  NoMemory,            ///< the tree would exceed the limit
  Stopped              ///< by progress
};

/// The first defect in the order of cell numbers, and its place.
struct MeshProblem
{
  MeshDefect Defect = MeshDefect::None;
  std::int64_t Cell = -1;  ///< through all parts; -1 if no cell is at fault
  std::int64_t Point = -1; ///< id in the part of the cell; -1 if no point is at fault
};

/// Coordinates may not be larger, so that products of three lengths are finite.
constexpr double FarthestPoint = 1e100;

inline bool IsPointUsable(const glm::dvec3& point)
{
  // NaN compares as false.
  return glm::abs(point.x) <= FarthestPoint && glm::abs(point.y) <= FarthestPoint &&
    glm::abs(point.z) <= FarthestPoint;
}

/// A box in the coordinates of a mesh.
struct PointBox
{
  glm::dvec3 Low{ std::numeric_limits<double>::infinity() };
  glm::dvec3 High{ -std::numeric_limits<double>::infinity() };

  void Widen(const glm::dvec3& point)
  {
    this->Low = glm::min(this->Low, point);
    this->High = glm::max(this->High, point);
  }
  void Widen(const PointBox& box)
  {
    this->Low = glm::min(this->Low, box.Low);
    this->High = glm::max(this->High, box.High);
  }
};

/// Consecutive cells of one part, which one thread works on.
struct CellChunk
{
  std::size_t Part;
  std::int64_t Begin, End;        ///< in the part
  std::int64_t First;             ///< the number of cell Begin through all parts
  std::int64_t NumberOfCells = 0; ///< with volume, and not hidden
  PointBox Box;                   ///< around them
};

/// Check all cells with volume that are not hidden.
/// \return chunks of cells, in the order of cells. They do not depend on the number of threads.
/// \throws std::bad_alloc
std::vector<CellChunk> CheckMesh(
  const Mesh& mesh, const ReportProgress& progress, MeshProblem& problem);

}

#endif
