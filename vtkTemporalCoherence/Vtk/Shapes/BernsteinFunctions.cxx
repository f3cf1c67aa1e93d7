// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Shapes/BernsteinFunctions.h"

#include <cstddef>

namespace TemporalCoherence
{
namespace
{

/// Number of powers of a variable: 0 to the highest order of VTK's cells.
constexpr int MostPowers = 11;

double Factorial(int n)
{
  return n < 2 ? 1.0 : n * Factorial(n - 1);
}

/// The multinomial coefficient of a product of these powers.
template <typename... Powers>
double Multinomial(Powers... powers)
{
  return Factorial((powers + ...)) / (Factorial(powers) * ...);
}

/// The variables of functions at a place: coordinates, and their complements to 1.
std::array<double, 6> VariablesAt(CurvedShape shape, const glm::dvec3& at)
{
  switch (shape)
  {
    case CurvedShape::Tetrahedron:
      return { at.x, at.y, at.z, 1.0 - at.x - at.y - at.z, 1.0, 1.0 };
    case CurvedShape::Wedge:
      return { at.x, at.y, 1.0 - at.x - at.y, at.z, 1.0 - at.z, 1.0 };
    case CurvedShape::Hexahedron:
    case CurvedShape::Pyramid:
      break;
  }
  return { at.x, 1.0 - at.x, at.y, 1.0 - at.y, at.z, 1.0 - at.z };
}

}

BernsteinFunctions::BernsteinFunctions(
  CurvedShape shape, const std::vector<glm::dvec3>& places, const std::array<int, 3>& powers)
  : Shape(shape)
{
  for (const glm::dvec3& place : places)
  {
    const glm::dvec3 steps = place * glm::dvec3(powers[0], powers[1], powers[2]);
    const glm::ivec3 at = glm::ivec3(glm::round(steps));
    const int i = at.x, j = at.y, k = at.z, n = powers[0];
    Function function{ 0.0, { i, n - i, j, powers[1] - j, k, powers[2] - k } };
    double factor = 1.0;
    if (shape == CurvedShape::Tetrahedron)
    {
      function.Powers = { i, j, k, n - i - j - k, 0, 0 };
      factor = Multinomial(i, j, k, n - i - j - k);
    }
    else if (shape == CurvedShape::Wedge)
    {
      function.Powers = { i, j, n - i - j, k, powers[2] - k, 0 };
      factor = Multinomial(i, j, n - i - j) * Multinomial(k, powers[2] - k);
    }
    else
    {
      factor =
        Multinomial(i, n - i) * Multinomial(j, powers[1] - j) * Multinomial(k, powers[2] - k);
    }
    function.Factor = factor;
    bool isKnown = glm::length(steps - glm::dvec3(at)) < 1e-6;
    for (const int power : function.Powers)
    {
      isKnown = isKnown && power >= 0 && power < MostPowers;
    }
    if (!isKnown)
    {
      this->Functions.clear();
      return;
    }
    this->Functions.push_back(function);
  }
}

void BernsteinFunctions::At(const glm::dvec3& place, double* values) const
{
  const std::array<double, 6> variables = VariablesAt(this->Shape, place);
  std::array<std::array<double, MostPowers>, 6> powers;
  for (std::size_t v = 0; v < variables.size(); ++v)
  {
    powers[v][0] = 1.0;
    for (std::size_t p = 1; p < powers[v].size(); ++p)
    {
      powers[v][p] = powers[v][p - 1] * variables[v];
    }
  }
  for (std::size_t f = 0; f < this->Functions.size(); ++f)
  {
    values[f] = this->Functions[f].Factor;
    for (std::size_t v = 0; v < variables.size(); ++v)
    {
      values[f] *= powers[v][static_cast<std::size_t>(this->Functions[f].Powers[v])];
    }
  }
}

}
