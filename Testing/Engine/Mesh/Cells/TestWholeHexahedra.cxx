// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Hexahedra of small whole values, and rays along their edges: roots lie exactly on borders of
// cells. Each crossing is a root, and no surface is missed.

#include "Checks/Sanitized.h"
#include "Mesh/Cells/HexahedronRoots.h"
#include "Mesh/Cells/KernelsCells.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <random>
#include <vector>

namespace
{

using namespace TemporalCoherence;
using namespace TemporalCoherence::MeshKernels;

using Number = long double;
using Place = std::array<Number, 3>;
using Corners = std::array<double, 8>;

/// A function may be so far from 0 at a root, by its largest value at a corner.
constexpr Number Near = 1e-9L;

class WholeNumbers
{
public:
  explicit WholeNumbers(unsigned int seed)
    : Engine(seed)
  {
  }

  int Below(int count) { return std::uniform_int_distribution<int>(0, count - 1)(this->Engine); }
  double Around() { return std::uniform_real_distribution<double>(-1.0, 1.0)(this->Engine); }

  /// Whole values of the next system are -Most to Most, and are wrong by so much.
  void Next()
  {
    this->Most = 1 + this->Below(4);
    const double roundings[] = { 0.0, 0.0, 1e-15, 1e-14, 1e-13 };
    this->Rounding = roundings[this->Below(5)];
  }
  double Whole() { return this->Rounded(this->Below(2 * this->Most + 1) - this->Most); }
  double Rounded(double value) { return value + this->Rounding * this->Around(); }

  /// From 0 to 1: a border, the middle, or any other place between pixels that are parts of a cell.
  double Fraction()
  {
    const int parts = 1 + this->Below(16);
    return static_cast<double>(this->Below(parts + 1)) / parts;
  }

private:
  std::mt19937 Engine;
  int Most = 1;
  double Rounding = 0.0;
};

/// The function at a place in [-1, 1]^3.
Number ValueAt(const Corners& corners, const Place& at)
{
  Number value = 0;
  for (std::size_t c = 0; c < 8; ++c)
  {
    Number weight = 1;
    for (std::size_t a = 0; a < 3; ++a)
    {
      weight *= (1 + ((c >> a & 1u) != 0 ? at[a] : -at[a])) / 2;
    }
    value += weight * corners[c];
  }
  return value;
}

Number LargestOf(const Corners& corners)
{
  double largest = 0.0;
  for (const double value : corners)
  {
    largest = std::max(largest, std::abs(value));
  }
  return largest > 0.0 ? largest : 1.0;
}

/// How far a place in a cell is from being a root.
Number DistantFromRoot(const SeenHexahedron& cell, const std::array<double, 3>& at)
{
  const Place place = { at[0], at[1], at[2] };
  Number distant = 0;
  for (const Corners* corners : { &cell.X, &cell.Y, &cell.Difference })
  {
    distant = std::max(distant, std::abs(ValueAt(*corners, place)) / LargestOf(*corners));
  }
  for (const Number coordinate : place)
  {
    distant = std::max(distant, std::abs(coordinate) - 1);
  }
  return distant;
}

using Rows = std::array<Place, 3>;

Place Cross(const Place& a, const Place& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

Number Dot(const Place& a, const Place& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// Newton's method.
/// \return true if it ends at a single root well inside of the cell
bool FindSingle(const SeenHexahedron& cell, Place& at)
{
  for (int step = 0; step < 40; ++step)
  {
    Rows rows;
    Place values;
    const Corners* const functions[3] = { &cell.X, &cell.Y, &cell.Difference };
    for (std::size_t i = 0; i < 3; ++i)
    {
      const Number scale = LargestOf(*functions[i]);
      values[i] = ValueAt(*functions[i], at) / scale;
      for (std::size_t a = 0; a < 3; ++a)
      {
        Place ahead = at, behind = at;
        ahead[a] = 1;
        behind[a] = -1;
        rows[i][a] = (ValueAt(*functions[i], ahead) - ValueAt(*functions[i], behind)) / (2 * scale);
      }
    }
    const Rows columns = { Cross(rows[1], rows[2]), Cross(rows[2], rows[0]),
      Cross(rows[0], rows[1]) };
    const Number determinant = Dot(rows[0], columns[0]);
    Number longest = 0, outermost = 0;
    for (std::size_t a = 0; a < 3; ++a)
    {
      const Place column = { columns[0][a], columns[1][a], columns[2][a] };
      const Number move = Dot(values, column) / determinant;
      at[a] -= move;
      longest = std::max(longest, std::abs(move));
      outermost = std::max(outermost, std::abs(at[a]));
    }
    if (!(longest < 8))
    {
      return false;
    }
    if (longest < 1e-15L)
    {
      return std::abs(determinant) > 1e-4L && outermost < 1 - Near;
    }
  }
  return false;
}

/// Counts what is wrong with the roots of systems.
class RootJudge
{
public:
  /// \param starts of Newton's method
  void Look(const SeenHexahedron& cell, const std::vector<Place>& starts)
  {
    HexahedronRoots roots;
    FindRoots(cell, roots);
    for (std::size_t i = 0; i < roots.Count; ++i)
    {
      this->False += DistantFromRoot(cell, roots.Roots[i].At) > Near;
    }
    this->Found += static_cast<int>(roots.Count);
    for (Place at : starts)
    {
      // A line of roots fills the list.
      if (roots.Count == roots.Roots.size() || !FindSingle(cell, at))
      {
        continue;
      }
      ++this->Certain;
      const bool isFound = std::any_of(roots.Roots.begin(), roots.Roots.begin() + roots.Count,
        [&](const HexahedronRoot& root)
        {
          return std::abs(root.At[0] - at[0]) < 1e-7L && std::abs(root.At[1] - at[1]) < 1e-7L &&
            std::abs(root.At[2] - at[2]) < 1e-7L;
        });
      this->Missed += !isFound;
    }
  }

  int Found = 0, False = 0, Certain = 0, Missed = 0;
};

/// A ray along an axis of a unit cube.
TEST(HexahedronRoots, OfWholeValuesInCubes)
{
  WholeNumbers numbers(60);
  RootJudge judge;
  const int count = IsMemorySanitized ? 20000 : 500000;
  for (int i = 0; i < count; ++i)
  {
    numbers.Next();
    const double x = numbers.Fraction(), y = numbers.Fraction();
    SeenHexahedron cell;
    for (std::size_t c = 0; c < 8; ++c)
    {
      cell.X[c] = numbers.Rounded((c & 1u) - x);
      cell.Y[c] = numbers.Rounded((c >> 1 & 1u) - y);
      cell.T[c] = static_cast<double>(c >> 2);
      cell.Difference[c] = numbers.Whole();
    }
    judge.Look(cell, { { 2.0L * x - 1, 2.0L * y - 1, 0 } });
  }
  EXPECT_EQ(judge.False, 0);
  EXPECT_EQ(judge.Missed, 0);
  EXPECT_GT(judge.Found, count / 5);
  EXPECT_GT(judge.Certain, count / 10);
}

/// Any cells and rays whose coordinates are small whole numbers: three functions of such values.
TEST(HexahedronRoots, OfWholeValuesInAnyCells)
{
  WholeNumbers numbers(61);
  RootJudge judge;
  const int count = IsMemorySanitized ? 2000 : 100000;
  for (int i = 0; i < count; ++i)
  {
    numbers.Next();
    SeenHexahedron cell;
    const bool isWarped = numbers.Below(2) == 0;
    for (std::size_t c = 0; c < 8; ++c)
    {
      cell.X[c] = numbers.Whole() + (isWarped ? 3.0 * (c & 1u) - 1.0 : 0.0);
      cell.Y[c] = numbers.Whole() + (isWarped ? 3.0 * (c >> 1 & 1u) - 2.0 : 0.0);
      cell.T[c] = static_cast<double>(c >> 2);
      cell.Difference[c] = numbers.Whole();
    }
    std::vector<Place> starts(4);
    for (Place& start : starts)
    {
      start = { numbers.Around(), numbers.Around(), numbers.Around() };
    }
    judge.Look(cell, starts);
  }
  EXPECT_EQ(judge.False, 0);
  EXPECT_EQ(judge.Missed, 0);
  EXPECT_GT(judge.Found, count / 5);
  EXPECT_GT(judge.Certain, count / 5);
}

/// A cell with edges that are whole vectors, and rays along one of these.
struct SteepCell
{
  MeshCell Cell;
  MeshRays Rays;
  std::array<double, 64> X, Y; ///< in the cell, of rays
  std::size_t Along;

  explicit SteepCell(WholeNumbers& numbers)
  {
    this->Cell.Shape = MeshCellShape::Hexahedron;
    this->Along = static_cast<std::size_t>(numbers.Below(3));
    std::array<glm::dvec3, 3> edges;
    const double length = numbers.Below(2) == 0 ? 1.0 : 0.1;
    const bool isOblique = numbers.Below(2) == 0;
    do
    {
      for (int a = 0; a < 3; ++a)
      {
        glm::dvec3& edge = edges[static_cast<std::size_t>(a)];
        edge = glm::dvec3(a == 0, a == 1, a == 2);
        for (int i = 0; isOblique && i < 3; ++i)
        {
          edge[i] = numbers.Below(5) - 2;
        }
        edge *= length;
      }
    } while (std::abs(glm::dot(edges[0], glm::cross(edges[1], edges[2]))) < 1e-6);
    const glm::dvec3 corner =
      length * glm::dvec3(numbers.Below(40), numbers.Below(40), numbers.Below(40));
    for (std::size_t c = 0; c < 8; ++c)
    {
      glm::dvec3& point = this->Cell.Points[c];
      point = corner;
      for (std::size_t a = 0; a < 3; ++a)
      {
        point += (c >> a & 1u) != 0 ? edges[a] : glm::dvec3(0.0);
      }
      this->Cell.Values[c] = numbers.Whole();
    }
    this->Rays.Count = 64;
    for (std::size_t ray = 0; ray < 64; ++ray)
    {
      this->X[ray] = numbers.Fraction();
      this->Y[ray] = numbers.Fraction();
      const glm::dvec3 origin = corner + this->X[ray] * edges[(this->Along + 1) % 3] +
        this->Y[ray] * edges[(this->Along + 2) % 3] - 8.0 * edges[this->Along];
      for (int a = 0; a < 3; ++a)
      {
        this->Rays.Origin[static_cast<std::size_t>(a)][ray] = origin[a];
        this->Rays.Direction[static_cast<std::size_t>(a)][ray] = edges[this->Along][a];
      }
      this->Rays.Begin[ray] = -1e30;
      this->Rays.End[ray] = 1e30;
    }
    this->Rays.Prepare();
  }

  /// It is not on the border of the cell.
  bool IsInside(std::size_t ray) const
  {
    return std::min(this->X[ray], this->Y[ray]) > 0.0 && std::max(this->X[ray], this->Y[ray]) < 1.0;
  }

  /// The value on a ray. It is linear there: t is 8 where the ray enters, 9 where it leaves.
  Number ValueAt(std::size_t ray, Number t) const
  {
    Place at;
    at[this->Along] = 2 * (t - 8) - 1;
    at[(this->Along + 1) % 3] = 2.0L * this->X[ray] - 1;
    at[(this->Along + 2) % 3] = 2.0L * this->Y[ray] - 1;
    return ::ValueAt(this->Cell.Values, at);
  }
};

/// Crossings of all rays of a tile, by vectors.
TEST(HexahedronRoots, OfWholeValuesByVectors)
{
  WholeNumbers numbers(62);
  const int count = IsMemorySanitized ? 500 : 20000;
  int certain = 0, invented = 0, missed = 0, none = 0;
  for (int i = 0; i < count; ++i)
  {
    numbers.Next();
    const auto cell = std::make_unique<SteepCell>(numbers);
    const auto found = std::make_unique<Crossings>();
    HexahedronCrossings(cell->Cell, cell->Cell.Values, cell->Rays, ~std::uint64_t(0), *found);
    const Number scale = LargestOf(cell->Cell.Values);
    std::array<int, 64> often{};
    for (std::size_t k = 0; k < found->Count; ++k)
    {
      const Number t = found->T[k];
      ++often[found->Ray[k]];
      invented +=
        std::abs(cell->ValueAt(found->Ray[k], t)) > Near * scale || t < 8 - Near || t > 9 + Near;
    }
    for (std::size_t ray = 0; ray < 64; ++ray)
    {
      const Number in = cell->ValueAt(ray, 8), out = cell->ValueAt(ray, 9);
      const bool isSure = cell->IsInside(ray) && std::min(std::abs(in), std::abs(out)) > Near;
      const bool isCrossed = (in < 0) != (out < 0);
      certain += isSure && isCrossed;
      none += isSure && !isCrossed;
      missed += isSure && isCrossed && often[ray] != 1;
      invented += isSure && !isCrossed && often[ray] != 0;
    }
  }
  EXPECT_EQ(invented, 0);
  EXPECT_EQ(missed, 0);
  EXPECT_GT(certain, count);
  EXPECT_GT(none, count);
}

/// The parts of rays in a cell: from face to face, with the values there.
TEST(HexahedronRoots, SpansOfWholeValues)
{
  WholeNumbers numbers(63);
  const int count = IsMemorySanitized ? 500 : 20000;
  int certain = 0, missed = 0, wrong = 0;
  for (int i = 0; i < count; ++i)
  {
    numbers.Next();
    const auto cell = std::make_unique<SteepCell>(numbers);
    const auto spans = std::make_unique<CellSpans>();
    HexahedronSpans(cell->Cell, cell->Cell.Values, cell->Rays, ~std::uint64_t(0), *spans);
    const Number scale = LargestOf(cell->Cell.Values);
    for (std::size_t ray = 0; ray < 64; ++ray)
    {
      if (!cell->IsInside(ray))
      {
        continue;
      }
      ++certain;
      if (spans->Count[ray] != 1)
      {
        ++missed;
        continue;
      }
      const CellSpan& span = spans->Spans[ray][0];
      wrong += std::abs(span.In - 8) > Near || std::abs(span.Out - 9) > Near ||
        std::abs(span.AtIn - cell->ValueAt(ray, 8)) > Near * scale ||
        std::abs(span.AtOut - cell->ValueAt(ray, 9)) > Near * scale;
    }
  }
  EXPECT_EQ(missed, 0);
  EXPECT_EQ(wrong, 0);
  EXPECT_GT(certain, 30 * count);
}

}
