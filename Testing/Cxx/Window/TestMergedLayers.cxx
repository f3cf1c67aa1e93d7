// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Where a pixel has more layers than are kept, polygons among them are off by one small group of
// layers at most, and by nothing where no polygon cuts a group.

#include "Scenes/PlateStack.h"

#include <vtkFloatingPointExceptions.h>

#include <cstdlib>

namespace
{

using namespace PlateStack;

constexpr double Alpha = 0.02;

/// Isosurfaces of one place, from below to above, of slowly changing colours.
std::vector<Plate> Haze(int count)
{
  std::vector<Plate> plates;
  for (int i = 0; i < count; ++i)
  {
    const double share = (i + 0.5) / count;
    plates.push_back({ -0.9 + 1.8 * share + 1e-4, { -0.8, 0.7, -0.9, 0.8 },
      { share, 0.9 - 0.5 * share, 0.5 }, Alpha });
  }
  return plates;
}

/// Layers that stand for others, beside each that is kept.
int MergedWith(int count)
{
  int step = 1;
  while (count > 32 * step)
  {
    step *= 2;
  }
  return step - 1;
}

/// Draw a haze and a polygon at a height.
void TestPolygon(Peeler peeler, int count, double height, double opacity)
{
  StackScene scene(peeler);
  scene.AreVolumesLast = peeler != Peeler::Renderer;
  scene.AddPolygon({ height, { -0.5, 0.9, -0.6, 0.9 }, { 0.1, 0.2, 1.0 }, opacity });
  Pile& pile = scene.AddPile(Haze(count), false);
  const bool isBetween = height > -1.0 && height < 1.0;
  const std::string what = std::to_string(count) + " layers, a polygon of opacity " +
    std::to_string(opacity) + " at " + std::to_string(height) +
    (peeler == Peeler::Renderer ? ", peeled" : "");
  const double rounding = peeler == Peeler::Renderer ? 5.0 : 2.0;
  const double tolerance = rounding + (isBetween ? 255.0 * Alpha * MergedWith(count) : 0.0);
  scene.ExpectOrder(what, tolerance);

  // Every pixel of the volume has that many layers, and those that are not kept are counted.
  const vtkIdType layers = pile.Mapper->GetStatistics()->GetNumberOfLayers();
  const vtkIdType pixels = layers / count;
  const int step = MergedWith(count) + 1;
  const vtkIdType kept = (count + step - 1) / step;
  Expect(layers > 0 && layers % count == 0, what + ": " + std::to_string(layers) + " layers");
  Expect(pile.Mapper->GetStatistics()->GetNumberOfMergedLayers() == layers - kept * pixels,
    what + ": " + std::to_string(pile.Mapper->GetStatistics()->GetNumberOfMergedLayers()) +
      " merged layers");

  // Other colours and opacities, by layers that are known and others that are found again.
  pile.Prop->GetProperty()->SetAmbient(1.0);
  pile.Prop->GetProperty()->SetDiffuse(0.0);
  pile.Prop->GetProperty()->SetSpecular(0.0);
  pile.Prop->GetProperty()->ShadeOn();
  scene.ExpectOrder(what + ", shaded", tolerance);
  Expect(std::string(pile.Mapper->GetStatistics()->GetRouteAsString()) == "Reshade",
    what + ": shaded again");
  Expect(pile.Mapper->GetStatistics()->GetNumberOfMergedLayers() == layers - kept * pixels,
    what + ": merged layers are counted again");
}

}

int TestMergedLayers(int, char*[])
{
  // The software rasteriser behind some windows divides by zero by itself.
  vtkFloatingPointExceptions::Disable();
  for (const int count : { 32, 33, 120 })
  {
    for (const double height : { 1.5, 0.61, 0.02, -0.55, -1.5 })
    {
      TestPolygon(Peeler::PolygonsOnly, count, height, 1.0);
      TestPolygon(Peeler::Renderer, count, height, 1.0);
      TestPolygon(Peeler::Renderer, count, height, 0.5);
    }
  }
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
