// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// vtkTemporalCoherenceVolume among translucent polygons, under ambient occlusion and shadows, is
// what arithmetic says, or looks as polygons in its place.

#include "Checks/Expect.h"
#include "Scenes/OffScreen.h"
#include "Scenes/Scene.h"
#include "Volumes/Volumes.h"
#include "vtkTemporalCoherenceVolume.h"

#include <vtkActor.h>
#include <vtkCameraPass.h>
#include <vtkFloatingPointExceptions.h>
#include <vtkLight.h>
#include <vtkObjectFactory.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPlaneSource.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderPassCollection.h>
#include <vtkRenderStepsPass.h>
#include <vtkSSAOPass.h>
#include <vtkSequencePass.h>
#include <vtkShadowMapBakerPass.h>
#include <vtkShadowMapPass.h>
#include <vtkSphereSource.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <string>

namespace
{

constexpr int Size = 120;
using Color = std::array<double, 3>;
constexpr Color Surface{ 0.9, 0.8, 0.7 }; ///< what the scene's volumes look like
constexpr Color Glass{ 0.0, 0.2, 1.0 };
constexpr Color Smoke{ 1.0, 0.0, 0.0 };

/// A scene without light whose volume is a vtkTemporalCoherenceVolume, seen from above without
/// perspective: x and y from -1 to 1.
struct FlatScene
{
  FlatScene(vtkImageData* image, double isovalue)
    : Iso(image, { isovalue })
  {
    this->Volume->SetMapper(this->Iso.Mapper);
    this->Volume->SetProperty(this->Iso.Volume->GetProperty());
    this->Volume->GetProperty()->ShadeOff();
    this->Iso.Renderer->RemoveVolume(this->Iso.Volume);
    this->Iso.Renderer->AddVolume(this->Volume);
    vtkCamera* camera = this->Iso.Renderer->GetActiveCamera();
    camera->SetPosition(0.0, 0.0, 5.0);
    camera->SetFocalPoint(0.0, 0.0, 0.0);
    camera->ParallelProjectionOn();
    camera->SetParallelScale(1.0);
    camera->SetClippingRange(3.0, 7.0);
    OpenWindow(this->Window, this->Iso.Renderer, Size, Size);
  }

  vtkActor* AddGlass(const Color& color, double opacity, const std::array<double, 3>& origin,
    const std::array<double, 3>& first, const std::array<double, 3>& second)
  {
    vtkNew<vtkPlaneSource> plane;
    plane->SetOrigin(origin[0], origin[1], origin[2]);
    plane->SetPoint1(first[0], first[1], first[2]);
    plane->SetPoint2(second[0], second[1], second[2]);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(plane->GetOutputPort());
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->LightingOff();
    actor->GetProperty()->SetColor(color[0], color[1], color[2]);
    actor->GetProperty()->SetOpacity(opacity);
    this->Iso.Renderer->AddActor(actor);
    return actor;
  }

  /// True if the window shows a colour at (x, y) of the world.
  bool Shows(double x, double y, const Color& expected)
  {
    const int column = static_cast<int>((x + 1.0) * Size / 2);
    const int row = static_cast<int>((y + 1.0) * Size / 2);
    const auto pixel = PixelsOf(this->Window, column, row, column, row);
    for (int c = 0; c < 3; ++c)
    {
      if (std::abs(pixel->GetValue(c) - 255.0 * expected[static_cast<std::size_t>(c)]) > 2.5)
      {
        std::cerr << "channel " << c << " is " << +pixel->GetValue(c) << " for "
                  << 255.0 * expected[static_cast<std::size_t>(c)] << '\n';
        return false;
      }
    }
    return true;
  }

  Scene Iso;
  vtkNew<vtkTemporalCoherenceVolume> Volume;
  vtkNew<vtkRenderWindow> Window;
};

Color Over(const Color& front, double opacity, const Color& back)
{
  Color result{};
  for (std::size_t c = 0; c < 3; ++c)
  {
    result[c] = opacity * front[c] + (1.0 - opacity) * back[c];
  }
  return result;
}

/// The share of pixels of two windows that differ by more than some steps of the colour scale.
double ShareThatDiffers(vtkUnsignedCharArray* a, vtkUnsignedCharArray* b, int steps)
{
  int different = 0;
  for (vtkIdType i = 0; i < a->GetNumberOfValues(); i += 4)
  {
    different += std::abs(a->GetValue(i) - b->GetValue(i)) > steps;
  }
  return 4.0 * different / static_cast<double>(a->GetNumberOfValues());
}

/// A surface at z = 0 where x < 0.5; nothing to the right of it.
vtkSmartPointer<vtkImageData> HalfPlane()
{
  return Volumes::FromFormula(
    41, VTK_FLOAT, [](double x, double, double z) { return x < 0.51 ? -z : -1.0; });
}

/// Glass behind, before and through the surface, each a stripe of its own; smoke before all in the
/// left third.
void TestTranslucentPolygons(bool peels)
{
  const std::string name = peels ? "peeled" : "sorted";
  FlatScene scene(HalfPlane(), 0.0);
  scene.AddGlass(Glass, 0.4, { -1.0, -0.9, 0.4 }, { 0.8, -0.9, 0.4 }, { -1.0, -0.4, 0.4 });
  scene.AddGlass(Glass, 0.4, { -1.0, -0.2, -0.4 }, { 0.8, -0.2, -0.4 }, { -1.0, 0.2, -0.4 });
  scene.AddGlass(Glass, 0.4, { -1.0, 0.4, -0.5 }, { 0.0, 0.4, 0.5 }, { -1.0, 0.9, -0.5 });
  scene.AddGlass(Smoke, 0.25, { -1.0, -1.0, 0.8 }, { -0.7, -1.0, 0.8 }, { -1.0, 1.0, 0.8 });
  if (peels)
  {
    scene.Window->SetAlphaBitPlanes(1);
    scene.Iso.Renderer->SetUseDepthPeeling(1);
    scene.Iso.Renderer->SetMaximumNumberOfPeels(10);
    scene.Iso.Renderer->SetOcclusionRatio(0.0);
  }
  scene.Window->Render();
  const auto withVolume = PixelsOf(scene.Window);

  const Color black{};
  Expect(scene.Shows(0.2, 0.3, Surface), name + ": the surface");
  Expect(scene.Shows(0.0, -0.6, Over(Glass, 0.4, Surface)), name + ": glass before it");
  Expect(scene.Shows(0.0, 0.0, Surface), name + ": glass behind it");
  Expect(scene.Shows(-0.25, 0.6, Over(Glass, 0.4, Surface)), name + ": the glass that comes out");
  Expect(scene.Shows(-0.62, 0.6, Surface), name + ": the glass that is inside");
  Expect(scene.Shows(0.65, -0.6, Over(Glass, 0.4, black)), name + ": glass beside it");
  Expect(scene.Shows(0.65, 0.0, Over(Glass, 0.4, black)), name + ": glass behind, beside it");
  Expect(scene.Shows(-0.85, 0.0, Over(Smoke, 0.25, Surface)), name + ": smoke");
  Expect(scene.Shows(-0.85, 0.6, Over(Smoke, 0.25, Surface)), name + ": smoke, glass behind");
  // A plain volume is drawn last of all: this prop is what makes the difference.
  scene.Iso.Renderer->RemoveVolume(scene.Volume);
  scene.Iso.Renderer->AddVolume(scene.Iso.Volume);
  scene.Window->Render();
  Expect(scene.Shows(0.0, -0.6, Surface), name + ": vtkVolume covers glass");

  // A polygon in place of the isosurface.
  scene.Iso.Renderer->RemoveVolume(scene.Iso.Volume);
  scene.AddGlass(Surface, 1.0, { -1.0, -1.0, 0.0 }, { 0.5, -1.0, 0.0 }, { -1.0, 1.0, 0.0 });
  scene.Window->Render();
  const auto withPolygon = PixelsOf(scene.Window);
  const double share = ShareThatDiffers(withVolume, withPolygon, 2);
  Expect(share < 0.01, name + ": unlike polygons in " + std::to_string(share) + " of the pixels");
}

/// Any other mapper of volumes.
class CountingMapper : public vtkVolumeMapper
{
public:
  static CountingMapper* New();
  vtkTypeMacro(CountingMapper, vtkVolumeMapper);
  void Render(vtkRenderer*, vtkVolume*) override { ++this->Renders; }
  void ReleaseGraphicsResources(vtkWindow*) override {}

  int Renders = 0;
};
vtkStandardNewMacro(CountingMapper);

/// In which pass the prop draws.
void TestPasses()
{
  FlatScene scene(HalfPlane(), 0.0);
  Expect(scene.Volume->HasOpaqueGeometry() && !scene.Volume->HasTranslucentPolygonalGeometry(),
    "opaque by default");
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.0, 0.5);
  scene.Volume->GetProperty()->SetScalarOpacity(opacity);
  Expect(!scene.Volume->HasOpaqueGeometry(), "translucent isovalue");
  scene.Window->Render();
  opacity->RemoveAllPoints();
  opacity->AddPoint(0.0, 1.0);
  Expect(scene.Volume->HasOpaqueGeometry(), "opaque isovalue");
  vtkNew<vtkPiecewiseFunction> gradientOpacity;
  gradientOpacity->AddPoint(0.0, 0.0);
  gradientOpacity->AddPoint(1.0, 1.0);
  scene.Volume->GetProperty()->SetGradientOpacity(gradientOpacity);
  Expect(!scene.Volume->HasOpaqueGeometry(), "gradient opacity");
  scene.Volume->GetProperty()->DisableGradientOpacityOn();
  Expect(scene.Volume->HasOpaqueGeometry(), "gradient opacity switched off");

  scene.Window->Render();
  Expect(scene.Shows(0.0, 0.0, Surface), "drawn");
  const vtkIdType rays = scene.Iso.Mapper->GetStatistics()->GetNumberOfRays();
  scene.Iso.Mapper->ClearCache();
  Expect(scene.Volume->RenderVolumetricGeometry(scene.Iso.Renderer) == 0 &&
      scene.Iso.Mapper->GetStatistics()->GetNumberOfRays() == 0 && rays > 0,
    "not in the other pass");

  // Another mapper is served as by vtkVolume.
  vtkNew<CountingMapper> other;
  other->SetInputData(scene.Iso.Mapper->GetInput());
  scene.Volume->SetMapper(other);
  Expect(!scene.Volume->HasOpaqueGeometry(), "another mapper");
  Expect(scene.Volume->RenderOpaqueGeometry(scene.Iso.Renderer) == 0 && other->Renders == 0,
    "not in the opaque pass");
  scene.Window->Render();
  Expect(other->Renders == 1, "once, with the volumes");
  scene.Volume->SetMapper(nullptr);
  Expect(!scene.Volume->HasOpaqueGeometry(), "no mapper");
}

/// A polygonal stand-in for an isosurface, in its colour.
vtkNew<vtkActor> StandIn(vtkAlgorithm* source, double ambient)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  vtkProperty* property = actor->GetProperty();
  property->SetColor(Surface[0], Surface[1], Surface[2]);
  property->SetAmbient(ambient);
  property->SetDiffuse(1.0 - ambient);
  return actor;
}

vtkNew<vtkSphereSource> Sphere(double radius, double x, double y, double z)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(radius);
  sphere->SetCenter(x, y, z);
  sphere->SetThetaResolution(200);
  sphere->SetPhiResolution(200);
  return sphere;
}

/// A ball on a plain, one of them an isosurface: as dark where they meet as with polygons only.
void TestAmbientOcclusion(bool isPlainVolume)
{
  const std::string name = isPlainVolume ? "the plain occludes" : "the ball occludes";
  const auto image = Volumes::FromFormula(61, VTK_FLOAT,
    [=](double x, double y, double z) { return isPlainVolume ? -z : -std::hypot(x, y, z - 0.3); });
  FlatScene scene(image, isPlainVolume ? 0.0 : -0.4);
  // Since VTK 9.6 the pass wants volumes to be shaded: here with light from everywhere.
  vtkVolumeProperty* property = scene.Volume->GetProperty();
  property->ShadeOn();
  property->SetAmbient(1.0);
  property->SetDiffuse(0.0);
  property->SetSpecular(0.0);
  vtkCamera* camera = scene.Iso.Renderer->GetActiveCamera();
  camera->ParallelProjectionOff();
  camera->SetViewAngle(20.0);
  camera->Elevation(-35.0);
  vtkNew<vtkPlaneSource> plain;
  plain->SetOrigin(-1.0, -1.0, 0.0);
  plain->SetPoint1(1.0, -1.0, 0.0);
  plain->SetPoint2(-1.0, 1.0, 0.0);
  const auto sphere = Sphere(0.4, 0.0, 0.0, 0.3);
  const auto ofPlain = StandIn(plain, 1.0), ofSphere = StandIn(sphere, 1.0);
  scene.Iso.Renderer->AddActor(isPlainVolume ? ofSphere : ofPlain);

  vtkNew<vtkRenderStepsPass> steps;
  vtkNew<vtkSSAOPass> occlusion;
  occlusion->SetRadius(0.5);
  occlusion->SetBias(0.01);
  occlusion->SetKernelSize(64);
  occlusion->SetDelegatePass(steps);
  scene.Iso.Renderer->SetPass(occlusion);
  scene.Window->Render();
  const auto withVolume = PixelsOf(scene.Window);
  scene.Iso.Renderer->RemoveVolume(scene.Volume);
  scene.Iso.Renderer->AddActor(isPlainVolume ? ofPlain : ofSphere);
  scene.Window->Render();
  const auto withPolygons = PixelsOf(scene.Window);
  occlusion->ReleaseGraphicsResources(scene.Window);
  scene.Iso.Renderer->SetPass(nullptr);
  scene.Window->Render();
  const auto withoutPass = PixelsOf(scene.Window);
  const double effect = ShareThatDiffers(withPolygons, withoutPass, 20);
  Expect(effect > 0.05, name + ": there is occlusion, " + std::to_string(effect));
  const double share = ShareThatDiffers(withVolume, withPolygons, 8);
  Expect(share < 0.01, name + ": " + std::to_string(share) + " of the pixels differ");
}

/// The shadow of a ball on a plain that it touches, where VTK's shadows are faint, with another
/// ball between it and the light.
void TestShadows(bool isSpot)
{
  const std::string name = isSpot ? "spot light" : "sunlight";
  const auto image = Volumes::FromFormula(
    61, VTK_FLOAT, [](double x, double y, double z) { return -std::hypot(x, y, z - 0.2); });
  FlatScene scene(image, -0.3);
  scene.Iso.Renderer->SetBackground(0.0, 0.0, 0.3);
  vtkNew<vtkPlaneSource> plain;
  plain->SetOrigin(-1.5, -1.5, 0.0);
  plain->SetPoint1(1.5, -1.5, 0.0);
  plain->SetPoint2(-1.5, 1.5, 0.0);
  const auto sphere = Sphere(0.3, 0.0, 0.0, 0.2);
  const auto ofPlain = StandIn(plain, 0.0), ofSphere = StandIn(sphere, 1.0);
  scene.Iso.Renderer->AddActor(ofPlain);
  const auto nearLight = Sphere(0.1, 0.5, 0.0, 1.2);
  const auto before = StandIn(nearLight, 0.0);
  scene.Iso.Renderer->AddActor(before);
  vtkNew<vtkLight> light;
  light->SetLightTypeToSceneLight();
  light->SetPositional(isSpot);
  light->SetPosition(1.5, 0.0, 3.0);
  light->SetFocalPoint(0.0, 0.0, 0.0);
  light->SetConeAngle(40.0);
  scene.Iso.Renderer->AddLight(light);

  vtkNew<vtkShadowMapPass> shadows;
  shadows->GetShadowMapBakerPass()->SetResolution(512);
  vtkNew<vtkRenderPassCollection> passes;
  passes->AddItem(shadows->GetShadowMapBakerPass());
  passes->AddItem(shadows);
  vtkNew<vtkSequencePass> sequence;
  sequence->SetPasses(passes);
  vtkNew<vtkCameraPass> pass;
  pass->SetDelegatePass(sequence);
  scene.Iso.Renderer->SetPass(pass);
  scene.Window->Render();
  scene.Window->Render();
  const auto withVolume = PixelsOf(scene.Window);
  Expect(std::string(scene.Iso.Mapper->GetStatistics()->GetRouteAsString()) == "Redisplay",
    name + ": the eye's picture stays");
  scene.Iso.Renderer->RemoveVolume(scene.Volume);
  scene.Window->Render();
  const auto withNeither = PixelsOf(scene.Window);
  scene.Iso.Renderer->AddActor(ofSphere);
  scene.Window->Render();
  const auto withPolygons = PixelsOf(scene.Window);
  const double effect = ShareThatDiffers(withPolygons, withNeither, 40);
  Expect(effect > 0.02, name + ": there is a shadow, " + std::to_string(effect));
  const double share = ShareThatDiffers(withVolume, withPolygons, 20);
  Expect(share < 0.005, name + ": " + std::to_string(share) + " of the pixels differ");
}

}

int TestOrder(int, char*[])
{
  // The software rasteriser behind some windows divides by zero by itself.
  vtkFloatingPointExceptions::Disable();
  TestTranslucentPolygons(false);
  TestTranslucentPolygons(true);
  TestPasses();
  TestAmbientOcclusion(true);
  TestAmbientOcclusion(false);
  TestShadows(false);
  TestShadows(true);
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
