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

/// The pixels that the renderer draws now: those of its part of the window, or of the texture that
/// a render pass has put in the window's place.
glm::ivec2 PictureSizeOf(vtkRenderer* renderer);

/// The view of the renderer's active camera in a picture of a given size.
/// \param aspect width by height of what the camera sees
/// \param error  gets what is wrong and what to do about it
/// \return false on error
bool MakeView(
  vtkRenderer* renderer, const glm::ivec2& size, double aspect, View& view, std::string& error);

}

#endif
