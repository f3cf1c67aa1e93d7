// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Surfaces are coloured by another array as vtkProbeFilter and VTK's tables say, of all kinds of
// data, points and cells. A new array or table traces nothing; mistakes are told in a sentence.

#include "Checks/Expect.h"
#include "Scenes/ColorScene.h"
#include "Scenes/Mistake.h"
#include "Volumes/AmrGrids.h"
#include "Volumes/CurvedGrids.h"
#include "Volumes/Grids.h"
#include "Volumes/VtkMeshes.h"

#include <vtkCellData.h>
#include <vtkDiscretizableColorTransferFunction.h>
#include <vtkDoubleArray.h>
#include <vtkExplicitStructuredGrid.h>
#include <vtkLookupTable.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPlane.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkProbeFilter.h>
#include <vtkStructuredGrid.h>
#include <vtkUnstructuredGrid.h>
#include <vtkVariant.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <limits>
#include <string>

namespace
{

constexpr int Size = 90;
using Mapper = vtkTemporalCoherenceVolumeMapper;
using ColorArrays::Add;
using ColorArrays::AddAll;
using ColorArrays::Ball;
constexpr double Isovalue = ColorScene::Isovalue;

/// The picture has at each pixel the colour of the table at the value that VTK finds there.
/// \param source what is probed
void ExpectProbed(ColorScene& scene, vtkDataSet* source, const std::string& what)
{
  Expect(scene.Render(Size, Size), what + ": a picture");
  vtkNew<vtkPolyData> surface;
  Expect(scene.Mapper->GetVisibleSurface(surface) && surface->GetNumberOfPoints() > Size,
    what + ": a surface");
  vtkNew<vtkProbeFilter> probe;
  probe->SetInputData(surface);
  probe->SetSourceData(source);
  probe->PassPointArraysOff();
  probe->Update();
  vtkPointData* const found = probe->GetOutput()->GetPointData();
  vtkDataArray* const values = found->GetArray(scene.Mapper->GetColorArrayName());
  vtkDataArray* const isValid = found->GetArray("vtkValidPointMask");
  vtkDataArray* const colors = surface->GetPointData()->GetArray("Color");
  int differing = 0, valid = 0;
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    if (isValid->GetComponent(i, 0) == 0.0)
    {
      continue;
    }
    const int component = scene.Mapper->GetColorArrayComponent();
    double value = 0.0;
    for (int c = 0; c < values->GetNumberOfComponents(); ++c)
    {
      value += std::pow(values->GetComponent(i, c), 2.0);
    }
    value = component < 0 ? std::sqrt(value) : values->GetComponent(i, component);
    double color[3];
    scene.Table()->GetColor(value, color);
    bool isNear = true;
    for (int c = 0; c < 3; ++c)
    {
      isNear = isNear && std::abs(255.0 * color[c] - colors->GetComponent(i, c)) <= 1.0;
    }
    differing += !isNear;
    ++valid;
  }
  Expect(valid > Size, what + ": VTK finds values");
  // A hit may lie on the other side of a face, where the value of a cell ends.
  Expect(differing <= valid / 200,
    what + ": " + std::to_string(differing) + " of " + std::to_string(valid) + " colours differ");
}

void ExpectAllProbed(ColorScene& scene, vtkDataSet* source, const std::string& what)
{
  scene.ColorBy(false, "heat");
  ExpectProbed(scene, source, what + ", points");
  scene.ColorBy(false, "flow", 1);
  ExpectProbed(scene, source, what + ", a component");
  scene.ColorBy(false, "flow", -1);
  ExpectProbed(scene, source, what + ", lengths");
  scene.ColorBy(true, "cell heat");
  ExpectProbed(scene, source, what + ", cells");
}

void TestKinds()
{
  const auto image = Ball();
  const auto probe = [](vtkDataSet* data, const std::string& what)
  {
    AddAll(data);
    ColorScene scene(data);
    ExpectAllProbed(scene, data, what);
  };
  probe(image, "image");
  probe(VtkMeshes::Rectilinear(image), "rectilinear grid like an image");
  probe(Grids::FromFormula({ Grids::FineInside(15, 0.8), Grids::Even(14), Grids::Even(13) },
          VTK_DOUBLE, [](double x, double y, double z) { return 8.0 * std::hypot(x - 0.1, y, z); }),
    "rectilinear grid");
  probe(VtkMeshes::Curvilinear(image), "curvilinear grid");
  probe(VtkMeshes::Explicit(image), "explicit structured grid");
  for (const int type : { VTK_TETRA, VTK_HEXAHEDRON, VTK_WEDGE, VTK_PYRAMID, VTK_VOXEL })
  {
    probe(VtkMeshes::Unstructured(image, type), "cells of type " + std::to_string(type));
  }

  // Colours move with the volume.
  ColorScene turned(image);
  turned.Render(Size, Size);
  vtkNew<vtkImageData> before;
  before->DeepCopy(turned.Color);
  turned.Volume->SetPosition(100.0, 0.0, -20.0);
  turned.Renderer->ResetCamera();
  turned.Render(Size, Size);
  int differing = 0;
  for (int y = 0; y < Size; ++y)
  {
    for (int x = 0; x < Size; ++x)
    {
      const auto* const a = static_cast<unsigned char*>(before->GetScalarPointer(x, y, 0));
      const unsigned char* const b = turned.ColorAt(x, y);
      differing += std::abs(a[0] - b[0]) > 3 || std::abs(a[2] - b[2]) > 3;
    }
  }
  Expect(differing < 40, "a volume that is moved keeps its colours");
}

/// Points that divide curved cells have the values of these.
void TestCurvedCells()
{
  constexpr int type = VTK_QUADRATIC_HEXAHEDRON;
  const auto grid = TileCubes(type, HexahedronPattern(type), 3);
  vtkNew<vtkDoubleArray> field;
  field->SetName("field");
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    double at[3];
    grid->GetPoint(i, at);
    for (double& place : at)
    {
      place *= 12.0;
    }
    grid->GetPoints()->SetPoint(i, at);
    field->InsertNextValue(std::hypot(at[0] - 5.0, at[1] - 6.0, at[2] - 7.0));
  }
  grid->GetPointData()->SetScalars(field);
  vtkNew<vtkDoubleArray> heat;
  heat->SetName("heat");
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    const double* const at = grid->GetPoint(i);
    heat->InsertNextValue(10.0 + 5.0 * at[0] + 2.0 * at[1] - at[2]);
  }
  grid->GetPointData()->AddArray(heat);
  Add(grid, true, "cell heat", VTK_INT, 1);
  ColorScene scene(grid);
  ExpectProbed(scene, grid, "curved cells, points");
  scene.ColorBy(true, "cell heat");
  ExpectProbed(scene, grid, "curved cells, cells");
}

void TestComposites()
{
  const auto image = Ball();
  vtkNew<vtkMultiBlockDataSet> images, meshes;
  images->SetBlock(0, image);
  meshes->SetBlock(0, VtkMeshes::Unstructured(image, VTK_TETRA));
  AddAll(vtkDataSet::SafeDownCast(meshes->GetBlock(0)));
  ColorScene ofImages(images), ofMeshes(meshes);
  ExpectAllProbed(ofImages, image, "blocks of images");
  ExpectAllProbed(
    ofMeshes, vtkDataSet::SafeDownCast(meshes->GetBlock(0)), "blocks of unstructured grids");

  // The picture of an adaptive grid by its own array is that by the function of its surface.
  AmrTestLevels levels;
  levels.Ratios = { 2 };
  levels.Boxes = { { { glm::ivec3(0), glm::ivec3(11) } }, { { glm::ivec3(4), glm::ivec3(13) } } };
  const auto amr =
    MakeAmr(levels, [](const glm::dvec3& at) { return glm::distance(at, glm::dvec3(5.5)); });
  ColorScene scene(amr);
  scene.Mapper->SetScalarModeToUseCellData();
  vtkUniformGrid* const first = amr->GetDataSet(0, 0);
  scene.ColorBy(true, first->GetCellData()->GetScalars()->GetName());
  scene.SetIsovalues({ 3.5 });
  Expect(scene.Render(Size, Size), "an adaptive grid");
  double color[3];
  scene.Table()->GetColor(3.5, color);
  const unsigned char* const middle = scene.ColorAt(Size / 2, Size / 2);
  Expect(middle[3] == 255 && std::abs(middle[0] - 255.0 * color[0]) <= 1.0 &&
      std::abs(middle[1] - 255.0 * color[1]) <= 1.0,
    "has its colour by its own array");
}

void TestTables()
{
  const auto image = Ball();
  ColorScene scene(image);
  vtkNew<vtkLookupTable> steps;
  steps->SetNumberOfTableValues(7);
  steps->SetTableRange(20.0, 100.0);
  steps->Build();
  scene.Mapper->SetColorTable(steps);
  ExpectProbed(scene, image, "lookup table");
  steps->SetNumberOfTableValues(64);
  steps->SetScaleToLog10();
  steps->ForceBuild();
  ExpectProbed(scene, image, "logarithmic table");
  steps->SetTableRange(50.0, 60.0);
  steps->UseBelowRangeColorOn();
  steps->UseAboveRangeColorOn();
  steps->SetBelowRangeColor(0.1, 0.9, 0.3, 1.0);
  steps->SetAboveRangeColor(0.8, 0.1, 0.7, 1.0);
  ExpectProbed(scene, image, "colours beyond the range");

  vtkNew<vtkColorTransferFunction> lab;
  lab->SetColorSpaceToLab();
  lab->AddRGBPoint(0.0, 0.1, 0.2, 0.9);
  lab->AddRGBPoint(70.0, 0.9, 0.9, 0.9, 0.3, 0.6);
  lab->AddRGBPoint(120.0, 0.8, 0.1, 0.1);
  scene.Mapper->SetColorTable(lab);
  ExpectProbed(scene, image, "curved function");
  vtkNew<vtkColorTransferFunction> far;
  far->AddRGBPoint(-1e9, 0.0, 0.0, 0.0);
  far->AddRGBPoint(55.0, 0.2, 0.9, 0.1);
  far->AddRGBPoint(65.0, 0.9, 0.2, 0.8);
  far->AddRGBPoint(1e9, 1.0, 1.0, 1.0);
  scene.Mapper->SetColorTable(far);
  ExpectProbed(scene, image, "nodes far beyond the data");
  vtkNew<vtkDiscretizableColorTransferFunction> discrete;
  discrete->DiscretizeOn();
  discrete->SetNumberOfValues(5);
  discrete->AddRGBPoint(10.0, 0.0, 0.2, 0.4);
  discrete->AddRGBPoint(110.0, 1.0, 0.9, 0.0);
  discrete->Build();
  scene.Mapper->SetColorTable(discrete);
  ExpectProbed(scene, image, "function in steps");

  // Logarithms over several decades; ranges that end at 0 or are negative.
  auto logarithmic = vtkSmartPointer<vtkColorTransferFunction>::New();
  logarithmic->SetScaleToLog10();
  logarithmic->AddRGBPoint(1e-3, 0.0, 0.1, 0.2);
  logarithmic->AddRGBPoint(1e5, 1.0, 0.9, 0.6);
  scene.Mapper->SetColorTable(logarithmic);
  ExpectProbed(scene, image, "logarithmic function");
  discrete->SetUseLogScale(1);
  discrete->SetNumberOfValues(12);
  discrete->Build();
  scene.Mapper->SetColorTable(discrete);
  ExpectProbed(scene, image, "function in logarithmic steps");
  for (const auto& range :
    { std::array<double, 2>{ 0.0, 100.0 }, { 13.0, 60.0 }, { -100.0, -10.0 } })
  {
    vtkNew<vtkLookupTable> decades;
    decades->SetScaleToLog10();
    decades->SetNumberOfTableValues(50);
    decades->SetTableRange(range.data());
    decades->SetAboveRangeColor(0.1, 0.9, 0.2, 1.0);
    decades->SetUseAboveRangeColor(range[0] == 13.0);
    decades->Build();
    scene.Mapper->SetColorTable(decades);
    ExpectProbed(scene, image, "logarithmic table from " + std::to_string(range[0]));
  }
  vtkNew<vtkLookupTable> whole;
  whole->SetNumberOfTableValues(100);
  whole->SetTableRange(0.0, 100.0);
  whole->Build();
  scene.Mapper->SetColorTable(whole);
  scene.ColorBy(true, "cell heat");
  ExpectProbed(scene, image, "whole numbers between colours");
  scene.ColorBy(false, "heat");

  // Names of whole numbers.
  vtkNew<vtkLookupTable> names;
  names->IndexedLookupOn();
  names->SetNumberOfTableValues(256);
  names->ForceBuild();
  for (int i = 0; i < 256; ++i)
  {
    names->SetAnnotation(vtkVariant(i), std::to_string(i));
  }
  scene.Mapper->SetColorTable(names);
  scene.ColorBy(true, "cell heat");
  ExpectProbed(scene, image, "names");

  vtkVolumeProperty* const property = scene.Volume->GetProperty();
  scene.Mapper->SetColorTable(nullptr);
  vtkNew<vtkPiecewiseFunction> gray;
  gray->AddPoint(0.0, 0.0);
  gray->AddPoint(120.0, 1.0);
  property->SetColor(gray);
  scene.ColorBy(false, "heat");
  Expect(scene.Render(Size, Size), "gray values of the property");
  const unsigned char* const middle = scene.ColorAt(Size / 2, Size / 2);
  Expect(middle[0] > 20 && middle[0] == middle[1] && middle[1] == middle[2], "are gray");
}

/// Where surfaces are faces of cells, each has the colour of the cell behind it.
void TestFaces()
{
  const auto image = Ball();
  vtkNew<vtkDoubleArray> ofCells;
  ofCells->SetName("drawn");
  for (vtkIdType i = 0; i < image->GetNumberOfCells(); ++i)
  {
    double bounds[6];
    image->GetCellBounds(i, bounds);
    const double distance = std::hypot(0.5 * (bounds[0] + bounds[1]) - 10.3,
      0.5 * (bounds[2] + bounds[3]) - 5.1, 0.5 * (bounds[4] + bounds[5]) - 6.2);
    ofCells->InsertNextValue(distance < 5.0 ? 10.0 : 0.0);
  }
  image->GetCellData()->AddArray(ofCells);
  vtkNew<vtkLookupTable> table;
  table->SetTableRange(0.0, 10.0);
  table->SetNumberOfTableValues(2);
  table->SetTableValue(0, 1.0, 0.0, 0.0);
  table->SetTableValue(1, 0.0, 1.0, 0.0);
  ColorScene scene(image);
  scene.Volume->GetProperty()->SetInterpolationTypeToNearest();
  scene.Mapper->SetScalarModeToUseCellFieldData();
  scene.Mapper->SelectScalarArray("drawn");
  scene.Mapper->SetColorTable(table);
  scene.ColorBy(true, "drawn");
  Expect(scene.Render(Size, Size), "faces of cells");
  int hit = 0, other = 0;
  for (int y = 0; y < Size; ++y)
  {
    for (int x = 0; x < Size; ++x)
    {
      const unsigned char* const color = scene.ColorAt(x, y);
      hit += color[3] != 0;
      other += color[3] != 0 && color[1] < 250;
    }
  }
  Expect(hit > Size && other == 0,
    std::to_string(other) + " of " + std::to_string(hit) + " pixels show the cell before the face");
}

/// Blocks that lack the array are an error.
void TestLackingBlocks()
{
  const auto image = Ball(), other = Ball();
  other->SetOrigin(2.0 + 16.0, -3.0, 1.0);
  other->GetPointData()->RemoveArray("heat");
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, image);
  blocks->SetBlock(1, other);
  ColorScene scene(blocks);
  scene.SetIsovalues({ 8.0 });
  scene.ColorBy(false, "flow");
  Mistake mistake(scene, "named 'heat' on its points");
  scene.ColorBy(false, "heat");
  mistake.ExpectRefused();
}

/// Values that are missing have the table's colour for them.
void TestMissing()
{
  const auto image = Ball();
  vtkDataArray* const heat = image->GetPointData()->GetArray("heat");
  for (vtkIdType i = 0; i < heat->GetNumberOfTuples(); ++i)
  {
    heat->SetComponent(i, 0, std::nan(""));
  }
  ColorScene scene(image);
  scene.Volume->GetProperty()->GetRGBTransferFunction()->SetNanColor(0.2, 0.6, 0.4);
  Expect(scene.Render(Size, Size), "without values");
  const unsigned char* const middle = scene.ColorAt(Size / 2, Size / 2);
  Expect(middle[0] == 51 && middle[1] == 153 && middle[2] == 102 && middle[3] == 255,
    "the colour of missing values");
}

/// Nothing is traced for new colours, and pictures are those of cold frames.
void TestRoutes()
{
  for (const bool isMesh : { false, true })
  {
    const auto image = Ball();
    vtkSmartPointer<vtkDataSet> data = image;
    if (isMesh)
    {
      data = VtkMeshes::Unstructured(image, VTK_HEXAHEDRON);
      AddAll(data);
    }
    for (const bool areLayers : { false, true })
    {
      ColorScene scene(data), cold(data);
      vtkNew<vtkLookupTable> table;
      table->SetTableRange(20.0, 100.0);
      vtkNew<vtkPiecewiseFunction> opacity;
      opacity->AddPoint(Isovalue, areLayers ? 0.4 : 1.0);
      for (ColorScene* each : { &scene, &cold })
      {
        each->SetIsovalues({ Isovalue, 3.0 });
        each->Volume->GetProperty()->ShadeOn();
        each->Volume->GetProperty()->SetScalarOpacity(opacity);
        each->Mapper->SetColorTable(table);
      }
      const std::string kind =
        std::string(isMesh ? "mesh" : "image") + (areLayers ? " with layers" : "");
      const auto compare = [&](const std::string& what, bool isNew)
      {
        cold.Mapper->ClearCache();
        Expect(scene.Render(Size, Size) && cold.Render(Size, Size) &&
            AreIdentical(scene.Color, cold.Color) && AreIdentical(scene.Depth, cold.Depth),
          kind + ", " + what + ": as cold");
        Expect(isNew || scene.Mapper->GetStatistics()->GetNumberOfTracedRays() == 0,
          kind + ", " + what + ": nothing is traced");
      };
      const auto both = [&](const std::function<void(ColorScene&)>& change)
      {
        change(scene);
        change(cold);
      };
      compare("first", true);
      table->SetTableRange(40.0, 80.0);
      compare("a range", false);
      both([](ColorScene& each) { each.ColorBy(true, "cell heat"); });
      compare("an array of cells", false);
      both([](ColorScene& each) { each.ColorBy(false, "flow", -1); });
      compare("lengths", false);
      for (const double high : { 160.0, 170.0, 150.0 })
      {
        table->SetTableRange(60.0, high);
        compare("a range to " + std::to_string(high), false); // values are kept from the second on
      }
      vtkDataArray* const flow = data->GetPointData()->GetArray("flow");
      for (vtkIdType i = 0; i < flow->GetNumberOfTuples(); ++i)
      {
        flow->SetComponent(i, 1, 10.0 + i % 50);
      }
      flow->Modified();
      compare("samples of the array", true);
      both([](ColorScene& each) { each.ColorBy(false, "heat"); });
      both([](ColorScene& each) { each.LookFrom(-1.0, 0.5, 0.3); });
      compare("another view", true);
      vtkNew<vtkPlane> plane;
      plane->SetOrigin(10.0, 5.0, 6.0);
      plane->SetNormal(1.0, 0.0, 0.2);
      both(
        [&](ColorScene& each)
        {
          each.Mapper->SetSurfaceModeToThreshold();
          each.Mapper->AddClippingPlane(plane);
        });
      compare("a cut solid", true);
      both([](ColorScene& each) { each.ColorBy(false, nullptr); });
      compare("no array", false);
      both([](ColorScene& each) { each.SetIsovalues({ 4.5 }); });
      both([](ColorScene& each) { each.ColorBy(false, "heat"); });
      compare("another isovalue", true);
    }
  }
}

/// A scene is refused with one sentence.
void ExpectError(const std::string& word, const std::function<void(ColorScene&)>& spoil,
  const std::function<vtkSmartPointer<vtkDataSet>()>& make = Ball)
{
  const auto data = make();
  ColorScene scene(data);
  Mistake mistake(scene, word);
  spoil(scene);
  mistake.ExpectRefused();
}

void TestMistakes()
{
  const auto mesh = []() -> vtkSmartPointer<vtkDataSet>
  {
    const auto made = VtkMeshes::Unstructured(Ball(), VTK_TETRA);
    AddAll(made);
    return made;
  };
  for (const std::function<vtkSmartPointer<vtkDataSet>()>& make :
    { std::function<vtkSmartPointer<vtkDataSet>()>(Ball),
      std::function<vtkSmartPointer<vtkDataSet>()>(mesh) })
  {
    ExpectError(
      "named 'nothing' on its points", [](ColorScene& s) { s.ColorBy(false, "nothing"); }, make);
    ExpectError(
      "named 'heat' on its cells", [](ColorScene& s) { s.ColorBy(true, "heat"); }, make);
    ExpectError(
      "ColorArrayComponent is 3", [](ColorScene& s) { s.ColorBy(false, "flow", 3); }, make);
    ExpectError(
      "short",
      [](ColorScene& scene)
      {
        auto* const data = vtkDataSet::SafeDownCast(scene.Mapper->GetDataObjectInput());
        vtkNew<vtkDoubleArray> few;
        few->SetName("short");
        few->SetNumberOfTuples(3);
        data->GetPointData()->AddArray(few);
        scene.ColorBy(false, "short");
      },
      make);
  }
  ExpectError("not whole numbers",
    [](ColorScene& scene)
    {
      vtkNew<vtkLookupTable> table;
      table->IndexedLookupOn();
      table->SetAnnotation(vtkVariant(0.5), "a half");
      scene.Mapper->SetColorTable(table);
    });
  ExpectError("not all finite",
    [](ColorScene& scene)
    {
      vtkNew<vtkColorTransferFunction> table;
      table->AddRGBPoint(0.0, 0.0, 0.0, 0.0);
      table->AddRGBPoint(1.0, 1.0, 0.0, 0.0);
      double node[6] = { std::nan(""), 0.0, 0.0, 0.0, 0.5, 0.0 };
      table->SetNodeValue(1, node);
      scene.Mapper->SetColorTable(table);
    });
  ExpectError("not all finite",
    [](ColorScene& scene)
    {
      vtkNew<vtkColorTransferFunction> table;
      table->AddRGBPoint(0.0, 0.0, 0.0, 0.0);
      table->AddRGBPoint(std::numeric_limits<double>::infinity(), 1.0, 0.0, 0.0);
      scene.Mapper->SetColorTable(table);
    });
}

void TestSettings()
{
  vtkNew<Mapper> mapper;
  Expect(std::string(mapper->GetColorArrayName()).empty() && !mapper->GetColorArrayOnCells() &&
      mapper->GetColorArrayComponent() == 0 && !mapper->GetColorTable(),
    "defaults");
  mapper->SetColorArrayComponent(-7);
  Expect(mapper->GetColorArrayComponent() == -1, "clamped");
  const vtkMTimeType before = mapper->GetMTime();
  mapper->SetColorArrayName("heat");
  Expect(mapper->GetMTime() > before, "modified");
}

}

int TestColorArray(int, char*[])
{
  TestKinds();
  TestCurvedCells();
  TestComposites();
  TestTables();
  TestFaces();
  TestLackingBlocks();
  TestMissing();
  TestRoutes();
  TestMistakes();
  TestSettings();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
