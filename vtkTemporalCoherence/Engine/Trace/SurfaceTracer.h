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
#include <memory>

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

/// Cells to search, one for each of some rays of a batch.
struct RayCells
{
  std::size_t Surface = 0; ///< position in the list of isovalues
  std::uint64_t Rays = 0;  ///< one bit for each of these rays
  /// By axis and ray. Other rays have the cell of one of these, up to the capacity of batches.
  std::array<RayBatch::Array<std::int32_t>, 3> Cell;

  glm::ivec3 At(std::size_t ray) const
  {
    return { this->Cell[0][ray], this->Cell[1][ray], this->Cell[2][ray] };
  }
};

/// What a search of cells leaves open, one bit for each ray.
struct SearchedCells
{
  std::uint64_t Missing = 0; ///< it does not meet the surface in its cell
  std::uint64_t Shared =
    0; ///< it meets the surface where it leaves the cell: others may have it, too
};

/// Cells in which rays may meet one surface, each of some ray of a batch, and what the search of
/// them finds.
struct PassedCells
{
  int Count = 0;
  std::size_t Surface = 0;                           ///< position in the list of isovalues
  RayBatch::Array<std::uint8_t> Ray;                 ///< of each cell
  std::array<RayBatch::Array<std::int32_t>, 3> Cell; ///< by axis

  // One bit for each cell:
  std::uint64_t One = 0;  ///< the ray meets the surface there once: Distance, and Kind by Exits
  std::uint64_t Open = 0; ///< not known: to be searched with all surfaces
  std::uint64_t Exits = 0;
  RayBatch::Array<double> Distance;

  void Append(std::size_t ray, const std::array<std::uint16_t, 3>& cell)
  {
    const auto at = static_cast<std::size_t>(this->Count++);
    this->Ray[at] = static_cast<std::uint8_t>(ray);
    for (std::size_t a = 0; a < 3; ++a)
    {
      this->Cell[a][at] = cell[a];
    }
  }

  glm::ivec3 CellAt(std::size_t i) const
  {
    return { this->Cell[0][i], this->Cell[1][i], this->Cell[2][i] };
  }
};

/// Finds the surfaces along the rays of a batch, for one kind of field.
///
/// The hit of a ray is the nearest surface of all isovalues, by the rules of HitOrder.h. It depends
/// on the ray, its Begin and its End, but not on where the walk starts or which cells are skipped.
/// The first entry of a ray is where it first enters an active cell: before it, neither this ray
/// nor one at most a voxel away meets a surface. (The first entry does depend on where the walk
/// starts. Rays that go as a beam are told none.)
class SurfaceTracer
{
public:
  /// Make the tracer for the kind of the scene's field. The scene's structures must outlive it.
  /// \throws std::bad_alloc
  static std::shared_ptr<const SurfaceTracer> Make(const TraceScene& scene);

  virtual ~SurfaceTracer() = default;
  SurfaceTracer(const SurfaceTracer&) = delete;
  SurfaceTracer& operator=(const SurfaceTracer&) = delete;

  /// Find the first surface along each ray. Thread-safe.
  virtual void Trace(const RayBatch& rays, HitBatch& hits) const = 0;

  /// Find the next surface along each ray, behind the one in `hits`; without one, the first. Does
  /// not find first entries. Thread-safe.
  ///
  /// With CROSSING every crossing of every isovalue is a surface. With THRESHOLD every entry into a
  /// solid is one, and every cap where the ray begins or leaves hidden cells. A kind that does not
  /// override this shows only the first surface.
  virtual void FindNext(const RayBatch& rays, HitBatch& hits) const;

  /// Append the next surfaces along each open ray, as FindNext finds them one by one: up to the
  /// limit, or to where the ray is opaque. No ray is open then. Thread-safe.
  virtual void FindLayers(const RayBatch& rays, LayerBatch& layers) const;

  /// True if FindLayers finds several surfaces of a ray as quickly as one.
  virtual bool FindsLayersTogether(const RayBatch&) const { return false; }

  /// Search only the given cells for one surface. A surface nearer than the hit of its ray becomes
  /// the hit. Only called for kinds that have isomaps.
  /// Thread-safe.
  virtual SearchedCells SearchCells(
    const RayBatch& rays, const RayCells& cells, HitBatch& hits) const;

  /// Search cells for one surface, where that can be done for many at once. By default none is.
  /// Thread-safe.
  virtual void SearchPassed(const RayBatch& rays, PassedCells& cells) const;

  /// Append what an open ray meets in a cell behind its last layer, of all surfaces. Only called
  /// for kinds whose isomaps hold passages. Thread-safe.
  /// \return false if surfaces lie too close together to be told in this way: the ray must walk
  ///         from its last layer on
  virtual bool AppendIn(
    const RayBatch&, std::size_t /*ray*/, const glm::ivec3& /*cell*/, LayerBatch&) const
  {
    return false;
  }

  /// Append caps where open rays begin in solids. As above.
  virtual void AppendCaps(const RayBatch&, LayerBatch&) const {}

protected:
  SurfaceTracer() = default;
};

}

#endif
