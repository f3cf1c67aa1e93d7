// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_CellRoot_h
#define TemporalCoherence_CellRoot_h

#include "Scene/Surfaces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

/// The first crossing of zero along a straight path through one cell.
///
/// All functions here are pure: the result depends on the eight corner values and the path alone.
/// Values on a face are computed from the face's own four corners. They are bit-identical in both
/// cells that share the face, so that no surface is lost or met twice between cells.
namespace TemporalCoherence
{

/// Differences from the isovalue at the corners of a cell, corner (x, y, z) at [x + 2 y + 4 z].
template <typename Real>
using Corners = std::array<Real, 8>;

/// Ends of a path through a cell, in the cell's own coordinates [0, 1]^3.
template <typename Real>
struct CellPath
{
  std::array<Real, 3> Begin, End;
};

/// Weighted mean: exactly a at weight 0, exactly b at weight 1, and of their sign if a and b have
/// equal signs.
template <typename Real>
Real Mix(Real a, Real b, Real weightOfB)
{
  return (Real(1) - weightOfB) * a + weightOfB * b;
}

/// A cubic on [0, 1] by its Bernstein coefficients: it lies within their range.
template <typename Real>
using Cubic = std::array<Real, 4>;

/// The trilinear interpolant along a path. Trilinear means affine in each coordinate, so that the
/// Bernstein coefficients are the means of the values at the corners of the box around the path
/// (its polar form): first at Begin, last at End.
template <typename Real>
Cubic<Real> CubicAlong(const Corners<Real>& v, const CellPath<Real>& path)
{
  // box[x + 2 y + 4 z]: the value where each coordinate equals Begin's (0) or End's (1).
  Corners<Real> alongX, alongXY, box;
  for (std::size_t row = 0; row < 8; row += 2)
  {
    alongX[row] = Mix(v[row], v[row + 1], path.Begin[0]);
    alongX[row + 1] = Mix(v[row], v[row + 1], path.End[0]);
  }
  for (std::size_t slice = 0; slice < 8; slice += 4)
  {
    for (std::size_t x = 0; x < 2; ++x)
    {
      const Real low = alongX[slice + x];
      const Real high = alongX[slice + 2 + x];
      alongXY[slice + x] = Mix(low, high, path.Begin[1]);
      alongXY[slice + 2 + x] = Mix(low, high, path.End[1]);
    }
  }
  for (std::size_t xy = 0; xy < 4; ++xy)
  {
    box[xy] = Mix(alongXY[xy], alongXY[4 + xy], path.Begin[2]);
    box[4 + xy] = Mix(alongXY[xy], alongXY[4 + xy], path.End[2]);
  }
  constexpr Real third = Real(1) / Real(3);
  return { box[0], (box[1] + box[2] + box[4]) * third, (box[6] + box[5] + box[3]) * third, box[7] };
}

/// The cubic's value, by repeated means (de Casteljau). Its sign is exact if all coefficients have
/// the same sign.
template <typename Real>
Real Evaluate(const Cubic<Real>& b, Real s)
{
  const Real q0 = Mix(b[0], b[1], s), q1 = Mix(b[1], b[2], s), q2 = Mix(b[2], b[3], s);
  return Mix(Mix(q0, q1, s), Mix(q1, q2, s), s);
}

/// The crossing between low and high, where the cubic changes sides once: Newton's method, kept
/// within the bracket by bisection.
template <typename Real>
Real RefineCrossing(const Cubic<Real>& b, Real low, Real high)
{
  constexpr int MostSteps = 32;
  constexpr Real Tolerance = sizeof(Real) == 4 ? Real(1e-6) : Real(1e-12);

  // Power form about 0, for values and slopes at the price of six operations.
  const Real c0 = b[0];
  const Real c1 = Real(3) * (b[1] - b[0]);
  const Real c2 = Real(3) * ((b[2] - b[1]) - (b[1] - b[0]));
  const Real c3 = (b[3] - b[0]) - Real(3) * (b[2] - b[1]);

  const Real atLow = Evaluate(b, low);
  const Real atHigh = Evaluate(b, high);
  const bool insideLow = IsInside(atLow);

  // Start where the chord crosses, but away from the ends. An end may be a root itself, as samples
  // equal to the isovalue are common, yet not the crossing in question.
  const Real chord = atHigh != atLow ? atLow / (atLow - atHigh) : Real(0.5);
  Real s = low + (high - low) * std::min(std::max(chord, Real(0.0625)), Real(0.9375));
  for (int step = 0; step < MostSteps; ++step)
  {
    const Real value = ((c3 * s + c2) * s + c1) * s + c0;
    const Real slope = (Real(3) * c3 * s + Real(2) * c2) * s + c1;
    (IsInside(value) == insideLow ? low : high) = s;
    const Real distance = slope != Real(0) ? -value / slope : Real(2);
    Real next = s + distance;
    if (!(next > low && next < high))
    {
      if (std::abs(distance) <= Tolerance || high - low <= Tolerance)
      {
        break;
      }
      next = Real(0.5) * (low + high);
    }
    const Real moved = std::abs(next - s);
    s = next;
    if (moved <= Tolerance)
    {
      break;
    }
  }
  return s;
}

/// The turning points of a cubic, ascending; `count` of them within (0, 1).
template <typename Real>
std::array<Real, 2> TurningPoints(const Cubic<Real>& b, int& count)
{
  // The steps are the Bernstein coefficients of a third of the derivative, a quadratic. They are
  // scaled by the largest, so that squares neither overflow nor vanish.
  Real d0 = b[1] - b[0], d1 = b[2] - b[1], d2 = b[3] - b[2];
  const Real largest = std::max(std::abs(d0), std::max(std::abs(d1), std::abs(d2)));
  std::array<Real, 2> points{};
  count = 0;
  if (!(largest > Real(0)))
  {
    return points;
  }
  d0 /= largest;
  d1 /= largest;
  d2 /= largest;
  const Real a = (d2 - d1) - (d1 - d0), halfB = d1 - d0, c = d0;
  const Real discriminant = halfB * halfB - a * c;
  if (!(discriminant > Real(0)))
  {
    return points;
  }
  const Real q = -(halfB + std::copysign(std::sqrt(discriminant), halfB));
  for (const auto& [numerator, denominator] : { std::pair{ c, q }, std::pair{ q, a } })
  {
    if (denominator != Real(0))
    {
      const Real s = numerator / denominator;
      if (s > Real(0) && s < Real(1))
      {
        points[static_cast<std::size_t>(count++)] = s;
      }
    }
  }
  if (count == 2 && points[0] > points[1])
  {
    std::swap(points[0], points[1]);
  }
  return points;
}

/// Lowest and highest value of a cubic on [0, 1].
template <typename Real>
std::array<Real, 2> RangeOf(const Cubic<Real>& b)
{
  Real lowest = std::min(b[0], b[3]), highest = std::max(b[0], b[3]);
  if (std::max(b[1], b[2]) > highest || std::min(b[1], b[2]) < lowest)
  {
    int count = 0;
    const std::array<Real, 2> turns = TurningPoints(b, count);
    for (int turn = 0; turn < count; ++turn)
    {
      const Real value = Evaluate(b, turns[static_cast<std::size_t>(turn)]);
      lowest = std::min(lowest, value);
      highest = std::max(highest, value);
    }
  }
  return { lowest, highest };
}

/// Call visit(s) for each s in [0, 1] where the cubic changes between inside and outside,
/// ascending, until it returns true.
template <typename Real, typename Visit>
void VisitCrossings(const Cubic<Real>& b, const Visit& visit)
{
  // By Descartes' rule the number of crossings equals the number of sign changes among the
  // coefficients, or is two less. Zero changes mean no crossing, one change means one crossing.
  const bool begin = IsInside(b[0]);
  const bool second = IsInside(b[1]), third = IsInside(b[2]), end = IsInside(b[3]);
  const int changes = (begin != second) + (second != third) + (third != end);
  if (changes == 0)
  {
    return;
  }
  if (changes == 1)
  {
    visit(RefineCrossing(b, Real(0), Real(1)));
    return;
  }

  // Otherwise split at the turning points into monotone pieces (Marmitt et al. 2004).
  int count = 0;
  const std::array<Real, 2> turns = TurningPoints(b, count);
  Real low = Real(0);
  bool side = begin;
  for (int i = 0; i < count; ++i)
  {
    const Real high = turns[static_cast<std::size_t>(i)];
    if (IsInside(Evaluate(b, high)) != side)
    {
      if (visit(RefineCrossing(b, low, high)))
      {
        return;
      }
      side = !side;
    }
    low = high;
  }
  if (end != side)
  {
    visit(RefineCrossing(b, low, Real(1)));
  }
}

/// Smallest s in [0, 1] where the cubic changes between inside and outside; false if it does not.
template <typename Real>
bool FirstCrossing(const Cubic<Real>& b, Real& s)
{
  bool isFound = false;
  VisitCrossings(b,
    [&](Real at)
    {
      s = at;
      isFound = true;
      return true;
    });
  return isFound;
}

/// The corner of a cell whose sample is nearest to a point; x + 2 y + 4 z.
template <typename Real>
std::size_t NearestCorner(const std::array<Real, 3>& at)
{
  return static_cast<std::size_t>(at[0] >= Real(0.5)) |
    static_cast<std::size_t>(at[1] >= Real(0.5)) << 1 |
    static_cast<std::size_t>(at[2] >= Real(0.5)) << 2;
}

/// The corners of a cell whose samples become the nearest, one after the other, along a path.
struct NearestPath
{
  std::array<std::size_t, 4> Corners; ///< the first one at the beginning of the path
  std::array<double, 4> Shares;       ///< share of the path at which each becomes the nearest
  std::size_t Count;
};

/// \param midway share of the path at which it passes the middle of the cell, along each axis
template <typename Real>
NearestPath FindNearestPath(const CellPath<Real>& path, const std::array<double, 3>& midway)
{
  std::array<std::size_t, 3> order{};
  std::size_t passed = 0;
  for (std::size_t a = 0; a < 3; ++a)
  {
    const bool fromHigh = path.Begin[a] >= Real(0.5);
    if (fromHigh != (path.End[a] >= Real(0.5)))
    {
      // Insert into the ascending order of the middles that are passed.
      std::size_t at = passed++;
      for (; at > 0 && midway[order[at - 1]] > midway[a]; --at)
      {
        order[at] = order[at - 1];
      }
      order[at] = a;
    }
  }
  NearestPath nearest;
  nearest.Corners[0] = NearestCorner(path.Begin);
  nearest.Shares[0] = 0.0;
  nearest.Count = passed + 1;
  for (std::size_t i = 0; i < passed; ++i)
  {
    nearest.Corners[i + 1] = nearest.Corners[i] ^ std::size_t(1) << order[i];
    nearest.Shares[i + 1] = std::min(std::max(midway[order[i]], 0.0), 1.0);
  }
  return nearest;
}

/// Call visit(share) for each share of a path at which the value of the nearest sample changes
/// between inside and outside, ascending, until it returns true. These are the faces half way
/// between two samples.
template <typename Real, typename Visit>
void VisitNearestCrossings(
  const Corners<Real>& corners, const NearestPath& path, const Visit& visit)
{
  for (std::size_t i = 1; i < path.Count; ++i)
  {
    if (IsInside(corners[path.Corners[i]]) != IsInside(corners[path.Corners[i - 1]]) &&
      visit(path.Shares[i]))
    {
      return;
    }
  }
}

/// Find the first share at which the nearest sample's value changes sides; false if none.
template <typename Real>
bool FirstNearestCrossing(const Corners<Real>& corners, const NearestPath& path, double& s)
{
  bool isFound = false;
  VisitNearestCrossings(corners, path,
    [&](double share)
    {
      s = share;
      isFound = true;
      return true;
    });
  return isFound;
}

}

#endif
