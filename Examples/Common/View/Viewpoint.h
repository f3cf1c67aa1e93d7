// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Viewpoint_h
#define Viewpoint_h

#include <array>
#include <string>

class vtkRenderer;

// Places around a volume from which all of it is seen.
class Viewpoint
{
public:
  Viewpoint() = default;

  // Fits the renderer's camera to the bounds. The axes are "+y" and the like: the viewer's place,
  // seen from the middle, and the way up; `from` gives way where both are on one axis.
  Viewpoint(
    vtkRenderer* renderer, const double bounds[6], const std::string& from, const std::string& up);

  // Walk around the volume: 0 degrees is where `from` said.
  void PlaceCamera(vtkRenderer* renderer, double azimuthDegrees) const;

private:
  std::array<double, 6> Bounds = {};
  std::array<double, 3> From = {};
  std::array<double, 3> Up = {};
  std::array<double, 3> Middle = {};
  double Distance = 1.0;
};

#endif
