// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Surfaces and gradients that vectors find in cells of a rectilinear field have the bits of the
// formulas written out one by one.

#include "Checks/Infinity.h"
#include "EachTarget.h"
#include "Kinds/FieldKind.h"
#include "Lattice/Coordinates.h"
#include "Lattice/KernelsCrossing.h"
#include "Lattice/RectilinearCells.h"
#include "Scene/Difference.h"
#include "Shade/RaysFromPoints.h"
#include "Shade/SurfaceNormal.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace
{

using namespace TemporalCoherence;

class KernelsRectilinear : public EachTarget
{
protected:
  using Vectors = std::array<RayBatch::Array<double>, 3>;

  const glm::ivec3 Size{ 12, 10, 9 };
  std::shared_ptr<const GridCoordinates> Coordinates = Stretched(Size, 50.0, 3);
  std::mt19937 Engine{ 7 };

  double Random(double low, double high)
  {
    return std::uniform_real_distribution<double>(low, high)(this->Engine);
  }

  /// Rays through cells, some along faces and some of which begin or end in their cell.
  void MakeRays(int count, RayBatch& rays, std::vector<glm::ivec3>& cells)
  {
    rays.Count = count;
    cells.assign(static_cast<std::size_t>(count), glm::ivec3(0));
    for (std::size_t ray = 0; ray < RayBatch::Capacity; ++ray)
    {
      const bool isIn = ray < cells.size();
      const bool isShort = this->Random(0.0, 1.0) < 0.2;
      for (int axis = 0; axis < 3; ++axis)
      {
        const auto a = static_cast<std::size_t>(axis);
        const int cell = static_cast<int>(this->Random(0.0, this->Size[axis] - 1.001));
        const double low = this->Coordinates->At(axis, cell);
        const double high = this->Coordinates->At(axis, cell + 1);
        const bool isAlongFace = this->Random(0.0, 1.0) < 0.1;
        const double direction = isAlongFace ? 1e-15 : this->Random(-1.0, 1.0);
        rays.Direction[a][ray] = direction;
        rays.Inverse[a][ray] = 1.0 / direction;
        rays.Origin[a][ray] = (isAlongFace ? low : this->Random(low, high)) - 10.0 * direction;
        if (isIn)
        {
          cells[ray][axis] = cell;
        }
      }
      rays.Begin[ray] = isShort ? 9.99 : 0.0;
      rays.End[ray] = isShort ? 10.01 : 100.0;
    }
  }

  template <typename T>
  void CompareGradients(double low, double high, bool withHoles)
  {
    Grid<T> grid(this->Size);
    grid.Field.Shape = RectilinearKind(this->Coordinates);
    grid.FillRandomly(low, high, 6);
    for (std::size_t i = 0; i < grid.Samples.size() && withHoles; i += 11)
    {
      grid.Samples[i] = std::numeric_limits<T>::quiet_NaN();
    }
    const std::vector<double> isovalues{ 0.5 * low + 0.5 * high, high, 0.25 * low + 0.75 * high };
    for (const std::size_t count : { 1u, 7u, 16u, 41u, 64u })
    {
      RaysFromPoints rays;
      rays.Count = count;
      Vectors expected;
      RayBatch::Array<SurfaceIndex> surfaces;
      for (std::size_t i = 0; i < RayBatch::Capacity; ++i)
      {
        surfaces[i] = static_cast<SurfaceIndex>(i / 5 % 3);
        for (std::size_t a = 0; a < 3; ++a)
        {
          // Some on planes between samples, some a little outside of the field.
          const auto& along = this->Coordinates->Along[a];
          const auto plane = static_cast<std::size_t>(this->Random(0.0, 8.9));
          rays.Begin[a][i] =
            this->Random(0.0, 1.0) < 0.3 ? along[plane] : this->Random(-1e-3, along.back() + 1e-3);
          rays.Own[a][i] = 1.0;
        }
      }
      for (std::size_t i = 0; i < count; ++i)
      {
        const glm::dvec3 gradient = this->GradientAt(grid,
          { isovalues[static_cast<std::size_t>(surfaces[i])], { low, high } }, rays.PointAt(i));
        for (std::size_t a = 0; a < 3; ++a)
        {
          expected[a][i] = gradient[static_cast<int>(a)];
        }
      }
      this->ForEachTarget(
        [&](const char* target)
        {
          Vectors found;
          KindOf(grid.Field)
            .FindGradients({ grid.Field, glm::dmat4(1.0), { low, high }, &isovalues },
              { rays, surfaces, found });
          for (std::size_t a = 0; a < 3; ++a)
          {
            EXPECT_TRUE(AreIdentical(found[a], expected[a], static_cast<int>(count)))
              << target << ", axis " << a << ", " << count << " points";
          }
        });
    }
  }

private:
  static double Bounded(double gradient)
  {
    constexpr double largest = std::numeric_limits<double>::max() / 8.0;
    return std::min(std::max(gradient, -largest), largest);
  }

  /// Central differences at the corners of the cell, one-sided at the boundary, interpolated.
  template <typename T>
  glm::dvec3 GradientAt(
    Grid<T>& grid, const Difference<double>& difference, const glm::dvec3& point) const
  {
    glm::ivec3 cell;
    glm::dvec3 at;
    for (int axis = 0; axis < 3; ++axis)
    {
      const std::vector<double>& along = this->Coordinates->Of(axis);
      const auto behind = std::upper_bound(along.begin() + 1, along.end() - 1, point[axis]);
      cell[axis] = static_cast<int>(behind - along.begin()) - 1;
      const double low = behind[-1];
      at[axis] = std::min(std::max((point[axis] - low) / (behind[0] - low), 0.0), 1.0);
    }
    glm::dvec3 sum(0.0);
    for (int corner = 0; corner < 8; ++corner)
    {
      const glm::ivec3 side(corner & 1, corner >> 1 & 1, corner >> 2);
      const glm::dvec3 weights(
        side.x ? at.x : 1.0 - at.x, side.y ? at.y : 1.0 - at.y, side.z ? at.z : 1.0 - at.z);
      const double weight = weights.x * weights.y * weights.z;
      for (int axis = 0; axis < 3 && weight > 0.0; ++axis)
      {
        glm::ivec3 before = cell + side, behind = cell + side;
        before[axis] = std::max(before[axis] - 1, 0);
        behind[axis] = std::min(behind[axis] + 1, this->Size[axis] - 1);
        const double change =
          difference(static_cast<double>(grid.At(behind.x, behind.y, behind.z))) -
          difference(static_cast<double>(grid.At(before.x, before.y, before.z)));
        const double distance =
          this->Coordinates->At(axis, behind[axis]) - this->Coordinates->At(axis, before[axis]);
        sum[axis] += weight * Bounded(change / distance);
      }
    }
    return { Bounded(difference.Unscaled(sum.x)), Bounded(difference.Unscaled(sum.y)),
      Bounded(difference.Unscaled(sum.z)) };
  }
};

TEST_F(KernelsRectilinear, CrossingsAreThoseOfSegmentsOneByOne)
{
  int found = 0;
  for (int batch = 0; batch < 150; ++batch)
  {
    const int count = 1 + batch % RayBatch::Capacity;
    const bool isSolid = batch % 3 == 0;
    RayBatch rays;
    std::vector<glm::ivec3> cells;
    this->MakeRays(count, rays, cells);
    SegmentBatch<double> segments;
    segments.All = &rays;
    segments.Count = count;
    RayBatch::Array<double> enter, distance, atEntry;
    for (std::size_t i = 0; i < RayBatch::Capacity; ++i)
    {
      const glm::ivec3 cell = i < cells.size() ? cells[i] : cells[0];
      Corners<double> corners;
      for (std::size_t corner = 0; corner < 8; ++corner)
      {
        corners[corner] = segments.Corners[corner][i] = this->Random(-1.0, 1.0);
      }
      for (int axis = 0; axis < 3; ++axis)
      {
        const auto a = static_cast<std::size_t>(axis);
        segments.Cell[a][i] = this->Coordinates->At(axis, cell[axis]);
        segments.Last[a][i] = this->Coordinates->At(axis, cell[axis] + 1);
      }
      const RectilinearSegment segment({ rays, i, *this->Coordinates }, cell);
      const Cubic<double> cubic = CubicAlong(corners, segment.Path);
      double share = 0.0;
      const bool isMet = (isSolid && IsInside(cubic[0])) || FirstCrossing(cubic, share);
      enter[i] = segment.Enter;
      atEntry[i] = cubic[0];
      distance[i] = isMet ? segment.DistanceAt(share) : Infinity;
      found += i < cells.size() && std::isfinite(distance[i]);
    }
    this->ForEachTarget(
      [&](const char* target)
      {
        FindCrossingsInBoxes(segments, isSolid);
        EXPECT_TRUE(AreIdentical(segments.Enter, enter, count)) << target;
        EXPECT_TRUE(AreIdentical(segments.AtEntry, atEntry, count)) << target;
        EXPECT_TRUE(AreIdentical(segments.Distance, distance, count)) << target;
      });
  }
  EXPECT_GT(found, 1000);
}

TEST_F(KernelsRectilinear, GradientsAreThoseOfPointsOneByOne)
{
  this->CompareGradients<std::uint8_t>(0.0, 255.0, false);
  this->CompareGradients<std::int32_t>(-2e9, 2e9, false);
  this->CompareGradients<float>(-3.0, 5.0, false);
  this->CompareGradients<double>(-1e200, 1e200, false);
}

TEST_F(KernelsRectilinear, GradientsBesideHoles)
{
  this->CompareGradients<float>(-3.0, 5.0, true);
  this->CompareGradients<double>(-1e200, 1e200, true);
}

}
