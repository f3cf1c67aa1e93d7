// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Viewpoint_h
#define Viewpoint_h

#include <array>
#include <string>

class vtkRenderer;

// Slightly from above: more of the shape is seen than in a level view.
constexpr double UsualElevation = 6.0; // degrees

// Places around a volume from which all of it is seen.
class Viewpoint
{
public:
  Viewpoint() = default;

  // Fits the renderer's camera to the bounds. The axes are "+y" and the like: the viewer's place,
  // seen from the middle, and the way up; `from` gives way where both are on one axis.
  Viewpoint(
    vtkRenderer* renderer, const double bounds[6], const std::string& from, const std::string& up);

  // Walk around the volume: an azimuth of 0 degrees is where `from` said. The elevation is less
  // than 90 degrees up or down.
  void PlaceCamera(
    vtkRenderer* renderer, double azimuthDegrees, double elevationDegrees = UsualElevation) const;

  // How much of the half width or height of a picture the bounds take, seen from where the camera
  // is: 1 fills it.
  // \param aspect width of the picture by its height
  double ShareOfView(vtkRenderer* renderer, double aspect) const;

private:
  std::array<double, 6> Bounds = {};
  std::array<double, 3> From = {};
  std::array<double, 3> Up = {};
  std::array<double, 3> Middle = {};
  double Distance = 1.0;
};

#endif
