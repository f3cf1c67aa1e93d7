// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_WindowRays_h
#define TemporalCoherence_WindowRays_h

#include "vtkTemporalCoherenceCompatibility.h"

#include <glm/glm.hpp>

#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkVolume;
VTK_ABI_NAMESPACE_END

namespace TemporalCoherence
{

/// Decides how many rays a frame for a window has.
class WindowRays
{
public:
  /// \param asked   distance between rays in pixels, as set
  /// \param warning receives a message if there are too many rays: once, until another distance is
  ///                set
  glm::ivec2 For(const glm::ivec2& pixels, double asked, vtkVolume* volume, std::string& warning);

private:
  double LastAsked = 1.0;
  bool HasWarned = false; ///< of this distance; several windows may share a mapper
};

}

#endif
