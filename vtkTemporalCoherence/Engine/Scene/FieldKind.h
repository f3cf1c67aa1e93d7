// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_FieldKind_h
#define TemporalCoherence_FieldKind_h

#include <glm/glm.hpp>

#include <limits>
#include <memory>

namespace TemporalCoherence
{

class BandTracer;
class SurfaceTracer;
struct BandScene;
struct CellBox;
struct CellList;
struct Field;
struct GradientQuery;
struct GradientTile;
struct IndexTransform;
struct RayBatch;
struct TraceScene;

/// A box in index space.
struct IndexBox
{
  glm::dvec3 Low, High;
};

/// How fine a field is: lengths in the world.
struct VoxelSize
{
  double Shortest, Longest; ///< edges of cells
  double Bend;              ///< the edge in units of which smooth surfaces bend
};

/// What a kind of field can give beyond what every kind gives. Where it cannot, a frame takes the
/// next best route.
struct FieldAbilities
{
  bool Isomaps = false; ///< it has a BandTracer, and its SurfaceTracer searches the cells of knots
  bool Samples = false; ///< values lie in memory, at Field::Samples: ranges are made from them
  bool TimeSteps = false; ///< samples that changed are told from others by fingerprints
};

/// What frames ask of a field, whatever its cells are. A kind has no state that changes, and fields
/// share it.
///
/// To all kinds belong the box [0, Dimensions - 1] of index space, and in it blocks of cells: the
/// leaves and nodes of ValueRangePyramid. What a kind has to give is told in terms of blocks and of
/// tiles of rays; how it finds surfaces in a block is its own. A new kind overrides the pure
/// functions, and those of the others whose answer is not that of an image.
class FieldKind
{
public:
  virtual ~FieldKind() = default;

  /// True if fields that differ in the two kinds alone are the same.
  virtual bool IsSame(const FieldKind& other) const { return this == &other; }

  virtual FieldAbilities Abilities() const { return {}; }

  /// Smallest and largest value that the field may have in a block of cells. Nobody asks kinds with
  /// samples. The type of a field without is ScalarType::Float64.
  virtual glm::dvec2 RangeIn(const CellBox& cells) const;

  /// True if blocks of equally many cells are boxes of the same size.
  virtual bool AreBlocksAlike() const { return true; }

  /// The box that holds a block of cells.
  virtual IndexBox BoxOf(const CellBox& cells) const;

  virtual VoxelSize VoxelSizeIn(const IndexTransform& transform) const;

  /// What finds the first surfaces of tiles of rays, and those behind them. The scene's structures
  /// outlive it.
  /// \throws std::bad_alloc
  virtual std::shared_ptr<const SurfaceTracer> MakeTracer(const TraceScene& scene) const = 0;

  /// What finds the ranges of values along tiles of rays, for isomaps; null: it cannot.
  /// \throws std::bad_alloc
  virtual std::shared_ptr<const BandTracer> MakeBandTracer(const BandScene& scene) const;

  /// Find where rays enter the cells of a list, for isomaps; kinds without are not asked.
  virtual void FindEntries(const RayBatch& rays, CellList& cells) const;

  /// Find the gradients of the field at the hits of a tile.
  virtual void FindGradients(const GradientQuery& query, const GradientTile& tile) const = 0;

  /// The normal of the face on which a ray comes into the cells, from outside of the field or out
  /// of hidden cells: there solids are cut open. \param point, direction of the ray, in index space
  /// \param nearest faces that are not nearer to the point are left out; gets the distance of the
  ///                one that is found
  /// \return of unit length, in index space, against the ray; the zero vector if there is none
  virtual glm::dvec3 FaceNormal(const Field& field, const glm::dvec3& point,
    const glm::dvec3& direction, double& nearest) const;
};

/// True if fields that differ in two kinds alone are the same.
inline bool AreSame(
  const std::shared_ptr<const FieldKind>& a, const std::shared_ptr<const FieldKind>& b)
{
  return a == b || a->IsSame(*b);
}

/// The kind of images: samples lie at whole numbers (Fields/UniformKind.cxx).
std::shared_ptr<const FieldKind> UniformKind();

}

#endif
