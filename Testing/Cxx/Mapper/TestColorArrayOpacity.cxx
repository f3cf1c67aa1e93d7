// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// With ColorArrayOpacity, surfaces have opacities by an array too: pictures are those of a
// brute-force compositor, of all kinds of data. Every route makes the cold picture.

#include "Checks/Expect.h"
#include "Scenes/ColorScene.h"
#include "Scenes/Mistake.h"
#include "Truth/Compositor.h"
#include "Volumes/AmrGrids.h"
#include "Volumes/Grids.h"
#include "Volumes/Volumes.h"
#include "Volumes/VtkMeshes.h"

#include <vtkDataArray.h>
#include <vtkDiscretizableColorTransferFunction.h>
#include <vtkDoubleArray.h>
#include <vtkLookupTable.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPointData.h>
#include <vtkRTAnalyticSource.h>
#include <vtkStructuredGrid.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace
{

constexpr int Size = 90;
using Mapper = vtkTemporalCoherenceVolumeMapper;

/// A linear function of places, which interpolation repeats.
double HeatAt(const std::array<double, 3>& at)
{
  return 150.0 + 4.0 * at[0] + 5.0 * at[1] - 3.0 * at[2];
}

/// Steps whose alpha goes from 0 to 1.
vtkSmartPointer<vtkLookupTable> Steps(double low, double high)
{
  auto table = vtkSmartPointer<vtkLookupTable>::New();
  table->SetNumberOfTableValues(9);
  table->SetTableRange(low, high);
  table->SetAlphaRange(0.0, 1.0);
  table->Build();
  return table;
}

/// A function whose opacity is another function.
vtkSmartPointer<vtkDiscretizableColorTransferFunction> WithFunction()
{
  auto table = vtkSmartPointer<vtkDiscretizableColorTransferFunction>::New();
  table->DiscretizeOff();
  table->AddRGBPoint(80.0, 0.1, 0.3, 0.9);
  table->AddRGBPoint(220.0, 0.9, 0.4, 0.1);
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(100.0, 0.0);
  opacity->AddPoint(150.0, 0.8, 0.3, 0.6);
  opacity->AddPoint(200.0, 0.3);
  table->SetScalarOpacityFunction(opacity);
  table->EnableOpacityMappingOn();
  table->Build();
  return table;
}

/// Layers agree with brute force, which asks VTK for the looks of places.
void TestTruth()
{
  vtkNew<vtkRTAnalyticSource> wavelet;
  wavelet->SetWholeExtent(-12, 12, -12, 12, -12, 12);
  wavelet->Update();
  vtkImageData* const image = wavelet->GetOutput();
  vtkNew<vtkDoubleArray> heat;
  heat->SetName("heat");
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    std::array<double, 3> at;
    image->GetPoint(i, at.data());
    heat->InsertNextValue(HeatAt(at));
  }
  image->GetPointData()->AddArray(heat);
  const std::vector<std::array<double, 5>> nodes = { { 100.0, 0.2, 0.4, 1.0, 0.2 },
    { 150.0, 0.9, 0.9, 0.1, 0.6 }, { 200.0, 1.0, 0.2, 0.1, 1.0 } };
  const std::array<vtkSmartPointer<vtkScalarsToColors>, 3> tables = { nullptr, Steps(90.0, 210.0),
    WithFunction() };
  for (vtkScalarsToColors* table : tables)
  {
    for (const bool threshold : { false, true })
    {
      Scene scene(image, { 100.0, 150.0, 200.0 });
      SetColors(scene, nodes);
      vtkVolumeProperty* const property = scene.Volume->GetProperty();
      property->SetShade(!threshold); // the brute-force normal of a cap is not that of the face
      scene.Mapper->SetSurfaceMode(threshold);
      scene.Mapper->SetColorArrayName("heat");
      scene.Mapper->ColorArrayOpacityOn();
      scene.Mapper->SetColorTable(table);
      scene.LookFrom(1.0, 0.8, 0.5);
      Compositor compositor(scene, image);
      compositor.ChangeLook = [&](const Compositor::Point& place, std::array<double, 4>& color)
      {
        const double value = HeatAt(place);
        const double opacity =
          table ? table->GetOpacity(value) : property->GetScalarOpacity()->GetValue(value);
        color[3] *= opacity;
        vtkScalarsToColors* const colors = table ? table : property->GetRGBTransferFunction();
        colors->GetColor(value, color.data());
      };
      ExpectComposite(std::string("wavelet, ") + (threshold ? "THRESHOLD" : "CROSSING") + ", by " +
          (table ? table->GetClassName() : "the property"),
        scene, compositor);
    }
  }
}

/// Red and clear below a value, green from it on.
vtkSmartPointer<vtkLookupTable> RedIsClear(double from)
{
  auto table = vtkSmartPointer<vtkLookupTable>::New();
  table->SetNumberOfTableValues(2);
  table->SetTableRange(from - 1000.0, from + 1000.0);
  table->SetTableValue(0, 1.0, 0.0, 0.0, 0.0);
  table->SetTableValue(1, 0.0, 1.0, 0.0, 1.0);
  return table;
}

/// The median of the values that are seen, within a step of a table.
double MedianSeen(ColorScene& scene)
{
  constexpr double low = 0.0, high = 300.0;
  vtkNew<vtkLookupTable> grays;
  grays->SetTableRange(low, high);
  grays->SetHueRange(0.0, 0.0);
  grays->SetSaturationRange(0.0, 0.0);
  grays->SetValueRange(0.0, 1.0);
  grays->SetRampToLinear();
  grays->Build();
  scene.Mapper->SetColorTable(grays);
  scene.Render(Size, Size);
  std::vector<int> seen;
  for (int pixel = 0; pixel < Size * Size; ++pixel)
  {
    const unsigned char* const color = scene.ColorAt(pixel % Size, pixel / Size);
    if (color[3] != 0)
    {
      seen.push_back(color[0]);
    }
  }
  Expect(!seen.empty(), "something is seen");
  std::sort(seen.begin(), seen.end());
  return seen.empty() ? low : low + (seen[seen.size() / 2] + 0.5) / 256.0 * (high - low);
}

/// Where a surface is green, it stays. Where it is red, something behind it is seen, or nothing.
void ExpectCutOut(ColorScene& scene, const std::string& what)
{
  scene.Mapper->SetAntialiasingToOff();
  scene.Mapper->ColorArrayOpacityOff();
  scene.Mapper->SetColorTable(RedIsClear(MedianSeen(scene)));
  Expect(scene.Render(Size, Size) && scene.Mapper->IsOpaque(scene.Volume), what + ": opaque");
  vtkNew<vtkImageData> colors, depths;
  colors->DeepCopy(scene.Color);
  depths->DeepCopy(scene.Depth);
  scene.Mapper->ColorArrayOpacityOn();
  Expect(scene.Render(Size, Size) && !scene.Mapper->IsOpaque(scene.Volume), what + ": cut out");
  int green = 0, red = 0, wrong = 0;
  for (int y = 0; y < Size; ++y)
  {
    for (int x = 0; x < Size; ++x)
    {
      const auto* const before = static_cast<unsigned char*>(colors->GetScalarPointer(x, y, 0));
      const float depth = *static_cast<float*>(depths->GetScalarPointer(x, y, 0));
      const unsigned char* const after = scene.ColorAt(x, y);
      green += before[1] == 255;
      red += before[0] == 255;
      const bool isSame = after[1] == 255 && scene.DepthAt(x, y) == depth;
      const bool isBehind = after[0] == 0 && scene.DepthAt(x, y) > depth;
      wrong += before[3] == 0 ? after[3] != 0 : before[1] == 255 ? !isSame : !isBehind;
    }
  }
  Expect(green > Size && red > Size, what + ": some is red and some is green");
  Expect(wrong == 0, what + ": " + std::to_string(wrong) + " pixels are wrong");
}

void ExpectAllCutOut(ColorScene& scene, const std::string& what)
{
  scene.SetIsovalues({ ColorScene::Isovalue, 3.0 });
  scene.ColorBy(false, "heat");
  ExpectCutOut(scene, what + ", points");
  scene.ColorBy(false, "flow", -1);
  ExpectCutOut(scene, what + ", lengths");
  scene.ColorBy(true, "cell heat");
  ExpectCutOut(scene, what + ", cells");
}

void TestKinds()
{
  const auto image = ColorArrays::Ball();
  const auto cut = [](vtkDataSet* data, const std::string& what)
  {
    ColorArrays::AddAll(data);
    ColorScene scene(data);
    ExpectAllCutOut(scene, what);
    scene.Mapper->SetSurfaceModeToThreshold();
    ExpectAllCutOut(scene, what + ", THRESHOLD");
  };
  cut(image, "image");
  cut(Grids::FromFormula({ Grids::FineInside(15, 0.8), Grids::Even(14), Grids::Even(13) },
        VTK_DOUBLE, [](double x, double y, double z) { return 8.0 * std::hypot(x - 0.1, y, z); }),
    "rectilinear grid");
  cut(VtkMeshes::Curvilinear(image), "curvilinear grid");
  for (const int type : { VTK_TETRA, VTK_HEXAHEDRON, VTK_WEDGE })
  {
    cut(VtkMeshes::Unstructured(image, type), "cells of type " + std::to_string(type));
  }

  vtkNew<vtkMultiBlockDataSet> images, meshes;
  images->SetBlock(0, image);
  const auto mesh = VtkMeshes::Unstructured(image, VTK_TETRA);
  ColorArrays::AddAll(mesh);
  meshes->SetBlock(0, mesh);
  ColorScene ofImages(images), ofMeshes(meshes);
  ExpectAllCutOut(ofImages, "blocks of images");
  ExpectAllCutOut(ofMeshes, "blocks of meshes");
}

void TestAdaptiveGrid()
{
  AmrTestLevels levels;
  levels.Ratios = { 2 };
  levels.Boxes = { { { glm::ivec3(0), glm::ivec3(11) } }, { { glm::ivec3(4), glm::ivec3(13) } } };
  const auto amr =
    MakeAmr(levels, [](const glm::dvec3& at) { return glm::distance(at, glm::dvec3(5.5)); });
  for (unsigned int level = 0; level < 2; ++level)
  {
    ColorArrays::Add(amr->GetDataSet(level, 0), true, "cell heat", VTK_FLOAT, 1);
  }
  ColorScene scene(amr);
  scene.Mapper->SetScalarModeToUseCellData();
  scene.ColorBy(true, "cell heat");
  scene.SetIsovalues({ 3.5, 2.0 });
  ExpectCutOut(scene, "adaptive grid");
}

/// An image of two labels, one inside the other.
vtkSmartPointer<vtkImageData> Labels()
{
  const auto image = ColorArrays::Ball();
  vtkDataArray* const distances = image->GetPointData()->GetScalars();
  vtkNew<vtkUnsignedCharArray> labels;
  for (vtkIdType i = 0; i < distances->GetNumberOfTuples(); ++i)
  {
    const double distance = distances->GetComponent(i, 0);
    labels->InsertNextValue(distance < 3.0 ? 2 : distance < 5.0 ? 1 : 0);
  }
  image->GetPointData()->SetScalars(labels);
  return image;
}

void TestLabels()
{
  const auto image = Labels();
  ColorScene scene(image);
  scene.Mapper->SetSurfaceModeToLabels();
  ExpectCutOut(scene, "labels");
  scene.Mapper->SetLabelRadius(2.0);
  ExpectCutOut(scene, "smooth labels");
}

/// Values that are missing have the table's opacity for them; opaque tables make no layers.
void TestTables()
{
  const auto image = ColorArrays::Ball();
  ColorScene scene(image);
  scene.Mapper->ColorArrayOpacityOn();
  Expect(scene.Render(Size, Size) && scene.Mapper->IsOpaque(scene.Volume) &&
      scene.Mapper->GetStatistics()->GetNumberOfLayers() == 0,
    "opaque functions make no layers");
  vtkNew<vtkImageData> before;
  before->DeepCopy(scene.Color);
  scene.Mapper->ColorArrayOpacityOff();
  Expect(scene.Render(Size, Size) && AreIdentical(before, scene.Color) &&
      scene.Mapper->GetStatistics()->GetRoute() == Mapper::ROUTE_REDISPLAY,
    "and change nothing");

  vtkDataArray* const heat = image->GetPointData()->GetArray("heat");
  for (vtkIdType i = 0; i < heat->GetNumberOfTuples(); ++i)
  {
    heat->SetComponent(i, 0, std::nan(""));
  }
  heat->Modified();
  vtkNew<vtkLookupTable> table;
  table->SetNanColor(0.2, 0.6, 0.4, 0.25);
  scene.Mapper->SetColorTable(table);
  scene.Mapper->ColorArrayOpacityOn();
  Expect(scene.Render(Size, Size), "without values");
  const double seen = 255.0 * (1.0 - 0.75 * 0.75); // in front and behind
  Expect(std::abs(scene.ColorAt(Size / 2, Size / 2)[3] - seen) <= 2.0,
    "missing values have their opacity");
}

/// What is clear is not picked, with a frame or without.
void TestPicks()
{
  ColorScene scene(ColorArrays::Ball());
  scene.Mapper->SetAntialiasingToOff();
  scene.Mapper->SetColorTable(RedIsClear(MedianSeen(scene)));
  scene.Mapper->ColorArrayOpacityOn();
  Expect(scene.Render(Size, Size), "a picture to pick in");
  double eye[3];
  scene.Renderer->GetActiveCamera()->GetPosition(eye);
  int differing = 0, picked = 0;
  for (int y = 0; y < Size; y += 2)
  {
    for (int x = 0; x < Size; x += 2)
    {
      double at[3], t = 0.0, position[3], normal[3], beyond[3];
      if (!scene.Mapper->PickPixel(x, y, at, normal, nullptr))
      {
        differing += scene.ColorAt(x, y)[3] != 0;
        continue;
      }
      ++picked;
      for (int a = 0; a < 3; ++a)
      {
        beyond[a] = eye[a] + 2.0 * (at[a] - eye[a]);
      }
      differing +=
        !scene.Mapper->IntersectWithLine(scene.Volume, eye, beyond, t, position, normal, nullptr) ||
        std::abs(t - 0.5) > 1e-6;
    }
  }
  Expect(picked > Size && differing == 0, std::to_string(differing) + " picks differ");
}

/// Compares frames with those of a mapper without a past.
struct Pair
{
  explicit Pair(vtkDataSet* data, const std::string& name)
    : Name(name)
    , Drawn(data)
    , Cold(data)
  {
  }

  void Both(const std::function<void(ColorScene&)>& change)
  {
    change(this->Drawn);
    change(this->Cold);
  }

  /// \param route that is expected; empty: any
  void Compare(const std::string& what, const std::string& route)
  {
    this->Cold.Mapper->ClearCache();
    Expect(this->Drawn.Render(Size, Size) && this->Cold.Render(Size, Size) &&
        AreIdentical(this->Drawn.Color, this->Cold.Color) &&
        AreIdentical(this->Drawn.Depth, this->Cold.Depth),
      this->Name + ", " + what + ": as cold");
    const std::string taken = this->Drawn.Mapper->GetStatistics()->GetRouteAsString();
    Expect(route.empty() || taken == route, this->Name + ", " + what + ": by " + taken);
  }

  std::string Name;
  ColorScene Drawn, Cold;
};

/// New looks composite known layers again.
void TestRoutes()
{
  const auto image = ColorArrays::Ball();
  const auto mesh = VtkMeshes::Unstructured(image, VTK_HEXAHEDRON);
  ColorArrays::AddAll(mesh);
  for (const bool isMesh : { false, true })
  {
    for (const bool hasShadows : { false, true })
    {
      vtkDataSet* const data = isMesh ? static_cast<vtkDataSet*>(mesh) : image;
      Pair pair(data, std::string(isMesh ? "mesh" : "image") + (hasShadows ? ", shadows" : ""));
      const auto table = Steps(20.0, 100.0);
      table->SetAlphaRange(0.2, 0.9);
      table->Build();
      pair.Both(
        [&](ColorScene& each)
        {
          each.SetIsovalues({ ColorScene::Isovalue, 3.0 });
          each.Volume->GetProperty()->ShadeOn();
          each.Mapper->SetShadows(hasShadows);
          each.Mapper->SetColorTable(table);
        });
      pair.Compare("opaque", "Cold");
      pair.Both([](ColorScene& each) { each.Mapper->ColorArrayOpacityOn(); });
      pair.Compare("opacities", "Recomposite");
      table->SetTableRange(40.0, 80.0);
      pair.Compare("a range", "Recomposite");
      table->SetTableRange(20.0, 100.0);
      pair.Compare("the first range", "Recomposite");
      Expect(hasShadows || pair.Drawn.Mapper->GetStatistics()->GetNumberOfTracedRays() == 0,
        pair.Name + ": known layers are not traced");
      pair.Both([](ColorScene& each) { each.ColorBy(true, "cell heat"); });
      pair.Compare("an array of cells", "Recomposite");
      pair.Both([](ColorScene& each) { each.Volume->GetProperty()->SetAmbient(0.3); });
      pair.Compare("another light", "Reshade");
      vtkNew<vtkLookupTable> opaque;
      pair.Both([&](ColorScene& each) { each.Mapper->SetColorTable(opaque); });
      pair.Compare("an opaque table", "Recomposite");
      pair.Both([&](ColorScene& each) { each.Mapper->SetColorTable(table); });
      pair.Both([](ColorScene& each) { each.LookFrom(-1.0, 0.5, 0.3); });
      pair.Compare("another view", "Cold");
      pair.Both([](ColorScene& each) { each.SetIsovalues({ 4.5 }); });
      pair.Compare("another isovalue", "");
      pair.Both([](ColorScene& each) { each.Mapper->ColorArrayOpacityOff(); });
      pair.Compare("opaque again", "Recomposite");
    }
  }
}

void TestMistakes()
{
  const auto refuse = [](const std::string& word, const std::function<void(ColorScene&)>& spoil)
  {
    ColorScene scene(ColorArrays::Ball());
    Mistake mistake(scene, word);
    scene.Mapper->ColorArrayOpacityOn();
    spoil(scene);
    mistake.ExpectRefused();
  };
  refuse("ColorArrayOpacity is on, but there is no array",
    [](ColorScene& scene) { scene.ColorBy(false, nullptr); });
  refuse("opacities belong are not all finite",
    [](ColorScene& scene)
    {
      vtkNew<vtkPiecewiseFunction> opacity;
      opacity->AddPoint(0.0, 1.0);
      opacity->AddPoint(std::numeric_limits<double>::infinity(), 1.0);
      scene.Volume->GetProperty()->SetScalarOpacity(opacity);
    });
  refuse("Scalar opacity at value",
    [](ColorScene& scene)
    {
      vtkNew<vtkPiecewiseFunction> opacity;
      opacity->AddPoint(50.0, 1.0);
      opacity->AddPoint(70.0, 1e9);
      scene.Volume->GetProperty()->SetScalarOpacity(opacity);
    });
  vtkNew<Mapper> mapper;
  Expect(!mapper->GetColorArrayOpacity(), "off by default");
}

}

int TestColorArrayOpacity(int, char*[])
{
  TestTruth();
  TestKinds();
  TestAdaptiveGrid();
  TestLabels();
  TestTables();
  TestPicks();
  TestRoutes();
  TestMistakes();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
