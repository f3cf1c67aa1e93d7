// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_PixelHit_h
#define TemporalCoherence_PixelHit_h

#include "Scene/Frame.h"
#include "Scene/View.h"

#include <cstddef>
#include <optional>

namespace TemporalCoherence
{

/// The hit that a pixel of a frame shows.
struct PixelHit
{
  glm::dvec3 Position; ///< in the world
  glm::dvec3 Normal;   ///< unit normal in the world, facing the viewer
  int Surface;         ///< position in the list of isovalues
  CellNumber Cell;     ///< of a mesh
};

/// Position of pixel (x, y) in the planes of a frame.
inline std::size_t IndexOfPixel(const Frame& frame, int x, int y)
{
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(frame.Size.x) +
    static_cast<std::size_t>(x);
}

/// The cell of a mesh that pixel (x, y) shows.
inline CellNumber CellOfHit(const Frame& frame, int x, int y)
{
  return frame.Cells.empty() ? NoCell : frame.Cells[IndexOfPixel(frame, x, y)];
}

/// World position of the hit of pixel (x, y).
/// \pre the pixel has a hit
inline glm::dvec3 PositionOfHit(const Frame& frame, const View& view, int x, int y)
{
  const Ray ray = view.RayThrough(x, y);
  return ray.Origin + frame.Depth[IndexOfPixel(frame, x, y)] * ray.Direction;
}

/// The hit that pixel (x, y) of a window shows, if there is one.
/// \param view   of the frame
/// \param window pixels that the frame fills; the number of rays may differ (PixelRays)
std::optional<PixelHit> FindPixelHit(
  const Frame& frame, const View& view, const glm::ivec2& window, int x, int y);

}

#endif
