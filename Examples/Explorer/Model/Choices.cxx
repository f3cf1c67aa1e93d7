// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Model/Choices.h"

#include "Model/Appearance.h"

const std::vector<Choice>& AllChoices()
{
  static const std::vector<const char*> onOff = { "off", "on" };
  static const std::vector<Choice> choices = {
    { Choose::Palette, "palette", "Colour", 'p', "colours of the surface", PaletteNames() },
    { Choose::Material, "material", "Material", 'm', "material: matt or glossy", MaterialNames() },
    { Choose::Light, "light", "Light", 'l', "light: where it comes from", LightNames() },
    { Choose::Surface, "surface", "Surface", 'v', "open surface or capped solid",
      { "crossing", "solid" } },
    { Choose::Accuracy, "accuracy", "Accuracy", 'a', "accuracy of pictures as the view moves",
      { "bounded", "exact", "paper" } },
    { Choose::ImageCache, "image-cache", "Image cache", 'c',
      "image cache: start from earlier pictures where the accuracy lets it", onOff },
    { Choose::Isomap, "isomap", "Isomap", 'i', "isomap: look isovalues up in a still view", onOff },
    { Choose::Leaping, "leaping", "Space leaping", 'j', "leap over empty space", onOff },
    { Choose::Ahead, "map-ahead", "Map at first drag", 'k',
      "build the whole isomap when a drag begins", onOff },
    { Choose::Answers, "answers", "Yellow: cast anew", 'y',
      "yellow: what the image cache did not serve", onOff },
    { Choose::Scale, "scale", "Picture scale", 'x', "size of a saved picture, in views",
      { "1", "2", "4" } },
    { Choose::Film, "film", "Film", 'f', "recordings as pictures or as a film", { "png", "ogv" } },
    { Choose::Gradients, "gradients", "Mesh normals", 'g',
      "normals of meshes: those of cells, with facets, or smooth", { "facets", "smooth" }, true },
  };
  return choices;
}

const Choice& ChoiceOf(Choose what)
{
  return AllChoices()[static_cast<std::size_t>(what)];
}

Chosen::Chosen()
{
  (*this)[Choose::Accuracy] = 1;
  (*this)[Choose::ImageCache] = 1;
  (*this)[Choose::Isomap] = 1;
  (*this)[Choose::Leaping] = 1;
  (*this)[Choose::Ahead] = 1;
}

const char* Chosen::TextOf(Choose what) const
{
  return ChoiceOf(what).Values[static_cast<std::size_t>((*this)[what])];
}
