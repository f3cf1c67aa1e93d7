// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_ViewFromRenderer_h
#define TemporalCoherence_ViewFromRenderer_h

#include "Scene/View.h"
#include "vtkTemporalCoherenceCompatibility.h"

#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkRenderer;
VTK_ABI_NAMESPACE_END

namespace TemporalCoherence
{

/// The pixels that the renderer draws now: its part of the window, or the texture that a render
/// pass draws into instead.
glm::ivec2 PictureSizeOf(vtkRenderer* renderer);

/// Make the view of the renderer's active camera in a picture of a given size.
/// \param aspect width / height of the camera's view
/// \param error  receives the mistake and its remedy
/// \return false on error
bool MakeView(
  vtkRenderer* renderer, const glm::ivec2& size, double aspect, View& view, std::string& error);

}

#endif
