// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// The Explorer's histogram, table, panels and keys change the model and show it. The keyboard alone
// suffices, and nothing is cut off.

#include "ExplorerTests.h"

#include <vtkCamera.h>
#include <vtkMath.h>

#include <QAbstractButton>
#include <QAction>
#include <QComboBox>
#include <QDialog>
#include <QDialogButtonBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMouseEvent>
#include <QPushButton>
#include <QSlider>
#include <QSpinBox>
#include <QTableWidget>
#include <QTimer>
#include <QVTKOpenGLNativeWidget.h>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <set>

void ExplorerTests::TheHistogramMovesIsovalues()
{
  HistogramPanel* histogram = this->Window->Histogram();
  const auto& range = this->Bench->Data.Counted().Range;
  const auto isovalue = [this] { return *this->Bench->Data.State().Isovalue; };
  QTest::mousePress(histogram, Qt::LeftButton, {}, histogram->PlaceOf(0.5));
  QTest::mouseMove(histogram, histogram->PlaceOf(1.0));
  QTest::mouseRelease(histogram, Qt::LeftButton, {}, histogram->PlaceOf(1.0));
  QTRY_VERIFY_WITH_TIMEOUT(!this->Bench->IsBusy(), Patience);
  const double step = this->Bench->Data.StepOfValues();
  this->Bench->Edit("isovalue", [](Look& look) { look.Surfaces[0].Value = 100.0; });
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
  this->Bench->Turn(Row::Drawing, 1);
  const auto nodes = [this]() -> const std::vector<Marker>&
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

// The value under the pointer stays there, and keys move by smaller steps.
void ExplorerTests::TheHistogramIsZoomed()
{
  HistogramPanel* histogram = this->Window->Histogram();
  const QPoint middle = histogram->PlaceOf(0.5), place = histogram->PlaceOf(0.25);
  const auto turn = [&](int clicks, Qt::KeyboardModifiers keys)
  {
    QWheelEvent event(place, histogram->mapToGlobal(place), {}, QPoint(0, 120 * clicks),
      Qt::NoButton, keys, Qt::NoScrollPhase, false);
    QApplication::sendEvent(histogram, &event);
  };
  turn(4, Qt::ControlModifier);
  QVERIFY(std::abs(histogram->PlaceOf(0.25).x() - place.x()) <= 1);
  QVERIFY(histogram->PlaceOf(0.5).x() > middle.x() + 20);
  QTest::mouseClick(histogram, Qt::LeftButton, {}, place);
  QTRY_VERIFY_WITH_TIMEOUT(!this->Bench->IsBusy(), Patience);
  const double value = *this->Bench->Data.State().Isovalue;
  QVERIFY(std::abs(this->Bench->Data.ShareOf(value) - 0.25) < 0.01);
  QTest::keyClick(histogram, Qt::Key_Right);
  const double step = *this->Bench->Data.State().Isovalue - value;
  QVERIFY(step > 0.0 && step < 0.5 * this->Bench->Data.StepOfValues());
  const int before = histogram->PlaceOf(0.25).x();
  turn(-1, Qt::ShiftModifier);
  QVERIFY(histogram->PlaceOf(0.25).x() < before);
  turn(-30, Qt::ControlModifier);
  QCOMPARE(histogram->PlaceOf(0.5), middle);
}

// Files of samples alone tell nothing of themselves.
void ExplorerTests::FilesOfSamplesAloneAreAskedFor()
{
  std::string samples;
  for (int i = 0; i < 5 * 4 * 3; ++i)
  {
    samples += static_cast<char>(i);
  }
  const QString path = this->Directory.filePath("samples.raw");
  Write(path, samples);
  const auto answer = [this, &path](int x, bool isRight)
  {
    QTimer::singleShot(0, this,
      [=]
      {
        auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
        const QList<QSpinBox*> counts = dialog->findChildren<QSpinBox*>();
        counts[0]->setValue(x);
        counts[1]->setValue(4);
        counts[2]->setValue(3);
        auto* button = dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Open);
        QCOMPARE(button->isEnabled(), isRight);
        isRight ? dialog->accept() : dialog->reject();
      });
    this->Bench->OpenPath(path);
  };
  const std::string before = this->Bench->Data.State().Source.Path;
  answer(6, false);
  QVERIFY(!this->Bench->IsBusy());
  QCOMPARE(this->Bench->Data.State().Source.Path, before);
  QSignalSpy opened(this->Bench.get(), &Workbench::Opened);
  answer(5, true);
  QVERIFY(opened.wait(Patience));
  QCOMPARE(this->Bench->Data.Counted().Range[1], 59.0);
  QVERIFY(this->Bench->Data.Description().find("5 x 4 x 3") == 0);
}

void ExplorerTests::TheTableChangesSurfaces()
{
  auto* table = this->Window->findChild<QTableWidget*>("surfaces");
  QTRY_COMPARE_WITH_TIMEOUT(table->rowCount(), 1, Patience);
  const auto surface = [this] { return this->Bench->Data.Settings().Surfaces[0]; };
  table->item(0, 0)->setText("90");
  QCOMPARE(surface().Value, 90.0);
  table->item(0, 0)->setCheckState(Qt::Unchecked);
  QVERIFY(!surface().IsVisible);
  table->item(0, 2)->setText("40 %");
  QCOMPARE(surface().Opacity, 0.4);
  table->item(0, 2)->setText("nonsense");
  QCOMPARE(surface().Opacity, 0.4);
  this->Bench->Edit("surface", [](Look& look) { look.Surfaces.push_back(look.Surfaces[0]); });
  QTRY_COMPARE_WITH_TIMEOUT(table->rowCount(), 2, Patience);
}

void ExplorerTests::TheListChangesLabels()
{
  this->OpenLabels();
  auto* list = this->Window->findChild<QTableWidget*>("labels");
  QTRY_COMPARE_WITH_TIMEOUT(list->rowCount(), 3, Patience);
  QTRY_VERIFY_WITH_TIMEOUT(list->isVisible(), Patience);
  QVERIFY(!this->Window->findChild<QTableWidget*>("surfaces")->isVisible());
  QCOMPARE(list->item(2, 0)->text(), QString("30 heart"));
  const auto seen = [this]
  {
    std::string labels;
    for (const LabelLook& label : this->Bench->Data.Settings().Labels)
    {
      labels += label.IsVisible ? std::to_string(label.Label) + " " : "";
    }
    return labels;
  };
  const auto press = [this](const char* text)
  {
    for (QAbstractButton* button : this->Window->findChildren<QAbstractButton*>())
    {
      if (button->text() == text)
      {
        button->click();
      }
    }
  };
  list->item(0, 0)->setCheckState(Qt::Unchecked);
  QCOMPARE(seen(), std::string("2 30 "));
  list->item(2, 1)->setText("40 %");
  QCOMPARE(this->Bench->Data.Settings().Labels[2].Opacity, 0.4);
  list->selectRow(1);
  press("Solo");
  QCOMPARE(seen(), std::string("2 "));
  press("Solo");
  QCOMPARE(seen(), std::string("1 2 30 "));
  // What is found alone is hidden.
  auto* search = this->Window->findChild<QLineEdit*>("search labels");
  search->setText("HEART");
  QVERIFY(list->isRowHidden(0) && !list->isRowHidden(2));
  press("Hide");
  QCOMPARE(seen(), std::string("1 2 "));
  search->clear();
  press("Show");
  QCOMPARE(seen(), std::string("1 2 30 "));
  this->Bench->Changes.undo();
  QCOMPARE(seen(), std::string("1 2 "));
  // Data that are no labels show surfaces again.
  this->Bench->Turn(Row::Drawing, 1);
  QTRY_VERIFY_WITH_TIMEOUT(!list->isVisible(), Patience);
}

void ExplorerTests::PanelsShowTheModel()
{
  auto* palette = this->Window->findChild<QComboBox*>("palette");
  this->Bench->Turn(Row::Palette, 2);
  QTRY_COMPARE_WITH_TIMEOUT(palette->currentText(), QString("steel"), Patience);
  auto* isomap = this->Window->findChild<QAbstractButton*>("isomap");
  QTRY_VERIFY_WITH_TIMEOUT(isomap->isChecked(), Patience);
  isomap->click();
  QCOMPARE(this->Bench->Data.Settings().Values[Row::Isomap], 0.0);
  // A slider switches on what it is a part of.
  const Look& look = this->Bench->Data.Settings();
  const double before = look.Values[Row::Shading];
  QVERIFY(before > 0.0);
  this->Window->findChild<QSlider*>("ambient")->setValue(1000);
  QCOMPARE(look.Values[Row::Shading], 1.0);
  QCOMPARE(look.Values[Row::OwnShading], 1.0);
  this->Bench->Changes.undo();
  QCOMPARE(look.Values[Row::Shading], before);
  QCOMPARE(look.Values[Row::OwnShading], 0.0);
  // Each setting that has a name for people has its widget.
  for (const Setting& setting : AllSettings())
  {
    const QString name = setting.IsChoice() ? setting.Name : QString(setting.Label).toLower();
    QVERIFY2(name.isEmpty() || this->Window->findChild<QWidget*>(name), setting.Label);
  }
  // Meshes have normals of their own, and surfaces only.
  QVERIFY(!this->Window->findChild<QComboBox*>("gradients")->isVisibleTo(this->Window.get()));
}

void ExplorerTests::ClippingAndCropping()
{
  const auto whole = this->Bench->Data.View.Picture(Width, Height);
  this->Window->findChild<QAbstractButton*>("clipping")->click();
  QVERIFY(this->Bench->Data.Settings().Values[Row::Clipping] != 0.0);
  const auto clipped = this->Bench->Data.View.Picture(Width, Height);
  QVERIFY(!AreSame(whole, clipped));
  this->Window->findChild<QAbstractButton*>("clipping")->click();
  this->Bench->Edit("cropping",
    [](Look& look)
    {
      look.Values[Row::Cropping] = 1;
      SetNumbers(look, Row::Crop, { 15.5, 31.0, 0.0, 31.0, 0.0, 31.0 });
    });
  const auto cropped = this->Bench->Data.View.Picture(Width, Height);
  QVERIFY(!AreSame(whole, cropped));
  this->Bench->Changes.undo();
  QVERIFY(AreSame(whole, this->Bench->Data.View.Picture(Width, Height)));
}

// What is seen beside the volume is saved with it.
void ExplorerTests::PicturesHaveAnnotations()
{
  this->Bench->Turn(Row::Background, 1);
  const auto bare = this->Bench->Data.View.Picture(Width, Height);
  for (const Row::Which row : { Row::Outline, Row::Axes, Row::ScaleBar, Row::ColorBar })
  {
    this->Bench->Turn(row, 1);
    const auto picture = this->Bench->Data.View.Picture(Width, Height);
    QVERIFY2(!AreSame(bare, picture), AllSettings()[row].Name);
    // They hide no more than they are.
    int different = 0;
    for (int pixel = 0; pixel < Width * Height; ++pixel)
    {
      const int x = pixel % Width, y = pixel / Width;
      different += bare->GetScalarComponentAsDouble(x, y, 0, 0) !=
        picture->GetScalarComponentAsDouble(x, y, 0, 0);
    }
    QVERIFY2(different < Width * Height / 5, std::to_string(different).c_str());
    this->Bench->Turn(row, 1);
  }
  QVERIFY(AreSame(bare, this->Bench->Data.View.Picture(Width, Height)));
  // A background of one's own, or none.
  this->Bench->Turn(Row::Background, 1);
  const auto white = this->Bench->Data.View.Picture(Width, Height);
  QCOMPARE(white->GetScalarComponentAsDouble(0, 0, 0, 0), 255.0);
  const auto none = this->Bench->Data.View.Picture(
    Width, Height, [](double) { return true; }, false);
  QCOMPARE(none->GetNumberOfScalarComponents(), 4);
  QCOMPARE(none->GetScalarComponentAsDouble(0, 0, 0, 3), 0.0);
  int opaque = 0;
  for (int y = 0; y < Height; ++y)
  {
    for (int x = 0; x < Width; ++x)
    {
      if (none->GetScalarComponentAsDouble(x, y, 0, 3) == 255.0)
      {
        ++opaque;
        QCOMPARE(none->GetScalarComponentAsDouble(x, y, 0, 0),
          white->GetScalarComponentAsDouble(x, y, 0, 0));
      }
    }
  }
  QVERIFY(opaque > 100);
  // In a parallel projection, the middle of the view stays as large as it is.
  const CameraState perspective = this->Bench->Data.View.Camera();
  this->Bench->Turn(Row::Projection, 1);
  QVERIFY(!AreSame(white, this->Bench->Data.View.Picture(Width, Height)));
  this->Bench->Turn(Row::Projection, 1);
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    QVERIFY(
      std::abs(this->Bench->Data.View.Camera().Position[axis] - perspective.Position[axis]) < 1e-6);
  }
}

void ExplorerTests::ThePointerTellsWhatIsThere()
{
  QTRY_VERIFY_WITH_TIMEOUT(!this->Bench->IsBusy() && !this->Bench->IsRenderDue(), Patience);
  auto* label = this->Window->findChild<QLabel*>("under pointer");
  QWidget* view = this->Window->View();
  const auto pointAt = [&](const QPoint& place)
  {
    QMouseEvent event(QEvent::MouseMove, place, view->mapToGlobal(place), Qt::NoButton,
      Qt::NoButton, Qt::NoModifier);
    QApplication::sendEvent(view, &event);
  };
  const int* size = this->Bench->Data.View.Renderer->GetSize();
  QPoint hit;
  for (int i = 0; i < 400 && hit.isNull(); ++i)
  {
    const QPoint place(size[0] * (i % 20) / 20, size[1] * (i / 20) / 20);
    hit = this->Bench->Data.View.SeenAt(place.x(), place.y()) ? place : hit;
  }
  QVERIFY(!hit.isNull());
  // The pointer of the screen may move meanwhile: try again.
  const auto says = [&](const QPoint& place, const QString& begin)
  {
    for (int i = 0; i < 50; ++i)
    {
      pointAt(place);
      QTest::qWait(100);
      if (begin.isEmpty() ? label->text().isEmpty() : label->text().startsWith(begin))
      {
        return true;
      }
    }
    return false;
  };
  QVERIFY(says(QPoint(hit.x(), size[1] - 1 - hit.y()) / view->devicePixelRatioF(), "Surface "));
  QVERIFY(says(QPoint(1, 1), ""));
}

void ExplorerTests::MenusHaveTicks()
{
  const auto all = this->Window->findChildren<QMenu*>();
  const auto found = std::find_if(
    all.begin(), all.end(), [](const QMenu* menu) { return menu->title().startsWith("Material"); });
  QVERIFY(found != all.end());
  auto* settings = qobject_cast<QMenu*>((*found)->parentWidget());
  QVERIFY(settings);
  const auto ticked = [&]
  {
    emit settings->aboutToShow();
    std::string names;
    for (const QAction* item : (*found)->actions())
    {
      names += item->isChecked() ? item->text().toStdString() : "";
    }
    return names;
  };
  QCOMPARE(ticked(), std::string("satin"));
  (*found)->actions()[2]->trigger();
  QCOMPARE(ticked(), std::string("glossy"));
}

void ExplorerTests::DistancesAreMeasured()
{
  QTRY_VERIFY_WITH_TIMEOUT(!this->Bench->IsBusy() && !this->Bench->IsRenderDue(), Patience);
  VolumeView& view = this->Bench->Data.View;
  const int* size = view.Renderer->GetSize();
  std::vector<QPoint> hits;
  std::vector<Point> places;
  for (int i = 0; i < 400 && hits.size() < 2; ++i)
  {
    const QPoint place(size[0] * (i % 20) / 20, size[1] * (i / 20) / 20);
    if (const auto seen = view.SeenAt(place.x(), size[1] - 1 - place.y()))
    {
      hits.push_back(place);
      places.push_back(seen->Place);
    }
  }
  QCOMPARE(hits.size(), std::size_t{ 2 });
  QSignalSpy said(this->Bench.get(), &Workbench::Said);
  const auto bare = view.Picture(Width, Height);
  this->Bench->Render(); // what is pointed at is that of the last picture
  this->Bench->Measure(hits[0]);
  this->Bench->Measure(hits[1]);
  const double distance =
    std::sqrt(vtkMath::Distance2BetweenPoints(places[0].data(), places[1].data()));
  QCOMPARE(
    said.last()[0].toString(), QString("Distance: %1").arg(QString::number(distance, 'g', 5)));
  QVERIFY(!AreSame(bare, view.Picture(Width, Height)));
  this->Bench->Measure(hits[0]); // the ruler goes
  QVERIFY(AreSame(bare, view.Picture(Width, Height)));
  this->Bench->Render();
  this->Bench->Try([&] { this->Bench->Measure(QPoint(0, 0)); });
  QVERIFY(said.last()[1].toBool());
}

void ExplorerTests::ViewsAreRemembered()
{
  this->Window->TakeUpLast();
  Write(this->Directory.filePath("views.vtu"), TimeSeries());
  Session session;
  session.Source.Path = this->Directory.filePath("views.vtu").toStdString();
  this->Open(session);
  this->Bench->Data.View.Renderer->GetActiveCamera()->Roll(180.0);
  const CameraState left = this->Bench->Data.View.Camera();
  this->Open(SmallSession());
  this->Open(session);
  QVERIFY(left.ViewUp == this->Bench->Data.View.Camera().ViewUp);
  // A session tells its own view.
  session.HasCamera = true;
  session.Camera = left;
  session.Camera.ViewAngle = 20.0;
  this->Open(session);
  QCOMPARE(this->Bench->Data.View.Camera().ViewAngle, 20.0);
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
    QVERIFY2(this->Window->minimumSizeHint().height() <= 500, "too high for a small screen");
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
  this->Bench->OpenPath(this->Directory.filePath(name));
  QVERIFY(opened.wait(Patience));
  QVERIFY(this->Window->windowTitle().startsWith(name));
  QVERIFY(this->Window->findChild<QLabel*>("sentence")->text().startsWith(QChar(0x200e) + name));
}
