// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_DepthReader_h
#define TemporalCoherence_DepthReader_h

#include "Scene/Tiles.h"
#include "vtkTemporalCoherenceCompatibility.h"

#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLRenderWindow;
VTK_ABI_NAMESPACE_END

namespace TemporalCoherence
{

/// Read the present depth buffer. If it is multisampled, any sample of each pixel is read.
/// \param rect        pixels of that buffer
/// \param[out] depths row by row from below: 0 at the near plane, 1 at the far plane
/// \return false if it cannot be read
/// \throws std::bad_alloc
bool ReadDepths(vtkOpenGLRenderWindow* window, const PixelRect& rect, std::vector<float>& depths);

}

#endif
