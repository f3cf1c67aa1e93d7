// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_DragRule_h
#define TemporalCoherence_DragRule_h

#include "Scene/Surfaces.h"

#include <cstddef>

namespace TemporalCoherence
{

/// Decides how far the bands of a drag reach, and how many groups of tiles a frame builds. It
/// counts cells and bytes, never time: a drag builds the same bands on every machine, with any
/// number of threads.
class DragRule
{
public:
  DragRule();

  /// An isovalue that needs a band.
  struct Step
  {
    double Isovalue;
    double Before; ///< the previous isovalue; equal to Isovalue if it did not move
    double Range;  ///< width of the range of all values
  };

  /// True if the isovalue moves too far for a drag. Nobody knows where a jump leads to next.
  static bool IsJump(const Step& step);

  /// The band to build. It begins at the isovalue and reaches ahead in the direction of the drag.
  /// An isovalue at rest gets a narrow band around it.
  ValueBand BandFor(const Step& step) const;

  /// Isovalues of the drag in the band of a step: one at least.
  double StepsIn(const Step& step) const;

  /// How many of the groups of a picture the next frame may build.
  /// \param steps isovalues in the bands
  std::size_t GroupsToBuild(std::size_t groups, double steps) const;

  /// The work of a frame.
  struct Outcome
  {
    std::size_t GroupsBuilt = 0, GroupsTraced = 0;
    double CellsBuilt = 0.0;  ///< cells read to build groups and to look them up
    double CellsTraced = 0.0; ///< cells read to trace groups
    double MemoryShare = 0.0; ///< bytes of such bands in all groups, relative to the allowed bytes
    double Steps = 1.0;       ///< isovalues in such bands
  };
  void Learn(const Outcome& frame);

private:
  double Steps;                ///< most isovalues in a band
  double CellsOfTracing = 0.0; ///< mean of a traced group; 0: unknown
  double Price = 0.0;          ///< cells of building, relative to tracing; 0: unknown
  int FramesToWait = 0;        ///< before anything is built again
};

}

#endif
