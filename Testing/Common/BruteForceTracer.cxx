// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BruteForceTracer.h"

#include <vtkCamera.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDataSetAttributes.h>
#include <vtkImageData.h>
#include <vtkMath.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkRectilinearGrid.h>
#include <vtkRenderer.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace
{

using Point = std::array<double, 3>;

Point Transform(const std::array<double, 16>& m, const Point& p, double w)
{
  Point result;
  for (std::size_t row = 0; row < 3; ++row)
  {
    result[row] =
      m[4 * row] * p[0] + m[4 * row + 1] * p[1] + m[4 * row + 2] * p[2] + m[4 * row + 3] * w;
  }
  return result;
}

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

/// The point at a stop, exactly on its plane: integer samples can make whole faces equal the
/// isovalue, and a point beside such a face by rounding would not see it.
Point At(const Point& origin, const Point& direction, const Stop& stop)
{
  Point point = Along(origin, direction, stop.T);
  if (stop.Axis >= 0)
  {
    point[static_cast<std::size_t>(stop.Axis)] = stop.Plane;
  }
  return point;
}

std::array<double, 16> Elements(vtkMatrix4x4* matrix)
{
  std::array<double, 16> elements;
  std::copy_n(matrix->GetData(), 16, elements.begin());
  return elements;
}

}

BruteForceTracer::BruteForceTracer(
  vtkImageData* image, vtkVolume* volume, int component, vtkDataArray* cells)
{
  image->GetDimensions(this->Dimensions.data());
  this->FindHidden(image, cells != nullptr);
  this->SetSamples(cells ? cells : image->GetPointData()->GetScalars(), component, cells);
  this->IsNearest = volume->GetProperty()->GetInterpolationType() == VTK_NEAREST_INTERPOLATION;
  for (std::size_t a = 0; a < 3; ++a)
  {
    for (int i = 0; i < this->Dimensions[a]; ++i)
    {
      this->Planes[a].push_back(i);
    }
  }

  // Corner by corner, so that no matrix of ours is trusted.
  const int* extent = image->GetExtent();
  vtkNew<vtkMatrix4x4> world;
  vtkNew<vtkMatrix4x4> toVolume;
  double corner[4][3];
  for (int c = 0; c < 4; ++c)
  {
    const int ijk[3] = { extent[0] + (c == 1), extent[2] + (c == 2), extent[4] + (c == 3) };
    image->TransformIndexToPhysicalPoint(ijk, corner[c]);
  }
  if (cells)
  {
    // The first sample lies half a step along every axis from the first corner.
    double centre[3];
    const double first[3] = { extent[0] + 0.5, extent[2] + 0.5, extent[4] + 0.5 };
    image->TransformContinuousIndexToPhysicalPoint(first, centre);
    for (int row = 0; row < 3; ++row)
    {
      const double shift = centre[row] - corner[0][row];
      for (auto& point : corner)
      {
        point[row] += shift;
      }
    }
  }
  for (int row = 0; row < 3; ++row)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      toVolume->SetElement(row, axis, corner[axis + 1][row] - corner[0][row]);
    }
    toVolume->SetElement(row, 3, corner[0][row]);
  }
  volume->ComputeMatrix();
  vtkMatrix4x4::Multiply4x4(volume->GetMatrix(), toVolume, world);
  this->SetPlacement(world);
}

BruteForceTracer::BruteForceTracer(
  vtkRectilinearGrid* grid, vtkVolume* volume, int component, vtkDataArray* cells)
{
  grid->GetDimensions(this->Dimensions.data());
  this->FindHidden(grid, cells != nullptr);
  this->SetSamples(cells ? cells : grid->GetPointData()->GetScalars(), component, cells);
  this->IsNearest = volume->GetProperty()->GetInterpolationType() == VTK_NEAREST_INTERPOLATION;
  vtkDataArray* coordinates[3] = { grid->GetXCoordinates(), grid->GetYCoordinates(),
    grid->GetZCoordinates() };
  vtkNew<vtkMatrix4x4> toVolume;
  vtkNew<vtkMatrix4x4> world;
  for (std::size_t a = 0; a < 3; ++a)
  {
    // From the first plane on: far from the origin small distances would drown.
    std::vector<double>& planes = this->Planes[a];
    for (vtkIdType i = 0; i < this->Dimensions[a]; ++i)
    {
      const double here = coordinates[a]->GetTuple1(i);
      planes.push_back(cells ? 0.5 * (here + coordinates[a]->GetTuple1(i + 1)) : here);
    }
    this->IsDescending[a] = planes.front() > planes.back();
    std::sort(planes.begin(), planes.end());
    const double origin = planes.front();
    toVolume->SetElement(static_cast<int>(a), 3, origin);
    for (double& plane : planes)
    {
      plane -= origin;
    }
  }
  volume->ComputeMatrix();
  vtkMatrix4x4::Multiply4x4(volume->GetMatrix(), toVolume, world);
  this->SetPlacement(world);
}

void BruteForceTracer::SetSamples(vtkDataArray* array, int component, bool onCells)
{
  for (int& samples : this->Dimensions)
  {
    samples -= onCells;
  }
  double largest = 0.0;
  this->Samples.resize(static_cast<std::size_t>(this->Dimensions[0]) *
    static_cast<std::size_t>(this->Dimensions[1]) * static_cast<std::size_t>(this->Dimensions[2]));
  for (std::size_t i = 0; i < this->Samples.size(); ++i)
  {
    const double value = array->GetComponent(static_cast<vtkIdType>(i), component);
    this->Samples[i] = value;
    largest = std::isfinite(value) ? std::max(largest, std::abs(value)) : largest;
  }
  // Not a number: below every isovalue.
  for (double& value : this->Samples)
  {
    value = std::isnan(value) ? -3.0 * largest - 1.0 : value;
  }
}

void BruteForceTracer::SetPlacement(vtkMatrix4x4* world)
{
  this->WorldFromIndex = Elements(world);
  this->Voxel = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis)
  {
    const std::vector<double>& planes = this->Planes[static_cast<std::size_t>(axis)];
    const double unit = std::hypot(
      world->GetElement(0, axis), world->GetElement(1, axis), world->GetElement(2, axis));
    for (std::size_t i = 1; i < planes.size(); ++i)
    {
      this->Voxel = std::min(this->Voxel, unit * (planes[i] - planes[i - 1]));
    }
  }
  vtkNew<vtkMatrix4x4> back;
  vtkMatrix4x4::Invert(world, back);
  this->IndexFromWorld = Elements(back);
}

/// The cell that a coordinate lies in, or the nearest one.
int BruteForceTracer::CellOf(std::size_t axis, double at) const
{
  const std::vector<double>& planes = this->Planes[axis];
  const auto above = std::upper_bound(planes.begin(), planes.end(), at);
  return std::clamp(static_cast<int>(above - planes.begin()) - 1, 0, this->Dimensions[axis] - 2);
}

void BruteForceTracer::FindHidden(vtkDataSet* data, bool areSamplesCells)
{
  using Attributes = vtkDataSetAttributes;
  vtkDataArray* ofCells = data->GetCellData()->GetArray(Attributes::GhostArrayName());
  vtkDataArray* ofPoints = data->GetPointData()->GetArray(Attributes::GhostArrayName());
  if (!ofCells && !ofPoints)
  {
    return;
  }
  vtkIdType cell = 0;
  for (int k = 0; k < this->Dimensions[2] - 1; ++k)
  {
    for (int j = 0; j < this->Dimensions[1] - 1; ++j)
    {
      for (int i = 0; i < this->Dimensions[0] - 1; ++i, ++cell)
      {
        const int flag = ofCells ? static_cast<int>(ofCells->GetComponent(cell, 0)) : 0;
        const int notOfThisPiece = areSamplesCells ? 0 : Attributes::DUPLICATECELL;
        bool isHidden =
          (flag & (Attributes::HIDDENCELL | Attributes::REFINEDCELL | notOfThisPiece)) != 0;
        for (int corner = 0; corner < 8 && ofPoints; ++corner)
        {
          const vtkIdType row = (k + (corner >> 2)) * this->Dimensions[1] + j + (corner >> 1 & 1);
          const vtkIdType point = row * this->Dimensions[0] + i + (corner & 1);
          const int flagOfPoint = static_cast<int>(ofPoints->GetComponent(point, 0));
          isHidden = isHidden || (flagOfPoint & Attributes::HIDDENPOINT) != 0;
        }
        this->Hidden.push_back(isHidden);
      }
    }
  }
  if (areSamplesCells)
  {
    this->HideAroundSamples();
  }
}

/// From hidden samples, the cells of the image, to the cells between them.
void BruteForceTracer::HideAroundSamples()
{
  const std::vector<bool> samples = this->Hidden;
  const int nx = this->Dimensions[0] - 1, ny = this->Dimensions[1] - 1;
  this->Hidden.clear();
  for (int k = 0; k < this->Dimensions[2] - 2; ++k)
  {
    for (int j = 0; j < ny - 1; ++j)
    {
      for (int i = 0; i < nx - 1; ++i)
      {
        bool isHidden = false;
        for (int corner = 0; corner < 8; ++corner)
        {
          const int row = (k + (corner >> 2)) * ny + j + (corner >> 1 & 1);
          isHidden = isHidden || samples[static_cast<std::size_t>(row * nx + i + (corner & 1))];
        }
        this->Hidden.push_back(isHidden);
      }
    }
  }
}

/// True if a point is in a hidden cell.
bool BruteForceTracer::IsHidden(const Point& index) const
{
  if (this->Hidden.empty())
  {
    return false;
  }
  std::array<int, 3> cell;
  for (std::size_t a = 0; a < 3; ++a)
  {
    cell[a] = this->CellOf(a, index[a]);
    cell[a] = this->IsDescending[a] ? this->Dimensions[a] - 2 - cell[a] : cell[a];
  }
  return this->Hidden[static_cast<std::size_t>(
    (cell[2] * (this->Dimensions[1] - 1) + cell[1]) * (this->Dimensions[0] - 1) + cell[0])];
}

/// The highest isovalue that the field reaches at a point; -1 if there is none.
int BruteForceTracer::HighestInside(const Point& index) const
{
  int highest = -1;
  for (std::size_t i = 0; i < this->Isovalues.size(); ++i)
  {
    if (this->DifferenceAt(index, this->Isovalues[i]) >= 0.0 &&
      (highest < 0 || this->Isovalues[i] > this->Isovalues[static_cast<std::size_t>(highest)]))
    {
      highest = static_cast<int>(i);
    }
  }
  return highest;
}

double BruteForceTracer::Sample(int i, int j, int k) const
{
  i = this->IsDescending[0] ? this->Dimensions[0] - 1 - i : i;
  j = this->IsDescending[1] ? this->Dimensions[1] - 1 - j : j;
  k = this->IsDescending[2] ? this->Dimensions[2] - 1 - k : k;
  const auto nx = static_cast<std::size_t>(this->Dimensions[0]);
  const auto ny = static_cast<std::size_t>(this->Dimensions[1]);
  return this->Samples[(static_cast<std::size_t>(k) * ny + static_cast<std::size_t>(j)) * nx +
    static_cast<std::size_t>(i)];
}

double BruteForceTracer::DifferenceAt(const Point& index, double isovalue) const
{
  std::array<int, 3> cell;
  Point f;
  for (std::size_t a = 0; a < 3; ++a)
  {
    cell[a] = this->CellOf(a, index[a]);
    const double* plane = &this->Planes[a][static_cast<std::size_t>(cell[a])];
    f[a] = std::clamp((index[a] - plane[0]) / (plane[1] - plane[0]), 0.0, 1.0);
    f[a] = this->IsNearest ? std::floor(f[a] + 0.5) : f[a];
  }
  double sum = 0.0;
  for (int corner = 0; corner < 8; ++corner)
  {
    const int x = corner & 1, y = corner >> 1 & 1, z = corner >> 2;
    const double weight =
      (x ? f[0] : 1.0 - f[0]) * (y ? f[1] : 1.0 - f[1]) * (z ? f[2] : 1.0 - f[2]);
    // Differences first: where samples equal the isovalue, so does the field, to the last bit.
    const double sample = this->Sample(cell[0] + x, cell[1] + y, cell[2] + z);
    sum += weight > 0.0 ? weight * (sample - isovalue) : 0.0;
  }
  return sum;
}

Point BruteForceTracer::WorldNormalAt(const Point& world) const
{
  const Point index = Transform(this->IndexFromWorld, world, 1.0);
  std::array<int, 3> cell;
  Point f;
  for (std::size_t a = 0; a < 3; ++a)
  {
    cell[a] = this->CellOf(a, index[a]);
    const double* plane = &this->Planes[a][static_cast<std::size_t>(cell[a])];
    f[a] = std::clamp((index[a] - plane[0]) / (plane[1] - plane[0]), 0.0, 1.0);
  }
  Point gradient{};
  for (std::size_t corner = 0; corner < 8; ++corner)
  {
    double weight = 1.0;
    std::array<int, 3> at;
    for (std::size_t a = 0; a < 3; ++a)
    {
      const int isHigh = static_cast<int>(corner >> a & 1u);
      at[a] = cell[a] + isHigh;
      weight *= isHigh ? f[a] : 1.0 - f[a];
    }
    for (std::size_t a = 0; a < 3; ++a)
    {
      std::array<int, 3> low = at, high = at;
      low[a] = std::max(at[a] - 1, 0);
      high[a] = std::min(at[a] + 1, this->Dimensions[a] - 1);
      const double distance = this->Planes[a][static_cast<std::size_t>(high[a])] -
        this->Planes[a][static_cast<std::size_t>(low[a])];
      const double difference =
        this->Sample(high[0], high[1], high[2]) - this->Sample(low[0], low[1], low[2]);
      gradient[a] += weight * difference / distance;
    }
  }
  // Gradients go with the transposed inverse.
  Point normal{};
  for (std::size_t column = 0; column < 3; ++column)
  {
    for (std::size_t row = 0; row < 3; ++row)
    {
      normal[column] += this->IndexFromWorld[4 * row + column] * gradient[row];
    }
  }
  vtkMath::Normalize(normal.data());
  return normal;
}

/// First crossing within an interval in which the field along the ray is one cubic (or constant).
bool BruteForceTracer::CrossesIn(const Point& origin, const Point& direction, double begin,
  double end, double atBegin, double atEnd, double isovalue, double& t) const
{
  // A crossing of a cubic may hide between two of any finite number of samples; its turning points
  // give it away. They come from the derivative of the cubic through four values.
  const double h = (end - begin) / 3.0;
  std::array<double, 4> v = { atBegin, 0.0, 0.0, atEnd };
  for (std::size_t i = 1; i < 3; ++i)
  {
    v[i] =
      this->DifferenceAt(Along(origin, direction, begin + static_cast<double>(i) * h), isovalue);
  }
  const double d1 = v[1] - v[0], d2 = v[2] - 2 * v[1] + v[0],
               d3 = v[3] - 3 * v[2] + 3 * v[1] - v[0];
  // v(u) = v0 + d1 u + d2 u (u - 1) / 2 + d3 u (u - 1) (u - 2) / 6, u in [0, 3]
  const double a = d3 / 2, b = d2 - d3, c = d1 - d2 / 2 + d3 / 3;
  std::vector<double> stops = { 0.0 };
  const double discriminant = b * b - 4 * a * c;
  if (discriminant > 0.0)
  {
    // Without cancellation: the cubic may be all but quadratic.
    const double q = -0.5 * (b + std::copysign(std::sqrt(discriminant), b));
    if (a != 0.0)
    {
      stops.push_back(q / a);
    }
    if (q != 0.0)
    {
      stops.push_back(c / q);
    }
  }
  stops.push_back(3.0);
  std::sort(stops.begin(), stops.end());

  const bool inside = v[0] >= 0.0;
  double low = begin;
  for (const double stop : stops)
  {
    if (stop <= 0.0 || stop > 3.0)
    {
      continue;
    }
    double high = stop == 3.0 ? end : begin + stop * h;
    const double value =
      stop == 3.0 ? v[3] : this->DifferenceAt(Along(origin, direction, high), isovalue);
    if ((value >= 0.0) != inside)
    {
      for (int step = 0; step < 60; ++step)
      {
        const double middle = 0.5 * (low + high);
        const double at = this->DifferenceAt(Along(origin, direction, middle), isovalue);
        ((at >= 0.0) == inside ? low : high) = middle;
      }
      t = 0.5 * (low + high);
      return true;
    }
    low = high;
  }
  return false;
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

Point BruteForceTracer::IndexOf(const Point& world) const
{
  return Transform(this->IndexFromWorld, world, 1.0);
}

BruteForceTracer::Hit BruteForceTracer::Trace(const Line& line) const
{
  const Hit miss{ std::numeric_limits<double>::infinity(), -1, {} };
  const Point origin = Transform(this->IndexFromWorld, line.Origin, 1.0);
  const Point step = Transform(this->IndexFromWorld, line.Direction, 0.0);
  double begin = line.Begin, end = line.End;
  int firstAxis = -1, lastAxis = -1;
  double firstPlane = 0.0, lastPlane = 0.0;
  for (std::size_t a = 0; a < 3; ++a)
  {
    const double last = this->Planes[a].back();
    if (step[a] == 0.0)
    {
      if (origin[a] < 0.0 || origin[a] > last)
      {
        return miss;
      }
      continue;
    }
    const bool isForward = step[a] > 0.0;
    const double enter = ((isForward ? 0.0 : last) - origin[a]) / step[a];
    const double leave = ((isForward ? last : 0.0) - origin[a]) / step[a];
    if (enter > begin)
    {
      begin = enter;
      firstAxis = static_cast<int>(a);
      firstPlane = isForward ? 0.0 : last;
    }
    if (leave < end)
    {
      end = leave;
      lastAxis = static_cast<int>(a);
      lastPlane = isForward ? last : 0.0;
    }
  }
  if (!(begin < end))
  {
    return miss;
  }

  const Stop first{ begin, firstAxis, firstPlane };
  const auto hitAt = [&](double t, int isovalue) {
    return Hit{ t, isovalue, Along(line.Origin, line.Direction, t) };
  };

  // All planes on which the field along the ray stops being one polynomial.
  std::vector<Stop> stops = { first, { end, lastAxis, lastPlane } };
  for (std::size_t a = 0; a < 3; ++a)
  {
    const std::vector<double>& planes = this->Planes[a];
    const auto stopAt = [&](double plane)
    {
      const double t = (plane - origin[a]) / step[a];
      if (t > begin && t < end)
      {
        stops.push_back({ t, static_cast<int>(a), plane });
      }
    };
    for (std::size_t i = 0; i < planes.size() && step[a] != 0.0; ++i)
    {
      stopAt(planes[i]);
      if (this->IsNearest && i + 1 < planes.size())
      {
        stopAt(0.5 * (planes[i] + planes[i + 1]));
      }
    }
  }
  std::sort(stops.begin(), stops.end());
  const auto midway = [&](std::size_t i)
  { return Along(origin, step, 0.5 * (stops[i].T + stops[i + 1].T)); };
  bool isCutOpen = true; // where the ray begins, and behind hidden cells
  const std::size_t none = stops.size();
  std::size_t last = none; // interval before
  for (std::size_t i = 0; i + 1 < stops.size(); ++i)
  {
    // What a ray touches in a point hides nothing and shows nothing.
    if (!this->Hidden.empty() && !(stops[i].T < stops[i + 1].T))
    {
      continue;
    }
    const std::size_t previous = std::exchange(last, i);
    if (this->IsHidden(midway(i)))
    {
      isCutOpen = true;
      continue;
    }
    const bool isCap = std::exchange(isCutOpen, false) && this->IsThreshold;
    const int highest = isCap ? this->HighestInside(At(origin, step, stops[i])) : -1;
    if (highest >= 0)
    {
      return hitAt(stops[i].T, highest);
    }
    double nearest = std::numeric_limits<double>::infinity();
    int surface = -1;
    for (std::size_t s = 0; s < this->Isovalues.size(); ++s)
    {
      double t;
      bool found, isFirst = false;
      if (this->IsNearest)
      {
        // Constant within the interval: compare with the interval before.
        const double value = this->Isovalues[s];
        const double here = this->DifferenceAt(midway(i), value);
        const double before = previous == none ? here : this->DifferenceAt(midway(previous), value);
        found = (here >= 0.0) != (before >= 0.0);
        t = stops[i].T;
        // A jump passes all values between, upwards from the lowest, downwards from the highest.
        isFirst = surface >= 0 && t == nearest &&
          (here >= 0.0) == (value < this->Isovalues[static_cast<std::size_t>(surface)]);
      }
      else
      {
        const double value = this->Isovalues[s];
        found = this->CrossesIn(origin, step, stops[i].T, stops[i + 1].T,
          this->DifferenceAt(At(origin, step, stops[i]), value),
          this->DifferenceAt(At(origin, step, stops[i + 1]), value), value, t);
      }
      if (found && (t < nearest || isFirst))
      {
        nearest = t;
        surface = static_cast<int>(s);
      }
    }
    if (surface >= 0)
    {
      return hitAt(nearest, surface);
    }
  }
  return miss;
}
