// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_SurfaceTracer_h
#define TemporalCoherence_SurfaceTracer_h

#include "Acceleration/ActiveCells.h"
#include "Scene/Field.h"
#include "Scene/RayBatch.h"
#include "Scene/Surfaces.h"

#include <memory>

namespace TemporalCoherence
{

/// What rays are traced through.
struct TraceScene
{
  Field Samples;
  Surfaces Sought;
  glm::dvec2 FiniteRange{ 0.0 };       ///< smallest and largest finite sample
  const ActiveCells* Active = nullptr; ///< null: no space leaping, every cell on the way is read
};

/// One cell for each of some rays of a batch.
struct CellList
{
  std::size_t Surface = 0; ///< position in the list of isovalues
  int Count = 0;
  RayBatch::Array<std::uint8_t> Ray; ///< ascending
  std::array<RayBatch::Array<std::int32_t>, 3> Cell;
  RayBatch::Array<std::uint8_t> IsContact; ///< 1: it is the first that the isovalue passes through
};

/// Finds the first surface along each ray of a batch.
///
/// A ray goes from cell to cell; in each cell that can hold a surface the first crossing is found
/// exactly (CellRoot.h). The hit is the nearest over all isovalues. The result depends on the ray,
/// its Begin and its End, and not on where the walk starts or what is leapt over. (The contact, the
/// first cell on the walk that an isovalue passes through, does depend on where it starts.)
class SurfaceTracer
{
public:
  /// A tracer for the type of the scene's samples. The scene's structures must outlive it.
  /// \throws std::bad_alloc
  static std::unique_ptr<SurfaceTracer> Make(const TraceScene& scene);

  virtual ~SurfaceTracer() = default;
  SurfaceTracer(const SurfaceTracer&) = delete;
  SurfaceTracer& operator=(const SurfaceTracer&) = delete;

  /// Safe from many threads.
  virtual void Trace(const RayBatch& rays, HitBatch& hits) const = 0;

  /// Look for one surface in the given cells only, and make what is found the hit of its ray where
  /// it is nearer than the hit that the ray has; likewise contacts. Safe from many threads.
  /// \return one bit for each ray in whose cell it is not
  virtual std::uint64_t SearchCells(
    const RayBatch& rays, const CellList& cells, HitBatch& hits) const = 0;

protected:
  SurfaceTracer() = default;
};

}

#endif
