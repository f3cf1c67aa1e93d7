// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Model/Film.h"

#include <vtkCamera.h>

void ForEachFrame(Model& model, Look look, std::size_t marker, FilmMotion motion, int frames,
  const std::function<bool(int frame)>& draw)
{
  for (int frame = 0; frame < frames; ++frame)
  {
    if (motion == FilmMotion::Sweep)
    {
      model.MarkersOf(look)[marker].Value = model.ValueAt((frame + 0.5) / frames);
      model.View.Apply(look);
    }
    if (!draw(frame))
    {
      return;
    }
    if (motion == FilmMotion::TurnAround)
    {
      model.View.Renderer->GetActiveCamera()->Azimuth(360.0 / frames);
    }
  }
}
