// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ColorArrays_h
#define ColorArrays_h

#include "Files/Volume.h"

#include <array>
#include <map>
#include <string>
#include <utility>
#include <vector>

// The arrays that can give surfaces their colours: those that all drawn parts of a data object
// have.
class ColorArrays
{
public:
  struct Item
  {
    ArrayChoice Choice;
    int Components = 1;
  };

  ColorArrays() = default; // there are none
  explicit ColorArrays(vtkDataObject* data);

  const std::vector<Item>& All() const { return this->Items; }
  const Item* Find(const std::string& name) const; // null if it is none of them
  // \param component -1: the length of vectors
  bool Has(const std::string& name, int component) const;

  // From which value to which one colours go, of an array that there is: they differ also where
  // all values are the same. Values are read once.
  std::array<double, 2> Range(const std::string& name, int component);

private:
  vtkSmartPointer<vtkDataObject> Data;
  std::vector<Item> Items;
  std::map<std::pair<std::string, int>, std::array<double, 2>> Known;
};

#endif
