// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ExplorerTests.h"

#include "Program/UserError.h"
#include "Window/Program.h"

#include <QFile>
#include <QSettings>
#include <QSurfaceFormat>
#include <QVTKOpenGLNativeWidget.h>

#include <cstdio>
#include <cstring>

Session SmallSession()
{
  Session session;
  session.Source.Spheres = Spheres;
  // Frames that follow one another of themselves are a test of their own.
  session.Settings.Values[Row::Occlusion] = 0;
  return session;
}

void SetNumbers(Look& look, Row::Which first, const std::vector<double>& values)
{
  std::copy(values.begin(), values.end(), &look.Values[first]);
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

void ExplorerTests::initTestCase()
{
  QVERIFY(this->Directory.isValid());
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, this->Directory.path());
}

void ExplorerTests::init()
{
  this->Bench = std::make_unique<Workbench>(this->Directory.path().toStdString());
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
