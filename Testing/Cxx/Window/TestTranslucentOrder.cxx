// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// An opaque plate among nested translucent spheres: each pixel shows the layers before the plate
// over it, however the plate moves and whatever it is drawn into.

#include "Checks/Expect.h"
#include "Scenes/OffScreen.h"
#include "Scenes/Scene.h"
#include "Truth/BruteForceTracer.h"
#include "Volumes/Volumes.h"
#include "vtkTemporalCoherenceVolume.h"

#include <vtkActor.h>
#include <vtkFloatingPointExceptions.h>
#include <vtkMatrix4x4.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPlaneSource.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderStepsPass.h>
#include <vtkSSAAPass.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <set>
#include <string>
#include <vector>

namespace
{

using Color = std::array<double, 3>;
constexpr Color OuterColor{ 1.0, 0.2, 0.0 };
constexpr Color InnerColor{ 0.0, 0.9, 0.3 };
constexpr Color PlateColor{ 0.1, 0.2, 1.0 };
constexpr Color Background{ 0.8, 0.8, 0.8 };
constexpr double OuterRadius = 0.9, InnerRadius = 0.5;
constexpr double HalfPlate = 1.0;
constexpr std::array<int, 2> WindowSize{ 160, 120 };

/// How a scene is drawn.
struct Setup
{
  std::string Name;
  bool IsParallel = false;
  int Samples = 0;              ///< of each pixel
  bool IsPart = false;          ///< of the window
  float SampleDistance = 1.0f;  ///< of the picture
  double InnerOpacity = 0.5;    ///< 1: an opaque core
  bool IsSuperSampled = false;  ///< by a render pass, in a framebuffer of its own
  int Reach = 1;                ///< pixels as far as this apart may have a share in one another
  std::size_t FewestOrders = 8; ///< of layers and plate, in all pictures together
};

/// Minus the distance from the middle.
vtkSmartPointer<vtkImageData> Ball()
{
  return Volumes::FromFormula(
    101, VTK_FLOAT, [](double x, double y, double z) { return -std::sqrt(x * x + y * y + z * z); });
}

/// What a ray meets.
struct Sight
{
  double Plate = std::numeric_limits<double>::infinity(); ///< distance
  std::vector<std::array<double, 2>> Layers;              ///< distance and radius, front to back

  int LayersBefore() const
  {
    return static_cast<int>(std::count_if(this->Layers.begin(), this->Layers.end(),
      [this](const std::array<double, 2>& layer) { return layer[0] < this->Plate; }));
  }

  /// The same number where the same things are seen in the same order.
  int Order() const
  {
    return (std::isfinite(this->Plate) ? 100 : 0) + 10 * static_cast<int>(this->Layers.size()) +
      this->LayersBefore();
  }
};

class PlateScene
{
public:
  explicit PlateScene(const Setup& how)
    : How(how)
    , Iso(Ball(), { -OuterRadius, -InnerRadius })
  {
    vtkVolumeProperty* property = this->Iso.Volume->GetProperty();
    property->ShadeOff();
    vtkNew<vtkColorTransferFunction> color;
    color->AddRGBPoint(-OuterRadius, OuterColor[0], OuterColor[1], OuterColor[2]);
    color->AddRGBPoint(-InnerRadius, InnerColor[0], InnerColor[1], InnerColor[2]);
    property->SetColor(color);
    vtkNew<vtkPiecewiseFunction> opacity;
    opacity->AddPoint(-OuterRadius, OuterOpacity);
    opacity->AddPoint(-InnerRadius, how.InnerOpacity);
    property->SetScalarOpacity(opacity);
    this->Iso.Mapper->SetImageSampleDistance(how.SampleDistance);

    vtkNew<vtkPlaneSource> plane;
    plane->SetOrigin(-HalfPlate, -HalfPlate, 0.0);
    plane->SetPoint1(HalfPlate, -HalfPlate, 0.0);
    plane->SetPoint2(-HalfPlate, HalfPlate, 0.0);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(plane->GetOutputPort());
    this->Plate->SetMapper(mapper);
    this->Plate->GetProperty()->LightingOff();
    this->Plate->GetProperty()->SetColor(PlateColor[0], PlateColor[1], PlateColor[2]);
    this->Iso.Renderer->AddActor(this->Plate);

    this->Iso.Renderer->SetBackground(Background[0], Background[1], Background[2]);
    if (how.IsPart)
    {
      this->Iso.Renderer->SetViewport(0.2, 0.1, 0.95, 0.9);
    }
    if (how.IsSuperSampled)
    {
      vtkNew<vtkRenderStepsPass> steps;
      vtkNew<vtkSSAAPass> pass;
      pass->SetDelegatePass(steps);
      this->Iso.Renderer->SetPass(pass);
    }
    vtkCamera* camera = this->Iso.Renderer->GetActiveCamera();
    camera->SetPosition(0.0, 0.0, 5.0);
    camera->SetFocalPoint(0.0, 0.0, 0.0);
    camera->SetParallelProjection(how.IsParallel);
    camera->SetParallelScale(1.1);
    camera->SetViewAngle(26.0);
    camera->SetClippingRange(2.0, 9.0);
    OpenWindow(this->Window, this->Iso.Renderer, WindowSize[0], WindowSize[1]);
    this->Window->SetMultiSamples(how.Samples);
  }

  /// Put the plate at a place before the spheres, tilted, and look.
  void LookFrom(double x, double z, double tilt)
  {
    this->Plate->SetPosition(x, 0.0, z);
    this->Plate->SetOrientation(0.0, tilt, 0.0);
    this->Window->Render();
    this->Compare(" at " + std::to_string(z) + ", " + std::to_string(tilt) + " degrees");
  }

  std::string Route() { return this->Iso.Mapper->GetStatistics()->GetRouteAsString(); }

  Scene Iso;
  vtkNew<vtkActor> Plate;
  vtkNew<vtkRenderWindow> Window;
  std::set<int> Orders; ///< of layers and plate, of all pixels that were looked at

private:
  static constexpr double OuterOpacity = 0.3;

  Sight SightOf(const BruteForceTracer::Line& line)
  {
    Sight sight;
    double along = 0.0, square = 0.0;
    for (std::size_t a = 0; a < 3; ++a)
    {
      along -= line.Origin[a] * line.Direction[a];
      square += line.Origin[a] * line.Origin[a];
    }
    for (const double radius : { OuterRadius, InnerRadius })
    {
      const double half = radius * radius - (square - along * along);
      if (half > 0.0)
      {
        sight.Layers.push_back({ along - std::sqrt(half), radius });
        sight.Layers.push_back({ along + std::sqrt(half), radius });
      }
    }
    std::sort(sight.Layers.begin(), sight.Layers.end());

    vtkNew<vtkMatrix4x4> toPlate;
    vtkMatrix4x4::Invert(this->Plate->GetMatrix(), toPlate);
    std::array<double, 4> eye{ line.Origin[0], line.Origin[1], line.Origin[2], 1.0 };
    std::array<double, 4> forth{ line.Direction[0], line.Direction[1], line.Direction[2], 0.0 };
    toPlate->MultiplyPoint(eye.data(), eye.data());
    toPlate->MultiplyPoint(forth.data(), forth.data());
    const double t = -eye[2] / forth[2];
    if (std::abs(eye[0] + t * forth[0]) < HalfPlate && std::abs(eye[1] + t * forth[1]) < HalfPlate)
    {
      sight.Plate = t;
    }
    return sight;
  }

  Color ColorOf(const Sight& sight) const
  {
    Color sum{};
    double through = 1.0;
    for (const std::array<double, 2>& layer : sight.Layers)
    {
      if (layer[0] < sight.Plate)
      {
        const bool isOuter = layer[1] == OuterRadius;
        const double opacity = isOuter ? OuterOpacity : this->How.InnerOpacity;
        Lay(isOuter ? OuterColor : InnerColor, through * opacity, sum);
        through *= 1.0 - opacity;
      }
    }
    Lay(std::isfinite(sight.Plate) ? PlateColor : Background, through, sum);
    return sum;
  }

  static void Lay(const Color& color, double share, Color& sum)
  {
    for (std::size_t c = 0; c < 3; ++c)
    {
      sum[c] += share * color[c];
    }
  }

  /// Compare all pixels in whose neighbourhood nothing changes but distances.
  void Compare(const std::string& what)
  {
    const int* origin = this->Iso.Renderer->GetOrigin();
    const int* size = this->Iso.Renderer->GetSize();
    const int width = size[0], height = size[1];
    std::vector<Sight> sights;
    for (int i = 0; i < width * height; ++i)
    {
      sights.push_back(this->SightOf(
        BruteForceTracer::LineThrough(this->Iso.Renderer, i % width, i / width, width, height)));
    }
    const auto pixels =
      PixelsOf(this->Window, origin[0], origin[1], origin[0] + width - 1, origin[1] + height - 1);
    const int reach = this->How.Reach;
    int compared = 0, wrong = 0;
    for (int y = reach; y < height - reach; ++y)
    {
      for (int x = reach; x < width - reach; ++x)
      {
        const Sight& sight = sights[static_cast<std::size_t>(y * width + x)];
        bool isClear = true;
        for (int near = 0; near < (2 * reach + 1) * (2 * reach + 1); ++near)
        {
          const int row = y - reach + near / (2 * reach + 1);
          const int column = x - reach + near % (2 * reach + 1);
          isClear &=
            sights[static_cast<std::size_t>(row * width + column)].Order() == sight.Order();
        }
        if (isClear)
        {
          const Color expected = this->ColorOf(sight);
          const unsigned char* shown = pixels->GetPointer(4 * (y * width + x));
          bool isRight = true;
          for (std::size_t c = 0; c < 3; ++c)
          {
            isRight &= std::abs(shown[c] - 255.0 * expected[c]) <= 2.0;
          }
          ++compared;
          wrong += !isRight;
          this->Orders.insert(sight.Order());
        }
      }
    }
    Expect(compared > width * height / 2 && wrong == 0,
      this->How.Name + what + ": " + std::to_string(wrong) + " of " + std::to_string(compared) +
        " pixels are wrong");
  }

  Setup How;
};

/// The plate moves from before the spheres to behind them; the picture of the volume stays.
void TestPlate(const Setup& how)
{
  PlateScene scene(how);
  scene.Plate->VisibilityOff();
  scene.LookFrom(100.0, 0.0, 0.0);
  scene.Plate->VisibilityOn();
  for (const double z : { 1.2, 0.7, 0.2, -0.3, -0.7, -1.2 })
  {
    scene.LookFrom(0.4, z, 0.0);
    Expect(scene.Route() == "Redisplay", how.Name + ": the picture stays, not " + scene.Route());
  }
  for (const double tilt : { 60.0, -40.0 })
  {
    scene.LookFrom(0.2, 0.0, tilt);
    Expect(scene.Route() == "Redisplay", how.Name + ": the picture stays, not " + scene.Route());
  }
  Expect(scene.Orders.size() >= how.FewestOrders,
    how.Name + ": there are " + std::to_string(scene.Orders.size()) + " orders");

  // Other colours, the plate where it was.
  scene.Iso.Volume->GetProperty()->ShadeOn();
  scene.Window->Render();
  Expect(scene.Route() == "Reshade", how.Name + ": shaded again, not " + scene.Route());
  scene.Iso.Volume->GetProperty()->ShadeOff();
  scene.LookFrom(0.2, 0.0, -40.0);
  Expect(scene.Route() == "Reshade", how.Name + ": shaded again, not " + scene.Route());
  // Nothing is left of the plate when it is gone.
  scene.Plate->VisibilityOff();
  scene.LookFrom(100.0, 0.0, 0.0);
}

/// Opaque isosurfaces between the layers are to them what polygons are, if they are drawn as such.
void TestOpaqueVolume()
{
  PlateScene scene{ Setup() };
  scene.Plate->VisibilityOff();
  Scene inside(Ball(), { -0.7 });
  vtkNew<vtkTemporalCoherenceVolume> volume;
  volume->SetMapper(inside.Mapper);
  volume->SetProperty(inside.Volume->GetProperty());
  volume->GetProperty()->ShadeOff();
  vtkNew<vtkColorTransferFunction> color;
  color->AddRGBPoint(0.0, PlateColor[0], PlateColor[1], PlateColor[2]);
  volume->GetProperty()->SetColor(color);
  scene.Iso.Renderer->AddVolume(volume); // after the translucent one
  scene.Window->Render();
  const auto pixel = PixelsOf(
    scene.Window, WindowSize[0] / 2, WindowSize[1] / 2, WindowSize[0] / 2, WindowSize[1] / 2);
  for (std::size_t c = 0; c < 3; ++c)
  {
    const double expected = 255.0 * (0.3 * OuterColor[c] + 0.7 * PlateColor[c]);
    Expect(std::abs(pixel->GetValue(static_cast<vtkIdType>(c)) - expected) <= 2.0,
      "the outer sphere over an opaque one, not what it hides");
  }
}

}

int TestTranslucentOrder(int, char*[])
{
  // The software rasteriser behind some windows divides by zero by itself.
  vtkFloatingPointExceptions::Disable();
  Setup how;
  how.Name = "perspective";
  TestPlate(how);
  how.Name = "opaque core";
  how.InnerOpacity = 1.0;
  TestPlate(how);
  how = Setup();
  how.Name = "parallel";
  how.IsParallel = true;
  TestPlate(how);
  how.Name = "part of the window";
  how.IsPart = true;
  TestPlate(how);
  how.Name = "coarse part";
  how.SampleDistance = 2.0f;
  how.Reach = 2;
  TestPlate(how);
  how = Setup();
  how.Name = "coarse";
  how.SampleDistance = 2.7f;
  how.Reach = 3;
  TestPlate(how);
  how = Setup();
  how.Name = "fine";
  how.SampleDistance = 0.5f;
  TestPlate(how);
  how.Name = "fine part";
  how.SampleDistance = 0.3f;
  how.IsPart = true;
  TestPlate(how);
  how = Setup();
  how.Name = "fine, opaque core, parallel";
  how.SampleDistance = 0.7f;
  how.InnerOpacity = 1.0;
  how.IsParallel = true;
  TestPlate(how);
  how = Setup();
  how.Name = "multisampled";
  how.Samples = 4;
  TestPlate(how);
  how.Name = "multisampled part";
  how.IsPart = true;
  TestPlate(how);
  how = Setup();
  how.Name = "supersampled";
  how.IsSuperSampled = true;
  how.Reach = 3;
  TestPlate(how);
  TestOpaqueVolume();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
