// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Benchmarks_BlendFrames_h
#define Benchmarks_BlendFrames_h

#include "BlendErrors.h"
#include "BlendLooks.h"
#include "BlendWays.h"

#include <array>
#include <string>
#include <vector>

/// Frames of blended volumes by all ways in turn.
namespace BlendFrames
{

/// What changes from one frame to the next.
enum class Change
{
  View,  ///< by a degree
  Ramp,  ///< its lower end
  Color, ///< at the same opacity
  Light  ///< ambient and diffuse
};
constexpr std::size_t Changes = 4;

struct Figures
{
  std::string Who;
  std::array<double, Changes> Times; ///< medians in ms; None if not measured
  BlendErrors::Errors Errors;
};

/// \param mode of vtkVolumeMapper
/// \return the first two are this mapper's: cold, and with what it knows of earlier frames
std::vector<Figures> Measure(
  Stage& stage, const BlendLooks::Look& look, int mode, int rounds, bool hasWindow);

}

#endif
