// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_RayBudget_h
#define TemporalCoherence_RayBudget_h

#include "Render/FrameStatistics.h"

#include <cstdint>

namespace TemporalCoherence
{

/// Chooses how many rays a frame may trace to finish in its allowed time, from the times of earlier
/// frames. It reads no clock.
class RayBudget
{
public:
  /// A frame is part of an interaction if its allowed time is less than this, in seconds: the limit
  /// of vtkFixedPointVolumeRayCastMapper.
  static constexpr double InteractiveTime = 1.0;

  /// The rays of the next frame.
  struct Choice
  {
    double Distance = 1.0; ///< pixels between the rays of the grid; 1: every pixel has a ray
    double Until = 0.0;    ///< seconds from the beginning of the frame in which tiles may begin
  };

  /// Learn from a frame whose rays were traced.
  /// \param wasWhole every pixel had a ray
  /// \param allowed  seconds for it. Only frames of an interaction tell what comes besides rays:
  ///                 others may have set up the data
  /// \param kind     of the picture: what was learned of another kind is forgotten
  void Learn(const FrameStatistics& frame, bool wasWhole, double allowed, int kind);

  /// The rays of a frame.
  /// \param pixels  number of them
  /// \param allowed seconds to make it
  /// \param most    the largest distance
  /// \param kind    of the picture; nothing is known of one that the last frame was not of
  Choice Choose(std::int64_t pixels, double allowed, double most, int kind) const;

private:
  bool IsKnown = false;
  int Kind = 0;
  bool IsWholeKnown = false;  ///< else the last frame could not be made whole
  double WholePerPixel = 0.0; ///< seconds
  double GridPerRay = 0.0;    ///< seconds
  double Rest = -1.0; ///< seconds that do not depend on the number of rays; below 0: not known
  double Fill = 0.0;  ///< of these, seconds to fill tiles between rays
};

}

#endif
