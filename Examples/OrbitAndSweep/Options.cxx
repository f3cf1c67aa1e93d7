// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Options.h"

#include <algorithm>
#include <vector>

namespace
{

void MakeQuick(Options& options)
{
  options.Width = 256;
  options.Height = 192;
  options.OrbitFrames = 4;
  options.SweepFrames = 4;
  options.ColorFrames = 2;
  options.RepeatFrames = 2;
  options.FramesWithoutReuse = 2;
}

}

Options ParseOptions(int argc, char* argv[])
{
  using Text = const std::string&;
  Options options;
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  // First, wherever it stands: what it sets, other options may set again.
  if (std::count(arguments.begin(), arguments.end(), "--quick") > 0)
  {
    MakeQuick(options);
  }
  CommandLine line(options);
  line.AddSwitch("--quick", [] {});
  line.AddSetting("--frames",
    [&options](Text name, Text value) { options.OrbitFrames = ParseCount(name, value, 100000); });
  line.AddSetting("--output", [&options](Text, Text value) { options.OutputDirectory = value; });
  line.Parse(arguments);
  return options;
}

std::string HelpText()
{
  return std::string(
           R"(Orbit around a volume's isosurface and sweep its isovalue, ray cast on the CPU.

usage: OrbitAndSweep [VOLUME [ISOVALUE]] [OPTIONS]

)") +
    VolumeHelp + R"(
Pictures are written for an orbit (2 degrees a frame), a sweep of the isovalue in a still view, a
change of colour and a repeated picture, with a table of what each took. To look around in a window,
see Examples/Explorer.

  --size WxH | N         pixels of a picture, width x height or a square's side; default 1024
  --frames N             frames of the orbit; default 30
  --output DIR           where the pictures go; default ./pictures
)" + CommonOptionsHelp +
    R"(  --quick                small pictures, few frames
  --help                 show this text
)";
}
