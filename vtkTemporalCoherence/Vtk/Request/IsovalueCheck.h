// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_IsovalueCheck_h
#define TemporalCoherence_IsovalueCheck_h

#include "Acceleration/ValueRangePyramid.h"
#include "Request/DrawnVolume.h"
#include "Request/RequestFromMapper.h"

#include <string>

namespace TemporalCoherence
{

/// Warns of an empty picture that the user may not expect: no sample can meet an isovalue, or VTK's
/// default isovalue 0 is transparent. It warns once, and only before the mapper has shown a
/// surface: an isovalue may be dragged out of the range, and a time step may have no surface.
class IsovalueCheck
{
public:
  /// \param request of the present frame
  /// \param ranges  of its samples; unused if all isovalues are transparent
  /// \return the warning with its remedy; empty without a warning
  std::string Check(
    const DrawnVolume& drawn, const FrameRequest& request, const ValueRangePyramid& ranges);

private:
  bool IsSettled = false;        ///< a surface or a warning was shown
  bool AreLabelsSettled = false; ///< the same of labels
};

}

#endif
