// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
// What files that are made of Documentation/Recipes.md need: how a recipe makes itself known, and
// what it is checked with.
#ifndef RecipeChecks_h
#define RecipeChecks_h

#include <vtkAlgorithm.h>
#include <vtkImageData.h>

#include <functional>
#include <string>
#include <utility>
#include <vector>

struct Recipe
{
  std::string Name;
  bool NeedsDisplay;
  std::function<void()> Run; ///< throws if it does not give what it promises
};

/// All recipes of this program.
std::vector<Recipe>& Recipes();

/// Adds a recipe to this program before main() begins.
struct KnownRecipe
{
  explicit KnownRecipe(Recipe recipe) { Recipes().push_back(std::move(recipe)); }
};

/// Throws unless a recipe gave this.
void Expect(bool isThere, const char* what);

/// The number of pixels of RGBA whose alpha is in a range.
int NumberOfPixels(vtkImageData* picture, int leastAlpha, int mostAlpha);

/// The number of pixels of RGB with more blue than red, or with more red than blue.
int NumberOfPixels(vtkImageData* picture, bool areBlue);

/// The interpolated value of an image at a point.
double ValueAt(vtkAlgorithm* source, const double position[3]);

#endif
