// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_FieldKind_h
#define TemporalCoherence_FieldKind_h

#include "Isomap/BandTracer.h"
#include "Lattice/SurfaceTracer.h"
#include "Scene/FieldShape.h"
#include "Shade/FieldNormals.h"
#include "Volumes/Beams/CompositeTables.h"
#include "Volumes/Medium/BlendTracer.h"

#include <memory>

namespace TemporalCoherence
{

/// A kind of field: the shape of its cells, the normals of its surfaces, and a tracer for each way
/// to draw it. This room alone knows which tracer serves which kind:
///
/// | kind        | surfaces and layers          | isomaps           | blended volumes           |
/// |-------------|------------------------------|-------------------|---------------------------|
/// | uniform     | UniformTracer                | UniformBandTracer | LatticeBlending           |
/// | labels      | LabelTracer                  | none              | none                      |
/// | rectilinear | CellTracer (RectilinearKind) | CellBandTracer    | LatticeBlending           |
/// | mesh        | MeshTracer                   | MeshBandTracer    | none: an error says to    |
/// |             |                              |                   | resample, or draw surfaces|
///
/// A new kind derives from this class, and finds surfaces in a block of cells in its own way.
class FieldKind
  : public FieldShape
  , public FieldNormals
{
public:
  /// Make a tracer, which finds the first surface along each ray of a tile, and the layers behind
  /// it. The scene's structures outlive it.
  /// \throws std::bad_alloc
  virtual std::shared_ptr<const SurfaceTracer> MakeTracer(const TraceScene& scene) const = 0;

  /// Make a tracer of value ranges along rays, for isomaps. Null if the kind has no isomaps.
  /// \throws std::bad_alloc
  virtual std::shared_ptr<const BandTracer> MakeBandTracer(const BandScene& scene) const;

  /// Make a tracer for blended volumes. Null if the kind can only be drawn by isosurfaces: its
  /// blended volumes show nothing.
  /// \param kept tables of an earlier tracer, which may serve again; receives this one's. May be
  /// null \throws std::bad_alloc
  virtual std::shared_ptr<const BlendTracer> MakeBlendTracer(
    const BlendScene& scene, KeptTables* kept) const;
};

/// The kind of a field: its shape or, if the shape is no kind, UniformKind().
const FieldKind& KindOf(const Field& field);

/// Make the tracer of a scene, for the kind of its field. Null if the kind has no such tracer. The
/// scene's structures must outlive the tracer.
/// \throws std::bad_alloc
std::shared_ptr<const SurfaceTracer> MakeSurfaceTracer(const TraceScene& scene);
std::shared_ptr<const BandTracer> MakeBandTracer(const BandScene& scene);
std::shared_ptr<const BlendTracer> MakeBlendTracer(
  const BlendScene& scene, KeptTables* kept = nullptr);

}

#endif
