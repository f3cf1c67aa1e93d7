// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/Cells/HexahedronRoots.h"

#include "Mesh/Cells/RootItems.h"
#include "Mesh/Cells/Trilinear.h"

#include <algorithm>
#include <cmath>

namespace TemporalCoherence
{
namespace MeshKernels
{

namespace
{

struct Box
{
  std::array<double, 3> Middle, Half;
};

using System = std::array<Trilinear, 3>;

/// A system multiplied by the inverse of its linear part.
struct Preconditioned
{
  System Functions;            ///< linear parts are the coordinates themselves
  std::array<double, 3> Error; ///< rounding errors
  std::array<double, 3> Rest;  ///< bounds of nonlinear parts
  std::array<double, 3> Steep; ///< bounds of the slopes of nonlinear parts
};

/// \return false if the system is singular
bool Precondition(const System& system, Preconditioned& out)
{
  const Row rows[3] = { { system[0][1], system[0][2], system[0][4] },
    { system[1][1], system[1][2], system[1][4] }, { system[2][1], system[2][2], system[2][4] } };
  const Row columns[3] = { Cross(rows[1], rows[2]), Cross(rows[2], rows[0]),
    Cross(rows[0], rows[1]) };
  const double determinant = Dot(rows[0], columns[0]);
  if (!(std::abs(determinant) > LeastDeterminant))
  {
    return false;
  }
  const double scale = 1.0 / determinant;
  // Bound the rounding errors of the inverse by sums of the amounts of its products.
  Row amounts[3], sums[3];
  for (std::size_t j = 0; j < 3; ++j)
  {
    amounts[j] = { std::abs(rows[j][0]), std::abs(rows[j][1]), std::abs(rows[j][2]) };
  }
  for (std::size_t j = 0; j < 3; ++j)
  {
    const Row &a = amounts[(j + 1) % 3], &b = amounts[(j + 2) % 3];
    sums[j] = { a[1] * b[2] + a[2] * b[1], a[2] * b[0] + a[0] * b[2], a[0] * b[1] + a[1] * b[0] };
  }
  const Row constant = { std::abs(system[0][0]), std::abs(system[1][0]), std::abs(system[2][0]) };
  const double all = Dot(amounts[0], sums[0]), lost = ValueError * std::abs(scale);
  for (std::size_t i = 0; i < 3; ++i)
  {
    const Row inverse = { columns[0][i] * scale, columns[1][i] * scale, columns[2][i] * scale };
    const Row inverted = { std::abs(inverse[0]), std::abs(inverse[1]), std::abs(inverse[2]) };
    out.Error[i] = lost * (all + Dot({ sums[0][i], sums[1][i], sums[2][i] }, constant)) +
      ValueError * (inverted[0] + inverted[1] + inverted[2]);
    Trilinear& function = out.Functions[i];
    for (std::size_t k = 0; k < 8; ++k)
    {
      function[k] = Dot(inverse, { system[0][k], system[1][k], system[2][k] });
    }
    function[1] = i == 0;
    function[2] = i == 1;
    function[4] = i == 2;
    const double pairs = std::abs(function[3]) + std::abs(function[5]) + std::abs(function[6]);
    const double triple = std::abs(function[7]);
    out.Rest[i] = pairs + triple;
    out.Steep[i] = 2.0 * pairs + 3.0 * triple;
  }
  return std::isfinite(out.Rest[0] + out.Rest[1] + out.Rest[2]) &&
    std::isfinite(out.Functions[0][0] + out.Functions[1][0] + out.Functions[2][0]);
}

/// Newton's method within the box, where the system has one root at most.
/// \return false if there is none
bool FindOnly(const Preconditioned& system, std::array<double, 3>& v)
{
  std::array<double, 3> most;
  for (std::size_t i = 0; i < 3; ++i)
  {
    most[i] = 1.0 + Margin + system.Error[i];
    v[i] = std::clamp(-system.Functions[i][0], -most[i], most[i]);
  }
  for (int step = 0; step < MostNewtonSteps; ++step)
  {
    Row rows[3], value;
    for (std::size_t i = 0; i < 3; ++i)
    {
      rows[i] = GradientAt(system.Functions[i], v);
      value[i] = ValueAt(system.Functions[i], v);
    }
    const Row columns[3] = { Cross(rows[1], rows[2]), Cross(rows[2], rows[0]),
      Cross(rows[0], rows[1]) };
    const double scale = 1.0 / Dot(rows[0], columns[0]);
    double longest = 0.0, moved = 0.0;
    bool isIn = true;
    for (std::size_t i = 0; i < 3; ++i)
    {
      const double move =
        ((value[0] * columns[0][i] + value[1] * columns[1][i]) + value[2] * columns[2][i]) * scale;
      const double next = std::clamp(v[i] - move, -most[i], most[i]);
      isIn = isIn && std::abs(v[i] - move) <= most[i];
      longest = std::max(longest, std::abs(move));
      moved = std::max(moved, std::abs(next - v[i]));
      v[i] = next;
    }
    if (longest <= LastStep || moved <= LastMove)
    {
      return longest <= LastStep && isIn;
    }
  }
  return false;
}

class Search
{
public:
  Search(const SeenHexahedron& cell, HexahedronRoots& roots)
    : Roots(roots)
  {
    const std::array<double, 8>* const values[3] = { &cell.X, &cell.Y, &cell.Difference };
    for (std::size_t i = 0; i < 3; ++i)
    {
      double largest = 0.0;
      for (const double value : *values[i])
      {
        largest = std::max(largest, std::abs(value));
      }
      this->Whole[i] = TrilinearOf(*values[i]);
      const double scale = largest > 0.0 ? 1.0 / largest : 1.0;
      for (double& coefficient : this->Whole[i])
      {
        coefficient *= scale;
      }
    }
    this->T = TrilinearOf(cell.T);
  }

  void Run()
  {
    this->Put({ { 0.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 } });
    for (int count = 0; count < MostBoxes && this->Next < this->End &&
         this->Roots.Count < this->Roots.Roots.size();
         ++count)
    {
      const Box box = count < MostByTurns ? this->Boxes[this->Next++] : this->Boxes[--this->End];
      this->Look(box);
    }
  }

private:
  /// True if a function has the same sign at all corners.
  static bool IsWithout(const Trilinear& function)
  {
    const std::array<double, 8> corners = CornersOf(function);
    const auto [low, high] = std::minmax_element(corners.begin(), corners.end());
    return *low > ValueError || *high < -ValueError;
  }

  void Look(Box box)
  {
    System system;
    for (std::size_t i = 0; i < 3; ++i)
    {
      system[i] = Restrict(this->Whole[i], box.Middle, box.Half);
      if (IsWithout(system[i]))
      {
        return;
      }
    }
    Preconditioned near;
    bool isShorter = false;
    if (Precondition(system, near))
    {
      const bool isOnly = std::max({ near.Steep[0], near.Steep[1], near.Steep[2] }) < MostNonlinear;
      const double error = std::max({ near.Error[0], near.Error[1], near.Error[2] });
      if (isOnly && error < MostError)
      {
        std::array<double, 3> v;
        if (FindOnly(near, v))
        {
          this->Append({ box.Middle[0] + box.Half[0] * v[0], box.Middle[1] + box.Half[1] * v[1],
            box.Middle[2] + box.Half[2] * v[2] });
        }
        return;
      }
      if (!Shorten(near, box, isShorter))
      {
        return;
      }
    }
    // Search a shortened box again, however small it is: it may hold no root any more.
    if (isShorter)
    {
      this->Put(box);
    }
    else if (std::max({ box.Half[0], box.Half[1], box.Half[2] }) < 0.5 * SmallestBox)
    {
      this->Append(box.Middle);
    }
    else
    {
      this->Halve(box);
    }
  }

  /// Shorten a box to the part that can hold roots.
  /// \return false if nothing is left
  static bool Shorten(const Preconditioned& near, Box& box, bool& isShorter)
  {
    std::array<double, 3> middle, share;
    for (std::size_t i = 0; i < 3; ++i)
    {
      const double reach = near.Rest[i] + near.Error[i] + Margin, at = -near.Functions[i][0];
      const double low = std::max(at - reach, -1.0), high = std::min(at + reach, 1.0);
      if (low > high)
      {
        return false;
      }
      middle[i] = 0.5 * (low + high);
      share[i] = 0.5 * (high - low);
    }
    isShorter = CutBox(middle, share, box.Middle, box.Half);
    return true;
  }

  void Halve(const Box& box)
  {
    const auto a = static_cast<std::size_t>(
      std::max_element(box.Half.begin(), box.Half.end()) - box.Half.begin());
    Box part = box;
    part.Half[a] *= 0.5;
    part.Middle[a] = box.Middle[a] + part.Half[a];
    this->Put(part);
    part.Middle[a] = box.Middle[a] - part.Half[a];
    this->Put(part);
  }

  void Append(const std::array<double, 3>& at)
  {
    HexahedronRoot root;
    root.At = at;
    root.T = ValueAt(this->T, at) + 0.0;
    const Row x = GradientAt(this->Whole[0], at), y = GradientAt(this->Whole[1], at);
    const Row along = Cross(x, y);
    const double difference = Dot(along, GradientAt(this->Whole[2], at));
    const double distance = Dot(along, GradientAt(this->T, at));
    root.Rises = (difference > 0.0) == (distance > 0.0);
    AddRoot(root, this->Roots);
  }

  void Put(const Box& box) { this->Boxes[this->End++] = box; }

  /// The first boxes are searched in the order of their creation, large ones first, so that single
  /// roots are found before a line of roots uses up MostBoxes. All later boxes are searched depth
  /// first, so that few of them wait: one for each halving along each axis.
  static constexpr int MostByTurns = 256;
  static constexpr std::size_t MostHalved = 112;

  HexahedronRoots& Roots;
  System Whole;
  Trilinear T;
  std::array<Box, 2 * MostByTurns + MostHalved> Boxes;
  std::size_t Next = 0, End = 0;
};

}

void FindRoots(const SeenHexahedron& cell, HexahedronRoots& roots)
{
  roots.Count = 0;
  Search(cell, roots).Run();
}

}
}
