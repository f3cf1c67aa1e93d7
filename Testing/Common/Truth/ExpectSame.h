// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_ExpectSame_h
#define Testing_ExpectSame_h

#include "Checks/Expect.h"
#include "Scenes/Scene.h"

#include <string>

/// Two scenes show the same from the camera of the first one, to the last bit, and not nothing.
inline void ExpectSame(const std::string& what, Scene& scene, Scene& reference, int size)
{
  reference.Renderer->SetActiveCamera(scene.Renderer->GetActiveCamera());
  Expect(scene.Render(size, size) && reference.Render(size, size), what + ": rendered");
  Expect(AreIdentical(scene.Depth, reference.Depth), what + ": the same depths");
  Expect(AreIdentical(scene.Color, reference.Color), what + ": the same colours");
  int hits = 0;
  for (int y = 0; y < size; ++y)
  {
    for (int x = 0; x < size; ++x)
    {
      hits += scene.ColorAt(x, y)[3] != 0;
    }
  }
  Expect(hits > size, what + ": something is seen");
}

#endif
