// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// The Explorer's model: sessions are repeated, those of version 0.1 too, and settings are fitted to
// the data.

#include "ExplorerTests.h"

#include "Files/FourSpheres.h"
#include "View/Appearance.h"

#include <vtkCamera.h>
#include <vtkColorTransferFunction.h>
#include <vtkContourValues.h>
#include <vtkMath.h>
#include <vtkPiecewiseFunction.h>
#include <vtkVolumeProperty.h>

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
