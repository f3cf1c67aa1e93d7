// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
// A viewer of isosurfaces and blended volumes: see --help.
#include "Program/Quoted.h"
#include "Program/UserError.h"
#include "View/Picture.h"
#include "Window/Dialogs.h"
#include "Window/Display.h"
#include "Window/DragMeasurement.h"
#include "Window/MainWindow.h"

#include <QApplication>
#include <QSettings>
#include <QSurfaceFormat>
#include <QTimer>
#include <QVTKOpenGLNativeWidget.h>

#include <cstdio>
#include <exception>

namespace
{

Session FirstSession(const Options& options)
{
  Session session;
  if (options.StartsWithSession)
  {
    session = ReadSession(options.SessionFile);
  }
  else
  {
    session.Source = options.Source;
  }
  session.Isovalue = options.Isovalue ? options.Isovalue : session.Isovalue;
  if (options.ThresholdMode)
  {
    session.Settings.Choices[Choose::Surface] = vtkTemporalCoherenceVolumeMapper::THRESHOLD;
  }
  return session;
}

// Once something is shown: what is asked for on the command line.
void Finish(MainWindow& window, Workbench& bench)
{
  const Options& options = bench.Chosen;
  bench.Render();
  if (!options.Screenshot.empty())
  {
    WritePng(PictureOf(&window), options.Screenshot, "name another file with --screenshot");
    std::printf("Screenshot: %s\n", Printable(options.Screenshot).c_str());
    window.close();
  }
  else if (options.MeasuredDrag > 0)
  {
    MeasureDrag(window, bench, options.MeasuredDrag);
    window.close();
  }
}

// Mistakes of the command line end the program.
void Run(const Options& options, int argc, char* argv[])
{
  const Session session = FirstSession(options);
  CheckDisplay();
  QSurfaceFormat format = QVTKOpenGLNativeWidget::defaultFormat();
  format.setSamples(0);
  QSurfaceFormat::setDefaultFormat(format);
#if QT_VERSION < QT_VERSION_CHECK(6, 0, 0)
  QApplication::setAttribute(Qt::AA_EnableHighDpiScaling);
  QApplication::setAttribute(Qt::AA_UseHighDpiPixmaps);
  QApplication::setHighDpiScaleFactorRoundingPolicy(
    Qt::HighDpiScaleFactorRoundingPolicy::PassThrough);
#endif
  QApplication application(argc, argv);
  QApplication::setOrganizationName("vtkTemporalCoherence");
  QApplication::setApplicationName("Explorer");
  Workbench bench(options);
  MainWindow window(bench);
  window.resize(QSize(options.Width, options.Height) / window.devicePixelRatioF());
  std::exception_ptr failure;
  const auto end = [&failure](const std::string& sentence)
  {
    failure = std::make_exception_ptr(UserError(sentence));
    QApplication::exit(1);
  };
  QMetaObject::Connection first;
  first = QObject::connect(&bench, &Workbench::Opened, &window,
    [&]
    {
      QObject::disconnect(first);
      QTimer::singleShot(0, &window,
        [&]
        {
          try
          {
            Finish(window, bench);
          }
          catch (const std::exception& mistake)
          {
            end(SentenceOf(mistake));
          }
        });
    });
  bench.OpenFirst(session, end);
  window.show();
  window.activateWindow();
  QApplication::exec();
  if (failure)
  {
    std::rethrow_exception(failure);
  }
}

}

int main(int argc, char* argv[])
{
  return RunProgram("Explorer",
    [&]
    {
      const Options options = ParseOptions(argc, argv);
      if (options.Help)
      {
        std::fputs(HelpText().c_str(), stdout);
        return;
      }
      Run(options, argc, argv);
    });
}
