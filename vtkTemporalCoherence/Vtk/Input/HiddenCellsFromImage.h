// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_HiddenCellsFromImage_h
#define TemporalCoherence_HiddenCellsFromImage_h

#include "Input/SampleMask.h"
#include "Scene/HiddenCells.h"
#include "vtkTemporalCoherenceCompatibility.h"

#include <vtkType.h>

#include <array>
#include <memory>
#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkImageData;
class vtkUnsignedCharArray;
VTK_ABI_NAMESPACE_END

namespace TemporalCoherence
{

/// Finds the cells that ghost arrays of an image and a mask hide. Keeps them until an input
/// changes.
///
/// Ghost arrays are VTK's vtkGhostType arrays. A cell is hidden if it is flagged as hidden, refined
/// or duplicate, or if it has a hidden point. Duplicate points hide nothing: their samples are
/// valid. A mask hides a cell if it shows none of its samples.
class HiddenCellsOfImage
{
public:
  /// Find the hidden cells of the field that is made of an image.
  /// \param samplesAreCells the field's samples lie at the centres of the image's cells, so each
  ///                        hidden cell of the image hides the field's cells around it
  /// \param mask            of the field's samples
  /// \param hidden          gets the cells; null if none is hidden
  /// \param error           receives the mistake and its remedy
  /// \return false on error
  bool Find(vtkImageData* image, bool samplesAreCells, const SampleMask& mask,
    std::shared_ptr<const HiddenCells>& hidden, std::string& error);

  void Release() { *this = HiddenCellsOfImage(); }

private:
  /// The inputs of hidden cells, to be compared.
  struct Origin
  {
    std::array<const vtkUnsignedCharArray*, 2> Arrays{}; ///< of cells and of points; or null
    std::array<vtkMTimeType, 2> Times{};
    std::array<int, 3> Dimensions{}; ///< of the image
    bool SamplesAreCells = false;
    SampleMask Mask;

    bool operator==(const Origin& other) const
    {
      return this->Arrays == other.Arrays && this->Times == other.Times &&
        this->Dimensions == other.Dimensions && this->SamplesAreCells == other.SamplesAreCells &&
        this->Mask == other.Mask;
    }
  };

  Origin MadeFrom;
  std::shared_ptr<const HiddenCells> Made;
};

}

#endif
