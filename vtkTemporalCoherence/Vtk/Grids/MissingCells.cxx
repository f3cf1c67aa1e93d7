// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Grids/MissingCells.h"

#include "Input/SamplesOfArray.h"

#include <vtkDataArray.h>
#include <vtkDataSet.h>

#include <algorithm>
#include <cmath>

namespace TemporalCoherence
{
namespace
{

/// Mark the NaN values of a component.
template <typename T>
void MarkNaN(const ArraySamples& samples, std::int64_t count, std::vector<std::uint8_t>& missing)
{
  const T* const first = static_cast<const T*>(samples.First);
  for (std::int64_t i = 0; i < count; ++i)
  {
    if (std::isnan(first[i * samples.Step]))
    {
      missing.resize(static_cast<std::size_t>(count), 0);
      missing[static_cast<std::size_t>(i)] = 1;
    }
  }
}

}

void FindMissingCells(
  const GridLeaf& leaf, const DrawnComponent& component, std::vector<std::uint8_t>& missing)
{
  missing.clear();
  const vtkIdType count = leaf.Data->GetNumberOfCells();
  const int components = leaf.Array->GetNumberOfComponents();
  if (!leaf.OnCells || leaf.Array->GetNumberOfTuples() < count)
  {
    return;
  }
  const int first = component.IsMagnitude ? 0 : std::max(component.Number, 0);
  const int end = component.IsMagnitude ? components : component.Number + 1;
  for (int c = first; c < end && c < components; ++c)
  {
    const ArraySamples samples = SamplesOf(leaf.Array, c);
    if (samples.Type == ScalarType::Float32)
    {
      MarkNaN<float>(samples, count, missing);
    }
    else if (samples.Type == ScalarType::Float64)
    {
      MarkNaN<double>(samples, count, missing);
    }
  }
}

}
