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
  /// \param request of a frame that was made
  /// \param ranges  of its samples; unused if all isovalues are transparent
  /// \return what is wrong and what to do about it; empty if there is no warning
  std::string Check(
    const DrawnVolume& drawn, const FrameRequest& request, const ValueRangePyramid& ranges);

private:
  bool IsSettled = false; ///< there was a surface, or a warning
};

}

#endif
