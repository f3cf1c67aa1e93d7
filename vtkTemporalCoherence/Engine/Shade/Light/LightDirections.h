// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_LightDirections_h
#define TemporalCoherence_LightDirections_h

#include "Shade/Light/PatchPlace.h"

#include <glm/glm.hpp>

#include <cstdint>

namespace TemporalCoherence
{

// Rays of a patch. Each patch has a sequence of its own, which fills its target evenly however many
// of its members were used. `number`: of the rays that the patch sent before.

/// A direction in the hemisphere around a normal, weighted by its cosine.
/// \param normal of unit length
glm::dvec3 DirectionAround(const glm::dvec3& normal, const PatchPlace& place, std::uint32_t number);

/// A point of the disk of radius 1 that is perpendicular to an axis.
/// \param axis of unit length
glm::dvec3 PointOnDisk(const glm::dvec3& axis, const PatchPlace& place, std::uint32_t number);

}

#endif
