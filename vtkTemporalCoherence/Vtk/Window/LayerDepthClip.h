// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_LayerDepthClip_h
#define TemporalCoherence_LayerDepthClip_h

#include "Scene/View.h"
#include "Window/PixelRays.h"

#include <vector>

namespace TemporalCoherence
{

/// Clip the layers of a picture by the window's depth buffer: each pixel shows the layers in front
/// of other props. If all layers of a pixel lie behind, it keeps its colour: the depth test hides
/// it, sample by sample.
/// \param rect        whole tiles of the frame
/// \param depths      of the window's pixels in rect, row by row
/// \param size        window pixels along each axis; a coarse picture has fewer pixels
/// \param[out] colors of these pixels, premultiplied
/// \return false if they equal the picture's own colours
/// \throws std::bad_alloc
bool ClipLayersAt(const std::vector<float>& depths, const glm::ivec2& size, const PixelRect& rect,
  const Frame& frame, const View& view, std::vector<PixelColor>& colors);

}

#endif
