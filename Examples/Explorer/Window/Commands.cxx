// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Window/Commands.h"

#include "Work/Workbench.h"

#include <vtkCamera.h>

#include <QAbstractButton>
#include <QAction>
#include <QCursor>
#include <QDockWidget>
#include <QFile>
#include <QMainWindow>

namespace
{

void Stop(QMainWindow& window, Workbench& bench)
{
  bench.Cancel();
  window.setWindowState(window.windowState() & ~Qt::WindowFullScreen);
}

void ForgetColor(QMainWindow&, Workbench& bench)
{
  bench.BeginGesture();
  bench.EditMarker(QObject::tr("colour"), [](Marker& marker) { marker.Color.reset(); });
}

void ResetView(QMainWindow&, Workbench& bench)
{
  bench.Data.ResetView();
  bench.RenderSoon();
}

void TurnUpsideDown(QMainWindow&, Workbench& bench)
{
  bench.Data.View.Renderer->GetActiveCamera()->Roll(180.0);
  bench.RenderSoon();
}

// From the first place to the second; a third time, there is no ruler any more.
void Measure(QMainWindow& window, Workbench& bench)
{
  bench.Measure(
    window.findChild<QWidget*>("view")->mapFromGlobal(QCursor::pos()) * window.devicePixelRatioF());
}

void SavePictureOfWindow(QMainWindow& window, Workbench& bench)
{
  const std::string path = bench.Output.NextPath();
  SaveWindow(window, path);
  bench.Say("Saved " + path);
}

void ShowKeys(QMainWindow& window, Workbench&)
{
  window.findChild<QDockWidget*>("Keys")->toggleViewAction()->trigger();
}

void Step(Workbench& bench, int steps)
{
  bench.Ask([&] { return bench.Data.OtherTimeStep(bench.Data.State().Source.TimeStep + steps); });
}

}

const std::vector<Command>& AllCommands()
{
  using Need = Command::Need;
  using W = QMainWindow;
  using B = Workbench;
  static const std::vector<Command> commands = {
    { "&File", "&Open...", "O; Ctrl+O", "open a volume or a session", Need::Nothing, AskOpen },
    { "&File", "Open &Folder...", "Ctrl+Shift+O",
      "open a folder with a series of DICOM files, of pictures, or of OME-Zarr", Need::Nothing,
      AskOpenFolder },
    { "&File", "&Save Session", "W; Ctrl+S", "save the session", Need::Data,
      [](W&, B& bench) { bench.SaveSession(bench.SessionFile); } },
    { "&File", "Save Session &As...", "Ctrl+Shift+S", "save the session as another file",
      Need::Data, AskSaveSession },
    { "&File", "Restore Session", "Z", "restore the saved session", Need::Nothing,
      [](W&, B& bench) { bench.OpenPath(QFile::decodeName(bench.SessionFile.c_str())); } },
    { "&File", "Save &Picture", "S", "save a picture (PNG)", Need::Data,
      [](W&, B& bench) { bench.SavePicture(); } },
    { "&File", "Save Picture As...", "Ctrl+P", "save a picture of any size and name", Need::Data,
      AskPicture },
    { "&File", "Save Picture of &Window", "Shift+S", "save a picture of the window, panels and all",
      Need::Nothing, SavePictureOfWindow },
    { "&File", "E&xport Triangles...", "Ctrl+E",
      "write the surfaces that are seen as triangles: .stl, .ply or .vtp", Need::Surfaces,
      AskTriangles },
    { "&File", "S&hare as Web Page...", "Ctrl+Shift+P",
      "write this view for all isovalues: a page for browsers that needs no volume", Need::Surfaces,
      AskSharing },
    { "&File", "&Record", "R", "begin and end a recording of every frame", Need::Data,
      [](W&, B& bench) { bench.ToggleRecording(); } },
    { "&File", "&Film...", "Ctrl+F", "make a film of a turn, or of all isovalues", Need::Data,
      AskFilm },
    { "&File", "&Quit", "Q; Ctrl+Q", "end", Need::Nothing, [](W& window, B&) { window.close(); } },
    { "&Edit", "&Undo", "Ctrl+Z", "undo the last change of settings", Need::Undo, nullptr },
    { "&Edit", "&Redo", "Ctrl+Shift+Z; Ctrl+Y", "do again what was undone", Need::Redo, nullptr },
    { "&Edit", "&Add Surface", "Ctrl+N; +", "add another surface, or node of the opacity",
      Need::Addable, [](W&, B& bench) { bench.AddMarker(); } },
    { "&Edit", "&Remove Surface", "Ctrl+D; -", "remove the selected surface, or node",
      Need::Removable, [](W&, B& bench) { bench.RemoveMarker(); } },
    { "&Edit", "&Colour...", "", "colour of the selected surface, or node", Need::Data, AskColor },
    { "&Edit", "Colour of &Palette", "", "the colour that the palette has for its value",
      Need::Data, ForgetColor },
    { "&View", "&Reset", "H", "see all of the volume", Need::Data, ResetView },
    { "&View", "&Upside Down", "U", "turn the picture by half a turn", Need::Data, TurnUpsideDown },
    { "&View", "&Measure Distance", "Ctrl+M",
      "measure a distance: from where the pointer is, then to where it is", Need::Data, Measure },
    { "&View", "&Full Screen", "F11", "fill the screen, and back", Need::Nothing,
      [](W& window, B&) { window.setWindowState(window.windowState() ^ Qt::WindowFullScreen); } },
    { "&Data", "&Build Isomap", "B", "build the isomap of this view, for all isovalues", Need::Data,
      [](W&, B& bench) { bench.BuildIsomap(); } },
    { "&Data", "&Next Array", "N", "the next array of the file", Need::Nothing,
      [](W&, B& bench) { bench.Ask([&] { return bench.Data.NextArrayOfFile(); }); } },
    { "&Data", "&Label Names...", "",
      "names and colours of labels from a file: of ITK-SNAP, Slicer, or JSON", Need::Labels,
      AskLabelNames },
    { "&Data", "&Earlier Time Step", ",", "the time step before", Need::Nothing,
      [](W&, B& bench) { Step(bench, -1); } },
    { "&Data", "&Later Time Step", ".", "the next time step", Need::Nothing,
      [](W&, B& bench) { Step(bench, 1); } },
    { "&Data", "&Play", "Space", "play time steps, and pause", Need::Steps,
      [](W& window, B&) { window.findChild<QAbstractButton*>("play")->click(); } },
    { "&Data", "&Stop", "Esc", "stop what takes long; leave the full screen", Need::Nothing, Stop },
    { "&Help", "&Keys", "?; F1", "show or hide all keys", Need::Nothing, ShowKeys },
  };
  return commands;
}

std::vector<std::pair<std::string, std::string>> AllKeys()
{
  std::vector<std::pair<std::string, std::string>> keys = {
    { "left drag", "turn; with Shift: move" },
    { "wheel, right drag", "nearer and farther" },
    { "drag in histogram", "the isovalue of the selected surface, or a node of the opacity" },
    { "Left, Right", "isovalue by 1/256 of the range; Shift: by 10/256" },
    { "Page Up, Page Down", "in the histogram: the marker before, the next one" },
    { "Insert, Delete", "in the histogram: add or remove a marker" },
    { "right click", "in the histogram and on its table: the colour of a marker" },
    { "Shift + key", "of a setting: the value before" },
    { "drop a file", "open it" },
  };
  for (const Command& command : AllCommands())
  {
    if (command.Keys[0])
    {
      keys.emplace_back(command.Keys, command.Help);
    }
  }
  for (const Setting& setting : AllSettings())
  {
    std::string values;
    for (const char* value : setting.Words)
    {
      values += (values.empty() ? " (" : ", ") + std::string(value);
    }
    if (setting.Key)
    {
      keys.emplace_back(std::string(1, setting.Key), setting.Help + values + ")");
    }
  }
  return keys;
}
