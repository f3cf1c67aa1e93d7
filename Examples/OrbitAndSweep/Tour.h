// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Tour_h
#define Tour_h

#include <vtkType.h>

#include <string>
#include <vector>

struct IsovalueChoice;
struct Options;
class PictureBook;
class Scene;

// The change of frames that were made with no help from an earlier picture.
inline const char* const WithoutReuse = "no re-use";

// What one frame took, and by which route the mapper made it.
struct FrameRecord
{
  std::string Change; // what was changed for this frame
  std::string Route;
  double WallMs = 0.0;
  double TraceMs = 0.0;
  double ShadeMs = 0.0;
  vtkIdType Rays = 0;
};

// Renders an orbit, repetitions, colours and a sweep, gives the pictures to the book and tells on
// standard output how far it is. Throws UserError.
std::vector<FrameRecord> RunTour(
  Scene& scene, const IsovalueChoice& isovalue, const Options& options, PictureBook& book);

#endif
