// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Makes the pictures of Documentation/Gallery.md that are not figures of the paper, and their
// tables. Windows are drawn in, and need a display, such as xvfb-run -a gives.

#include "CommandLine.h"
#include "Display.h"
#include "FeaturePictures.h"
#include "Measuring.h"
#include "Report.h"
#include "RouteRows.h"
#include "Studio.h"

namespace
{

constexpr int QuickSize = 256;
constexpr int QuickFrames = 3;

void MakeGallery(GallerySettings& settings)
{
  if (settings.Output.empty())
  {
    throw Measuring::Failure("Give --output and a folder for the pictures.");
  }
  RequireDisplay();
  RequireFolder(settings.Output);
  JsonWriter json;
  AddMachine(json, settings.Size);
  json.Add("windowsBy", Studio(settings.Size).DrawnBy());
  if (IsWanted("routes", settings))
  {
    RouteRows::Make(settings, json);
  }
  FeaturePictures::Make(settings, json);
  PrintReplaced(settings);
  json.Write(settings.Output + "/gallery.json");
}

std::vector<CommandLine::Choice> PictureChoices()
{
  std::vector<CommandLine::Choice> choices = { { "routes", "a picture of every route" } };
  for (const std::string& name : FeaturePictures::Names())
  {
    choices.push_back({ name, "" });
  }
  return choices;
}

}

int main(int argc, char* argv[])
{
  GallerySettings settings;
  CommandLine options("GalleryPictures",
    "Draw every route and every feature, as pictures (PNG) and tables (Markdown).");
  options.Text("--output", "folder for pictures and gallery.json", settings.Output);
  options.Number("--size", "pixels of what is drawn in each direction (1024)", settings.Size);
  options.Number("--frames", "frames of which a time is the median (15)", settings.Frames);
  options.Choices("--only", "these pictures (all)", "picture", PictureChoices(), settings.Only);
  options.Flag("--quick", "small pictures of generated volumes, few frames", settings.IsQuick);
  return options.Run(argc, argv,
    [&]
    {
      if (settings.IsQuick)
      {
        settings.Size = QuickSize;
        settings.Frames = QuickFrames;
      }
      MakeGallery(settings);
      return true;
    });
}
