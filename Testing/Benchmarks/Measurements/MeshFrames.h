// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Benchmarks_MeshFrames_h
#define Benchmarks_MeshFrames_h

#include "MeshPeers.h"

#include <string>
#include <vector>

/// The mapper beside what VTK has to draw an isosurface of an irregular grid: the same views and
/// isovalues, one way after the other in each.
namespace MeshFrames
{

/// Medians in milliseconds; None where there is no such figure.
struct Times
{
  std::string Who, Remark;
  double PercentDrawn = 0.0;
  double SetUp = 0.0;  ///< the first frame, less a new view
  double Memory = 0.0; ///< bytes beside the mesh
  double Cold = 0.0;   ///< with all that depends on the isovalue made anew
  double NewView = 0.0;
  double FirstIsovalue = 0.0; ///< the first new one in a view
  double LaterIsovalue = 0.0; ///< those after it
  double InRange = 0.0;       ///< new ones of a range that was built before; None if not looked up
  double LaterLookedUp = 0.0; ///< of these the share in percent that was looked up
  double PercentWrong = 0.0;  ///< pixels hit in one picture and not in ours
  double DepthOff = 0.0;      ///< median, in mean edges of cells, where both are hit
  double DepthFarOff = 0.0;   ///< the same, exceeded by 1 % of the pixels
};

/// The first are those of the mapper.
/// \throws Measuring::Failure if the mapper cannot draw the mesh
std::vector<Times> Measure(const MeshPeers::Subject& subject, int rounds, bool hasWindow);

}

#endif
