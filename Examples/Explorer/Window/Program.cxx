// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Window/Program.h"

#include "Files/Trial.h"
#include "Program/Quoted.h"
#include "Program/UserError.h"
#include "Window/Commands.h"
#include "Window/MainWindow.h"

#include <QApplication>
#include <QSurfaceFormat>
#include <QVTKOpenGLNativeWidget.h>

#include <cstdio>
#include <cstdlib>
#include <utility>

#ifdef EXPLORER_HAS_X11
#include <X11/Xlib.h>
#endif

namespace
{

const QSize FirstSize(1280, 800); // pixels, of the window

struct Options : CommonOptions
{
  std::string Session; // to begin with
  std::string Output = ".";
  std::string Screenshot; // draw the window once, into this file
};

Options ParseOptions(int argc, char* argv[], const Extension& extension)
{
  using Text = const std::string&;
  Options options;
  options.Width = options.Height = 0; // as it was last
  CommandLine line(options);
  line.AddSetting("--session", [&options](Text, Text value) { options.Session = value; });
  line.AddSetting("--output", [&options](Text, Text value) { options.Output = value; });
  line.AddSetting("--screenshot", [&options](Text, Text value) { options.Screenshot = value; });
  extension.AddOptions(line);
  line.Parse({ argv + 1, argv + argc });
  if (IsSessionName(options.Source.Path))
  {
    options.Session = std::exchange(options.Source.Path, "");
  }
  return options;
}

void PrintHelp()
{
  std::printf(
    R"(Look at isosurfaces of a volume in a window: turn it, drag the isovalue, change colour and light.

usage: Explorer [VOLUME [ISOVALUE] | FILE.session] [OPTIONS]

%s
  --session FILE         begin with a session that was saved; save there; default to save:
                         ./explorer.session
  --output DIR           where pictures and recordings go; default: the present directory
  --size WxH | N         pixels of the window; default: as large as it was last
%s  --screenshot FILE      draw the window once, save it as FILE (PNG), and end
  --help                 show this text

Keys:
)",
    VolumeHelp, CommonOptionsHelp);
  for (const auto& [keys, help] : AllKeys())
  {
    std::printf("  %s  %s\n", keys.c_str(), help.c_str());
  }
}

Session FirstSession(const Options& options)
{
  Session session;
  session.Source = options.Source;
  session.MaySuitFile = !options.Isovalue && !options.ThresholdMode;
  session = options.Session.empty() ? session : ReadSession(options.Session);
  session.Isovalue = options.Isovalue ? options.Isovalue : session.Isovalue;
  if (options.ThresholdMode)
  {
    session.Settings.Values[Row::Surface] = vtkTemporalCoherenceVolumeMapper::THRESHOLD;
  }
  return session;
}

// Mistakes of the command line end the program.
void Run(const Options& options, int argc, char* argv[], const Extension& extension)
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
  Workbench bench(options.Output, options.Session.empty() ? "explorer.session" : options.Session,
    options.From, options.Up);
  MainWindow window(bench);
  const bool hasSize = options.Width > 0;
  window.resize(
    (hasSize ? QSize(options.Width, options.Height) : FirstSize) / window.devicePixelRatioF());
  if (!hasSize && options.Screenshot.empty() && options.From.empty())
  {
    window.TakeUpLast();
  }
  extension.Begin(window, bench);
  std::string failure;
  bench.OnRefused = [&failure](const std::string& sentence)
  {
    failure = sentence;
    QApplication::quit();
  };
  const auto finish = [&]
  {
    bench.Render();
    if (!options.Screenshot.empty())
    {
      bench.Refiner->Refine();
      SaveWindow(window, options.Screenshot);
      std::printf("Screenshot: %s\n", Printable(options.Screenshot).c_str());
      window.close();
    }
    else
    {
      extension.First(window, bench);
    }
  };
  QMetaObject::Connection first;
  first = QObject::connect(
    &bench, &Workbench::Opened, &window,
    [&]
    {
      QObject::disconnect(first);
      bench.Try(finish);
      bench.OnRefused = nullptr;
    },
    Qt::QueuedConnection);
  bench.Open(session);
  window.show();
  window.activateWindow();
  QApplication::exec();
  if (!failure.empty())
  {
    throw UserError(failure);
  }
}

}

int RunExplorer(int argc, char* argv[], const Extension& extension)
{
  BeginTrials();
  return RunProgram("Explorer",
    [&]
    {
      const Options options = ParseOptions(argc, argv, extension);
      options.Help ? PrintHelp() : Run(options, argc, argv, extension);
    });
}

void CheckDisplay()
{
#if !defined(_WIN32) && !defined(__APPLE__)
  if (std::getenv("WAYLAND_DISPLAY") || std::getenv("QT_QPA_PLATFORM"))
  {
    return; // whoever chooses another way knows it
  }
  const char* name = std::getenv("DISPLAY");
  std::string problem = name && *name ? "" : "DISPLAY is not set";
#ifdef EXPLORER_HAS_X11
  Display* display = problem.empty() ? XOpenDisplay(name) : nullptr;
  if (display)
  {
    XCloseDisplay(display);
  }
  else if (problem.empty())
  {
    problem = Quoted(name) + " (DISPLAY) cannot be opened";
  }
#endif
  if (!problem.empty())
  {
    throw UserError("A window needs a display, but " + problem +
      "; log in with ssh -X or run under xvfb-run, or make pictures with Examples/OrbitAndSweep, "
      "which needs none.");
  }
#endif
}
