// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "AnswerPicture.h"

#include "FigurePictures.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace
{

using Pixel = std::array<unsigned char, 3>;

constexpr unsigned char PossibleHit = 2; ///< in the array Answer
constexpr int PixelsToOne = 3;           ///< drawn to shown, along each axis

/// Of the answer at a pixel.
Pixel ColorOf(const Pixel& seen, bool isPossible, bool isHit)
{
  constexpr std::array<double, 3> yellow = { 255.0, 214.0, 10.0 };
  constexpr Pixel nothingFound = { 92, 80, 24 };
  constexpr double faint = 0.45, bright = 0.6;
  if (isPossible && !isHit)
  {
    return nothingFound;
  }
  const double grey = (seen[0] + seen[1] + seen[2]) / (3.0 * 255.0);
  Pixel color{};
  for (std::size_t c = 0; c < color.size(); ++c)
  {
    const double shade = isPossible
      ? yellow[c] * (1.0 - bright + bright * std::min(1.0, 1.5 * grey))
      : isHit ? 255.0 * faint * grey + FigurePictures::Ground[c]
              : FigurePictures::Ground[c];
    color[c] = static_cast<unsigned char>(std::min(255.0, shade));
  }
  return color;
}

vtkSmartPointer<vtkImageData> Painted(vtkImageData* picture, vtkImageData* rgba, Drawer& drawer)
{
  vtkNew<vtkImageData> answers;
  drawer.Mapper->GetLastFrame(answers, vtkTemporalCoherenceVolumeMapper::FRAME_ANSWER);
  auto painted = vtkSmartPointer<vtkImageData>::New();
  painted->DeepCopy(picture);
  auto* pixels = static_cast<unsigned char*>(painted->GetScalarPointer());
  const auto* alpha = static_cast<const unsigned char*>(rgba->GetScalarPointer()) + 3;
  const auto* answer = static_cast<const unsigned char*>(answers->GetScalarPointer());
  for (vtkIdType i = 0; i < painted->GetNumberOfPoints(); ++i, pixels += 3)
  {
    const Pixel color =
      ColorOf({ pixels[0], pixels[1], pixels[2] }, answer[i] == PossibleHit, alpha[4 * i] > 0);
    std::copy(color.begin(), color.end(), pixels);
  }
  return painted;
}

}

vtkSmartPointer<vtkImageData> WithAnswers(Drawer& drawer, bool withAnswers)
{
  const vtkSmartPointer<vtkImageData> picture = FigurePictures::OnGround(drawer.Color);
  std::vector<vtkSmartPointer<vtkImageData>> row = { FigurePictures::Shrunk(picture, PixelsToOne) };
  if (withAnswers)
  {
    row.push_back(FigurePictures::Shrunk(Painted(picture, drawer.Color, drawer), PixelsToOne));
  }
  return FigurePictures::Tile({ row });
}
