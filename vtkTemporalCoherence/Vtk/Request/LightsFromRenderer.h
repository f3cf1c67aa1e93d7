// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_LightsFromRenderer_h
#define TemporalCoherence_LightsFromRenderer_h

#include "Scene/Appearance.h"
#include "vtkTemporalCoherenceCompatibility.h"

#include <glm/glm.hpp>

#include <optional>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkRenderer;
VTK_ABI_NAMESPACE_END

namespace TemporalCoherence
{

/// Make the lights that are on, like the renderer before it draws into a window. All but headlights
/// cast shadows. Their size is that of a light with a radius of 1, seen from its focal point.
/// \param error receives the mistake and its remedy
/// \return false on error, for example if an intensity is NaN
bool FindLights(vtkRenderer* renderer, std::vector<Light>& lights, std::string& error);

/// Find the ambient light of volumes, as vtkGPUVolumeRayCastMapper does.
/// \param found receives the sum of the ambient colours of the lights that are on; nothing if a
///              single headlight of intensity 1 shines: then the volume's own colour is its ambient
///              light
/// \param error receives the mistake and its remedy
/// \return false on error: an effective ambient colour is not finite
bool FindAmbientLight(vtkRenderer* renderer, std::optional<glm::dvec3>& found, std::string& error);

}

#endif
