// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_FieldNormals_h
#define TemporalCoherence_FieldNormals_h

#include "Scene/CapPoint.h"
#include "Scene/Field.h"
#include "Shade/SurfaceNormal.h"

#include <glm/glm.hpp>

namespace TemporalCoherence
{

/// Tells which way the surfaces of a field face.
class FieldNormals
{
public:
  virtual ~FieldNormals() = default;

  /// Find the gradients of the field at the hits of a tile.
  virtual void FindGradients(const GradientQuery& query, const GradientTile& tile) const = 0;

  /// The normal of the face through which a ray enters visible cells, from outside of the field or
  /// from hidden cells. Solids are capped there. Meshes return a face of the hit cell; the default
  /// is a face of the field's box.
  /// \param nearest faces farther from the point than this are ignored; gets the distance of the
  ///                face found
  /// \return in index space, of unit length, facing against the ray; the zero vector if there is
  /// none
  virtual glm::dvec3 FaceNormal(const Field& field, const CapPoint& cap, double& nearest) const;
};

}

#endif
