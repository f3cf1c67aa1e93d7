// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_TileGrid_h
#define TemporalCoherence_TileGrid_h

#include "Mesh/Tiles/KernelsOutlines.h"
#include "Mesh/Tiles/KernelsTileGrid.h"
#include "Mesh/Tree/MeshTree.h"
#include "Scene/RayBatch.h"
#include "Scene/Tiles.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace TemporalCoherence
{

/// The rays of a whole tile as a grid of 8 x 8 pixels. Finds the pixels that can see a box or a
/// cell.
class TileGrid
{
public:
  TileGrid() = default;
  TileGrid(const RayBatch& rays, const MeshTree& tree)
    : Lattice(tree.Dimensions().x + tree.Dimensions().y + tree.Dimensions().z)
  {
    this->Forward = AheadOf(rays, 0);
    const bool areOfView = rays.PerDepth[0] != 0.0;
    if (rays.Count == RayBatch::Capacity && areOfView)
    {
      this->FindRows(rays);
      this->Forward = this->IsKnown ? this->Seen.Row[0] : this->Forward;
      this->Around = this->PlanesAlong(TileSize);
      for (const float offset : this->Around.Offset)
      {
        this->IsKnown &= std::isfinite(offset);
      }
    }
  }

  /// False: the rays form no such grid, and the tile has no planes or projections.
  bool IsGrid() const { return this->IsKnown; }

  /// Depth of a point of index space.
  double DepthOf(const glm::dvec3& point) const { return glm::dot(this->Forward, point); }

  /// True if two grids measure equal depths, within rounding: their tiles belong to one view.
  bool HasDepthsOf(const TileGrid& other) const
  {
    return glm::length(other.Forward - this->Forward) <= SameDepth * glm::length(this->Forward);
  }

  /// Unit of depths, a power of two: ray i has depth w at t = w DepthUnit() PerDepth[i].
  double DepthUnit() const { return this->Unit; }

  /// Convert a depth (DepthOf) of this grid, or of a grid with HasDepthsOf(), to w of OutlineView,
  /// rounded down.
  /// \pre IsGrid()
  double ToSeenDepth(double depth) const
  {
    const double slack = 2.0 * SameDepth * this->Reach() * glm::length(this->Forward);
    return depth - this->DepthOf(this->Seen.Origin) - slack;
  }

  /// The depth of the nearest point of a box. Orders boxes from front to back, roughly.
  double NearestDepth(const FloatBox& box) const
  {
    const glm::dvec3 low(box.Low), high(box.High);
    return 0.5 *
      (glm::dot(this->Forward, low + high) - glm::dot(glm::abs(this->Forward), high - low));
  }

  /// Planes around the tile, in index space.
  const TilePlanes& Planes() const { return this->Around; }

  /// Planes around `columns` columns of pixels, beginning with the tile's first column.
  TilePlanes PlanesAlong(int columns) const
  {
    const std::array<double, 2> last = { columns - 1 + Margin, TileSize - 1 + Margin };
    const glm::dvec3 depth = this->Seen.IsPerspective ? this->Seen.Row[0] : glm::dvec3(0.0);
    const double one = this->Seen.IsPerspective ? 0.0 : 1.0;
    TilePlanes planes;
    for (std::size_t axis = 0; axis < 2; ++axis)
    {
      const glm::dvec3& along = this->Seen.Row[axis + 1];
      this->SetPlane(2 * axis, along + Margin * depth, Margin * one, planes);
      this->SetPlane(2 * axis + 1, last[axis] * depth - along, last[axis] * one, planes);
    }
    return planes;
  }

  /// True if the tile's rays lie between the planes of another tile or strip.
  /// \pre IsGrid()
  bool IsWithin(const TilePlanes& planes, const RayBatch& rays) const
  {
    // A part of the slack is left for single precision.
    const double slack = 0.5 * this->Slack();
    for (const std::size_t corner : Corners)
    {
      const glm::dvec3 from = OriginOf(rays, corner), along = DirectionOf(rays, corner);
      const glm::dvec3 to = from + 2.0 * this->Reach() / glm::length(along) * along;
      for (std::size_t plane = 0; plane < planes.Offset.size(); ++plane)
      {
        const glm::dvec3 normal(
          planes.Normal[0][plane], planes.Normal[1][plane], planes.Normal[2][plane]);
        const double offset = static_cast<double>(planes.Offset[plane]) - slack;
        if (!(glm::dot(normal, from) + offset >= 0.0 && glm::dot(normal, to) + offset >= 0.0))
        {
          return false;
        }
      }
    }
    return true;
  }

  /// True if the rays belong to a tile beside this one, in the same rows of pixels.
  /// \param column result: the first column of that tile, in this grid
  /// \pre IsGrid(), also for the grid of the rays
  bool HasBeside(const RayBatch& rays, double& column) const
  {
    constexpr double most = 1e-4;
    const double reach = this->Reach();
    for (const std::size_t corner : Corners)
    {
      const glm::dvec3 from = OriginOf(rays, corner) - this->Seen.Origin;
      const glm::dvec3 along = this->Unit * AheadOf(rays, corner);
      const glm::dvec3 start = this->Seen.Place(from), step = this->Seen.Place(along);
      const glm::dvec3& at = this->Seen.IsPerspective ? step : start;
      const glm::dvec3 beside = this->Seen.IsPerspective
        ? reach * glm::abs(start)
        : glm::abs(glm::dvec3(start.x, reach * step.y, reach * step.z));
      const double x = static_cast<double>(corner % TileSize);
      const double y = static_cast<double>(corner / TileSize);
      column = corner == 0 ? std::round(at.y) : column;
      if (!(std::max({ std::abs(at.y - column - x), std::abs(at.z - y), std::abs(step.x - 1.0),
              beside.x, beside.y, beside.z }) < most))
      {
        return false;
      }
    }
    return true;
  }

  /// Find the tile's projection of points in a box of index space, relative to the box's middle.
  /// \return false if it is unknown: the box is too near the eye or too large
  bool See(const FloatBox& box, OutlineView& view) const
  {
    constexpr double nearest = 0.125, farthest = 0x1p16;
    const glm::dvec3 middle = box.Middle() - this->Seen.Origin;
    const glm::dvec3 half = 0.5 * (glm::dvec3(box.High) - glm::dvec3(box.Low));
    std::array<double, 3> reach;
    const double aroundDepth = glm::dot(glm::abs(this->Seen.Row[0]), half);
    for (std::size_t row = 0; row < 3; ++row)
    {
      const glm::dvec3& along = this->Seen.Row[row];
      const double at = glm::dot(along, middle), around = glm::dot(glm::abs(along), half);
      for (std::size_t a = 0; a < 3; ++a)
      {
        view.Row[row][a] = static_cast<float>(along[static_cast<int>(a)]);
      }
      view.Middle[row] = static_cast<float>(at);
      reach[row] = row == 0 ? at - around : std::abs(at) + around;
    }
    view.IsPerspective = this->Seen.IsPerspective;
    view.Margin = static_cast<float>(Margin);
    const double depth = view.IsPerspective ? reach[0] : 1.0;
    const double pixels = std::max(reach[1], reach[2]) / depth;
    view.Reach = static_cast<float>(pixels);
    view.DepthReach = static_cast<float>(std::abs(view.Middle[0]) + aroundDepth);
    const bool isAhead =
      !view.IsPerspective || reach[0] > nearest * static_cast<double>(view.Middle[0]);
    return this->IsKnown && isAhead && pixels < farthest;
  }

private:
  /// The rays at the corners of a tile.
  static constexpr std::array<std::size_t, 4> Corners{ 0, TileSize - 1, 64 - TileSize, 63 };

  /// Projects a point p of index space: with q = p - Origin, the column is Row[1] . q / Row[0] . q,
  /// and the row is Row[2] . q / Row[0] . q. Parallel views skip the division.
  struct TileRows
  {
    /// Depth, column and row of Origin + distance, in parallel views.
    glm::dvec3 Place(const glm::dvec3& distance) const
    {
      return { glm::dot(this->Row[0], distance), glm::dot(this->Row[1], distance),
        glm::dot(this->Row[2], distance) };
    }

    std::array<glm::dvec3, 3> Row;
    glm::dvec3 Origin;
    bool IsPerspective;
  };

  /// Largest relative difference of equal depth directions.
  static constexpr double SameDepth = 1e-10;

  /// Pixels around the tile and around cells, against rounding.
  static constexpr double Margin = 0x1p-6;

  static glm::dvec3 OriginOf(const RayBatch& rays, std::size_t ray)
  {
    return { rays.Origin[0][ray], rays.Origin[1][ray], rays.Origin[2][ray] };
  }

  static glm::dvec3 DirectionOf(const RayBatch& rays, std::size_t ray)
  {
    return { rays.Direction[0][ray], rays.Direction[1][ray], rays.Direction[2][ray] };
  }

  /// Step of a ray per unit of RayBatch's depth: an affine function of the pixel.
  static glm::dvec3 AheadOf(const RayBatch& rays, std::size_t ray)
  {
    return rays.PerDepth[ray] * DirectionOf(rays, ray);
  }

  /// Depth, column and row of a point are linear in the steps from pixel to pixel.
  void FindRows(const RayBatch& rays)
  {
    constexpr std::size_t right = TileSize - 1, top = RayBatch::Capacity - TileSize;
    constexpr double steps = TileSize - 1;
    const glm::dvec3 origin = OriginOf(rays, 0);
    const bool isPerspective = OriginOf(rays, right) == origin && OriginOf(rays, top) == origin;
    const auto affine = [&](std::size_t ray)
    { return isPerspective ? AheadOf(rays, ray) : OriginOf(rays, ray); };
    const glm::dmat3 inverse = glm::inverse(glm::dmat3(
      AheadOf(rays, 0), (affine(right) - affine(0)) / steps, (affine(top) - affine(0)) / steps));
    double sum = 0.0;
    for (int row = 0; row < 3; ++row)
    {
      this->Seen.Row[static_cast<std::size_t>(row)] = { inverse[0][row], inverse[1][row],
        inverse[2][row] };
      sum += std::abs(inverse[0][row]) + std::abs(inverse[1][row]) + std::abs(inverse[2][row]);
    }
    this->Seen.Origin = origin;
    this->Seen.IsPerspective = isPerspective;
    this->IsKnown = std::isfinite(sum);
    if (this->IsKnown && glm::length(this->Seen.Row[0]) > 0.0)
    {
      this->SetUnit();
    }
  }

  /// Choose a unit in which depths fit single precision, however large the mesh is in the world.
  /// Meshes of usual size have the unit 1. All tiles of a view must choose equal units although
  /// their depths differ by rounding errors, so usual sizes lie far from the limits between two
  /// units.
  void SetUnit()
  {
    constexpr double octaves = 64.0, begin = 31.63;
    const double size = std::log2(glm::length(this->Seen.Row[0]));
    const double steps = std::floor((size + begin) / octaves);
    this->Unit = std::ldexp(1.0, static_cast<int>(octaves * steps));
    for (std::size_t row = 0; row < 3; ++row)
    {
      this->Seen.Row[row] /= row == 0 || this->Seen.IsPerspective ? this->Unit : 1.0;
    }
  }

  /// Upper bound of the lattice's distance from 0 and from the eye.
  double Reach() const
  {
    const glm::dvec3& origin = this->Seen.Origin;
    return std::abs(origin.x) + std::abs(origin.y) + std::abs(origin.z) + this->Lattice;
  }

  /// Slack for rounding to single precision.
  double Slack() const
  {
    constexpr double rounding = 1e-6;
    return rounding * this->Reach();
  }

  /// normal . (point - Origin) + offset >= 0, with slack.
  void SetPlane(
    std::size_t plane, const glm::dvec3& normal, double offset, TilePlanes& planes) const
  {
    const double size = glm::length(normal);
    const glm::dvec3 unit = normal / size;
    for (std::size_t a = 0; a < 3; ++a)
    {
      planes.Normal[a][plane] = static_cast<float>(unit[static_cast<int>(a)]);
    }
    planes.Offset[plane] =
      static_cast<float>(offset / size - glm::dot(unit, this->Seen.Origin) + this->Slack());
  }

  double Lattice = 0.0; ///< sum of the lengths of its axes
  bool IsKnown = false;
  double Unit = 1.0; ///< of depths
  glm::dvec3 Forward{ 0.0 };
  TileRows Seen{};
  TilePlanes Around{};
};

}

#endif
