// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Window/RayEnds.h"

#include "Scene/Parallel.h"
#include "Window/DepthReader.h"
#include "Window/OpenGLWindow.h"
#include "Window/PeelingPass.h"
#include "Window/PixelRays.h"

#include <vtkActor2D.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkPropCollection.h>
#include <vtkRenderer.h>
#include <vtkVolume.h>

#include <algorithm>
#include <cstddef>
#include <limits>

namespace TemporalCoherence
{
namespace
{

constexpr std::int64_t RowGrain = 16;

/// The depth of the background.
constexpr float FarthestDepth = 1.0f;

/// The t of a ray at a depth of the window.
double DistanceAt(const View& view, const Ray& ray, float depth)
{
  if (depth >= FarthestDepth)
  {
    return std::numeric_limits<double>::infinity();
  }
  // Clip coordinates are linear along the ray, and the depth gives z / w.
  const double z = 2.0 * static_cast<double>(depth) - 1.0;
  const glm::dvec4 plane = RowOf(view.ClipFromWorld, 2) - z * RowOf(view.ClipFromWorld, 3);
  return -glm::dot(plane, glm::dvec4(ray.Origin, 1.0)) /
    glm::dot(plane, glm::dvec4(ray.Direction, 0.0));
}

/// True if a renderer may have drawn something besides a volume.
bool MayHideVolume(vtkRenderer* renderer, vtkVolume* volume)
{
  if (renderer->GetPreserveDepthBuffer())
  {
    return true; // the depths of other renderers are there
  }
  vtkPropCollection* props = renderer->GetViewProps();
  vtkCollectionSimpleIterator at;
  props->InitTraversal(at);
  while (vtkProp* prop = props->GetNextProp(at))
  {
    if (prop != volume && prop->GetVisibility() && !vtkActor2D::SafeDownCast(prop))
    {
      return true;
    }
  }
  return false;
}

}

RayEnds EndsAt(const std::vector<float>& depths, const glm::ivec2& size, const View& view)
{
  const auto isBackground = [](float depth) { return depth >= FarthestDepth; };
  if (std::all_of(depths.begin(), depths.end(), isBackground))
  {
    return nullptr;
  }
  const glm::ivec2& rays = view.Size;
  const auto ends = std::make_shared<std::vector<double>>(
    static_cast<std::size_t>(rays.x) * static_cast<std::size_t>(rays.y));
  // Each ray ends at the depth of the pixel that holds its centre.
  const PixelRays pixels(size, rays);
  ParallelFor(rays.y, RowGrain,
    [&](std::int64_t row)
    {
      const int y = static_cast<int>(row);
      double* to = ends->data() + row * rays.x;
      for (int x = 0; x < rays.x; ++x)
      {
        const glm::ivec2 pixel = pixels.AtCentre({ x, y });
        const float depth =
          depths[static_cast<std::size_t>(pixel.y) * static_cast<std::size_t>(size.x) +
            static_cast<std::size_t>(pixel.x)];
        *to++ = DistanceAt(view, view.RayThrough(x, y), depth);
      }
    });
  return ends;
}

bool FindRayEnds(vtkRenderer* renderer, vtkVolume* volume, const View& view, RayEnds& ends)
{
  ends = nullptr;
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (!window || !MayHideVolume(renderer, volume))
  {
    return true;
  }
  std::vector<float> depths;
  const PixelRect viewport = ViewportOf(window);
  const auto pass = PeelingPass::Of(volume);
  const bool isRead =
    pass ? pass->ReadOpaqueDepths(viewport.Size, depths) : ReadDepths(window, viewport, depths);
  if (isRead)
  {
    ends = EndsAt(depths, viewport.Size, view);
  }
  return isRead;
}

}
