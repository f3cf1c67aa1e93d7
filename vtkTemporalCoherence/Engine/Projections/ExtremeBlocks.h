// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_ExtremeBlocks_h
#define TemporalCoherence_ExtremeBlocks_h

#include "Acceleration/HiddenCells.h"
#include "Acceleration/ValueRangePyramid.h"
#include "Scene/Field.h"
#include "Scene/RayBatch.h"
#include "Trace/CellRoot.h"
#include "Trace/CellSamples.h"

#include <hwy/base.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace TemporalCoherence
{

/// The smallest number in single precision that is not less.
template <typename Real>
float RoundedUp(Real value)
{
  using Limits = std::numeric_limits<float>;
  constexpr auto most = static_cast<Real>(Limits::max());
  if (value > most)
  {
    return Limits::infinity();
  }
  const auto rounded = static_cast<float>(std::max(value, -most));
  return static_cast<Real>(rounded) < value ? std::nextafter(rounded, Limits::infinity()) : rounded;
}

/// The largest one that is not more.
template <typename Real>
float RoundedDown(Real value)
{
  return -RoundedUp(-value);
}

/// A cell that may hold the largest value of a ray.
template <typename Real>
struct ExtremeCell
{
  glm::ivec3 Place;
  Corners<Real> Samples; ///< negated, if the smallest value is asked for
  Real Smallest, Largest;
  float Bound; ///< not less than the largest
};

/// Searches single cells for single rays.
template <typename Real>
class CellMeeting
{
public:
  virtual ~CellMeeting() = default;

  /// The largest value of a ray in a cell.
  /// \param at gets the t at which it is taken first
  /// \return false if the ray only touches the cell
  virtual bool Meet(const RayBatch& rays, std::size_t ray, const ExtremeCell<Real>& cell,
    Real& value, double& at) const = 0;
};

/// A block of cells to be searched.
struct ExtremeBlock
{
  glm::ivec3 Place; ///< counted in blocks
  float Bound;      ///< of its values
  float Depth;      ///< the smaller, the nearer
};

/// The most promising one is searched first, and of equal ones the nearest.
inline bool operator<(const ExtremeBlock& a, const ExtremeBlock& b)
{
  return a.Bound > b.Bound || (a.Bound == b.Bound && a.Depth < b.Depth);
}

/// The largest values of the blocks of a field, in single precision, rounded up; minus infinity if
/// there are none. Those of the negated field, if its smallest values are asked for.
template <typename Real>
class ExtremeBlocks
{
public:
  /// A block's children: those of a node are leaves, and so on.
  using Children = std::array<float, 64>;

  /// Largest values of blocks of 2^Bits cells along each axis.
  struct Level
  {
    float BoundOf(const glm::ivec3& block) const
    {
      return this->Bounds[static_cast<std::size_t>(block.x +
        static_cast<std::int64_t>(this->Dimensions.x) *
          (block.y + static_cast<std::int64_t>(this->Dimensions.y) * block.z))];
    }

    glm::ivec3 Dimensions; ///< in blocks
    std::vector<float> Bounds;
  };

  virtual ~ExtremeBlocks() = default;
  ExtremeBlocks(const ExtremeBlocks&) = delete;
  ExtremeBlocks& operator=(const ExtremeBlocks&) = delete;

  /// The leaves of a node.
  virtual void BoundLeaves(std::int64_t node, Children& bounds) const = 0;

  /// Read cells of a leaf, one bit each, that are neither hidden nor have a sample that is not
  /// finite.
  /// \return how many these are
  virtual std::size_t Read(
    const glm::ivec3& leaf, std::uint64_t cells, ExtremeCell<Real>* read) const = 0;

  const glm::ivec3& Cells() const { return this->NumberOfCells; }
  const Level& Nodes() const { return this->OfNodes; }
  const Level& Groups() const { return this->OfGroups; } ///< blocks of 4^3 nodes

protected:
  explicit ExtremeBlocks(const Field& field)
    : NumberOfCells(field.Dimensions - 1)
  {
  }

  /// Find the bounds of groups from those of nodes.
  void FindGroups()
  {
    const glm::ivec3& nodes = this->OfNodes.Dimensions;
    this->OfGroups.Dimensions = (nodes + 3) / 4;
    const glm::ivec3& groups = this->OfGroups.Dimensions;
    this->OfGroups.Bounds.assign(static_cast<std::size_t>(groups.x) *
        static_cast<std::size_t>(groups.y) * static_cast<std::size_t>(groups.z),
      -std::numeric_limits<float>::infinity());
    std::size_t node = 0;
    for (int z = 0; z < nodes.z; ++z)
    {
      for (int y = 0; y < nodes.y; ++y)
      {
        for (int x = 0; x < nodes.x; ++x, ++node)
        {
          float& bound = this->OfGroups.Bounds[static_cast<std::size_t>(
            x / 4 + groups.x * (y / 4 + static_cast<std::int64_t>(groups.y) * (z / 4)))];
          bound = std::max(bound, this->OfNodes.Bounds[node]);
        }
      }
    }
  }

  glm::ivec3 NumberOfCells; ///< along each axis
  Level OfNodes, OfGroups;
};

/// The same of samples of a known type.
template <typename T, typename Real>
class TypedExtremeBlocks final : public ExtremeBlocks<Real>
{
public:
  using Children = typename ExtremeBlocks<Real>::Children;
  using Range = ValueRangePyramid::Range<T>;

  /// \param ranges of the field
  TypedExtremeBlocks(const Field& field, const ValueRangePyramid& ranges, bool isMinimum)
    : ExtremeBlocks<Real>(field)
    , Ranges(ranges)
    , Samples(field)
    , Hidden(field.Hidden.get())
    , Sign(isMinimum ? Real(-1) : Real(1))
  {
    this->OfNodes.Dimensions = ranges.NodeDimensions();
    this->OfNodes.Bounds.resize(static_cast<std::size_t>(ranges.NumberOfNodes()));
    for (std::size_t node = 0; node < this->OfNodes.Bounds.size(); ++node)
    {
      this->OfNodes.Bounds[node] = this->BoundOf(ranges.NodeAt<T>(static_cast<std::int64_t>(node)));
    }
    this->FindGroups();
  }

  void BoundLeaves(std::int64_t node, Children& bounds) const override
  {
    const Range* const leaves = this->Ranges.template LeavesOf<T>(node);
    for (std::size_t leaf = 0; leaf < bounds.size(); ++leaf)
    {
      bounds[leaf] = this->BoundOf(leaves[leaf]);
    }
  }

  std::size_t Read(
    const glm::ivec3& leaf, std::uint64_t cells, ExtremeCell<Real>* read) const override
  {
    cells &= this->CellsIn(leaf);
    std::size_t count = 0;
    for (; cells != 0; cells &= cells - 1)
    {
      const int number = static_cast<int>(hwy::Num0BitsBelowLS1Bit_Nonzero64(cells));
      ExtremeCell<Real>& cell = read[count];
      cell.Place = leaf + glm::ivec3(number & 3, number >> 2 & 3, number >> 4);
      count += this->ReadCell(cell);
    }
    return count;
  }

private:
  /// One bit for each cell of a leaf that is in the field and not hidden.
  std::uint64_t CellsIn(const glm::ivec3& leaf) const
  {
    const glm::ivec3 count =
      glm::min(this->NumberOfCells - leaf, glm::ivec3(ValueRangePyramid::LeafSize));
    const std::uint64_t row = (1u << count.x) - 1u, rows = (1u << 4 * count.y) - 1u;
    const std::uint64_t slices = count.z == ValueRangePyramid::LeafSize
      ? ~std::uint64_t(0)
      : (std::uint64_t(1) << 16 * count.z) - 1u;
    const std::uint64_t cells = 0x1111111111111111u * row & 0x0001000100010001u * rows & slices;
    return this->Hidden ? cells & ~this->Hidden->LeafAt(leaf) : cells;
  }

  /// \return false if a sample is not finite
  bool ReadCell(ExtremeCell<Real>& cell) const
  {
    const std::array<T, 8> samples = this->Samples.Read(cell.Place);
    bool areFinite = true;
    for (std::size_t i = 0; i < samples.size(); ++i)
    {
      cell.Samples[i] = this->Sign * static_cast<Real>(samples[i]);
      areFinite = areFinite && (!std::is_floating_point_v<T> || std::isfinite(cell.Samples[i]));
    }
    cell.Smallest = *std::min_element(cell.Samples.begin(), cell.Samples.end());
    cell.Largest = *std::max_element(cell.Samples.begin(), cell.Samples.end());
    cell.Bound = RoundedUp(cell.Largest);
    return areFinite;
  }

  float BoundOf(const Range& range) const
  {
    if (range.Max < range.Min)
    {
      return -std::numeric_limits<float>::infinity();
    }
    return RoundedUp(this->Sign * static_cast<Real>(this->Sign > Real(0) ? range.Max : range.Min));
  }

  const ValueRangePyramid& Ranges;
  CellSamples<T> Samples;
  const HiddenCells* Hidden;
  Real Sign;
};

}

#endif
