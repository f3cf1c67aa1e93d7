// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/Arrays.h"

#include "Program/Quoted.h"
#include "Program/UserError.h"

#include <vtkAbstractVolumeMapper.h>
#include <vtkBitArray.h>
#include <vtkCellData.h>
#include <vtkCompositeDataIterator.h>
#include <vtkCompositeDataSet.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkRectilinearGrid.h>
#include <vtkUniformGridAMR.h>

#include <algorithm>
#include <sstream>

namespace
{

vtkDataSetAttributes* AttributesOf(vtkDataSet* set, bool onCells)
{
  return onCells ? static_cast<vtkDataSetAttributes*>(set->GetCellData()) : set->GetPointData();
}

// Numbers that mean something along a ray: no marks, no identities.
bool IsDrawable(vtkDataSetAttributes* attributes, int i)
{
  vtkDataArray* array = attributes->GetArray(i);
  return array && array->GetName() && array->GetName()[0] && !vtkBitArray::SafeDownCast(array) &&
    attributes->GetArrayName(i) != std::string(vtkDataSetAttributes::GhostArrayName()) &&
    array != attributes->GetGlobalIds() && array != attributes->GetPedigreeIds();
}

bool Holds(const Volume& volume, const ArrayChoice& choice, double value)
{
  Volume other = volume;
  other.Array = choice;
  const std::vector<vtkDataArray*> arrays = ShownArrays(other);
  return std::any_of(arrays.begin(), arrays.end(),
    [value](vtkDataArray* array)
    {
      double range[2];
      array->GetFiniteRange(range, 0);
      return value >= range[0] && value <= range[1];
    });
}

std::string ListOf(const std::vector<ArrayChoice>& choices)
{
  std::string list;
  for (const ArrayChoice& choice : choices)
  {
    list += (list.empty() ? "" : ", ") + choice.Name;
  }
  return Printable(list);
}

}

std::vector<vtkDataSet*> DataSetsOf(vtkDataObject* data)
{
  std::vector<vtkDataSet*> sets;
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(data))
  {
    const auto leaves = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
    for (leaves->InitTraversal(); !leaves->IsDoneWithTraversal(); leaves->GoToNextItem())
    {
      if (auto* set = vtkDataSet::SafeDownCast(leaves->GetCurrentDataObject()))
      {
        sets.push_back(set);
      }
    }
  }
  else if (auto* set = vtkDataSet::SafeDownCast(data))
  {
    sets.push_back(set);
  }
  return sets;
}

bool HasMeshes(vtkDataObject* data)
{
  const std::vector<vtkDataSet*> sets = DataSetsOf(data);
  return vtkUniformGridAMR::SafeDownCast(data) ||
    std::any_of(sets.begin(), sets.end(),
      [](vtkDataSet* set)
      { return !vtkImageData::SafeDownCast(set) && !vtkRectilinearGrid::SafeDownCast(set); });
}

std::vector<ArrayChoice> AllArrays(vtkDataObject* data)
{
  std::vector<ArrayChoice> all;
  for (const bool onCells : { false, true })
  {
    for (vtkDataSet* set : DataSetsOf(data))
    {
      vtkDataSetAttributes* attributes = AttributesOf(set, onCells);
      for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
      {
        const ArrayChoice choice = { IsDrawable(attributes, i) ? attributes->GetArrayName(i) : "",
          onCells };
        // By its name it is chosen: of two arrays of a name, the one at points.
        const bool isKnown = std::any_of(all.begin(), all.end(),
          [&choice](const ArrayChoice& other) { return choice.Name == other.Name; });
        if (!choice.Name.empty() && !isKnown)
        {
          all.push_back(choice);
        }
      }
    }
  }
  return all;
}

std::vector<vtkDataArray*> ShownArrays(const Volume& volume)
{
  const ArrayChoice& choice = volume.Array;
  std::vector<vtkDataArray*> arrays;
  for (vtkDataSet* set : DataSetsOf(volume.Data))
  {
    vtkDataSetAttributes* attributes = AttributesOf(set, choice.IsOnCells);
    vtkDataArray* array =
      choice.Name.empty() ? attributes->GetScalars() : attributes->GetArray(choice.Name.c_str());
    arrays.insert(arrays.end(), array ? 1 : 0, array);
  }
  return arrays;
}

void ChooseArray(Volume& volume, const std::string& name, const std::optional<double>& isovalue)
{
  const std::vector<ArrayChoice> all = AllArrays(volume.Data);
  const bool isImage = vtkImageData::SafeDownCast(volume.Data) != nullptr;
  if (name.empty() && isImage)
  {
    volume.Array = {}; // its active scalars
    return;
  }
  if (all.empty())
  {
    throw UserError(Quoted(volume.Name) +
      " has no array of numbers at its points or of its cells; add one, and save it again.");
  }
  auto chosen = all.begin();
  if (!name.empty())
  {
    chosen = std::find_if(
      all.begin(), all.end(), [&name](const ArrayChoice& choice) { return choice.Name == name; });
    if (chosen == all.end())
    {
      throw UserError(Quoted(volume.Name) + " has no array " + Quoted(name) +
        "; choose one of those it has: " + ListOf(all) + ".");
    }
  }
  else if (isovalue)
  {
    chosen = std::find_if(all.begin(), all.end(),
      [&](const ArrayChoice& choice) { return Holds(volume, choice, *isovalue); });
    chosen = chosen == all.end() ? all.begin() : chosen;
  }
  volume.Array = *chosen;
}

std::string NextArray(const Volume& volume)
{
  const std::vector<ArrayChoice> all = AllArrays(volume.Data);
  const std::vector<vtkDataArray*> shown = ShownArrays(volume);
  ArrayChoice now = volume.Array;
  if (now.Name.empty() && !shown.empty() && shown.front()->GetName())
  {
    now.Name = shown.front()->GetName();
  }
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    if (all[i].Name == now.Name)
    {
      return all.size() > 1 ? all[(i + 1) % all.size()].Name : "";
    }
  }
  return all.empty() ? "" : all.front().Name;
}

void ShowArray(const Volume& volume, vtkAbstractVolumeMapper* mapper)
{
  const ArrayChoice& choice = volume.Array;
  mapper->SetScalarMode(choice.Name.empty() ? VTK_SCALAR_MODE_DEFAULT
      : choice.IsOnCells                    ? VTK_SCALAR_MODE_USE_CELL_FIELD_DATA
                                            : VTK_SCALAR_MODE_USE_POINT_FIELD_DATA);
  mapper->SelectScalarArray(choice.Name.c_str());
}

std::string DescriptionOf(const Volume& volume)
{
  std::ostringstream text;
  const std::vector<vtkDataArray*> shown = ShownArrays(volume);
  if (auto* image = vtkImageData::SafeDownCast(volume.Data))
  {
    int n[3];
    image->GetDimensions(n);
    text << n[0] << " x " << n[1] << " x " << n[2] << "  ";
  }
  else
  {
    vtkIdType cells = 0;
    for (vtkDataSet* set : DataSetsOf(volume.Data))
    {
      cells += set->GetNumberOfCells();
    }
    text << cells << " cells  ";
  }
  text << (shown.empty() ? "no array" : shown.front()->GetDataTypeAsString());
  if (!volume.Array.Name.empty())
  {
    text << ' ' << Printable(volume.Array.Name) << (volume.Array.IsOnCells ? " of cells" : "");
  }
  return text.str();
}
