// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Colours and opacities of blended volumes are those of VTK's transfer functions, whatever their
// nodes, shapes, scales and spaces are.

#include "BlendedScene.h"
#include "Checks/Expect.h"

#include <vtkPointData.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

namespace
{

using Rgba = std::array<double, 4>;

/// A cube with sides of 2 and one value everywhere, seen along z.
struct ConstantScene : Scene
{
  explicit ConstantScene(int mode)
    : Scene(Volumes::FromFormula(4, VTK_DOUBLE, [](double, double, double) { return 0.0; }), {})
  {
    this->Mapper->SetBlendMode(mode);
    this->Volume->GetProperty()->ShadeOff();
    this->Volume->GetProperty()->SetColor(this->Color);
    this->Volume->GetProperty()->SetScalarOpacity(this->Opacity);
    this->LookFrom(0.0, 0.0, 5.0);
    this->Renderer->GetActiveCamera()->ParallelProjectionOn();
    this->Renderer->GetActiveCamera()->SetParallelScale(0.5);
  }

  /// What the middle of the picture shows of a value.
  Rgba Shown(double value)
  {
    auto* image = vtkImageData::SafeDownCast(this->Mapper->GetInput());
    image->GetPointData()->GetScalars()->FillComponent(0, value);
    image->GetPointData()->GetScalars()->Modified();
    Expect(this->Render(8, 8), "a frame");
    const unsigned char* color = this->Scene::ColorAt(4, 4);
    return { color[0] + 0.0, color[1] + 0.0, color[2] + 0.0, color[3] + 0.0 };
  }

  /// What it should show: the colour, multiplied by the opacity of the whole way through the cube.
  Rgba Expected(double value)
  {
    double color[3];
    this->Color->GetColor(value, color);
    double opacity = this->Opacity->GetValue(value);
    if (this->Mapper->GetBlendMode() == vtkVolumeMapper::COMPOSITE_BLEND)
    {
      const double unit = this->Volume->GetProperty()->GetScalarOpacityUnitDistance();
      opacity = 1.0 - std::pow(1.0 - opacity, this->Length / unit);
    }
    return { 255.0 * opacity * color[0], 255.0 * opacity * color[1], 255.0 * opacity * color[2],
      255.0 * opacity };
  }

  vtkNew<vtkColorTransferFunction> Color;
  vtkNew<vtkPiecewiseFunction> Opacity;
  double Length = 2.0; ///< of the way
};

/// \param most error in 255ths
void ExpectFunctions(ConstantScene& scene, const std::string& what,
  const std::vector<double>& values, double most = 1.1)
{
  for (const double value : values)
  {
    const Rgba shown = scene.Shown(value), expected = scene.Expected(value);
    for (std::size_t c = 0; c < 4; ++c)
    {
      Expect(std::abs(shown[c] - expected[c]) <= most,
        what + " at " + std::to_string(value) + ", channel " + std::to_string(c) + ": " +
          std::to_string(shown[c]) + ", expected " + std::to_string(expected[c]));
    }
  }
}

std::vector<double> Values(double low, double high, int count)
{
  std::vector<double> values;
  for (int i = 0; i < count; ++i)
  {
    values.push_back(low + (high - low) * (i + 0.5) / count);
  }
  return values;
}

void AddPoints(ConstantScene& scene)
{
  scene.Color->RemoveAllPoints();
  scene.Color->AddRGBPoint(-3.0, 0.9, 0.2, 0.1);
  scene.Color->AddRGBPoint(1.7, 0.1, 0.8, 0.3);
  scene.Color->AddRGBPoint(8.1, 0.2, 0.3, 1.0);
  scene.Opacity->RemoveAllPoints();
  scene.Opacity->AddPoint(-2.0, 0.1);
  scene.Opacity->AddPoint(0.3, 0.7);
  scene.Opacity->AddPoint(0.35, 0.2);
  scene.Opacity->AddPoint(6.0, 0.9);
}

void TestShapes(int mode)
{
  const std::string name = NameOfMode(mode);
  ConstantScene scene(mode);
  AddPoints(scene);
  const std::vector<double> values = Values(-5.0, 10.0, 41);
  ExpectFunctions(scene, name + ", straight", values);

  scene.Color->ClampingOff();
  ExpectFunctions(scene, name + ", colours end", values);
  scene.Opacity->ClampingOff();
  ExpectFunctions(scene, name + ", opacities end", values);
  scene.Color->ClampingOn();
  scene.Opacity->ClampingOn();

  double node[4];
  scene.Opacity->GetNodeValue(2, node);
  node[2] = 0.3; // midpoint
  node[3] = 0.6; // sharpness
  scene.Opacity->SetNodeValue(2, node);
  double colors[6];
  scene.Color->GetNodeValue(0, colors);
  colors[4] = 0.7;
  colors[5] = 0.3;
  scene.Color->SetNodeValue(0, colors);
  ExpectFunctions(scene, name + ", bent", values);
  node[3] = 1.0;
  scene.Opacity->SetNodeValue(2, node);
  ExpectFunctions(scene, name + ", with a jump", values);

  AddPoints(scene);
  for (const int space : { VTK_CTF_HSV, VTK_CTF_LAB, VTK_CTF_DIVERGING })
  {
    scene.Color->SetColorSpace(space);
    ExpectFunctions(scene, name + ", space " + std::to_string(space), values);
  }
  scene.Color->SetColorSpaceToRGB();
  scene.Color->RemovePoint(-3.0);
  scene.Color->AddRGBPoint(0.01, 1.0, 0.0, 0.2);
  scene.Color->SetScaleToLog10();
  ExpectFunctions(scene, name + ", logarithmic", Values(0.5, 9.0, 17), 2.0);
}

/// Nodes at integers are met to the last bit, and a function may have one node, or none.
void TestNodes(int mode)
{
  const std::string name = NameOfMode(mode);
  ConstantScene scene(mode);
  scene.Color->AddRGBPoint(0.0, 1.0, 1.0, 1.0);
  scene.Opacity->AddPoint(99.0, 0.0);
  scene.Opacity->AddPoint(100.0, 0.5);
  scene.Opacity->AddPoint(101.0, 0.0);
  scene.Opacity->AddPoint(4000.0, 0.0);
  ExpectFunctions(scene, name + ", a spike", { 98.0, 99.0, 100.0, 101.0, 102.0, 3000.0 }, 0.6);
  scene.Opacity->RemoveAllPoints();
  scene.Opacity->AddPoint(1e9, 0.25);
  ExpectFunctions(scene, name + ", one node", { -1.0, 1e9, 2e9 });
  scene.Opacity->RemoveAllPoints();
  ExpectFunctions(scene, name + ", no node", { -1.0, 0.0, 2.0 });
  scene.Color->RemoveAllPoints();
  ExpectFunctions(scene, name + ", no node at all", { -1.0, 0.0, 2.0 });
  scene.Color->AddRGBPoint(0.0, 1.0, 1.0, 1.0);
  scene.Opacity->AddPoint(-2e-12, 0.1);
  scene.Opacity->AddPoint(3e-12, 0.8);
  ExpectFunctions(scene, name + ", tiny values", { -3e-12, 0.0, 1e-12, 4e-12 });
  scene.Opacity->RemoveAllPoints();
  scene.Opacity->AddPoint(-1e200, 0.1);
  scene.Opacity->AddPoint(1e200, 0.8);
  ExpectFunctions(scene, name + ", huge values", { -1e200, 0.0, 5e199 });
}

/// Gray functions, unit distances, and the volume's scale: distances are those of the data.
void TestProperty(int mode)
{
  const std::string name = NameOfMode(mode);
  ConstantScene scene(mode);
  AddPoints(scene);
  vtkVolumeProperty* property = scene.Volume->GetProperty();
  property->SetScalarOpacityUnitDistance(0.7);
  ExpectFunctions(scene, name + ", unit distance", Values(-3.0, 7.0, 11));
  scene.Volume->SetScale(3.0);
  scene.Renderer->GetActiveCamera()->SetPosition(0.0, 0.0, 15.0);
  scene.Renderer->ResetCameraClippingRange();
  ExpectFunctions(scene, name + ", scaled", Values(-3.0, 7.0, 11));
  vtkNew<vtkPiecewiseFunction> gray;
  gray->AddPoint(-1.0, 0.2);
  gray->AddPoint(5.0, 0.9);
  property->SetColor(gray);
  const Rgba shown = scene.Shown(2.0);
  const double opacity = scene.Expected(2.0)[3];
  for (std::size_t c = 0; c < 3; ++c)
  {
    Expect(std::abs(shown[c] - opacity * gray->GetValue(2.0)) < 1.1, name + ", gray");
  }
}

/// A change of a function makes another picture; none makes none.
void TestChanges(int mode)
{
  ConstantScene scene(mode);
  AddPoints(scene);
  scene.Shown(1.0);
  Expect(scene.Render(8, 8) &&
      std::string(scene.Mapper->GetStatistics()->GetRouteAsString()) == "Redisplay",
    "nothing changed");
  scene.Opacity->AddPoint(1.0, 0.5);
  ExpectFunctions(scene, NameOfMode(mode) + ", another opacity", { 1.0 });
  scene.Color->AddRGBPoint(1.0, 0.5, 0.1, 0.2);
  ExpectFunctions(scene, NameOfMode(mode) + ", another colour", { 1.0 });
  vtkNew<vtkPiecewiseFunction> other;
  other->AddPoint(0.0, 0.3);
  scene.Volume->GetProperty()->SetScalarOpacity(other);
  scene.Opacity->DeepCopy(other);
  ExpectFunctions(scene, NameOfMode(mode) + ", another function", { 1.0 });
}

}

int TestBlendedFunctions(int, char*[])
{
  for (const int mode : BlendModes)
  {
    if (IsGrey(mode))
    {
      continue;
    }
    TestShapes(mode);
    TestNodes(mode);
    TestProperty(mode);
    TestChanges(mode);
  }
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
