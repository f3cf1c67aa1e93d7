// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Isovalues that no sample can meet get one warning with range and remedy, where the mapper knows
// all of the data. Nothing else gets one.

#include "Checks/EventCounter.h"
#include "Checks/Expect.h"
#include "Scenes/OffScreen.h"
#include "Truth/ImageBlocks.h"

#include <vtkContourValues.h>
#include <vtkDataSetAttributes.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkPiecewiseFunction.h>
#include <vtkRTAnalyticSource.h>
#include <vtkRenderWindow.h>
#include <vtkTestErrorObserver.h>
#include <vtkTrivialProducer.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iomanip>
#include <limits>
#include <sstream>

namespace
{

using namespace ImageBlocks;
using Mapper = vtkTemporalCoherenceVolumeMapper;

/// The samples of Whole() are from 5 to 95; this is 10 higher.
Image Raised(int type = VTK_FLOAT)
{
  return Volumes::FromFormula(
    N, type, [](double x, double y, double z) { return Waves(x, y, z) + 10.0; });
}

/// Warnings of a scene's frames; no frame has an error.
class Listener
{
public:
  explicit Listener(Scene& scene)
    : Of(scene)
  {
    scene.Mapper->AddObserver(vtkCommand::WarningEvent, this->Observer);
    scene.Mapper->AddObserver(vtkCommand::ErrorEvent, this->Observer);
  }

  /// True if a frame comes with a warning.
  bool Warns(const std::string& what)
  {
    Expect(this->Of.Render(40, 30), what + ": rendered");
    Expect(!this->Observer->GetError(), what + ": " + this->Observer->GetErrorMessage());
    const bool isThere = this->Observer->GetWarning();
    this->Message = isThere ? this->Observer->GetWarningMessage() : "";
    this->Observer->Clear();
    return isThere;
  }

  std::string Message;

private:
  Scene& Of;
  vtkNew<vtkTest::ErrorObserver> Observer;
};

void ExpectOne(const std::string& what, Scene& scene)
{
  scene.LookFrom(1.0, 2.0, 0.5);
  Listener listener(scene);
  Expect(listener.Warns(what), what + ": no warning");
  Expect(!listener.Warns(what + ", again"), what + ": said twice");
}

void ExpectNone(const std::string& what, Scene& scene)
{
  scene.LookFrom(1.0, 2.0, 0.5);
  Listener listener(scene);
  const bool warns = listener.Warns(what);
  Expect(!warns, what + ": " + listener.Message);
}

void TestUntouched()
{
  // A property as VTK makes it.
  Scene scene(Raised(), { 0.0 });
  vtkNew<vtkVolumeProperty> property;
  scene.Volume->SetProperty(property);
  Listener listener(scene);
  Expect(listener.Warns("untouched"), "untouched: no warning");
  for (const char* word : { "Isovalue 0 ", "range from", "GetIsoSurfaceValues()->SetValue" })
  {
    Expect(listener.Message.find(word) != std::string::npos,
      std::string("'") + word + "' is not in: " + listener.Message);
  }
  double range[2];
  Raised()->GetPointData()->GetScalars()->GetRange(range);
  std::ostringstream text;
  text << std::setprecision(4) << range[0];
  Expect(
    listener.Message.find(text.str()) != std::string::npos, "the range in: " + listener.Message);
  Expect(!scene.Mapper->PickPixel(20, 15, nullptr, nullptr, nullptr), "untouched: empty");
}

/// Once, and not after there was a surface: it may be dragged out of the range.
void TestOnce()
{
  Scene scene(Raised(), { 0.0 });
  scene.LookFrom(1.0, 2.0, 0.5);
  Listener listener(scene);
  Expect(listener.Warns("first"), "first: no warning");
  scene.SetIsovalues({ -3.0, 200.0 });
  Expect(!listener.Warns("other isovalues outside"), "other isovalues outside: said again");
  scene.Renderer->GetActiveCamera()->Azimuth(5.0);
  Expect(!listener.Warns("another view"), "another view: said again");
  scene.Mapper->SetInputData(Whole());
  Expect(!listener.Warns("other data"), "other data: said again");
  scene.SetIsovalues({ -3.0, 60.0 });
  Expect(!listener.Warns("cured"), "cured: " + listener.Message);

  Scene several(Raised(), { 200.0, -3.0, 0.0 });
  several.LookFrom(1.0, 2.0, 0.5);
  Listener ofSeveral(several);
  Expect(ofSeveral.Warns("several"), "several: no warning");
  Expect(ofSeveral.Message.find("3 isovalues (-3 to 200)") != std::string::npos,
    "all of them: " + ofSeveral.Message);

  Scene dragged(Raised(), { 60.0 });
  dragged.LookFrom(1.0, 2.0, 0.5);
  Listener ofDrag(dragged);
  for (const double isovalue : { 60.0, 61.0, 62.0, 99.0, 120.0, 60.0, 0.0 })
  {
    dragged.SetIsovalues({ isovalue });
    Expect(!ofDrag.Warns("a drag"), "a drag: " + ofDrag.Message);
  }
}

/// Where no sample is below the isovalue, as of most data at VTK's untouched 0, all are inside.
void TestSmallestSample()
{
  for (const int type : { VTK_UNSIGNED_CHAR, VTK_SHORT, VTK_FLOAT })
  {
    const Image image = Volumes::FromFormula(
      N, type, [](double x, double y, double z) { return std::max(Waves(x, y, z) - 50.0, 0.0); });
    const std::string what = "from 0, type " + std::to_string(type);
    Scene scene(image, { 0.0 });
    vtkNew<vtkVolumeProperty> untouched;
    scene.Volume->SetProperty(untouched);
    ExpectOne(what, scene);
    Expect(!scene.Mapper->PickPixel(20, 15, nullptr, nullptr, nullptr), what + ": empty");
    Scene composite(image, { 0.0 });
    vtkPiecewiseFunction* opacity = composite.Volume->GetProperty()->GetScalarOpacity();
    opacity->RemoveAllPoints();
    opacity->AddPoint(0.0, 0.0);
    opacity->AddPoint(20.0, 1.0);
    ExpectOne(what + ", with the opacity of another blend mode", composite);
    Scene solid(image, { 0.0 });
    solid.Mapper->SetSurfaceModeToThreshold();
    ExpectNone(what + ", a solid", solid);
  }
}

/// VTK's untouched 0 among the samples, but left out by an opacity that is made for composite
/// blending: Hounsfield units, for example.
void TestUntouchedTransparent()
{
  const Image image = Volumes::FromFormula(
    N, VTK_SHORT, [](double x, double y, double z) { return Waves(x, y, z) - 50.0; });
  const auto fade = [](Scene& scene, double isovalue)
  {
    vtkPiecewiseFunction* opacity = scene.Volume->GetProperty()->GetScalarOpacity();
    opacity->RemoveAllPoints();
    opacity->AddPoint(isovalue, 0.0);
    opacity->AddPoint(isovalue + 10.0, 1.0);
  };
  Scene scene(image, { 0.0 });
  fade(scene, 0.0);
  scene.LookFrom(1.0, 2.0, 0.5);
  Listener listener(scene);
  Expect(listener.Warns("transparent 0"), "transparent 0: no warning");
  Expect(listener.Message.find("opacity of 0") != std::string::npos, listener.Message);
  Expect(!listener.Warns("transparent 0, again"), "transparent 0: said twice");

  Scene fading(image, { 0.0 });
  fading.LookFrom(1.0, 2.0, 0.5);
  Listener ofFading(fading);
  Expect(!ofFading.Warns("opaque 0"), "opaque 0: " + ofFading.Message);
  fade(fading, 0.0);
  Expect(!ofFading.Warns("faded"), "faded: " + ofFading.Message);
  Scene chosen(image, { 1.0 });
  fade(chosen, 1.0);
  ExpectNone("another transparent isovalue", chosen);
}

/// What samples can meet, or nobody asked for.
void TestNoMistakes()
{
  const Image image = Raised(VTK_SHORT);
  double range[2];
  image->GetPointData()->GetScalars()->GetRange(range);
  Scene touching(image, { range[1] });
  ExpectNone("the largest sample", touching);
  Scene above(image, { range[0] + 1.0 });
  ExpectNone("above the smallest sample", above);
  Scene none(image, {});
  ExpectNone("no isovalue", none);
  Scene invisible(image, { 60.0 });
  invisible.Volume->GetProperty()->GetScalarOpacity()->RemoveAllPoints();
  invisible.Volume->GetProperty()->GetScalarOpacity()->AddPoint(60.0, 0.0);
  ExpectNone("a surface that is transparent", invisible);
  Scene solid(image, { range[0] - 1.0 });
  solid.Mapper->SetSurfaceModeToThreshold();
  ExpectNone("a solid of all samples", solid);
  Expect(solid.Mapper->PickPixel(20, 15, nullptr, nullptr, nullptr), "a solid of all is seen");
  Scene nothing(image, { range[1] + 1.0 });
  nothing.Mapper->SetSurfaceModeToThreshold();
  ExpectOne("a solid of no sample", nothing);

  // Between holes that are not numbers and samples there is none.
  const Image holed = Raised();
  holed->GetPointData()->GetScalars()->SetComponent(
    N * N * N / 2, 0, std::numeric_limits<double>::quiet_NaN());
  Scene around(holed, { 0.0 });
  ExpectOne("a hole that is not a number", around);
  // Between infinite samples and others there are surfaces.
  for (const double special :
    { -std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity() })
  {
    const Image holes = Raised();
    holes->GetPointData()->GetScalars()->SetComponent(N * N * N / 2, 0, special);
    Scene scene(holes, { special > 0.0 ? 1000.0 : 0.0 });
    ExpectNone("holes", scene);
    Scene beyond(holes, { special > 0.0 ? 0.0 : 1000.0 });
    ExpectOne("beyond what has holes", beyond);
  }
}

/// Samples that are all alike have no surface at any isovalue.
void TestAlike()
{
  const double infinite = std::numeric_limits<double>::infinity();
  const auto imageOf = [](double even, double odd)
  {
    return Volumes::FromFormula(
      9, VTK_FLOAT, [=](double x, double, double) { return std::lround(x) % 2 == 0 ? even : odd; });
  };
  const auto expect =
    [&](const std::string& what, double even, double odd, double isovalue, const char* words)
  {
    Scene scene(imageOf(even, odd), { isovalue });
    scene.LookFrom(1.0, 2.0, 0.5);
    Listener listener(scene);
    Expect(listener.Warns(what), what + ": no warning");
    Expect(listener.Message.find(words) != std::string::npos, what + ": " + listener.Message);
    Expect(!listener.Warns(what + ", again"), what + ": said twice");
  };
  for (const double isovalue : { 0.0, 3.0, 7.0 })
  {
    expect("equal samples", 3.0, 3.0, isovalue, "all of them are 3,");
  }
  expect("infinite samples", infinite, infinite, 1.0, "all of them are inf,");
  expect("infinite samples below", -infinite, -infinite, 1.0, "all of them are -inf,");
  expect("numbers that are equal", 3.0, std::nan(""), 1.0, "all of them are 3,");
  expect("above infinite samples", 3.0, infinite, 1.0, "range from 3 to inf,");
  // This reason is the same for all isovalues and modes.
  expect("samples that are no numbers", std::nan(""), std::nan(""), 1.0, "that is NaN");
  Scene between(imageOf(3.0, infinite), { 10.0 }), both(imageOf(-infinite, infinite), { 1.0 });
  ExpectNone("between a sample and an infinite one", between);
  ExpectNone("between infinite samples", both);
  Scene solid(imageOf(3.0, 3.0), { 2.0 });
  solid.Mapper->SetSurfaceModeToThreshold();
  ExpectNone("a solid of equal samples", solid);
}

/// Time steps without a surface are no mistake, where others had one.
void TestTimeSteps()
{
  const Image steps = Whole();
  Scene scene(steps, { 60.0 });
  scene.LookFrom(1.0, 2.0, 0.5);
  Listener listener(scene);
  vtkDataArray* samples = steps->GetPointData()->GetScalars();
  for (int step = 0; step < 6; ++step)
  {
    const bool isLow = step % 3 == 2;
    for (vtkIdType i = 0; i < samples->GetNumberOfTuples(); ++i)
    {
      samples->SetComponent(i, 0, (isLow ? 0.5 : 1.0) * static_cast<double>(i % 99));
    }
    steps->Modified();
    Expect(!listener.Warns("a time step"), "a time step: " + listener.Message);
  }
}

/// A mapper that may not know all of the data says nothing.
void TestPieces()
{
  const Image image = Raised();
  // A piece of what the pipeline has.
  vtkNew<vtkRTAnalyticSource> wavelet;
  wavelet->SetWholeExtent(-10, 10, -10, 10, -10, 10);
  Scene piece(nullptr, { 0.0 });
  piece.Mapper->SetInputConnection(wavelet->GetOutputPort());
  ExpectOne("a whole pipeline", piece);
  vtkNew<vtkTrivialProducer> producer;
  const Image half = Part(image, { 0, N - 1, 0, N - 1, 0, N / 2 });
  int whole[6];
  image->GetExtent(whole);
  producer->SetOutput(half);
  producer->SetWholeExtent(whole);
  Scene part(nullptr, { 0.0 });
  part.Mapper->SetInputConnection(producer->GetOutputPort());
  ExpectNone("a part of the whole extent", part);
  producer->SetWholeExtent(half->GetExtent());
  ExpectOne("all of the whole extent", part);

  Scene silent(image, { 0.0 });
  silent.Mapper->WarnOfIsovaluesOff();
  ExpectNone("switched off", silent);
  silent.Mapper->WarnOfIsovaluesOn();
  ExpectOne("switched on", silent);

  const Image overlapping = Raised();
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->SetNumberOfTuples(overlapping->GetNumberOfCells());
  ghosts->FillValue(0);
  ghosts->SetValue(7, vtkDataSetAttributes::DUPLICATECELL);
  overlapping->GetCellData()->AddArray(ghosts);
  Scene layered(overlapping, { 0.0 });
  ExpectNone("with cells of other pieces", layered);
  ghosts->SetValue(7, vtkDataSetAttributes::HIDDENCELL);
  ghosts->Modified();
  ExpectOne("with hidden cells", layered);
}

void TestBlocks()
{
  const Image image = Raised();
  Scene all(nullptr, { 0.0 });
  all.Mapper->SetInputDataObject(Blocks(image));
  ExpectOne("all blocks", all);
  const auto tree = Blocks(image);
  tree->SetBlock(3, nullptr);
  Scene some(nullptr, { 0.0 });
  some.Mapper->SetInputDataObject(tree);
  ExpectNone("some blocks", some);

  // Who draws each block by a mapper of its own hands them the volume whose mapper it is.
  Scene one(image, { 0.0 });
  vtkNew<Mapper> owner;
  owner->SetInputDataObject(Blocks(image));
  one.Volume->SetMapper(owner);
  ExpectNone("a mapper for a block", one);
  owner->SetInputDataObject(image);
  ExpectOne("a mapper for a mapper", one);

  // Bricks, each of which is a volume.
  Scene brick(image, { 0.0 });
  vtkNew<vtkVolume> other;
  other->SetProperty(brick.Volume->GetProperty());
  other->SetMapper(owner);
  brick.Renderer->AddVolume(other);
  ExpectNone("volumes of one property", brick);
  vtkNew<vtkVolumeProperty> own;
  other->SetProperty(own);
  ExpectOne("volumes of their own", brick);
}

void TestWindow()
{
  Scene scene(Raised(), { 0.0 });
  vtkNew<vtkRenderWindow> window;
  OpenWindow(window, scene.Renderer, 40, 30);
  scene.LookFrom(1.0, 2.0, 0.5);
  const EventCounter warnings(scene.Mapper, vtkCommand::WarningEvent);
  for (int i = 0; i < 3; ++i)
  {
    window->Render();
  }
  Expect(warnings.Count == 1, "in a window: " + std::to_string(warnings.Count) + " warnings");
}

}

int TestIsovalueWarning(int, char*[])
{
  TestUntouched();
  TestOnce();
  TestSmallestSample();
  TestUntouchedTransparent();
  TestNoMistakes();
  TestAlike();
  TestTimeSteps();
  TestPieces();
  TestBlocks();
  TestWindow();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
