// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Input/ImageOfGrid.h"

#include "Kinds/RectilinearKind.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkRectilinearGrid.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <sstream>
#include <utility>
#include <vector>

namespace TemporalCoherence
{
namespace
{

/// Largest distance between samples of grid and image, in mean cells, at which the grid is drawn as
/// an image: about the precision of float coordinates, and a hundredth of the tolerance of depths.
constexpr double LargestShift = 1e-5;

/// The positions of samples along one axis.
struct GridAxis
{
  double First = 0.0;
  double Spacing = 1.0;      ///< mean distance of samples, negative if coordinates descend
  std::vector<double> Along; ///< in units of Spacing, from the first sample
  bool IsUniform = true;
};

/// The fault of coordinates and its remedy; empty if they are valid.
std::string FaultOf(const std::vector<double>& coordinates)
{
  std::ostringstream fault;
  for (std::size_t i = 0; i < coordinates.size(); ++i)
  {
    if (!std::isfinite(coordinates[i]))
    {
      fault << "hold " << coordinates[i] << " at position " << i << "; set finite numbers";
      return fault.str();
    }
  }
  for (std::size_t i = 1; i < coordinates.size(); ++i)
  {
    const double before = coordinates[i - 1], here = coordinates[i];
    const bool isAscending = coordinates.back() > coordinates.front();
    if (!(isAscending ? here > before : here < before))
    {
      fault << "neither ascend nor descend strictly: " << before << " is followed by " << here
            << " at position " << i << "; set sorted ones without repetition";
      return fault.str();
    }
  }
  return {};
}

/// The coordinates of the points along an axis.
bool ReadCoordinates(
  vtkDataArray* array, int count, char name, std::vector<double>& coordinates, std::string& error)
{
  std::string fault;
  if (!array || array->GetNumberOfTuples() < count)
  {
    fault = "hold " + std::to_string(array ? array->GetNumberOfTuples() : 0) +
      " values, but it has " + std::to_string(count) + " points along this axis; set one for each";
  }
  else
  {
    for (vtkIdType i = 0; i < count; ++i)
    {
      coordinates.push_back(array->GetComponent(i, 0));
    }
    fault = FaultOf(coordinates);
  }
  if (!fault.empty())
  {
    const auto axis = static_cast<char>(name - 'x' + 'X');
    error = std::string("The ") + name + " coordinates of the grid " + fault +
      " with vtkRectilinearGrid::Set" + axis + "Coordinates.";
    return false;
  }
  return true;
}

std::vector<double> Centres(const std::vector<double>& coordinates)
{
  std::vector<double> centres;
  for (std::size_t i = 1; i < coordinates.size(); ++i)
  {
    centres.push_back(0.5 * coordinates[i - 1] + 0.5 * coordinates[i]);
  }
  return centres;
}

/// The axis for samples at given positions.
/// \return false if double precision is too coarse for their distances
bool MakeAxis(const std::vector<double>& places, GridAxis& axis)
{
  axis = GridAxis();
  if (places.empty())
  {
    return true;
  }
  axis.First = places.front();
  if (places.size() == 1)
  {
    return true;
  }
  const double cells = static_cast<double>(places.size() - 1);
  axis.Spacing = (places.back() - places.front()) / cells;
  for (const double place : places)
  {
    axis.Along.push_back((place - axis.First) / axis.Spacing);
  }
  axis.Along.back() = cells;
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    if (i > 0 && !(axis.Along[i] > axis.Along[i - 1]))
    {
      return false;
    }
    axis.IsUniform &= std::abs(axis.Along[i] - static_cast<double>(i)) <= LargestShift;
  }
  return true;
}

bool ReadAxes(
  vtkRectilinearGrid* grid, bool onCells, std::array<GridAxis, 3>& axes, std::string& error)
{
  int points[3];
  grid->GetDimensions(points);
  vtkDataArray* const arrays[3] = { grid->GetXCoordinates(), grid->GetYCoordinates(),
    grid->GetZCoordinates() };
  for (std::size_t a = 0; a < 3; ++a)
  {
    const char name = "xyz"[a];
    std::vector<double> coordinates;
    if (!ReadCoordinates(arrays[a], points[a], name, coordinates, error))
    {
      return false;
    }
    if (!MakeAxis(onCells ? Centres(coordinates) : coordinates, axes[a]))
    {
      error = std::string("The ") + name +
        " coordinates of the grid are too close to each other, or too far apart, for double "
        "precision; scale them.";
      return false;
    }
    // The origin of an image is its first point, half a cell before the first centre.
    axes[a].First -= onCells ? 0.5 * axes[a].Spacing : 0.0;
  }
  return true;
}

}

bool ImageOfGrid::See(vtkRectilinearGrid* grid, bool onCells, std::string& error)
{
  std::array<GridAxis, 3> axes;
  if (grid->GetNumberOfPoints() > 0 && !ReadAxes(grid, onCells, axes, error))
  {
    this->Release();
    return false;
  }
  if (!this->AsImage)
  {
    this->AsImage = vtkSmartPointer<vtkImageData>::New();
  }
  const vtkMTimeType stamp = grid->GetMTime();
  if (this->Grid != grid || this->Stamp != stamp)
  {
    int points[3];
    grid->GetDimensions(points);
    this->AsImage->SetDimensions(points);
    this->AsImage->GetPointData()->ShallowCopy(grid->GetPointData());
    this->AsImage->GetCellData()->ShallowCopy(grid->GetCellData());
    this->Grid = grid;
    this->Stamp = stamp;
  }
  this->AsImage->SetOrigin(axes[0].First, axes[1].First, axes[2].First);
  this->AsImage->SetSpacing(axes[0].Spacing, axes[1].Spacing, axes[2].Spacing);
  this->OfField = UniformShape();
  if (!(axes[0].IsUniform && axes[1].IsUniform && axes[2].IsUniform))
  {
    auto along = std::make_shared<GridCoordinates>();
    along->Along = { std::move(axes[0].Along), std::move(axes[1].Along), std::move(axes[2].Along) };
    this->OfField = RectilinearKind(along);
  }
  return true;
}

}
