// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_EmptyPicture_h
#define TemporalCoherence_EmptyPicture_h

#include "Acceleration/HiddenCells.h"
#include "Acceleration/ValueRangePyramid.h"
#include "Request/DrawnVolume.h"
#include "Scene/Field.h"

#include <vtkDataObject.h>
#include <vtkVolume.h>
#include <vtkWeakPointer.h>

#include <memory>
#include <string>
#include <vector>

namespace TemporalCoherence
{

/// Warns of input that cannot show anything, whatever its isovalues are: without samples, with all
/// cells hidden, with samples that all are NaN, or with all points at one place. It warns once for
/// each volume, and again only after the reason was gone. It does not warn of input that is too
/// thin for cells, nor where the mapper may have a part of the data only.
class EmptyPicture
{
public:
  /// \param shown  the samples of the frame that was made, with their hidden cells
  /// \param ranges of the samples; not read if they have no cells
  /// \return what is wrong and what to do about it; empty if there is no warning
  std::string Check(const DrawnVolume& drawn, const Field& shown, const ValueRangePyramid& ranges);

  /// True if the volume's user was warned, and the reason is still there.
  bool IsTold(const vtkVolume* volume) const;

private:
  std::string FindReason(vtkDataObject* data, const Field& shown, const ValueRangePyramid& ranges);
  bool AreAllHidden(const Field& shown);

  /// What a volume was told.
  struct Story
  {
    vtkWeakPointer<vtkVolume> Of;
    std::string Reason;
  };

  std::vector<Story> Stories;
  std::weak_ptr<const HiddenCells> Counted; ///< the last hidden cells
  bool WereAllHidden = false;               ///< these were all cells
};

}

#endif
