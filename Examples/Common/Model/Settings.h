// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Settings_h
#define Settings_h

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

using Point = std::array<double, 3>;
using Rgb = std::array<double, 3>; // 0 to 1
using Box = std::array<double, 6>; // from and to, of x, y and z

// The rows of the table of settings, in its order.
struct Row
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
    Occlusion,
    Shadows,
    Preset, // of the blended volume
    Cut,    // what is seen on the clipping plane
    Background,
    Projection,
    Outline,
    Axes,
    ScaleBar,
    ColorBar,
    Transparency,                  // of saved pictures
    ColorMap,                      // of an array that gives surfaces their colours
    OwnShading,                    // else it is that of the material
    Shading,                       // ambient, diffuse, specular, power
    OcclusionRadius = Shading + 4, // as a share of the longest edge
    OcclusionStrength,
    Density,
    Brightness, // of averages and sums; 0: it is to be fitted
    Shift,      // of the nodes, since the preset was chosen
    LabelRadius,
    Crop, // a box along the data's own axes
    Count = Crop + 6,
    Opacity = Count, // is that of the selected marker
    Window,          // these two are those of the greys
    Level,
  };
};

// Words of Row::Drawing and of Row::Cut.
struct Drawing
{
  enum Way
  {
    Surfaces,
    Composite,
    Maximum,
    Minimum,
    Average,
    Additive,
    Labels
  };
};
struct OnCut
{
  enum What
  {
    Nothing,
    Greys,
    Colors
  };
};

class Model;

// A surface at an isovalue, a node of the opacity of a blended volume, or an end of the greys.
struct Marker
{
  double Value = 0.0;
  double Opacity = 1.0;
  bool IsVisible = true;         // of a surface
  std::optional<Rgb> Color = {}; // none: the palette's
};

// How a label of a label map is drawn.
struct LabelLook
{
  int Label = 0;
  Rgb Color = {};
  double Opacity = 1.0;
  bool IsVisible = true;
  std::string Name = {}; // printable; may be empty

  bool operator==(const LabelLook& other) const
  {
    return this->Label == other.Label && this->Color == other.Color &&
      this->Opacity == other.Opacity && this->IsVisible == other.IsVisible &&
      this->Name == other.Name;
  }
};

// The array whose values give surfaces, or labels, their colours.
struct ArrayColor
{
  std::string Name;  // empty: there is none
  int Component = 0; // -1: the length of vectors
};

constexpr double SeeThrough = 0.35; // opacity of a surface around another

// The colour of a surface beside others, from the second on.
Rgb ContrastOf(std::size_t surface);

// A colour for a label that no file tells; labels that follow one another differ much.
Rgb ColorOfLabel(int label);

struct Plane // in the world; what the normal points to is seen
{
  Point Origin = {};
  Point Normal = {}; // none: where it suits the view
};

// All settings that can be undone.
struct Look
{
  Look();               // as by default
  static Look Before(); // as sessions mean that are older than settings that they do not tell
  int Choice(Row::Which what) const { return static_cast<int>(this->Values[what]); }
  const char* TextOf(Row::Which choice) const;

  // What has no surfaces.
  bool Blends() const
  {
    const int way = this->Choice(Row::Drawing);
    return way != Drawing::Surfaces && way != Drawing::Labels;
  }
  // Maximum or minimum: one value of a ray is shown, in grey.
  bool IsProjection() const;

  std::array<double, Row::Count> Values; // of a choice: the place of its word
  std::vector<Marker> Surfaces;          // one at least, once a volume is open
  std::vector<Marker> Nodes;             // in ascending order of values; two at least
  std::vector<Marker> Greys;             // of projections: the values of black and of white
  std::vector<LabelLook> Labels;         // of the data, ascending, once they were drawn
  Plane Clip;
  ArrayColor ColorBy;
};

// A row of the table of settings: one of a few values, or a number. Panels, menus, keys, names of
// what is undone, sessions and the help are made of the rows; VolumeView::Apply() draws with them.
struct Setting
{
  const char* Name;  // in sessions, where rows of one name share a line; none: in no line
  const char* Label; // for people
  const char* Help;
  const char* Panel; // and part of it; none: neither a panel nor a menu has it
  char Key;
  std::vector<const char*> Words;       // of a choice; none: it is a number
  bool (Model::*For)() const = nullptr; // null: for any data, drawn in any way
  double Default = 0.0;
  std::optional<double> Before = {}; // where sessions do not tell it, as it was made later
  // Of a number.
  std::array<double, 2> Range = { 0.0, 1.0 };
  std::optional<std::size_t> Axis = {}; // along which the data's bounds are the range
  Row::Which Switch = Row::Count;       // goes on with a change; off: not in sessions
  bool IsLogarithmic = false;

  bool IsChoice() const { return !this->Words.empty(); }
  std::size_t Place() const; // in the table
};
const std::vector<Setting>& AllSettings();

#endif
