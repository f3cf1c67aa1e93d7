// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_BeamCameras_h
#define Testing_BeamCameras_h

#include "Checks/Sanitized.h"
#include "Scene/View.h"

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <cstddef>
#include <vector>

/// A camera anywhere, in index space as world.
struct Camera
{
  glm::dvec3 Eye, Towards;
  double Pixel; ///< width of a pixel at distance 1, or of a parallel view's pixels
  bool Parallel;
};

inline TemporalCoherence::View ViewFrom(const Camera& camera, int pixels)
{
  const glm::dvec3 along = glm::normalize(camera.Towards - camera.Eye);
  const glm::dvec3 up =
    std::abs(along.z) > 0.9 ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(0.0, 0.0, 1.0);
  const double half = 0.5 * camera.Pixel * pixels, near = 1e-3, far = 1e4;
  const glm::dmat4 projection = camera.Parallel
    ? glm::ortho(-half, half, -half, half, near, far)
    : glm::frustum(-half * near, half * near, -half * near, half * near, near, far);
  TemporalCoherence::View view;
  TemporalCoherence::MakeView(glm::lookAt(camera.Eye, camera.Towards, up), projection,
    { near, far }, glm::ivec2(pixels), view);
  return view;
}

/// All cameras, or every fifth where a sanitizer makes each ten times as slow.
constexpr std::size_t EveryNthCamera = IsMemorySanitized ? 5 : 1;

/// Cameras around a grid, in it, along its axes, faces and edges, near and far.
inline std::vector<Camera> CamerasFor(const glm::ivec3& dimensions)
{
  const glm::dvec3 centre = 0.5 * glm::dvec3(dimensions - 1);
  const double radius = glm::length(centre);
  std::vector<Camera> cameras;
  for (const glm::dvec3& from :
    { glm::dvec3(-1.0, -2.0, 0.8), glm::dvec3(1.0, 0.3, -0.6), glm::dvec3(0.0, 0.0, 1.0),
      glm::dvec3(0.0, -1.0, 0.0), glm::dvec3(1.0, 1.0, 0.0), glm::dvec3(-1.0, 1.0, 1.0) })
  {
    const glm::dvec3 eye = centre + 3.0 * radius * glm::normalize(from);
    for (const double pixel : { 0.01, 0.1, 0.33, 1.0, 2.0, 10.0 })
    {
      cameras.push_back({ eye, centre, pixel, true });
      cameras.push_back({ eye, centre, pixel / (2.0 * radius), false });
    }
    cameras.push_back({ centre + 0.3 * from, centre - from, 0.02, false });
    cameras.push_back({ centre, centre - from, 0.2, false });
    // From a sample, past samples: on planes between cells, and along edges.
    const glm::dvec3 sample = glm::floor(centre);
    cameras.push_back({ sample + 100.0 * from, sample, 1.0, true });
    cameras.push_back({ sample + 60.0 * from, sample, 1.0 / 128, false });
    cameras.push_back({ sample, sample - from, 0.125, false });
  }
  std::vector<Camera> chosen;
  for (std::size_t i = 0; i < cameras.size(); i += EveryNthCamera)
  {
    chosen.push_back(cameras[i]);
  }
  return chosen;
}

#endif
