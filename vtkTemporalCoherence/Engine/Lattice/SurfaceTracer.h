// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_SurfaceTracer_h
#define TemporalCoherence_SurfaceTracer_h

#include "Acceleration/ActiveCells.h"
#include "Scene/Field.h"
#include "Scene/LayerBatch.h"
#include "Scene/RayBatch.h"
#include "Scene/Surfaces.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace TemporalCoherence
{

/// How the rays of a tile are traced through active cells. The hits are the same.
enum class Traversal : std::uint8_t
{
  Fastest,
  Walks, ///< each ray walks from cell to cell
  Beams  ///< all rays together, for kinds of fields that have beams
};

/// The scene that rays are traced through.
struct TraceScene
{
  Field Samples;
  Surfaces Isosurfaces;
  glm::dvec2 FiniteRange{ 0.0 };       ///< smallest and largest finite sample
  const ActiveCells* Active = nullptr; ///< null: no space leaping, all cells along a ray are read
  bool IsHinted = false;               ///< walks may begin behind surfaces, and end before
  Traversal By = Traversal::Fastest;
};

/// Cells to search: one cell per ray, for a subset of a batch.
struct RayCells
{
  std::size_t Surface = 0; ///< position in the list of isovalues
  std::uint64_t Rays = 0;  ///< one bit for each ray of the subset
  /// By axis and ray. Places of other rays, up to the batch's capacity, repeat a cell of the
  /// subset.
  std::array<RayBatch::Array<std::int32_t>, 3> Cell;

  glm::ivec3 At(std::size_t ray) const
  {
    return { this->Cell[0][ray], this->Cell[1][ray], this->Cell[2][ray] };
  }
};

/// The rays that a search of cells leaves open, one bit each.
struct SearchedCells
{
  std::uint64_t Missing = 0; ///< it does not meet the surface in its cell
  std::uint64_t Shared =
    0; ///< it meets the surface where it leaves the cell: others may have it, too
};

/// Finds the surfaces along the rays of a batch, for one kind of field.
///
/// The hit of a ray is the nearest surface of all isovalues, by the rules of HitOrder.h. It depends
/// on the ray, its Begin and its End, but not on where the walk starts or which cells are skipped.
class SurfaceTracer
{
public:
  virtual ~SurfaceTracer() = default;
  SurfaceTracer(const SurfaceTracer&) = delete;
  SurfaceTracer& operator=(const SurfaceTracer&) = delete;

  /// Find the first surface along each ray. Thread-safe.
  virtual void Trace(const RayBatch& rays, HitBatch& hits) const = 0;

  /// Find the rays that meet any surface, when all surfaces are opaque. Thread-safe. By default by
  /// Trace.
  /// \pre with THRESHOLD, rays begin next to a surface
  /// \param rays      arrays are filled up to the end of the last vector
  /// \param cellsRead grows by the number of cells that were read
  /// \return one bit for each ray that does
  virtual std::uint64_t FindBlocked(const RayBatch& rays, std::int64_t& cellsRead) const;

  /// Find the next surface along each ray, behind the one in `hits`; without one, the first.
  /// Thread-safe.
  ///
  /// With CROSSING every crossing of every isovalue is a surface. With THRESHOLD every entry into a
  /// solid is one, and every cap where the ray begins or leaves hidden cells. A kind that does not
  /// override this shows only the first surface.
  virtual void FindNext(const RayBatch& rays, HitBatch& hits) const;

  /// Append the next surfaces along each open ray, in the order of FindNext, until the ray is full
  /// or opaque or ends. Closes all rays. Thread-safe.
  virtual void FindLayers(const RayBatch& rays, LayerBatch& layers) const;

  /// True if FindLayers finds several surfaces of a ray as quickly as one.
  virtual bool FindsLayersTogether(const RayBatch&) const { return false; }

  /// Search only the given cells for one surface. A surface nearer than the hit of its ray becomes
  /// the hit. Only called for kinds that have isomaps.
  /// Thread-safe.
  virtual SearchedCells SearchCells(
    const RayBatch& rays, const RayCells& cells, HitBatch& hits) const;

protected:
  SurfaceTracer() = default;
};

}

#endif
