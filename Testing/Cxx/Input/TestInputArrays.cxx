// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// The array that is asked for is drawn: of points or cells, by every scalar mode, and the component
// of it that VectorMode or the property names. Pictures agree with brute force or with those of
// plain images.

#include "Scenes/Mistake.h"
#include "Truth/Agreement.h"
#include "Truth/PlainImages.h"

#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkFloatingPointExceptions.h>
#include <vtkMatrix4x4.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPointData.h>
#include <vtkStringArray.h>
#include <vtkTestErrorObserver.h>

#include <cstdlib>
#include <functional>
#include <limits>

namespace
{

using namespace PlainImages;
using Mapper = vtkTemporalCoherenceVolumeMapper;

/// Every scalar mode, one after the other: each array is another picture, and none a stale one.
void TestScalarModes()
{
  constexpr int N = 33;
  const auto points = Values("points", N, Waves), other = Values("other", N, Blob);
  const auto cells = Values("cells", N - 1, Blob);
  const auto otherCells = Values("other cells", N - 1, Waves, VTK_SHORT);
  Image image = PlainImage(N, points);
  image->GetPointData()->AddArray(other);
  image->GetCellData()->SetScalars(cells);
  image->GetCellData()->AddArray(otherCells);
  Scene scene(image, { 60.0 });
  scene.LookFrom(1.0, -2.0, 0.6);
  const Image ofPoints = PlainImage(N, points), ofOther = PlainImage(N, other);
  const Image ofCells = Centres(N - 1, cells), ofOtherCells = Centres(N - 1, otherCells);

  for (const int mode : { Mapper::CROSSING, Mapper::THRESHOLD })
  {
    scene.Mapper->SetSurfaceMode(mode);
    scene.Mapper->SetScalarModeToDefault();
    ExpectSame("default", scene, ofPoints);
    scene.Mapper->SetScalarModeToUseCellData();
    ExpectSame("cell data", scene, ofCells);
    scene.Mapper->SetScalarModeToUsePointData();
    ExpectSame("point data", scene, ofPoints);
    scene.Mapper->SetScalarModeToUsePointFieldData();
    scene.Mapper->SelectScalarArray("other");
    ExpectSame("point array by name", scene, ofOther);
    scene.Mapper->SelectScalarArray(0);
    ExpectSame("point array by number", scene, ofPoints);
    scene.Mapper->SelectScalarArray(1);
    ExpectSame("another number", scene, ofOther);
    scene.Mapper->SetScalarModeToUseCellFieldData();
    ExpectSame("cell array by number", scene, ofOtherCells);
    scene.Mapper->SelectScalarArray("cells");
    ExpectSame("cell array by name", scene, ofCells);
    scene.Mapper->SelectScalarArray("other cells");
    ExpectSame("another name", scene, ofOtherCells);
  }

  // By default cells serve where points have none; the active array may change.
  scene.Mapper->SetScalarModeToDefault();
  image->GetPointData()->SetActiveScalars("other");
  ExpectSame("another active array", scene, ofOther);
  image->GetPointData()->SetActiveScalars(nullptr);
  ExpectSame("default, cells only", scene, ofCells);
  image->GetCellData()->SetActiveScalars("other cells");
  ExpectSame("another active array of cells", scene, ofOtherCells);

  // Values may change without the array becoming another one.
  otherCells->DeepCopy(Values("other cells", N - 1, Blob, VTK_SHORT));
  otherCells->Modified();
  ExpectSame("new values of cells", scene, ofOtherCells);
  for (vtkIdType i = 0; i < otherCells->GetNumberOfTuples(); ++i)
  {
    otherCells->SetComponent(i, 0, 120.0 - otherCells->GetComponent(i, 0));
  }
  image->Modified();
  ExpectSame("values changed, the image tells", scene, ofOtherCells,
    [](Scene& reference) { reference.Mapper->GetInputDataObject(0, 0)->Modified(); });
}

/// One sample at the centre of each cell, wherever the image lies.
void TestCellsAgainstBruteForce()
{
  for (const bool isOblique : { false, true })
  {
    const auto cells = Values("cells", 24, Blob);
    vtkNew<vtkImageData> image;
    image->SetExtent(-3, 21, 5, 29, 2, 26);
    image->SetSpacing(0.1, 0.07, 0.12);
    image->SetOrigin(-1.0, 0.5, 0.3);
    image->GetCellData()->SetScalars(cells);
    Scene scene(image, { 60.0, 90.0 });
    if (isOblique)
    {
      image->SetDirectionMatrix(0.0, -0.6, 0.8, 0.0, 0.8, 0.6, -1.0, 0.0, 0.0);
      scene.Volume->SetScale(1.0, 2.0, 0.7);
      scene.Volume->RotateX(30.0);
      scene.Volume->SetPosition(1.0, 2.0, -3.0);
    }
    scene.LookFrom(1.0, -2.0, 0.6);
    scene.Renderer->GetActiveCamera()->Zoom(1.3);
    for (const bool isNearest : { false, true })
    {
      for (const int mode : { Mapper::CROSSING, Mapper::THRESHOLD })
      {
        scene.Volume->GetProperty()->SetInterpolationType(
          isNearest ? VTK_NEAREST_INTERPOLATION : VTK_LINEAR_INTERPOLATION);
        scene.Mapper->SetSurfaceMode(mode);
        BruteForceTracer truth(image, scene.Volume, 0, cells);
        truth.Isovalues = { 60.0, 90.0 };
        truth.IsThreshold = mode == Mapper::THRESHOLD;
        ExpectColdTruth(std::string(isOblique ? "oblique" : "straight") + " cells" +
            (isNearest ? ", nearest" : "") + (truth.IsThreshold ? ", THRESHOLD" : ""),
          scene, truth, 120, 120);
      }
    }
  }
}

void TestTooFewCells()
{
  for (const auto& [x, y, z] : { std::array{ 2, 9, 9 }, { 9, 2, 9 }, { 9, 9, 2 }, { 1, 9, 9 } })
  {
    vtkNew<vtkImageData> image;
    image->SetDimensions(x, y, z);
    vtkNew<vtkFloatArray> cells;
    cells->SetNumberOfTuples(image->GetNumberOfCells());
    cells->Fill(200.0);
    image->GetCellData()->SetScalars(cells);
    Scene scene(image, { 60.0 });
    scene.LookFrom(1.0, 2.0, 0.5);
    scene.Mapper->SetSurfaceModeToThreshold();
    vtkNew<vtkTest::ErrorObserver> observer;
    scene.Mapper->AddObserver(vtkCommand::ErrorEvent, observer);
    Expect(scene.Render(30, 30) && !observer->GetError(), "one cell along an axis is no error");
    Expect(!scene.Mapper->PickPixel(15, 15, nullptr, nullptr, nullptr), "but nothing is seen");
  }
}

/// Four components, each with its own look in the property; component c is Waves or Blob.
struct FourComponents
{
  static constexpr int N = 33;

  FourComponents()
  {
    this->Array->SetNumberOfComponents(4);
    this->Array->SetNumberOfTuples(N * N * N);
    for (int c = 0; c < 4; ++c)
    {
      this->Single.push_back(Values("single", N, c % 2 ? Blob : Waves));
      for (vtkIdType i = 0; i < N * N * N; ++i)
      {
        this->Single.back()->SetTuple1(i, this->Single.back()->GetTuple1(i) + 4.0 * c);
      }
      this->Array->CopyComponent(c, this->Single.back(), 0);
    }
  }

  /// Give a component of a property the look of number `look`.
  static void SetLook(vtkVolumeProperty* property, int component, int look)
  {
    vtkNew<vtkColorTransferFunction> color;
    color->AddRGBPoint(0.0, 0.2 + 0.2 * look, 0.9, 0.1);
    color->AddRGBPoint(100.0, 0.2, 0.3 + 0.2 * look, 0.7);
    property->SetColor(component, color);
    property->SetAmbient(component, 0.1 * look);
    property->SetDiffuse(component, 0.9 - 0.1 * look);
    property->SetSpecular(component, 0.05 * look);
    property->SetSpecularPower(component, 5.0 + look);
  }

  vtkNew<vtkFloatArray> Array;
  std::vector<vtkSmartPointer<vtkDataArray>> Single;
};

/// Without a VectorMode: as vtkGPUVolumeRayCastMapper chooses.
void TestComponentsOfProperty()
{
  FourComponents four;
  constexpr int N = FourComponents::N;
  Scene scene(PlainImage(N, four.Array), { 60.0 });
  scene.LookFrom(1.0, -2.0, 0.6);
  vtkVolumeProperty* property = scene.Volume->GetProperty();
  for (int c = 0; c < 4; ++c)
  {
    FourComponents::SetLook(property, c, c);
  }
  const auto expect = [&](const std::string& what, std::size_t component, int look)
  {
    ExpectSame(what, scene, PlainImage(N, four.Single[component]),
      [look](Scene& reference)
      { FourComponents::SetLook(reference.Volume->GetProperty(), 0, look); });
  };
  expect("equal weights", 0, 0);
  property->SetComponentWeight(2, 1.0);
  property->SetComponentWeight(0, 0.5);
  property->SetComponentWeight(1, 0.5);
  property->SetComponentWeight(3, 0.9);
  expect("component 2 weighs most", 2, 2);
  property->SetComponentWeight(3, 1.0);
  expect("equal weights of 2 and 3", 2, 2);
  property->SetComponentWeight(2, 0.0);
  expect("component 3 weighs most", 3, 3);
  scene.Mapper->SetVectorModeToComponent();
  scene.Mapper->SetVectorComponent(1);
  expect("a component that the mapper chose has the first look", 1, 0);
  scene.Mapper->SetVectorModeToDisabled();
  property->IndependentComponentsOff();
  expect("dependent components", 0, 0);
  property->IndependentComponentsOn();

  // An isovalue that the chosen component does not show is left out, as with one component.
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.0, 0.0);
  property->SetScalarOpacity(3, opacity);
  Expect(scene.Render(Size, Size), "rendered");
  Expect(!scene.Mapper->PickPixel(Size / 2, Size / 2, nullptr, nullptr, nullptr),
    "the opacity of the component counts");
}

/// A scene with a valid picture is spoilt: one error that contains `word`, and it can be mended.
void ExpectError(const std::string& word, const std::function<void(Scene&)>& spoil)
{
  const auto points = Values("points", 17, Blob);
  Image image = PlainImage(17, points);
  vtkNew<vtkStringArray> names;
  names->SetName("names");
  names->SetNumberOfValues(17 * 17 * 17);
  image->GetPointData()->AddArray(names);
  image->GetFieldData()->AddArray(points);
  Scene scene(image, { 60.0 });
  scene.LookFrom(1.0, 2.0, 0.5);
  Mistake mistake(scene, word);
  spoil(scene);
  mistake.ExpectRefused();
  scene.Mapper->SetInputData(image);
  scene.Mapper->SetScalarModeToDefault();
  scene.Mapper->SetVectorModeToDisabled();
  scene.Volume->SetUserMatrix(nullptr);
  scene.Volume->SetScale(1.0);
  image->SetSpacing(0.0625, 0.0625, 0.0625);
  image->SetOrigin(-1.0, -1.0, -1.0);
  mistake.ExpectMended();
}

void TestMistakes()
{
  const auto ofPoints = [](const char* name)
  {
    return [name](Scene& scene)
    {
      scene.Mapper->SetScalarModeToUsePointFieldData();
      scene.Mapper->SelectScalarArray(name);
    };
  };
  ExpectError("named 'pressure' on its points", ofPoints("pressure"));
  ExpectError("no array of numbers named 'names'", ofPoints("names"));
  for (const int number : { 7, -1 })
  {
    ExpectError(number < 0 ? "ScalarMode asks for an array on points, but none is chosen"
                           : "no array number 7 on its points, or it holds no numbers",
      [number](Scene& scene)
      {
        scene.Mapper->SetScalarModeToUsePointFieldData();
        scene.Mapper->SelectScalarArray(number);
      });
  }
  ExpectError("named 'points' on its cells",
    [](Scene& scene)
    {
      scene.Mapper->SetScalarModeToUseCellFieldData();
      scene.Mapper->SelectScalarArray("points");
    });
  ExpectError(
    "no scalars on cells", [](Scene& scene) { scene.Mapper->SetScalarModeToUseCellData(); });
  ExpectError("no scalars on points",
    [](Scene& scene)
    {
      scene.Mapper->SetScalarModeToUsePointData();
      scene.Mapper->SetInputData(PlainImage(17, nullptr));
    });
  ExpectError("field data",
    [](Scene& scene)
    {
      scene.Mapper->SetScalarMode(VTK_SCALAR_MODE_USE_FIELD_DATA);
      scene.Mapper->SelectScalarArray("points");
    });
  ExpectError("ScalarMode is 17", [](Scene& scene) { scene.Mapper->SetScalarMode(17); });
  ExpectError("VectorComponent is 1",
    [](Scene& scene)
    {
      scene.Mapper->SetVectorModeToComponent();
      scene.Mapper->SetVectorComponent(1);
    });
  ExpectError("last row of the volume's matrix is (0, 0.5, 0, 1)",
    [](Scene& scene)
    {
      vtkNew<vtkMatrix4x4> projection;
      projection->SetElement(3, 1, 0.5);
      scene.Volume->SetUserMatrix(projection);
    });
  const double nan = std::numeric_limits<double>::quiet_NaN();
  ExpectError("spacing (nan, ",
    [nan](Scene& scene)
    { vtkImageData::SafeDownCast(scene.Mapper->GetInput())->SetSpacing(nan, 0.1, 0.1); });
  ExpectError("origin (-1, nan, ",
    [nan](Scene& scene)
    { vtkImageData::SafeDownCast(scene.Mapper->GetInput())->SetOrigin(-1.0, nan, 0.1); });
  ExpectError("not finite", [nan](Scene& scene) { scene.Volume->SetScale(1.0, nan, 1.0); });
}

void TestSetters()
{
  vtkNew<Mapper> mapper;
  Expect(mapper->GetVectorMode() == Mapper::DISABLED, "by default, the property chooses");
  mapper->SetVectorModeToMagnitude();
  Expect(mapper->GetVectorMode() == 0, "as in vtkSmartVolumeMapper");
}

}

int TestInputArrays(int, char*[])
{
  // The Debug driver traps operations on what is not a number, which is what is tested here.
  vtkFloatingPointExceptions::Disable();
  TestScalarModes();
  TestCellsAgainstBruteForce();
  TestTooFewCells();
  TestComponentsOfProperty();
  TestMistakes();
  TestSetters();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
