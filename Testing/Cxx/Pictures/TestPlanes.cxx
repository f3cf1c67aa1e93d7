// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// The planes of a frame as images, and the surface that it shows as points.

#include "Checks/Expect.h"
#include "Scenes/Scene.h"
#include "Volumes/Volumes.h"

#include <vtkCell.h>
#include <vtkDataArray.h>
#include <vtkFloatingPointExceptions.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkRenderWindow.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <string>

namespace
{

struct Planes
{
  bool Render(Scene& scene, int width, int height)
  {
    return scene.Mapper->RenderToImage(scene.Renderer, scene.Volume, width, height, this->Color,
      this->Depth, this->Normals, this->Isovalues, this->Answers);
  }
  bool Get(Scene& scene)
  {
    return scene.Mapper->GetLastFrame(
      this->Color, this->Depth, this->Normals, this->Isovalues, this->Answers);
  }
  static double At(vtkImageData* image, int x, int y, int component = 0)
  {
    return image->GetScalarComponentAsDouble(x, y, 0, component);
  }
  std::array<vtkImageData*, 5> All() const
  {
    return { this->Color, this->Depth, this->Normals, this->Isovalues, this->Answers };
  }

  vtkNew<vtkImageData> Color, Depth, Normals, Isovalues, Answers;
};

/// Four isovalues, the third of them without opacity.
struct CutScene : Scene
{
  CutScene()
    : Scene(Volumes::FourSpheres(40), { 180.0, 100.0, 60.0, 140.0 })
  {
    vtkNew<vtkPiecewiseFunction> opacity;
    opacity->AddPoint(60.0, 0.0);
    opacity->AddPoint(100.0, 1.0);
    this->Volume->GetProperty()->SetScalarOpacity(opacity);
    this->LookFrom(1.0, 2.0, 0.5);
    // Cut open, so that more than the outermost surface is seen.
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    const double* range = camera->GetClippingRange();
    camera->SetClippingRange(0.5 * (range[0] + range[1]), range[1]);
  }
};

/// Every plane is what the pixels tell when they are picked one by one.
void ExpectPixels(const std::string& what, Scene& scene, const Planes& planes)
{
  int size[3];
  planes.Depth->GetDimensions(size);
  int different = 0;
  std::array<int, 4> seen{};
  for (int y = 0; y < size[1]; ++y)
  {
    for (int x = 0; x < size[0]; ++x)
    {
      double position[3], normal[3] = { 0.0, 0.0, 0.0 };
      int index = -1;
      const bool isHit = scene.Mapper->PickPixel(x, y, position, normal, &index);
      different += Planes::At(planes.Isovalues, x, y) != index;
      different += std::isinf(Planes::At(planes.Depth, x, y)) == isHit;
      different += (Planes::At(planes.Color, x, y, 3) != 0.0) != isHit;
      different += Planes::At(planes.Answers, x, y) == 0.0 && isHit;
      for (int c = 0; c < 3; ++c)
      {
        different += Planes::At(planes.Normals, x, y, c) != normal[c];
      }
      if (isHit)
      {
        ++seen[static_cast<std::size_t>(index)];
        const double* eye = scene.Renderer->GetActiveCamera()->GetPosition();
        const double t =
          std::hypot(position[0] - eye[0], position[1] - eye[1], position[2] - eye[2]);
        different += std::abs(Planes::At(planes.Depth, x, y) - t) > 1e-5 * t;
      }
    }
  }
  Expect(different == 0, what + ": " + std::to_string(different) + " values differ");
  Expect(seen[0] > 20 && seen[1] > 20 && seen[2] == 0 && seen[3] > 20,
    what + ": three of four isovalues are seen");
}

void TestPlanesOfImage()
{
  CutScene scene;
  Planes planes;
  Expect(!planes.Get(scene), "no frame, no images");
  Expect(planes.Color->GetNumberOfPoints() == 0, "and they are left alone");
  Expect(planes.Render(scene, 90, 70), "rendered");
  const std::array<int, 5> types = { VTK_UNSIGNED_CHAR, VTK_FLOAT, VTK_FLOAT, VTK_INT,
    VTK_UNSIGNED_CHAR };
  const std::array<int, 5> components = { 4, 1, 3, 1, 1 };
  const std::array<std::string, 5> names = { "Color", "Depth", "Normals", "IsovalueIndex",
    "Answer" };
  for (std::size_t i = 0; i < 5; ++i)
  {
    vtkImageData* image = planes.All()[i];
    vtkDataArray* scalars = image->GetPointData()->GetScalars();
    const int* size = image->GetDimensions();
    Expect(size[0] == 90 && size[1] == 70 && size[2] == 1 && scalars->GetDataType() == types[i] &&
        scalars->GetNumberOfComponents() == components[i] && scalars->GetName() == names[i],
      names[i] + ": size, type and name");
  }
  ExpectPixels("image", scene, planes);
  Expect(scene.Render(90, 70) && AreIdentical(scene.Color, planes.Color) &&
      AreIdentical(scene.Depth, planes.Depth),
    "colour and depth are those without the rest");

  // Each alone, into memory that is there and that others see.
  for (std::size_t i = 0; i < 5; ++i)
  {
    const std::array<vtkImageData*, 5> all = planes.All();
    vtkNew<vtkImageData> before, kept, alone;
    before->DeepCopy(all[i]);
    kept->ShallowCopy(all[i]);
    std::array<vtkImageData*, 5> one{};
    one[i] = alone;
    Expect(scene.Mapper->GetLastFrame(one[0], one[1], one[2], one[3], one[4]) &&
        AreIdentical(alone, before),
      names[i] + ": alone");
    void* memory = alone->GetScalarPointer();
    Expect(scene.Mapper->GetLastFrame(one[0], one[1], one[2], one[3], one[4]) &&
        alone->GetScalarPointer() == memory,
      names[i] + ": keeps its memory");
    scene.Renderer->GetActiveCamera()->Azimuth(20.0);
    Expect(planes.Render(scene, 90, 70) && AreIdentical(kept, before),
      names[i] + ": what others see is not written");
    scene.Renderer->GetActiveCamera()->Azimuth(-20.0);
    Expect(planes.Render(scene, 90, 70), "back");
  }
  scene.Mapper->ReleaseReuse();
  Expect(!planes.Get(scene), "forgotten");
}

/// What the answers count is what the mapper counts.
void TestAnswers()
{
  CutScene scene;
  Planes planes;
  Expect(planes.Render(scene, 120, 120), "rendered");
  scene.Renderer->GetActiveCamera()->Azimuth(1.0);
  Expect(planes.Render(scene, 120, 120), "rendered");
  Expect(std::string(scene.Mapper->GetRouteAsString()) == "ImageCache", "from the cache");
  std::array<vtkIdType, 3> counts{};
  for (int y = 0; y < 120; ++y)
  {
    for (int x = 0; x < 120; ++x)
    {
      ++counts[static_cast<std::size_t>(Planes::At(planes.Answers, x, y))];
    }
  }
  Expect(counts[0] == scene.Mapper->GetNumberOfDefiniteMisses() &&
      counts[1] == scene.Mapper->GetNumberOfDefiniteHits() &&
      counts[2] == scene.Mapper->GetNumberOfPossibleHits(),
    "answers add up to the counters");
  Expect(counts[0] > 0 && counts[1] > 0 && counts[2] > 0, "every answer is there");
}

void TestPlanesOfWindow()
{
  CutScene scene;
  vtkNew<vtkRenderWindow> window;
  window->SetMultiSamples(0);
  window->SetSize(100, 80);
  window->AddRenderer(scene.Renderer);
  window->Render();
  Planes planes;
  Expect(planes.Get(scene), "the frame of a window");
  ExpectPixels("window", scene, planes);
  Expect(scene.Render(100, 80) && AreIdentical(scene.Color, planes.Color) &&
      AreIdentical(scene.Depth, planes.Depth),
    "is that of an image");
}

/// Every pixel with a surface is a point.
void TestVisibleSurface()
{
  CutScene scene;
  vtkNew<vtkPolyData> points;
  Expect(!scene.Mapper->GetVisibleSurface(points) && !scene.Mapper->GetVisibleSurface(nullptr) &&
      points->GetNumberOfPoints() == 0,
    "no frame, no points");
  Planes planes;
  Expect(planes.Render(scene, 83, 71), "rendered");
  Expect(!scene.Mapper->GetVisibleSurface(nullptr), "nowhere to write");
  Expect(scene.Mapper->GetVisibleSurface(points), "points");
  vtkPointData* data = points->GetPointData();
  vtkDataArray* normals = data->GetNormals();
  vtkDataArray* colors = data->GetScalars();
  vtkDataArray* isovalues = data->GetArray("Isovalue");
  vtkDataArray* indices = data->GetArray("IsovalueIndex");
  if (!normals || !colors || !isovalues || !indices)
  {
    Expect(false, "all arrays are there");
    return;
  }
  const std::array<double, 4> values = { 180.0, 100.0, 60.0, 140.0 };
  vtkIdType at = 0;
  int different = 0;
  for (int y = 0; y < 71; ++y)
  {
    for (int x = 0; x < 83; ++x)
    {
      double position[3], normal[3];
      int index = -1;
      if (!scene.Mapper->PickPixel(x, y, position, normal, &index) ||
        at >= points->GetNumberOfPoints())
      {
        continue;
      }
      different += isovalues->GetComponent(at, 0) != values[static_cast<std::size_t>(index)];
      different += indices->GetComponent(at, 0) != index;
      for (int c = 0; c < 3; ++c)
      {
        different += points->GetPoint(at)[c] != position[c];
        different += normals->GetComponent(at, c) != normal[c];
      }
      for (int c = 0; c < 4; ++c)
      {
        different += colors->GetComponent(at, c) != Planes::At(planes.Color, x, y, c);
      }
      ++at;
    }
  }
  Expect(at > 100 && at == points->GetNumberOfPoints(),
    "a point for each of " + std::to_string(at) + " hits");
  Expect(different == 0, std::to_string(different) + " values differ");
  vtkIdType wrong = points->GetNumberOfVerts() != at;
  for (vtkIdType i = 0; i < points->GetNumberOfCells(); ++i)
  {
    vtkCell* vertex = points->GetCell(i);
    wrong += vertex->GetNumberOfPoints() != 1 || vertex->GetPointId(0) != i;
  }
  Expect(wrong == 0, "a vertex for each point");

  scene.SetIsovalues({});
  Expect(planes.Render(scene, 83, 71) && scene.Mapper->GetVisibleSurface(points) &&
      points->GetNumberOfPoints() == 0 && points->GetNumberOfCells() == 0,
    "an empty picture has no points");
}

}

int TestPlanes(int, char*[])
{
  vtkFloatingPointExceptions::Disable();
  TestPlanesOfImage();
  TestAnswers();
  TestPlanesOfWindow();
  TestVisibleSurface();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
