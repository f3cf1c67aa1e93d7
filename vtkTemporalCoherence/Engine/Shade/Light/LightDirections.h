// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_LightDirections_h
#define TemporalCoherence_LightDirections_h

#include "Shade/Light/PatchPlace.h"

#include <glm/glm.hpp>

#include <cstdint>

namespace TemporalCoherence
{

/// The direction of a ray that finds light. Directions fill the hemisphere around the normal
/// evenly, weighted by their cosines, whatever the number of a patch's rays. \param normal of unit
/// length \param number of rays that the patch sent before
glm::dvec3 LightDirection(const glm::dvec3& normal, const PatchPlace& place, std::uint32_t number);

}

#endif
