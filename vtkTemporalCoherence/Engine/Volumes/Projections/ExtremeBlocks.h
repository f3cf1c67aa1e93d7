// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_ExtremeBlocks_h
#define TemporalCoherence_ExtremeBlocks_h

#include "Acceleration/ValueRangePyramid.h"
#include "Lattice/CellRoot.h"
#include "Scene/Field.h"
#include "Scene/HiddenCells.h"
#include "Scene/RayBatch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <vector>

namespace TemporalCoherence
{

/// Round a number up to a float.
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

/// Round a number down to a float.
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
  Corners<Real> Samples; ///< negated in searches for a minimum
  Real Smallest, Largest;
};

/// The samples of a leaf.
template <typename Real>
struct ExtremeLeaf
{
  static constexpr std::size_t Edge = ValueRangePyramid::LeafSize + 1;
  static constexpr std::size_t RowLength = 8; ///< padded by finite numbers

  /// The row of samples from (0, y, z) on.
  const Real* Row(std::size_t y, std::size_t z) const
  {
    return &this->Samples[RowLength * (y + Edge * z)];
  }

  /// Corners of cell `number`: x + 4 y + 16 z.
  Corners<Real> CornersOf(int number) const
  {
    const auto at = static_cast<std::size_t>(number);
    const std::size_t x = at & 3, y = at >> 2 & 3, z = at >> 4;
    Corners<Real> corners;
    for (std::size_t row = 0; row < 4; ++row)
    {
      const Real* const from = this->Row(y + (row & 1), z + (row >> 1)) + x;
      corners[2 * row] = from[0];
      corners[2 * row + 1] = from[1];
    }
    return corners;
  }

  /// Negated in searches for a minimum. The last samples repeat beyond the field.
  alignas(64) std::array<Real, RowLength * Edge * Edge> Samples{};
  /// Mask of the cells that are not hidden and have finite samples only.
  std::uint64_t Cells = 0;
};

/// Searches single cells for single rays.
template <typename Real>
class CellMeeting
{
public:
  virtual ~CellMeeting() = default;

  /// The largest value of a ray in a cell.
  /// \param at gets the first t with this value
  /// \return false if the ray only touches the cell
  virtual bool Meet(const RayBatch& rays, std::size_t ray, const ExtremeCell<Real>& cell,
    Real& value, double& at) const = 0;
};

/// A block of cells to be searched.
struct ExtremeBlock
{
  glm::ivec3 Place; ///< counted in blocks
  float Bound;      ///< upper bound of its values
  float Depth;      ///< the smaller, the nearer
};

/// Order of the search: the largest bound first, then the nearest block.
inline bool operator<(const ExtremeBlock& a, const ExtremeBlock& b)
{
  return a.Bound > b.Bound || (a.Bound == b.Bound && a.Depth < b.Depth);
}

/// Upper bounds of the values in blocks of a field, in single precision; minus infinity for blocks
/// without values. Searches for a minimum negate the field.
template <typename Real>
class ExtremeBlocks
{
public:
  /// Bounds of the 4^3 children of a block, such as the leaves of a node.
  using Children = std::array<float, 64>;

  /// Upper bounds of all blocks of one size.
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

  /// Find the bounds of a node's leaves.
  virtual void BoundLeaves(std::int64_t node, Children& bounds) const = 0;

  /// Read the leaf that begins with a cell.
  virtual void Read(const glm::ivec3& first, ExtremeLeaf<Real>& leaf) const = 0;

  const glm::ivec3& Cells() const { return this->NumberOfCells; }
  const Level& Nodes() const { return this->OfNodes; }
  const Level& Groups() const { return this->OfGroups; } ///< blocks of 4^3 nodes

protected:
  explicit ExtremeBlocks(const Field& field)
    : NumberOfCells(field.Dimensions - 1)
  {
  }

  /// Find the bounds of groups from the bounds of nodes.
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

/// Blocks of samples of a known type.
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
    , AreFinite(ranges.AreSamplesFinite())
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

  void Read(const glm::ivec3& first, ExtremeLeaf<Real>& leaf) const override
  {
    constexpr int edge = ValueRangePyramid::LeafSize + 1;
    const glm::ivec3 last = glm::min(this->NumberOfCells - first, glm::ivec3(edge - 1));
    const bool areRows = last.x == edge - 1 && this->Samples.Strides.x == 1;
    Real* row = leaf.Samples.data();
    for (int z = 0; z < edge; ++z)
    {
      for (int y = 0; y < edge; ++y, row += ExtremeLeaf<Real>::RowLength)
      {
        const T* const from =
          this->Samples.At(first.x, first.y + std::min(y, last.y), first.z + std::min(z, last.z));
        for (int x = 0; areRows && x < edge; ++x)
        {
          row[x] = this->Sign * static_cast<Real>(from[x]);
        }
        for (int x = 0; !areRows && x < edge; ++x)
        {
          row[x] =
            this->Sign * static_cast<Real>(from[std::min(x, last.x) * this->Samples.Strides.x]);
        }
      }
    }
    leaf.Cells = this->CellsIn(first);
    if (!this->AreFinite)
    {
      leaf.Cells &= FiniteCells(leaf);
    }
  }

private:
  /// Mask of the cells of a leaf that lie in the field and are not hidden.
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

  /// Mask of the cells with finite samples.
  static std::uint64_t FiniteCells(const ExtremeLeaf<Real>& leaf)
  {
    std::uint64_t finite = 0;
    for (int cell = 0; cell < 64; ++cell)
    {
      const Corners<Real> corners = leaf.CornersOf(cell);
      const bool areFinite = std::all_of(
        corners.begin(), corners.end(), [](Real sample) { return std::isfinite(sample); });
      finite |= static_cast<std::uint64_t>(areFinite) << cell;
    }
    return finite;
  }

  float BoundOf(const Range& range) const
  {
    if (range.Max < range.Min)
    {
      return -std::numeric_limits<float>::infinity();
    }
    const Real largest =
      this->Sign * static_cast<Real>(this->Sign > Real(0) ? range.Max : range.Min);
    if constexpr (sizeof(T) <= 2 || std::is_same_v<T, float>)
    {
      return static_cast<float>(largest); // exact
    }
    return RoundedUp(largest);
  }

  const ValueRangePyramid& Ranges;
  TypedField<T> Samples;
  const HiddenCells* Hidden;
  bool AreFinite; ///< all samples
  Real Sign;
};

}

#endif
