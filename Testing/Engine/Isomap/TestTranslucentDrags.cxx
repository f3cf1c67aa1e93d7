// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Drags of translucent isovalues show the cold picture: planes, and layers in their order, whatever
// else changes in the view, by any kind of field and region. First surfaces are looked up.

#include "Lattice/Coordinates.h"
#include "Render/OpacityChanges.h"

#include <vtkSMPTools.h>

#include <random>
#include <string>
#include <vector>

namespace
{

using namespace TemporalCoherence;

class TranslucentDrags : public OpacityChanges
{
protected:
  /// Without image cache other opacities are looked up, too, not composited again.
  TranslucentDrags() { this->Options.Reuse.Frames = false; }

  /// Drag isovalues, and now and then change opacities, colours, or jump.
  void Drag(unsigned int seed, int steps = 14)
  {
    std::mt19937 engine(seed);
    this->SetOpacity(0.4);
    this->Render("first");
    for (int step = 0; step < steps; ++step)
    {
      std::vector<double>& isovalues = this->Key.EditIsosurfaces().Isovalues;
      const auto change = engine() % 8;
      if (change == 0)
      {
        this->SetOpacity(0.05 + 0.1 * static_cast<double>(engine() % 10)); // never opaque
      }
      else if (change == 1)
      {
        this->Key.Appearance.Ambient = 0.02 * static_cast<double>(engine() % 20);
      }
      else if (change == 2)
      {
        isovalues.back() = -60.0 + static_cast<double>(engine() % 120);
      }
      else
      {
        isovalues[engine() % isovalues.size()] += 0.7 * static_cast<double>(1 + engine() % 2);
      }
      this->Render("seed " + std::to_string(seed) + ", step " + std::to_string(step));
      if (this->HasFatalFailure())
      {
        return;
      }
    }
  }

  void ExpectLookUps(int atLeast)
  {
    EXPECT_GE(this->Routes[Route::IsomapBuild] + this->Routes[Route::IsomapLookup], atLeast);
  }
};

TEST_F(TranslucentDrags, AreColdFrames)
{
  for (const SurfaceMode mode : { SurfaceMode::Crossing, SurfaceMode::Threshold })
  {
    this->Key.EditIsosurfaces().Mode = mode;
    this->Drag(1);
  }
  this->Key.View = LookAt(Dimensions, { 1.0, 0.2, 0.7 }, { 60, 50 }, true);
  this->Drag(2);
  this->ExpectLookUps(15);
}

TEST_F(TranslucentDrags, UseARangeThatIsBuiltAtOnce)
{
  this->Key.EditIsosurfaces().Isovalues = { 20.0 };
  this->Options.Map.Range = { 15.0, 35.0 };
  this->SetOpacity(0.4);
  this->Render("first");
  for (int step = 1; step <= 10; ++step)
  {
    this->Key.EditIsosurfaces().Isovalues = { 20.0 + step };
    this->Render("step", step == 1 ? Route::IsomapBuild : Route::IsomapLookup);
    EXPECT_LT(this->Statistics().TracedRays, this->Statistics().Rays / 50);
    EXPECT_GT(this->Statistics().Layers, 3000);
  }
  this->Key.EditIsosurfaces().Opacities.clear();
  this->Key.EditIsosurfaces().Isovalues = { 31.5 };
  this->Render("opaque, in the same isomap", Route::IsomapLookup);
}

TEST_F(TranslucentDrags, AreExactWhateverTheToleranceIs)
{
  this->Options.Map.Tolerance = 0.3;
  this->Options.Map.HasNormals = true;
  this->Options.Map.Range = { -70.0, 70.0 };
  this->Drag(3);
  this->ExpectLookUps(4);
  EXPECT_TRUE(this->Renderer.IsomapOfLastView().Form() == KnotForm());
}

TEST_F(TranslucentDrags, OfOpacityByGradientsAndDeepLayers)
{
  this->Key.EditIsosurfaces().ByGradient.Nodes = { { 5.0, 0.0 }, { 30.0, 0.2 } };
  this->Drag(4);
  this->Key.EditIsosurfaces().ByGradient.Nodes.clear();
  this->Samples.FillRandomly(-100.0, 100.0, 8); // more layers than a pass finds
  this->Key.Samples.Stamp += 1;
  this->Options.Map.Range = { -70.0, 70.0 };
  this->Drag(5, 8);
  this->ExpectLookUps(4);
}

TEST_F(TranslucentDrags, OfRegionsHiddenCellsGridsAndNearestSamples)
{
  this->CutIntoPieces();
  this->Options.Map.Range = { -70.0, 70.0 }; // all is looked up, however fast the machine is
  for (const SurfaceMode mode : { SurfaceMode::Crossing, SurfaceMode::Threshold })
  {
    this->Key.EditIsosurfaces().Mode = mode;
    this->Key.Samples = this->Samples.Field;
    this->Drag(6, 8);
    this->HideSomeCells();
    this->Drag(7, 8);
    this->Key.Samples.Between = Interpolation::Nearest;
    this->Drag(8, 6);
    this->Key.Samples = this->Samples.Field;
    this->Key.Samples.Shape = RectilinearKind(Stretched(Dimensions, 2.0, 4));
    this->Drag(9, 6);
  }
  this->ExpectLookUps(20);
}

TEST_F(TranslucentDrags, AreTheSameForAnyNumberOfThreads)
{
  // The backend of plain threads starts as many as it is told, whatever the machine has.
  const std::string before = vtkSMPTools::GetBackend();
  ASSERT_TRUE(vtkSMPTools::SetBackend("STDThread"));
  for (const int threads : { 1, 3 })
  {
    vtkSMPTools::Initialize(threads);
    this->Drag(11, 6);
  }
  vtkSMPTools::Initialize(0);
  vtkSMPTools::SetBackend(before.c_str());
}

}
