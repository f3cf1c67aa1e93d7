// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/Arrays.h"

#include "Files/Drawn.h"
#include "Program/Quoted.h"
#include "Program/UserError.h"

#include <vtkAbstractVolumeMapper.h>
#include <vtkArrayDispatch.h>
#include <vtkBitArray.h>
#include <vtkCellData.h>
#include <vtkCompositeDataIterator.h>
#include <vtkCompositeDataSet.h>
#include <vtkDataArrayRange.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkRectilinearGrid.h>
#include <vtkUniformGridAMR.h>

#include <algorithm>
#include <climits>
#include <functional>
#include <sstream>
#include <unordered_set>

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

template <typename Array>
std::vector<int> DifferentValues(Array* array, std::size_t most)
{
  std::unordered_set<int> found;
  std::vector<bool> isKnown(1 << 16); // of the small ones
  vtkTypeInt64 last = -1;
  for (const auto value : vtk::DataArrayValueRange<1>(array))
  {
    const auto number = static_cast<vtkTypeInt64>(value);
    const bool isSmall = number >= 0 && number < static_cast<vtkTypeInt64>(isKnown.size());
    if (number == last || (isSmall && isKnown[static_cast<std::size_t>(number)]))
    {
      continue;
    }
    last = number;
    if (isSmall)
    {
      isKnown[static_cast<std::size_t>(number)] = true;
    }
    if (number >= INT_MIN && number <= INT_MAX && found.insert(static_cast<int>(number)).second &&
      found.size() >= most)
    {
      break;
    }
  }
  std::vector<int> values(found.begin(), found.end());
  std::sort(values.begin(), values.end());
  return values;
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

vtkDataArray* ArrayOf(vtkDataSet* set, const ArrayChoice& choice)
{
  vtkDataSetAttributes* attributes = AttributesOf(set, choice.IsOnCells);
  return choice.Name.empty() ? attributes->GetScalars() : attributes->GetArray(choice.Name.c_str());
}

std::vector<vtkDataArray*> ShownArrays(const Volume& volume)
{
  std::vector<vtkDataArray*> arrays;
  for (vtkDataSet* set : DataSetsOf(volume.Data))
  {
    vtkDataArray* array = ArrayOf(set, volume.Array);
    arrays.insert(arrays.end(), array ? 1 : 0, array);
  }
  return arrays;
}

void ChooseArray(Volume& volume, const std::string& name, const std::optional<double>& isovalue)
{
  const std::vector<ArrayChoice> all = AllArrays(volume.Data);
  const auto first = [&all](const std::function<bool(const ArrayChoice&)>& isWanted)
  { return std::find_if(all.begin(), all.end(), isWanted); };
  if (!name.empty() && !all.empty())
  {
    const auto named = first([&name](const ArrayChoice& choice) { return choice.Name == name; });
    if (named == all.end())
    {
      throw UserError(Quoted(volume.Name) + " has no array " + Quoted(name) +
        "; choose one of those it has: " + ListOf(all) + ".");
    }
    volume.Array = *named;
    return;
  }
  if (volume.Bricks) // one array, which was chosen where the volume was opened
  {
    volume.Array = {};
    return;
  }
  Drawn drawn(volume.Data);
  const auto varies = [&drawn](const ArrayChoice& choice)
  {
    const std::array<double, 2> range = drawn.Range(choice);
    return range[0] < range[1];
  };
  auto* image = vtkImageData::SafeDownCast(volume.Data);
  const bool hasScalars = image && image->GetPointData()->GetScalars();
  volume.Array = {}; // an image's own scalars
  if (hasScalars && varies(volume.Array))
  {
    return;
  }
  if (all.empty() && !hasScalars)
  {
    throw UserError(Quoted(volume.Name) +
      " has no array of numbers at its points or of its cells; add one, and save it again.");
  }
  auto chosen = all.end();
  if (isovalue)
  {
    chosen = first(
      [&](const ArrayChoice& choice)
      {
        const std::array<double, 2> range = drawn.Range(choice);
        return *isovalue >= range[0] && *isovalue <= range[1];
      });
  }
  chosen = chosen == all.end() ? first(varies) : chosen;
  if (chosen != all.end())
  {
    volume.Array = *chosen;
  }
  else if (!hasScalars)
  {
    volume.Array = all.front();
  }
}

std::string OthersThan(const Volume& volume)
{
  std::vector<ArrayChoice> others = AllArrays(volume.Data);
  const std::vector<vtkDataArray*> shown = ShownArrays(volume);
  others.erase(
    std::remove_if(others.begin(), others.end(),
      [&](const ArrayChoice& choice)
      {
        return choice.Name == volume.Array.Name ||
          (!shown.empty() && shown.front()->GetName() && choice.Name == shown.front()->GetName());
      }),
    others.end());
  std::string text;
  if (!others.empty())
  {
    text = "another array by --array (" + Shortened(ListOf(others)) + ")";
  }
  if (volume.TimeSteps > 1)
  {
    text += std::string(text.empty() ? "" : ", or ") + "another of its " +
      std::to_string(volume.TimeSteps) + " time steps by --time-step";
  }
  return text;
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

bool AreWholeNumbers(const Volume& volume)
{
  const std::vector<vtkDataSet*> sets = DataSetsOf(volume.Data);
  const std::vector<vtkDataArray*> arrays = ShownArrays(volume);
  return !arrays.empty() && !volume.Bricks && // all samples would be looked at
    std::all_of(sets.begin(), sets.end(),
      [](vtkDataSet* set) { return vtkImageData::SafeDownCast(set) != nullptr; }) &&
    std::all_of(arrays.begin(), arrays.end(),
      [](vtkDataArray* array)
      {
        const int type = array->GetDataType();
        return array->GetNumberOfComponents() == 1 && type != VTK_FLOAT && type != VTK_DOUBLE;
      });
}

std::vector<int> WholeNumbersOf(vtkDataArray* array, std::size_t most)
{
  std::vector<int> values;
  const auto work = [&](auto* typed) { values = DifferentValues(typed, most); };
  if (!vtkArrayDispatch::DispatchByValueType<vtkArrayDispatch::Integrals>::Execute(array, work))
  {
    work(array);
  }
  return values;
}
