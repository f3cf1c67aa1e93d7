// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// LABELS show at each pixel the label that a march by small steps meets, in its colour from a table
// or from the property. Other labels that are drawn, strokes and mistakes behave as with isovalues.

#include "Checks/Expect.h"
#include "Scenes/Mistake.h"
#include "Scenes/Scene.h"

#include <vtkFloatArray.h>
#include <vtkIntArray.h>
#include <vtkLookupTable.h>
#include <vtkMatrix4x4.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPlane.h>
#include <vtkPointData.h>
#include <vtkRectilinearGrid.h>
#include <vtkStructuredGrid.h>
#include <vtkTestErrorObserver.h>
#include <vtkVariant.h>
#include <vtkXMLImageDataWriter.h>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <set>

namespace
{

constexpr int Size = 60;
constexpr int Labels = 6; // 0 to 5

/// Balls of labels 1 to 5, some of which touch, in an oblique image.
vtkSmartPointer<vtkImageData> Balls(int type = VTK_UNSIGNED_CHAR)
{
  constexpr int n[3] = { 28, 25, 22 };
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(n);
  image->SetOrigin(3.0, -1.0, 0.5);
  image->SetSpacing(0.8, 1.0, 1.3);
  image->AllocateScalars(type, 1);
  const double balls[5][4] = { { 9, 9, 9, 7 }, { 16, 12, 11, 6 }, { 14, 18, 12, 6 },
    { 22, 8, 15, 5 }, { 26, 20, 10, 5 } };
  for (int k = 0; k < n[2]; ++k)
  {
    for (int j = 0; j < n[1]; ++j)
    {
      for (int i = 0; i < n[0]; ++i)
      {
        double label = 0.0;
        for (int ball = 0; ball < 5; ++ball)
        {
          const double* b = balls[ball];
          label = std::hypot(i - b[0], j - b[1], k - b[2]) < b[3] ? ball + 1.0 : label;
        }
        image->SetScalarComponentFromDouble(i, j, k, 0, label);
      }
    }
  }
  return image;
}

vtkSmartPointer<vtkLookupTable> Table(const std::set<int>& hidden = { 0 })
{
  auto table = vtkSmartPointer<vtkLookupTable>::New();
  table->SetNumberOfTableValues(Labels);
  table->SetTableRange(0.0, Labels - 1.0);
  for (int label = 0; label < Labels; ++label)
  {
    table->SetTableValue(
      label, label / 5.0, 1.0 - label / 5.0, label % 2, hidden.count(label) ? 0.0 : 1.0);
  }
  return table;
}

struct LabelScene : Scene
{
  explicit LabelScene(vtkDataSet* data)
    : Scene(data, {})
  {
    this->Mapper->SetSurfaceModeToLabels();
    this->Mapper->SetLabelTable(Table());
    this->Volume->GetProperty()->ShadeOff();
    this->LookFrom(1.0, 2.0, 0.5);
  }

  int LabelAt(int x, int y)
  {
    int label = -1;
    return this->Mapper->PickPixel(x, y, nullptr, nullptr, &label) ? label : -1;
  }
};

/// The label that a line of sight meets; -1 if it meets none.
/// \param isClear receives whether a small step before and behind gives the same
int March(LabelScene& scene, vtkImageData* image, const std::set<int>& drawn, int x, int y)
{
  vtkNew<vtkMatrix4x4> world;
  vtkMatrix4x4::Invert(
    scene.Renderer->GetActiveCamera()->GetCompositeProjectionTransformMatrix(1.0, -1.0, 1.0),
    world);
  double ends[2][4];
  for (int end = 0; end < 2; ++end)
  {
    const double clip[4] = { (2.0 * x + 1.0) / Size - 1.0, (2.0 * y + 1.0) / Size - 1.0,
      2.0 * end - 1.0, 1.0 };
    world->MultiplyPoint(clip, ends[end]);
  }
  constexpr int steps = 20000;
  const int* n = image->GetDimensions();
  for (int step = 0; step < steps; ++step)
  {
    const double share = step / (steps - 1.0);
    int sample[3];
    bool isIn = true;
    for (int a = 0; a < 3; ++a)
    {
      const double from = ends[0][a] / ends[0][3], to = ends[1][a] / ends[1][3];
      const double at =
        (from + share * (to - from) - image->GetOrigin()[a]) / image->GetSpacing()[a];
      isIn &= at >= 0.0 && at <= n[a] - 1.0;
      sample[a] = static_cast<int>(std::floor(at + 0.5));
    }
    if (isIn)
    {
      const auto label =
        static_cast<int>(image->GetScalarComponentAsDouble(sample[0], sample[1], sample[2], 0));
      if (drawn.count(label))
      {
        return label;
      }
    }
  }
  return -1;
}

void ExpectMarch(
  LabelScene& scene, vtkImageData* image, const std::set<int>& drawn, const std::string& what)
{
  Expect(scene.Render(Size, Size), what + ": a picture");
  int differing = 0;
  std::set<int> seen;
  for (int y = 0; y < Size; y += 2)
  {
    for (int x = 0; x < Size; x += 2)
    {
      const int label = scene.LabelAt(x, y);
      seen.insert(label);
      differing += label != March(scene, image, drawn, x, y);
    }
  }
  Expect(differing <= 2,
    what + ": labels are those of a march, but for " + std::to_string(differing) + " pixels");
  Expect(seen.size() > 1, what + ": something is seen");
}

void TestPixels()
{
  for (const int type : { VTK_UNSIGNED_CHAR, VTK_SHORT, VTK_INT, VTK_UNSIGNED_INT, VTK_LONG_LONG })
  {
    const auto image = Balls(type);
    LabelScene scene(image);
    ExpectMarch(scene, image, { 1, 2, 3, 4, 5 }, "type " + std::to_string(type));
  }
  const auto image = Balls();
  LabelScene scene(image);
  for (const std::set<int>& hidden : { std::set<int>{ 0, 1 }, std::set<int>{ 0, 2, 3 },
         std::set<int>{ 0, 1, 2, 4, 5 }, std::set<int>{ 0, 3 } })
  {
    std::set<int> drawn;
    for (int label = 1; label < Labels; ++label)
    {
      if (!hidden.count(label))
      {
        drawn.insert(label);
      }
    }
    scene.Mapper->SetLabelTable(Table(hidden));
    ExpectMarch(scene, image, drawn, "some labels");
  }
  // Another label is outside.
  scene.Mapper->SetLabelTable(Table({}));
  scene.Mapper->SetOutsideLabel(3);
  ExpectMarch(scene, image, { 0, 1, 2, 4, 5 }, "another outside");
}

void TestColors()
{
  const auto image = Balls();
  LabelScene scene(image);
  scene.Render(Size, Size);
  for (int x = 0; x < Size; ++x)
  {
    const int label = scene.LabelAt(x, Size / 2);
    const unsigned char* color = scene.ColorAt(x, Size / 2);
    const auto isNear = [&](int channel, double value)
    { return std::abs(color[channel] - 255.0 * value) <= 1.0; };
    Expect(
      label < 0 || (isNear(0, label / 5.0) && isNear(1, 1.0 - label / 5.0) && isNear(2, label % 2)),
      "colours of the table");
  }
  vtkNew<vtkImageData> ofTable;
  ofTable->DeepCopy(scene.Color);

  // Annotated values, and the property's functions, give the picture of the table.
  vtkNew<vtkColorTransferFunction> colors;
  vtkNew<vtkPiecewiseFunction> opacity;
  const auto annotated = vtkSmartPointer<vtkLookupTable>::New();
  annotated->SetNumberOfTableValues(Labels);
  annotated->IndexedLookupOn();
  for (int label = 0; label < Labels; ++label)
  {
    double rgba[4];
    scene.Mapper->GetLabelTable()->GetColor(label, rgba);
    colors->AddRGBPoint(label, rgba[0], rgba[1], rgba[2]);
    opacity->AddPoint(label, label ? 1.0 : 0.0);
    annotated->SetAnnotation(vtkVariant(label), std::to_string(label));
    annotated->SetTableValue(label, rgba[0], rgba[1], rgba[2], label ? 1.0 : 0.0);
  }
  scene.Mapper->SetLabelTable(annotated);
  Expect(scene.Render(Size, Size) && AreIdentical(ofTable, scene.Color), "annotated values");
  scene.Mapper->SetLabelTable(nullptr);
  scene.Volume->GetProperty()->SetColor(colors);
  scene.Volume->GetProperty()->SetScalarOpacity(opacity);
  Expect(scene.Render(Size, Size) && AreIdentical(ofTable, scene.Color), "functions");
  Expect(scene.Mapper->GetStatistics()->GetRoute() != vtkTemporalCoherenceVolumeMapper::ROUTE_COLD,
    "the same labels are not traced again");
  // New colours trace nothing.
  colors->AddRGBPoint(2.0, 0.1, 0.9, 0.2);
  Expect(scene.Render(Size, Size) &&
      scene.Mapper->GetStatistics()->GetRoute() == vtkTemporalCoherenceVolumeMapper::ROUTE_RESHADE,
    "colours are shaded again");
}

/// The label seen through translucent ones is met behind them.
void TestOpacities()
{
  const auto image = Balls();
  LabelScene scene(image);
  const auto table = Table();
  scene.Mapper->SetLabelTable(table);
  scene.Render(Size, Size);
  for (const int through : { 1, 2 })
  {
    double rgba[4];
    table->GetTableValue(through, rgba);
    rgba[3] = 0.4;
    table->SetTableValue(through, rgba);
  }
  Expect(scene.Render(Size, Size) &&
      scene.Mapper->GetStatistics()->GetRoute() ==
        vtkTemporalCoherenceVolumeMapper::ROUTE_RECOMPOSITE,
    "opacities go on behind known labels");
  vtkNew<vtkImageData> recomposited;
  recomposited->DeepCopy(scene.Color);
  scene.Mapper->ClearCache();
  Expect(scene.Render(Size, Size) && AreIdentical(recomposited, scene.Color), "as a cold frame");
  Expect(scene.Mapper->GetStatistics()->GetNumberOfLayers() > 100, "there are layers behind");
}

void TestCuts()
{
  const auto image = Balls();
  LabelScene scene(image);
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(image->GetCenter());
  plane->SetNormal(-1.0, -2.0, 0.0);
  scene.Mapper->AddClippingPlane(plane);
  Expect(scene.Render(Size, Size), "a cut picture");
  double place[3], normal[3];
  int label = -1;
  Expect(scene.Mapper->PickPixel(Size / 2, Size / 2, place, normal, &label) && label > 0,
    "the cut is capped");
  int sample[3];
  for (int a = 0; a < 3; ++a)
  {
    sample[a] =
      static_cast<int>(std::lround((place[a] - image->GetOrigin()[a]) / image->GetSpacing()[a]));
  }
  Expect(label ==
      static_cast<int>(image->GetScalarComponentAsDouble(sample[0], sample[1], sample[2], 0)),
    "by the label that is cut");
  Expect(std::abs(normal[0] - 1.0 / std::sqrt(5.0)) < 1e-6, "with the normal of the plane");
}

/// Routes give the bytes of a cold frame after whatever changed.
void TestRoutes()
{
  const auto image = Balls(VTK_SHORT);
  LabelScene scene(image), cold(image);
  for (LabelScene* each : { &scene, &cold })
  {
    each->Volume->GetProperty()->ShadeOn();
    each->Mapper->SetLabelRadius(2.0);
  }
  cold.Mapper->ReuseFramesOff();
  const auto compare = [&](const std::string& what)
  {
    cold.Mapper->ClearCache();
    Expect(scene.Render(Size, Size) && cold.Render(Size, Size), what + ": pictures");
    Expect(AreIdentical(scene.Color, cold.Color) && AreIdentical(scene.Depth, cold.Depth),
      what + ": as cold");
  };
  const auto setTable = [&](vtkLookupTable* table)
  {
    scene.Mapper->SetLabelTable(table);
    cold.Mapper->SetLabelTable(table);
  };
  compare("first");
  setTable(Table({ 0, 2 }));
  compare("hidden");
  setTable(Table());
  compare("shown");
  for (LabelScene* each : { &scene, &cold })
  {
    each->LookFrom(-1.0, 1.0, 0.3);
  }
  compare("turned");
  for (const int label : { 4, 0, 5 })
  {
    for (int step = 0; step < 3; ++step)
    {
      for (int j = 0; j < 4; ++j)
      {
        image->SetScalarComponentFromDouble(10 + step, 12 + j, 10, 0, label);
      }
      image->GetPointData()->GetScalars()->Modified();
      image->Modified();
      compare("painted");
    }
  }
  for (LabelScene* each : { &scene, &cold })
  {
    each->Mapper->SetLabelRadius(0.0);
  }
  compare("faces of voxels");
}

/// Of a large map, a stroke traces the tiles that see it, whether its place is told or not.
void TestStrokes(bool areTold)
{
  vtkNew<vtkImageData> image;
  image->SetExtent(5, 100, -3, 76, 0, 69);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  for (int k = 0; k < 70; ++k)
  {
    for (int j = 0; j < 80; ++j)
    {
      for (int i = 0; i < 96; ++i)
      {
        const double distance = std::hypot(i - 47.0, j - 40.0, k - 35.0);
        image->SetScalarComponentFromDouble(i + 5, j - 3, k, 0, distance < 30.0 ? 1 + i / 20 : 0);
      }
    }
  }
  for (const double radius : { 0.0, 2.5 })
  {
    LabelScene scene(image), cold(image);
    for (LabelScene* each : { &scene, &cold })
    {
      each->Mapper->SetLabelRadius(radius);
      each->Volume->GetProperty()->ShadeOn();
    }
    Expect(scene.Render(160, 160), "a large map");
    for (int stroke = 0; stroke < 3; ++stroke)
    {
      for (int step = 0; step < 60; ++step)
      {
        const int at[3] = { 45 + step % 4, 59 + step / 4 % 5, 30 + 6 * stroke + step / 20 };
        image->SetScalarComponentFromDouble(
          at[0], at[1], at[2], 0, 1 + (stroke + (radius > 0.0 ? 1 : 3)) % 4);
      }
      if (areTold)
      {
        // Two parts of the stroke, one of which reaches beyond the image.
        const int parts[2][6] = { { 45, 48, 59, 61, 30 + 6 * stroke, 32 + 6 * stroke },
          { 45, 200, 62, 63, 30 + 6 * stroke, 32 + 6 * stroke } };
        for (const int* part : parts)
        {
          Expect(vtkTemporalCoherenceVolumeMapper::ModifiedWithin(image, part), "told");
        }
      }
      else
      {
        image->GetPointData()->GetScalars()->Modified();
      }
      Expect(scene.Render(160, 160) && cold.Render(160, 160) &&
          AreIdentical(scene.Color, cold.Color) && AreIdentical(scene.Depth, cold.Depth),
        "a stroke looks as in a new picture");
      cold.Mapper->ClearCache();
      auto* const statistics = scene.Mapper->GetStatistics();
      Expect(statistics->GetRoute() == vtkTemporalCoherenceVolumeMapper::ROUTE_TIME_STEP &&
          statistics->GetNumberOfTracedRays() < 160 * 160 / 2,
        "a stroke traces what sees it, not " + std::to_string(statistics->GetNumberOfTracedRays()) +
          " rays by " + statistics->GetRouteAsString() + ", with radius " + std::to_string(radius));
    }
  }
}

/// A change that was not told is found beside told ones.
void TestChangesNotTold()
{
  const auto image = Balls();
  LabelScene scene(image), cold(image);
  const int extent[6] = { 3, 5, 3, 5, 3, 5 };
  for (int turn = 0; turn < 4; ++turn)
  {
    vtkDataArray* const samples = image->GetPointData()->GetScalars();
    samples->SetComponent(9 + 28 * (9 + 25 * (4 + turn)), 0, 5 - turn);
    samples->Modified();
    Expect(turn == 1 || vtkTemporalCoherenceVolumeMapper::ModifiedWithin(image, extent), "told");
    Expect(
      scene.Render(Size, Size) && cold.Render(Size, Size) && AreIdentical(scene.Color, cold.Color),
      "what was not told is seen");
    cold.Mapper->ClearCache();
  }
  vtkNew<vtkIntArray> other;
  Expect(!vtkTemporalCoherenceVolumeMapper::ModifiedWithin(image, extent, other) &&
      !vtkTemporalCoherenceVolumeMapper::ModifiedWithin(nullptr, extent),
    "there must be an array");
}

/// Odd extents, several mappers, arrays that two images share, and files.
void TestOddChanges()
{
  const auto image = Balls();
  vtkDataArray* const samples = image->GetPointData()->GetScalars();
  vtkNew<vtkImageData> other; // of another shape, with the same samples
  other->SetDimensions(22, 25, 28);
  other->GetPointData()->SetScalars(samples);
  LabelScene scene(image), rare(image), reshaped(other);
  const int most = std::numeric_limits<int>::max();
  const int extents[][6] = { { 20, 3, 0, 24, 0, 21 }, { 0, 27, 0, 24, 30, 40 },
    { -most, most, 9, 9, -most, most }, { 0, 27, 0, 24, 0, 21 }, { 9, 12, 5, 7, most, -most } };
  int turn = 0;
  for (const int* extent : extents)
  {
    samples->SetComponent(9 + 28 * (9 + 25 * (4 + turn)), 0, 5 - turn);
    const bool isThere = turn == 2 || turn == 3;
    if (!isThere)
    {
      samples->Modified();
    }
    Expect(vtkTemporalCoherenceVolumeMapper::ModifiedWithin(image, extent), "any extent is told");
    for (LabelScene* each : { &scene, &rare, &reshaped })
    {
      LabelScene fresh(each == &reshaped ? other.Get() : image.Get());
      Expect((each == &rare && turn % 2 == 0) ||
          (each->Render(Size, Size) && fresh.Render(Size, Size) &&
            AreIdentical(each->Color, fresh.Color)),
        "extent " + std::to_string(turn) + " looks as in a new picture");
    }
    ++turn;
  }
  vtkNew<vtkXMLImageDataWriter> writer;
  writer->SetInputData(image);
  writer->WriteToOutputStringOn();
  writer->Write();
  Expect(writer->GetOutputString().find("TOLD_CHANGES") == std::string::npos,
    "files know nothing of it");
}

/// An added label that fills a part of the box up to its faces is capped there.
void TestCapsOfOtherSets()
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(64, 64, 96);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  auto* const samples = static_cast<unsigned char*>(image->GetScalarPointer());
  for (int i = 0; i < 64 * 64 * 96; ++i)
  {
    samples[i] = static_cast<unsigned char>(1 + i % 64 / 32 + 2 * (i / 4096 / 60));
  }
  LabelScene scene(image), cold(image);
  for (const std::set<int>& hidden : { std::set<int>{ 0, 2, 3 }, { 0, 3, 4 }, { 0 }, { 0, 1, 2 } })
  {
    for (LabelScene* each : { &scene, &cold })
    {
      each->Mapper->SetLabelTable(Table(hidden));
    }
    cold.Mapper->ClearCache();
    Expect(scene.Render(2 * Size, 2 * Size) && cold.Render(2 * Size, 2 * Size) &&
        AreIdentical(scene.Color, cold.Color) && AreIdentical(scene.Depth, cold.Depth),
      "caps of labels that are added");
  }
}

/// Most pixels keep their label where another set is drawn.
void TestOtherSets()
{
  const auto image = Balls();
  LabelScene scene(image), cold(image);
  for (const std::set<int>& hidden : { std::set<int>{ 0 }, { 0, 2 }, { 0, 2, 4 }, { 0, 1 } })
  {
    for (LabelScene* each : { &scene, &cold })
    {
      each->Mapper->SetLabelTable(Table(hidden));
    }
    Expect(scene.Render(Size, Size) && cold.Render(Size, Size) &&
        AreIdentical(scene.Color, cold.Color) && AreIdentical(scene.Depth, cold.Depth),
      "another set looks as in a new picture");
    auto* const statistics = scene.Mapper->GetStatistics();
    Expect(hidden.size() == 1 ||
        (statistics->GetRoute() == vtkTemporalCoherenceVolumeMapper::ROUTE_KEEP_LABELS &&
          statistics->GetNumberOfTracedRays() <
            cold.Mapper->GetStatistics()->GetNumberOfTracedRays()),
      "and traces fewer rays");
    cold.Mapper->ClearCache();
  }
}

/// Labels are as many as 32 bits have names for.
void TestManyLabels()
{
  constexpr int n = 50;
  vtkNew<vtkImageData> image;
  image->SetDimensions(n, n, n);
  image->AllocateScalars(VTK_INT, 1);
  auto* const samples = static_cast<int*>(image->GetScalarPointer());
  for (int i = 0; i < n * n * n; ++i)
  {
    samples[i] = 16000 * (i + 1);
  }
  LabelScene scene(image);
  vtkNew<vtkLookupTable> table;
  table->SetNumberOfTableValues(2);
  table->SetTableRange(0.0, 2e9);
  scene.Mapper->SetLabelTable(table);
  Expect(scene.Render(Size, Size), "every sample has a label of its own");
  double place[3], normal[3];
  int label = 0;
  Expect(scene.Mapper->PickPixel(Size / 2, Size / 2, place, normal, &label) && label % 16000 == 0 &&
      label > 0,
    "a label of 32 bits is picked");
}

void TestSettings()
{
  vtkNew<vtkTemporalCoherenceVolumeMapper> mapper;
  mapper->SetSurfaceModeToLabels();
  Expect(mapper->GetSurfaceMode() == vtkTemporalCoherenceVolumeMapper::LABELS &&
      mapper->GetOutsideLabel() == 0 && mapper->GetLabelRadius() == 0.0 && !mapper->GetLabelTable(),
    "defaults");
  mapper->SetLabelRadius(100.0);
  Expect(mapper->GetLabelRadius() == 8.0, "clamped");
  vtkNew<vtkTest::ErrorObserver> observer;
  mapper->AddObserver(vtkCommand::ErrorEvent, observer);
  mapper->SetLabelRadius(std::nan(""));
  Expect(mapper->GetLabelRadius() == 8.0 && observer->GetError(), "NaN is an error");
}

/// A scene of labels is refused with one sentence.
template <typename Spoil>
void ExpectError(const std::string& word, const Spoil& spoil)
{
  const auto image = Balls();
  LabelScene scene(image);
  Mistake mistake(scene, word);
  spoil(scene);
  mistake.ExpectRefused();
}

void TestMistakes()
{
  ExpectError("whole ones",
    [](Scene& scene)
    {
      const auto image = Balls(VTK_FLOAT);
      scene.Mapper->SetInputData(image);
    });
  ExpectError("no colour for label 5",
    [](Scene& scene)
    {
      auto table = vtkSmartPointer<vtkLookupTable>::New();
      table->SetNumberOfTableValues(5);
      table->SetTableRange(0.0, 4.0);
      scene.Mapper->SetLabelTable(table);
    });
  ExpectError("no colour for label 1",
    [](Scene& scene)
    {
      auto table = vtkSmartPointer<vtkLookupTable>::New();
      table->IndexedLookupOn();
      table->SetAnnotation(vtkVariant(0), "outside");
      scene.Mapper->SetLabelTable(table);
    });
  ExpectError("only be drawn of images",
    [](Scene& scene)
    {
      vtkNew<vtkRectilinearGrid> grid;
      vtkNew<vtkFloatArray> along;
      for (const float x : { 0.0f, 1.0f, 3.0f })
      {
        along->InsertNextValue(x);
      }
      grid->SetDimensions(3, 3, 3);
      grid->SetXCoordinates(along);
      grid->SetYCoordinates(along);
      grid->SetZCoordinates(along);
      vtkNew<vtkIntArray> labels;
      labels->SetNumberOfTuples(27);
      labels->Fill(1);
      grid->GetPointData()->SetScalars(labels);
      scene.Mapper->SetInputData(grid);
    });

  // No label is drawn: one warning.
  const auto image = Balls();
  LabelScene scene(image);
  scene.Mapper->SetLabelTable(Table({ 0, 1, 2, 3, 4, 5 }));
  vtkNew<vtkTest::ErrorObserver> observer;
  scene.Mapper->AddObserver(vtkCommand::WarningEvent, observer);
  Expect(scene.Render(Size, Size) &&
      observer->GetWarningMessage().find("No label is drawn") != std::string::npos,
    "a warning that no label is drawn");
}

}

int TestLabels(int, char*[])
{
  TestPixels();
  TestColors();
  TestOpacities();
  TestCuts();
  TestRoutes();
  TestStrokes(false);
  TestStrokes(true);
  TestChangesNotTold();
  TestOddChanges();
  TestCapsOfOtherSets();
  TestOtherSets();
  TestManyLabels();
  TestSettings();
  TestMistakes();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
