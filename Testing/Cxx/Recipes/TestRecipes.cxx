// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
// Each recipe in C++ of Documentation/Recipes.md compiles as it stands there, runs, and gives what
// it promises: a picture that shows something, a hit, a second volume, a route.
//
// usage: Recipes NAME

#include "RecipeChecks.h"

#include <vtkAlgorithm.h>
#include <vtkImageData.h>

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <stdexcept>

std::vector<Recipe>& Recipes()
{
  static std::vector<Recipe> recipes;
  return recipes;
}

void Expect(bool isThere, const char* what)
{
  if (!isThere)
  {
    throw std::runtime_error(std::string("Expected ") + what);
  }
}

int NumberOfPixels(vtkImageData* picture, int leastAlpha, int mostAlpha)
{
  Expect(picture->GetNumberOfScalarComponents() == 4, "pixels with alpha");
  const auto* pixel = static_cast<const unsigned char*>(picture->GetScalarPointer());
  int count = 0;
  for (vtkIdType i = 0; i < picture->GetNumberOfPoints(); ++i, pixel += 4)
  {
    count += pixel[3] >= leastAlpha && pixel[3] <= mostAlpha ? 1 : 0;
  }
  return count;
}

int NumberOfPixels(vtkImageData* picture, bool areBlue)
{
  Expect(picture->GetNumberOfScalarComponents() == 3, "pixels without alpha");
  const auto* pixel = static_cast<const unsigned char*>(picture->GetScalarPointer());
  int count = 0;
  for (vtkIdType i = 0; i < picture->GetNumberOfPoints(); ++i, pixel += 3)
  {
    count += (areBlue ? pixel[2] > pixel[0] : pixel[2] < pixel[0]) ? 1 : 0;
  }
  return count;
}

double ValueAt(vtkAlgorithm* source, const double position[3])
{
  auto* image = vtkImageData::SafeDownCast(source->GetOutputDataObject(0));
  int cell[3];
  double parts[3];
  Expect(image->ComputeStructuredCoordinates(position, cell, parts) != 0, "a point in the image");
  const int* extent = image->GetExtent();
  double value = 0.0;
  for (int corner = 0; corner < 8; ++corner)
  {
    double weight = 1.0;
    int sample[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      const int step = corner >> axis & 1;
      weight *= step == 1 ? parts[axis] : 1.0 - parts[axis];
      // At the end of the image the weight of the next sample is 0.
      sample[axis] = std::min(cell[axis] + step, extent[2 * axis + 1]);
    }
    value += weight * image->GetScalarComponentAsDouble(sample[0], sample[1], sample[2], 0);
  }
  return value;
}

int main(int argc, char* argv[])
{
  for (const Recipe& recipe : Recipes())
  {
    if (argc != 2 || recipe.Name != argv[1])
    {
      continue;
    }
    if (recipe.NeedsDisplay && std::getenv("DISPLAY") == nullptr)
    {
      std::cout << "SKIPPED: there is no display\n";
      return EXIT_SUCCESS;
    }
    try
    {
      recipe.Run();
      return EXIT_SUCCESS;
    }
    catch (const std::exception& failure)
    {
      std::cerr << recipe.Name << ": " << failure.what() << '\n';
      return EXIT_FAILURE;
    }
  }
  std::cerr << "usage: " << argv[0] << " NAME, one of";
  for (const Recipe& recipe : Recipes())
  {
    std::cerr << " '" << recipe.Name << "'";
  }
  std::cerr << '\n';
  return EXIT_FAILURE;
}
