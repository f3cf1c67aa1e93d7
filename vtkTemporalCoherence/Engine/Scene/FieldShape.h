// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_FieldShape_h
#define TemporalCoherence_FieldShape_h

#include <glm/glm.hpp>

#include <cstdint>
#include <memory>
#include <vector>

namespace TemporalCoherence
{

struct CellBox;
struct IndexTransform;
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
};

/// Optional abilities of a field. Without one, a frame takes the next best route.
struct FieldAbilities
{
  bool Isomaps = false; ///< it has a BandTracer, and its SurfaceTracer searches the cells of knots
  bool Samples = false; ///< it has samples at Field::Samples, from which value ranges are made
  bool TimeSteps = false; ///< fingerprints tell which samples changed
  int Reach = 0;          ///< a sample may change surfaces in so many cells around its own ones
  /// Cells have any shape: hits name their cells, and the field has no samples. It may end anywhere
  /// in its box; solids are capped there.
  bool IsMesh = false;
  /// False if the points of each cell lie in a plane: such a field shows nothing.
  bool HasVolume = true;
};

/// The cells of a field: where they lie, and which values they hold. A shape is immutable and
/// shared by fields.
///
/// Every shape fills the box [0, Dimensions - 1] of index space. The box is divided into blocks of
/// cells (CellBlocks). The defaults are right for images; a new shape overrides the others. Its
/// kind (Kinds/FieldKind.h) finds surfaces in it.
class FieldShape
{
public:
  virtual ~FieldShape() = default;

  /// True if two fields are equal when only their shapes differ.
  virtual bool IsSame(const FieldShape& other) const { return this == &other; }

  virtual FieldAbilities Abilities() const { return {}; }

  /// Bounds of the field's values in a block of cells. Only called for kinds without samples. Such
  /// a field has the type ScalarType::Float64.
  virtual glm::dvec2 RangeIn(const CellBox& cells) const;

  /// Bounds of the finite values alone, at least of all finite samples. Only called where RangeIn
  /// is not finite. An infinite end is unknown. By default RangeIn.
  virtual glm::dvec2 FiniteRangeIn(const CellBox& cells) const { return this->RangeIn(cells); }

  /// One bit for each cell of a leaf that a surface can pass through, by the bits of ActiveCells.
  /// Only called for kinds without samples. By default all cells.
  /// \param bands of isovalues, ascending; endless above if cells count that are wholly inside
  virtual std::uint64_t CellsIn(const CellBox& leaf, const std::vector<ValueBand>& bands) const;

  /// True if all blocks of the same number of cells have the same size in index space.
  virtual bool AreBlocksAlike() const { return true; }

  /// The box around a block of cells.
  virtual IndexBox BoxOf(const CellBox& cells) const;

  virtual VoxelSize VoxelSizeIn(const IndexTransform& transform) const;
};

/// True if two shapes are equal.
inline bool AreSame(
  const std::shared_ptr<const FieldShape>& a, const std::shared_ptr<const FieldShape>& b)
{
  return a == b || a->IsSame(*b);
}

/// The shape of images: samples lie at integer coordinates.
std::shared_ptr<const FieldShape> UniformShape();

}

#endif
