// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_VolumePlace_h
#define TemporalCoherence_VolumePlace_h

#include "Scene/Field.h"
#include "vtkTemporalCoherenceCompatibility.h"

#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkVolume;
VTK_ABI_NAMESPACE_END

namespace TemporalCoherence
{

bool IsFinite(const glm::dmat4& matrix);

/// True if a matrix flattens the unit box so much that its inverse is useless.
bool IsFlat(const glm::dmat4& matrix);

/// Apply the transform of the volume to one from index space to the volume's own coordinates.
/// \param error receives the mistake and its remedy
/// \return false on error
bool PlaceVolume(vtkVolume* volume, IndexTransform& transform, std::string& error);

}

#endif
