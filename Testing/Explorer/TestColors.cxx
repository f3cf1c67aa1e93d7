// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// The Explorer colours surfaces by another array, of points or cells, and tells it in the colour
// bar. The choice can be undone, is kept in sessions, and stays as long as the data have the array.

#include "ExplorerTests.h"

#include "Files/ColorArrays.h"

#include <QComboBox>

#include <array>
#include <functional>

namespace
{

constexpr int Edge = 12; // points along an axis

using Values = std::function<std::string(int x, int y, int z)>;

std::string ArrayText(int edge, const Values& values)
{
  std::string text;
  for (int i = 0; i < edge * edge * edge; ++i)
  {
    text += values(i % edge, i / edge % edge, i / edge / edge) + "\n";
  }
  return text;
}

// Points have a distance from the middle and, if it is whole, the numbers x and y and a vector.
std::string TextOfArrays(bool isWhole)
{
  const std::string scalars = " float\nLOOKUP_TABLE default\n";
  const auto number = [](int value) { return std::to_string(value); };
  const auto distance = [&](int x, int y, int z)
  {
    return number(
      (2 * x - 11) * (2 * x - 11) + (2 * y - 11) * (2 * y - 11) + (2 * z - 11) * (2 * z - 11));
  };
  std::string text = "# vtk DataFile Version 3.0\nballs\nASCII\nDATASET STRUCTURED_POINTS\n"
                     "DIMENSIONS 12 12 12\nORIGIN 0 0 0\nSPACING 1 1 1\nPOINT_DATA 1728\n"
                     "SCALARS distance" +
    scalars + ArrayText(Edge, distance);
  if (isWhole)
  {
    text += "SCALARS x" + scalars + ArrayText(Edge, [&](int x, int, int) { return number(x); });
    text += "VECTORS way float\n" +
      ArrayText(Edge, [&](int x, int, int z) { return number(x) + " 7 " + number(z); });
    text += "CELL_DATA 1331\nSCALARS cell" + scalars +
      ArrayText(Edge - 1, [&](int, int, int z) { return number(z); });
  }
  return text;
}

Session SessionOf(const QString& path)
{
  Session session;
  session.Source.Path = path.toStdString();
  session.Isovalue = 60.0;
  session.Settings.Values[Row::Occlusion] = 0;
  session.Settings.Values[Row::Material] = 3; // flat: nothing but colours is seen
  return session;
}

void Choose(QComboBox* box, int index)
{
  box->setCurrentIndex(index);
  emit box->activated(index);
}

// How much more red than blue there is in the left and in the right half of a picture, beside the
// background.
std::array<double, 2> RedOfHalves(vtkImageData* picture)
{
  const auto redOf = [picture](int x, int y)
  {
    return picture->GetScalarComponentAsDouble(x, y, 0, 0) -
      picture->GetScalarComponentAsDouble(x, y, 0, 2);
  };
  std::array<double, 2> red = {};
  for (int y = 0; y < Height; ++y)
  {
    for (int x = 0; x < Width; ++x)
    {
      red[x < Width / 2 ? 0 : 1] += redOf(x, y) - redOf(0, 0);
    }
  }
  return red;
}

}

void ExplorerTests::ArraysColorSurfaces()
{
  const QString path = this->Directory.filePath("arrays.vtk");
  Write(path, TextOfArrays(true));
  auto* arrays = this->Window->findChild<QComboBox*>("color-by");
  auto* components = this->Window->findChild<QComboBox*>("color-by-component");
  QVERIFY(!arrays->isVisibleTo(this->Window.get())); // spheres have one array
  this->Open(SessionOf(path));
  Model& model = this->Bench->Data;
  QTRY_VERIFY_WITH_TIMEOUT(arrays->isVisibleTo(this->Window.get()), Patience);
  QCOMPARE(arrays->count(), 5);
  QCOMPARE(arrays->currentIndex(), 0);
  const auto plain = model.View.Picture(Width, Height);

  Choose(arrays, 2);
  QCOMPARE(model.Settings().ColorBy.Name, std::string("x"));
  const auto byX = model.View.Picture(Width, Height);
  const std::array<double, 2> red = RedOfHalves(byX);
  QVERIFY2(red[0] < -1e4 && red[1] > 1e4, std::to_string(red[0]).c_str());
  QVERIFY(!components->isVisibleTo(this->Window.get()));
  this->Bench->Turn(Row::ColorMap, -1);
  QVERIFY(!AreSame(byX, model.View.Picture(Width, Height)));
  this->Bench->Changes.undo();
  QVERIFY(AreSame(byX, model.View.Picture(Width, Height)));
  this->Bench->Changes.undo();
  QVERIFY(AreSame(plain, model.View.Picture(Width, Height)));
  QTRY_COMPARE_WITH_TIMEOUT(arrays->currentIndex(), 0, Patience);

  // The first component of the vectors is x; the second is the same everywhere.
  Choose(arrays, 3);
  QCOMPARE(model.Settings().ColorBy.Component, -1);
  QTRY_VERIFY_WITH_TIMEOUT(components->isVisibleTo(this->Window.get()), Patience);
  Choose(components, 1);
  QVERIFY(AreSame(byX, model.View.Picture(Width, Height)));
  Choose(components, 2);
  QVERIFY(!AreSame(byX, model.View.Picture(Width, Height)));
  Choose(arrays, 4);
  QVERIFY(model.View.Mapper->GetColorArrayOnCells() != 0);
  QVERIFY(!AreSame(byX, model.View.Picture(Width, Height)));
  // Blended volumes have colours of their own.
  const auto blended = [&](const ArrayColor& color)
  {
    Look look = model.Settings();
    look.ColorBy = color;
    model.SetChoice(look, Row::Drawing, Drawing::Composite);
    model.SetSettings(look);
    return model.View.Picture(Width, Height);
  };
  QVERIFY(AreSame(blended({ "x", 0 }), blended({})));
}

void ExplorerTests::ArrayColorsAreKept()
{
  const QString whole = this->Directory.filePath("arrays.vtk");
  const QString part = this->Directory.filePath("one-array.vtk");
  const std::string kept = this->Directory.filePath("colors.session").toStdString();
  Write(whole, TextOfArrays(true));
  Write(part, TextOfArrays(false));
  Session session = SessionOf(whole);
  session.Settings.ColorBy = { "way", 2 };
  session.Settings.Values[Row::ColorBar] = 1;
  this->Open(session);
  Model& model = this->Bench->Data;
  QCOMPARE(model.View.Colors.Key().Title, std::string("way 3"));
  const auto picture = model.View.Picture(Width, Height);
  model.Save(kept);
  QVERIFY(TextOf(QString::fromStdString(kept)).find("color-by = way\n") != std::string::npos);
  this->Open(ReadSession(kept));
  QVERIFY(AreSame(picture, model.View.Picture(Width, Height)));
  // The bar has the table of the array.
  Look look = model.Settings();
  look.ColorBy = {};
  model.SetSettings(look);
  QVERIFY(!model.View.Colors.Key().Colors && model.View.Colors.Key().Title.empty());

  // It stays as the drawn array changes, and goes with data that have it not.
  this->Open(session);
  QSignalSpy said(this->Bench.get(), &Workbench::Said);
  QSignalSpy opened(this->Bench.get(), &Workbench::Opened);
  this->Bench->Ask([&] { return model.OtherArray("x", 0); });
  QTRY_COMPARE_WITH_TIMEOUT(opened.count(), 1, Patience);
  QCOMPARE(model.Settings().ColorBy.Name, std::string("way"));
  QCOMPARE(model.Settings().ColorBy.Component, 2);
  session.Source.Path = part.toStdString();
  this->Open(session);
  QVERIFY(model.Settings().ColorBy.Name.empty() && !model.ColorsByArray());
  model.View.Picture(Width, Height);
  for (const auto& sentence : said)
  {
    QVERIFY2(!sentence[1].toBool(), sentence[0].toString().toUtf8());
  }
}

// Of all values; also those of one number, or of none that is finite.
void ExplorerTests::RangesOfArraysAreWide()
{
  const QString path = this->Directory.filePath("arrays.vtk");
  Write(path, TextOfArrays(true));
  this->Open(SessionOf(path));
  ColorArrays arrays = this->Bench->Data.View.Colors.Arrays();
  QCOMPARE(arrays.All().size(), std::size_t(4));
  QVERIFY(arrays.Range("x", 0) == (std::array<double, 2>{ 0.0, 11.0 }));
  QVERIFY(arrays.Range("way", 1) == (std::array<double, 2>{ 3.5, 10.5 }));
  QVERIFY(arrays.Range("cell", 0) == (std::array<double, 2>{ 0.0, 10.0 }));
  QVERIFY(arrays.Has("way", -1) && arrays.Has("way", 2) && !arrays.Has("way", 3));
  QVERIFY(!arrays.Has("", 0) && !arrays.Find("other"));
}
