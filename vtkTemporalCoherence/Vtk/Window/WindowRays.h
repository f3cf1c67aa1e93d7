// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_WindowRays_h
#define TemporalCoherence_WindowRays_h

#include "Render/SampleDistance.h"
#include "vtkTemporalCoherenceCompatibility.h"

#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkVolume;
VTK_ABI_NAMESPACE_END

namespace TemporalCoherence
{

/// Tells how many rays a frame for a window has.
class WindowRays
{
public:
  /// \param asked   the distance of rays that is set, in pixels
  /// \param warning gets that it would be too many, once until they no longer are
  glm::ivec2 For(const glm::ivec2& pixels, double asked, vtkVolume* volume, std::string& warning);

private:
  std::string LastWarning;
};

}

#endif
