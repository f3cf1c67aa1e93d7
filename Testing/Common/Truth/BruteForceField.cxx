// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Truth/BruteForceField.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDataSetAttributes.h>
#include <vtkImageData.h>
#include <vtkMath.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkRectilinearGrid.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{

using Point = BruteForceField::Point;

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

std::array<double, 16> Elements(vtkMatrix4x4* matrix)
{
  std::array<double, 16> elements;
  std::copy_n(matrix->GetData(), 16, elements.begin());
  return elements;
}

/// From index space to the coordinates of an image, corner by corner, so that no matrix of ours is
/// trusted.
void PlaceImage(vtkImageData* image, bool onCells, vtkMatrix4x4* toVolume)
{
  const int* extent = image->GetExtent();
  double corner[4][3];
  for (int c = 0; c < 4; ++c)
  {
    const int ijk[3] = { extent[0] + (c == 1), extent[2] + (c == 2), extent[4] + (c == 3) };
    image->TransformIndexToPhysicalPoint(ijk, corner[c]);
  }
  if (onCells)
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
}

}

BruteForceField::BruteForceField(
  vtkImageData* image, vtkVolume* volume, int component, vtkDataArray* cells)
{
  image->GetDimensions(this->Dimensions.data());
  this->FindHidden(image, cells != nullptr);
  this->SetSamples(cells ? cells : image->GetPointData()->GetScalars(), component, cells);
  this->TakesNearest = volume->GetProperty()->GetInterpolationType() == VTK_NEAREST_INTERPOLATION;
  for (std::size_t a = 0; a < 3; ++a)
  {
    for (int i = 0; i < this->Dimensions[a]; ++i)
    {
      this->PlanesAlong[a].push_back(i);
    }
  }
  vtkNew<vtkMatrix4x4> toVolume;
  PlaceImage(image, cells != nullptr, toVolume);
  this->SetTransform(toVolume, volume);
}

BruteForceField::BruteForceField(
  vtkRectilinearGrid* grid, vtkVolume* volume, int component, vtkDataArray* cells)
{
  grid->GetDimensions(this->Dimensions.data());
  this->FindHidden(grid, cells != nullptr);
  this->SetSamples(cells ? cells : grid->GetPointData()->GetScalars(), component, cells);
  this->TakesNearest = volume->GetProperty()->GetInterpolationType() == VTK_NEAREST_INTERPOLATION;
  vtkDataArray* coordinates[3] = { grid->GetXCoordinates(), grid->GetYCoordinates(),
    grid->GetZCoordinates() };
  vtkNew<vtkMatrix4x4> toVolume;
  for (std::size_t a = 0; a < 3; ++a)
  {
    // From the first plane on: far from the origin small distances would drown.
    std::vector<double>& planes = this->PlanesAlong[a];
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
  this->SetTransform(toVolume, volume);
}

void BruteForceField::SetSamples(vtkDataArray* array, int component, bool onCells)
{
  for (int& samples : this->Dimensions)
  {
    samples -= onCells;
  }
  bool areNumbers = true;
  this->Samples.resize(static_cast<std::size_t>(this->Dimensions[0]) *
    static_cast<std::size_t>(this->Dimensions[1]) * static_cast<std::size_t>(this->Dimensions[2]));
  for (std::size_t i = 0; i < this->Samples.size(); ++i)
  {
    const double value = array->GetComponent(static_cast<vtkIdType>(i), component);
    this->Samples[i] = value;
    areNumbers = areNumbers && !std::isnan(value);
  }
  if (!areNumbers)
  {
    this->HideAroundNaN();
  }
}

void BruteForceField::HideAroundNaN()
{
  const int nx = this->Dimensions[0], ny = this->Dimensions[1], nz = this->Dimensions[2];
  this->Hidden.resize(static_cast<std::size_t>((nx - 1) * (ny - 1) * (nz - 1)), false);
  for (int k = 0; k < nz; ++k)
  {
    for (int j = 0; j < ny; ++j)
    {
      for (int i = 0; i < nx; ++i)
      {
        const int cell[3] = { i, j, k };
        const bool isNumber =
          !std::isnan(this->Samples[static_cast<std::size_t>((k * ny + j) * nx + i)]);
        for (int around = 0; around < 8 && !isNumber; ++around)
        {
          const int x = cell[0] - (around & 1), y = cell[1] - (around >> 1 & 1),
                    z = cell[2] - (around >> 2);
          if (std::min({ x, y, z }) >= 0 && x < nx - 1 && y < ny - 1 && z < nz - 1)
          {
            this->Hidden[static_cast<std::size_t>((z * (ny - 1) + y) * (nx - 1) + x)] = true;
          }
        }
      }
    }
  }
}

void BruteForceField::SetTransform(vtkMatrix4x4* toVolume, vtkVolume* volume)
{
  vtkNew<vtkMatrix4x4> world;
  volume->ComputeMatrix();
  vtkMatrix4x4::Multiply4x4(volume->GetMatrix(), toVolume, world);
  this->WorldFromIndex = Elements(world);
  this->Voxel = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis)
  {
    const std::vector<double>& planes = this->PlanesAlong[static_cast<std::size_t>(axis)];
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
int BruteForceField::CellOf(std::size_t axis, double at) const
{
  const std::vector<double>& planes = this->PlanesAlong[axis];
  const auto above = std::upper_bound(planes.begin(), planes.end(), at);
  return std::clamp(static_cast<int>(above - planes.begin()) - 1, 0, this->Dimensions[axis] - 2);
}

void BruteForceField::FindHidden(vtkDataSet* data, bool areSamplesCells)
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
        constexpr int hiding =
          Attributes::HIDDENCELL | Attributes::REFINEDCELL | Attributes::DUPLICATECELL;
        bool isHidden = (flag & hiding) != 0;
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
void BruteForceField::HideAroundSamples()
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

void BruteForceField::HideBySamples(const std::function<bool(int, int, int)>& isShown)
{
  const int nx = this->Dimensions[0] - 1, ny = this->Dimensions[1] - 1,
            nz = this->Dimensions[2] - 1;
  this->Hidden.resize(static_cast<std::size_t>(nx * ny * nz), false);
  std::size_t cell = 0;
  for (int k = 0; k < nz; ++k)
  {
    for (int j = 0; j < ny; ++j)
    {
      for (int i = 0; i < nx; ++i, ++cell)
      {
        bool isAnyShown = false;
        for (int corner = 0; corner < 8; ++corner)
        {
          isAnyShown =
            isAnyShown || isShown(i + (corner & 1), j + (corner >> 1 & 1), k + (corner >> 2));
        }
        this->Hidden[cell] = this->Hidden[cell] || !isAnyShown;
      }
    }
  }
}

bool BruteForceField::IsHidden(const Point& index) const
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

double BruteForceField::Sample(int i, int j, int k) const
{
  i = this->IsDescending[0] ? this->Dimensions[0] - 1 - i : i;
  j = this->IsDescending[1] ? this->Dimensions[1] - 1 - j : j;
  k = this->IsDescending[2] ? this->Dimensions[2] - 1 - k : k;
  const auto nx = static_cast<std::size_t>(this->Dimensions[0]);
  const auto ny = static_cast<std::size_t>(this->Dimensions[1]);
  return this->Samples[(static_cast<std::size_t>(k) * ny + static_cast<std::size_t>(j)) * nx +
    static_cast<std::size_t>(i)];
}

/// The cell that a point lies in, or the nearest one, and where in it.
std::array<int, 3> BruteForceField::FindCell(const Point& index, Point& share) const
{
  std::array<int, 3> cell;
  for (std::size_t a = 0; a < 3; ++a)
  {
    cell[a] = this->CellOf(a, index[a]);
    const double* plane = &this->PlanesAlong[a][static_cast<std::size_t>(cell[a])];
    share[a] = std::clamp((index[a] - plane[0]) / (plane[1] - plane[0]), 0.0, 1.0);
  }
  return cell;
}

double BruteForceField::DifferenceAt(const Point& index, double isovalue) const
{
  Point f;
  const std::array<int, 3> cell = this->FindCell(index, f);
  for (double& share : f)
  {
    share = this->TakesNearest ? std::floor(share + 0.5) : share;
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

Point BruteForceField::WorldNormalAt(const Point& world) const
{
  Point f;
  const std::array<int, 3> cell = this->FindCell(this->IndexOf(world), f);
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
      low[a] = std::isnan(this->Sample(low[0], low[1], low[2])) ? at[a] : low[a];
      high[a] = std::isnan(this->Sample(high[0], high[1], high[2])) ? at[a] : high[a];
      const double distance = this->PlanesAlong[a][static_cast<std::size_t>(high[a])] -
        this->PlanesAlong[a][static_cast<std::size_t>(low[a])];
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

Point BruteForceField::IndexOf(const Point& world) const
{
  return Transform(this->IndexFromWorld, world, 1.0);
}

Point BruteForceField::IndexDirectionOf(const Point& world) const
{
  return Transform(this->IndexFromWorld, world, 0.0);
}
