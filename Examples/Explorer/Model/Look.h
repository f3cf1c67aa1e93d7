// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Look_h
#define Look_h

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

using Point = std::array<double, 3>;
using Rgb = std::array<double, 3>; // 0 to 1
using Box = std::array<double, 6>; // from and to, of x, y and z

// What is one of a few values.
struct Choose
{
  enum Which : std::size_t
  {
    Palette,
    Material,
    Light,
    Surface,
    Accuracy,
    ImageCache,
    Isomap,
    Leaping,
    Ahead,
    Answers,
    Scale,
    Film,
    Gradients,
    Drawing,
    Clipping,
    Cropping,
    Count,
  };
};

// Panels, menus, keys, sessions and the help are made of the list of these.
struct Choice
{
  enum class Panel
  {
    Surfaces,
    Clip,
    Light,
    Reuse,
  };
  enum class Data
  {
    Any,
    Meshes, // it has no effect on images and rectilinear grids
    Images, // meshes cannot be drawn so
  };

  Choose::Which What;
  const char* Name;  // in sessions
  const char* Label; // for people
  char Key;
  const char* Help;
  std::vector<const char*> Values;
  Panel In;
  Data For = Data::Any;
};
const std::vector<Choice>& AllChoices(); // in the order of the enumeration

// A surface at an isovalue, or a node of the opacity of a blended volume.
struct Marker
{
  double Value = 0.0;
  double Opacity = 1.0;
  bool IsVisible = true;         // of a surface
  std::optional<Rgb> Color = {}; // none: the palette's
};

struct Plane // in the world; what the normal points to is seen
{
  Point Origin = {};
  Point Normal = {}; // none: where it suits the view
};

// All settings that can be undone.
struct Look
{
  std::array<int, Choose::Count> Choices = { 0, 0, 0, 0, 0, 1, 1, 1, 1 }; // exact, and all re-use
  std::vector<Marker> Surfaces; // one at least, once a volume is open
  std::vector<Marker> Nodes;    // in ascending order of values; two at least
  double Density = 1.0;         // of blended volumes: a hundredth of the volume is so opaque
  Plane Clip;
  Box Crop = { -1e300, 1e300, -1e300, 1e300, -1e300, 1e300 }; // along the data's own axes
  bool HasShading = false;                                    // of its own: not the material's
  std::array<double, 4> Shading = {};                         // ambient to power

  const char* TextOf(Choose::Which what) const
  {
    return AllChoices()[what].Values[static_cast<std::size_t>(this->Choices[what])];
  }
};

#endif
