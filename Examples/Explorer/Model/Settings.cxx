// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Model/Settings.h"

#include "View/Appearance.h"

namespace
{

using Panel = Setting::Panel;
using Data = Setting::Data;

Setting SideOfBox(const char* label, double standard, std::size_t axis)
{
  return { "crop", label, "a side of the box", Panel::Clip, '\0', {}, Data::Any, standard, {}, axis,
    Choose::Cropping };
}

Setting Reflection(const char* label, const char* help, double most)
{
  return { "shading", label, help, Panel::Light, '\0', {}, Data::Any, 0.0, { 0.0, most }, {},
    Choose::OwnShading };
}

// In the order of the enumerations.
std::vector<Setting> MakeTable()
{
  const std::vector<const char*> onOff = { "off", "on" };
  return {
    { "palette", "Colours", "colours over the values", Panel::Surfaces, 'P', PaletteNames() },
    { "material", "Material", "material: matt or glossy", Panel::Light, 'M', MaterialNames() },
    { "light", "Light", "light: where it comes from", Panel::Light, 'L', LightNames() },
    { "surface", "Surface", "open surface or capped solid", Panel::Surfaces, 'V',
      { "crossing", "solid" }, Data::Surfaces },
    { "accuracy", "Accuracy", "accuracy of pictures as the view moves", Panel::Reuse, 'A',
      { "exact", "paper" } },
    { "image-cache", "Re-use pictures", "start from earlier pictures where the accuracy lets it",
      Panel::Reuse, 'C', onOff, Data::Any, 1.0 },
    { "isomap", "Isomap", "isomap: look isovalues up in a still view", Panel::Reuse, 'I', onOff,
      Data::Any, 1.0 },
    { "leaping", "Space leaping", "leap over empty space", Panel::Reuse, 'J', onOff, Data::Any,
      1.0 },
    { "map-ahead", "Isomap at first drag", "build the whole isomap when a drag begins",
      Panel::Reuse, 'K', onOff, Data::Any, 1.0 },
    { "answers", "Yellow: cast anew", "yellow: what the image cache did not serve", Panel::Reuse,
      'Y', onOff },
    { "scale", "Picture scale", "size of a saved picture, in views", Panel::Reuse, 'X',
      { "1", "2", "4" } },
    { "film", "Recording", "recordings as pictures or as a film", Panel::Reuse, 'F',
      { "png", "ogv" } },
    { "gradients", "Mesh normals", "normals of meshes: those of cells, with facets, or smooth",
      Panel::Light, 'G', { "facets", "smooth" }, Data::Meshes },
    { "drawing", "Draw", "surfaces, or the blended volume", Panel::Surfaces, 'D',
      { "surfaces", "composite", "maximum", "minimum", "average", "additive" }, Data::Images },
    { "clipping", "Clip by a plane", "clip by a plane: drag it, or its arrow, in the view",
      Panel::Clip, 'T', onOff },
    { "cropping", "Crop to a box", "crop to a box: drag its sides in the view", Panel::Clip, 'E',
      onOff },
    { "", "", "", Panel::None, '\0', onOff },
    { "density", "Density", "of the blended volume: how soon it is opaque", Panel::Surfaces, '\0',
      {}, Data::Blended, 1.0, { 1e-3, 1e3 }, {}, Choose::Count, true },
    SideOfBox("X from", -1e300, 0),
    SideOfBox("X to", 1e300, 0),
    SideOfBox("Y from", -1e300, 1),
    SideOfBox("Y to", 1e300, 1),
    SideOfBox("Z from", -1e300, 2),
    SideOfBox("Z to", 1e300, 2),
    Reflection("Ambient", "light from everywhere", 1.0),
    Reflection("Diffuse", "light that shows the shape", 1.0),
    Reflection("Specular", "how bright highlights are", 1.0),
    Reflection("Power", "how small highlights are", 200.0),
    { "", "Opacity", "of the selected surface: less is see-through", Panel::Surfaces, '\0', {} },
  };
}

}

const std::vector<Setting>& AllSettings()
{
  static const std::vector<Setting> table = MakeTable();
  return table;
}

std::size_t Setting::Row() const
{
  return static_cast<std::size_t>(this - AllSettings().data());
}

Look::Look()
{
  for (std::size_t i = 0; i < Choose::Count; ++i)
  {
    this->Choices[i] = static_cast<int>(AllSettings()[i].Default);
  }
  for (std::size_t i = 0; i < Number::Count; ++i)
  {
    this->Numbers[i] = AllSettings()[Choose::Count + i].Default;
  }
}

const char* Look::TextOf(Choose::Which what) const
{
  return AllSettings()[what].Values[static_cast<std::size_t>(this->Choices[what])];
}
