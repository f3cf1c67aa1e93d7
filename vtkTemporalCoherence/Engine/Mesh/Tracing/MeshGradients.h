// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_MeshGradients_h
#define TemporalCoherence_MeshGradients_h

#include "Mesh/Tree/MeshTree.h"
#include "Shade/SurfaceNormal.h"

#include <glm/glm.hpp>

#include <cmath>
#include <memory>
#include <vector>

namespace TemporalCoherence
{

/// Gradients at the points of a mesh: means over the cells around each point. They are interpolated
/// like values, which makes normals continuous.
struct PointGradients
{
  std::vector<std::vector<glm::vec3>> Parts; ///< by part and point, in the mesh's coordinates

  /// \throws std::bad_alloc
  static std::shared_ptr<const PointGradients> Make(const MeshTree& tree);
  std::size_t MemoryInBytes() const;
};

/// A component of a gradient in index space. Gradients that are not finite become 0.
inline double GradientInIndexSpace(const MeshTree& tree, double gradient)
{
  const double scaled = tree.Scale() * gradient;
  return std::isfinite(scaled) ? scaled : 0.0;
}

/// Find the gradients of a mesh at hits.
/// \param averaged null: use the gradients of the interpolant in the hit cells
void FindMeshGradients(const MeshTree& tree, const PointGradients* averaged,
  const GradientQuery& query, const GradientTile& tile);

}

#endif
