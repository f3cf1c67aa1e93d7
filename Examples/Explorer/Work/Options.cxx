// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Work/Options.h"

#include "Model/Choices.h"
#include "Model/Session.h"
#include "Work/Actions.h"

#include <sstream>
#include <vector>

Options ParseOptions(int argc, char* argv[])
{
  using Text = const std::string&;
  Options options;
  options.Width = 1280;
  options.Height = 800;
  CommandLine line(options);
  line.AddSetting("--session",
    [&options](Text, Text value)
    {
      options.SessionFile = value;
      options.StartsWithSession = true;
    });
  line.AddSetting("--output", [&options](Text, Text value) { options.OutputDirectory = value; });
  line.AddSetting("--log", [&options](Text, Text value) { options.Log = value; });
  line.AddSetting("--screenshot", [&options](Text, Text value) { options.Screenshot = value; });
  line.AddSetting("--measure-drag",
    [&options](Text name, Text value) { options.MeasuredDrag = ParseCount(name, value, 100000); });
  line.Parse({ argv + 1, argv + argc });
  if (IsSessionName(options.Source.Path))
  {
    options.SessionFile = options.Source.Path;
    options.StartsWithSession = true;
    options.Source.Path.clear();
  }
  return options;
}

std::string HelpText()
{
  std::ostringstream text;
  text
    << R"(Look at isosurfaces of a volume in a window: turn it, drag the isovalue, change colour and light.

usage: Explorer [VOLUME [ISOVALUE] | FILE.session] [OPTIONS]

VOLUME is an image (.vti .vtk .mhd .mha .nii .nii.gz .slc), a grid (.vtu .vts .vtr .vtm .vth .vtk and
the parallel .pvtu .pvts .pvtr; Exodus .ex2 .exo .e, .cgns and PLOT3D .xyz, xyz.bin where VTK reads
them), a directory with a series of DICOM files, or, with --raw, a file of bare samples. Without
VOLUME four spheres are generated.
ISOVALUE is chosen from the volume's histogram if it is not given.

  --session FILE         begin with a session that was saved; save there; default to save:
                         ./explorer.session
  --output DIR           where pictures and recordings go; default: the present directory
  --size WxH | N         pixels of the window; default 1280x800
)" << CommonOptionsHelp
    << R"(  --screenshot FILE      draw the window once, save it as FILE (PNG), and end
  --measure-drag N       drag the isovalue in N steps, print what a frame took beside showing any
                         picture of the window's size, and end
  --log FILE             a line for each frame and message, for scripts
  --help                 show this text

Keys:
)";
  for (const Gesture& gesture : AllGestures())
  {
    text << "  " << gesture.Keys << ": " << gesture.Help << '\n';
  }
  for (const Action& action : AllActions())
  {
    text << (action.Keys[0] ? "  " : "") << action.Keys << (action.Keys[0] ? "  " : "")
         << (action.Keys[0] ? action.Help : "") << (action.Keys[0] ? "\n" : "");
  }
  for (const Choice& choice : AllChoices())
  {
    text << "  " << choice.Key << "  " << choice.Help;
    const char* separator = " (";
    for (const char* value : choice.Values)
    {
      text << separator << value;
      separator = ", ";
    }
    text << ")\n";
  }
  return text.str();
}
