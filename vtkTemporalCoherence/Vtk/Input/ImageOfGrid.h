// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_ImageOfGrid_h
#define TemporalCoherence_ImageOfGrid_h

#include "Scene/FieldKind.h"
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

/// Presents a rectilinear grid as an image of the same dimensions, data and box, and tells where
/// the samples lie in that box. So grids take the same path as images.
class ImageOfGrid
{
public:
  /// \param onCells the samples lie at the centres of cells, otherwise at points
  /// \param error   gets what is wrong and what to do about it
  /// \return false on error: if coordinates are missing, not finite, or neither strictly ascending
  /// nor descending. A grid with fewer than two samples along an axis is no error.
  bool See(vtkRectilinearGrid* grid, bool onCells, std::string& error);

  /// The image. It shares the data of the grid, and its first and last samples lie where those of
  /// the grid do. Its spacing is the mean spacing, negative along axes with descending coordinates.
  /// It is modified only when the grid is.
  vtkImageData* Image() const { return this->AsImage; }

  /// The kind of the grid's field. A grid whose samples lie within 1e-5 of a cell of those of the
  /// image is drawn as that image.
  const std::shared_ptr<const FieldKind>& Kind() const { return this->OfField; }

  /// Forget the grid.
  void Release() { *this = ImageOfGrid(); }

private:
  vtkSmartPointer<vtkImageData> AsImage;
  std::shared_ptr<const FieldKind> OfField = UniformKind();
  const vtkRectilinearGrid* Grid = nullptr; ///< only compared
  vtkMTimeType Stamp = 0;                   ///< of the grid
};

}

#endif
