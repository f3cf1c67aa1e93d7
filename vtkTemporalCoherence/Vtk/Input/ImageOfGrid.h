// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_ImageOfGrid_h
#define TemporalCoherence_ImageOfGrid_h

#include "Scene/FieldShape.h"
#include "vtkTemporalCoherenceCompatibility.h"

#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <memory>
#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkImageData;
class vtkRectilinearGrid;
VTK_ABI_NAMESPACE_END

namespace TemporalCoherence
{

/// Presents a rectilinear grid as an image with equal dimensions, data and box, and a shape with
/// the places of samples in that box. So grids and images share one path.
class ImageOfGrid
{
public:
  /// \param onCells the samples lie at the centres of cells, otherwise at points
  /// \param error   receives the mistake and its remedy
  /// \return false on error: if coordinates are missing, not finite, or neither strictly ascending
  /// nor descending. A grid with fewer than two samples along an axis is no error.
  bool See(vtkRectilinearGrid* grid, bool onCells, std::string& error);

  /// The image. It shares the data of the grid, and the places of the first and last samples. Its
  /// spacing is the mean spacing, negative along axes with descending coordinates. Only changes of
  /// the grid modify it.
  vtkImageData* Image() const { return this->AsImage; }

  /// The shape of the grid's field. If all samples of grid and image agree within 1e-5 of a cell,
  /// the grid is drawn as the image.
  const std::shared_ptr<const FieldShape>& Shape() const { return this->OfField; }

  /// Forget the grid.
  void Release() { *this = ImageOfGrid(); }

private:
  vtkSmartPointer<vtkImageData> AsImage;
  std::shared_ptr<const FieldShape> OfField = UniformShape();
  const vtkRectilinearGrid* Grid = nullptr; ///< only compared
  vtkMTimeType Stamp = 0;                   ///< of the grid
};

}

#endif
