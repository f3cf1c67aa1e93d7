// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_LineTracer_h
#define TemporalCoherence_LineTracer_h

#include "Scene/Frame.h"
#include "Scene/FrameKey.h"

#include <glm/glm.hpp>

#include <optional>

namespace TemporalCoherence
{

struct FieldRanges;

/// The first surface on a line, in the world.
struct LineHit
{
  double Distance; ///< from where the line begins
  int Surface;     ///< position in the list of isovalues
  glm::dvec3 Position;
  glm::dvec3 Normal; ///< unit normal, facing the beginning of the line
  CellNumber Cell;   ///< of a mesh, in which the surface is hit
};

/// Find the first surface on the line from `begin` to `end`, as a cold frame would: the line is the
/// ray of a picture with one pixel. It is clipped like any frame.
/// \param scene  its view and appearance are ignored
/// \param ranges of its samples
/// \pre the line has a length, and both ends are finite
/// \throws std::bad_alloc
std::optional<LineHit> TraceLine(
  const FrameKey& scene, const FieldRanges& ranges, const glm::dvec3& begin, const glm::dvec3& end);

}

#endif
