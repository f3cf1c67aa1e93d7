// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "View/Viewpoint.h"

#include <vtkCamera.h>
#include <vtkMath.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>

namespace
{

// Slightly from above: more of the shape is seen than in a level view.
constexpr double ElevationDegrees = 6.0;

// ResetCamera fits the sphere around the volume's box; few objects fill its corners.
constexpr double ZoomBeyondFit = 1.25;

std::array<double, 3> AxisVector(const std::string& axis)
{
  std::array<double, 3> vector = { 0.0, 0.0, 0.0 };
  vector[static_cast<std::size_t>(axis[1] - 'x')] = axis[0] == '-' ? -1.0 : 1.0;
  return vector;
}

}

Viewpoint::Viewpoint(
  vtkRenderer* renderer, const double bounds[6], const std::string& from, const std::string& up)
  : From(AxisVector(from[1] == up[1] ? "+z" : from))
  , Up(AxisVector(up))
{
  std::copy_n(bounds, 6, this->Bounds.begin());
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetViewAngle(30.0);
  renderer->ResetCamera(bounds);
  camera->GetFocalPoint(this->Middle.data());
  this->Distance = camera->GetDistance();
  camera->Zoom(ZoomBeyondFit);
}

void Viewpoint::PlaceCamera(vtkRenderer* renderer, double azimuthDegrees) const
{
  const double azimuth = vtkMath::RadiansFromDegrees(azimuthDegrees);
  const double elevation = vtkMath::RadiansFromDegrees(ElevationDegrees);
  double side[3];
  vtkMath::Cross(this->Up.data(), this->From.data(), side);
  double position[3];
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double level = std::cos(azimuth) * this->From[axis] + std::sin(azimuth) * side[axis];
    position[axis] = this->Middle[axis] +
      this->Distance * (std::cos(elevation) * level + std::sin(elevation) * this->Up[axis]);
  }
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(position);
  camera->SetFocalPoint(this->Middle.data());
  camera->SetViewUp(this->Up.data());
  renderer->ResetCameraClippingRange(this->Bounds.data());
}
