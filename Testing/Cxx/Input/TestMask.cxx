// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// A mask hides a cell if it shows none of its samples. Pictures agree with brute force, for all
// kinds of masks and inputs.

#include "Checks/EventCounter.h"
#include "Checks/Expect.h"
#include "Scenes/Subject.h"
#include "Truth/Agreement.h"
#include "Truth/ColdWitness.h"
#include "Truth/ExpectSame.h"
#include "Truth/MaskedTruth.h"
#include "Volumes/Ghosts.h"
#include "Volumes/Grids.h"
#include "Volumes/Masks.h"
#include "Volumes/Volumes.h"
#include "Walks/Sweep.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPointData.h>
#include <vtkRectilinearGrid.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace
{

using Mapper = vtkTemporalCoherenceVolumeMapper;
using Image = vtkSmartPointer<vtkImageData>;

constexpr int N = 32; ///< samples along each axis of the waves

void TestAgainstBruteForce()
{
  const std::vector<Subject> volumes = {
    { "Waves", Volumes::Waves(), { 200.0 } },
    { "Waves", Volumes::Waves(), { 200.0, -300.0, 650.0 } },
    { "Noise", Volumes::Noise(N, VTK_DOUBLE, 0.0, 1.0), { 0.8 } },
  };
  for (const Masks::Named& named : Masks::All())
  {
    long hits = 0;
    for (Subject subject : volumes)
    {
      const Image mask = Masks::For(subject.Image, named.Value);
      for (const Sweep::Placing& placing : Sweep::AllPlacings())
      {
        for (const int way : { 0, 1, 2, 3 })
        {
          subject.Mode = way % 2 ? Mapper::THRESHOLD : Mapper::CROSSING;
          subject.IsNearest = way / 2 != 0;
          Scene scene(subject.Image, subject.Isovalues);
          subject.Prepare(scene);
          Masks::SetBinary(scene.Mapper, mask);
          placing.SetCamera(scene);
          BruteForceTracer truth(subject.Image, scene.Volume);
          truth.Isovalues = subject.Isovalues;
          truth.IsThreshold = subject.Mode == Mapper::THRESHOLD;
          Masks::Hide(mask, truth.Field);
          const std::string what = subject.Describe() + ", " + named.Name + ", " + placing.Name;
          Expect(scene.Render(60, 45), what + ": rendered");
          const Agreement agreement = CompareWithTruth(scene, truth);
          Expect(agreement.Holds(), what + ": " + agreement.Describe());
          hits += agreement.Hits;
        }
      }
    }
    Expect(hits > 10000, named.Name + ": little is seen, " + std::to_string(hits) + " hits");
  }
}

/// A mask that a threshold made at the isovalue shows all of the surface: each cell that the
/// surface passes has a sample inside.
void TestSegmentation()
{
  const Image image = Volumes::FourSpheres(40);
  vtkDataArray* samples = image->GetPointData()->GetScalars();
  const auto inside = [&](int i, int j, int k)
  { return samples->GetComponent((k * 40 + j) * 40 + i, 0) >= 100.0 ? 255 : 0; };
  Scene plain(image, { 100.0 }), masked(image, { 100.0 });
  Masks::SetBinary(masked.Mapper, Masks::For(image, inside));
  plain.LookFrom(1.0, 2.0, 0.5);
  ExpectSame("a mask made of the surface's inside", plain, masked, 120);
}

/// Values of any whole type: above 0 is shown.
void TestTypes()
{
  const Image image = Volumes::Waves();
  const Masks::ChooseValue value = Masks::Random(0.9, 3);
  const Image bytes = Masks::For(image, value);
  vtkDataArray* shown = bytes->GetPointData()->GetScalars();
  for (const int type : { VTK_CHAR, VTK_SIGNED_CHAR, VTK_SHORT, VTK_UNSIGNED_SHORT, VTK_INT,
         VTK_UNSIGNED_INT, VTK_LONG, VTK_UNSIGNED_LONG, VTK_LONG_LONG, VTK_ID_TYPE })
  {
    const bool isSigned = type == VTK_SIGNED_CHAR || type == VTK_SHORT || type == VTK_INT ||
      type == VTK_LONG || type == VTK_LONG_LONG || type == VTK_ID_TYPE;
    const Image mask = Masks::For(
      image,
      [&](int i, int j, int k)
      {
        const auto here = static_cast<int>(shown->GetComponent((k * N + j) * N + i, 0));
        return here == 0 && isSigned ? -((i + j) % 2) : here;
      },
      type);
    Scene expected(image, { 200.0 }), scene(image, { 200.0 });
    Masks::SetBinary(expected.Mapper, bytes);
    Masks::SetBinary(scene.Mapper, mask);
    expected.LookFrom(1.0, 2.0, 0.5);
    ExpectSame("a mask of type " + std::to_string(type), expected, scene, 60);
  }
}

/// Scalars of cells are masked cell by cell, by a mask on cells, found as the input's scalars are,
/// or by one on as many points.
void TestCells()
{
  const Image image = Volumes::Waves();
  const Image small = Volumes::Noise(N - 1, VTK_FLOAT, 0.0, 100.0);
  vtkDataArray* cells = small->GetPointData()->GetScalars();
  cells->SetName("of cells");
  image->GetCellData()->AddArray(cells);
  const Image onPoints = Masks::For(small, Masks::Random(0.9, 4));
  const auto onCells = Image::New();
  onCells->SetDimensions(N, N, N);
  vtkDataArray* values = onPoints->GetPointData()->GetScalars();
  for (const char* name : { "of cells", "another" })
  {
    values->SetName(name);
    onCells->GetCellData()->Initialize();
    onCells->GetCellData()->SetScalars(values);
    for (const Image& mask : { onPoints, onCells })
    {
      Scene scene(image, { 50.5 });
      scene.Mapper->SetScalarModeToUseCellFieldData();
      scene.Mapper->SelectScalarArray("of cells");
      Masks::SetBinary(scene.Mapper, mask);
      scene.LookFrom(1.0, 2.0, 0.5);
      BruteForceTracer truth(image, scene.Volume, 0, cells);
      truth.Isovalues = { 50.5 };
      Masks::Hide(onPoints, truth.Field);
      const std::string what = std::string("cells, ") + name;
      ExpectColdTruth(what, scene, truth, 80, 60);
      Ghosts::HidePoints(image, 0.01, 5);
      BruteForceTracer both(image, scene.Volume, 0, cells);
      both.Isovalues = { 50.5 };
      Masks::Hide(onPoints, both.Field);
      ExpectColdTruth(what + ", and ghosts", scene, both, 80, 60);
      Ghosts::Remove(image);
    }
  }
}

/// Grids are masked sample by sample, in the order of their arrays, whichever way they ascend.
void TestGrid()
{
  const Image image = Volumes::Waves();
  const auto grid = Grids::FromImage(image, VTK_DOUBLE);
  for (int axis = 0; axis < 3; ++axis)
  {
    std::vector<double> along = Grids::Random(N, 4.0, 7u + static_cast<unsigned>(axis));
    if (axis == 1)
    {
      std::reverse(along.begin(), along.end());
    }
    Grids::SetCoordinates(grid, axis, along);
  }
  const Image mask = Masks::For(image, [](int i, int j, int k) { return i + 2 * j + k < 60; });
  for (const int mode : { Mapper::CROSSING, Mapper::THRESHOLD })
  {
    Scene scene(grid, { 200.0 });
    scene.Mapper->SetSurfaceMode(mode);
    Masks::SetBinary(scene.Mapper, mask);
    scene.LookFrom(1.0, 2.0, 0.5);
    BruteForceTracer truth(grid.Get(), scene.Volume);
    truth.Isovalues = { 200.0 };
    truth.IsThreshold = mode == Mapper::THRESHOLD;
    Masks::Hide(mask, truth.Field);
    ExpectColdTruth("a grid with a mask", scene, truth, 80, 60);
  }
}

void SetLabelOpacity(Scene& scene, int label, double atLow, double atHigh)
{
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(-1000.0, atLow);
  opacity->AddPoint(1000.0, atHigh);
  scene.Volume->GetProperty()->SetLabelScalarOpacity(label, opacity);
}

/// Of label maps, labels are hidden whose own opacity is 0. All else of them has no effect.
void TestLabels()
{
  const Image image = Volumes::Waves();
  const Image labels = Masks::For(image, [](int i, int j, int) { return i / 8 + 4 * (j / 16); });
  for (const int type : { VTK_UNSIGNED_CHAR, VTK_INT })
  {
    Scene scene(image, { 200.0 });
    scene.LookFrom(1.0, 2.0, 0.5);
    const Image mask = Masks::For(
      image, [](int i, int j, int) { return i / 8 + 4 * (j / 16); }, type);
    scene.Mapper->SetMaskInput(mask); // a label map: VTK's default
    const auto expectHidden = [&](const std::string& what, const std::vector<double>& hidden)
    {
      BruteForceTracer truth(image, scene.Volume);
      truth.Isovalues = { 200.0 };
      Masks::Hide(
        labels,
        [&](double label)
        { return std::find(hidden.begin(), hidden.end(), label) == hidden.end(); },
        truth.Field);
      // From whatever the last frame has left.
      Expect(scene.Render(80, 60), "labels, " + what + ": rendered");
      const Agreement agreement = CompareWithTruth(scene, truth);
      Expect(
        agreement.Holds() && agreement.Hits > 800, "labels, " + what + ": " + agreement.Describe());
    };
    expectHidden("without functions", {});
    SetLabelOpacity(scene, 2, 0.0, 0.0);
    expectHidden("one", { 2.0 });
    SetLabelOpacity(scene, 5, -1.0, -0.5);
    SetLabelOpacity(scene, 1, 0.2, 0.6);
    SetLabelOpacity(scene, 300, 0.0, 0.0);
    vtkNew<vtkColorTransferFunction> red;
    red->AddRGBPoint(0.0, 1.0, 0.0, 0.0);
    scene.Volume->GetProperty()->SetLabelColor(3, red);
    expectHidden("two, others shown", { 2.0, 5.0 });
    Expect(scene.Render(80, 60) && IsRoute(scene, "Redisplay"), "nothing changed");
    scene.Mapper->SetMaskBlendFactor(0.5f);
    expectHidden("half a label's own", {});
    scene.SetIsovalues({ 201.0 });
    Expect(
      scene.Render(80, 60) && IsRoute(scene, "IsomapBuild"), "what hides nothing costs nothing");
    scene.SetIsovalues({ 200.0 });
    scene.Mapper->SetMaskBlendFactor(1.0f);
    SetLabelOpacity(scene, 2, 1.0, 1.0);
    expectHidden("one is shown again", { 5.0 });
    scene.Mapper->SetMaskTypeToBinary();
    expectHidden("as a binary mask", { 0.0 });
    scene.Mapper->SetMaskTypeToLabelMap();
    expectHidden("as labels again", { 5.0 });

    // 0 at one isovalue and not at another: no picture could be right.
    SetLabelOpacity(scene, 4, 0.0, 1.0);
    scene.SetIsovalues({ 200.0, -1200.0 });
    const EventCounter errors(scene.Mapper, vtkCommand::ErrorEvent);
    Expect(!scene.Render(80, 60) && !scene.Render(80, 60) && errors.Count == 1,
      "half hidden: " + std::to_string(errors.Count) + " errors");
    SetLabelOpacity(scene, 4, std::nan(""), 1.0);
    Expect(!scene.Render(80, 60) && errors.Count == 2, "an opacity that is no number");
    scene.SetIsovalues({ 200.0 });
    SetLabelOpacity(scene, 4, 1.0, 1.0);
    expectHidden("after a mistake", { 5.0 });
  }
}

}

int TestMask(int, char*[])
{
  TestAgainstBruteForce();
  TestSegmentation();
  TestTypes();
  TestCells();
  TestGrid();
  TestLabels();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
