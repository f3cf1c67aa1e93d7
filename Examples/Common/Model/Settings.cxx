// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Model/Settings.h"

#include "Model/Model.h"
#include "View/Appearance.h"

#include <vtkMath.h>
#include <vtkTemporalCoherencePresets.h>

#include <algorithm>
#include <cmath>

namespace
{

Setting SideOfBox(const char* label, double standard, std::size_t axis)
{
  return { "crop", label, "a side of the box", "Crop", '\0', {}, nullptr, standard, {}, {}, axis,
    Row::Cropping };
}

Setting Reflection(const char* label, const char* help, double most)
{
  return { "shading", label, help, "Light", '\0', {}, nullptr, 0.0, {}, { 0.0, most }, {},
    Row::OwnShading };
}

// A number of a switch that sessions have had since there is the switch.
Setting PartOfLight(const char* name, const char* label, const char* help, double standard,
  const std::array<double, 2>& range, Row::Which ofSwitch, bool isLogarithmic = false)
{
  return { name, label, help, "Light", '\0', {}, &Model::DrawsSurfaces, standard, {}, range, {},
    ofSwitch, isLogarithmic };
}

// "own" first: nodes that are no preset's, or no more.
std::vector<const char*> NamesOfPresets()
{
  std::vector<const char*> names = { "own" };
  for (int i = 0; i < vtkTemporalCoherencePresets::GetNumberOfPresets(); ++i)
  {
    names.push_back(vtkTemporalCoherencePresets::GetPresetName(i));
  }
  return names;
}

double PlaceOfPalette(const std::string& name)
{
  const std::vector<const char*> names = PaletteNames();
  return static_cast<double>(std::find(names.begin(), names.end(), name) - names.begin());
}

std::vector<Setting> MakeTable()
{
  const std::vector<const char*> onOff = { "off", "on" };
  return {
    { "palette", "Colours", "colours over the values", "Surfaces", 'P', PaletteNames(),
      &Model::ShowsPalette },
    { "material", "Material", "material: matt or glossy", "Light", 'M', MaterialNames() },
    { "light", "Light", "light: where it comes from", "Light", 'L', LightNames() },
    { "surface", "Surface", "open surface or capped solid", "Surfaces", 'V', { "open", "solid" },
      &Model::HasIsovalues },
    { "accuracy", "Accuracy", "accuracy of pictures as the view moves", "Re-use", 'A',
      { "exact", "paper" } },
    { "image-cache", "Re-use pictures", "start from earlier pictures where the accuracy lets it",
      "Re-use", 'C', onOff, nullptr, 1.0 },
    { "isomap", "Isomap", "isomap: look isovalues up in a still view", "Re-use", 'I', onOff,
      nullptr, 1.0 },
    { "leaping", "Space leaping", "leap over empty space", "Re-use", 'J', onOff, nullptr, 1.0 },
    { "map-ahead", "Isomap before a drag", "build the whole isomap when a drag begins", "Re-use",
      'K', onOff, nullptr, 1.0 },
    { "answers", "Show re-use in yellow", "yellow: what the image cache did not serve", "Re-use",
      'Y', onOff },
    { "scale", "Picture scale", "size of a saved picture, in views", "Scene", 'X',
      { "1", "2", "4" } },
    { "film", "Recording", "recordings as pictures or as a film", "Scene", 'F', { "png", "ogv" } },
    { "gradients", "Mesh normals", "normals of meshes: those of cells, with facets, or smooth",
      "Light", 'G', { "facets", "smooth" }, &Model::DrawsMesh, 1.0, 0.0 },
    { "drawing", "Draw", "surfaces, the blended volume, or the labels of a segmentation",
      "Surfaces", 'D',
      { "surfaces", "composite", "maximum", "minimum", "average", "additive", "labels" },
      &Model::DrawsImage },
    { "clipping", "Clip by a plane", "clip by a plane: drag it, or its arrow, in the view", "Clip",
      'T', onOff },
    { "cropping", "Crop to a box", "crop to a box: drag its sides in the view", "Crop", 'E',
      onOff },
    { "occlusion", "Ambient occlusion", "ambient occlusion: hollows are darker, so depth shows",
      "Light", '1', onOff, &Model::DrawsSurfaces, 1.0, 0.0 },
    { "shadows", "Shadows", "shadows of surfaces on one another, by all lights but headlights",
      "Light", '3', onOff, &Model::DrawsSurfaces, 0.0, 0.0 },
    { "preset", "Preset", "colours and opacities by name; Shift moves them over the values",
      "Surfaces", '\0', NamesOfPresets(), &Model::HasNodes },
    { "cut", "On the plane", "what the clipping plane shows where it cuts", "Clip", '4',
      { "nothing", "grey values", "colours" }, &Model::CanShowCut },
    { "background", "Background", "background of the view and of pictures", "Scene", '2',
      { "dark", "grey", "white" } },
    { "projection", "Projection", "what is far away is smaller, or not", "Scene", '5',
      { "perspective", "parallel" } },
    { "outline", "Outline", "the edges of the volume's box", "Scene", '6', onOff },
    { "axes", "Axes", "which way x, y and z go", "Scene", '7', onOff },
    { "scale-bar", "Scale bar", "how long a distance is in the middle of the view", "Scene", '8',
      onOff },
    { "color-bar", "Colour bar", "which value has which colour", "Scene", '9', onOff },
    { "transparency", "Transparent pictures", "saved pictures have no background", "Scene", '\0',
      onOff },
    { "color-map", "Colour map", "colours over the values of the array that colours surfaces",
      "Surfaces", '\0', PaletteNames(), &Model::ColorsByArray, PlaceOfPalette("cool-warm") },
    { "", "", "", "", '\0', onOff },
    Reflection("Ambient", "light from everywhere", 1.0),
    Reflection("Diffuse", "light that shows the shape", 1.0),
    Reflection("Specular", "how bright highlights are", 1.0),
    Reflection("Power", "how small highlights are", 200.0),
    PartOfLight("occlusion-radius", "Occlusion radius",
      "how far surfaces keep light away: a share of the longest edge", 0.125, { 0.01, 1.0 },
      Row::Occlusion, true),
    PartOfLight("occlusion-strength", "Occlusion strength", "how dark hollows are", 1.0,
      { 0.0, 1.0 }, Row::Occlusion),
    { "density", "Density", "of the blended volume: how soon it is opaque", "Surfaces", '\0', {},
      &Model::HasNodes, 1.0, {}, { 1e-3, 1e3 }, {}, Row::Count, true },
    { "brightness", "Brightness", "of averages and sums", "Surfaces", '\0', {}, &Model::AddsUp, 0.0,
      {}, { 1e-3, 1e3 }, {}, Row::Count, true },
    { "shift", "Shift", "moves colours and opacities over the values", "Surfaces", '\0', {},
      &Model::HasNodes },
    { "label-radius", "Smoothness", "of labels: how far around they are smoothed, in samples",
      "Labels", '\0', {}, &Model::DrawsLabels, 2.5, {}, { 0.0, 8.0 } },
    SideOfBox("X from", -1e300, 0),
    SideOfBox("X to", 1e300, 0),
    SideOfBox("Y from", -1e300, 1),
    SideOfBox("Y to", 1e300, 1),
    SideOfBox("Z from", -1e300, 2),
    SideOfBox("Z to", 1e300, 2),
    { "", "Opacity", "of the selected surface: less is see-through", "Surfaces", '\0', {},
      &Model::HasMarkers },
    { "", "Window", "how many values lie from black to white", "Surfaces", '\0', {},
      &Model::HasGreys },
    { "", "Level", "the value of middle grey", "Surfaces", '\0', {}, &Model::HasGreys },
  };
}

}

const std::vector<Setting>& AllSettings()
{
  static const std::vector<Setting> table = MakeTable();
  return table;
}

std::size_t Setting::Place() const
{
  return static_cast<std::size_t>(this - AllSettings().data());
}

Rgb ContrastOf(std::size_t surface)
{
  constexpr std::array<Rgb, 4> contrasts = { { { 0.96, 0.90, 0.72 }, { 0.36, 0.66, 0.92 },
    { 0.92, 0.42, 0.36 }, { 0.48, 0.80, 0.50 } } };
  return contrasts[(surface + contrasts.size() - 1) % contrasts.size()];
}

Rgb ColorOfLabel(int label)
{
  constexpr double golden = 0.618033988749895; // hues never come close to one another soon
  const double turns = golden * label;
  Rgb color;
  vtkMath::HSVToRGB(
    turns - std::floor(turns), label % 2 == 0 ? 0.45 : 0.7, 0.95, &color[0], &color[1], &color[2]);
  return color;
}

Look::Look()
{
  std::transform(AllSettings().begin(), AllSettings().begin() + Row::Count, this->Values.begin(),
    [](const Setting& setting) { return setting.Default; });
}

Look Look::Before()
{
  Look look;
  for (std::size_t row = 0; row < Row::Count; ++row)
  {
    look.Values[row] = AllSettings()[row].Before.value_or(look.Values[row]);
  }
  return look;
}

bool Look::IsProjection() const
{
  const int way = this->Choice(Row::Drawing);
  return way == Drawing::Maximum || way == Drawing::Minimum;
}

const char* Look::TextOf(Row::Which choice) const
{
  return AllSettings()[choice].Words[static_cast<std::size_t>(this->Values[choice])];
}
