// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Points in a cell are found there, and points outside of it are not. Gradients agree with small
// steps, also at corners without volume.

#include "Mesh/Cells/CellPoints.h"
#include "RandomCells.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{

using namespace TemporalCoherence;
using namespace TemporalCoherence::MeshKernels;

glm::dvec3 SomewhereIn(RandomCells& random, const MeshCell& cell)
{
  const glm::dvec3 at = 0.5 + 0.45 * random.Point();
  return cell.Shape == MeshCellShape::Tetrahedron ? at / 3.0 : at;
}

/// True for cells that RandomCells has flattened. Nothing is exactly in them.
bool IsFlat(const MeshCell& cell)
{
  bool isFlat = true;
  for (const glm::dvec3& point : cell.Points)
  {
    const glm::dvec3 edge = point - cell.Points[0];
    isFlat = isFlat && std::abs(edge.z - 0.25 * edge.x) < 1e-9;
  }
  return isFlat;
}

TEST(CellPoints, AreFoundInCells)
{
  RandomCells random(50);
  random.HasScales = false;
  for (int round = 0; round < 20000; ++round)
  {
    const MeshCell cell = round % 2 == 0 ? random.Hexahedron() : random.Tetrahedron();
    const glm::dvec3 at = SomewhereIn(random, cell), point = PointAt(cell, at);
    const PointInCell found = FindPoint(cell, point);
    ASSERT_TRUE(std::isfinite(found.At.x + found.At.y + found.At.z));
    if (found.IsIn)
    {
      // Folded cells have several places for a point.
      EXPECT_LT(glm::length(PointAt(cell, found.At) - point), 1e-7) << round;
    }
    else
    {
      EXPECT_TRUE(round % 2 == 1 || IsFlat(cell)) << round;
    }
  }
}

TEST(CellPoints, OutsideAreNotInCells)
{
  RandomCells random(51);
  random.HasScales = false;
  for (int round = 0; round < 5000; ++round)
  {
    const MeshCell cell = round % 2 == 0 ? random.Hexahedron() : random.Tetrahedron();
    glm::dvec3 outside = cell.Points[0];
    for (std::size_t c = 1; c < 8; ++c)
    {
      outside = glm::max(outside, cell.Points[c]);
    }
    outside += 0.01;
    EXPECT_FALSE(FindPoint(cell, outside).IsIn) << round;
  }
}

TEST(CellPoints, GradientsAreThoseOfSmallSteps)
{
  RandomCells random(52);
  random.HasScales = false;
  int compared = 0;
  for (int round = 0; round < 20000; ++round)
  {
    const MeshCell cell = round % 2 == 0 ? random.Hexahedron() : random.Tetrahedron();
    const glm::dvec3 at = SomewhereIn(random, cell);
    const glm::dvec3 gradient = GradientAt(cell, at);
    ASSERT_TRUE(std::isfinite(gradient.x + gradient.y + gradient.z));
    constexpr double step = 1e-6;
    for (int a = 0; a < 3; ++a)
    {
      glm::dvec3 ahead = at, behind = at;
      ahead[a] += step;
      behind[a] -= step;
      // The chain rule, which holds in flat cells only as well as values fit.
      const double expected = ValueAt(cell, ahead) - ValueAt(cell, behind);
      const glm::dvec3 moved = PointAt(cell, ahead) - PointAt(cell, behind);
      if (glm::length(gradient) < 100.0)
      {
        const double wrong = std::abs(glm::dot(gradient, moved) - expected) / step;
        compared += wrong < 1e-4 * (1.0 + glm::length(gradient));
      }
    }
  }
  EXPECT_GT(compared, 3 * 20000 * 8 / 10);
}

TEST(CellPoints, GradientsOfCornersWithoutVolumeAreThoseBesideThem)
{
  MeshCell pyramid;
  pyramid.Shape = MeshCellShape::Hexahedron;
  const glm::dvec3 slope(1.0, -2.0, 3.0);
  for (std::size_t c = 0; c < 8; ++c)
  {
    pyramid.Points[c] = c < 4 ? glm::dvec3(c & 1, c >> 1, 0.0) : glm::dvec3(0.5, 0.5, 1.0);
    pyramid.Values[c] = glm::dot(slope, pyramid.Points[c]);
  }
  const glm::dvec3 apex = GradientAt(pyramid, glm::dvec3(0.3, 0.6, 1.0));
  EXPECT_NEAR(glm::length(apex - slope), 0.0, 1e-6);
  EXPECT_TRUE(FindPoint(pyramid, glm::dvec3(0.5, 0.5, 1.0)).IsIn);

  // A point: no gradient, but numbers.
  MeshCell point = pyramid;
  point.Points.fill(glm::dvec3(1.0, 2.0, 3.0));
  EXPECT_EQ(GradientAt(point, glm::dvec3(0.5)), glm::dvec3(0.0));
  EXPECT_TRUE(std::isfinite(FindPoint(point, glm::dvec3(5.0)).At.x));
}

}
