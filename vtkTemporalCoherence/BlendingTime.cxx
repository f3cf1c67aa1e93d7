// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BlendingTime.h"

#include <vtkDataArray.h>
#include <vtkDataSet.h>
#include <vtkGPUVolumeRayCastMapper.h>
#include <vtkImageData.h>
#include <vtkMatrix4x4.h>
#include <vtkPiecewiseFunction.h>
#include <vtkRectilinearGrid.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace TemporalCoherence
{
namespace
{

/// Columns of samples along each axis that are looked at: a square of this side.
constexpr int Columns = 8;

/// Places of the opacity function that are looked at.
constexpr int Places = 1024;

/// A ray is opaque beyond this.
constexpr double LeastTransparency = 1.0 / 255;

/// What rays of the volume meet on average until they are opaque.
struct Means
{
  double Steps = 0.0; ///< of VTK's mapper
  double Cells = 0.0; ///< that are not transparent
};

/// CPU time of VTK's mapper for a picture of 512 x 512 pixels with llvmpipe, in ms. Measured with
/// two volumes, a formula and six functions of opacity; only ratios are used.
double TimeOfVtk(const Means& means, bool isShaded)
{
  return isShaded ? 160.0 + 13.9 * means.Steps : 70.0 + 4.2 * means.Steps;
}

/// CPU time of this library, from the same measurement. The first cells of a ray cost most: as a
/// rule they hold ramps and peaks, at which rays are divided.
double TimeOfOurs(const Means& means, bool isShaded)
{
  const double all = isShaded ? 1000.0 + 65.0 * means.Cells : 900.0 + 35.0 * means.Cells;
  return 400.0 + std::min(180.0 * means.Cells, all);
}

/// The samples of an image or a rectilinear grid. Distances in a grid count as equal.
struct Lattice
{
  vtkDataArray* Samples = nullptr; ///< null: there are none
  int Component = 0;               ///< whose opacity counts
  std::array<int, 3> Counts = { 0, 0, 0 };
  std::array<double, 3> Spacing = { 1.0, 1.0, 1.0 };
};

Lattice LatticeOf(vtkGPUVolumeRayCastMapper* mapper, vtkVolumeProperty* property)
{
  auto* const data = vtkDataSet::SafeDownCast(mapper->GetInputDataObject(0, 0));
  Lattice lattice;
  if (auto* image = vtkImageData::SafeDownCast(data))
  {
    image->GetDimensions(lattice.Counts.data());
  }
  else if (auto* grid = vtkRectilinearGrid::SafeDownCast(data))
  {
    grid->GetDimensions(lattice.Counts.data());
  }
  else
  {
    return lattice;
  }
  int isOnCells = 0;
  vtkDataArray* const samples = vtkAbstractMapper::GetScalars(data, mapper->GetScalarMode(),
    mapper->GetArrayAccessMode(), mapper->GetArrayId(), mapper->GetArrayName(), isOnCells);
  const double* const bounds = data->GetBounds();
  vtkIdType all = 1;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const int intervals = std::max(lattice.Counts[axis] - 1, 1);
    const double length = bounds[2 * axis + 1] - bounds[2 * axis];
    lattice.Spacing[axis] = length > 0.0 ? length / intervals : 1.0;
    lattice.Counts[axis] = isOnCells ? intervals : lattice.Counts[axis];
    all *= lattice.Counts[axis];
  }
  if (samples && all > 0 && samples->GetNumberOfTuples() >= all)
  {
    lattice.Samples = samples;
    lattice.Component =
      property->GetIndependentComponents() ? 0 : samples->GetNumberOfComponents() - 1;
  }
  return lattice;
}

/// The distance of samples of VTK's mapper in a picture that is not in a hurry: the least spacing
/// in the world, used as a distance in the data.
double StepOf(vtkGPUVolumeRayCastMapper* mapper, const Lattice& lattice, vtkVolume* volume)
{
  const std::array<double, 3>& spacing = lattice.Spacing;
  double step = static_cast<double>(mapper->GetSampleDistance());
  if (mapper->GetAutoAdjustSampleDistances())
  {
    step = std::numeric_limits<double>::infinity();
    vtkMatrix4x4* const matrix = volume->GetMatrix();
    for (int axis = 0; axis < 3; ++axis)
    {
      step = std::min(step,
        spacing[static_cast<std::size_t>(axis)] *
          std::hypot(
            matrix->GetElement(0, axis), matrix->GetElement(1, axis), matrix->GetElement(2, axis)));
    }
  }
  else if (mapper->GetLockSampleDistanceToInputSpacing())
  {
    double intervals = 1.0;
    for (const int count : lattice.Counts)
    {
      intervals *= std::max(count - 1, 1);
    }
    const double small = std::min(std::pow(intervals, 0.333) / 100.0, 1.0);
    step = (spacing[0] + spacing[1] + spacing[2]) / 6.0 * (0.01 + 0.99 * small);
  }
  return step > 0.0 ? step : 1.0;
}

/// The transparency of a distance along an axis, at equal distances in the range of values.
struct Transparencies
{
  std::array<double, 2> Range = { 0.0, 1.0 };
  std::array<double, Places> Table = {};

  Transparencies(const Lattice& lattice, vtkVolumeProperty* property, double distance)
  {
    lattice.Samples->GetFiniteRange(this->Range.data(), lattice.Component);
    if (!(this->Range[0] < this->Range[1]))
    {
      this->Range[1] = this->Range[0] + 1.0;
    }
    const double unit = property->GetScalarOpacityUnitDistance(0);
    property->GetScalarOpacity(0)->GetTable(
      this->Range[0], this->Range[1], Places, this->Table.data());
    for (double& place : this->Table)
    {
      place =
        std::pow(1.0 - std::min(std::max(0.0, place), 1.0), distance / (unit > 0.0 ? unit : 1.0));
    }
  }

  double At(double value) const
  {
    const double share = (value - this->Range[0]) / (this->Range[1] - this->Range[0]);
    const double place = std::min(std::max(0.0, share), 1.0); // in this order NaN is 0
    return this->Table[static_cast<std::size_t>(std::lround(place * (Places - 1)))];
  }
};

/// Follow columns along an axis until they are opaque.
/// \param step of VTK's mapper
void AddColumns(const Lattice& lattice, const Transparencies& transparencies, std::size_t axis,
  double step, Means& means)
{
  const std::array<int, 3>& counts = lattice.Counts;
  const std::array<vtkIdType, 3> strides = { 1, counts[0],
    static_cast<vtkIdType>(counts[0]) * counts[1] };
  const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
  constexpr double share = 1.0 / (3 * Columns * Columns);
  for (vtkIdType column = 0; column < Columns * Columns; ++column)
  {
    vtkIdType at = strides[u] * ((2 * (column % Columns) + 1) * counts[u] / (2 * Columns)) +
      strides[v] * ((2 * (column / Columns) + 1) * counts[v] / (2 * Columns));
    bool wasClear = true;
    double left = 1.0;
    for (int i = 0; i < counts[axis] && left > LeastTransparency; ++i)
    {
      const double transparency =
        transparencies.At(lattice.Samples->GetComponent(at, lattice.Component));
      const bool isClear = transparency == 1.0;
      left *= transparency;
      means.Steps += share * lattice.Spacing[axis] / step;
      means.Cells += isClear && wasClear ? 0.0 : share;
      wasClear = isClear;
      at += strides[axis];
    }
  }
}

}

double BlendingTimeBesideVtk(vtkGPUVolumeRayCastMapper* mapper, vtkVolume* volume)
{
  vtkVolumeProperty* const property = volume->GetProperty();
  const Lattice lattice = LatticeOf(mapper, property);
  if (!lattice.Samples)
  {
    return 0.0;
  }
  Means means;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    AddColumns(lattice, Transparencies(lattice, property, lattice.Spacing[axis]), axis,
      StepOf(mapper, lattice, volume), means);
  }
  const bool isShaded = property->GetShade() ||
    (property->HasGradientOpacity() && !property->GetDisableGradientOpacity());
  return TimeOfOurs(means, isShaded) / TimeOfVtk(means, isShaded);
}

}
