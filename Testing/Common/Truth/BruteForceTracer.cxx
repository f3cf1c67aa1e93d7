// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Truth/BruteForceTracer.h"
#include "Checks/Infinity.h"

#include <vtkCamera.h>
#include <vtkMath.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace
{

using Point = BruteForceField::Point;

/// A distance along a ray, and the plane between cells that the ray passes there, if any.
struct Stop
{
  double T;
  int Axis = -1;
  double Plane = 0.0;

  bool operator<(const Stop& other) const { return this->T < other.T; }
};

Point Along(const Point& origin, const Point& direction, double t)
{
  return { origin[0] + t * direction[0], origin[1] + t * direction[1],
    origin[2] + t * direction[2] };
}

/// A line in index space.
struct Path
{
  Point Origin, Direction;

  Point At(double t) const { return Along(this->Origin, this->Direction, t); }

  /// The point at a stop, exactly on its plane: integer samples can make whole faces equal the
  /// isovalue, and a point beside such a face by rounding would not see it.
  Point At(const Stop& stop) const
  {
    Point point = this->At(stop.T);
    if (stop.Axis >= 0)
    {
      point[static_cast<std::size_t>(stop.Axis)] = stop.Plane;
    }
    return point;
  }

  Point Between(const Stop& a, const Stop& b) const { return this->At(0.5 * (a.T + b.T)); }
};

/// Clip a path to the box of the field.
/// \return false if nothing is left
bool Clip(const BruteForceField& field, const Path& path, Stop& first, Stop& last)
{
  for (std::size_t a = 0; a < 3; ++a)
  {
    const double highest = field.Planes(a).back();
    const double origin = path.Origin[a], step = path.Direction[a];
    if (step == 0.0)
    {
      if (origin < 0.0 || origin > highest)
      {
        return false;
      }
      continue;
    }
    const double from = step > 0.0 ? 0.0 : highest, to = step > 0.0 ? highest : 0.0;
    const double enter = (from - origin) / step, leave = (to - origin) / step;
    if (enter > first.T)
    {
      first = { enter, static_cast<int>(a), from };
    }
    if (leave < last.T)
    {
      last = { leave, static_cast<int>(a), to };
    }
  }
  return first.T < last.T;
}

/// Both ends, and all planes between them on which the field along the path stops being one
/// polynomial.
std::vector<Stop> FindStops(
  const BruteForceField& field, const Path& path, const Stop& first, const Stop& last)
{
  std::vector<Stop> stops = { first, last };
  for (std::size_t a = 0; a < 3; ++a)
  {
    const std::vector<double>& planes = field.Planes(a);
    const auto stopAt = [&](double plane)
    {
      const double t = (plane - path.Origin[a]) / path.Direction[a];
      if (t > first.T && t < last.T)
      {
        stops.push_back({ t, static_cast<int>(a), plane });
      }
    };
    for (std::size_t i = 0; i < planes.size() && path.Direction[a] != 0.0; ++i)
    {
      stopAt(planes[i]);
      if (field.IsNearest() && i + 1 < planes.size())
      {
        stopAt(0.5 * (planes[i] + planes[i + 1]));
      }
    }
  }
  std::sort(stops.begin(), stops.end());
  return stops;
}

/// Where a cubic, given by its values at 0, 1, 2 and 3, turns; and 3, its end. Ascending.
std::vector<double> TurningPoints(std::array<double, 4> v)
{
  // Times a number: squares of huge values are infinite, those of tiny ones 0.
  const double largest = std::abs(*std::max_element(
    v.begin(), v.end(), [](double x, double y) { return std::abs(x) < std::abs(y); }));
  if (std::isnormal(largest))
  {
    const int exponent = std::ilogb(largest);
    for (double& value : v)
    {
      value = std::ldexp(value, -exponent);
    }
  }
  const double d1 = v[1] - v[0], d2 = v[2] - 2 * v[1] + v[0],
               d3 = v[3] - 3 * v[2] + 3 * v[1] - v[0];
  // v(u) = v0 + d1 u + d2 u (u - 1) / 2 + d3 u (u - 1) (u - 2) / 6, u in [0, 3]
  const double a = d3 / 2, b = d2 - d3, c = d1 - d2 / 2 + d3 / 3;
  std::vector<double> points = { 3.0 };
  const double discriminant = b * b - 4 * a * c;
  if (discriminant > 0.0)
  {
    // Without cancellation: the cubic may be all but quadratic.
    const double q = -0.5 * (b + std::copysign(std::sqrt(discriminant), b));
    if (a != 0.0)
    {
      points.push_back(q / a);
    }
    if (q != 0.0)
    {
      points.push_back(c / q);
    }
  }
  std::sort(points.begin(), points.end());
  return points;
}

/// First crossing of an isovalue between two stops, between which the field is one cubic.
double FirstCrossing(const BruteForceField& field, const Path& path, const Stop& begin,
  const Stop& end, double isovalue)
{
  // A crossing of a cubic may hide between two of any finite number of samples; its turning points
  // give it away. They come from the derivative of the cubic through four values.
  const double h = (end.T - begin.T) / 3.0;
  const auto valueAt = [&](double t) { return field.DifferenceAt(path.At(t), isovalue); };
  const std::array<double, 4> v = { field.DifferenceAt(path.At(begin), isovalue),
    valueAt(begin.T + h), valueAt(begin.T + 2.0 * h), field.DifferenceAt(path.At(end), isovalue) };
  const bool inside = v[0] >= 0.0;
  double low = begin.T;
  for (const double point : TurningPoints(v))
  {
    if (point <= 0.0 || point > 3.0)
    {
      continue;
    }
    double high = point == 3.0 ? end.T : begin.T + point * h;
    const double value = point == 3.0 ? v[3] : valueAt(high);
    if ((value >= 0.0) != inside)
    {
      for (int step = 0; step < 60; ++step)
      {
        const double middle = 0.5 * (low + high);
        ((valueAt(middle) >= 0.0) == inside ? low : high) = middle;
      }
      return 0.5 * (low + high);
    }
    low = high;
  }
  return Infinity;
}

/// A surface on a path: t, and its position in the list.
struct Found
{
  double T = Infinity;
  int Isovalue = -1;
};

/// The first surface between two stops, between which the field is one cubic.
Found FirstCrossing(const BruteForceField& field, const Path& path, const Stop& begin,
  const Stop& end, const std::vector<double>& isovalues)
{
  Found first;
  for (std::size_t i = 0; i < isovalues.size(); ++i)
  {
    const double t = FirstCrossing(field, path, begin, end, isovalues[i]);
    if (t < first.T)
    {
      first = { t, static_cast<int>(i) };
    }
  }
  return first;
}

/// The first surface that a jump of the field passes. Upwards it passes all values between from the
/// lowest, downwards from the highest.
Found FirstInJump(const BruteForceField& field, const Point& before, const Point& here, double t,
  const std::vector<double>& isovalues)
{
  Found first;
  for (std::size_t i = 0; i < isovalues.size(); ++i)
  {
    const bool isInside = field.DifferenceAt(here, isovalues[i]) >= 0.0;
    const bool wasInside = field.DifferenceAt(before, isovalues[i]) >= 0.0;
    if (isInside != wasInside &&
      (first.Isovalue < 0 ||
        isInside == (isovalues[i] < isovalues[static_cast<std::size_t>(first.Isovalue)])))
    {
      first = { t, static_cast<int>(i) };
    }
  }
  return first;
}

/// The highest isovalue that the field reaches at a point; -1 if there is none.
int HighestInside(
  const BruteForceField& field, const Point& index, const std::vector<double>& isovalues)
{
  int highest = -1;
  for (std::size_t i = 0; i < isovalues.size(); ++i)
  {
    if (field.DifferenceAt(index, isovalues[i]) >= 0.0 &&
      (highest < 0 || isovalues[i] > isovalues[static_cast<std::size_t>(highest)]))
    {
      highest = static_cast<int>(i);
    }
  }
  return highest;
}

}

BruteForceTracer::BruteForceTracer(
  vtkImageData* image, vtkVolume* volume, int component, vtkDataArray* cells)
  : Field(image, volume, component, cells)
{
}

BruteForceTracer::BruteForceTracer(
  vtkRectilinearGrid* grid, vtkVolume* volume, int component, vtkDataArray* cells)
  : Field(grid, volume, component, cells)
{
}

BruteForceTracer::Line BruteForceTracer::LineThrough(
  vtkRenderer* renderer, int x, int y, int width, int height)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  vtkMatrix4x4* projection =
    camera->GetCompositeProjectionTransformMatrix(static_cast<double>(width) / height, -1.0, 1.0);
  vtkNew<vtkMatrix4x4> back;
  vtkMatrix4x4::Invert(projection, back);
  std::array<Point, 2> ends;
  for (std::size_t e = 0; e < 2; ++e)
  {
    double p[4] = { 2.0 * (x + 0.5) / width - 1.0, 2.0 * (y + 0.5) / height - 1.0,
      e == 0 ? -1.0 : 1.0, 1.0 };
    back->MultiplyPoint(p, p);
    ends[e] = { p[0] / p[3], p[1] / p[3], p[2] / p[3] };
  }
  Point eye, direction, forward;
  camera->GetPosition(eye.data());
  camera->GetDirectionOfProjection(forward.data());
  vtkMath::Subtract(ends[1].data(), ends[0].data(), direction.data());
  const double length = vtkMath::Normalize(direction.data());
  // Distances count from the eye, or from the plane through a parallel camera.
  Point toNear;
  vtkMath::Subtract(ends[0].data(), eye.data(), toNear.data());
  const double toBegin = camera->GetParallelProjection()
    ? vtkMath::Dot(toNear.data(), forward.data()) / vtkMath::Dot(direction.data(), forward.data())
    : vtkMath::Norm(toNear.data());
  return { Along(ends[0], direction, -toBegin), direction, toBegin, toBegin + length };
}

BruteForceTracer::Hit BruteForceTracer::Trace(
  vtkRenderer* renderer, int x, int y, int width, int height) const
{
  return this->Trace(LineThrough(renderer, x, y, width, height));
}

BruteForceTracer::Hit BruteForceTracer::Trace(const Line& line) const
{
  const Hit miss{ Infinity, -1, {} };
  const auto hitAt = [&](const Found& found) {
    return Hit{ found.T, found.Isovalue, Along(line.Origin, line.Direction, found.T) };
  };
  const Path path{ this->Field.IndexOf(line.Origin), this->Field.IndexDirectionOf(line.Direction) };
  Stop first{ line.Begin }, last{ line.End };
  if (!Clip(this->Field, path, first, last))
  {
    return miss;
  }
  const std::vector<Stop> stops = FindStops(this->Field, path, first, last);
  bool isCutOpen = true; // where the ray begins, and behind hidden cells
  bool isFirst = true;   // of the intervals that are not empty
  Point before{};        // midway in the interval before
  for (std::size_t i = 0; i + 1 < stops.size(); ++i)
  {
    // What a ray touches in a point hides nothing and shows nothing.
    if (this->Field.HasHidden() && !(stops[i].T < stops[i + 1].T))
    {
      continue;
    }
    const Point here = path.Between(stops[i], stops[i + 1]);
    const Point previous = std::exchange(before, here);
    const bool hasPrevious = !std::exchange(isFirst, false);
    if (this->Field.IsHidden(here))
    {
      isCutOpen = true;
      continue;
    }
    const bool isCap = std::exchange(isCutOpen, false) && this->IsThreshold;
    const int highest = isCap ? HighestInside(this->Field, path.At(stops[i]), this->Isovalues) : -1;
    if (highest >= 0)
    {
      return hitAt({ stops[i].T, highest });
    }
    Found found;
    if (!this->Field.IsNearest())
    {
      found = FirstCrossing(this->Field, path, stops[i], stops[i + 1], this->Isovalues);
    }
    else if (hasPrevious)
    {
      found = FirstInJump(this->Field, previous, here, stops[i].T, this->Isovalues);
    }
    if (found.Isovalue >= 0)
    {
      return hitAt(found);
    }
  }
  return miss;
}
