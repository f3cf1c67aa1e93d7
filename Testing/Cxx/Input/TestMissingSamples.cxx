// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Samples that are not numbers hide their cells, as flags do, on every kind of data.

#include "Checks/Expect.h"
#include "MissingSamples.h"
#include "Scenes/Subject.h"
#include "Truth/Agreement.h"
#include "Truth/ExpectSame.h"
#include "Volumes/Ghosts.h"
#include "Volumes/Volumes.h"

#include <vtkCellData.h>
#include <vtkDataSetAttributes.h>
#include <vtkExtractVOI.h>
#include <vtkFloatArray.h>
#include <vtkFloatingPointExceptions.h>
#include <vtkMath.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPointData.h>
#include <vtkRectilinearGrid.h>
#include <vtkUnsignedCharArray.h>

#include <cmath>
#include <cstdlib>
#include <string>

namespace
{

using namespace MissingSamples;
using Attributes = vtkDataSetAttributes;
using Mapper = vtkTemporalCoherenceVolumeMapper;

/// Two scenes show surfaces at the same places, to the last bit.
void ExpectSameDepths(const std::string& what, Scene& scene, Scene& reference)
{
  reference.Renderer->SetActiveCamera(scene.Renderer->GetActiveCamera());
  Expect(scene.Render(90, 70) && reference.Render(90, 70), what + ": not rendered");
  Expect(AreIdentical(scene.Depth, reference.Depth), what + ": other depths");
  int hits = 0;
  for (int pixel = 0; pixel < 90 * 70; ++pixel)
  {
    hits += !std::isinf(scene.DepthAt(pixel % 90, pixel / 90));
  }
  Expect(hits > 100, what + ": nothing is seen");
}

/// Picks trace rays by themselves, and meet what pixels show.
void ExpectSamePicks(const std::string& what, Scene& scene)
{
  double eye[3];
  scene.Renderer->GetActiveCamera()->GetPosition(eye);
  for (int y = 5; y < 70; y += 20)
  {
    for (int x = 5; x < 90; x += 20)
    {
      double pixel[3], end[3], at[3], t = 0.0;
      int isovalue = -1;
      if (!scene.Mapper->PickPixel(x, y, pixel, nullptr, nullptr))
      {
        continue;
      }
      for (int axis = 0; axis < 3; ++axis)
      {
        end[axis] = eye[axis] + 2.0 * (pixel[axis] - eye[axis]);
      }
      Expect(scene.Mapper->IntersectWithLine(scene.Volume, eye, end, t, at, nullptr, &isovalue) &&
          vtkMath::Distance2BetweenPoints(at, pixel) < 1e-10,
        what + ": a line meets something else");
    }
  }
}

/// Missing samples look as blanked points, but for normals beside them in images, which blanked
/// samples still serve.
void TestAsBlanked()
{
  for (const Sort& sort : AllSorts())
  {
    for (const auto& [name, isMissing] : AllMissing())
    {
      for (const int mode : { Mapper::CROSSING, Mapper::THRESHOLD })
      {
        for (const bool isNearest : { false, true })
        {
          const int type = isNearest ? VTK_FLOAT : VTK_DOUBLE;
          const std::string what = sort.Name + ", " + name + ", mode " + std::to_string(mode) +
            (isNearest ? ", nearest" : "");
          Scene scene(sort.Of(WithHoles(type, isMissing)), { 55.0, 30.0 });
          Scene reference(sort.Of(Blanked(type, isMissing)), { 55.0, 30.0 });
          for (Scene* each : { &scene, &reference })
          {
            each->Mapper->SetSurfaceMode(mode);
            each->Volume->GetProperty()->SetInterpolationType(isNearest);
          }
          scene.LookFrom(1.0, 0.5, 0.7);
          ExpectSameDepths(what, scene, reference);
          if (sort.IsMesh)
          {
            Expect(AreIdentical(scene.Color, reference.Color), what + ": other colours");
          }
          ExpectSamePicks(what, scene);
        }
      }
    }
  }
}

void TestAgainstBruteForce()
{
  for (const auto& [name, isMissing] : AllMissing())
  {
    for (const int type : { VTK_FLOAT, VTK_DOUBLE })
    {
      for (const int mode : { Mapper::CROSSING, Mapper::THRESHOLD })
      {
        for (const bool isNearest : { false, true })
        {
          const Subject subject = { name, WithHoles(type, isMissing), { 55.0, 30.0 }, mode,
            isNearest };
          Scene scene(subject.Image, subject.Isovalues);
          subject.Prepare(scene);
          scene.LookFrom(0.3, -1.0, 0.6);
          BruteForceTracer truth(subject.Image, scene.Volume);
          truth.Isovalues = subject.Isovalues;
          truth.IsThreshold = mode == Mapper::THRESHOLD;
          ExpectColdTruth(subject.Describe(), scene, truth, 90, 70);
        }
      }
    }
  }
}

/// Normals beside missing samples are those of one-sided differences.
void TestNormals()
{
  for (const bool isGrid : { false, true })
  {
    for (const bool isNearest : { false, true })
    {
      for (const auto& [name, isMissing] : AllMissing())
      {
        Subject subject = { "normals, " + name, WithHoles(VTK_FLOAT, isMissing), { 55.0 } };
        subject.IsNearest = isNearest;
        subject.IsGrid = isGrid;
        Scene scene(subject.Image, subject.Isovalues);
        subject.Prepare(scene);
        scene.LookFrom(0.3, -1.0, 0.6);
        Expect(scene.Render(120, 90), subject.Describe() + ": rendered");
        auto* grid = vtkRectilinearGrid::SafeDownCast(scene.Mapper->GetDataObjectInput());
        const BruteForceTracer truth = grid ? BruteForceTracer(grid, scene.Volume)
                                            : BruteForceTracer(subject.Image, scene.Volume);
        int hits = 0, wrong = 0;
        for (int pixel = 0; pixel < 120 * 90; ++pixel)
        {
          double at[3], normal[3];
          if (scene.Mapper->PickPixel(pixel % 120, pixel / 120, at, normal, nullptr))
          {
            ++hits;
            // With nearest interpolation, a normal is that of a sample.
            const auto expected = truth.Field.WorldNormalAt({ at[0], at[1], at[2] });
            const double cosine = std::abs(vtkMath::Dot(normal, expected.data()));
            wrong += isNearest ? !(std::abs(vtkMath::Norm(normal) - 1.0) < 1e-5 && cosine > 0.5)
                               : !(cosine > 0.999);
          }
        }
        Expect(hits > 500 && wrong <= (isNearest ? hits / 20 : 0),
          subject.Describe() + ": " + std::to_string(wrong) + " of " + std::to_string(hits) +
            " normals are wrong");
      }
    }
  }
}

/// Scalars of cells: a cell without a value is hidden as a blanked cell is.
void TestCells()
{
  const Image whole = Volumes::FromFormula(N, VTK_FLOAT, Waves);
  const auto isMissing = [](int i) { return i % 31 == 7 || (i > 3000 && i < 3400); };
  const auto valuesOf = [&](bool hasNaN)
  {
    vtkNew<vtkFloatArray> values;
    values->SetName("of cells");
    for (int i = 0; i < (N - 1) * (N - 1) * (N - 1); ++i)
    {
      const int point = (i / (N - 1) / (N - 1) * N + i / (N - 1) % (N - 1)) * N + i % (N - 1);
      const double value = whole->GetPointData()->GetScalars()->GetComponent(point, 0);
      values->InsertNextValue(static_cast<float>(hasNaN && isMissing(i) ? NaN : value));
    }
    Image image = Image::New();
    image->CopyStructure(whole);
    image->GetCellData()->SetScalars(values);
    return image;
  };
  for (const Sort& sort : AllSorts())
  {
    const Image holes = valuesOf(true), blanked = valuesOf(false);
    int cell = 0;
    Ghosts::FlagCells(
      blanked, [&](int, int, int) { return isMissing(cell++) ? Attributes::HIDDENCELL : 0; });
    for (const int mode : { Mapper::CROSSING, Mapper::THRESHOLD })
    {
      Scene scene(sort.Of(holes), { 55.0 }), reference(sort.Of(blanked), { 55.0 });
      scene.Mapper->SetSurfaceMode(mode);
      reference.Mapper->SetSurfaceMode(mode);
      scene.LookFrom(1.0, 0.5, 0.7);
      const std::string what = "cells, " + sort.Name + ", mode " + std::to_string(mode);
      ExpectSameDepths(what, scene, reference);
      if (sort.IsMesh)
      {
        Expect(AreIdentical(scene.Color, reference.Color), what + ": other colours");
      }
    }
  }
}

/// Of several components, those count that are used.
void TestComponents()
{
  const Missing isMissing = AllMissing()[1].second;
  const Image one = WithHoles(VTK_FLOAT, isMissing),
              all = WithHoles(VTK_FLOAT, [](int, int, int) { return false; });
  vtkNew<vtkFloatArray> both;
  both->SetName("both");
  both->SetNumberOfComponents(2);
  for (vtkIdType i = 0; i < one->GetNumberOfPoints(); ++i)
  {
    both->InsertNextTuple2(all->GetPointData()->GetScalars()->GetComponent(i, 0),
      one->GetPointData()->GetScalars()->GetComponent(i, 0));
  }
  const Image image = Image::New();
  image->CopyStructure(one);
  image->GetPointData()->SetScalars(both);
  Scene scene(image, { 55.0 });
  scene.Mapper->SetVectorModeToComponent();
  scene.LookFrom(1.0, 0.5, 0.7);
  for (const int component : { 0, 1 })
  {
    scene.Mapper->SetVectorComponent(component);
    Scene reference(component == 0 ? all : one, { 55.0 });
    ExpectSame("component " + std::to_string(component), scene, reference, 70);
  }
  scene.Mapper->SetVectorModeToMagnitude();
  scene.SetIsovalues({ 80.0 });
  Image blanked = Image::New();
  blanked->DeepCopy(image);
  auto* flagged = vtkFloatArray::SafeDownCast(blanked->GetPointData()->GetScalars());
  for (vtkIdType i = 0; i < blanked->GetNumberOfPoints(); ++i)
  {
    flagged->SetComponent(i, 1, all->GetPointData()->GetScalars()->GetComponent(i, 0));
  }
  Ghosts::FlagPoints(
    blanked, [&](int i, int j, int k) { return isMissing(i, j, k) ? Attributes::HIDDENPOINT : 0; });
  Scene reference(blanked, { 80.0 });
  reference.Mapper->SetVectorModeToMagnitude();
  ExpectSameDepths("magnitude", scene, reference);
}

/// Blocks that share missing samples, as one.
void TestBlocks()
{
  const Image whole = WithHoles(VTK_DOUBLE, AllMissing()[1].second);
  vtkNew<vtkMultiBlockDataSet> blocks;
  for (unsigned int block = 0; block < 2; ++block)
  {
    vtkNew<vtkExtractVOI> extract;
    extract->SetInputData(whole);
    extract->SetVOI(block == 0 ? 0 : 10, block == 0 ? 10 : N - 1, 0, N - 1, 0, N - 1);
    extract->Update();
    vtkNew<vtkImageData> part;
    part->ShallowCopy(extract->GetOutput());
    blocks->SetBlock(block, part);
  }
  Scene reference(whole, { 55.0 }), scene(nullptr, { 55.0 });
  scene.Mapper->SetInputDataObject(blocks);
  reference.LookFrom(1.0, 0.5, 0.7);
  scene.Renderer->SetActiveCamera(reference.Renderer->GetActiveCamera());
  ExpectSame("blocks", scene, reference, 70);
}

/// Blended volumes leave the same cells out.
void TestBlended()
{
  for (const int mode : { vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND,
         vtkVolumeMapper::MINIMUM_INTENSITY_BLEND, vtkVolumeMapper::AVERAGE_INTENSITY_BLEND,
         vtkVolumeMapper::ADDITIVE_BLEND, vtkVolumeMapper::COMPOSITE_BLEND })
  {
    for (const auto& [name, isMissing] : AllMissing())
    {
      Scene scene(WithHoles(VTK_FLOAT, isMissing), {});
      Scene reference(Blanked(VTK_FLOAT, isMissing), {});
      for (Scene* each : { &scene, &reference })
      {
        each->Mapper->SetBlendMode(mode);
        each->Volume->GetProperty()->ShadeOff(); // blanked samples still serve gradients
        each->Volume->GetProperty()->GetScalarOpacity()->AddPoint(0.0, 0.01);
        each->Volume->GetProperty()->GetScalarOpacity()->AddPoint(100.0, 0.5);
        each->Volume->GetProperty()->GetRGBTransferFunction()->AddRGBPoint(0.0, 0.0, 0.2, 1.0);
        each->Volume->GetProperty()->GetRGBTransferFunction()->AddRGBPoint(100.0, 1.0, 0.8, 0.0);
      }
      scene.LookFrom(1.0, 0.5, 0.7);
      reference.Renderer->SetActiveCamera(scene.Renderer->GetActiveCamera());
      const std::string what = "blend mode " + std::to_string(mode) + ", " + name;
      Expect(scene.Render(70, 60) && reference.Render(70, 60), what + ": rendered");
      int farthest = 0;
      for (int pixel = 0; pixel < 4 * 70 * 60; ++pixel)
      {
        const int at = pixel / 4;
        farthest = std::max(farthest,
          std::abs(static_cast<int>(scene.ColorAt(at % 70, at / 70)[pixel % 4]) -
            static_cast<int>(reference.ColorAt(at % 70, at / 70)[pixel % 4])));
      }
      Expect(farthest <= 1, what + ": colours differ by " + std::to_string(farthest));
    }
  }
}

}

int TestMissingSamples(int, char*[])
{
  // The Debug driver traps operations on what is not a number, which is what is tested here.
  vtkFloatingPointExceptions::Disable();
  TestAsBlanked();
  TestAgainstBruteForce();
  TestNormals();
  TestCells();
  TestComponents();
  TestBlocks();
  TestBlended();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
