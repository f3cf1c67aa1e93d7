// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Volumes/Projections/ExtremeSearches.h"

#include "Lattice/RectilinearCells.h"
#include "Lattice/UniformCells.h"
#include "Volumes/Projections/ExtremeBeams.h"
#include "Volumes/Projections/ExtremeWalk.h"

#include <utility>

namespace TemporalCoherence
{
namespace
{

template <typename T, typename Geometry>
std::unique_ptr<const ExtremeSearch> MakeSearch(const ExtremeTask& task, const Geometry& shape)
{
  using Beams = ExtremeBeams<T, typename Geometry::Real>;
  using Search = std::unique_ptr<const ExtremeSearch>;
  if (task.Samples.Between == Interpolation::Nearest)
  {
    auto walk = std::make_unique<ExtremeWalk<T, Geometry, Interpolation::Nearest>>(task, shape);
    const CellMeeting<typename Geometry::Real>* const meeting = walk.get();
    return task.ByBeams ? Search(std::make_unique<Beams>(task, std::move(walk), meeting))
                        : Search(std::move(walk));
  }
  auto walk = std::make_unique<ExtremeWalk<T, Geometry, Interpolation::Linear>>(task, shape);
  return task.ByBeams ? Search(std::make_unique<Beams>(task, std::move(walk), nullptr))
                      : Search(std::move(walk));
}

}

std::unique_ptr<const ExtremeSearch> MakeExtremeSearch(const ExtremeTask& task)
{
  return DispatchScalarType(task.Samples.Type,
    [&](auto type)
    {
      using T = decltype(type);
      return task.Grid ? MakeSearch<T>(task, RectilinearCells<T>(*task.Grid))
                       : MakeSearch<T>(task, UniformCells<T>());
    });
}

}
