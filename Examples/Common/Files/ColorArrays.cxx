// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/ColorArrays.h"

#include "Files/Arrays.h"
#include "Files/Drawn.h"

#include <vtkDataArray.h>
#include <vtkDataSet.h>
#include <vtkImageData.h>
#include <vtkRectilinearGrid.h>
#include <vtkUniformGridAMR.h>

#include <algorithm>
#include <cmath>

namespace
{

// The mapper looks for the array in all blocks of images, but not in meshes without volume.
std::vector<vtkDataSet*> PartsOf(vtkDataObject* data)
{
  std::vector<vtkDataSet*> parts = DataSetsOf(data);
  parts.erase(std::remove_if(parts.begin(), parts.end(),
                [](vtkDataSet* part)
                {
                  const bool isImage =
                    vtkImageData::SafeDownCast(part) || vtkRectilinearGrid::SafeDownCast(part);
                  return part->GetNumberOfCells() == 0 || (!isImage && !HasVolume(part));
                }),
    parts.end());
  return parts;
}

// The components that an array has in each part; 0 if it is not the same everywhere.
int ComponentsIn(const std::vector<vtkDataSet*>& parts, const ArrayChoice& choice)
{
  int components = 0;
  for (vtkDataSet* part : parts)
  {
    vtkDataArray* const array = ArrayOf(part, choice);
    const vtkIdType places =
      choice.IsOnCells ? part->GetNumberOfCells() : part->GetNumberOfPoints();
    if (!array || array->GetNumberOfTuples() != places ||
      (components > 0 && components != array->GetNumberOfComponents()))
    {
      return 0;
    }
    components = array->GetNumberOfComponents();
  }
  return components;
}

}

ColorArrays::ColorArrays(vtkDataObject* data)
  : Data(data)
{
  const std::vector<vtkDataSet*> parts = PartsOf(data);
  for (ArrayChoice choice : AllArrays(data))
  {
    // Adaptive grids are drawn by values of cells.
    choice.IsOnCells = choice.IsOnCells || vtkUniformGridAMR::SafeDownCast(data);
    const int components = ComponentsIn(parts, choice);
    if (components > 0)
    {
      this->Items.push_back({ choice, components });
    }
  }
}

const ColorArrays::Item* ColorArrays::Find(const std::string& name) const
{
  const auto found = std::find_if(this->Items.begin(), this->Items.end(),
    [&name](const Item& item) { return item.Choice.Name == name; });
  return found == this->Items.end() ? nullptr : &*found;
}

bool ColorArrays::Has(const std::string& name, int component) const
{
  const Item* const item = this->Find(name);
  return item && component >= -1 && component < item->Components;
}

std::array<double, 2> ColorArrays::Range(const std::string& name, int component)
{
  const auto known = this->Known.find({ name, component });
  if (known != this->Known.end())
  {
    return known->second;
  }
  constexpr bool areAveraged = false; // a cell has one colour
  std::array<double, 2> range =
    Drawn(this->Data, areAveraged).Range(this->Find(name)->Choice, component);
  if (range[0] > range[1]) // no value is finite
  {
    range = { 0.0, 1.0 };
  }
  else if (range[0] == range[1])
  {
    const double half = range[0] == 0.0 ? 0.5 : 0.5 * std::abs(range[0]);
    range = { range[0] - half, range[1] + half };
  }
  return this->Known[{ name, component }] = range;
}
