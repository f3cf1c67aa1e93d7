// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "InputArrays.h"

#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkPointData.h"

#include <set>

namespace
{

/// Arrays of numbers that could be drawn.
std::vector<vtkDataArray*> ArraysIn(vtkDataSetAttributes* attributes)
{
  std::vector<vtkDataArray*> arrays;
  for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = attributes->GetArray(i);
    const char* name = array ? array->GetName() : nullptr;
    if (name && std::string(name) != vtkDataSetAttributes::GhostArrayName())
    {
      arrays.push_back(array);
    }
  }
  return arrays;
}

/// The names of the arrays that could be chosen, for a message.
std::string NamesIn(vtkDataObject* data)
{
  std::set<std::string> names;
  for (vtkDataSet* dataSet : DataSetsOf(data))
  {
    for (const int association : { vtkDataObject::POINT, vtkDataObject::CELL })
    {
      for (vtkDataArray* array : ArraysIn(dataSet->GetAttributes(association)))
      {
        names.insert(std::string("('") + (association == vtkDataObject::CELL ? "CELLS" : "POINTS") +
          "', '" + array->GetName() + "')");
      }
    }
  }
  std::string text;
  for (const std::string& name : names)
  {
    text += (text.empty() ? "" : ", ") + name;
  }
  return text;
}

}

vtkDataArray* ArrayChoice::In(vtkDataSet* dataSet) const
{
  vtkDataSetAttributes* attributes = this->IsOnCells
    ? static_cast<vtkDataSetAttributes*>(dataSet->GetCellData())
    : dataSet->GetPointData();
  return this->Name.empty() ? nullptr : attributes->GetArray(this->Name.c_str());
}

bool IsArrayName(const char* name)
{
  return name && name[0] && std::string(name) != "None";
}

std::vector<vtkDataSet*> DataSetsOf(vtkDataObject* data)
{
  return vtkCompositeDataSet::GetDataSets<vtkDataSet>(data);
}

ArrayChoice FirstScalars(vtkDataSet* dataSet)
{
  for (const bool onCells : { false, true })
  {
    vtkDataSetAttributes* attributes = onCells
      ? static_cast<vtkDataSetAttributes*>(dataSet->GetCellData())
      : dataSet->GetPointData();
    vtkDataArray* found = attributes->GetScalars();
    const std::vector<vtkDataArray*> arrays = ArraysIn(attributes);
    if (!(found && found->GetName()) && !arrays.empty())
    {
      found = arrays.front();
    }
    if (found && found->GetName())
    {
      return { found->GetName(), onCells };
    }
  }
  return {};
}

std::string SayMissing(const ArrayChoice& choice, vtkDataObject* data, const char* property)
{
  return std::string("The input has no ") + (choice.IsOnCells ? "cell" : "point") + " array '" +
    choice.Name + "'; choose one that it has with " + property + ": " + NamesIn(data) + ".";
}
