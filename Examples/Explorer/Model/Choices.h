// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Choices_h
#define Choices_h

#include <array>
#include <cstddef>
#include <string>
#include <vector>

// Everything that is one of a few: the bar of switches, the keys, sessions and the help are all
// made from this list.
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
};
constexpr std::size_t NumberOfChoices = 13;

struct Choice
{
  Choose What;
  const char* Name;  // in sessions and logs
  const char* Label; // for people
  char Key;
  const char* Help;
  std::vector<const char*> Values;
  bool IsForMeshes = false; // has no effect on images and rectilinear grids

  bool IsSwitch() const { return std::string(this->Values[0]) == "off"; }
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

private:
  std::array<int, NumberOfChoices> Values{};
};

#endif
