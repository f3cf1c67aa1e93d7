// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Integral/BlendTruthField.h"

#include "Scene/HiddenCells.h"

#include <algorithm>
#include <cmath>

using namespace TemporalCoherence;

namespace
{

/// The eight corners of a cell: x fastest.
glm::ivec3 CornerOf(int corner)
{
  return { corner & 1, corner >> 1 & 1, corner >> 2 };
}

template <typename T>
T Interpolate(const std::array<T, 8>& corners, const glm::dvec3& share)
{
  T sum(0.0);
  for (int corner = 0; corner < 8; ++corner)
  {
    const glm::dvec3 side(CornerOf(corner));
    const glm::dvec3 weight = side * share + (1.0 - side) * (1.0 - share);
    const double product = weight.x * weight.y * weight.z;
    // What is not finite counts only where it has a weight.
    sum += product > 0.0 ? product * corners[static_cast<std::size_t>(corner)] : T(0.0);
  }
  return sum;
}

}

BlendTruthField::BlendTruthField(const FrameKey& key, const GridCoordinates* coordinates)
  : Fields{ key.Samples }
  , Labels(key.Blended().Labels ? &key.Blended().Labels->Samples : nullptr)
{
  this->Fields.insert(this->Fields.end(), key.Blended().Others.begin(), key.Blended().Others.end());
  for (std::size_t a = 0; a < 3; ++a)
  {
    const auto axis = static_cast<int>(a);
    for (int i = 0; i < key.Samples.Dimensions[axis]; ++i)
    {
      this->Planes[a].push_back(coordinates ? coordinates->At(axis, i) : i);
    }
    this->BreaksAlong[a] = this->Planes[a];
    for (std::size_t i = 1; i < this->Planes[a].size() && (this->IsNearest() || this->Labels); ++i)
    {
      this->BreaksAlong[a].push_back(0.5 * (this->Planes[a][i - 1] + this->Planes[a][i]));
    }
    std::sort(this->BreaksAlong[a].begin(), this->BreaksAlong[a].end());
  }
}

glm::dvec3 BlendTruthField::Last() const
{
  return { this->Planes[0].back(), this->Planes[1].back(), this->Planes[2].back() };
}

double BlendTruthField::Sample(const TemporalCoherence::Field& field, const glm::ivec3& at)
{
  const glm::i64vec3 along = glm::i64vec3(at) * field.Strides;
  const std::int64_t place = along.x + along.y + along.z;
  return DispatchScalarType(field.Type,
    [&](auto type)
    { return static_cast<double>(static_cast<const decltype(type)*>(field.Samples)[place]); });
}

/// A central difference, or one-sided at the boundary and beside a sample that is not finite.
glm::dvec3 BlendTruthField::GradientOfSample(std::size_t component, const glm::ivec3& at) const
{
  glm::dvec3 gradient;
  for (int axis = 0; axis < 3; ++axis)
  {
    const std::vector<double>& planes = this->Planes[static_cast<std::size_t>(axis)];
    glm::ivec3 low = at, high = at;
    low[axis] = std::max(at[axis] - 1, 0);
    high[axis] = std::min(at[axis] + 1, static_cast<int>(planes.size()) - 1);
    low[axis] = std::isfinite(this->Sample(component, low)) ? low[axis] : at[axis];
    high[axis] = std::isfinite(this->Sample(component, high)) ? high[axis] : at[axis];
    gradient[axis] = (this->Sample(component, high) - this->Sample(component, low)) /
      (planes[static_cast<std::size_t>(high[axis])] - planes[static_cast<std::size_t>(low[axis])]);
  }
  return gradient;
}

void BlendTruthField::Read(const glm::dvec3& point, Cell& cell) const
{
  glm::ivec3 number;
  for (int axis = 0; axis < 3; ++axis)
  {
    const std::vector<double>& planes = this->Planes[static_cast<std::size_t>(axis)];
    const auto above = std::upper_bound(planes.begin(), planes.end(), point[axis]);
    number[axis] = std::clamp(
      static_cast<int>(above - planes.begin()) - 1, 0, static_cast<int>(planes.size()) - 2);
    const double* plane = &planes[static_cast<std::size_t>(number[axis])];
    cell.Low[axis] = plane[0];
    cell.Size[axis] = plane[1] - plane[0];
  }
  if (cell.Number == number)
  {
    return;
  }
  cell.Number = number;
  for (int corner = 0; corner < 8 && this->Labels; ++corner)
  {
    cell.Labels[static_cast<std::size_t>(corner)] =
      Sample(*this->Labels, number + CornerOf(corner));
  }
  const auto& hidden = this->Fields[0].Hidden;
  cell.IsVisible = !(hidden && hidden->IsHidden(number));
  for (std::size_t c = 0; c < this->Components(); ++c)
  {
    for (int corner = 0; corner < 8; ++corner)
    {
      const glm::ivec3 at = number + CornerOf(corner);
      const auto i = static_cast<std::size_t>(corner);
      cell.Values[c][i] = this->Sample(c, at);
      cell.Gradients[c][i] = this->GradientOfSample(c, at);
      cell.IsVisible = cell.IsVisible && std::isfinite(cell.Values[c][i]);
    }
  }
}

glm::dvec3 BlendTruthField::ShareOf(const Cell& cell, const glm::dvec3& point) const
{
  const glm::dvec3 share = glm::clamp((point - cell.Low) / cell.Size, 0.0, 1.0);
  return this->IsNearest() ? glm::floor(share + 0.5) : share;
}

double BlendTruthField::ValueAt(
  const Cell& cell, std::size_t component, const glm::dvec3& point) const
{
  // Rounding must not leave the range of the samples: equal ones give the same value everywhere.
  const std::array<double, 8>& values = cell.Values[component];
  const auto range = std::minmax_element(values.begin(), values.end());
  return std::clamp(Interpolate(values, this->ShareOf(cell, point)), *range.first, *range.second);
}

double BlendTruthField::LabelAt(const Cell& cell, const glm::dvec3& point)
{
  const glm::ivec3 side(glm::lessThan(0.5 * cell.Size, point - cell.Low));
  return cell.Labels[static_cast<std::size_t>(side.x + 2 * side.y + 4 * side.z)];
}

glm::dvec3 BlendTruthField::GradientAt(
  const Cell& cell, std::size_t component, const glm::dvec3& point) const
{
  return Interpolate(cell.Gradients[component], this->ShareOf(cell, point));
}
