// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OffScreenWindow.h"

#include "Measuring.h"

#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <array>

namespace
{

/// Of the ground: no shade of what is drawn here, and exact in 8 bits.
constexpr std::array<unsigned char, 3> Ground = { 51, 102, 153 };

}

OffScreenWindow::OffScreenWindow(vtkRenderer* renderer, int size)
  : Size(size)
{
  renderer->SetBackground(Ground[0] / 255.0, Ground[1] / 255.0, Ground[2] / 255.0);
  this->Window->SetOffScreenRendering(1);
  this->Window->SetMultiSamples(0);
  this->Window->SetSize(size, size);
  this->Window->AddRenderer(renderer);
}

double OffScreenWindow::Draw()
{
  return Measuring::TimeOf(
    [&]
    {
      this->Window->Render();
      this->Window->WaitForCompletion();
    });
}

double OffScreenWindow::PercentDrawn()
{
  constexpr int backBuffer = 0;
  vtkNew<vtkUnsignedCharArray> pixels;
  this->Window->GetPixelData(0, 0, this->Size - 1, this->Size - 1, backBuffer, pixels);
  vtkIdType drawn = 0;
  for (vtkIdType i = 0; i < pixels->GetNumberOfTuples(); ++i)
  {
    std::array<unsigned char, 3> pixel{};
    pixels->GetTypedTuple(i, pixel.data());
    drawn += pixel == Ground ? 0 : 1;
  }
  return 100.0 *
    Measuring::Ratio(static_cast<double>(drawn), static_cast<double>(pixels->GetNumberOfTuples()));
}
