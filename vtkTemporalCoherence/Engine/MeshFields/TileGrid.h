// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_TileGrid_h
#define TemporalCoherence_TileGrid_h

#include "Mesh/MeshBoxes.h"
#include "Scene/RayBatch.h"
#include "Scene/Tiles.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace TemporalCoherence
{

/// The rays of a whole tile as a grid of 8 x 8 pixels: which of them can meet a box or a cell.
class TileGrid
{
public:
  /// \param low, scale mesh coordinates = low + scale * index
  TileGrid(const RayBatch& rays, const glm::dvec3& low, double scale)
  {
    const auto originOf = [&](std::size_t ray)
    { return glm::dvec3(rays.Origin[0][ray], rays.Origin[1][ray], rays.Origin[2][ray]); };
    // How far a ray comes for a unit of depth: an affine function of the pixel.
    const auto aheadOf = [&](std::size_t ray)
    {
      return rays.PerDepth[ray] *
        glm::dvec3(rays.Direction[0][ray], rays.Direction[1][ray], rays.Direction[2][ray]);
    };
    this->Forward = aheadOf(0);
    if (rays.Count != RayBatch::Capacity)
    {
      return;
    }
    constexpr std::size_t right = TileSize - 1, top = RayBatch::Capacity - TileSize;
    constexpr double steps = TileSize - 1;
    this->Origin = originOf(0);
    this->IsPerspective = originOf(right) == this->Origin && originOf(top) == this->Origin;
    const auto& affine = [&](std::size_t ray)
    { return this->IsPerspective ? aheadOf(ray) : originOf(ray); };
    const glm::dmat3 basis(
      aheadOf(0), (affine(right) - affine(0)) / steps, (affine(top) - affine(0)) / steps);
    const glm::dmat3 inverse = glm::inverse(basis);
    for (int row = 0; row < 3; ++row)
    {
      this->Rows[static_cast<std::size_t>(row)] =
        glm::dvec3(inverse[0][row], inverse[1][row], inverse[2][row]);
    }
    const glm::dvec3 sum = this->Rows[0] + this->Rows[1] + this->Rows[2];
    this->IsKnown = std::isfinite(sum.x + sum.y + sum.z);
    this->FindPlanes();
    this->ToMesh(low, scale);
  }

  /// False: nothing is known of the tile but its rays.
  bool IsGrid() const { return this->IsKnown; }

  /// How far a point of index space lies ahead.
  double DepthOf(const glm::dvec3& point) const { return glm::dot(this->Forward, point); }

  /// The same for the nearest point of a box.
  double NearestDepth(const FloatBox& box) const
  {
    const glm::dvec3 low(box.Low), high(box.High);
    return 0.5 *
      (glm::dot(this->Forward, low + high) - glm::dot(glm::abs(this->Forward), high - low));
  }

  /// False if no ray of the tile passes a box of index space.
  bool MayMeet(const FloatBox& box) const
  {
    const glm::dvec3 middle = 0.5 * (glm::dvec3(box.Low) + glm::dvec3(box.High)) - this->Origin;
    return MayMeet(this->Planes, middle, 0.5 * (glm::dvec3(box.High) - glm::dvec3(box.Low)));
  }

  /// The same for a box in the coordinates of the mesh.
  /// \param half of its edges
  bool MayMeet(const glm::dvec3& middle, const glm::dvec3& half) const
  {
    return MayMeet(this->PlanesInMesh, middle - this->OriginInMesh, half);
  }

  /// One bit for each ray that can pass between some points, in the coordinates of the mesh.
  std::uint64_t RaysBetween(const glm::dvec3* points, int count) const
  {
    double lowX = 1e30, highX = -1e30, lowY = 1e30, highY = -1e30;
    for (int i = 0; i < count; ++i)
    {
      const glm::dvec3 from = points[i] - this->OriginInMesh;
      const double depth = this->IsPerspective ? glm::dot(this->RowsInMesh[0], from) : 1.0;
      if (!(depth > 0.0))
      {
        return ~std::uint64_t(0); // beside the eye or behind it
      }
      const double perDepth = 1.0 / depth;
      const double x = glm::dot(this->RowsInMesh[1], from) * perDepth;
      const double y = glm::dot(this->RowsInMesh[2], from) * perDepth;
      lowX = std::min(lowX, x);
      highX = std::max(highX, x);
      lowY = std::min(lowY, y);
      highY = std::max(highY, y);
    }
    const std::uint64_t columns = BitsBetween(lowX, highX), rows = BitsBetween(lowY, highY);
    // Spread the bits of the rows over bytes (seven by one product), and fill these with the
    // columns.
    const std::uint64_t spread =
      ((rows & 0x7f) * 0x0002040810204081u & 0x0101010101010101u) | rows >> 7 << 56;
    return spread * columns;
  }

private:
  /// Normal . (point - Origin) + Offset >= 0.
  struct Plane
  {
    glm::dvec3 Normal, Size;
    double Offset;
  };

  /// Pixels around the tile and around cells, against rounding.
  static constexpr double Margin = 0x1p-6;

  /// Bits of the pixels of a row of the tile between two coordinates.
  static std::uint64_t BitsBetween(double low, double high)
  {
    const int first = static_cast<int>(std::ceil(std::clamp(low - Margin, -1.0, 8.0)));
    const int last = static_cast<int>(std::floor(std::clamp(high + Margin, -1.0, 8.0)));
    const int from = std::max(first, 0), to = std::min(last, TileSize - 1);
    return from > to ? 0 : ((std::uint64_t(2) << to) - 1) & ~((std::uint64_t(1) << from) - 1);
  }

  void FindPlanes()
  {
    constexpr double last = TileSize - 1 + Margin;
    for (std::size_t axis = 0; axis < 2; ++axis)
    {
      const glm::dvec3& along = this->Rows[axis + 1];
      const glm::dvec3 depth = this->IsPerspective ? this->Rows[0] : glm::dvec3(0.0);
      const double one = this->IsPerspective ? 0.0 : 1.0;
      this->Set(2 * axis, along + Margin * depth, Margin * one);
      this->Set(2 * axis + 1, last * depth - along, last * one);
    }
  }

  void Set(std::size_t plane, const glm::dvec3& normal, double offset)
  {
    this->Planes[plane] = { normal, glm::abs(normal), offset };
  }

  static bool MayMeet(
    const std::array<Plane, 4>& planes, const glm::dvec3& middle, const glm::dvec3& half)
  {
    for (const Plane& plane : planes)
    {
      if (glm::dot(plane.Normal, middle) + glm::dot(plane.Size, half) + plane.Offset < 0.0)
      {
        return false;
      }
    }
    return true;
  }

  /// The same planes and rows for points of the mesh.
  void ToMesh(const glm::dvec3& low, double scale)
  {
    this->OriginInMesh = low + scale * this->Origin;
    for (std::size_t i = 0; i < this->Rows.size(); ++i)
    {
      this->RowsInMesh[i] = this->Rows[i] / scale;
    }
    for (std::size_t i = 0; i < this->Planes.size(); ++i)
    {
      const Plane& plane = this->Planes[i];
      this->PlanesInMesh[i] = { plane.Normal / scale, plane.Size / scale, plane.Offset };
    }
  }

  bool IsKnown = false;
  bool IsPerspective = true;
  glm::dvec3 Origin{ 0.0 }, Forward;
  std::array<glm::dvec3, 3> Rows{}; ///< depth and the pixel's place of a point, times depth
  std::array<Plane, 4> Planes{};
  glm::dvec3 OriginInMesh{ 0.0 };
  std::array<glm::dvec3, 3> RowsInMesh{};
  std::array<Plane, 4> PlanesInMesh{};
};

}

#endif
