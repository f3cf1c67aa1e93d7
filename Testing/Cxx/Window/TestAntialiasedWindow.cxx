// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// In a window, the second frame of a still picture is antialiased. Its edges blend over other props
// and the background, whatever the order of the props. They write no depth, and are not picked.

#include "Checks/Expect.h"
#include "Scenes/OffScreen.h"
#include "Truth/ColdWitness.h"
#include "Volumes/Volumes.h"
#include "vtkTemporalCoherenceVolume.h"

#include <vtkActor.h>
#include <vtkFloatArray.h>
#include <vtkFloatingPointExceptions.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPlaneSource.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

namespace
{

constexpr int Size = 90;

using Rgb = std::array<double, 3>;
constexpr Rgb Background{ 0.2, 0.4, 0.6 }, Behind{ 1.0, 0.0, 0.0 }, Before{ 0.0, 0.0, 1.0 };

/// How the sphere is drawn.
struct Kind
{
  std::string Name;
  bool IsPlainVolume;
  bool IsLast; ///< of the props
  double Opacity = 1.0;
  float Distance = 1.0f; ///< of rays, in pixels
};

/// A sphere seen along z. Below the middle of the picture, a rectangle lies behind it; right of the
/// middle, another one lies before it.
struct Stage : Scene
{
  explicit Stage(const Kind& kind)
    : Scene(Volumes::FromFormula(
              65, VTK_DOUBLE, [](double x, double y, double z) { return -std::hypot(x, y, z); }),
        { -0.7 })
    , Of(kind)
  {
    this->Mapper->SetAntialiasingToWhenStill();
    this->Mapper->SetImageSampleDistance(kind.Distance);
    this->LookFrom(0.0, 0.0, 5.0);
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(0.0, 0.0, 5.0);
    camera->ParallelProjectionOn();
    camera->SetParallelScale(1.0);
    camera->SetClippingRange(3.0, 7.0);
    this->Renderer->SetBackground(Background[0], Background[1], Background[2]);
    vtkNew<vtkPiecewiseFunction> opacity;
    opacity->AddPoint(0.0, kind.Opacity);
    this->Volume->GetProperty()->SetScalarOpacity(opacity);
    this->Renderer->RemoveAllViewProps();
    this->Prop = vtkSmartPointer<vtkVolume>::Take(
      kind.IsPlainVolume ? vtkVolume::New() : vtkTemporalCoherenceVolume::New());
    this->Prop->SetMapper(this->Mapper);
    this->Prop->SetProperty(this->Volume->GetProperty());
    if (!kind.IsLast)
    {
      this->Renderer->AddVolume(this->Prop);
    }
    this->AddRectangle({ -2.0, -2.0, -0.9 }, { 4.0, 2.0 }, Behind);
    this->AddRectangle({ 0.0, -2.0, 0.9 }, { 2.0, 4.0 }, Before);
    if (kind.IsLast)
    {
      this->Renderer->AddVolume(this->Prop);
    }
    OpenWindow(this->Window, this->Renderer, Size, Size);
  }

  void Draw()
  {
    this->Window->Render();
    this->Window->GetRGBACharPixelData(0, 0, Size - 1, Size - 1, 0, this->Pixels);
    this->Window->GetZbufferData(0, 0, Size - 1, Size - 1, this->Buffer);
  }

  Kind Of;
  vtkSmartPointer<vtkVolume> Prop;
  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkUnsignedCharArray> Pixels;
  vtkNew<vtkFloatArray> Buffer;

private:
  void AddRectangle(
    const std::array<double, 3>& corner, const std::array<double, 2>& edges, const Rgb& color)
  {
    vtkNew<vtkPlaneSource> plane;
    plane->SetOrigin(corner[0], corner[1], corner[2]);
    plane->SetPoint1(corner[0] + edges[0], corner[1], corner[2]);
    plane->SetPoint2(corner[0], corner[1] + edges[1], corner[2]);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(plane->GetOutputPort());
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->LightingOff();
    actor->GetProperty()->SetColor(color[0], color[1], color[2]);
    this->Renderer->AddActor(actor);
  }
};

/// Compare a window with a picture that lies between the props.
/// \param image of the sphere alone
void ExpectBlended(Stage& stage, const ColdWitness& image, const std::string& what)
{
  int edges = 0, different = 0, wrongDepth = 0;
  for (int pixel = 0; pixel < Size * Size; ++pixel)
  {
    const int x = pixel % Size, y = pixel / Size;
    const auto* sphere = static_cast<unsigned char*>(image.Color->GetScalarPointer(x, y, 0));
    const Rgb& behind = y < Size / 2 ? Behind : Background;
    const bool isHidden = x >= Size / 2;
    bool isSame = true;
    for (std::size_t c = 0; c < 3; ++c)
    {
      const double blended = sphere[c] + (255 - sphere[3]) * behind[c];
      const double expected = isHidden ? 255.0 * Before[c] : blended;
      isSame &= std::abs(stage.Pixels->GetValue(4 * pixel + static_cast<int>(c)) - expected) <= 2.5;
    }
    different += !isSame;
    const bool isEdge = sphere[3] > 0 && sphere[3] < 255;
    edges += isEdge && !isHidden;
    const double depth = stage.Buffer->GetValue(pixel);
    const double ofProps = isHidden ? 0.275 : y < Size / 2 ? 0.725 : 1.0;
    if (sphere[3] != 255 || isHidden)
    {
      wrongDepth += std::abs(depth - ofProps) > 1e-3;
    }
    else
    {
      wrongDepth += !(depth < ofProps - 1e-3);
    }
  }
  Expect(different == 0, what + ": " + std::to_string(different) + " pixels are not blended");
  Expect(wrongDepth == 0, what + ": " + std::to_string(wrongDepth) + " wrong depths");
  const bool isSmooth = image.Mapper->GetAntialiasing() != 0;
  Expect(stage.Of.Opacity < 1.0 || isSmooth == (edges > 50), what + ": edges");
}

void TestKind(const Kind& kind)
{
  Stage stage(kind);
  ColdWitness image;
  Expect(stage.Render(Size, Size), kind.Name + ": the size");
  stage.Mapper->ClearCache();
  stage.Draw();
  Expect(!stage.Mapper->GetFrameIsFinal(), kind.Name + ": not final");
  image.Draw(stage);
  ExpectBlended(stage, image, kind.Name + ", first frame");
  stage.Draw();
  Expect(stage.Mapper->GetFrameIsFinal(), kind.Name + ": final");
  image.Mapper->SetAntialiasingToAlways();
  image.Draw(stage);
  ExpectBlended(stage, image, kind.Name + ", second frame");
  stage.Draw();
  ExpectBlended(stage, image, kind.Name + ", third frame");

  // Picks are those of the centres of pixels.
  for (int pixel = 0; pixel < Size * Size; ++pixel)
  {
    const int x = pixel % Size, y = pixel / Size;
    double position[3], normal[3];
    int index;
    const bool isHit = std::isfinite(*static_cast<float*>(image.Depth->GetScalarPointer(x, y, 0)));
    if (stage.Mapper->PickPixel(x, y, position, normal, &index) != isHit)
    {
      Expect(false, kind.Name + ": picks");
      break;
    }
  }

  stage.Renderer->GetActiveCamera()->Azimuth(10.0);
  stage.Draw();
  Expect(!stage.Mapper->GetFrameIsFinal(), kind.Name + ": moving");
}

/// Edges of finer and coarser rays.
void TestDistances()
{
  for (const float distance : { 0.5f, 2.0f })
  {
    Stage stage({ "distance", true, true, 1.0, distance });
    stage.Draw();
    vtkNew<vtkUnsignedCharArray> first;
    first->DeepCopy(stage.Pixels);
    stage.Draw();
    Expect(stage.Mapper->GetFrameIsFinal(), "distance: final");
    int changed = 0;
    for (vtkIdType i = 0; i < first->GetNumberOfValues(); ++i)
    {
      changed += first->GetValue(i) != stage.Pixels->GetValue(i);
    }
    Expect(changed > 50, "distance " + std::to_string(distance) + ": edges change");
  }
}

}

int TestAntialiasedWindow(int, char*[])
{
  // The software rasteriser behind some windows divides by zero by itself.
  vtkFloatingPointExceptions::Disable();
  for (const Kind& kind : std::vector<Kind>{
         { "plain volume, first", true, false },
         { "plain volume, last", true, true },
         { "opaque prop, first", false, false },
         { "opaque prop, last", false, true },
         { "translucent", true, true, 0.5 },
       })
  {
    TestKind(kind);
  }
  TestDistances();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
