// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Model/Look.h"

#include "View/Appearance.h"

const std::vector<Choice>& AllChoices()
{
  using Panel = Choice::Panel;
  using Data = Choice::Data;
  static const std::vector<const char*> onOff = { "off", "on" };
  static const std::vector<Choice> choices = {
    { Choose::Palette, "palette", "Colours", 'P', "colours over the values", PaletteNames(),
      Panel::Surfaces },
    { Choose::Material, "material", "Material", 'M', "material: matt or glossy", MaterialNames(),
      Panel::Light },
    { Choose::Light, "light", "Light", 'L', "light: where it comes from", LightNames(),
      Panel::Light },
    { Choose::Surface, "surface", "Surface", 'V', "open surface or capped solid",
      { "crossing", "solid" }, Panel::Surfaces },
    { Choose::Accuracy, "accuracy", "Accuracy", 'A', "accuracy of pictures as the view moves",
      { "exact", "paper" }, Panel::Reuse },
    { Choose::ImageCache, "image-cache", "Re-use pictures", 'C',
      "start from earlier pictures where the accuracy lets it", onOff, Panel::Reuse },
    { Choose::Isomap, "isomap", "Isomap", 'I', "isomap: look isovalues up in a still view", onOff,
      Panel::Reuse },
    { Choose::Leaping, "leaping", "Space leaping", 'J', "leap over empty space", onOff,
      Panel::Reuse },
    { Choose::Ahead, "map-ahead", "Isomap at first drag", 'K',
      "build the whole isomap when a drag begins", onOff, Panel::Reuse },
    { Choose::Answers, "answers", "Yellow: cast anew", 'Y',
      "yellow: what the image cache did not serve", onOff, Panel::Reuse },
    { Choose::Scale, "scale", "Picture scale", 'X', "size of a saved picture, in views",
      { "1", "2", "4" }, Panel::Reuse },
    { Choose::Film, "film", "Recording", 'F', "recordings as pictures or as a film",
      { "png", "ogv" }, Panel::Reuse },
    { Choose::Gradients, "gradients", "Mesh normals", 'G',
      "normals of meshes: those of cells, with facets, or smooth", { "facets", "smooth" },
      Panel::Light, Data::Meshes },
    { Choose::Drawing, "drawing", "Draw", 'D', "surfaces, or the blended volume",
      { "surfaces", "composite", "maximum", "minimum", "average", "additive" }, Panel::Surfaces,
      Data::Images },
    { Choose::Clipping, "clipping", "Clip by a plane", 'T',
      "clip by a plane: drag it, or its arrow, in the view", onOff, Panel::Clip },
    { Choose::Cropping, "cropping", "Crop to a box", 'E',
      "crop to a box: drag its sides in the view", onOff, Panel::Clip },
  };
  return choices;
}
