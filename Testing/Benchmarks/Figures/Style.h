// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Gallery_Style_h
#define Gallery_Style_h

#include <array>
#include <vector>

class vtkRenderer;
class vtkVolumeProperty;

/// How all pictures of the gallery look.
namespace Style
{

/// Where the viewer stands: directions from the middle of what is shown.
struct View
{
  std::array<double, 3> From = { -1.0, -2.0, 0.8 };
  std::array<double, 3> Up = { 0.0, 0.0, 1.0 };
  double Zoom = 1.3; ///< beyond what shows the sphere around the box
};

void PointCamera(vtkRenderer* renderer, const double bounds[6], const View& view);

/// A key light from the upper left, a weak one from the right and one from the viewer.
void AddLights(vtkRenderer* renderer);

using Color = std::array<double, 3>;
constexpr Color Skin = { 0.94, 0.76, 0.62 };
constexpr Color Bone = { 0.97, 0.94, 0.86 };
constexpr Color Steel = { 0.58, 0.68, 0.82 };
constexpr Color Gold = { 0.96, 0.72, 0.28 };
constexpr Color Coral = { 0.93, 0.40, 0.32 };
constexpr Color Teal = { 0.22, 0.68, 0.66 };
constexpr Color Leaf = { 0.56, 0.72, 0.36 };
constexpr Color Lines = { 0.45, 0.52, 0.62 };

/// A surface of a volume.
struct Surface
{
  double Isovalue;
  Style::Color Color;
  double Opacity = 1.0;
};

/// Isovalues, transfer functions and shading.
void Show(vtkVolumeProperty* property, const std::vector<Surface>& surfaces);

}

#endif
