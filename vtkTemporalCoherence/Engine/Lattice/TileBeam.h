// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_TileBeam_h
#define TemporalCoherence_TileBeam_h

#include "Lattice/KernelsWalk.h"
#include "Scene/RayBatch.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace TemporalCoherence
{

/// The rays of a tile as one beam, in single precision. Coordinates are voxels relative to a nearby
/// cell, t counts voxels from the first ray's begin. Tests of a ray against a cell allow a margin
/// for all rounding errors, and tell when they cannot decide.
struct alignas(64) TileBeam
{
  template <typename T>
  using Array = RayBatch::Array<T>;

  /// Planes with all rays on one side, normal . point >= offset: four along the tile's edges, and
  /// one across the beam, behind all cells that matter. An array holds one coefficient of all
  /// planes; its last entries are unused.
  static constexpr std::size_t Planes = 5, Across = 4;
  using OfPlanes = std::array<float, 8>;
  struct alignas(64) Hull
  {
    /// normal . (i, j, k) of each child of a block: x + 4 y + 16 z.
    std::array<std::array<float, 64>, Planes> Children;
    std::array<OfPlanes, 3> Normal;
    OfPlanes Offset;
    OfPlanes Reach; ///< how far a cell reaches from its first corner along the normal
  };

  // Arrays come first, so that no vector straddles cache lines.
  std::array<Array<float>, 3> Origin, Direction, Inverse;
  /// If IsPlain, a ray passes a plane between cells at its coordinate * Inverse + ToOrigin.
  std::array<Array<float>, 3> ToOrigin;
  Array<float> Begin, End, WalkBegin; ///< moved outwards by the margin
  Array<float> AtDepth, PerDepth;     ///< depth in the beam: AtDepth + t PerDepth
  /// If IsPlain, bound of how much later than computed a ray may enter a cell, or earlier leave it.
  Array<float> Slack;

  /// Results. Cells that a ray enters at Behind or later do not matter. Cell is the nearest known
  /// cell with a certain hit; the ray enters it before Behind.
  Array<float> Behind;
  Array<std::int32_t> Cell;
  Hull Around;
  std::size_t Deepest; ///< the ray whose Behind is the deepest
  float DeepestBehind; ///< its Behind when the plane across was moved there
  std::int64_t CellsPassed = 0;

  std::size_t Count; ///< number of rays, including fill of the last vector
  glm::ivec3 Anchor; ///< the cell that coordinates are relative to
  double First;      ///< t of the RayBatch where t of the beam is 0
  double Scale;      ///< voxels per unit of the RayBatch's t
  /// Upper bound, in voxels, of the rounding error of any plane, point or distance.
  float Margin;
  /// Voxels along all axes together that a ray may move while t grows by 1.
  float Steepest;
  glm::vec3 Forward; ///< the direction that depth is counted in
  int Flip;          ///< bits of a child's number that are flipped to go from front to back
  bool AreAlike;     ///< all rays run the same way along each axis
  /// The rays are alike, none runs nearly parallel to cell faces, and none begins inside the field.
  bool IsPlain;

  static constexpr std::int32_t NoCell = -1;
  static constexpr float Never = 1e30f; ///< a t behind all others

  /// t of the beam for a t of a RayBatch.
  float DistanceOf(double t) const { return static_cast<float>((t - this->First) * this->Scale); }
};

/// The trilinear interpolant of a cell, in single precision: by differences along x.
struct CellValues
{
  void Set(std::size_t row, float low, float high)
  {
    this->Low[row] = low;
    this->Step[row] = high - low;
    const float largest = std::max(std::abs(low), std::abs(high));
    this->Largest = row == 0 ? largest : std::max(this->Largest, largest);
  }

  /// Make the values NaN, so that tests decide nothing in the cell.
  void SetUnknown()
  {
    this->Low.fill(std::numeric_limits<float>::quiet_NaN());
    this->Step = this->Low;
    this->Largest = this->Low[0];
  }

  std::array<float, 4> Low, Step; ///< of the rows of corners: y + 2 z
  float Largest;                  ///< largest absolute value at a corner
};

/// Pairs of a ray and a cell that single precision cannot decide.
struct OpenCells
{
  /// One cell adds a tile's rays at most.
  static constexpr std::size_t Capacity = 2 * RayBatch::Capacity;

  std::size_t Count = 0;
  std::array<std::uint8_t, Capacity> Ray;
  std::array<std::int32_t, Capacity> Cell;
  std::array<float, Capacity> Enter; ///< lower bound of t where the ray enters the cell
};

/// The field of a beam: reads cells, and decides open cells in full precision.
class BeamScene : public LeafSource
{
public:
  /// Read a cell, and remember it.
  /// \param values gets the differences from the base isovalue, scaled by BeamLevels::Unit, or is
  ///               set to unknown
  /// \return the cell's number: the count of cells read before. There is room for MostCells
  virtual std::int32_t Read(const glm::ivec3& cell, CellValues& values) = 0;
  static constexpr std::int32_t MostCells = 256;

  /// Search the cells of certain hits and the open cells in full precision, and forget all cells.
  /// Moves each hit ray's Behind up to the entry of its hit's cell.
  virtual void Decide(OpenCells& open, TileBeam& beam) = 0;
};

}

#endif
