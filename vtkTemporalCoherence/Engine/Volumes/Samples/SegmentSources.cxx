// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Volumes/Samples/SegmentSources.h"

#include "Lattice/RectilinearCells.h"
#include "Lattice/UniformCells.h"
#include "Volumes/Samples/ComponentWalk.h"

namespace TemporalCoherence
{

std::unique_ptr<const SegmentSource> MakeSegmentSource(
  const BlendScene& scene, const GridCoordinates* grid)
{
  return DispatchScalarType(scene.Key.Samples.Type,
    [&](auto type) -> std::unique_ptr<const SegmentSource>
    {
      using T = decltype(type);
      if (grid)
      {
        using Cells = RectilinearCells<T>;
        return std::make_unique<ComponentWalk<T, Cells>>(scene, Cells(*grid), grid);
      }
      return std::make_unique<ComponentWalk<T, UniformCells<T>>>(scene, UniformCells<T>(), grid);
    });
}

}
