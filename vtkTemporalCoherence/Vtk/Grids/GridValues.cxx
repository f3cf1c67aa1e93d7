// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Grids/GridValues.h"

#include "Grids/CellTypes.h"
#include "Grids/PartPoints.h"
#include "Input/GhostArray.h"
#include "Input/SamplesOfArray.h"
#include "Input/VectorMagnitude.h"

#include <vtkCellData.h>
#include <vtkDataSet.h>
#include <vtkDoubleArray.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace TemporalCoherence
{
namespace
{

constexpr std::uint8_t WithoutValue =
  vtkDataSetAttributes::HIDDENCELL | vtkDataSetAttributes::REFINEDCELL;

/// For each type, whether its cells have volume.
std::array<bool, 256> FindTypesWithVolume(const MeshPart& part)
{
  std::array<bool, 256> haveVolume{};
  const TypeCounts counts = CountTypes(part);
  for (std::size_t type = 0; type < counts.size(); ++type)
  {
    haveVolume[type] = counts[type] > 0 && DimensionOfType(static_cast<int>(type)) == 3;
  }
  return haveVolume;
}

/// The mean of the cells around each point; 0 without such cells. Infinities of both signs cancel
/// each other, as equally large numbers do.
vtkSmartPointer<vtkDataArray> AverageToPoints(
  const MeshPart& part, const MeshArray& ofCells, const std::uint8_t* ghosts)
{
  const auto averages = vtkSmartPointer<vtkDoubleArray>::New();
  averages->SetNumberOfTuples(part.NumberOfPoints);
  double* const sums = averages->GetPointer(0);
  std::fill_n(sums, part.NumberOfPoints, 0.0);
  std::vector<std::int32_t> counts(static_cast<std::size_t>(part.NumberOfPoints), 0);
  std::vector<std::int32_t> infinities; // of both signs: the difference of their numbers
  const auto haveVolume = part.Types ? FindTypesWithVolume(part) : std::array<bool, 256>();
  // Add up serially, so that sums do not depend on the number of threads.
  for (std::int64_t cell = 0; cell < part.NumberOfCells; ++cell)
  {
    if ((part.Types && !haveVolume[part.TypeOf(cell)]) || (ghosts && (ghosts[cell] & WithoutValue)))
    {
      continue;
    }
    const double value = ofCells.At(cell);
    if (std::isnan(value))
    {
      continue;
    }
    ForEachPoint(part, cell,
      [&](std::int64_t point)
      {
        ++counts[static_cast<std::size_t>(point)];
        if (std::isinf(value))
        {
          infinities.resize(counts.size(), 0);
          infinities[static_cast<std::size_t>(point)] += value > 0.0 ? 1 : -1;
          return;
        }
        sums[point] += value;
      });
  }
  for (std::int64_t point = 0; point < part.NumberOfPoints; ++point)
  {
    sums[point] /= std::max(counts[static_cast<std::size_t>(point)], 1);
  }
  for (std::size_t point = 0; point < infinities.size(); ++point)
  {
    if (infinities[point] != 0)
    {
      sums[point] = std::copysign(std::numeric_limits<double>::infinity(), infinities[point]);
    }
  }
  return averages;
}

ArrayPlaces PlacesOf(const GridLeaf& leaf)
{
  return { leaf.Name, leaf.OnCells,
    leaf.OnCells ? leaf.Data->GetNumberOfCells() : leaf.Data->GetNumberOfPoints() };
}

MeshArray ArrayOf(const PointValues& values)
{
  const ArraySamples samples = SamplesOf(values.Array, values.Component);
  return { samples.First, samples.Type, samples.Step };
}

}

void NoteValues(const GridLeaf& leaf, const DrawnComponent& component, MadeFrom& from)
{
  // Programs that write values may call Modified() of the array or of the data set, as for images.
  from.Add(leaf.Array, leaf.Data->GetMTime());
  from.Add(leaf.OnCells ? 1.0 : 0.0);
  from.Add(component.Key());
}

bool SetValues(const GridLeaf& leaf, const DrawnComponent& component, MeshPart& part,
  PointValues& values, std::string& error)
{
  values = { leaf.Array, component.IsMagnitude ? 0 : component.Number };
  if (!CheckTuples(leaf.Array, PlacesOf(leaf), error) ||
    !HasComponent(leaf.Array, values.Component, error))
  {
    return false;
  }
  if (component.IsMagnitude && leaf.Array->GetNumberOfComponents() > 1)
  {
    VectorMagnitude lengths;
    values.Array = lengths.Of(leaf.Array, 0);
  }
  part.Values = ArrayOf(values);
  if (!leaf.OnCells)
  {
    return true;
  }
  vtkUnsignedCharArray* ghosts = GhostsOf(leaf.Data->GetCellData());
  values.Array = AverageToPoints(part, part.Values, ghosts ? ghosts->GetPointer(0) : nullptr);
  values.Component = 0;
  part.Values = ArrayOf(values);
  return true;
}

}
