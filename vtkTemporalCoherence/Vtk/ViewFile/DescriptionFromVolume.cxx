// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ViewFile/DescriptionFromVolume.h"

#include <vtkCamera.h>
#include <vtkColorTransferFunction.h>
#include <vtkPiecewiseFunction.h>
#include <vtkRenderer.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>

#include <algorithm>
#include <limits>

namespace TemporalCoherence
{
namespace
{

constexpr std::size_t MostSurfaces = 8;
constexpr int NumberOfColors = 256;

/// The colour that a volume gives to an isovalue.
glm::dvec3 ColorAt(double isovalue, vtkVolumeProperty* property)
{
  glm::dvec3 color;
  if (property->GetColorChannels() == 1)
  {
    return glm::dvec3(property->GetGrayTransferFunction()->GetValue(isovalue));
  }
  property->GetRGBTransferFunction()->GetColor(isovalue, &color.x);
  return color;
}

glm::dvec3 VectorOf(const double* numbers)
{
  return { numbers[0], numbers[1], numbers[2] };
}

/// Cropping planes of one box, as planes in the world.
void AddBox(const Region& region, const IndexTransform& transform, const glm::dvec3& last,
  std::vector<glm::dvec4>& planes)
{
  if (region.Boxes == Region::AllBoxes)
  {
    return;
  }
  const BoxRange boxes = region.RangeOfBoxes();
  for (int axis = 0; axis < 3; ++axis)
  {
    const glm::dvec2& crop = region.Crops[static_cast<std::size_t>(axis)];
    const double edges[4] = { 0.0, crop.x, crop.y, last[axis] };
    // The plane index[axis] - low >= 0, and its opposite, as rows of the world's coordinates.
    const glm::dvec4 row = RowOf(transform.IndexFromWorld, axis);
    planes.push_back(row - glm::dvec4(0.0, 0.0, 0.0, edges[std::min(boxes.First[axis], 3)]));
    planes.push_back(glm::dvec4(0.0, 0.0, 0.0, edges[std::min(boxes.Last[axis] + 1, 3)]) - row);
  }
}

}

ViewLook LookOf(
  const FrameKey& key, const SurfaceHistogram& surfaces, vtkRenderer* renderer, vtkVolume* volume)
{
  ViewLook look;
  look.Light = key.Appearance;
  vtkVolumeProperty* const property = volume->GetProperty();
  const Surfaces& shown = key.Isosurfaces();
  for (std::size_t i = 0; i < std::min(shown.Isovalues.size(), MostSurfaces); ++i)
  {
    look.Surfaces.push_back({ shown.Isovalues[i], key.Appearance.Colors[i],
      shown.Opacities.empty() ? 1.0 : shown.Opacities[i] });
  }
  if (look.Surfaces.empty())
  {
    constexpr double half = 0.5;
    const double isovalue = surfaces.Counts.empty() ? 0.0 : surfaces.IsovalueAt(half);
    look.Surfaces.push_back({ isovalue, ColorAt(isovalue, property), 1.0 });
  }
  for (int i = 0; i < NumberOfColors && surfaces.Range.x < surfaces.Range.y; ++i)
  {
    const double value = glm::mix(surfaces.Range.x, surfaces.Range.y, i / (NumberOfColors - 1.0));
    look.Colors.emplace_back(value, ColorAt(value, property));
  }
  look.Background = VectorOf(renderer->GetBackground());
  if (renderer->GetGradientBackground())
  {
    look.Background2 = VectorOf(renderer->GetBackground2());
  }
  return look;
}

ViewGeometry GeometryOf(const FrameKey& key, vtkRenderer* renderer, double tolerance)
{
  ViewGeometry geometry;
  geometry.Tolerance = tolerance;
  geometry.Voxel = key.Samples.Shape->VoxelSizeIn(key.Transform).Shortest;
  vtkCamera* const camera = renderer->GetActiveCamera();
  geometry.Camera.Parallel = camera->GetParallelProjection() != 0;
  geometry.Camera.Position = VectorOf(camera->GetPosition());
  geometry.Camera.FocalPoint = VectorOf(camera->GetFocalPoint());
  geometry.Camera.ViewUp = VectorOf(camera->GetViewUp());
  geometry.Camera.ViewAngle = camera->GetViewAngle();
  geometry.Camera.ParallelScale = camera->GetParallelScale();
  geometry.Camera.ClippingRange = { camera->GetClippingRange()[0], camera->GetClippingRange()[1] };
  geometry.Rays = key.View;
  geometry.WorldFromIndex = key.Transform.WorldFromIndex;
  geometry.Box = { glm::dvec3(0.0), glm::dvec3(key.Samples.Dimensions - 1) };
  geometry.Planes = key.Region.Clips;
  geometry.Lights = key.Appearance.Lights;
  AddBox(key.Region, key.Transform, geometry.Box.High, geometry.Planes);
  return geometry;
}

}
