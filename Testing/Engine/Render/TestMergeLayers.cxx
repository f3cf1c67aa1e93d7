// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// A new isovalue of one of several translucent surfaces traces nothing of the others, and the
// picture is the cold one: planes, answers, and layers in their order.

#include "Acceleration/HiddenCells.h"
#include "Fields/Coordinates.h"
#include "Render/OpacityChanges.h"

#include <algorithm>

namespace
{

using namespace TemporalCoherence;

class MergeLayers : public OpacityChanges
{
protected:
  MergeLayers()
  {
    this->Options.Reuse.Isomap = false;
    this->Key.Appearance.Colors = { { 1.0, 0.5, 0.2 }, { 0.2, 0.5, 1.0 }, { 0.3, 0.9, 0.4 },
      { 0.8, 0.8, 0.1 } };
  }

  /// Set isovalues, all of one opacity.
  void SetIsovalues(const std::vector<double>& isovalues, double opacity)
  {
    this->Key.Isosurfaces.Isovalues = isovalues;
    this->SetOpacity(opacity);
    this->Key.Appearance.Colors.resize(isovalues.size());
  }

  /// Keep some isovalues, drop and add others, and change their order.
  void ChangeIsovalues(std::mt19937& engine)
  {
    std::vector<double>& isovalues = this->Key.Isosurfaces.Isovalues;
    if (engine() % 2)
    {
      std::shuffle(isovalues.begin(), isovalues.end(), engine);
    }
    if (isovalues.size() > 3 || (isovalues.size() > 1 && engine() % 2))
    {
      isovalues.pop_back();
    }
    // Integers are samples, too: whole faces of cells are at such an isovalue.
    const double added = engine() % 2 ? std::uniform_real_distribution(-95.0, 95.0)(engine)
                                      : static_cast<double>(engine() % 190) - 95.0;
    const bool isThere = std::count(isovalues.begin(), isovalues.end(), added) > 0;
    if (!isThere && engine() % 5)
    {
      isovalues.insert(isovalues.begin() + engine() % (isovalues.size() + 1), added);
    }
    this->Key.Appearance.Colors.resize(isovalues.size(), { 0.3, 0.4, 0.5 });
  }

  /// Walk through isovalues and opacities.
  void Walk(unsigned int seed, int steps = 14)
  {
    std::mt19937 engine(seed);
    for (int step = 0; step < steps; ++step)
    {
      const std::size_t before = this->Key.Isosurfaces.Isovalues.size();
      if (engine() % 6)
      {
        this->ChangeIsovalues(engine);
      }
      if (before != this->Key.Isosurfaces.Isovalues.size() || engine() % 3 == 0)
      {
        this->SetAnyOpacities(engine);
      }
      if (this->Key.Isosurfaces.Opacities.empty() && engine() % 2)
      {
        this->SetOpacity(0.3);
      }
      this->Key.Appearance.ColorByAnswer = engine() % 8 == 0;
      this->Render("seed " + std::to_string(seed) + ", step " + std::to_string(step));
      if (this->HasFatalFailure())
      {
        return;
      }
    }
  }

  void ExpectMerged(int atLeast)
  {
    EXPECT_GE(this->Routes[Route::MergeLayers], atLeast) << "isovalues made other routes";
  }
};

TEST_F(MergeLayers, WalksThroughIsovalues)
{
  for (const SurfaceMode mode : { SurfaceMode::Crossing, SurfaceMode::Threshold })
  {
    this->Key.Isosurfaces.Mode = mode;
    this->Walk(1);
    this->Walk(2);
  }
  this->ExpectMerged(20);
}

}
