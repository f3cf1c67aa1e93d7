// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Blending/ExtremeSearch.h"

#include "Blending/ExtremeWalk.h"
#include "Fields/RectilinearCells.h"
#include "Fields/UniformCells.h"

namespace TemporalCoherence
{
namespace
{

template <typename T, typename Geometry>
std::unique_ptr<const ExtremeSearch> MakeWalk(const ExtremeTask& task, const Geometry& shape)
{
  if (task.Samples.Between == Interpolation::Nearest)
  {
    return std::make_unique<ExtremeWalk<T, Geometry, Interpolation::Nearest>>(task, shape);
  }
  return std::make_unique<ExtremeWalk<T, Geometry, Interpolation::Linear>>(task, shape);
}

}

std::unique_ptr<const ExtremeSearch> MakeExtremeSearch(const ExtremeTask& task)
{
  return DispatchScalarType(task.Samples.Type,
    [&](auto type)
    {
      using T = decltype(type);
      return task.Grid ? MakeWalk<T>(task, RectilinearCells<T>(*task.Grid))
                       : MakeWalk<T>(task, UniformCells<T>());
    });
}

}
