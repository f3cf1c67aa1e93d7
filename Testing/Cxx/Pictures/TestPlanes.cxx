// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// The arrays of a frame in one image, and the points of its surface, are what the pixels show.

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

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <string>

namespace
{

using Mapper = vtkTemporalCoherenceVolumeMapper;

struct ArrayFormat
{
  int Bit;
  const char* Name;
  int Type, Components;
};

const std::array<ArrayFormat, 5> Formats = { {
  { Mapper::FRAME_COLOR, "Color", VTK_UNSIGNED_CHAR, 4 },
  { Mapper::FRAME_DEPTH, "Depth", VTK_FLOAT, 1 },
  { Mapper::FRAME_NORMALS, "Normals", VTK_FLOAT, 3 },
  { Mapper::FRAME_ISOVALUE_INDEX, "IsovalueIndex", VTK_INT, 1 },
  { Mapper::FRAME_ANSWER, "Answer", VTK_UNSIGNED_CHAR, 1 },
} };

/// All arrays of a frame.
struct Planes
{
  bool Render(Scene& scene, int width, int height)
  {
    return scene.Mapper->MakeImage(scene.Renderer, scene.Volume, width, height, this->Image);
  }
  bool Get(Scene& scene) { return scene.Mapper->GetLastFrame(this->Image); }
  double At(const char* array, int x, int y, int component = 0) const
  {
    const vtkIdType pixel = y * static_cast<vtkIdType>(this->Image->GetDimensions()[0]) + x;
    return this->Image->GetPointData()->GetArray(array)->GetComponent(pixel, component);
  }

  vtkNew<vtkImageData> Image;
};

/// True if an image has an array with the bytes of a plane.
bool HasPlane(vtkImageData* image, const Planes& planes, const ArrayFormat& format)
{
  vtkDataArray* a = image->GetPointData()->GetArray(format.Name);
  vtkDataArray* b = planes.Image->GetPointData()->GetArray(format.Name);
  return a && b && a->GetDataType() == b->GetDataType() &&
    a->GetNumberOfValues() == b->GetNumberOfValues() &&
    std::memcmp(a->GetVoidPointer(0), b->GetVoidPointer(0),
      static_cast<std::size_t>(a->GetNumberOfValues() * a->GetDataTypeSize())) == 0;
}

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
  planes.Image->GetDimensions(size);
  int different = 0;
  std::array<int, 4> seen{};
  for (int y = 0; y < size[1]; ++y)
  {
    for (int x = 0; x < size[0]; ++x)
    {
      double position[3], normal[3] = { 0.0, 0.0, 0.0 };
      int index = -1;
      const bool isHit = scene.Mapper->PickPixel(x, y, position, normal, &index);
      different += planes.At("IsovalueIndex", x, y) != index;
      different += std::isinf(planes.At("Depth", x, y)) == isHit;
      different += (planes.At("Color", x, y, 3) != 0.0) != isHit;
      different += planes.At("Answer", x, y) == 0.0 && isHit;
      for (int c = 0; c < 3; ++c)
      {
        different += planes.At("Normals", x, y, c) != normal[c];
      }
      if (isHit)
      {
        ++seen[static_cast<std::size_t>(index)];
        const double* eye = scene.Renderer->GetActiveCamera()->GetPosition();
        const double t =
          std::hypot(position[0] - eye[0], position[1] - eye[1], position[2] - eye[2]);
        different += std::abs(planes.At("Depth", x, y) - t) > 1e-5 * t;
      }
    }
  }
  Expect(different == 0, what + ": " + std::to_string(different) + " values differ");
  Expect(seen[0] > 20 && seen[1] > 20 && seen[2] == 0 && seen[3] > 20,
    what + ": three of four isovalues are seen");
}

/// The image holds these arrays and nothing else, with the first as active scalars.
void ExpectArrays(const std::string& what, vtkImageData* image, int arrays, int width, int height)
{
  vtkPointData* data = image->GetPointData();
  const int* size = image->GetDimensions();
  Expect(size[0] == width && size[1] == height && size[2] == 1, what + ": size");
  int count = 0;
  for (const ArrayFormat& format : Formats)
  {
    vtkDataArray* array = data->GetArray(format.Name);
    const bool isWanted = (arrays & format.Bit) != 0;
    Expect((array != nullptr) == isWanted, what + ": " + format.Name + " is there if asked for");
    if (array)
    {
      Expect(array->GetDataType() == format.Type &&
          array->GetNumberOfComponents() == format.Components &&
          array->GetNumberOfTuples() == image->GetNumberOfPoints(),
        what + ": " + format.Name + ": type and size");
      Expect((data->GetScalars() == array) == (count == 0),
        what + ": " + format.Name + ": the first array is the active scalars");
      ++count;
    }
  }
  Expect(data->GetNumberOfArrays() == count, what + ": no other arrays");
  Expect((data->GetNormals() != nullptr) == ((arrays & Mapper::FRAME_NORMALS) != 0),
    what + ": active normals");
}

void TestPlanesOfImage()
{
  CutScene scene;
  Planes planes;
  Expect(!planes.Get(scene), "no frame, no image");
  Expect(planes.Image->GetNumberOfPoints() == 0, "and it is left alone");
  Expect(planes.Render(scene, 90, 70), "rendered");
  ExpectArrays("rendered", planes.Image, Mapper::FRAME_ALL, 90, 70);
  ExpectPixels("image", scene, planes);
  Expect(scene.Render(90, 70) && HasPlane(scene.Color, planes, Formats[0]) &&
      HasPlane(scene.Depth, planes, Formats[1]),
    "colour and depth are those without the rest");
  ExpectArrays("two images", scene.Color, Mapper::FRAME_COLOR, 90, 70);
  ExpectArrays("two images", scene.Depth, Mapper::FRAME_DEPTH, 90, 70);

  for (int arrays = 0; arrays <= Mapper::FRAME_ALL; ++arrays)
  {
    const std::string what = "arrays " + std::to_string(arrays);
    // What the image held before is gone.
    vtkNew<vtkImageData> some;
    some->SetOrigin(1.0, 2.0, 3.0);
    some->SetDimensions(7, 8, 9);
    some->AllocateScalars(VTK_DOUBLE, 2);
    some->GetPointData()->GetScalars()->SetName("Depth");
    Expect(scene.Mapper->GetLastFrame(some, arrays), what);
    ExpectArrays(what, some, arrays, 90, 70);
    for (const ArrayFormat& format : Formats)
    {
      Expect(!(arrays & format.Bit) || HasPlane(some, planes, format), what + ": " + format.Name);
    }
    Expect(some->GetOrigin()[0] == 0.0 && some->GetSpacing()[0] == 1.0, what + ": a pixel is 1");
  }
  scene.Mapper->ClearCache();
  Expect(!planes.Get(scene), "forgotten");
  ExpectArrays("forgotten", planes.Image, Mapper::FRAME_ALL, 90, 70);
}

/// An array that fits keeps its memory, but what others see is not written.
void TestMemoryOfArrays()
{
  CutScene scene;
  Planes planes;
  Expect(planes.Render(scene, 90, 70), "rendered");
  vtkPointData* data = planes.Image->GetPointData();
  for (std::size_t shared = 0; shared < Formats.size(); ++shared)
  {
    const std::string what = std::string(Formats[shared].Name) + " is shared: ";
    Planes before, after;
    before.Image->DeepCopy(planes.Image);
    vtkNew<vtkImageData> elsewhere;
    elsewhere->GetPointData()->AddArray(data->GetArray(Formats[shared].Name));
    std::array<void*, 5> memory;
    vtkMTimeType lastChange = 0;
    for (std::size_t i = 0; i < Formats.size(); ++i)
    {
      memory[i] = data->GetArray(Formats[i].Name)->GetVoidPointer(0);
      lastChange = std::max(lastChange, data->GetArray(Formats[i].Name)->GetMTime());
    }
    scene.Renderer->GetActiveCamera()->Azimuth(20.0);
    Expect(planes.Render(scene, 90, 70) && after.Get(scene), what + "rendered");
    Expect(HasPlane(elsewhere, before, Formats[shared]), what + "what others see stays");
    for (std::size_t i = 0; i < Formats.size(); ++i)
    {
      vtkDataArray* array = data->GetArray(Formats[i].Name);
      const bool isKept = array->GetVoidPointer(0) == memory[i];
      Expect(isKept == (i != shared), what + Formats[i].Name + " keeps its memory");
      Expect(HasPlane(after.Image, planes, Formats[i]), what + Formats[i].Name + " is written");
      Expect(array->GetMTime() > lastChange, what + Formats[i].Name + " is modified");
    }
  }
}

/// What the answers count is what the mapper counts.
void TestAnswers()
{
  CutScene scene;
  Planes planes;
  scene.Mapper->SetReuseAccuracyToPaper();
  Expect(planes.Render(scene, 120, 120), "rendered");
  scene.Renderer->GetActiveCamera()->Azimuth(1.0);
  Expect(planes.Render(scene, 120, 120), "rendered");
  Expect(std::string(scene.Mapper->GetStatistics()->GetRouteAsString()) == "ImageCache",
    "from the cache");
  std::array<vtkIdType, 3> counts{};
  for (int y = 0; y < 120; ++y)
  {
    for (int x = 0; x < 120; ++x)
    {
      ++counts[static_cast<std::size_t>(planes.At("Answer", x, y))];
    }
  }
  Expect(counts[0] == scene.Mapper->GetStatistics()->GetNumberOfDefiniteMisses() &&
      counts[1] == scene.Mapper->GetStatistics()->GetNumberOfDefiniteHits() &&
      counts[2] == scene.Mapper->GetStatistics()->GetNumberOfPossibleHits(),
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
  Expect(scene.Render(100, 80) && HasPlane(scene.Color, planes, Formats[0]) &&
      HasPlane(scene.Depth, planes, Formats[1]),
    "is that of an image");
}

/// Every pixel with a surface is a point.
void TestVisibleSurface()
{
  CutScene scene;
  vtkNew<vtkPolyData> points;
  Expect(!scene.Mapper->GetVisibleSurface(points) && points->GetNumberOfPoints() == 0,
    "no frame, no points");
  Planes planes;
  Expect(planes.Render(scene, 83, 71), "rendered");
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
        different += colors->GetComponent(at, c) != planes.At("Color", x, y, c);
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
  TestMemoryOfArrays();
  TestAnswers();
  TestPlanesOfWindow();
  TestVisibleSurface();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
