// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_EmptyPicture_h
#define TemporalCoherence_EmptyPicture_h

#include "Acceleration/ValueRangePyramid.h"
#include "Request/DrawnVolume.h"
#include "Scene/Field.h"
#include "Scene/HiddenCells.h"

#include <vtkDataObject.h>
#include <vtkVolume.h>
#include <vtkWeakPointer.h>

#include <memory>
#include <string>
#include <vector>

namespace TemporalCoherence
{

/// Warns of input that shows nothing at any isovalue: without samples, with all cells hidden, with
/// NaN in every cell, with flat cells only, or, if blended, with infinite samples only. It warns
/// once for each volume, and again only after the reason was gone. It ignores input too thin for cells, and mappers that
/// may draw a part of larger data.
class EmptyPicture
{
public:
  /// \param shown  the samples of the present frame, with their hidden cells
  /// \param ranges of the samples; not read if they have no cells
  /// \return the warning with its remedy; empty without a warning
  std::string Check(const DrawnVolume& drawn, const Field& shown, const ValueRangePyramid& ranges);

  /// True if a warning was given for the volume, and its reason persists.
  bool IsTold(const vtkVolume* volume) const;

private:
  std::string FindReason(
    vtkDataObject* data, bool isBlended, const Field& shown, const ValueRangePyramid& ranges);
  bool AreAllHidden(const Field& shown);

  /// A volume, and the reason of its last warning.
  struct Story
  {
    vtkWeakPointer<vtkVolume> Of;
    std::string Reason;
  };

  std::vector<Story> Stories;
  std::weak_ptr<const HiddenCells> Counted; ///< the last hidden cells
  bool WereAllHidden = false;               ///< all cells of the field
};

}

#endif
