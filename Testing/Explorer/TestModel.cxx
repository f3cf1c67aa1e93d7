// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// The Explorer's model: sessions are repeated, those of version 0.1 too, and settings are fitted to
// the data.

#include "ExplorerTests.h"

#include "Files/FourSpheres.h"
#include "Files/LabelNames.h"
#include "Program/UserError.h"
#include "View/Appearance.h"

#include <vtkCamera.h>
#include <vtkColorTransferFunction.h>
#include <vtkContourValues.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkMath.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPointData.h>
#include <vtkVolumeProperty.h>

#include <QDir>

#include <algorithm>
#include <cmath>
#include <cstring>

// As version 0.1 set up its mapper.
void ExplorerTests::ASessionOfVersion01GivesTheSamePicture()
{
  const QString path = this->Directory.filePath("old.session");
  Write(path,
    "# vtkTemporalCoherence Explorer session 1\nspheres = 32\nisovalue = 100\n"
    "camera-position = 70 -60 50\ncamera-focal-point = 15.5 15.5 15.5\ncamera-view-up = 0 0 1\n"
    "camera-view-angle = 30\npalette = ember\nmaterial = glossy\nlight = side\n"
    "surface = solid\naccuracy = bounded\nimage-cache = on\nisomap = off\nleaping = on\n"
    "map-ahead = on\nanswers = off\nscale = 2\nfilm = png\ngradients = facets\n");
  Model model("", "+z");
  model.Open(ReadSession(path.toStdString()));
  const auto picture = model.View.Picture(Width, Height);

  const vtkSmartPointer<vtkImageData> volume = MakeFourSpheres(Spheres);
  double range[2];
  volume->GetScalarRange(range);

  vtkNew<vtkTemporalCoherenceVolumeMapper> mapper;
  mapper->SetInputDataObject(volume);
  mapper->SetSurfaceModeToThreshold();
  vtkNew<vtkVolume> actor;
  actor->SetMapper(mapper);
  vtkVolumeProperty* property = actor->GetProperty();
  property->SetInterpolationTypeToLinear();
  property->GetIsoSurfaceValues()->SetValue(0, 100.0);
  vtkNew<vtkPiecewiseFunction> opaque;
  opaque->AddPoint(range[0], 1.0);
  opaque->AddPoint(range[1], 1.0);
  property->SetScalarOpacity(opaque);
  SetPalette(property->GetRGBTransferFunction(), 3, { range[0], range[1] });
  SetMaterial(property, 2);
  vtkNew<vtkRenderer> renderer;
  SetLight(renderer, 2);
  renderer->AddVolume(actor);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(70.0, -60.0, 50.0);
  camera->SetFocalPoint(15.5, 15.5, 15.5);
  camera->SetViewUp(0.0, 0.0, 1.0);
  camera->SetViewAngle(30.0);
  renderer->ResetCameraClippingRange();
  vtkNew<vtkImageData> rgba;
  QVERIFY(mapper->MakeImage(renderer, actor, Width, Height, rgba, nullptr));
  const auto* expected = static_cast<unsigned char*>(rgba->GetScalarPointer());
  const auto* got = static_cast<unsigned char*>(picture->GetScalarPointer());
  int covered = 0;
  for (int i = 0; i < Width * Height; ++i)
  {
    if (expected[4 * i + 3] == 255)
    {
      ++covered;
      QVERIFY(std::memcmp(expected + 4 * i, got + 3 * i, 3) == 0);
    }
  }
  QVERIFY2(covered > 500, std::to_string(covered).c_str());
}

// At first, but as a session says, if one says it.
void ExplorerTests::AveragesAndSumsAreBright()
{
  for (const int drawing : { Drawing::Average, Drawing::Additive })
  {
    Session session = SmallSession();
    session.Settings.Values[Row::Drawing] = drawing;
    Model model("", "+z");
    model.Open(session);
    const auto brightest = [&]
    {
      const vtkSmartPointer<vtkImageData> picture = model.View.Picture(Width, Height);
      double range[2];
      picture->GetPointData()->GetScalars()->GetRange(range, 0);
      return range[1];
    };
    QVERIFY(brightest() > 220.0);
    const double fitting = model.Settings().Values[Row::Brightness];
    QVERIFY(fitting > 0.0);
    session = model.State();
    session.Settings.Values[Row::Brightness] = 0.2 * fitting;
    model.Open(session);
    QCOMPARE(model.Settings().Values[Row::Brightness], 0.2 * fitting);
    QVERIFY(brightest() < 120.0 && brightest() > 20.0);
    Look look = model.Settings();
    model.SetChoice(look, Row::Drawing, Drawing::Composite);
    model.SetSettings(look);
    QCOMPARE(model.View.Mapper->GetFinalColorWindow(), 1.0f);
    model.SetChoice(look, Row::Drawing, drawing);
    model.SetSettings(look);
    QVERIFY(brightest() > 220.0);
  }
}

void ExplorerTests::SessionsAreRepeated()
{
  Session session = SmallSession();
  session.Isovalue = 40.0;
  session.Settings.Surfaces = { { 40.0, 0.25, true, Rgb{ 0.5, 0.25, 1.0 } }, { 90.5, 1.0, false } };
  session.Settings.Nodes = { { 0.0, 0.0 }, { 50.0, 0.125, true, Rgb{ 1.0, 0.0, 0.0 } },
    { 99.0, 1.0 } };
  session.Settings.Values[Row::Density] = 2.5;
  session.Settings.Values[Row::OwnShading] = 1;
  session.Settings.Values[Row::Clipping] = session.Settings.Values[Row::Cropping] = 1.0;
  session.Settings.Clip = Plane{ { 0.0, 12.5, 0.0 }, { 0.0, 1.0, 0.0 } };
  SetNumbers(session.Settings, Row::Crop, { 4.5, 28.5, 0.0, 31.0, 5.0, 31.0 });
  SetNumbers(session.Settings, Row::Shading, { 0.1, 0.2, 0.3, 40.0 });
  session.Settings.Values[Row::Drawing] = 1;
  const QString first = this->Directory.filePath("first.session");
  const QString second = this->Directory.filePath("second.session");
  WriteSession(session, first.toStdString());
  WriteSession(ReadSession(first.toStdString()), second.toStdString());
  QVERIFY(TextOf(first).find("surfaces = 40 0.25 1 0.5 0.25 1 ; 90.5 1 0") != std::string::npos);
  QCOMPARE(TextOf(second), TextOf(first));
  // As it is shown.
  this->Open(ReadSession(first.toStdString()));
  this->Bench->Data.Save(second.toStdString());
  const auto picture = this->Bench->Data.View.Picture(Width, Height);
  this->Open(ReadSession(second.toStdString()));
  QVERIFY(AreSame(picture, this->Bench->Data.View.Picture(Width, Height)));
}

void ExplorerTests::SettingsAreFitted()
{
  Look look = this->Bench->Data.Settings();
  look.Surfaces = { { 1e9, 7.0 }, { -1e9, -7.0 } };
  look.Nodes = { { 50.0, 2.0 }, { 40.0, -1.0 } };
  SetNumbers(look, Row::Crop, { 1e9, -1e9, 0.0, 0.1, -1e9, 1e9 });
  look.Values[Row::Clipping] = 1;
  look.Clip = Plane{};
  look.Values[Row::OwnShading] = 1;
  SetNumbers(look, Row::Shading, { -1.0, 2.0, 0.5, 1e9 });
  this->Bench->Data.SetSettings(look);
  const Look& fitted = this->Bench->Data.Settings();
  const auto& range = this->Bench->Data.Counted().Range;
  QCOMPARE(fitted.Surfaces[0].Value, range[1]);
  QCOMPARE(fitted.Surfaces[1].Value, range[0]);
  QCOMPARE(fitted.Surfaces[0].Opacity, 1.0);
  QVERIFY(fitted.Nodes[0].Value <= fitted.Nodes[1].Value);
  QVERIFY(fitted.Values[Row::Crop] <= fitted.Values[Row::Crop + 1]);
  // A plane without a direction is not drawn: another one is.
  QVERIFY(std::abs(vtkMath::Norm(fitted.Clip.Normal.data()) - 1.0) < 1e-12);
  QCOMPARE(fitted.Values[Row::Shading], 0.0);
  this->Bench->Data.View.Picture(Width, Height);
}

// A setting that a session does not tell was made after the session.
void ExplorerTests::OldSessionsAreAsTheyWere()
{
  const QString path = this->Directory.filePath("short.session");
  Write(path, "# vtkTemporalCoherence Explorer session 1\nspheres = 32\n");
  const Session session = ReadSession(path.toStdString());
  QCOMPARE(session.Settings.Values[Row::Occlusion], 0.0);
  QCOMPARE(session.Settings.Values[Row::Gradients], 0.0);
  QCOMPARE(session.Settings.Values[Row::Isomap], 1.0);
  QVERIFY(Look().Values[Row::Occlusion] != 0.0 && Look().Values[Row::Gradients] != 0.0);
}

void ExplorerTests::WaysToDrawDiffer()
{
  std::vector<vtkSmartPointer<vtkImageData>> pictures;
  const std::size_t count = AllSettings()[Row::Drawing].Words.size();
  for (std::size_t i = 0; i < count; ++i)
  {
    pictures.push_back(this->Bench->Data.View.Picture(Width, Height));
    for (std::size_t j = 0; j < i; ++j)
    {
      QVERIFY2(!AreSame(pictures[i], pictures[j]), AllSettings()[Row::Drawing].Words[i]);
    }
    this->Bench->Turn(Row::Drawing, 1);
  }
  QVERIFY(AreSame(pictures[0], this->Bench->Data.View.Picture(Width, Height)));
}

void ExplorerTests::PresetsAndShift()
{
  const auto look = [this]() -> const Look& { return this->Bench->Data.Settings(); };
  const Setting& shift = AllSettings()[Row::Shift];
  const auto& range = this->Bench->Data.Counted().Range;
  this->Bench->Turn(Row::Drawing, 1);
  const auto own = this->Bench->Data.View.Picture(Width, Height);
  for (std::size_t preset = 1; preset < AllSettings()[Row::Preset].Words.size(); ++preset)
  {
    this->Bench->Turn(Row::Preset, 1);
    QVERIFY(look().Nodes.size() >= 4 && look().Nodes[0].Color);
    QVERIFY(!AreSame(own, this->Bench->Data.View.Picture(Width, Height)));
  }
  // What is shifted comes back, also beyond the values that there are.
  const std::vector<Marker> before = look().Nodes;
  const double middle = this->Bench->ShareOf(shift);
  this->Bench->BeginGesture();
  for (const double share : { 0.7, 1.0 })
  {
    this->Bench->SetShare(shift, share);
  }
  QVERIFY(std::abs(look().Nodes[1].Value - before[1].Value - 0.5 * (range[1] - range[0])) < 1e-9);
  QCOMPARE(look().TextOf(Row::Preset), "mr");
  this->Bench->SetShare(shift, middle);
  for (std::size_t node = 0; node < before.size(); ++node)
  {
    QVERIFY(std::abs(look().Nodes[node].Value - before[node].Value) < 1e-9);
  }
  // A node that is changed makes the preset one's own.
  this->Bench->EditMarker("opacity", [](Marker& marker) { marker.Opacity = 0.5; });
  QCOMPARE(look().TextOf(Row::Preset), "own");
  this->Bench->Changes.undo();
  QCOMPARE(look().TextOf(Row::Preset), "mr");
}

void ExplorerTests::ProjectionsAreGrey()
{
  const auto ends = [this]() -> const std::vector<Marker>& { return this->Bench->Markers(); };
  this->Bench->Turn(Row::Drawing, 2);
  const auto picture = this->Bench->Data.View.Picture(Width, Height);
  const auto* rgb = static_cast<const unsigned char*>(picture->GetScalarPointer());
  int brightest = 0;
  for (vtkIdType i = 0; i < picture->GetNumberOfPoints(); ++i, rgb += 3)
  {
    // The background is nearly grey.
    QVERIFY(std::abs(rgb[0] - rgb[1]) < 8 && std::abs(rgb[1] - rgb[2]) < 8);
    brightest = std::max<int>(brightest, rgb[0]);
  }
  QVERIFY(brightest > 200);
  // Window and level are the ends of the ramp.
  QCOMPARE(ends().size(), std::size_t{ 2 });
  this->Bench->SetShare(AllSettings()[Row::Level], 0.5);
  this->Bench->SetShare(AllSettings()[Row::Window], 0.25);
  const auto& range = this->Bench->Data.Counted().Range;
  const double width = ends()[1].Value - ends()[0].Value;
  QVERIFY(std::abs(width - 0.25 * (range[1] - range[0])) < 0.01 * (range[1] - range[0]));
  QVERIFY(std::abs(ends()[0].Value + ends()[1].Value - range[0] - range[1]) < 1e-6 * width);
  // There are two of them, in order.
  this->Bench->AddMarker();
  QVERIFY(ends().size() == 2 && !this->Bench->CanRemove());
  this->Bench->EditMarker("opacity", [](Marker& marker) { marker.Value = 1e9; });
  QVERIFY(ends()[0].Value < ends()[1].Value && ends()[1].Value <= range[1]);
}

// The grey of a sample on the plane is that of the window.
void ExplorerTests::TheCutShowsSamples()
{
  this->Bench->Data.LookFrom("-y");
  this->Bench->Edit("clipping",
    [](Look& look)
    {
      look.Values[Row::Clipping] = look.Values[Row::Cut] = 1;
      look.Clip = Plane{ { 0.0, 12.25, 0.0 }, { 0.0, 1.0, 0.0 } };
    });
  this->Bench->Render();
  const VolumeView::Seen seen = this->Bench->Data.View.SeenAt(Width, Height).value();
  QVERIFY(seen.IsCut && std::abs(seen.Place[1] - 12.25) < 1e-6);
  vtkImageData* const image = vtkImageData::SafeDownCast(this->Bench->Data.Data().Data);
  const auto sample = [&](int y)
  {
    const double x = seen.Place[0], z = seen.Place[2];
    const int i = static_cast<int>(x), k = static_cast<int>(z);
    const double u = x - i, w = z - k;
    const auto at = [&](int di, int dk)
    { return image->GetScalarComponentAsDouble(i + di, y, k + dk, 0); };
    return (1 - w) * ((1 - u) * at(0, 0) + u * at(1, 0)) + w * ((1 - u) * at(0, 1) + u * at(1, 1));
  };
  const double expected = 0.75 * sample(12) + 0.25 * sample(13);
  QVERIFY2(std::abs(seen.Value - expected) < 1e-3, std::to_string(seen.Value).c_str());
  // And so it is in a picture.
  const int* size = this->Bench->Data.View.Renderer->GetSize();
  const auto picture = this->Bench->Data.View.Picture(size[0], size[1]);
  const std::vector<Marker>& greys = this->Bench->Data.Settings().Greys;
  const double grey =
    255.0 * std::clamp((expected - greys[0].Value) / (greys[1].Value - greys[0].Value), 0.0, 1.0);
  QVERIFY2(std::abs(picture->GetScalarComponentAsDouble(Width, Height, 0, 0) - grey) < 6.0,
    std::to_string(grey).c_str());
}

void ExplorerTests::SessionsMoveWithTheirVolumes()
{
  QDir directory(this->Directory.path());
  QVERIFY(directory.mkpath("here/data"));
  Write(directory.filePath("here/data/series.vtu"), TimeSeries());
  Session session;
  session.Source.Path = directory.filePath("here/data/series.vtu").toStdString();
  WriteSession(session, directory.filePath("here/one.session").toStdString());
  QVERIFY(directory.rename("here", "there"));
  const QString moved = directory.filePath("there/one.session");
  this->Open(ReadSession(moved.toStdString()));
  QCOMPARE(this->Bench->Data.Data().TimeSteps, 3);
  // A volume that has moved by itself is asked for.
  QVERIFY(directory.rename("there/data/series.vtu", "series.vtu"));
  QSignalSpy opened(this->Bench.get(), &Workbench::Opened);
  std::string missing;
  this->Bench->OnMissing = [&](const std::string& path)
  {
    missing = path;
    return directory.filePath("series.vtu").toStdString();
  };
  this->Bench->OpenPath(moved);
  QVERIFY(opened.wait(Patience));
  QVERIFY(QString::fromStdString(missing).endsWith("there/data/series.vtu"));
}

void ExplorerTests::OpenLabels()
{
  constexpr int edge = 24;
  std::string samples;
  for (int i = 0; i < edge * edge * edge; ++i)
  {
    const int x = i % edge, y = i / edge % edge, z = i / edge / edge;
    const bool isInside = std::min({ x, y, z }) > 2 && std::max({ x, y, z }) < edge - 3;
    samples += static_cast<char>(!isInside ? 0 : x < 8 ? 1 : x < 16 ? 2 : 30);
  }
  Write(this->Directory.filePath("seg.raw"), samples);
  Write(this->Directory.filePath("seg.mhd"),
    "ObjectType = Image\nNDims = 3\nDimSize = 24 24 24\nElementType = MET_UCHAR\n"
    "ElementDataFile = seg.raw\n");
  Write(this->Directory.filePath("seg.txt"),
    "# ITK-SnAP label description\n    0     0    0    0        0  0  0    \"Clear\"\n"
    "    1   255    0    0        1  1  1    \"left; lung\"\n"
    "   30     0  255   51      0.5  1  0    \"heart\"\n");
  Session session;
  session.Source.Path = this->Directory.filePath("seg.mhd").toStdString();
  session.MaySuitFile = true;
  session.Settings.Values[Row::Occlusion] = 0;
  this->Open(session);
}

// A file of names beside the volume says that its samples are labels, unless somebody has chosen.
void ExplorerTests::LabelsHaveNames()
{
  this->OpenLabels();
  Model& model = this->Bench->Data;
  QVERIFY(model.DrawsLabels() && !model.HasIsovalues() && !model.HasMarkers());
  QCOMPARE(model.Settings().Labels.size(), std::size_t(3));
  QCOMPARE(model.Settings().Labels[0].Name, std::string("left; lung"));
  QVERIFY(model.Settings().Labels[0].Color == (Rgb{ 1.0, 0.0, 0.0 }));
  QCOMPARE(model.Settings().Labels[1].Label, 2);
  QVERIFY(model.Settings().Labels[1].Name.empty());
  QCOMPARE(model.Settings().Labels[2].Opacity, 0.5);
  const auto picture = model.View.Picture(Width, Height);
  // Hidden, and found again in a session.
  this->Bench->EditOnce("labels", [](Look& look) { look.Labels[2].IsVisible = false; });
  const auto without = model.View.Picture(Width, Height);
  QVERIFY(!AreSame(picture, without));
  const std::string path = this->Directory.filePath("labels.session").toStdString();
  model.Save(path);
  this->Bench->Changes.undo();
  QVERIFY(AreSame(picture, model.View.Picture(Width, Height)));
  this->Open(ReadSession(path));
  QCOMPARE(model.Settings().Labels[0].Name, std::string("left, lung"));
  QVERIFY(!model.Settings().Labels[2].IsVisible);
  QVERIFY(AreSame(without, model.View.Picture(Width, Height)));
  // Names from another file leave colours alone that it does not tell.
  Write(this->Directory.filePath("more.json"), R"({"labels": {"lung": 1, "aorta": 2}})");
  this->Bench->EditOnce("labels",
    [this](Look& look)
    { Model::NameLabels(look, this->Directory.filePath("more.json").toStdString()); });
  QCOMPARE(model.Settings().Labels[1].Name, std::string("aorta"));
  QVERIFY(model.Settings().Labels[0].Color == (Rgb{ 1.0, 0.0, 0.0 }));

  Session session = SmallSession();
  session.Source.Path = this->Directory.filePath("seg.mhd").toStdString();
  this->Open(session);
  QVERIFY(!model.DrawsLabels());
  // The next volume is no segmentation.
  this->OpenLabels();
  QSignalSpy opened(this->Bench.get(), &Workbench::Opened);
  Write(this->Directory.filePath("scan.mhd"), TextOf(this->Directory.filePath("seg.mhd")));
  this->Bench->OpenPath(this->Directory.filePath("scan.mhd"));
  QVERIFY(!opened.isEmpty() || opened.wait(Patience));
  QVERIFY(!model.DrawsLabels());
}

void ExplorerTests::NamesOfAllKindsAreRead()
{
  const auto read = [this](const char* name, const std::string& text)
  {
    Write(this->Directory.filePath(name), text);
    return ReadLabelNames(this->Directory.filePath(name).toStdString());
  };
  const auto slicer =
    read("a.ctbl", "# Color table file\n0 air 0 0 0 0\n7 left_lung 255 51 0 255\n");
  QCOMPARE(slicer.size(), std::size_t(2));
  QCOMPARE(slicer[1].Name, std::string("left lung"));
  QVERIFY(slicer[1].Color && (*slicer[1].Color)[1] == 0.2 && slicer[0].Opacity == 0.0);
  for (const char* text :
    { R"({"1": "liver", "12": "spleen"})", R"({"liver": 1, "spleen": "12"})",
      R"({"name": "x", "labels": {"liver": 1, "spleen": 12}})",
      R"([{"value": 1, "name": "liver", "color": [255, 51, 0]}, {"label": 12, "name": "spleen"}])" })
  {
    const auto names = read("b.json", text);
    QCOMPARE(names.size(), std::size_t(2));
    const bool isFirst = names[0].Label == 1;
    QCOMPARE(names[isFirst ? 0 : 1].Name, std::string("liver"));
    QCOMPARE(names[isFirst ? 1 : 0].Label, 12);
  }
  for (const char* text : { "", "{", "[]", "7", R"({"EchoTime": 0.03})", R"([{"value": 1}])",
         R"([{"value": -1, "name": "x"}])",
         R"([{"value": 1, "name": "x", "color": ["red", 0, 0]}])", R"({"1": {"2": 3}})" })
  {
    QVERIFY_EXCEPTION_THROWN(read("c.json", text), UserError);
  }
  // Many files beside a volume have names with numbers.
  const std::string sidecar = this->Directory.filePath("d.json").toStdString();
  Write(this->Directory.filePath("d.json"), R"({"RepetitionTime": 2, "FlipAngle": 90})");
  QCOMPARE(ReadLabelNames(sidecar).size(), std::size_t(2));
  QVERIFY_EXCEPTION_THROWN(ReadLabelNames(sidecar, true), UserError);
  // FreeSurfer's tables have 0 where Slicer's have opacities.
  QCOMPARE(
    *read("e.txt", "10 Left-Thalamus 0 118 14 0\n11 Left-Caudate 122 186 220 0\n")[1].Opacity, 1.0);
  QVERIFY_EXCEPTION_THROWN(read("c.txt", "1 2 3\n"), UserError);
  QVERIFY_EXCEPTION_THROWN(read("c.txt", "1 liver 255 0 0 255\nno label\n"), UserError);
  QVERIFY_EXCEPTION_THROWN(
    ReadLabelNames(this->Directory.filePath("missing.txt").toStdString()), UserError);
}
