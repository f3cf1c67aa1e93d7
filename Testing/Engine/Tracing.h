// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Tracing_h
#define Testing_Tracing_h

#include "Acceleration/ActiveCells.h"
#include "Acceleration/ValueRangePyramid.h"
#include "Grid.h"
#include "Kinds/FieldKind.h"
#include "Lattice/SurfaceTracer.h"

#include <vector>

/// A field with all that rays need, in index space as world.
template <typename T>
struct Tracing
{
  Tracing(Grid<T>& grid, const std::vector<double>& isovalues, TemporalCoherence::SurfaceMode mode)
  {
    this->Pyramid.Build(grid.Field);
    this->Scene.Samples = grid.Field;
    if (!grid.Field.Hidden)
    {
      this->Scene.Samples.Hidden =
        TemporalCoherence::HiddenCells::WithoutNaN(grid.Field, this->Pyramid.LeavesWithNaN());
    }
    this->Scene.Isosurfaces = { isovalues, mode };
    this->Scene.FiniteRange = this->Pyramid.FiniteRange();
    this->Active.Build(this->Scene.Samples, this->Pyramid, this->Scene.Isosurfaces);
    this->Scene.Active = &this->Active;
  }
  Tracing(const Tracing&) = delete;
  void operator=(const Tracing&) = delete;

  TemporalCoherence::HitBatch Trace(const TemporalCoherence::RayBatch& rays) const
  {
    TemporalCoherence::HitBatch hits;
    TemporalCoherence::MakeSurfaceTracer(this->Scene)->Trace(rays, hits);
    return hits;
  }

  TemporalCoherence::ValueRangePyramid Pyramid;
  TemporalCoherence::ActiveCells Active;
  TemporalCoherence::TraceScene Scene;
};

#endif
