// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_FieldKind_h
#define TemporalCoherence_FieldKind_h

#include <glm/glm.hpp>

#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

namespace TemporalCoherence
{

class BandTracer;
class BlendTracer;
class SurfaceTracer;
struct BandScene;
struct BlendScene;
struct CapPoint;
struct CellBox;
struct Field;
struct GradientQuery;
struct GradientTile;
struct IndexTransform;
struct RayBatch;
struct Surfaces;
struct TraceScene;
struct ValueBand;

/// A box in index space.
struct IndexBox
{
  glm::dvec3 Low, High;
};

/// How fine a field is: lengths in the world.
struct VoxelSize
{
  double Shortest, Longest; ///< edges of cells
  double Bend;              ///< the edge by which the bending of smooth surfaces is measured
};

/// What a kind of field can do beyond what every kind must. If it cannot, a frame takes the next
/// best route.
struct FieldAbilities
{
  bool Isomaps = false; ///< it has a BandTracer, and its SurfaceTracer searches the cells of knots
  bool Samples = false; ///< it has samples at Field::Samples, from which value ranges are made
  bool TimeSteps = false; ///< fingerprints tell which samples changed
  /// Its cells have any shape: hits tell their cells, and it has no samples. It has an end anywhere
  /// in its box, where solids are capped.
  bool IsMesh = false;
};

/// What frames ask of a field, whatever its cells are. A kind is immutable and shared by fields.
///
/// Every kind fills the box [0, Dimensions - 1] of index space. The box is divided into blocks of
/// cells, the leaves and nodes of ValueRangePyramid. A kind answers for blocks and for tiles of
/// rays; how it finds surfaces in a block is its own business. A new kind overrides the pure
/// virtual functions, and those others whose default, the answer for an image, is wrong for it.
class FieldKind
{
public:
  virtual ~FieldKind() = default;

  /// True if two fields are equal when only their kinds differ.
  virtual bool IsSame(const FieldKind& other) const { return this == &other; }

  virtual FieldAbilities Abilities() const { return {}; }

  /// Bounds of the field's values in a block of cells. Only called for kinds without samples. Such
  /// a field has the type ScalarType::Float64.
  virtual glm::dvec2 RangeIn(const CellBox& cells) const;

  /// Bounds of the finite values alone, at least those of the samples that RangeIn tells of. Only
  /// asked where RangeIn is not finite. An end that is not finite tells nothing. By default
  /// RangeIn.
  virtual glm::dvec2 FiniteRangeIn(const CellBox& cells) const { return this->RangeIn(cells); }

  /// One bit for each cell of a leaf that a surface can pass through, by the bits of ActiveCells.
  /// Only called for kinds without samples. By default all are.
  /// \param bands ascending; without an upper end, if cells count that are wholly inside
  virtual std::uint64_t CellsIn(const CellBox& leaf, const std::vector<ValueBand>& bands) const;

  /// True if all blocks of the same number of cells have the same size in index space.
  virtual bool AreBlocksAlike() const { return true; }

  /// The box around a block of cells.
  virtual IndexBox BoxOf(const CellBox& cells) const;

  virtual VoxelSize VoxelSizeIn(const IndexTransform& transform) const;

  /// Make a tracer, which finds the first surface along each ray of a tile, and those behind it.
  /// The scene's structures outlive it.
  /// \throws std::bad_alloc
  virtual std::shared_ptr<const SurfaceTracer> MakeTracer(const TraceScene& scene) const = 0;

  /// True if rays of cold frames walk from cell to cell, which takes so long that a frame may be
  /// faster by what a cached image tells of where walks may begin (BOUNDED).
  virtual bool GainsFromImages(const Field& field, const Surfaces& surfaces) const;

  /// Make a tracer of value ranges along rays, for isomaps. Null if the kind has no isomaps.
  /// \throws std::bad_alloc
  virtual std::shared_ptr<const BandTracer> MakeBandTracer(const BandScene& scene) const;

  /// Make a tracer of what rays see of a volume. Null if the kind can only be drawn by isosurfaces.
  /// \throws std::bad_alloc
  virtual std::shared_ptr<const BlendTracer> MakeBlendTracer(const BlendScene& scene) const;

  /// Find the gradients of the field at the hits of a tile.
  virtual void FindGradients(const GradientQuery& query, const GradientTile& tile) const = 0;

  /// The normal of the face through which a ray enters visible cells, from outside of the field or
  /// from hidden cells. Solids are capped there. In a mesh it is a face of the cell that is hit.
  /// \param nearest faces farther from the point than this are ignored; gets the distance of the
  ///                face found
  /// \return in index space, of unit length, facing against the ray; the zero vector if there is
  /// none
  virtual glm::dvec3 FaceNormal(const Field& field, const CapPoint& cap, double& nearest) const;
};

/// The same for two pointers to kinds.
inline bool AreSame(
  const std::shared_ptr<const FieldKind>& a, const std::shared_ptr<const FieldKind>& b)
{
  return a == b || a->IsSame(*b);
}

/// The kind of images: samples lie at integer coordinates (Fields/UniformKind.cxx).
std::shared_ptr<const FieldKind> UniformKind();

}

#endif
