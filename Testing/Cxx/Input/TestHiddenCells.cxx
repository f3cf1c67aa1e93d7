// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Cells that ghost arrays hide: compared with brute force, by all routes, as they change.

#include "Checks/EventCounter.h"
#include "Checks/Expect.h"
#include "Scenes/Subject.h"
#include "Truth/Agreement.h"
#include "Truth/ExpectSame.h"
#include "Volumes/Ghosts.h"
#include "Volumes/Volumes.h"
#include "Walks/RandomChanges.h"
#include "Walks/Sweep.h"

#include <vtkCellData.h>
#include <vtkDataSetAttributes.h>
#include <vtkPointData.h>
#include <vtkPointDataToCellData.h>
#include <vtkRTAnalyticSource.h>
#include <vtkSMPTools.h>
#include <vtkUniformGrid.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cstdlib>
#include <functional>

namespace
{

using Attributes = vtkDataSetAttributes;
using Mapper = vtkTemporalCoherenceVolumeMapper;

/// A way to hide something of an image.
struct Hiding
{
  std::string Name;
  std::function<void(vtkImageData*)> Hide;
};

std::vector<Hiding> AllHidings()
{
  const auto hiddenIf = [](bool isHidden) { return isHidden ? Attributes::HIDDENCELL : 0; };
  return {
    { "half",
      [=](vtkImageData* image)
      { Ghosts::FlagCells(image, [=](int i, int, int) { return hiddenIf(i < 13); }); } },
    { "checkerboard of cells",
      [=](vtkImageData* image)
      {
        Ghosts::FlagCells(
          image, [=](int i, int j, int k) { return hiddenIf((i + j + k) % 2 == 0); });
      } },
    { "checkerboard of blocks",
      [=](vtkImageData* image)
      {
        Ghosts::FlagCells(
          image, [=](int i, int j, int k) { return hiddenIf((i / 5 + j / 5 + k / 5) % 2 == 0); });
      } },
    { "a third of the cells", [](vtkImageData* image) { Ghosts::HideCells(image, 0.33, 3); } },
    { "nearly all cells", [](vtkImageData* image) { Ghosts::HideCells(image, 0.9, 4); } },
    { "some points", [](vtkImageData* image) { Ghosts::HidePoints(image, 0.04, 5); } },
    { "cells and points",
      [](vtkImageData* image)
      {
        Ghosts::HideCells(image, 0.1, 6);
        Ghosts::HidePoints(image, 0.01, 7);
      } },
  };
}

/// Pictures of the walk that leaps and of the one that does not, by some numbers of threads.
void ExpectOnePicture(Scene& scene, const std::string& what)
{
  ColdWitness cold;
  const std::string backend = vtkSMPTools::GetBackend();
  vtkSMPTools::SetBackend("STDThread");
  for (const int threads : { 1, 5 })
  {
    vtkSMPTools::Initialize(threads);
    for (const bool leaps : { true, false })
    {
      cold.Mapper->SetSpaceLeaping(leaps);
      cold.Mapper->SetSurfaceMode(scene.Mapper->GetSurfaceMode());
      Expect(cold.Draw(scene) && cold.IsIdentical(scene),
        what + ": another picture by " + std::to_string(threads) + " thread(s)" +
          (leaps ? "" : " without leaping"));
    }
  }
  vtkSMPTools::Initialize(0);
  vtkSMPTools::SetBackend(backend.c_str());
}

void TestAgainstBruteForce(const Subject& subject, int width, int height)
{
  for (const Sweep::Placing& placing : Sweep::AllPlacings())
  {
    for (const int mode : { Mapper::CROSSING, Mapper::THRESHOLD })
    {
      for (const bool isNearest : { false, true })
      {
        Subject here = subject;
        here.Mode = mode;
        here.IsNearest = isNearest;
        Scene scene(here.Image, here.Isovalues);
        here.Prepare(scene);
        placing.SetCamera(scene);
        BruteForceTracer truth(here.Image, scene.Volume);
        truth.Isovalues = here.Isovalues;
        truth.IsThreshold = mode == Mapper::THRESHOLD;
        const std::string what = here.Describe() + ", " + placing.Name;
        ExpectColdTruth(what, scene, truth, width, height);
        ExpectOnePicture(scene, what);
      }
    }
  }
}

void TestCold()
{
  const std::vector<Subject> volumes = {
    { "Waves", Volumes::Waves(), { 200.0 } },
    { "Waves", Volumes::Waves(), { 200.0, -300.0, 650.0 } },
    { "Noise", Volumes::Noise(27, VTK_DOUBLE, 0.0, 1.0), { 0.8 } },
  };
  for (const Hiding& hiding : AllHidings())
  {
    for (const Subject& volume : volumes)
    {
      Subject subject = volume;
      subject.Image = vtkSmartPointer<vtkImageData>::New();
      subject.Image->DeepCopy(volume.Image);
      subject.Name += " without " + hiding.Name;
      hiding.Hide(subject.Image);
      TestAgainstBruteForce(subject, 60, 45);
    }
  }
}

/// Flag a block of cells and one of points as VTK's tests of ghost arrays do.
/// \param flagOf gets i and k of a cell in its block
void FlagBlocks(vtkImageData* image, const std::function<int(int, int)>& flagOf)
{
  const auto isInBlock = [](int j) { return j >= 15 && j < 47; };
  Ghosts::FlagCells(image,
    [&](int i, int j, int k) { return isInBlock(j) && i >= 21 && i < 42 ? flagOf(i, k) : 0; });
  Ghosts::FlagPoints(image,
    [&](int i, int j, int k)
    {
      const int flag = j > 31 ? Attributes::DUPLICATEPOINT : Attributes::HIDDENPOINT;
      return isInBlock(j) && k < 31 && i >= 48 ? flag : 0;
    });
}

/// The scene of VTK's TestGPURayCastVolumeGhostArrays, a quarter as large.
vtkSmartPointer<vtkImageData> WaveletWithGhosts()
{
  vtkNew<vtkRTAnalyticSource> wavelet;
  wavelet->SetWholeExtent(-31, 32, -31, 32, -31, 32);
  wavelet->SetCenter(0.0, 0.0, 0.0);
  wavelet->Update();
  vtkSmartPointer<vtkImageData> image = wavelet->GetOutput();
  FlagBlocks(image,
    [](int i, int k)
    {
      const int flag = i > 31 ? Attributes::DUPLICATECELL : Attributes::HIDDENCELL;
      return k > 31 ? Attributes::REFINEDCELL : flag;
    });
  return image;
}

/// That of TestGPURayCastVolumeUniformGridBlanking.
vtkSmartPointer<vtkImageData> BlankedGrid()
{
  vtkNew<vtkRTAnalyticSource> wavelet;
  wavelet->SetWholeExtent(-31, 32, -31, 32, -31, 32);
  wavelet->Update();
  vtkNew<vtkUniformGrid> grid;
  grid->ShallowCopy(wavelet->GetOutput());
  for (int k = 0; k < 16; ++k)
  {
    for (int j = 15; j < 47; ++j)
    {
      for (int i = 21; i < 42; ++i)
      {
        grid->BlankCell(i, j, k);
      }
      for (int i = 48; i < 64; ++i)
      {
        grid->BlankPoint(i, j, k);
      }
    }
  }
  return grid;
}

/// That of TestGPURayCastVolumeGhostArraysCellData.
vtkSmartPointer<vtkImageData> CellsWithGhosts()
{
  vtkNew<vtkRTAnalyticSource> wavelet;
  wavelet->SetWholeExtent(-31, 32, -31, 32, -31, 32);
  wavelet->SetCenter(0.0, 0.0, 0.0);
  vtkNew<vtkPointDataToCellData> toCells;
  toCells->SetInputConnection(wavelet->GetOutputPort());
  toCells->Update();
  vtkSmartPointer<vtkImageData> image = toCells->GetImageDataOutput();
  FlagBlocks(image,
    [](int i, int k)
    {
      const int flag = i > 31 && k < 31 ? Attributes::DUPLICATECELL : Attributes::HIDDENCELL;
      return k > 31 ? Attributes::REFINEDCELL : flag;
    });
  return image;
}

/// Scalars of cells: what is another piece's is hidden as what is hidden itself.
void TestDuplicateCells()
{
  const vtkSmartPointer<vtkImageData> image = CellsWithGhosts();
  vtkNew<vtkImageData> hidden;
  hidden->DeepCopy(image);
  auto* flags = vtkUnsignedCharArray::SafeDownCast(
    hidden->GetCellData()->GetArray(Attributes::GhostArrayName()));
  for (vtkIdType i = 0; i < flags->GetNumberOfTuples(); ++i)
  {
    flags->SetValue(i, flags->GetValue(i) ? Attributes::HIDDENCELL : 0);
  }
  for (const int mode : { Mapper::CROSSING, Mapper::THRESHOLD })
  {
    for (const bool isNearest : { false, true })
    {
      const Subject subject = { "cells with ghosts", image, { 157.0, 100.0 }, mode, isNearest };
      Scene scene(image, subject.Isovalues), reference(hidden, subject.Isovalues);
      subject.Prepare(scene);
      subject.Prepare(reference);
      scene.LookFrom(0.1, -0.2, -1.0); // on the side with duplicates
      BruteForceTracer truth(image, scene.Volume, 0, image->GetCellData()->GetScalars());
      truth.Isovalues = subject.Isovalues;
      truth.IsThreshold = mode == Mapper::THRESHOLD;
      const std::string what = subject.Describe();
      ExpectColdTruth(what, scene, truth, 90, 70);
      ExpectSame(what + ", duplicate or hidden", scene, reference, 90);
    }
  }
}

void TestScenesOfVtk()
{
  TestAgainstBruteForce({ "wavelet with ghosts", WaveletWithGhosts(), { 157.0, 100.0 } }, 90, 70);
  TestAgainstBruteForce({ "blanked grid", BlankedGrid(), { 157.0 } }, 90, 70);
}

/// The cap of a solid in which a block is hidden has the normals of the block's faces.
void TestNormals()
{
  vtkSmartPointer<vtkImageData> image =
    Volumes::FromFormula(21, VTK_FLOAT, [](double, double, double) { return 1.0; });
  // All but the middle is hidden: what is left is a cube of [-0.5, 0.5]^3.
  Ghosts::FlagCells(image,
    [](int i, int j, int k)
    {
      const bool isInside = std::min({ i, j, k }) >= 5 && std::max({ i, j, k }) < 15;
      return isInside ? 0 : Attributes::HIDDENCELL;
    });
  Scene scene(image, { 0.5 });
  scene.Mapper->SetSurfaceModeToThreshold();
  scene.LookFrom(1.0, 2.0, 0.7);
  Expect(scene.Render(200, 200), "a cube: rendered");
  int faces[3] = { 0, 0, 0 };
  for (int y = 0; y < 200; ++y)
  {
    for (int x = 0; x < 200; ++x)
    {
      double at[3], normal[3];
      if (scene.Mapper->PickPixel(x, y, at, normal, nullptr))
      {
        const int axis = at[0] > 0.5 - 1e-9 ? 0 : (at[1] > 0.5 - 1e-9 ? 1 : 2);
        ++faces[axis];
        Expect(std::abs(at[axis] - 0.5) < 1e-6 && normal[axis] > 1.0 - 1e-6,
          "a cube: no normal of its face");
      }
    }
  }
  Expect(std::min({ faces[0], faces[1], faces[2] }) > 500, "a cube: three faces are seen");

  scene.Mapper->SetSurfaceModeToCrossing();
  Expect(scene.Render(200, 200) && !scene.Mapper->PickPixel(100, 100, nullptr, nullptr, nullptr),
    "a cube: open, there is no surface");
}

void TestNothingHidden()
{
  vtkSmartPointer<vtkImageData> image = Volumes::Waves();
  Scene scene(image, { 200.0 });
  scene.LookFrom(1.0, 2.0, 0.5);
  Expect(scene.Render(80, 60), "no ghosts: rendered");
  vtkNew<vtkImageData> color;
  color->DeepCopy(scene.Color);
  Ghosts::FlagCells(image, [](int, int, int) { return Attributes::EXTERIORCELL; });
  Ghosts::FlagPoints(image, [](int, int, int) { return Attributes::DUPLICATEPOINT; });
  Expect(scene.Render(80, 60) && AreIdentical(color, scene.Color),
    "flags that hide nothing: another picture");
  scene.SetIsovalues({ 210.0 });
  Expect(scene.Render(80, 60) && IsRoute(scene, "IsomapBuild"),
    "flags that hide nothing: the route is " +
      std::string(scene.Mapper->GetStatistics()->GetRouteAsString()));

  Ghosts::FlagCells(image, [](int, int, int) { return Attributes::HIDDENCELL; });
  for (const int mode : { Mapper::CROSSING, Mapper::THRESHOLD })
  {
    scene.Mapper->SetSurfaceMode(mode);
    Expect(scene.Render(80, 60), "all hidden: rendered");
    Expect(
      !scene.Mapper->PickPixel(40, 30, nullptr, nullptr, nullptr), "all hidden: something is seen");
  }
  Expect(scene.Mapper->BuildIsomap(scene.Renderer, scene.Volume), "all hidden: no isomap");
  Expect(scene.Render(80, 60) && !scene.Mapper->PickPixel(40, 30, nullptr, nullptr, nullptr),
    "all hidden: the isomap shows something");
}

/// Whatever becomes of ghost arrays is seen in the next frame.
void TestChanges()
{
  vtkSmartPointer<vtkImageData> image = Volumes::Waves();
  Scene scene(image, { 200.0 });
  scene.LookFrom(1.0, 2.0, 0.5);
  const auto expectChange = [&](const std::string& what)
  {
    Expect(scene.Render(80, 60) && IsRoute(scene, "Cold"),
      what + ": the route is " + scene.Mapper->GetStatistics()->GetRouteAsString());
    BruteForceTracer truth(image, scene.Volume);
    truth.Isovalues = { 200.0 };
    const Agreement agreement = CompareWithTruth(scene, truth);
    Expect(
      agreement.Hits > 100 && agreement.DifferentHits == 0, what + ": " + agreement.Describe());
    Expect(scene.Render(80, 60) && IsRoute(scene, "Redisplay"), what + ": again");
  };
  expectChange("no ghosts");
  Ghosts::HideCells(image, 0.3, 1);
  expectChange("added to cells");
  auto* ghosts = vtkUnsignedCharArray::SafeDownCast(
    image->GetCellData()->GetArray(Attributes::GhostArrayName()));
  for (vtkIdType i = 0; i < 15000; ++i)
  {
    ghosts->SetValue(i, Attributes::HIDDENCELL);
  }
  ghosts->Modified();
  expectChange("changed");
  Ghosts::HidePoints(image, 0.05, 2);
  expectChange("added to points");
  Ghosts::HideCells(image, 0.2, 3);
  expectChange("replaced");
  image->GetCellData()->RemoveArray(Attributes::GhostArrayName());
  expectChange("removed from cells");
  image->GetPointData()->RemoveArray(Attributes::GhostArrayName());
  expectChange("removed");
}

void TestMistakes()
{
  vtkSmartPointer<vtkImageData> image = Volumes::Waves();
  Scene scene(image, { 200.0 });
  scene.LookFrom(1.0, 2.0, 0.5);
  Expect(scene.Render(80, 60), "before an error: rendered");
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(Attributes::GhostArrayName());
  ghosts->SetNumberOfTuples(7);
  ghosts->FillValue(0);
  image->GetCellData()->AddArray(ghosts);
  const EventCounter errors(scene.Mapper, vtkCommand::ErrorEvent);
  Expect(!scene.Render(80, 60) && !scene.Render(80, 60), "too few flags: rendered");
  Expect(errors.Count == 1, "too few flags: " + std::to_string(errors.Count) + " errors");
  Expect(scene.Mapper->PickPixel(40, 30, nullptr, nullptr, nullptr), "the last picture stays");
  image->GetCellData()->RemoveArray(Attributes::GhostArrayName());
  Expect(scene.Render(80, 60), "after an error: rendered");
}

/// Isovalues that change: the picture is the cold one.
void TestSweeps()
{
  for (const Hiding& hiding : AllHidings())
  {
    for (const int mode : { Mapper::CROSSING, Mapper::THRESHOLD })
    {
      for (const bool isNearest : { false, true })
      {
        Subject subject = { "Waves without " + hiding.Name, Volumes::Waves(), {}, mode, isNearest };
        hiding.Hide(subject.Image);
        const std::vector<Sweep::Placing> placings = Sweep::AllPlacings();
        for (const std::size_t place : { 0u, 1u, 3u })
        {
          const Sweep::Placing& placing = placings[place];
          const std::string what = subject.Describe() + ", " + placing.Name;
          Scene scene(subject.Image, {});
          subject.Prepare(scene);
          placing.SetCamera(scene);
          Sweep::Routes routes =
            Sweep::ExpectCold(scene, Sweep::Up(subject, 12), 60, 45, what + ", up");
          const std::vector<double> samples = Sweep::FiniteSamplesOf(subject);
          const auto [low, high] = std::minmax_element(samples.begin(), samples.end());
          scene.Mapper->SetIsomapRange(*low, *high);
          for (const auto& [route, count] :
            Sweep::ExpectCold(scene, Sweep::Jumps(subject, 20, 5), 60, 45, what + ", jumps"))
          {
            routes[route] += count;
          }
          Expect(routes["IsomapBuild"] > 0 && routes["IsomapLookup"] > 0, what + ": no isomap");
        }
      }
    }
  }
}

/// Changes of all kinds in random order, of ghost arrays among them.
void TestRandomChanges(unsigned seed, int steps)
{
  vtkSmartPointer<vtkImageData> image = Volumes::Waves();
  Scene scene(image, { 0.0 });
  RandomViews views(scene, seed, 80);
  const EventCounter warnings(scene.Mapper, vtkCommand::WarningEvent);
  Ghosts::HideCells(image, 0.3, seed);
  std::vector<KindOfChange> kinds = KindsOfChange(scene, image, views);
  kinds.emplace_back(1, ChangesOfGhosts(image, views));
  const std::string what = "random changes, seed " + std::to_string(seed);
  Sweep::Tell(what, Wander(scene, views, kinds, what, steps));
}

}

int TestHiddenCells(int, char*[])
{
  TestCold();
  TestScenesOfVtk();
  TestDuplicateCells();
  TestNormals();
  TestNothingHidden();
  TestChanges();
  TestMistakes();
  TestSweeps();
  for (const unsigned seed : { 3u, 4u })
  {
    TestRandomChanges(seed, 600);
  }
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
