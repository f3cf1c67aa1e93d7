// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_TileBeam_h
#define TemporalCoherence_TileBeam_h

#include "Scene/RayBatch.h"
#include "Trace/KernelsWalk.h"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace TemporalCoherence
{

/// Cells as one number each.
class CellNumbers
{
public:
  static constexpr std::uint32_t None = ~std::uint32_t(0);

  explicit CellNumbers(const glm::ivec3& cells)
    : BitsX(BitsFor(cells.x))
    , BitsXY(BitsX + BitsFor(cells.y))
    , IsEnough(BitsXY + BitsFor(cells.z) < 32)
  {
  }

  /// False if the field has more cells than there are numbers.
  bool HasAll() const { return this->IsEnough; }

  std::uint32_t Of(const glm::ivec3& cell) const
  {
    return static_cast<std::uint32_t>(cell.x) | static_cast<std::uint32_t>(cell.y) << this->BitsX |
      static_cast<std::uint32_t>(cell.z) << this->BitsXY;
  }

  glm::ivec3 At(std::uint32_t number) const
  {
    return { number & ((1u << this->BitsX) - 1u),
      (number & ((1u << this->BitsXY) - 1u)) >> this->BitsX, number >> this->BitsXY };
  }

private:
  static int BitsFor(int count)
  {
    int bits = 1;
    while (bits < 31 && count >> bits)
    {
      ++bits;
    }
    return bits;
  }

  int BitsX, BitsXY;
  bool IsEnough;
};

/// The rays of a tile as one beam, in single precision: in voxels from a cell near by, with t in
/// voxels from where the first ray begins. What the beam says of a ray and a cell allows for all
/// rounding, by a margin: where it cannot be sure it says so.
struct alignas(64) TileBeam
{
  template <typename T>
  using Array = RayBatch::Array<T>;

  /// Length of 64 numbers, one for each child of a block: x + 4 y + 16 z.
  using Table = std::array<float, 64>;

  /// One of the planes that all rays are on one side of: normal . point >= Offset.
  struct alignas(64) Plane
  {
    Table Children;
    glm::vec3 Normal;
    float Offset;
    float Reach; ///< how far a cell reaches from its first corner along the normal
  };

  // Arrays first, where vectors do not lie across lines of the cache.
  std::array<Array<float>, 3> Origin, Direction, Inverse;
  Array<float> Begin, End, WalkBegin;   ///< moved outwards by the margin
  Array<float> AtDepth, PerDepth;       ///< depth in the beam: AtDepth + t PerDepth

  /// What is found. From Behind on nothing on a ray matters; Cell is one that the ray meets a
  /// surface in for sure, where it enters at Enter or before; there is no other between.
  Array<float> Behind, Enter;
  Array<std::uint32_t> Cell;
  /// The ray enters no active cell before Contact, which is that of ContactCell or a little before;
  /// all others it enters behind NextContact.
  Array<float> Contact, NextContact;
  Array<std::uint32_t> ContactCell;
  Table ChildDepths;
  std::array<Plane, 4> Hull;

  float Depth; ///< the farthest depth that matters
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
  float Nearest;     ///< how far a cell reaches against it from its first corner
  int Flip;          ///< bits of a child's number that are flipped to go from front to back

  /// t of the beam for a t of a RayBatch.
  float DistanceOf(double t) const { return static_cast<float>((t - this->First) * this->Scale); }
};

/// Cells in which single precision does not tell whether rays meet a surface.
struct OpenCells
{
  int Count = 0;
  RayBatch::Array<std::uint8_t> Ray;
  RayBatch::Array<std::uint32_t> Cell;
  RayBatch::Array<float> Enter; ///< the ray does not enter the cell before
};

/// What a beam goes through.
class BeamScene : public LeafSource
{
public:
  /// Differences from the isovalue at the corners of a cell, in units of which the largest are not
  /// far from 1.
  virtual void ReadCorners(const glm::ivec3& cell, std::array<float, 8>& corners) const = 0;

  /// Find out, in full precision; the list is empty then, and Behind of these rays is where they
  /// leave a cell that they meet a surface in.
  virtual void Decide(OpenCells& open, TileBeam& beam) = 0;
};

}

#endif
