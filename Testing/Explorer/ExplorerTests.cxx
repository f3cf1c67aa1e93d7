// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
// The Explorer's model, its work in the background, and its widgets, by simulated events. Nothing
// waits for a time: what is to happen is waited for.
#include "Files/FourSpheres.h"
#include "Program/UserError.h"
#include "View/Appearance.h"
#include "Window/Display.h"
#include "Window/MainWindow.h"

#include <vtkCamera.h>
#include <vtkColorTransferFunction.h>
#include <vtkContourValues.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPointData.h>
#include <vtkUnsignedCharArray.h>
#include <vtkVolumeProperty.h>

#include <QAbstractButton>
#include <QAction>
#include <QComboBox>
#include <QFile>
#include <QLabel>
#include <QSettings>
#include <QSignalSpy>
#include <QSlider>
#include <QSurfaceFormat>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QVTKOpenGLNativeWidget.h>
#include <QtTest>

#include <cstdio>
#include <cstring>

namespace
{

constexpr int Width = 160, Height = 120; // of pictures
constexpr int Spheres = 32;
constexpr int Patience = 60000; // ms until what has not happened is a failure

Session SmallSession()
{
  Session session;
  session.Source.Spheres = Spheres;
  return session;
}

bool AreSame(vtkImageData* a, vtkImageData* b)
{
  const auto bytes = [](vtkImageData* image)
  { return static_cast<std::size_t>(image->GetNumberOfPoints()) * 3; };
  return bytes(a) == bytes(b) &&
    std::memcmp(a->GetScalarPointer(), b->GetScalarPointer(), bytes(a)) == 0;
}

void Write(const QString& path, const std::string& text)
{
  QFile file(path);
  QVERIFY(file.open(QFile::WriteOnly));
  file.write(text.data(), static_cast<qint64>(text.size()));
}

std::string TextOf(const QString& path)
{
  QFile file(path);
  return file.open(QFile::ReadOnly) ? file.readAll().toStdString() : "";
}

// A tetrahedron whose values rise with time.
std::string TimeSeries()
{
  std::string arrays;
  for (int step = 0; step < 3; ++step)
  {
    const auto number = [step](int value) { return std::to_string(value + 10 * step); };
    arrays += "<DataArray type=\"Float32\" Name=\"value\" format=\"ascii\" TimeStep=\"" +
      std::to_string(step) + "\">" + number(0) + " " + number(0) + " " + number(0) + " " +
      number(100) + "</DataArray>\n";
  }
  return "<VTKFile type=\"UnstructuredGrid\" version=\"0.1\">\n"
         "<UnstructuredGrid TimeValues=\"0 1 2\">\n"
         "<Piece NumberOfPoints=\"4\" NumberOfCells=\"1\">\n<PointData Scalars=\"value\">\n" +
    arrays +
    "</PointData>\n<Points><DataArray type=\"Float32\" NumberOfComponents=\"3\" "
    "format=\"ascii\">0 0 0 1 0 0 0 1 0 0 0 1</DataArray></Points>\n"
    "<Cells><DataArray type=\"Int32\" Name=\"connectivity\" format=\"ascii\">0 1 2 3</DataArray>"
    "<DataArray type=\"Int32\" Name=\"offsets\" format=\"ascii\">4</DataArray>"
    "<DataArray type=\"UInt8\" Name=\"types\" format=\"ascii\">10</DataArray></Cells>\n"
    "</Piece></UnstructuredGrid></VTKFile>\n";
}

}

class ExplorerTests : public QObject
{
  Q_OBJECT

private slots:
  void initTestCase();
  void init();
  void cleanup();

  void ASessionOfVersion01GivesTheSamePicture();
  void SessionsAreRepeated();
  void SettingsAreFitted();
  void WaysToDrawDiffer();

  void TheWindowAnswersWhileReading();
  void TheLatestFileIsOpened();
  void TheWindowAnswersWhileAnIsomapIsBuilt();
  void SettingsWaitForTheIsomap();
  void ChangesAreUndone();
  void WhatCannotBeOpenedIsTold();
  void TimeStepsArePlayed();

  void TheHistogramMovesIsovalues();
  void TheHistogramMovesOpacities();
  void TheTableChangesSurfaces();
  void PanelsShowTheModel();
  void ClippingAndCropping();
  void KeysOfVersion01();
  void KeyboardAlone();
  void NothingIsCutOff();
  void NamesOfAllScripts();

private:
  void Open(const Session& session);

  QTemporaryDir Directory;
  std::unique_ptr<Workbench> Bench;
  std::unique_ptr<MainWindow> Window;
};

void ExplorerTests::initTestCase()
{
  QVERIFY(this->Directory.isValid());
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, this->Directory.path());
}

void ExplorerTests::init()
{
  Options options;
  options.OutputDirectory = this->Directory.path().toStdString();
  this->Bench = std::make_unique<Workbench>(options);
  this->Window = std::make_unique<MainWindow>(*this->Bench);
  this->Window->resize(900, 700);
  this->Window->show();
  this->Open(SmallSession());
}

void ExplorerTests::cleanup()
{
  this->Window.reset();
  this->Bench.reset();
}

void ExplorerTests::Open(const Session& session)
{
  QSignalSpy opened(this->Bench.get(), &Workbench::Opened);
  this->Bench->Open(session);
  QVERIFY(!opened.isEmpty() || opened.wait(Patience));
}

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
  VolumeView reference; // for its background and its way to make pictures
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
  QVERIFY(mapper->RenderToImage(renderer, actor, Width, Height, rgba, nullptr));
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
  session.Settings.Nodes = { { 0.0, 0.0 }, { 50.0, 0.125, Rgb{ 1.0, 0.0, 0.0 } }, { 99.0, 1.0 } };
  session.Settings.Density = 2.5;
  session.Settings.Clip = Plane{ { 0.0, 12.5, 0.0 }, { 0.0, 1.0, 0.0 } };
  session.Settings.Crop = std::array<double, 6>{ 4.5, 28.5, 0.0, 31.0, 5.0, 31.0 };
  session.Settings.Shading = std::array<double, 4>{ 0.1, 0.2, 0.3, 40.0 };
  session.Settings.Choices[Choose::Drawing] = 1;
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
  look.Crop = std::array<double, 6>{ 1e9, -1e9, 0.0, 0.1, -1e9, 1e9 };
  look.Clip = Plane{};
  look.Shading = std::array<double, 4>{ -1.0, 2.0, 0.5, 1e9 };
  this->Bench->Data.SetSettings(look);
  const Look& fitted = this->Bench->Data.Settings();
  const auto& range = this->Bench->Data.Counted().Range;
  QCOMPARE(fitted.Surfaces[0].Isovalue, range[1]);
  QCOMPARE(fitted.Surfaces[1].Isovalue, range[0]);
  QCOMPARE(fitted.Surfaces[0].Opacity, 1.0);
  QVERIFY(fitted.Nodes[0].Value <= fitted.Nodes[1].Value);
  QVERIFY((*fitted.Crop)[0] <= (*fitted.Crop)[1]);
  QVERIFY(!fitted.Clip);
  QCOMPARE((*fitted.Shading)[0], 0.0);
  this->Bench->Data.View.Picture(Width, Height);
}

void ExplorerTests::WaysToDrawDiffer()
{
  std::vector<vtkSmartPointer<vtkImageData>> pictures;
  const std::size_t count = ChoiceOf(Choose::Drawing).Values.size();
  for (std::size_t i = 0; i < count; ++i)
  {
    pictures.push_back(this->Bench->Data.View.Picture(Width, Height));
    for (std::size_t j = 0; j < i; ++j)
    {
      QVERIFY2(!AreSame(pictures[i], pictures[j]), ChoiceOf(Choose::Drawing).Values[i]);
    }
    this->Bench->Turn(Choose::Drawing, 1);
  }
  QVERIFY(AreSame(pictures[0], this->Bench->Data.View.Picture(Width, Height)));
}

// Opening comes back at once; what is read is seen when the event loop has run.
void ExplorerTests::TheWindowAnswersWhileReading()
{
  Session session = SmallSession();
  session.Source.Spheres = 2 * Spheres;
  QSignalSpy opened(this->Bench.get(), &Workbench::Opened);
  this->Bench->Open(session);
  QVERIFY(this->Bench->IsBusy());
  QCOMPARE(this->Bench->Data.State().Source.Spheres, Spheres);
  // Meanwhile what is shown is drawn, and changed.
  QSignalSpy frames(this->Bench.get(), &Workbench::FrameDrawn);
  this->Bench->Turn(Choose::Palette, 1);
  this->Bench->Render();
  QCOMPARE(frames.count(), 1);
  QVERIFY(opened.wait(Patience));
  QVERIFY(!this->Bench->IsBusy());
  QCOMPARE(this->Bench->Data.State().Source.Spheres, 2 * Spheres);
}

void ExplorerTests::TheLatestFileIsOpened()
{
  QSignalSpy opened(this->Bench.get(), &Workbench::Opened);
  for (const int size : { 20, 24, 28 })
  {
    Session session = SmallSession();
    session.Source.Spheres = size;
    this->Bench->Open(session);
  }
  QVERIFY(opened.wait(Patience));
  QCOMPARE(opened.count(), 1);
  QCOMPARE(this->Bench->Data.State().Source.Spheres, 28);
}

void ExplorerTests::TheWindowAnswersWhileAnIsomapIsBuilt()
{
  QSignalSpy said(this->Bench.get(), &Workbench::Said);
  this->Bench->BuildIsomap();
  QVERIFY(this->Bench->IsBusy());
  QTRY_VERIFY_WITH_TIMEOUT(!this->Bench->IsBusy(), Patience);
  QVERIFY(said.last()[0].toString().contains("is built"));
  // Stopped before the event loop has run, so before it can be done.
  this->Bench->Turn(Choose::Surface, 1);
  this->Bench->BuildIsomap();
  this->Bench->Cancel();
  QTRY_VERIFY_WITH_TIMEOUT(!this->Bench->IsBusy(), Patience);
  QVERIFY(said.last()[0].toString().contains("was stopped"));
}

void ExplorerTests::SettingsWaitForTheIsomap()
{
  this->Bench->BuildIsomap();
  this->Bench->Edit("isovalue", [](Look& look) { look.Surfaces[0].Isovalue = 77.0; });
  QCOMPARE(*this->Bench->Data.State().Isovalue, 77.0);
  QTRY_VERIFY_WITH_TIMEOUT(!this->Bench->IsBusy(), Patience);
  QCOMPARE(this->Bench->Data.View.Facts().Route, std::string("IsomapLookup"));
}

void ExplorerTests::ChangesAreUndone()
{
  const double before = *this->Bench->Data.State().Isovalue;
  this->Bench->BeginGesture();
  for (const double value : { 50.0, 60.0, 70.0 })
  {
    this->Bench->Edit("isovalue", [=](Look& look) { look.Surfaces[0].Isovalue = value; });
  }
  this->Bench->Turn(Choose::Light, 1);
  QCOMPARE(this->Bench->Changes.count(), 2);
  this->Bench->Changes.undo();
  QCOMPARE(this->Bench->Data.Settings().Choices[Choose::Light], 0);
  QCOMPARE(*this->Bench->Data.State().Isovalue, 70.0);
  this->Bench->Changes.undo();
  QCOMPARE(*this->Bench->Data.State().Isovalue, before);
  this->Bench->Changes.redo();
  QCOMPARE(*this->Bench->Data.State().Isovalue, 70.0);
}

void ExplorerTests::WhatCannotBeOpenedIsTold()
{
  Write(this->Directory.filePath("broken.vti"), "This is no XML.");
  QSignalSpy said(this->Bench.get(), &Workbench::Said);
  this->Bench->OpenPath(this->Directory.filePath("broken.vti").toStdString());
  QTRY_VERIFY_WITH_TIMEOUT(!this->Bench->IsBusy(), Patience);
  QCOMPARE(said.count(), 1);
  QVERIFY(said[0][0].toString().contains("could not be read"));
  QVERIFY(said[0][1].toBool());
  QCOMPARE(this->Window->findChild<QLabel*>("sentence")->text(), said[0][0].toString());
  QCOMPARE(this->Bench->Data.State().Source.Spheres, Spheres);
}

void ExplorerTests::TimeStepsArePlayed()
{
  Session session;
  session.Source.Path = this->Directory.filePath("series.vtu").toStdString();
  Write(this->Directory.filePath("series.vtu"), TimeSeries());
  this->Open(session);
  QCOMPARE(this->Bench->Data.Data().TimeSteps, 3);
  auto* slider = this->Window->findChild<QSlider*>("time");
  QVERIFY(slider->isVisible());
  QCOMPARE(slider->maximum(), 3);
  slider->setValue(3);
  QTRY_COMPARE_WITH_TIMEOUT(this->Bench->Data.State().Source.TimeStep, 3, Patience);
  QCOMPARE(this->Bench->Data.Counted().Range[1], 120.0);
  // Round and round, until it is paused.
  QSignalSpy opened(this->Bench.get(), &Workbench::Opened);
  auto* play = this->Window->findChild<QAbstractButton*>("play");
  play->click();
  QTRY_VERIFY_WITH_TIMEOUT(opened.count() >= 4, Patience);
  play->click();
  QTRY_VERIFY_WITH_TIMEOUT(!this->Bench->IsBusy(), Patience);
}

void ExplorerTests::TheHistogramMovesIsovalues()
{
  HistogramPanel* histogram = this->Window->Histogram();
  const auto& range = this->Bench->Data.Counted().Range;
  const auto isovalue = [this] { return *this->Bench->Data.State().Isovalue; };
  QTest::mousePress(histogram, Qt::LeftButton, {}, histogram->PlaceOf(0.5));
  QTest::mouseMove(histogram, histogram->PlaceOf(1.0));
  QTest::mouseRelease(histogram, Qt::LeftButton, {}, histogram->PlaceOf(1.0));
  QTRY_VERIFY_WITH_TIMEOUT(!this->Bench->IsBusy(), Patience);
  const double step = this->Bench->Data.StepOfIsovalues();
  this->Bench->Edit("isovalue", [](Look& look) { look.Surfaces[0].Isovalue = 100.0; });
  QTest::keyClick(histogram, Qt::Key_Right);
  QCOMPARE(isovalue(), 100.0 + step);
  QTest::keyClick(histogram, Qt::Key_Left, Qt::ShiftModifier);
  QCOMPARE(isovalue(), 100.0 - 9.0 * step);
  // The view passes them on.
  QTest::keyClick(this->Window->View(), Qt::Key_Up);
  QCOMPARE(isovalue(), 100.0 - 8.0 * step);
  // Of two surfaces, the marker that is near is dragged.
  this->Bench->Edit("surface",
    [&](Look& look) {
      look.Surfaces = { { range[0] + 0.25 * (range[1] - range[0]) }, { range[1] } };
    });
  QTest::mousePress(histogram, Qt::LeftButton, {}, histogram->PlaceOf(1.0) - QPoint(2, 0));
  QTest::mouseRelease(histogram, Qt::LeftButton, {}, histogram->PlaceOf(1.0));
  QCOMPARE(this->Bench->Selected(), std::size_t{ 1 });
  QTest::keyClick(histogram, Qt::Key_PageDown);
  QCOMPARE(this->Bench->Selected(), std::size_t{ 0 });
  QTRY_VERIFY_WITH_TIMEOUT(!this->Bench->IsBusy(), Patience);
}

void ExplorerTests::TheHistogramMovesOpacities()
{
  HistogramPanel* histogram = this->Window->Histogram();
  this->Bench->Turn(Choose::Drawing, 1);
  const auto nodes = [this]() -> const std::vector<Node>&
  { return this->Bench->Data.Settings().Nodes; };
  const std::size_t before = nodes().size();
  QTest::mouseDClick(histogram, Qt::LeftButton, {}, histogram->PlaceOf(0.75));
  QCOMPARE(nodes().size(), before + 1);
  QVERIFY(std::abs(nodes()[before - 1].Opacity - 0.5) < 0.1);
  QTest::keyClick(histogram, Qt::Key_Up);
  QTest::keyClick(histogram, Qt::Key_Delete);
  QCOMPARE(nodes().size(), before);
  QTest::keyClick(histogram, Qt::Key_Insert);
  QCOMPARE(nodes().size(), before + 1);
}

void ExplorerTests::TheTableChangesSurfaces()
{
  auto* table = this->Window->findChild<QTableWidget*>("surfaces");
  QTRY_COMPARE_WITH_TIMEOUT(table->rowCount(), 1, Patience);
  const auto surface = [this] { return this->Bench->Data.Settings().Surfaces[0]; };
  table->item(0, 0)->setText("90");
  QCOMPARE(surface().Isovalue, 90.0);
  table->item(0, 0)->setCheckState(Qt::Unchecked);
  QVERIFY(!surface().IsVisible);
  table->item(0, 2)->setText("40 %");
  QCOMPARE(surface().Opacity, 0.4);
  table->item(0, 2)->setText("nonsense");
  QCOMPARE(surface().Opacity, 0.4);
  this->Bench->Edit("surface", [](Look& look) { look.Surfaces.push_back(look.Surfaces[0]); });
  QTRY_COMPARE_WITH_TIMEOUT(table->rowCount(), 2, Patience);
}

void ExplorerTests::PanelsShowTheModel()
{
  auto* palette = this->Window->findChild<QComboBox*>("palette");
  this->Bench->Turn(Choose::Palette, 2);
  QTRY_COMPARE_WITH_TIMEOUT(palette->currentText(), QString("steel"), Patience);
  auto* isomap = this->Window->findChild<QAbstractButton*>("isomap");
  QTRY_VERIFY_WITH_TIMEOUT(isomap->isChecked(), Patience);
  isomap->click();
  QVERIFY(!this->Bench->Data.Settings().Choices.IsOn(Choose::Isomap));
  // Meshes have normals of their own, and surfaces only.
  QVERIFY(!this->Window->findChild<QComboBox*>("gradients")->isVisibleTo(this->Window.get()));
}

void ExplorerTests::ClippingAndCropping()
{
  const auto whole = this->Bench->Data.View.Picture(Width, Height);
  this->Window->findChild<QAbstractButton*>("clip")->click();
  QVERIFY(this->Bench->Data.Settings().Clip.has_value());
  const auto clipped = this->Bench->Data.View.Picture(Width, Height);
  QVERIFY(!AreSame(whole, clipped));
  this->Window->findChild<QAbstractButton*>("clip")->click();
  this->Bench->Edit("cropping",
    [](Look& look) {
      look.Crop = std::array<double, 6>{ 15.5, 31.0, 0.0, 31.0, 0.0, 31.0 };
    });
  const auto cropped = this->Bench->Data.View.Picture(Width, Height);
  QVERIFY(!AreSame(whole, cropped));
  this->Bench->Changes.undo();
  QVERIFY(AreSame(whole, this->Bench->Data.View.Picture(Width, Height)));
}

void ExplorerTests::KeysOfVersion01()
{
  std::set<QString> there;
  for (const QAction* action : this->Window->findChildren<QAction*>())
  {
    for (const QKeySequence& keys : action->shortcuts())
    {
      QVERIFY2(there.insert(keys.toString()).second, keys.toString().toUtf8());
    }
  }
  for (const char* keys : { "O", "B", "S", "Shift+S", "R", "W", "Z", "H", "N", ",", ".", "?", "F1",
         "Q", "P", "M", "L", "V", "A", "C", "I", "J", "K", "Y", "X", "F", "G" })
  {
    QVERIFY2(there.count(keys) == 1, keys);
  }
}

// Whatever takes the mouse takes the keyboard, too, and says what it is.
void ExplorerTests::KeyboardAlone()
{
  for (const QWidget* widget : this->Window->findChildren<QWidget*>())
  {
    const bool isInput = qobject_cast<const QComboBox*>(widget) ||
      qobject_cast<const QSlider*>(widget) || widget == this->Window->Histogram() ||
      widget == this->Window->View();
    if (isInput && !widget->objectName().startsWith("qt_"))
    {
      QVERIFY2(widget->focusPolicy() & Qt::TabFocus, widget->objectName().toUtf8());
      QVERIFY2(!widget->toolTip().isEmpty() || !widget->accessibleName().isEmpty(),
        widget->objectName().toUtf8());
    }
  }
}

void ExplorerTests::NothingIsCutOff()
{
  const QFont before = QApplication::font();
  for (const double scale : { 1.0, 2.0 })
  {
    QFont font = before;
    font.setPointSizeF(scale * before.pointSizeF());
    QApplication::setFont(font);
    this->cleanup();
    this->init();
    for (const QWidget* widget : this->Window->findChildren<QWidget*>())
    {
      const bool hasText = qobject_cast<const QLabel*>(widget) ||
        qobject_cast<const QAbstractButton*>(widget) || qobject_cast<const QComboBox*>(widget);
      const bool isOurs = widget->objectName() != "sentence" &&
        !QString(widget->metaObject()->className()).startsWith("QDock");
      if (hasText && isOurs && widget->isVisible())
      {
        QVERIFY2(widget->width() >= widget->minimumSizeHint().width(),
          QString("%1 %2 at font scale %3")
            .arg(widget->metaObject()->className(), widget->accessibleName())
            .arg(scale)
            .toUtf8());
      }
    }
  }
  QApplication::setFont(before);
}

void ExplorerTests::NamesOfAllScripts()
{
  const QString name = QString::fromUtf8("球 كرة.vtu");
  Write(this->Directory.filePath(name), TimeSeries());
  QSignalSpy opened(this->Bench.get(), &Workbench::Opened);
  this->Bench->OpenPath(this->Directory.filePath(name).toStdString());
  QVERIFY(opened.wait(Patience));
  QVERIFY(this->Window->windowTitle().startsWith(name));
  QVERIFY(this->Window->findChild<QLabel*>("sentence")->text().startsWith(name));
}

int main(int argc, char* argv[])
{
  try
  {
    CheckDisplay();
  }
  catch (const UserError& mistake)
  {
    std::printf("SKIPPED: %s\n", mistake.what());
    return 0;
  }
  QSurfaceFormat format = QVTKOpenGLNativeWidget::defaultFormat();
  format.setSamples(0);
  QSurfaceFormat::setDefaultFormat(format);
  QApplication application(argc, argv);
  ExplorerTests tests;
  return QTest::qExec(&tests, argc, argv);
}

#include "ExplorerTests.moc"
