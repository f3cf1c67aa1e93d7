// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Kinds/RectilinearKind.h"

#include "Isomap/CellBandTracer.h"
#include "Lattice/BeamChoice.h"
#include "Lattice/CellLayerBeam.h"
#include "Lattice/CellTracer.h"
#include "Lattice/KernelsRays.h"
#include "Lattice/RectilinearBeam.h"
#include "Scene/CellBox.h"
#include "Shade/LatticeFaces.h"
#include "Shade/RectilinearGradients.h"
#include "Volumes/LatticeBlending.h"

#include <limits>
#include <memory>
#include <utility>

namespace TemporalCoherence
{
namespace
{

/// The planes between cells: the coordinates, and one beyond each end.
struct RectilinearPlanes
{
  int Nearest(int axis, double at) const
  {
    const int cell = this->Grid.CellOf(axis, at);
    const double toLow = at - this->Grid.At(axis, cell);
    const double toHigh = this->Grid.At(axis, cell + 1) - at;
    return toHigh < toLow ? cell + 1 : cell;
  }
  double At(int axis, int plane) const { return this->Grid.At(axis, plane); }
  int CellOf(int axis, double at) const { return this->Grid.CellOf(axis, at); }

  const GridCoordinates& Grid;
};

/// CellTracer of a rectilinear field. It traces a tile's rays as one beam where that is faster.
template <typename T>
class RectilinearTracer final
  : public LayerBeamTracer<T, RectilinearCells<T>, Interpolation::Linear>
{
public:
  using Base = LayerBeamTracer<T, RectilinearCells<T>, Interpolation::Linear>;

  RectilinearTracer(const TraceScene& scene, const RectilinearCells<T>& shape)
    : Base(scene, shape, &shape.Grid)
  {
    if (HasBeams(scene))
    {
      this->Levels = std::make_unique<const BeamLevels<double>>(scene);
    }
  }

  void Trace(const RayBatch& rays, HitBatch& hits) const override
  {
    hits.Clear(rays.Count);
    this->FindCaps(rays, hits);
    const std::uint64_t wanted = WalksWithoutHit(rays, hits);
    if (!(this->Levels && AreBeam(this->Cells.Scene, rays, wanted) &&
          RectilinearBeam<T>(this->Cells, *this->Levels, rays, hits)
            .Trace(wanted, &this->Cells.Shape.Grid)))
    {
      this->WalkAll(rays, hits);
    }
  }

private:
  std::unique_ptr<const BeamLevels<double>> Levels; ///< null: no beams
};

/// Make the tracer of a scene.
template <typename T>
std::shared_ptr<const SurfaceTracer> MakeRectilinearTracer(
  const TraceScene& scene, const RectilinearCells<T>& shape)
{
  if (scene.Samples.Between == Interpolation::Nearest)
  {
    return std::make_shared<CellTracer<T, RectilinearCells<T>, Interpolation::Nearest>>(
      scene, shape);
  }
  return std::make_shared<RectilinearTracer<T>>(scene, shape);
}

class RectilinearFieldKind final : public FieldKind
{
public:
  explicit RectilinearFieldKind(std::shared_ptr<const GridCoordinates> grid)
    : Grid(std::move(grid))
  {
  }

  bool IsSame(const FieldShape& other) const override
  {
    const auto* const same = dynamic_cast<const RectilinearFieldKind*>(&other);
    return same && (same->Grid == this->Grid || same->Grid->Along == this->Grid->Along);
  }

  FieldAbilities Abilities() const override { return { true, true, true }; }

  bool AreBlocksAlike() const override { return false; }

  IndexBox BoxOf(const CellBox& cells) const override
  {
    IndexBox box;
    for (int axis = 0; axis < 3; ++axis)
    {
      box.Low[axis] = this->Grid->At(axis, cells.First[axis]);
      box.High[axis] = this->Grid->At(axis, cells.First[axis] + cells.Size[axis]);
    }
    return box;
  }

  VoxelSize VoxelSizeIn(const IndexTransform& transform) const override
  {
    VoxelSize size{ std::numeric_limits<double>::infinity(), 0.0 };
    for (int axis = 0; axis < 3; ++axis)
    {
      const double unit = glm::length(glm::dvec3(transform.WorldFromIndex[axis]));
      const glm::dvec2 along = unit * this->Grid->Edges(axis);
      size.Shortest = glm::min(size.Shortest, along.x);
      size.Longest = glm::max(size.Longest, along.y);
    }
    return size;
  }

  std::shared_ptr<const SurfaceTracer> MakeTracer(const TraceScene& scene) const override
  {
    return DispatchScalarType(scene.Samples.Type,
      [&](auto type)
      {
        return MakeRectilinearTracer<decltype(type)>(
          scene, RectilinearCells<decltype(type)>(*this->Grid));
      });
  }

  std::shared_ptr<const BandTracer> MakeBandTracer(const BandScene& scene) const override
  {
    return DispatchScalarType(scene.Samples.Type,
      [&](auto type)
      {
        return MakeCellBandTracer<decltype(type)>(
          scene, RectilinearCells<decltype(type)>(*this->Grid));
      });
  }

  std::shared_ptr<const BlendTracer> MakeBlendTracer(
    const BlendScene& scene, KeptTables* kept) const override
  {
    return MakeLatticeBlendTracer(scene, this->Grid.get(), kept);
  }

  void FindGradients(const GradientQuery& query, const GradientTile& tile) const override
  {
    RectilinearGradients(*this->Grid, query, tile);
  }

  glm::dvec3 FaceNormal(const Field& field, const CapPoint& cap, double& nearest) const override
  {
    return LatticeFaceNormal(RectilinearPlanes{ *this->Grid }, field, cap, nearest);
  }

  const std::shared_ptr<const GridCoordinates>& Coordinates() const { return this->Grid; }

private:
  std::shared_ptr<const GridCoordinates> Grid;
};

}

std::shared_ptr<const FieldKind> RectilinearKind(std::shared_ptr<const GridCoordinates> coordinates)
{
  return std::make_shared<RectilinearFieldKind>(std::move(coordinates));
}

std::shared_ptr<const GridCoordinates> CoordinatesOf(const FieldShape& shape)
{
  const auto* const kind = dynamic_cast<const RectilinearFieldKind*>(&shape);
  return kind ? kind->Coordinates() : nullptr;
}

}
