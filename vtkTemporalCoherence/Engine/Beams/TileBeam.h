// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_TileBeam_h
#define TemporalCoherence_TileBeam_h

#include "Scene/RayBatch.h"
#include "Trace/KernelsWalk.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace TemporalCoherence
{

/// The rays of a tile as one beam, in single precision: in voxels from a cell near by, with t in
/// voxels from where the first ray begins. What the beam says of a ray and a cell allows for all
/// rounding, by a margin: where it cannot be sure it says so.
struct alignas(64) TileBeam
{
  template <typename T>
  using Array = RayBatch::Array<T>;

  /// Planes that all rays are on one side of, normal . point >= offset: four along the edges of
  /// the tile, and one across, before which is all that matters. A coefficient of each in an array;
  /// the last ones are no planes.
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

  // Arrays first, where vectors do not lie across lines of the cache.
  std::array<Array<float>, 3> Origin, Direction, Inverse;
  /// If IsPlain, a ray passes a plane between cells at its coordinate * Inverse + ToOrigin.
  std::array<Array<float>, 3> ToOrigin;
  Array<float> Begin, End, WalkBegin; ///< moved outwards by the margin
  Array<float> AtDepth, PerDepth;     ///< depth in the beam: AtDepth + t PerDepth
  /// If IsPlain, how much later than told a ray may enter a cell, or how much earlier leave it.
  Array<float> Slack;

  /// What is found. A cell that a ray enters at Behind or later does not matter; Cell is one that
  /// the ray meets a surface in for sure and enters before Behind; there is no other between.
  Array<float> Behind;
  Array<std::int32_t> Cell;
  Hull Around;
  std::size_t Deepest; ///< the ray whose Behind is the deepest
  float DeepestBehind; ///< its Behind when the plane across was moved there
  std::int64_t CellsPassed = 0;

  std::size_t Count; ///< of rays, with those that fill the last vector
  glm::ivec3 Anchor; ///< the cell that coordinates are relative to
  double First;      ///< t of a RayBatch from which on t is counted
  double Scale;      ///< voxels for a unit of t of a RayBatch
  /// Voxels by which rounding may move any plane, point or distance, and more.
  float Margin;
  /// Voxels along all axes together that a ray may move while t grows by 1.
  float Steepest;
  glm::vec3 Forward; ///< the direction that depth is counted in
  int Flip;          ///< bits of a child's number that are flipped to go from front to back
  bool AreAlike;     ///< all rays run the same way along each axis
  /// The rays are alike, none of them runs nearly along faces of cells, and none begins on its way
  /// through the field.
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

  /// Let nothing be told of the cell.
  void SetUnknown()
  {
    this->Low.fill(std::numeric_limits<float>::quiet_NaN());
    this->Step = this->Low;
    this->Largest = this->Low[0];
  }

  std::array<float, 4> Low, Step; ///< of the rows of corners: y + 2 z
  float Largest;                  ///< absolute value at a corner
};

/// Cells in which single precision does not tell whether rays meet a surface.
struct OpenCells
{
  /// One cell adds a tile's rays at most.
  static constexpr std::size_t Capacity = 2 * RayBatch::Capacity;

  std::size_t Count = 0;
  std::array<std::uint8_t, Capacity> Ray;
  std::array<std::int32_t, Capacity> Cell;
  std::array<float, Capacity> Enter; ///< the ray does not enter the cell before
};

/// What a beam goes through.
class BeamScene : public LeafSource
{
public:
  /// Read a cell, and remember it.
  /// \param values gets the differences from the isovalue, in units of which the largest are not
  ///               far from 1, or is unknown
  /// \return the number by which it is remembered: how many were before. There is room for
  ///         MostCells
  virtual std::int32_t Read(const glm::ivec3& cell, CellValues& values) = 0;
  static constexpr std::int32_t MostCells = 256;

  /// Find out, in full precision, what rays meet in the cells of the beam and in open ones, and
  /// forget all cells. Behind of rays that meet a surface is behind the nearest one.
  virtual void Decide(OpenCells& open, TileBeam& beam) = 0;
};

}

#endif
