// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_Trilinear_h
#define TemporalCoherence_Trilinear_h

#include <array>
#include <cstddef>

namespace TemporalCoherence
{
namespace MeshKernels
{

/// A trilinear function on [-1, 1]^3 by its coefficients: [k] belongs to the product of the
/// coordinates whose bits are set in k.
using Trilinear = std::array<double, 8>;

/// From values at corners, x + 2 y + 4 z.
inline Trilinear TrilinearOf(const std::array<double, 8>& corners)
{
  Trilinear c = corners;
  for (std::size_t bit = 1; bit < 8; bit *= 2)
  {
    for (std::size_t k = 0; k < 8; ++k)
    {
      if ((k & bit) == 0)
      {
        const double low = c[k], high = c[k + bit];
        c[k] = 0.5 * (low + high);
        c[k + bit] = 0.5 * (high - low);
      }
    }
  }
  return c;
}

/// Values at the corners.
inline std::array<double, 8> CornersOf(const Trilinear& function)
{
  std::array<double, 8> c = function;
  for (std::size_t bit = 1; bit < 8; bit *= 2)
  {
    for (std::size_t k = 0; k < 8; ++k)
    {
      if ((k & bit) == 0)
      {
        const double middle = c[k], half = c[k + bit];
        c[k] = middle - half;
        c[k + bit] = middle + half;
      }
    }
  }
  return c;
}

/// The function on a box, whose coordinates are again from -1 to 1.
inline Trilinear Restrict(
  const Trilinear& function, const std::array<double, 3>& middle, const std::array<double, 3>& half)
{
  Trilinear c = function;
  for (std::size_t a = 0; a < 3; ++a)
  {
    const std::size_t bit = std::size_t(1) << a;
    for (std::size_t k = 0; k < 8; ++k)
    {
      if ((k & bit) == 0)
      {
        c[k] += middle[a] * c[k + bit];
        c[k + bit] *= half[a];
      }
    }
  }
  return c;
}

inline double ValueAt(const Trilinear& c, const std::array<double, 3>& u)
{
  return (c[0] + u[0] * c[1] + u[1] * (c[2] + u[0] * c[3])) +
    u[2] * (c[4] + u[0] * c[5] + u[1] * (c[6] + u[0] * c[7]));
}

inline std::array<double, 3> GradientAt(const Trilinear& c, const std::array<double, 3>& u)
{
  return { (c[1] + u[1] * c[3]) + u[2] * (c[5] + u[1] * c[7]),
    (c[2] + u[0] * c[3]) + u[2] * (c[6] + u[0] * c[7]),
    (c[4] + u[0] * c[5]) + u[1] * (c[6] + u[0] * c[7]) };
}

using Row = std::array<double, 3>;

inline Row Cross(const Row& a, const Row& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

inline double Dot(const Row& a, const Row& b)
{
  return (a[0] * b[0] + a[1] * b[1]) + a[2] * b[2];
}

}
}

#endif
