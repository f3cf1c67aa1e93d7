// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_CellOracle_h
#define Testing_CellOracle_h

#include "Mesh/Cells/MeshCell.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <vector>

/// Where a ray meets surfaces in a cell, by brute force in extended precision. Shares nothing with
/// the kernels.
namespace CellOracle
{

using Number = long double;
using Vector = glm::vec<3, Number>;

struct Ray
{
  Vector Origin, Direction;
};

/// A ray of a batch.
template <typename Rays>
Ray RayOf(const Rays& rays, std::size_t i)
{
  return { { rays.Origin[0][i], rays.Origin[1][i], rays.Origin[2][i] },
    { rays.Direction[0][i], rays.Direction[1][i], rays.Direction[2][i] } };
}

struct Root
{
  Vector At; ///< in the unit cube, up to Beyond outside of it
  Number T;
  bool Rises;
  Number Condition; ///< how much coordinates change with errors of values; large: ill-conditioned
  Number Speed;     ///< how far the ray is from being stuck, 0 to 1; small: Rises means nothing
};

/// How far outside of the cube roots are found, too.
constexpr Number Beyond = 1e-6L;

struct Roots
{
  std::vector<Root> All;
  bool IsDoubtful = false; ///< there may be roots that are not single ones
};

/// The roots in a hexahedron: it is cut into 8^depth boxes, and Newton's method is begun in each
/// one whose corners do not exclude a root.
Roots FindInHexahedron(const TemporalCoherence::MeshCell& cell,
  const std::array<double, 8>& differences, const Ray& ray, int depth);

/// Where a ray is in a tetrahedron.
struct Span
{
  bool IsHit = false;
  bool IsFlat = false; ///< nothing can be said
  Number In, Out, AtIn, AtOut;
};
Span FindInTetrahedron(const TemporalCoherence::MeshCell& cell,
  const std::array<double, 8>& differences, const Ray& ray);

}

#endif
