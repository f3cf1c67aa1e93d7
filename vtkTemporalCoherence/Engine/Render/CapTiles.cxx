// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Render/CapTiles.h"

#include "Acceleration/TileBounds.h"
#include "Scene/CellBox.h"
#include "Scene/LabelIndex.h"
#include "Scene/LabelSets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace TemporalCoherence
{
namespace
{

/// Largest error of a point, in voxels: at the largest distance that is drawn, rounding moves the
/// begin of a ray by less than a tenth of it.
constexpr double Slack = 1.0;

/// Where in the field rays may begin.
class RayBegins
{
public:
  explicit RayBegins(const RaySource& rays)
    : Last(rays.Last)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const RaySource::LinearVector& along = rays.Direction;
      const double reach = std::abs(along[1][axis]) + std::abs(along[2][axis]);
      const double rounding = 1e-12 * (std::abs(along[0][axis]) + reach);
      this->EntersLow[axis] = !(along[0][axis] + reach < -rounding);
      this->EntersHigh[axis] = !(along[0][axis] - reach > rounding);
    }
    this->FindNear(rays);
    for (const glm::dvec4& plane : rays.Clipper.Planes())
    {
      if (Touches(plane, { glm::dvec3(0.0), this->Last }))
      {
        this->Planes.push_back(plane);
      }
    }
  }

  /// True if rays may begin in a box.
  bool AreIn(const IndexBox& box) const
  {
    bool are = AreNear(this->Near, box);
    for (int axis = 0; axis < 3; ++axis)
    {
      are |= this->EntersLow[axis] && box.Low[axis] <= Slack;
      are |= this->EntersHigh[axis] && box.High[axis] >= this->Last[axis] - Slack;
    }
    return are ||
      std::any_of(this->Planes.begin(), this->Planes.end(),
        [&](const glm::dvec4& plane) { return Touches(plane, box); });
  }

private:
  /// Find the box around the part of the near plane that rays begin at.
  void FindNear(const RaySource& rays)
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    this->Near = { glm::dvec3(infinity), glm::dvec3(-infinity) };
    for (int corner = 0; corner < 4; ++corner)
    {
      const double x = corner & 1 ? 1.0 : -1.0, y = corner & 2 ? 1.0 : -1.0;
      const double forward = rays.Forward.x + x * rays.Forward.y + y * rays.Forward.z;
      const double perForward = rays.Near / forward;
      for (int axis = 0; axis < 3; ++axis)
      {
        const std::array<double, 6> terms = { rays.Origin[0][axis], x * rays.Origin[1][axis],
          y * rays.Origin[2][axis], perForward * rays.Direction[0][axis],
          perForward * x * rays.Direction[1][axis], perForward * y * rays.Direction[2][axis] };
        double sum = 0.0, size = 0.0;
        for (const double term : terms)
        {
          sum += term;
          size += std::abs(term);
        }
        const double rounding = 1e-12 * size;
        const bool isTold = forward > 0.0 && size < infinity;
        this->Near.Low[axis] = std::min(this->Near.Low[axis], isTold ? sum - rounding : -infinity);
        this->Near.High[axis] = std::max(this->Near.High[axis], isTold ? sum + rounding : infinity);
      }
    }
  }

  static bool AreNear(const IndexBox& a, const IndexBox& b)
  {
    return glm::all(glm::lessThanEqual(a.Low, b.High + Slack)) &&
      glm::all(glm::greaterThanEqual(a.High, b.Low - Slack));
  }

  /// \param plane with a normal of unit length; a plane without a normal touches everything
  static bool Touches(const glm::dvec4& plane, const IndexBox& box)
  {
    const glm::dvec3 normal(plane), half = 0.5 * (box.High - box.Low);
    const double distance = glm::dot(normal, 0.5 * (box.Low + box.High)) + plane.w;
    return !(std::abs(distance) > glm::dot(glm::abs(normal), half) + Slack);
  }

  glm::dvec3 Last;
  glm::bvec3 EntersLow, EntersHigh; ///< through which faces of the field's box, by axis
  IndexBox Near;
  std::vector<glm::dvec4> Planes; ///< that cut the field's box
};

/// Finds the blocks of cells in which rays may begin in a solid.
template <typename T>
class CapFinder
{
public:
  CapFinder(const FrameKey& key, const RaySource& rays, const ValueRangePyramid& ranges)
    : Shape(*key.Samples.Shape)
    , Cells(key.Samples.Dimensions - 1)
    , Lowest(
        *std::min_element(key.Isosurfaces().Isovalues.begin(), key.Isosurfaces().Isovalues.end()))
    , Drawn(key.Samples.Labels ? key.Isosurfaces().Isovalues : std::vector<double>())
    , Labels(key.Samples.Labels.get())
    , Begins(rays)
    , Ranges(ranges)
  {
  }

  std::vector<CellBox> Find() const
  {
    std::vector<CellBox> found;
    const glm::ivec3& nodes = this->Ranges.NodeDimensions();
    std::int64_t node = 0;
    for (int z = 0; z < nodes.z; ++z)
    {
      for (int y = 0; y < nodes.y; ++y)
      {
        for (int x = 0; x < nodes.x; ++x, ++node)
        {
          const glm::ivec3 first = ValueRangePyramid::NodeSize * glm::ivec3(x, y, z);
          if (this->AreIn(first, ValueRangePyramid::NodeSize))
          {
            this->FindInNode(this->SolidLeaves(node), first, found);
          }
        }
      }
    }
    return found;
  }

private:
  /// Bits of a node's leaves whose samples may reach into solids.
  std::uint64_t SolidLeaves(std::int64_t node) const
  {
    if (this->Labels)
    {
      return this->Labels->LeavesWith(this->Drawn, node);
    }
    const auto mayBe = [this](const ValueRangePyramid::Range<T>& range)
    { return static_cast<double>(range.Max) >= this->Lowest; };
    const ValueRangePyramid::Range<T>* const ranges = this->Ranges.template LeavesOf<T>(node);
    std::uint64_t leaves = 0;
    const bool isNode = mayBe(this->Ranges.template NodeAt<T>(node));
    for (int leaf = 0; isNode && leaf < ValueRangePyramid::LeavesPerNode; ++leaf)
    {
      leaves |= static_cast<std::uint64_t>(mayBe(ranges[leaf])) << leaf;
    }
    return leaves;
  }

  /// Append the box around those leaves of a node in which rays may begin.
  void FindInNode(
    std::uint64_t leaves, const glm::ivec3& firstCell, std::vector<CellBox>& found) const
  {
    constexpr int size = ValueRangePyramid::LeafSize;
    glm::ivec3 low = this->Cells, high(0);
    for (int leaf = 0; leaf < ValueRangePyramid::LeavesPerNode; ++leaf)
    {
      const glm::ivec3 first = firstCell + size * glm::ivec3(leaf & 3, leaf >> 2 & 3, leaf >> 4);
      if ((leaves >> leaf & 1u) != 0 && glm::all(glm::lessThan(first, this->Cells)) &&
        this->AreIn(first, size))
      {
        low = glm::min(low, first);
        high = glm::max(high, first + size);
      }
    }
    if (glm::all(glm::lessThan(low, high)))
    {
      // Rounding may move a point into the next cell.
      low = glm::max(low - 1, glm::ivec3(0));
      high = glm::min(high + 1, this->Cells);
      found.push_back({ low, high - low });
    }
  }

  bool AreIn(const glm::ivec3& first, int size) const
  {
    return this->Begins.AreIn(
      this->Shape.BoxOf({ first, glm::min(glm::ivec3(size), this->Cells - first) }));
  }

  const FieldShape& Shape;
  glm::ivec3 Cells;
  double Lowest;           ///< isovalue
  LabelIndex Drawn;        ///< labels
  const LabelSets* Labels; ///< of the field; null: samples are no labels
  RayBegins Begins;
  const ValueRangePyramid& Ranges;
};

}

std::vector<std::uint8_t> FindCapTiles(
  const FrameKey& key, const RaySource& rays, const ValueRangePyramid& ranges)
{
  const std::vector<CellBox> blocks = DispatchScalarType(key.Samples.Type,
    [&](auto type) { return CapFinder<decltype(type)>(key, rays, ranges).Find(); });
  return FindTiles(key.View, key.Transform, blocks, *key.Samples.Shape);
}

}
