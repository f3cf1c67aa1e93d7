// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Hardware selection finds a volume where its surfaces are seen, and nothing where they are not.

#include "Checks/Expect.h"
#include "Scenes/OffScreen.h"
#include "Scenes/Scene.h"
#include "Volumes/Volumes.h"
#include "Volumes/VtkMeshes.h"
#include "vtkTemporalCoherenceVolume.h"

#include <vtkActor.h>
#include <vtkDataObject.h>
#include <vtkFloatingPointExceptions.h>
#include <vtkHardwareSelector.h>
#include <vtkIdList.h>
#include <vtkInformation.h>
#include <vtkMath.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkPointSet.h>
#include <vtkPolyDataMapper.h>
#include <vtkPropPicker.h>
#include <vtkProperty.h>
#include <vtkSelection.h>
#include <vtkSelectionNode.h>
#include <vtkSphereSource.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

namespace
{

constexpr int Size = 150;
constexpr double Radius = 0.5;

vtkSmartPointer<vtkImageData> Ball()
{
  return Volumes::FromFormula(
    41, VTK_FLOAT, [](double x, double y, double z) { return -std::hypot(x, y, z); });
}

/// A ball as an isosurface and, to its right and a little nearer, a polygonal one that hides a part
/// of it and is partly inside.
struct TwoBalls
{
  explicit TwoBalls(vtkVolume* volume = nullptr)
    : Iso(Ball(), { -Radius })
  {
    this->Prop = volume ? volume : this->Iso.Volume.Get();
    if (volume)
    {
      volume->SetMapper(this->Iso.Mapper);
      volume->SetProperty(this->Iso.Volume->GetProperty());
      this->Iso.Renderer->RemoveVolume(this->Iso.Volume);
      this->Iso.Renderer->AddVolume(volume);
    }
    vtkNew<vtkSphereSource> sphere;
    sphere->SetRadius(Radius);
    sphere->SetCenter(0.45, -0.1, 0.0);
    sphere->SetThetaResolution(100);
    sphere->SetPhiResolution(100);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(sphere->GetOutputPort());
    this->Polygons->SetMapper(mapper);
    this->Polygons->GetProperty()->SetColor(0.0, 0.0, 1.0);
    this->Polygons->GetProperty()->LightingOff();
    this->Iso.Renderer->AddActor(this->Polygons);
    this->Iso.Volume->GetProperty()->ShadeOff();
    this->Iso.LookFrom(0.2, -2.0, 0.3);
    this->Iso.Renderer->GetActiveCamera()->Zoom(1.4);
    OpenWindow(this->Window, this->Iso.Renderer, Size, Size);
    this->Window->Render();
    this->Pixels = PixelsOf(this->Window);
  }

  /// What the window shows at a pixel.
  vtkProp* SeenAt(int x, int y) const
  {
    const unsigned char* pixel = this->Pixels->GetPointer(4 * (y * Size + x));
    if (pixel[0] > 100)
    {
      return this->Prop;
    }
    return pixel[2] > 100 ? this->Polygons.Get() : nullptr;
  }

  Scene Iso;
  vtkVolume* Prop;
  vtkNew<vtkActor> Polygons;
  vtkNew<vtkRenderWindow> Window;
  vtkSmartPointer<vtkUnsignedCharArray> Pixels;
};

/// Every pixel of the window selects what it shows.
void TestEveryPixel(vtkVolume* volume, int association, const std::string& name)
{
  TwoBalls scene(volume);
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(scene.Iso.Renderer);
  selector->SetArea(0, 0, Size - 1, Size - 1);
  selector->SetFieldAssociation(association);
  Expect(selector->CaptureBuffers(), name + ": captured");
  Expect(std::string(scene.Iso.Mapper->GetStatistics()->GetRouteAsString()) == "Redisplay",
    name + ": nothing is made anew to select");

  int volumes = 0, polygons = 0, wrong = 0, wrongNumbers = 0;
  vtkImageData* image = vtkImageData::SafeDownCast(scene.Iso.Mapper->GetInput());
  for (unsigned int y = 0; y < Size; ++y)
  {
    for (unsigned int x = 0; x < Size; ++x)
    {
      const unsigned int place[2] = { x, y };
      const auto found = selector->GetPixelInformation(place);
      vtkProp* prop = found.Valid ? found.Prop : nullptr;
      vtkProp* seen = scene.SeenAt(static_cast<int>(x), static_cast<int>(y));
      // Of polygons it is points that are selected, which are drawn large.
      const bool isSkipped = association == vtkDataObject::FIELD_ASSOCIATION_POINTS &&
        (seen == scene.Polygons || prop == scene.Polygons);
      wrong += !isSkipped && prop != seen;
      polygons += prop == scene.Polygons;
      if (prop != scene.Prop)
      {
        continue;
      }
      ++volumes;
      double position[3];
      if (!scene.Iso.Mapper->PickPixel(
            static_cast<int>(x), static_cast<int>(y), position, nullptr, nullptr))
      {
        ++wrongNumbers;
        continue;
      }
      if (association == vtkDataObject::FIELD_ASSOCIATION_POINTS)
      {
        wrongNumbers += found.AttributeID != image->FindPoint(position);
      }
      else
      {
        double box[6];
        image->GetCellBounds(found.AttributeID, box);
        for (int a = 0; a < 3; ++a)
        {
          wrongNumbers += position[a] < box[2 * a] - 1e-6 || position[a] > box[2 * a + 1] + 1e-6;
        }
      }
    }
  }
  Expect(wrong == 0, name + ": " + std::to_string(wrong) + " pixels select what is not seen");
  Expect(volumes > 1500, name + ": the volume is selected, " + std::to_string(volumes));
  Expect(polygons > 100, name + ": so are polygons");
  Expect(wrongNumbers == 0, name + ": " + std::to_string(wrongNumbers) + " wrong numbers");

  scene.Window->Render();
  const auto after = PixelsOf(scene.Window);
  Expect(std::equal(after->GetPointer(0), after->GetPointer(0) + after->GetNumberOfValues(),
           scene.Pixels->GetPointer(0)),
    name + ": the picture is as it was");
}

/// Of grids the cell that is hit is selected, its nearest point, and its block.
void TestGrids(int association, const std::string& name)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  const vtkSmartPointer<vtkImageData> ball = Ball();
  const vtkSmartPointer<vtkDataSet> grids[] = { VtkMeshes::Unstructured(ball, VTK_HEXAHEDRON),
    VtkMeshes::Curvilinear(ball) };
  for (unsigned int i = 0; i < 2; ++i)
  {
    auto* points = vtkPointSet::SafeDownCast(grids[i])->GetPoints();
    for (vtkIdType p = 0; p < points->GetNumberOfPoints() && i; ++p)
    {
      const double* at = points->GetPoint(p);
      points->SetPoint(p, at[0] + 1.2, at[1] + 0.3, at[2]);
    }
    points->Modified();
    blocks->SetBlock(i, grids[i]);
  }
  Scene scene(nullptr, { -Radius });
  scene.Mapper->SetInputDataObject(blocks);
  scene.LookFrom(0.2, -2.0, 0.3);
  scene.Renderer->GetActiveCamera()->Zoom(1.6);
  vtkNew<vtkRenderWindow> window;
  OpenWindow(window, scene.Renderer, Size, Size);
  window->Render();
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(scene.Renderer);
  selector->SetArea(0, 0, Size - 1, Size - 1);
  selector->SetFieldAssociation(association);
  Expect(selector->CaptureBuffers(), name + ": captured");
  int hits[2] = {}, wrong = 0;
  for (unsigned int pixel = 0; pixel < Size * Size; ++pixel)
  {
    const unsigned int place[2] = { pixel % Size, pixel / Size };
    const int x = static_cast<int>(place[0]), y = static_cast<int>(place[1]);
    unsigned int block = 0;
    const vtkIdType cell = scene.Mapper->PickCell(x, y, &block);
    const auto found = selector->GetPixelInformation(place);
    wrong += found.Valid != (cell >= 0);
    if (!found.Valid || cell < 0)
    {
      continue;
    }
    ++hits[block - 1];
    vtkNew<vtkIdList> points;
    grids[block - 1]->GetCellPoints(cell, points);
    const bool isSame = association == vtkDataObject::FIELD_ASSOCIATION_POINTS
      ? points->IsId(found.AttributeID) >= 0
      : found.AttributeID == cell;
    wrong += !isSame || found.CompositeID != static_cast<int>(block);
  }
  Expect(hits[0] > 500 && hits[1] > 500, name + ": both blocks are selected");
  Expect(wrong == 0, name + ": " + std::to_string(wrong) + " pixels are wrong");
}

/// The selection of a rectangle holds the numbers of what is seen in it.
void TestRectangle()
{
  TwoBalls scene;
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(scene.Iso.Renderer);
  selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_CELLS);
  int x = 0;
  while (x < Size && scene.SeenAt(x, Size / 2) != scene.Prop)
  {
    ++x;
  }
  const auto left = static_cast<unsigned int>(x + 5);
  selector->SetArea(left, Size / 2, left + 9, Size / 2 + 9);
  vtkSmartPointer<vtkSelection> selection;
  selection.TakeReference(selector->Select());
  Expect(selection && selection->GetNumberOfNodes() == 1, "one prop");
  if (selection && selection->GetNumberOfNodes() == 1)
  {
    vtkSelectionNode* node = selection->GetNode(0);
    Expect(
      vtkProp::SafeDownCast(node->GetProperties()->Get(vtkSelectionNode::PROP())) == scene.Prop,
      "the volume");
    Expect(node->GetProperties()->Get(vtkSelectionNode::PIXEL_COUNT()) == 100, "100 pixels");
  }
  selector->SetArea(0, 0, 4, 4);
  selection.TakeReference(selector->Select());
  Expect(!selection || selection->GetNumberOfNodes() == 0, "nothing in the corner");
}

/// vtkPropPicker gives prop and position.
void TestPropPicker()
{
  TwoBalls scene;
  vtkNew<vtkPropPicker> picker;
  int volumes = 0;
  for (int y = 7; y < Size; y += 17)
  {
    for (int x = 7; x < Size; x += 17)
    {
      vtkProp* seen = scene.SeenAt(x, y);
      const bool isPicked = picker->Pick(x, y, 0.0, scene.Iso.Renderer) != 0;
      Expect(isPicked == (seen != nullptr) && picker->GetViewProp() == seen, "the prop seen");
      double position[3];
      if (seen == scene.Prop && scene.Iso.Mapper->PickPixel(x, y, position, nullptr, nullptr))
      {
        ++volumes;
        const double distance =
          std::sqrt(vtkMath::Distance2BetweenPoints(position, picker->GetPickPosition()));
        Expect(distance < 0.02, "the place seen, but " + std::to_string(distance) + " away");
      }
    }
  }
  Expect(volumes > 5, "volumes are picked");
  scene.Prop->PickableOff();
  int y = Size / 2, x = 0;
  while (x < Size && scene.SeenAt(x, y) != scene.Prop)
  {
    ++x;
  }
  Expect(!picker->Pick(x + 3, y, 0.0, scene.Iso.Renderer), "not if it may not be picked");
}

}

int TestSelection(int, char*[])
{
  // The software rasteriser behind some windows divides by zero by itself.
  vtkFloatingPointExceptions::Disable();
  vtkNew<vtkTemporalCoherenceVolume> volume;
  TestEveryPixel(nullptr, vtkDataObject::FIELD_ASSOCIATION_CELLS, "cells");
  TestEveryPixel(nullptr, vtkDataObject::FIELD_ASSOCIATION_POINTS, "points");
  TestEveryPixel(volume, vtkDataObject::FIELD_ASSOCIATION_CELLS, "cells, opaque pass");
  TestGrids(vtkDataObject::FIELD_ASSOCIATION_CELLS, "cells of grids");
  TestGrids(vtkDataObject::FIELD_ASSOCIATION_POINTS, "points of grids");
  TestRectangle();
  TestPropPicker();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
