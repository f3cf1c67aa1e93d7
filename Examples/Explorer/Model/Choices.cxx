// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Model/Choices.h"

#include "View/Appearance.h"

#include <string>

const std::vector<Choice>& AllChoices()
{
  using Panel = Choice::Panel;
  using Data = Choice::Data;
  static const std::vector<const char*> onOff = { "off", "on" };
  static const std::vector<Choice> choices = {
    { Choose::Palette, "palette", "Colours", 'p', "colours over the values", PaletteNames(),
      Panel::Drawing },
    { Choose::Material, "material", "Material", 'm', "material: matt or glossy", MaterialNames(),
      Panel::Light },
    { Choose::Light, "light", "Light", 'l', "light: where it comes from", LightNames(),
      Panel::Light },
    { Choose::Surface, "surface", "Surface", 'v', "open surface or capped solid",
      { "crossing", "solid" }, Panel::Drawing },
    { Choose::Accuracy, "accuracy", "Accuracy", 'a', "accuracy of pictures as the view moves",
      { "bounded", "exact", "paper" }, Panel::Reuse },
    { Choose::ImageCache, "image-cache", "Image cache", 'c',
      "image cache: start from earlier pictures where the accuracy lets it", onOff, Panel::Reuse },
    { Choose::Isomap, "isomap", "Isomap", 'i', "isomap: look isovalues up in a still view", onOff,
      Panel::Reuse },
    { Choose::Leaping, "leaping", "Space leaping", 'j', "leap over empty space", onOff,
      Panel::Reuse },
    { Choose::Ahead, "map-ahead", "Isomap at first drag", 'k',
      "build the whole isomap when a drag begins", onOff, Panel::Reuse },
    { Choose::Answers, "answers", "Yellow: cast anew", 'y',
      "yellow: what the image cache did not serve", onOff, Panel::Reuse },
    { Choose::Scale, "scale", "Picture scale", 'x', "size of a saved picture, in views",
      { "1", "2", "4" }, Panel::Output },
    { Choose::Film, "film", "Recording", 'f', "recordings as pictures or as a film",
      { "png", "ogv" }, Panel::Output },
    { Choose::Gradients, "gradients", "Mesh normals", 'g',
      "normals of meshes: those of cells, with facets, or smooth", { "facets", "smooth" },
      Panel::Light, Data::Meshes },
    { Choose::Drawing, "drawing", "Draw", 'd', "surfaces, or the blended volume",
      { "surfaces", "composite", "maximum", "minimum", "average", "additive" }, Panel::Drawing,
      Data::Images },
  };
  return choices;
}

const Choice& ChoiceOf(Choose what)
{
  return AllChoices()[static_cast<std::size_t>(what)];
}

bool Choice::IsSwitch() const
{
  return this->Values[0] == std::string("off");
}

Chosen::Chosen()
{
  for (const Choose what :
    { Choose::Accuracy, Choose::ImageCache, Choose::Isomap, Choose::Leaping, Choose::Ahead })
  {
    (*this)[what] = 1;
  }
}

const char* Chosen::TextOf(Choose what) const
{
  return ChoiceOf(what).Values[static_cast<std::size_t>((*this)[what])];
}
