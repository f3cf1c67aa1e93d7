// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_CapPoint_h
#define TemporalCoherence_CapPoint_h

#include "Scene/Frame.h"

#include <glm/glm.hpp>

namespace TemporalCoherence
{

/// Where a ray meets a cap, in index space.
struct CapPoint
{
  glm::dvec3 At;
  glm::dvec3 Direction;     ///< of the ray
  CellNumber Cell = NoCell; ///< of a mesh: the ray enters it or begins in it
  bool IsOnPlane = false;   ///< it lies on a clipping plane or the near plane, within rounding
};

}

#endif
