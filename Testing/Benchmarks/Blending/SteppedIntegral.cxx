// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SteppedIntegral.h"

#include <vtkCamera.h>
#include <vtkDataArray.h>
#include <vtkMatrix4x4.h>
#include <vtkPointData.h>
#include <vtkVolumeProperty.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace
{

/// Where less light passes, nothing is seen of what follows.
constexpr double LeastPassed = 1e-7;

/// The colour and opacity of a value by straight lines between the points of a look.
std::array<double, 4> ColorOf(const BlendLooks::Look& look, double value)
{
  const std::vector<BlendLooks::Point>& points = look.Points;
  std::size_t next = 1;
  while (next + 1 < points.size() && points[next].Value <= value)
  {
    ++next;
  }
  const BlendLooks::Point &before = points[next - 1], &behind = points[next];
  const double share = std::clamp((value - before.Value) / (behind.Value - before.Value), 0.0, 1.0);
  std::array<double, 4> color;
  for (std::size_t c = 0; c < 4; ++c)
  {
    color[c] = before.Color[c] + share * (behind.Color[c] - before.Color[c]);
  }
  return color;
}

double Mix(double a, double b, double share)
{
  return a + share * (b - a);
}

/// The light that has come from a ray, in units of 1/255, and the share that passes of what
/// follows.
struct Light
{
  std::array<double, 3> Color{};
  double Passed = 1.0;

  /// \param length in units of the opacity's distance
  void Add(const std::array<double, 4>& color, double length)
  {
    const double left = this->Passed * std::pow(1.0 - color[3], length);
    for (std::size_t c = 0; c < 3; ++c)
    {
      this->Color[c] += 255.0 * (this->Passed - left) * color[c];
    }
    this->Passed = left;
  }
};

/// Add a step along which the value changes evenly. It is cut at each point of the look that it
/// passes, so that no jump is stepped over.
void AddStep(const BlendLooks::Look& look, double begin, double end, double length, Light& light)
{
  const std::size_t count = look.Points.size();
  double from = begin;
  const auto addUpTo = [&](double to)
  {
    const double share = begin == end ? 1.0 : (to - from) / (end - begin);
    light.Add(ColorOf(look, 0.5 * (from + to)), share * length);
    from = to;
  };
  for (std::size_t i = 0; i < count; ++i)
  {
    const double value = look.Points[begin < end ? i : count - 1 - i].Value;
    if (value > std::min(begin, end) && value < std::max(begin, end))
    {
      addUpTo(value);
    }
  }
  addUpTo(end);
}

}

SteppedIntegral::SteppedIntegral(const Stage& stage)
  : Of(stage)
{
  stage.Image->GetDimensions(this->Dimensions.data());
  vtkDataArray* scalars = stage.Image->GetPointData()->GetScalars();
  this->Values.resize(static_cast<std::size_t>(scalars->GetNumberOfTuples()));
  for (std::size_t i = 0; i < this->Values.size(); ++i)
  {
    this->Values[i] = scalars->GetComponent(static_cast<vtkIdType>(i), 0);
  }
  // As of a picture whose width is its height.
  vtkNew<vtkMatrix4x4> matrix;
  matrix->DeepCopy(
    stage.Renderer->GetActiveCamera()->GetCompositeProjectionTransformMatrix(1.0, -1.0, 1.0));
  matrix->Invert();
  std::copy_n(matrix->GetData(), 16, this->FromPicture.begin());
}

/// \param x,y   from the lower left corner of the picture, in pixels
/// \param depth -1 at the near plane, 1 at the far plane
SteppedIntegral::Point SteppedIntegral::WorldAt(double x, double y, double depth) const
{
  const double size = this->Of.Size;
  const std::array<double, 4> from{ 2.0 * x / size - 1.0, 2.0 * y / size - 1.0, depth, 1.0 };
  std::array<double, 4> to{};
  for (std::size_t row = 0; row < 4; ++row)
  {
    for (std::size_t column = 0; column < 4; ++column)
    {
      to[row] += this->FromPicture[4 * row + column] * from[column];
    }
  }
  return { to[0] / to[3], to[1] / to[3], to[2] / to[3] };
}

/// \return false if the ray passes beside the volume
bool SteppedIntegral::FindLine(int x, int y, Line& line) const
{
  const Point near = this->WorldAt(x + 0.5, y + 0.5, -1.0);
  const Point far = this->WorldAt(x + 0.5, y + 0.5, 1.0);
  const double *origin = this->Of.Image->GetOrigin(), *spacing = this->Of.Image->GetSpacing();
  const int* extent = this->Of.Image->GetExtent();
  Point from, way;
  double begin = 0.0, end = 1.0, length = 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    from[axis] = (near[axis] - origin[axis]) / spacing[axis] - extent[2 * axis];
    way[axis] = (far[axis] - near[axis]) / spacing[axis];
    const double low = -from[axis] / way[axis];
    const double high = (this->Dimensions[axis] - 1 - from[axis]) / way[axis];
    begin = std::max(begin, std::min(low, high));
    end = std::min(end, std::max(low, high));
    length += (far[axis] - near[axis]) * (far[axis] - near[axis]);
  }
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    line.Begin[axis] = from[axis] + begin * way[axis];
    line.End[axis] = from[axis] + end * way[axis];
  }
  line.Length = (end - begin) * std::sqrt(length);
  return begin < end;
}

/// Trilinear between samples.
double SteppedIntegral::ValueAt(const Point& index) const
{
  std::array<std::size_t, 3> first;
  Point share;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double cell = std::clamp(std::floor(index[axis]), 0.0, this->Dimensions[axis] - 2.0);
    first[axis] = static_cast<std::size_t>(cell);
    share[axis] = index[axis] - cell;
  }
  const auto alongY = static_cast<std::size_t>(this->Dimensions[0]);
  const std::size_t alongZ = alongY * static_cast<std::size_t>(this->Dimensions[1]);
  const double* corner = &this->Values[first[0] + first[1] * alongY + first[2] * alongZ];
  const auto edge = [&](std::size_t at) { return Mix(corner[at], corner[at + 1], share[0]); };
  return Mix(Mix(edge(0), edge(alongY), share[1]),
    Mix(edge(alongZ), edge(alongZ + alongY), share[1]), share[2]);
}

std::array<double, 3> SteppedIntegral::ColorAt(int x, int y, const BlendLooks::Look& look) const
{
  Line line;
  Light light;
  if (!this->FindLine(x, y, line))
  {
    return light.Color;
  }
  const double unit = this->Of.Volume->GetProperty()->GetScalarOpacityUnitDistance();
  double begin = this->ValueAt(line.Begin);
  for (int step = 1; step <= Steps && light.Passed > LeastPassed; ++step)
  {
    const double share = static_cast<double>(step) / Steps;
    const double end = this->ValueAt({ Mix(line.Begin[0], line.End[0], share),
      Mix(line.Begin[1], line.End[1], share), Mix(line.Begin[2], line.End[2], share) });
    AddStep(look, begin, end, line.Length / Steps / unit, light);
    begin = end;
  }
  return light.Color;
}
