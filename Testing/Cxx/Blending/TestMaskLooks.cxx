// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// The labels of a mask give looks to parts of a composite volume: those of their own functions,
// mixed with the volume's by MaskBlendFactor.

#include "BlendedScene.h"
#include "Checks/Expect.h"
#include "Scenes/Mistake.h"
#include "Truth/ColdWitness.h"
#include "Volumes/Masks.h"

#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkPointData.h>
#include <vtkRectilinearGrid.h>

#include <cstdlib>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace
{

using Image = vtkSmartPointer<vtkImageData>;

constexpr int Composite = vtkVolumeMapper::COMPOSITE_BLEND;
constexpr int N = 32; ///< samples of the volume along each axis
constexpr int Width = 80, Height = 60;

/// Nodes at values that are those of BlendedScene's functions.
vtkSmartPointer<vtkColorTransferFunction> Colors(const std::array<double, 3>& high)
{
  const auto color = vtkSmartPointer<vtkColorTransferFunction>::New();
  color->AddRGBPoint(0.0, 0.9, 0.1, 0.2);
  color->AddRGBPoint(128.0, 0.2, 0.3, 0.8);
  color->AddRGBPoint(255.0, high[0], high[1], high[2]);
  return color;
}

vtkSmartPointer<vtkPiecewiseFunction> Opacities(double low, double high)
{
  const auto opacity = vtkSmartPointer<vtkPiecewiseFunction>::New();
  opacity->AddPoint(0.0, low);
  opacity->AddPoint(20.0, low);
  opacity->AddPoint(255.0, high);
  return opacity;
}

Image MaskOf(const std::function<int(int, int, int)>& label, int type = VTK_UNSIGNED_CHAR)
{
  return Masks::For(Volumes::FourSpheres(N), label, type);
}

void SetLabels(Scene& scene, vtkImageData* mask)
{
  scene.Mapper->SetMaskInput(mask);
  scene.Mapper->SetMaskTypeToLabelMap();
}

/// Two pictures differ by so many 255ths at most.
void ExpectSame(const std::string& what, Scene& a, Scene& b, int tolerance)
{
  Expect(a.Render(Width, Height) && b.Render(Width, Height), what + ": rendered");
  int largest = 0, seen = 0;
  for (int y = 0; y < Height; ++y)
  {
    for (int x = 0; x < Width; ++x)
    {
      for (int channel = 0; channel < 4; ++channel)
      {
        const int first = a.ColorAt(x, y)[channel], second = b.ColorAt(x, y)[channel];
        largest = std::max(largest, std::abs(first - second));
        seen += channel == 3 && first > 25;
      }
    }
  }
  Expect(largest <= tolerance, what + ": differs by " + std::to_string(largest));
  Expect(seen > 300, what + ": little is seen, " + std::to_string(seen));
}

/// A volume that has one label everywhere looks as one whose property has the label's functions.
void TestOneLabel()
{
  for (const bool isNearest : { false, true })
  {
    for (const bool isShaded : { false, true })
    {
      for (const bool hasSteps : { false, true })
      {
        BlendedScene labelled(Composite), plain(Composite);
        for (Scene* scene : { static_cast<Scene*>(&labelled), static_cast<Scene*>(&plain) })
        {
          vtkVolumeProperty* property = scene->Volume->GetProperty();
          property->SetInterpolationType(
            isNearest ? VTK_NEAREST_INTERPOLATION : VTK_LINEAR_INTERPOLATION);
          property->SetShade(isShaded);
          scene->Mapper->SetSampleDistance(0.5f);
          scene->Mapper->SetFixedStepSampling(hasSteps);
        }
        vtkVolumeProperty* const own = labelled.Volume->GetProperty();
        own->SetLabelColor(7, Colors({ 0.2, 1.0, 0.4 }));
        own->SetLabelScalarOpacity(7, Opacities(0.0, 0.5));
        own->SetLabelColor(8, Colors({ 1.0, 1.0, 1.0 }));
        SetLabels(labelled, MaskOf([](int, int, int) { return 7; }));
        plain.Volume->GetProperty()->SetColor(Colors({ 0.2, 1.0, 0.4 }));
        plain.Volume->GetProperty()->SetScalarOpacity(Opacities(0.0, 0.5));
        ExpectSame(std::string("one label") + (isNearest ? ", nearest" : "") +
            (isShaded ? ", shaded" : "") + (hasSteps ? ", steps" : ""),
          labelled, plain, 2);
      }
    }
  }
}

/// A label without opacity is cut away half way between samples, as by a cropping plane there.
void TestHiddenHalf()
{
  for (const int type : { VTK_SHORT, VTK_INT, VTK_ID_TYPE })
  {
    BlendedScene labelled(Composite), cropped(Composite);
    labelled.Volume->GetProperty()->SetLabelScalarOpacity(3, Opacities(0.0, 0.0));
    SetLabels(labelled, MaskOf([](int i, int, int) { return i < 13 ? 0 : 3; }, type));
    cropped.Mapper->CroppingOn();
    const double at = labelled.Mapper->GetBounds()[0] + 12.5;
    cropped.Mapper->SetCroppingRegionPlanes(-9.0, at, -9.0, 40.0, -9.0, 40.0);
    ExpectSame("a hidden label of type " + std::to_string(type), labelled, cropped, 2);
  }
}

/// The mixture of two functions at the nodes that both have: a share of the second one. The first
/// one counts as black where it has no opacity.
void SetMixture(vtkVolumeProperty* mixed, vtkVolumeProperty* common, int label, double share)
{
  vtkNew<vtkColorTransferFunction> color;
  vtkNew<vtkPiecewiseFunction> opacity;
  for (double value = 0.0; value <= 255.0; value += 0.5)
  {
    double a[3], b[3];
    common->GetRGBTransferFunction()->GetColor(value, a);
    common->GetLabelColor(label)->GetColor(value, b);
    const double opacityOfA = common->GetScalarOpacity()->GetValue(value);
    const double opacityOfB = common->GetLabelScalarOpacity(label)->GetValue(value);
    const double ofA = opacityOfA > 0.0 ? 1.0 - share : 0.0;
    color->AddRGBPoint(
      value, ofA * a[0] + share * b[0], ofA * a[1] + share * b[1], ofA * a[2] + share * b[2]);
    opacity->AddPoint(value, (1.0 - share) * opacityOfA + share * opacityOfB);
  }
  mixed->SetColor(color);
  mixed->SetScalarOpacity(opacity);
}

/// As MaskBlendFactor says.
void TestMixture()
{
  BlendedScene labelled(Composite), plain(Composite);
  vtkVolumeProperty* const property = labelled.Volume->GetProperty();
  property->SetLabelColor(1, Colors({ 0.2, 1.0, 0.4 }));
  property->SetLabelScalarOpacity(1, Opacities(0.1, 0.3));
  labelled.Mapper->SetMaskBlendFactor(0.25f);
  SetLabels(labelled, MaskOf([](int, int, int) { return 1; }));
  for (const double low : { 0.1, 0.0 }) // 0: the volume alone shows nothing there
  {
    property->SetScalarOpacity(Opacities(low, 0.6));
    SetMixture(plain.Volume->GetProperty(), property, 1, 0.25);
    ExpectSame("a mixture, " + std::to_string(low), labelled, plain, 2);
  }

  labelled.Mapper->SetMaskBlendFactor(0.0f);
  plain.Volume->GetProperty()->SetColor(property->GetRGBTransferFunction());
  plain.Volume->GetProperty()->SetScalarOpacity(property->GetScalarOpacity());
  ExpectSame("a mixture without the label", labelled, plain, 0);
}

/// Labels that are nowhere or below 0, and labels of projections have no effect.
void TestNoEffect()
{
  const auto give = [](Scene& scene)
  {
    for (const int label : { -2, 9 })
    {
      scene.Volume->GetProperty()->SetLabelScalarOpacity(label, Opacities(0.0, 0.0));
    }
    SetLabels(scene, MaskOf([](int i, int, int) { return i % 3 - 2; }, VTK_SHORT));
  };
  for (const int mode : BlendModes)
  {
    BlendedScene labelled(mode), plain(mode);
    give(labelled);
    if (mode != Composite)
    {
      labelled.Volume->GetProperty()->SetLabelScalarOpacity(-1, Opacities(0.0, 0.0));
      SetLabels(labelled, MaskOf([](int, int, int) { return 9; }));
    }
    ExpectSame("no effect, " + NameOfMode(mode), labelled, plain, 0);
  }
}

/// What changes is seen in the next frame: as a mapper shows it that draws its first frame.
void TestChanges()
{
  const Image mask = MaskOf([](int i, int j, int) { return 1 + (i / 5 + j / 7) % 3; });
  BlendedScene scene(Composite);
  vtkVolumeProperty* property = scene.Volume->GetProperty();
  const auto expectFresh = [&](const std::string& what, bool isKept = false)
  {
    BlendedScene fresh(Composite);
    fresh.Mapper->SetMaskBlendFactor(scene.Mapper->GetMaskBlendFactor());
    fresh.Volume->SetProperty(property);
    SetLabels(fresh, mask);
    ExpectSame(what, scene, fresh, 0);
    Expect(IsRoute(scene, isKept ? "Redisplay" : "Cold"), what + ": the route");
    Expect(scene.Render(Width, Height) && IsRoute(scene, "Redisplay"), what + ": again");
  };
  SetLabels(scene, mask);
  property->SetLabelColor(1, Colors({ 0.2, 1.0, 0.4 }));
  property->SetLabelScalarOpacity(2, Opacities(0.0, 0.1));
  expectFresh("labels");
  property->SetLabelScalarOpacity(3, Opacities(0.0, 0.0));
  expectFresh("another label");
  property->GetLabelScalarOpacity(3)->AddPoint(100.0, 0.3);
  expectFresh("another node");
  vtkDataArray* const labels = mask->GetPointData()->GetScalars();
  for (vtkIdType i = 9000; i < 15000; ++i)
  {
    labels->SetComponent(i, 0, 3.0);
  }
  labels->Modified();
  expectFresh("a stroke");
  scene.Mapper->SetMaskBlendFactor(0.5f);
  expectFresh("a factor");
  property->SetLabelGradientOpacity(1, nullptr);
  expectFresh("nothing", true);
}

/// On a rectilinear grid, a label ends half way between samples, however far apart they lie.
void TestGrid()
{
  const Image image = Volumes::FourSpheres(N);
  vtkNew<vtkRectilinearGrid> grid;
  grid->SetDimensions(N, N, N);
  std::array<vtkNew<vtkDoubleArray>, 3> places;
  for (int i = 0; i < N; ++i)
  {
    for (const auto& along : places)
    {
      // 12 and 13 are 3 apart, and others a bit less than 1.
      along->InsertNextValue(i < 13 ? 0.93 * i : 12 * 0.93 + 3.0 + 0.93 * (i - 13));
    }
  }
  grid->SetXCoordinates(places[0]);
  grid->SetYCoordinates(places[1]);
  grid->SetZCoordinates(places[2]);
  grid->GetPointData()->SetScalars(image->GetPointData()->GetScalars());
  BlendedScene labelled(Composite, grid), cropped(Composite, grid);
  labelled.Volume->GetProperty()->SetLabelScalarOpacity(5, Opacities(0.0, 0.0));
  SetLabels(labelled, MaskOf([](int i, int, int) { return i < 13 ? 0 : 5; }));
  cropped.Mapper->CroppingOn();
  cropped.Mapper->SetCroppingRegionPlanes(-1.0, 12 * 0.93 + 1.5, -1.0, 40.0, -1.0, 40.0);
  ExpectSame("a grid", labelled, cropped, 2);
}

void TestMistakes()
{
  const auto expectRefused = [](const std::string& word, const std::function<void(Scene&)>& spoil)
  {
    BlendedScene scene(Composite);
    scene.Volume->GetProperty()->SetLabelScalarOpacity(1, Opacities(0.0, 0.2));
    Mistake mistake(scene, word);
    SetLabels(scene, MaskOf([](int, int, int) { return 1; }));
    spoil(scene);
    mistake.ExpectRefused();
    scene.Mapper->SetMaskInput(nullptr);
    mistake.ExpectMended();
  };
  expectRefused("Value of node 1 of the scalar opacity of label 1",
    [](Scene& scene)
    {
      double node[4] = { 20.0, std::numeric_limits<double>::quiet_NaN(), 0.5, 0.0 };
      scene.Volume->GetProperty()->GetLabelScalarOpacity(1)->SetNodeValue(1, node);
    });
  expectRefused("cannot be mixed with that of the volume where gradients",
    [](Scene& scene)
    {
      scene.Volume->GetProperty()->SetLabelGradientOpacity(1, Opacities(0.0, 0.5));
      scene.Mapper->SetMaskBlendFactor(0.5f);
    });
  expectRefused("have the type float",
    [](Scene& scene) { SetLabels(scene, MaskOf([](int, int, int) { return 1; }, VTK_FLOAT)); });
  expectRefused("The mask has 31 x 31 x 31 values",
    [](Scene& scene)
    { SetLabels(scene, Masks::For(Volumes::FourSpheres(31), [](int, int, int) { return 1; })); });

  // A volume of two components has no single look.
  vtkNew<vtkImageData> two;
  two->SetDimensions(N, N, N);
  two->AllocateScalars(VTK_UNSIGNED_CHAR, 2);
  two->GetPointData()->GetScalars()->Fill(150.0);
  BlendedScene scene(Composite, two);
  scene.Volume->GetProperty()->SetLabelScalarOpacity(1, Opacities(0.0, 0.2));
  Expect(scene.Render(Width, Height), "two components: rendered");
  Mistake mistake(scene, "volumes of one component only");
  SetLabels(scene, MaskOf([](int, int, int) { return 1; }));
  mistake.ExpectRefused();
}

}

int TestMaskLooks(int, char*[])
{
  TestOneLabel();
  TestHiddenHalf();
  TestMixture();
  TestNoEffect();
  TestChanges();
  TestGrid();
  TestMistakes();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
