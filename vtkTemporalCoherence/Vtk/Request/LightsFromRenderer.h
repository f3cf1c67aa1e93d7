// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_LightsFromRenderer_h
#define TemporalCoherence_LightsFromRenderer_h

#include "Scene/Appearance.h"
#include "vtkTemporalCoherenceCompatibility.h"

#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkRenderer;
VTK_ABI_NAMESPACE_END

namespace TemporalCoherence
{

/// Make the lights that are on, as the renderer finds them when it draws into a window.
/// \param error gets what is wrong and what to do about it
/// \return false on error, for example if an intensity is NaN
bool FindLights(vtkRenderer* renderer, std::vector<Light>& lights, std::string& error);

}

#endif
