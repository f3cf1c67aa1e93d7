// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Work/Actions.h"

const std::vector<Action>& AllActions()
{
  static const std::vector<Action> actions = {
    { Do::Open, "&File", "&Open...", "O; Ctrl+O", "open a volume or a session" },
    { Do::OpenFolder, "&File", "Open DICOM &Folder...", "Ctrl+Shift+O",
      "open a folder with a series of DICOM files" },
    { Do::SaveSession, "&File", "&Save Session", "W; Ctrl+S", "save the session" },
    { Do::SaveSessionAs, "&File", "Save Session &As...", "Ctrl+Shift+S",
      "save the session as another file" },
    { Do::Restore, "&File", "Restore Session", "Z", "restore the saved session" },
    { Do::Picture, "&File", "Save &Picture", "S", "save a picture (PNG)" },
    { Do::PictureAs, "&File", "Save Picture As...", "Ctrl+P",
      "save a picture of any size and name" },
    { Do::WindowPicture, "&File", "Save Picture of &Window", "Shift+S",
      "save a picture of the window, panels and all" },
    { Do::Record, "&File", "&Record", "R", "begin and end a recording of every frame" },
    { Do::Film, "&File", "&Film...", "Ctrl+F", "make a film of a turn, or of all isovalues" },
    { Do::Quit, "&File", "&Quit", "Q; Ctrl+Q", "end" },
    { Do::Undo, "&Edit", "&Undo", "Ctrl+Z", "undo the last change of settings" },
    { Do::Redo, "&Edit", "&Redo", "Ctrl+Shift+Z; Ctrl+Y", "do again what was undone" },
    { Do::AddSurface, "&Edit", "&Add Surface", "Ctrl+N; +", "add another surface" },
    { Do::RemoveSurface, "&Edit", "&Remove Surface", "Ctrl+D; -", "remove the selected surface" },
    { Do::Clip, "&Edit", "&Clip by a Plane", "T", "cut by a plane that is dragged in the view" },
    { Do::Crop, "&Edit", "C&rop to a Box", "E", "crop to a box whose sides are dragged" },
    { Do::ResetView, "&View", "&Reset", "H", "see all of the volume" },
    { Do::UpsideDown, "&View", "&Upside Down", "U", "turn the picture by half a turn" },
    { Do::FullScreen, "&View", "&Full Screen", "F11", "fill the screen, and back" },
    { Do::BuildIsomap, "&Data", "&Build Isomap", "B",
      "build the isomap of this view, for all isovalues" },
    { Do::NextArray, "&Data", "&Next Array", "N", "the next array of the file" },
    { Do::EarlierStep, "&Data", "&Earlier Time Step", ",", "the time step before" },
    { Do::LaterStep, "&Data", "&Later Time Step", ".", "the next time step" },
    { Do::Play, "&Data", "&Play", "Space", "play time steps, and pause" },
    { Do::Stop, "&Data", "&Stop", "Esc", "stop what takes long; leave the full screen" },
    { Do::Keys, "&Help", "&Keys", "?; F1", "show or hide all keys" },
  };
  return actions;
}

const std::vector<Gesture>& AllGestures()
{
  static const std::vector<Gesture> gestures = {
    { "left drag", "turn; with Shift: move" },
    { "wheel, right drag", "nearer and farther" },
    { "drag in histogram", "the isovalue of the selected surface, or a node of the opacity" },
    { "Left, Right", "isovalue by 1/256 of the range; Shift: by 10/256" },
    { "Page Up, Page Down", "in the histogram: the marker or node before, the next one" },
    { "double click, Delete", "in the histogram: add or remove a node of the opacity" },
    { "Shift + key", "of a setting: the value before" },
    { "drop a file", "open it" },
  };
  return gestures;
}
