// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Features that meet in one picture agree with brute force: inputs of all kinds, cropped to pieces,
// clipped, with cells hidden, opaque and translucent.

#include "Checks/Expect.h"
#include "Truth/Compositor.h"
#include "Truth/ExpectTruth.h"
#include "Truth/ImageBlocks.h"
#include "Truth/MaskedTruth.h"
#include "Volumes/Ghosts.h"
#include "Volumes/Grids.h"
#include "Volumes/Masks.h"

#include <vtkCellData.h>
#include <vtkContourValues.h>
#include <vtkDataSetAttributes.h>
#include <vtkPlane.h>
#include <vtkPointData.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>

namespace
{

using Mapper = vtkTemporalCoherenceVolumeMapper;
using Image = vtkSmartPointer<vtkImageData>;

constexpr int Samples = 9; ///< along each axis
constexpr int Width = 70, Height = 55;

/// An input, its samples as brute force sees them, and how the mapper is to read it.
struct Input
{
  std::string Name;
  vtkSmartPointer<vtkDataObject> Data;
  std::function<BruteForceTracer(vtkVolume*)> Truth;
  std::array<int, 3> Many;
  bool HidesCells;
  bool IsOfCells = false;
  Image Mask; ///< binary, or null
};

Image MakeImage(bool hides, double chance = 0.15)
{
  Image image = Volumes::Noise(Samples, VTK_SHORT, 0.0, 100.0);
  if (hides)
  {
    Ghosts::HideCells(image, chance, 5);
  }
  return image;
}

Input OfImage(bool hides)
{
  Image image = MakeImage(hides);
  return { hides ? "image with hidden cells" : "image", image,
    [image](vtkVolume* volume) { return BruteForceTracer(image.Get(), volume); },
    { Samples, Samples, Samples }, hides };
}

Input OfCells(bool hides)
{
  // A cell that is hidden is a sample of eight others.
  Image image = MakeImage(hides, 0.04);
  const Image noise = Volumes::Noise(Samples - 1, VTK_FLOAT, 0.0, 100.0);
  vtkSmartPointer<vtkDataArray> cells = noise->GetPointData()->GetScalars();
  cells->SetName("of cells");
  image->GetCellData()->AddArray(cells);
  return { hides ? "cells, some hidden" : "cells", image,
    [image, cells](vtkVolume* volume) { return BruteForceTracer(image.Get(), volume, 0, cells); },
    { Samples - 1, Samples - 1, Samples - 1 }, hides, true };
}

/// A sample that is masked, and all around it, too, hides a cell.
Input OfMask(bool hides)
{
  const Image image = MakeImage(hides);
  const int count[3] = { Samples, Samples, Samples };
  const Image mask = Masks::Make(count, VTK_UNSIGNED_CHAR, Masks::Random(0.8, 9));
  const auto truth = [image, mask](vtkVolume* volume)
  {
    BruteForceTracer traced(image.Get(), volume);
    Masks::Hide(mask, traced.Field);
    return traced;
  };
  return { hides ? "masked image with hidden cells" : "masked image", image, truth,
    { Samples, Samples, Samples }, true, false, mask };
}

Input OfGrid(bool hides)
{
  const Image image = MakeImage(hides);
  auto grid = Grids::FromImage(image, VTK_DOUBLE);
  for (int axis = 0; axis < 3; ++axis)
  {
    Grids::SetCoordinates(
      grid, axis, Grids::Random(Samples, 5.0, 11u + static_cast<unsigned>(axis)));
  }
  grid->GetCellData()->ShallowCopy(image->GetCellData());
  return { hides ? "grid with hidden cells" : "grid", grid,
    [grid](vtkVolume* volume) { return BruteForceTracer(grid.Get(), volume); },
    { Samples, Samples, Samples }, hides };
}

/// Four blocks, of which one may not be there.
Input OfBlocks(bool hides)
{
  Image image = MakeImage(false);
  constexpr int Cut = 4, Last = Samples - 1;
  auto blocks = ImageBlocks::Blocks(image,
    { { 0, Cut, 0, Cut, 0, Last }, { Cut, Last, 0, Cut, 0, Last }, { 0, Cut, Cut, Last, 0, Last },
      { Cut, Last, Cut, Last, 0, Last } });
  if (hides)
  {
    blocks->SetBlock(3, nullptr);
    Ghosts::FlagCells(image,
      [](int i, int j, int)
      { return i >= Cut && j >= Cut ? vtkDataSetAttributes::HIDDENCELL : 0; });
  }
  return { hides ? "three of four blocks" : "blocks", blocks,
    [image](vtkVolume* volume) { return BruteForceTracer(image.Get(), volume); },
    { Samples, Samples, Samples }, hides };
}

/// A way to cut a volume in [-1, 1]^3.
struct Cutting
{
  std::string Name;
  std::function<void(Mapper*)> Cut;
};

void Clip(Mapper* mapper)
{
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0.11, 0.0, 0.0);
  plane->SetNormal(-1.0, -0.3, 0.2);
  mapper->AddClippingPlane(plane);
}

void Crop(Mapper* mapper, int flags)
{
  mapper->CroppingOn();
  mapper->SetCroppingRegionPlanes(-0.43, 0.31, -0.37, 0.29, -0.57, 0.53);
  mapper->SetCroppingRegionFlags(flags);
}

std::vector<Cutting> AllCuttings()
{
  return {
    { "cropped to a box", [](Mapper* mapper) { Crop(mapper, VTK_CROP_SUBVOLUME); } },
    { "cropped to pieces", [](Mapper* mapper) { Crop(mapper, VTK_CROP_INVERTED_CROSS); } },
    { "cropped to other pieces", [](Mapper* mapper) { Crop(mapper, 0x2AAAAAA); } },
    { "clipped", Clip },
    { "cropped to pieces and clipped",
      [](Mapper* mapper)
      {
        Crop(mapper, VTK_CROP_INVERTED_FENCE);
        Clip(mapper);
      } },
  };
}

const std::vector<double> Isovalues = { 50.5, 80.25, 30.75 };

void Arrange(Scene& scene, const Input& input, bool isNearest, int mode)
{
  scene.Mapper->SetInputDataObject(input.Data);
  if (input.IsOfCells)
  {
    scene.Mapper->SetScalarModeToUseCellFieldData();
    scene.Mapper->SelectScalarArray("of cells");
  }
  scene.Mapper->SetMaskTypeToBinary();
  scene.Mapper->SetMaskInput(input.Mask);
  scene.Mapper->SetSurfaceMode(mode);
  scene.Volume->GetProperty()->SetInterpolationType(
    isNearest ? VTK_NEAREST_INTERPOLATION : VTK_LINEAR_INTERPOLATION);
  scene.Volume->GetProperty()->ShadeOff();
}

/// Compare what is seen first with brute force.
void ExpectTruthOf(const std::string& name, Scene& scene, const Input& input)
{
  BruteForceTracer truth = input.Truth(scene.Volume);
  truth.Isovalues = Isovalues;
  truth.IsThreshold = scene.Mapper->GetSurfaceMode() == Mapper::THRESHOLD;
  const int hits = ExpectTruth(name, scene, truth, Width, Height);
  Expect(hits > Width, name + ": something is seen");
}

void TestInputs()
{
  const std::vector<std::array<double, 5>> colors = { { 30.75, 0.1, 0.3, 0.9, 0.15 },
    { 50.5, 0.8, 0.3, 0.2, 0.3 }, { 80.25, 0.2, 0.9, 0.1, 0.5 } };
  for (const bool hides : { false, true })
  {
    for (const Input& input :
      { OfImage(hides), OfCells(hides), OfGrid(hides), OfBlocks(hides), OfMask(hides) })
    {
      for (const Cutting& cutting : AllCuttings())
      {
        for (const int mode : { Mapper::CROSSING, Mapper::THRESHOLD })
        {
          for (const bool isNearest : { false, true })
          {
            Scene scene(nullptr, Isovalues);
            Arrange(scene, input, isNearest, mode);
            cutting.Cut(scene.Mapper);
            scene.LookFrom(0.9, 0.7, 0.4);
            const std::string name = input.Name + ", " + cutting.Name +
              (mode == Mapper::THRESHOLD ? ", THRESHOLD" : ", CROSSING") +
              (isNearest ? ", nearest" : "");
            ExpectTruthOf(name, scene, input);
            // The compositor knows of no caps behind hidden cells: see TestHiddenSlab.
            if (!(input.HidesCells && mode == Mapper::THRESHOLD))
            {
              SetColors(scene, colors);
              ExpectComposite(name + ", translucent", scene,
                Compositor(scene, input.Truth(scene.Volume), input.Many.data()), Width, Height);
            }
          }
        }
      }
    }
  }
}

/// Translucent solids are cut open by hidden cells as they are by cropping.
void TestHiddenSlab()
{
  constexpr int N = 17, First = 5, Last = 11;
  for (const bool shade : { false, true })
  {
    for (const int mode : { Mapper::CROSSING, Mapper::THRESHOLD })
    {
      for (const bool isClipped : { false, true })
      {
        const Image whole = Volumes::Noise(N, VTK_FLOAT, 0.0, 100.0);
        const Image slab = Volumes::Noise(N, VTK_FLOAT, 0.0, 100.0);
        Ghosts::FlagCells(slab,
          [](int i, int, int)
          { return i >= First && i < Last ? vtkDataSetAttributes::HIDDENCELL : 0; });
        Scene cropped(whole, Isovalues), hidden(slab, Isovalues);
        cropped.Mapper->CroppingOn();
        cropped.Mapper->SetCroppingRegionPlanes(
          -1.0 + First * 0.125, -1.0 + Last * 0.125, -9.0, 9.0, -9.0, 9.0);
        cropped.Mapper->SetCroppingRegionFlags(1 << 12 | 1 << 14);
        for (Scene* scene : { &cropped, &hidden })
        {
          SetColors(*scene,
            { { 30.75, 0.1, 0.3, 0.9, 0.15 }, { 50.5, 0.8, 0.3, 0.2, 0.3 },
              { 80.25, 0.2, 0.9, 0.1, 0.5 } });
          scene->Volume->GetProperty()->SetShade(shade);
          scene->Mapper->SetSurfaceMode(mode);
          if (isClipped)
          {
            Clip(scene->Mapper);
          }
          scene->LookFrom(0.9, 0.7, 0.4);
          Expect(scene->Render(Width, Height), "slab: rendered");
        }
        int different = 0, seen = 0;
        for (int y = 0; y < Height; ++y)
        {
          for (int x = 0; x < Width; ++x)
          {
            int apart = 0;
            for (int c = 0; c < 4; ++c)
            {
              apart = std::max(apart, std::abs(cropped.ColorAt(x, y)[c] - hidden.ColorAt(x, y)[c]));
            }
            different += apart > 1;
            seen += hidden.ColorAt(x, y)[3] > 0;
          }
        }
        Expect(different <= 2 && seen > Width * Height / 20,
          "slab: " + std::to_string(different) + " of " + std::to_string(seen) +
            " pixels differ in mode " + std::to_string(mode) + (shade ? ", shaded" : "") +
            (isClipped ? ", clipped" : ""));
      }
    }
  }
}

}

int TestFeaturesTogether(int, char*[])
{
  TestInputs();
  TestHiddenSlab();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
