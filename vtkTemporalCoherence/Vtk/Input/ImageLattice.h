// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_ImageLattice_h
#define TemporalCoherence_ImageLattice_h

#include "vtkTemporalCoherenceCompatibility.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkImageData;
VTK_ABI_NAMESPACE_END

namespace TemporalCoherence
{

/// Points of a lattice from First to Last, both included.
struct LatticeBox
{
  glm::i64vec3 First{ 0 }, Last{ -1 };

  glm::i64vec3 Points() const { return this->Last - this->First + std::int64_t(1); }
};

/// Find the position of an image on the lattice of another one, in that image's indices.
/// \param why receives the difference
/// \return false if spacing or direction differ, or if the origins are not whole steps apart
bool PlaceOnLattice(
  vtkImageData* lattice, vtkImageData* image, LatticeBox& place, std::string& why);

}

#endif
