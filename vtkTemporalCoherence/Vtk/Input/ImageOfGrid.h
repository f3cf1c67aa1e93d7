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

/// Sees a rectilinear grid as an image of the same dimensions, data and box, and tells where the
/// samples lie in that box. All that is done with images can be done with it.
class ImageOfGrid
{
public:
  /// \param onCells the samples lie at the centres of cells, otherwise at points
  /// \param error   gets what is wrong and what to do about it
  /// \return false on error: coordinates that are missing, not finite, or not strictly ascending or
  ///         descending. A grid with fewer than two samples along an axis is no error.
  bool See(vtkRectilinearGrid* grid, bool onCells, std::string& error);

  /// Has the data of the grid, in place, and its first and last samples where these lie. The
  /// spacing is the mean one, negative along axes whose coordinates descend. It is modified only
  /// when the grid is.
  vtkImageData* Image() const { return this->AsImage; }

  /// The kind of field that the grid is. Where samples lie where those of the image do, to 1e-5 of
  /// a cell, it is drawn as the image that it is.
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
