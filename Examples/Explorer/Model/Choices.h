// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Choices_h
#define Choices_h

#include <array>
#include <cstddef>
#include <vector>

// Everything that is one of a few: panels, menus, keys, sessions and the help are made of this
// list.
enum class Choose
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
};
constexpr std::size_t NumberOfChoices = 14;

// What of Choose::Drawing shows surfaces; the others blend.
constexpr int DrawSurfaces = 0;

struct Choice
{
  enum class Panel
  {
    Drawing,
    Light,
    Reuse,
    Output,
  };
  enum class Data
  {
    Any,
    Meshes, // it has no effect on images and rectilinear grids
    Images, // meshes cannot be drawn so
  };

  Choose What;
  const char* Name;  // in sessions and logs
  const char* Label; // for people
  char Key;
  const char* Help;
  std::vector<const char*> Values;
  Panel In;
  Data For = Data::Any;

  bool IsSwitch() const;
};

// In the order of the enumeration.
const std::vector<Choice>& AllChoices();
const Choice& ChoiceOf(Choose what);

// The value chosen of each.
class Chosen
{
public:
  Chosen();
  int operator[](Choose what) const { return this->Values[static_cast<std::size_t>(what)]; }
  int& operator[](Choose what) { return this->Values[static_cast<std::size_t>(what)]; }
  bool IsOn(Choose what) const { return (*this)[what] != 0; }
  const char* TextOf(Choose what) const;
  bool operator==(const Chosen& other) const { return this->Values == other.Values; }

private:
  std::array<int, NumberOfChoices> Values{};
};

#endif
