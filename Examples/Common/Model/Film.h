// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Film_h
#define Film_h

#include "Model/Model.h"

#include <functional>

enum class FilmMotion
{
  TurnAround,
  Sweep // of a marker, over all values
};

// Moves the view, or a marker of a look, frame by frame, and calls draw(frame) each time until it
// returns false. The model's settings stay; what the view shows does not.
void ForEachFrame(Model& model, Look look, std::size_t marker, FilmMotion motion, int frames,
  const std::function<bool(int frame)>& draw);

#endif
