// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_LayerDepthClip_h
#define TemporalCoherence_LayerDepthClip_h

#include "Window/WindowPicture.h"

#include <vector>

namespace TemporalCoherence
{

/// The colours of a picture where other things in the window lie among its layers: each pixel shows
/// the layers in front of them. A pixel all of whose layers lie behind keeps its colour, for the
/// depth test to hide, which knows of parts of pixels.
/// \param rect        whole tiles of the frame
/// \param depths      of the depth buffer, row by row: one for each pixel that the window has there
/// \param size        how many these are; a coarse picture has fewer
/// \param[out] colors of these pixels, premultiplied
/// \return false if these are the picture's own colours
/// \throws std::bad_alloc
bool ClipLayersAt(const std::vector<float>& depths, const glm::ivec2& size, const PixelRect& rect,
  const Frame& frame, const View& view, std::vector<PixelColor>& colors);

}

#endif
