// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Grids/EvaluatedCells.h"

#include "Grids/PartPoints.h"

#include <vtkDataSet.h>
#include <vtkGenericCell.h>
#include <vtkNew.h>

#include <cstddef>
#include <limits>
#include <vector>

namespace TemporalCoherence
{

PartValues EvaluateCells(vtkDataSet* data, const PartValues& own, const MeshPart& part)
{
  constexpr double missing = std::numeric_limits<double>::quiet_NaN();
  const auto count = static_cast<std::size_t>(part.NumberOfPoints);
  std::vector<std::shared_ptr<std::vector<double>>> made;
  PartValues found;
  while (made.size() < own.Components.size())
  {
    made.push_back(std::make_shared<std::vector<double>>(count, missing));
    found.Components.push_back({ made.back()->data(), ScalarType::Float64, 1 });
    found.Owners.push_back(made.back());
  }
  std::vector<bool> isMade(count);
  std::vector<double> weights;
  vtkNew<vtkGenericCell> original;
  std::int64_t last = -1;
  const auto evaluate = [&](std::int64_t cell, std::int64_t point)
  {
    if (cell != last)
    {
      last = cell;
      data->GetCell(cell, original);
      weights.resize(static_cast<std::size_t>(original->GetNumberOfPoints()));
    }
    double at[3], parametric[3], distance;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      at[axis] = part.Coordinates[axis].At(point);
    }
    int sub;
    if (original->EvaluatePosition(at, nullptr, sub, parametric, distance, weights.data()) < 0)
    {
      return false; // the cell has no such place
    }
    for (std::size_t c = 0; c < made.size(); ++c)
    {
      double& value = (*made[c])[static_cast<std::size_t>(point)];
      value = 0.0;
      for (std::size_t i = 0; i < weights.size(); ++i)
      {
        value += weights[i] * own.Components[c].At(original->GetPointId(static_cast<int>(i)));
      }
    }
    return true;
  };
  for (std::int64_t cell = 0; cell < part.NumberOfCells; ++cell)
  {
    ForEachPoint(part, cell,
      [&](std::int64_t point)
      {
        const auto place = static_cast<std::size_t>(point);
        isMade[place] =
          isMade[place] || evaluate(part.Originals.First ? part.Originals.IdAt(cell) : cell, point);
      });
  }
  return found;
}

}
