// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_SurfaceTracer_h
#define TemporalCoherence_SurfaceTracer_h

#include "Acceleration/ActiveCells.h"
#include "Scene/Field.h"
#include "Scene/RayBatch.h"
#include "Scene/Surfaces.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>

namespace TemporalCoherence
{

/// How the rays of a tile go through active cells. The hits are the same.
enum class Traversal : std::uint8_t
{
  Fastest,
  Walks, ///< each ray goes from cell to cell
  Beams  ///< all go together where the kind of field can do it
};

/// What rays are traced through.
struct TraceScene
{
  Field Samples;
  Surfaces Sought;
  glm::dvec2 FiniteRange{ 0.0 };       ///< smallest and largest finite sample
  const ActiveCells* Active = nullptr; ///< null: no space leaping, every cell on the way is read
  bool IsHinted = false;               ///< walks may begin behind surfaces, and end before
  /// False: contacts of rays with hits may be told a little too early.
  bool AreContactsExact = true;
  Traversal By = Traversal::Fastest;
};

/// One cell for each of some rays of a batch.
struct CellList
{
  std::size_t Surface = 0; ///< position in the list of isovalues
  int Count = 0;
  RayBatch::Array<std::uint8_t> Ray; ///< ascending
  std::array<RayBatch::Array<std::int32_t>, 3> Cell;
  RayBatch::Array<std::uint8_t> IsContact; ///< 1: it is the first that the isovalue passes through
  RayBatch::Array<double> Enter;           ///< found by FieldKind::FindEntries: t

  void Append(std::size_t ray, const std::array<std::uint16_t, 3>& cell)
  {
    const auto at = static_cast<std::size_t>(this->Count++);
    this->Ray[at] = static_cast<std::uint8_t>(ray);
    for (std::size_t a = 0; a < 3; ++a)
    {
      this->Cell[a][at] = cell[a];
    }
  }

  glm::ivec3 At(std::size_t i) const
  {
    return { this->Cell[0][i], this->Cell[1][i], this->Cell[2][i] };
  }
};

/// Finds the surfaces along the rays of a batch, for one kind of field.
///
/// A hit is the nearest over all isovalues, by the rules of HitOrder.h. It depends on the ray, its
/// Begin and its End, and not on where the walk starts or what is leapt over. The contact is where
/// a ray first enters what may hold a surface: before it, neither this ray nor one that is at most
/// a voxel away meets any. (It does depend on where the walk starts.)
class SurfaceTracer
{
public:
  /// The tracer of the kind of the scene's field. The scene's structures must outlive it.
  /// \throws std::bad_alloc
  static std::shared_ptr<const SurfaceTracer> Make(const TraceScene& scene);

  virtual ~SurfaceTracer() = default;
  SurfaceTracer(const SurfaceTracer&) = delete;
  SurfaceTracer& operator=(const SurfaceTracer&) = delete;

  /// Find the first surface along each ray. Safe from many threads.
  virtual void Trace(const RayBatch& rays, HitBatch& hits) const = 0;

  /// Go on from the surface that each ray has in `hits`, or from its beginning where it has none,
  /// to the next one; none if there is no other before its end. Contacts are not looked for. Safe
  /// from many threads.
  ///
  /// With CROSSING every crossing of every isovalue is a surface; with THRESHOLD, where a solid is
  /// entered, and all solids that are cut open where the ray begins or leaves hidden cells. A kind
  /// that does not override it shows no surface behind the first one.
  virtual void FindNext(const RayBatch& rays, HitBatch& hits) const;

  /// Look for one surface in the given cells only, and make what is found the hit of its ray where
  /// it is nearer than the hit that the ray has; likewise contacts. Only kinds that have isomaps
  /// are asked. Safe from many threads. \return one bit for each ray in whose cell it is not
  virtual std::uint64_t SearchCells(
    const RayBatch& rays, const CellList& cells, HitBatch& hits) const;

protected:
  SurfaceTracer() = default;
};

}

#endif
