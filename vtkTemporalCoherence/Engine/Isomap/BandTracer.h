// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_BandTracer_h
#define TemporalCoherence_BandTracer_h

#include "Acceleration/ActiveCells.h"
#include "Acceleration/ValueRangePyramid.h"
#include "Isomap/KnotCollector.h"
#include "Isomap/Knots.h"
#include "Lattice/SurfaceTracer.h"
#include "Scene/Field.h"
#include "Scene/RayBatch.h"
#include "Scene/Surfaces.h"
#include "Shade/FieldNormals.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>

namespace TemporalCoherence
{

/// The scene that a band is traced through.
struct BandScene
{
  Field Samples;
  glm::dvec2 FiniteRange{ 0.0 }; ///< smallest and largest finite sample
  const ValueRangePyramid* Pyramid = nullptr;
  const ActiveCells* Active = nullptr; ///< of the band
  ValueBand Band;
  SurfaceMode Mode = SurfaceMode::Crossing;
  KnotForm Form{};
  IndexTransform Transform{};            ///< for normals
  const FieldNormals* Normals = nullptr; ///< of the field; not null if the form has normals
  /// Bytes of knots in a tile from which the whole band is too large, so that tracing stops.
  std::size_t MemoryLimit = std::numeric_limits<std::size_t>::max();
  Traversal By = Traversal::Fastest; ///< does not change the knots
};

/// Traces rays through the active cells of a band and records where each isovalue is first passed.
///
/// Along a ray only cells matter in which the running maximum of the field rises (or, for rays that
/// begin above an isovalue, the running minimum falls). Other cells are skipped, whole leaves at a
/// time. A ray ends where it has passed the whole band.
class BandTracer
{
public:
  virtual ~BandTracer() = default;
  BandTracer(const BandTracer&) = delete;
  BandTracer& operator=(const BandTracer&) = delete;

  /// Trace the rays of a tile. Thread-safe. If the knots exceed the limit, some are missing.
  /// \return number of cells whose samples were read
  /// \throws std::bad_alloc
  virtual std::int64_t Trace(const RayBatch& rays, TileKnots& knots) const = 0;

protected:
  BandTracer() = default;
};

/// Makes the tracer for the kind of the scene's field; null if there is none. The scene's
/// structures must outlive it.
/// \throws std::bad_alloc
using BandTracerMaker = std::shared_ptr<const BandTracer> (*)(const BandScene& scene);

}

#endif
