// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_ImageValues_h
#define TemporalCoherence_ImageValues_h

#include "Input/FieldSource.h"
#include "Input/ImageOfGrid.h"
#include "Input/MergedBlocks.h"
#include "Input/SamplesOfArray.h"
#include "Input/ScalarChoice.h"
#include "Scene/ArrayLooks.h"
#include "vtkTemporalCoherenceCompatibility.h"

#include <memory>
#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataObject;
class vtkVolume;
VTK_ABI_NAMESPACE_END

namespace TemporalCoherence
{

/// Reads an array that gives the surfaces of an image, of a rectilinear grid, or of blocks of
/// images their colours. Keeps computed arrays until the data change.
class ImageValues
{
public:
  /// \param data  an image, a rectilinear grid, or blocks of images on one lattice
  /// \param error receives the mistake and its remedy
  /// \return false on error
  /// \throws std::bad_alloc
  bool Make(vtkDataObject* data, const ArrayChoice& choice, vtkVolume* volume, FoundValues& found,
    std::string& error);

  void Release() { *this = ImageValues(); }

private:
  ArraysInPlace Arrays;
  MergedBlocks Blocks;
  ImageOfGrid Grid;
};

}

#endif
