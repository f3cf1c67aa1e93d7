// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Grids_h
#define Testing_Grids_h

#include "vtkTemporalCoherenceCompatibility.h"

#include <vtkRectilinearGrid.h>
#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <array>
#include <functional>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkImageData;
VTK_ABI_NAMESPACE_END

/// Rectilinear grids for tests.
namespace Grids
{

using Coordinates = std::array<std::vector<double>, 3>;

/// From -1 to 1, in cells of equal size.
std::vector<double> Even(int n);

/// From -1 to 1, finest in the middle, where cells are (1 - bend) times as long as the mean.
std::vector<double> FineInside(int n, double bend);

/// From -1 to 1, in cells of all sizes from 1 to `ratio` in any order.
std::vector<double> Random(int n, double ratio, unsigned int seed);

/// Put coordinates along an axis.
void SetCoordinates(
  vtkRectilinearGrid* grid, int axis, const std::vector<double>& along, int type = VTK_DOUBLE);

/// A grid with samples of a VTK scalar type, by a formula of their positions.
vtkSmartPointer<vtkRectilinearGrid> FromFormula(const Coordinates& along, int scalarType,
  const std::function<double(double, double, double)>& value);

/// An image as a grid.
vtkSmartPointer<vtkRectilinearGrid> FromImage(vtkImageData* image, int coordinateType);

/// The same grid with some axes reversed: their coordinates descend.
vtkSmartPointer<vtkRectilinearGrid> Reversed(
  vtkRectilinearGrid* grid, const std::array<bool, 3>& axes);

}

#endif
