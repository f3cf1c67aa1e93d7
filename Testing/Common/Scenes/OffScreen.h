// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_OffScreen_h
#define Testing_OffScreen_h

#include "Scenes/Scene.h"

#include <vtkRenderWindow.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cstdlib>

/// The RGBA pixels of a part of a window, both corners included.
inline vtkNew<vtkUnsignedCharArray> PixelsOf(
  vtkRenderWindow* window, int x0, int y0, int x1, int y1)
{
  vtkNew<vtkUnsignedCharArray> pixels;
  window->GetRGBACharPixelData(x0, y0, x1, y1, 0, pixels);
  return pixels;
}

inline vtkNew<vtkUnsignedCharArray> PixelsOf(vtkRenderWindow* window)
{
  const int* size = window->GetSize();
  return PixelsOf(window, 0, 0, size[0] - 1, size[1] - 1);
}

/// A window without multisampling.
inline void OpenWindow(vtkRenderWindow* window, vtkRenderer* renderer, int width, int height)
{
  window->SetMultiSamples(0);
  window->SetSize(width, height);
  window->AddRenderer(renderer);
}

/// Count the pixels of a black window that differ by more than 1/255 from the scene's last
/// MakeImage at (left, below); and the hits.
struct PictureDifference
{
  int Different = 0;
  int Hits = 0;
};

inline PictureDifference CompareWithImage(
  vtkUnsignedCharArray* pixels, int pixelsInRow, const Scene& scene, int left = 0, int below = 0)
{
  PictureDifference result;
  int size[3];
  scene.Color->GetDimensions(size);
  for (int y = 0; y < size[1]; ++y)
  {
    for (int x = 0; x < size[0]; ++x)
    {
      const unsigned char* expected = scene.ColorAt(x, y);
      const unsigned char* shown =
        pixels->GetPointer(4 * static_cast<vtkIdType>((below + y) * pixelsInRow + left + x));
      int largest = 0;
      for (int c = 0; c < 3; ++c)
      {
        largest = std::max(largest, std::abs(expected[c] - shown[c]));
      }
      result.Hits += expected[3] != 0;
      result.Different += largest > 1;
    }
  }
  return result;
}

#endif
