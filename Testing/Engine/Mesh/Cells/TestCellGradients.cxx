// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Gradients in cells of meshes are those of the scalar functions, and finite in any cell. They
// depend on the point and its cell alone: the same bits on every kind of vectors.

#include "Checks/Sanitized.h"
#include "EachTarget.h"
#include "Mesh/Cells/CellPoints.h"
#include "Mesh/Cells/KernelsCellGradients.h"
#include "RandomCells.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>

namespace
{

using namespace TemporalCoherence;
using namespace TemporalCoherence::MeshKernels;

glm::dvec3 VectorAt(const PointsInCells::Vectors& vectors, std::size_t i)
{
  return { vectors[0][i], vectors[1][i], vectors[2][i] };
}

bool IsFinite(const glm::dvec3& v)
{
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

bool AreEqual(const PointsInCells& a, std::size_t i, const PointsInCells& b, std::size_t k)
{
  return VectorAt(a.At, i) == VectorAt(b.At, k) &&
    VectorAt(a.Gradient, i) == VectorAt(b.Gradient, k);
}

/// Some cells with some points in, on and near each of them, in any order.
struct SomePoints
{
  std::array<MeshCell, PointsInCells::Capacity> Cells;
  std::size_t NumberOfCells;
  PointsInCells Points;
  std::array<glm::dvec3, PointsInCells::Capacity> Places; ///< where points were put

  explicit SomePoints(RandomCells& random)
    : NumberOfCells(static_cast<std::size_t>(1 + random.Below(20)))
  {
    for (std::size_t i = 0; i < this->NumberOfCells; ++i)
    {
      this->Cells[i] = random.Below(3) == 0 ? random.Tetrahedron() : random.Hexahedron();
    }
    this->Points.Count = static_cast<std::size_t>(1 + random.Below(64));
    for (std::size_t i = 0; i < this->Points.Count; ++i)
    {
      const auto cell = static_cast<std::size_t>(random.Below(static_cast<int>(NumberOfCells)));
      const bool isTetrahedron = this->Cells[cell].Shape == MeshCellShape::Tetrahedron;
      const double spreads[] = { 0.45, 0.5, 0.6, 3.0 };
      const glm::dvec3 at = 0.5 + spreads[std::max(random.Below(8) - 4, 0)] * random.Point();
      this->Places[i] = isTetrahedron ? at / 3.0 : at;
      this->Points.Set(i, cell, PointAt(this->Cells[cell], this->Places[i]));
    }
  }

  void Find() { FindCellGradients(this->Cells.data(), this->NumberOfCells, this->Points); }
};

const int Rounds = IsMemorySanitized ? 100 : 3000;

/// How far a cell is from a parallelepiped at some place in it: 0 at one without volume.
double ThicknessAt(const MeshCell& cell, const glm::dvec3& at)
{
  constexpr double step = 1e-4;
  std::array<glm::dvec3, 3> slopes;
  double box = 1.0;
  for (int a = 0; a < 3; ++a)
  {
    glm::dvec3 ahead = at, behind = at;
    ahead[a] += step;
    behind[a] -= step;
    const auto axis = static_cast<std::size_t>(a);
    slopes[axis] = (PointAt(cell, ahead) - PointAt(cell, behind)) / (2.0 * step);
    box *= glm::length(slopes[axis]);
  }
  return std::abs(glm::dot(slopes[0], glm::cross(slopes[1], slopes[2]))) / box;
}

TEST(CellGradients, AreThoseOfTheScalarFunctions)
{
  RandomCells random(60);
  random.HasScales = false;
  int compared = 0, elsewhere = 0;
  for (int round = 0; round < Rounds; ++round)
  {
    const auto some = std::make_unique<SomePoints>(random);
    some->Find();
    for (std::size_t i = 0; i < some->Points.Count; ++i)
    {
      const MeshCell& cell = some->Cells[some->Points.Cell[i]];
      const PointInCell there = FindPoint(cell, VectorAt(some->Points.Point, i));
      if (!there.IsIn || !(ThicknessAt(cell, there.At) > 1e-2))
      {
        continue;
      }
      ++compared;
      const glm::dvec3 at = VectorAt(some->Points.At, i);
      if (glm::length(at - there.At) > 1e-3)
      {
        // A folded cell has several places for a point.
        EXPECT_LT(glm::length(PointAt(cell, at) - VectorAt(some->Points.Point, i)), 1e-8) << round;
        ++elsewhere;
        continue;
      }
      const glm::dvec3 expected = GradientAt(cell, there.At);
      EXPECT_LT(glm::length(at - there.At), 1e-8) << round;
      EXPECT_LT(glm::length(VectorAt(some->Points.Gradient, i) - expected),
        1e-8 * (glm::length(expected) + 1e-6))
        << round;
    }
  }
  EXPECT_GT(compared, 15 * Rounds);
  EXPECT_LT(elsewhere, compared / 100);
}

TEST(CellGradients, AreFiniteWhateverTheCell)
{
  RandomCells random(61);
  for (int round = 0; round < Rounds; ++round)
  {
    const auto some = std::make_unique<SomePoints>(random);
    some->Find();
    for (std::size_t i = 0; i < some->Points.Count; ++i)
    {
      EXPECT_TRUE(IsFinite(VectorAt(some->Points.At, i))) << round;
      EXPECT_TRUE(IsFinite(VectorAt(some->Points.Gradient, i))) << round;
    }
  }
}

TEST(CellGradients, DependOnThePointAndItsCellAlone)
{
  RandomCells random(62);
  for (int round = 0; round < Rounds / 10; ++round)
  {
    const auto some = std::make_unique<SomePoints>(random);
    some->Find();
    for (std::size_t i = 0; i < some->Points.Count; ++i)
    {
      const auto alone = std::make_unique<PointsInCells>();
      alone->Count = 1;
      alone->Set(0, 0, VectorAt(some->Points.Point, i));
      FindCellGradients(&some->Cells[some->Points.Cell[i]], 1, *alone);
      EXPECT_TRUE(AreEqual(some->Points, i, *alone, 0)) << round;

      alone->HasPlaces = false;
      FindCellGradients(&some->Cells[some->Points.Cell[i]], 1, *alone);
      EXPECT_EQ(VectorAt(some->Points.Gradient, i), VectorAt(alone->Gradient, 0)) << round;
    }
  }
}

TEST(CellGradients, AreTheSameInTetrahedra)
{
  RandomCells random(63);
  PointsInCells points;
  const MeshCell cell = random.Tetrahedron();
  points.Count = 64;
  for (std::size_t i = 0; i < 64; ++i)
  {
    points.Set(i, 0, PointAt(cell, 0.5 + random.Point()));
  }
  FindCellGradients(&cell, 1, points);
  for (std::size_t i = 0; i < 64; ++i)
  {
    EXPECT_EQ(VectorAt(points.Gradient, i), GradientAt(cell, glm::dvec3(0.25)));
  }
}

TEST(CellGradients, NoPointsAreAllowed)
{
  PointsInCells points;
  FindCellGradients(nullptr, 0, points);
  EXPECT_EQ(points.Count, 0u);
}

class CellGradientTargets : public EachTarget
{
};

TEST_F(CellGradientTargets, AllFindTheSameBits)
{
  RandomCells random(64);
  for (int round = 0; round < Rounds / 10; ++round)
  {
    const SomePoints some(random);
    SomePoints reference = some;
    reference.Find();
    this->ForEachTarget(
      [&](const char* target)
      {
        SomePoints found = some;
        found.Find();
        for (std::size_t i = 0; i < some.Points.Count; ++i)
        {
          EXPECT_TRUE(AreEqual(found.Points, i, reference.Points, i)) << target << " " << round;
        }
      });
  }
}

}
