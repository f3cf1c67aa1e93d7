// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ViewFile/ViewPoster.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>

namespace TemporalCoherence
{
namespace
{

constexpr double MostOfByte = 255.0;

/// The colour of a row of the background, from the bottom.
glm::dvec3 BackgroundOf(const ViewLook& look, int row, int height)
{
  const double share = height > 1 ? row / (height - 1.0) : 0.0;
  return glm::mix(look.Background, look.Background2.value_or(look.Background), share);
}

}

std::vector<std::uint8_t> PosterOf(const Frame& frame, const ViewLook& look)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(frame.Size.x, frame.Size.y, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* bytes = static_cast<std::uint8_t*>(image->GetScalarPointer());
  std::size_t pixel = 0;
  for (int row = 0; row < frame.Size.y; ++row)
  {
    const glm::dvec3 background = BackgroundOf(look, row, frame.Size.y);
    for (int x = 0; x < frame.Size.x; ++x, ++pixel)
    {
      const std::array<std::uint8_t, 4>& color = frame.Colors[pixel];
      for (std::size_t c = 0; c < 3; ++c)
      {
        const double behind = (MostOfByte - color[3]) * background[static_cast<int>(c)];
        *bytes++ = static_cast<std::uint8_t>(std::lround(std::min(color[c] + behind, MostOfByte)));
      }
    }
  }
  vtkNew<vtkPNGWriter> writer;
  writer->WriteToMemoryOn();
  writer->SetInputData(image);
  writer->Write();
  vtkUnsignedCharArray* const file = writer->GetResult();
  return file ? std::vector<std::uint8_t>(
                  file->GetPointer(0), file->GetPointer(0) + file->GetNumberOfValues())
              : std::vector<std::uint8_t>();
}

}
