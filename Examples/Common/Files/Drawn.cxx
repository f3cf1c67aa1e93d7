// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/Drawn.h"

#include "Files/Arrays.h"

#include <vtkCell.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDoubleArray.h>
#include <vtkExplicitStructuredGrid.h>
#include <vtkGenericCell.h>
#include <vtkIdList.h>
#include <vtkImageData.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkRectilinearGrid.h>
#include <vtkStructuredGrid.h>
#include <vtkUniformGridAMR.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <cmath>

namespace
{

bool IsVolumeType(int type)
{
  const auto cell = vtkSmartPointer<vtkCell>::Take(vtkGenericCell::InstantiateCell(type));
  return cell && cell->GetCellDimension() == 3;
}

// For each number that a type of cells may have.
const std::array<bool, 256>& VolumeTypes()
{
  static const std::array<bool, 256> types = []
  {
    std::array<bool, 256> are{};
    for (int type = 0; type < VTK_NUMBER_OF_CELL_TYPES && type < 256; ++type)
    {
      are[static_cast<std::size_t>(type)] = IsVolumeType(type);
    }
    return are;
  }();
  return types;
}

vtkUnsignedCharArray* GhostsOf(vtkDataSetAttributes* attributes)
{
  return vtkUnsignedCharArray::SafeDownCast(
    attributes->GetArray(vtkDataSetAttributes::GhostArrayName()));
}

// The mean of the drawn cells around each point.
// \param isDrawn for each cell; null: all are
vtkSmartPointer<vtkDataArray> Averaged(
  vtkDataSet* set, vtkDataArray* ofCells, const std::vector<unsigned char>* isDrawn)
{
  const int components = ofCells->GetNumberOfComponents();
  const auto means = vtkSmartPointer<vtkDoubleArray>::New();
  means->SetNumberOfComponents(components);
  means->SetNumberOfTuples(set->GetNumberOfPoints());
  means->Fill(0.0);
  std::vector<double> counts(static_cast<std::size_t>(set->GetNumberOfPoints()), 0.0);
  std::vector<double> tuple(static_cast<std::size_t>(components));
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < set->GetNumberOfCells(); ++cell)
  {
    if (isDrawn && (*isDrawn)[static_cast<std::size_t>(cell)] == 0)
    {
      continue;
    }
    ofCells->GetTuple(cell, tuple.data());
    set->GetCellPoints(cell, corners);
    for (vtkIdType i = 0; i < corners->GetNumberOfIds(); ++i)
    {
      const vtkIdType point = corners->GetId(i);
      counts[static_cast<std::size_t>(point)] += 1.0;
      for (int j = 0; j < components; ++j)
      {
        means->SetComponent(
          point, j, means->GetComponent(point, j) + tuple[static_cast<std::size_t>(j)]);
      }
    }
  }
  for (vtkIdType point = 0; point < set->GetNumberOfPoints(); ++point)
  {
    const double count = std::max(counts[static_cast<std::size_t>(point)], 1.0);
    for (int j = 0; j < components; ++j)
    {
      means->SetComponent(point, j, means->GetComponent(point, j) / count);
    }
  }
  return means;
}

bool HasMark(vtkUnsignedCharArray* ghosts, vtkIdType i, int marks)
{
  return ghosts && i < ghosts->GetNumberOfValues() && (ghosts->GetValue(i) & marks) != 0;
}

}

bool HasVolume(vtkDataSet* set)
{
  int n[3] = { 0, 0, 0 };
  if (auto* image = vtkImageData::SafeDownCast(set))
  {
    image->GetDimensions(n);
  }
  else if (auto* rectilinear = vtkRectilinearGrid::SafeDownCast(set))
  {
    rectilinear->GetDimensions(n);
  }
  else if (auto* structured = vtkStructuredGrid::SafeDownCast(set))
  {
    structured->GetDimensions(n);
  }
  else if (vtkExplicitStructuredGrid::SafeDownCast(set))
  {
    return set->GetNumberOfCells() > 0;
  }
  else if (vtkUnstructuredGrid::SafeDownCast(set))
  {
    for (vtkIdType cell = 0; cell < set->GetNumberOfCells(); ++cell)
    {
      if (VolumeTypes()[static_cast<unsigned char>(set->GetCellType(cell))])
      {
        return true;
      }
    }
  }
  return n[0] > 1 && n[1] > 1 && n[2] > 1;
}

Drawn::Drawn(vtkDataObject* data, bool areAveraged)
  : AreAveraged(areAveraged && HasMeshes(data) && !vtkUniformGridAMR::SafeDownCast(data))
{
  for (vtkDataSet* set : DataSetsOf(data))
  {
    if (HasVolume(set))
    {
      this->Parts.emplace_back();
      this->Parts.back().Set = set;
    }
  }
}

void Drawn::LookAt(Part& part)
{
  part.IsKnown = true;
  vtkUnsignedCharArray* ghostCells = GhostsOf(part.Set->GetCellData());
  vtkUnsignedCharArray* ghostPoints = GhostsOf(part.Set->GetPointData());
  part.AreAll = !ghostCells && !ghostPoints && !vtkUnstructuredGrid::SafeDownCast(part.Set);
  if (part.AreAll)
  {
    return;
  }
  using Marks = vtkDataSetAttributes;
  constexpr int Hidden = Marks::HIDDENCELL | Marks::REFINEDCELL | Marks::DUPLICATECELL;
  part.Points.assign(static_cast<std::size_t>(part.Set->GetNumberOfPoints()), 0);
  part.Cells.assign(static_cast<std::size_t>(part.Set->GetNumberOfCells()), 0);
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < part.Set->GetNumberOfCells(); ++cell)
  {
    if (!VolumeTypes()[static_cast<unsigned char>(part.Set->GetCellType(cell))] ||
      HasMark(ghostCells, cell, Hidden))
    {
      continue;
    }
    part.Set->GetCellPoints(cell, corners);
    const vtkIdType* const begin = corners->GetPointer(0);
    const vtkIdType* const end = begin + corners->GetNumberOfIds();
    if (ghostPoints &&
      std::any_of(begin, end,
        [ghostPoints](vtkIdType point) { return HasMark(ghostPoints, point, Marks::HIDDENPOINT); }))
    {
      continue;
    }
    part.Cells[static_cast<std::size_t>(cell)] = 1;
    for (const vtkIdType* point = begin; point != end; ++point)
    {
      part.Points[static_cast<std::size_t>(*point)] = 1;
    }
  }
}

std::vector<DrawnArray> Drawn::Arrays(const ArrayChoice& choice)
{
  std::vector<DrawnArray> arrays;
  for (Part& part : this->Parts)
  {
    vtkDataArray* array = ArrayOf(part.Set, choice);
    if (!array)
    {
      continue;
    }
    if (!part.IsKnown)
    {
      LookAt(part);
    }
    if (choice.IsOnCells && this->AreAveraged &&
      array->GetNumberOfTuples() == part.Set->GetNumberOfCells())
    {
      arrays.push_back({ Averaged(part.Set, array, part.AreAll ? nullptr : &part.Cells),
        part.AreAll ? nullptr : &part.Points });
      continue;
    }
    const std::vector<unsigned char>& mask = choice.IsOnCells ? part.Cells : part.Points;
    const bool fits = array->GetNumberOfTuples() == static_cast<vtkIdType>(mask.size());
    arrays.push_back({ array, part.AreAll || !fits ? nullptr : &mask });
  }
  return arrays;
}

std::array<double, 2> Drawn::Range(const ArrayChoice& choice, int component)
{
  std::array<double, 2> range = { VTK_DOUBLE_MAX, -VTK_DOUBLE_MAX };
  const auto add = [&range](double low, double high) {
    range = { std::min(range[0], low), std::max(range[1], high) };
  };
  for (const DrawnArray& array : this->Arrays(choice))
  {
    if (!array.IsDrawn)
    {
      double own[2];
      array.Values->GetFiniteRange(own, component);
      add(own[0], own[1]);
      continue;
    }
    const int count = array.Values->GetNumberOfComponents();
    std::vector<double> tuple(static_cast<std::size_t>(count));
    for (vtkIdType i = 0; i < array.Values->GetNumberOfTuples(); ++i)
    {
      if ((*array.IsDrawn)[static_cast<std::size_t>(i)] == 0)
      {
        continue;
      }
      array.Values->GetTuple(i, tuple.data());
      const double value = component >= 0 ? tuple[static_cast<std::size_t>(component)]
                                          : vtkMath::Norm(tuple.data(), count);
      if (std::isfinite(value))
      {
        add(value, value);
      }
    }
  }
  return range;
}
