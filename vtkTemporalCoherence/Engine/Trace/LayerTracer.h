// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_LayerTracer_h
#define TemporalCoherence_LayerTracer_h

#include "Scene/RayBatch.h"
#include "Trace/SurfaceTracer.h"

#include <memory>

namespace TemporalCoherence
{

/// Finds the surfaces behind the first one along rays, one by one from front to back.
///
/// With CROSSING every crossing of every isovalue is a surface; with THRESHOLD, where a solid is
/// entered, and all solids that are cut open where the ray begins or leaves hidden cells. Which
/// comes next depends on the ray and the surface it is at alone.
class LayerTracer
{
public:
  /// A tracer for the type of the scene's samples. The scene's structures must outlive it.
  /// \throws std::bad_alloc
  static std::unique_ptr<LayerTracer> Make(const TraceScene& scene);

  virtual ~LayerTracer() = default;
  LayerTracer(const LayerTracer&) = delete;
  LayerTracer& operator=(const LayerTracer&) = delete;

  /// Go on from the surface that each ray has in `hits`, or from its beginning where it has none,
  /// to the next one; none if there is no other before its end. Safe from many threads.
  virtual void FindNext(const RayBatch& rays, HitBatch& hits) const = 0;

protected:
  LayerTracer() = default;
};

}

#endif
