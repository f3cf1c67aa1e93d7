// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Options.h"

#include <vtkType.h>

#include <algorithm>
#include <cerrno>
#include <climits>
#include <cmath>
#include <cstdlib>
#include <map>
#include <sstream>
#include <vector>

namespace
{

std::vector<std::string> Split(const std::string& text, char separator)
{
  std::vector<std::string> parts;
  std::istringstream in(text);
  for (std::string part; std::getline(in, part, separator);)
  {
    parts.push_back(part);
  }
  return parts;
}

// The whole text as a finite number.
bool IsNumber(const std::string& text, double& number)
{
  char* end = nullptr;
  number = std::strtod(text.c_str(), &end);
  return !text.empty() && *end == '\0' && std::isfinite(number);
}

// The whole text as a whole number from 1 to the most there may be.
bool IsCount(const std::string& text, int most, int& count)
{
  char* end = nullptr;
  errno = 0;
  const long number = std::strtol(text.c_str(), &end, 10);
  if (text.empty() || *end != '\0' || errno != 0 || number < 1 || number > most)
  {
    return false;
  }
  count = static_cast<int>(number);
  return true;
}

int ParseCount(const std::string& option, const std::string& text, int most)
{
  int count = 0;
  if (!IsCount(text, most, count))
  {
    throw UserError(
      option + " takes a whole number from 1 to " + std::to_string(most) + ", not '" + text + "'.");
  }
  return count;
}

double ParseIsovalue(const std::string& text)
{
  double value = 0.0;
  if (!IsNumber(text, value))
  {
    throw UserError("The isovalue is a number in the unit of the volume's samples, not '" + text +
      "'; leave it out to have one chosen.");
  }
  return value;
}

void ParseSize(const std::string& text, Options& options)
{
  const int most = 16384;
  const std::vector<std::string> parts = Split(text, 'x');
  const bool isPair = parts.size() == 2 && text.back() != 'x';
  if (!(parts.size() == 1 || isPair) || !IsCount(parts.front(), most, options.Width) ||
    !IsCount(parts.back(), most, options.Height) || text.back() == 'x')
  {
    throw UserError("--size takes pixels as WIDTHxHEIGHT or as one number, each from 1 to " +
      std::to_string(most) + ", for example 1024x768, not '" + text + "'.");
  }
}

const std::map<std::string, int>& ScalarTypes()
{
  static const std::map<std::string, int> types = { { "uchar", VTK_UNSIGNED_CHAR },
    { "char", VTK_SIGNED_CHAR }, { "ushort", VTK_UNSIGNED_SHORT }, { "short", VTK_SHORT },
    { "uint", VTK_UNSIGNED_INT }, { "int", VTK_INT }, { "float", VTK_FLOAT },
    { "double", VTK_DOUBLE } };
  return types;
}

RawLayout ParseRaw(const std::string& text)
{
  RawLayout layout;
  const std::vector<std::string> parts = Split(text, ',');
  bool isGood = parts.size() == 4 || parts.size() == 7;
  for (std::size_t axis = 0; isGood && axis < 3; ++axis)
  {
    isGood = IsCount(parts[axis], INT_MAX, layout.Dimensions[axis]);
    if (isGood && parts.size() == 7)
    {
      isGood = IsNumber(parts[4 + axis], layout.Spacing[axis]) && layout.Spacing[axis] > 0.0;
    }
  }
  isGood = isGood && ScalarTypes().count(parts[3]) == 1;
  if (!isGood)
  {
    throw UserError("--raw takes NX,NY,NZ,TYPE[,SX,SY,SZ] with one of the types uchar, char, "
                    "ushort, short, uint, int, float, double, for example 256,256,110,uchar,1,1,2, "
                    "not '" +
      text + "'.");
  }
  layout.ScalarType = ScalarTypes().at(parts[3]);
  return layout;
}

std::string ParseAxis(const std::string& option, const std::string& text)
{
  const std::string axis = text.size() == 1 ? "+" + text : text;
  if (axis.size() != 2 || (axis[0] != '+' && axis[0] != '-') || axis[1] < 'x' || axis[1] > 'z')
  {
    throw UserError(option + " takes one of +x, -x, +y, -y, +z, -z, not '" + text + "'.");
  }
  return axis;
}

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

using Switch = void (*)(Options& options);

const std::map<std::string, Switch>& Switches()
{
  static const std::map<std::string, Switch> switches = {
    { "--help", [](Options& o) { o.Help = true; } }, { "-h", [](Options& o) { o.Help = true; } },
    { "--big-endian", [](Options& o) { o.BigEndian = true; } },
    { "--threshold", [](Options& o) { o.ThresholdMode = true; } },
    { "--interactive", [](Options& o) { o.Interactive = true; } },
    { "--quick", [](Options&) {} }, // done before all others
  };
  return switches;
}

using Setting = void (*)(const std::string& option, const std::string& value, Options& options);
using Text = const std::string&;

const std::map<std::string, Setting>& Settings()
{
  static const std::map<std::string, Setting> settings = {
    { "--size", [](Text, Text value, Options& o) { ParseSize(value, o); } },
    { "--frames",
      [](Text name, Text value, Options& o) { o.OrbitFrames = ParseCount(name, value, 100000); } },
    { "--spheres",
      [](Text name, Text value, Options& o) { o.Spheres = ParseCount(name, value, 2048); } },
    { "--isovalue", [](Text, Text value, Options& o) { o.Isovalue = ParseIsovalue(value); } },
    { "--raw", [](Text, Text value, Options& o) { o.Raw = ParseRaw(value); } },
    { "--from", [](Text name, Text value, Options& o) { o.From = ParseAxis(name, value); } },
    { "--up", [](Text name, Text value, Options& o) { o.Up = ParseAxis(name, value); } },
    { "--output", [](Text, Text value, Options& o) { o.OutputDirectory = value; } },
    { "--screenshot",
      [](Text, Text value, Options& o)
      {
        o.Screenshot = value;
        o.Interactive = true;
      } },
  };
  return settings;
}

void TakePositional(const std::string& argument, int position, Options& options)
{
  if (argument.empty())
  {
    throw UserError("An argument is empty; name a volume, or leave it out for generated spheres.");
  }
  if (position == 0)
  {
    options.Volume = argument;
  }
  else if (position == 1)
  {
    options.Isovalue = ParseIsovalue(argument);
  }
  else
  {
    throw UserError("There is no use for '" + argument +
      "': a volume and an isovalue are all that is taken without an option; see --help.");
  }
}

bool IsOption(const std::string& argument)
{
  double number = 0.0;
  return argument.size() > 1 && argument[0] == '-' && !IsNumber(argument, number);
}

}

Options ParseOptions(int argc, char* argv[])
{
  Options options;
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  // First, wherever it stands: what it sets, other options may set again.
  if (std::count(arguments.begin(), arguments.end(), "--quick") > 0)
  {
    MakeQuick(options);
  }

  int positionals = 0;
  for (std::size_t i = 0; i < arguments.size(); ++i)
  {
    const std::string& argument = arguments[i];
    if (!IsOption(argument))
    {
      TakePositional(argument, positionals++, options);
    }
    else if (Switches().count(argument) == 1)
    {
      Switches().at(argument)(options);
    }
    else if (Settings().count(argument) == 1)
    {
      const std::string value = ++i < arguments.size() ? arguments[i] : "";
      if (value.empty() || value.compare(0, 2, "--") == 0)
      {
        throw UserError(argument + " needs a value after it; see --help.");
      }
      Settings().at(argument)(argument, value, options);
    }
    else
    {
      throw UserError("There is no option " + argument + "; --help lists those there are.");
    }
  }
  if (!options.From.empty() && options.From[1] == options.Up[1])
  {
    throw UserError(
      "--from " + options.From + " and --up " + options.Up + " lie on one axis; choose two axes.");
  }
  return options;
}

const char* HelpText()
{
  return R"(Orbit around a volume's isosurface and sweep its isovalue, ray cast on the CPU.

usage: OrbitAndSweep [VOLUME [ISOVALUE]] [OPTIONS]

VOLUME is a file .vti .vtk .mhd .mha .nii .nii.gz .slc, a directory with a series of DICOM files,
or, with --raw, a file of bare samples. Without VOLUME four spheres are generated.
ISOVALUE is chosen from the volume's histogram if it is not given.

Pictures are written for an orbit (2 degrees a frame), a sweep of the isovalue in a still view, a
change of colour and a repeated picture, with a table of what each took.

  --size WxH | N         pixels of a picture, width x height or a square's side; default 1024
  --frames N             frames of the orbit; default 30
  --output DIR           where the pictures go; default ./pictures
  --isovalue V           as ISOVALUE
  --threshold            solid where the value is at least the isovalue, capped where the volume
                         ends; default: a surface where the value passes the isovalue
  --from AXIS            where the viewer stands: +x -x +y -y +z -z; default: +y for NIfTI and
                         DICOM, -y otherwise
  --up AXIS              which way is up in the picture; default +z
  --raw NX,NY,NZ,TYPE[,SX,SY,SZ]
                         samples, type (uchar char ushort short uint int float double) and spacing
                         of a raw file, for example 256,256,110,uchar,1,1,2
  --big-endian           byte order of the raw file; default little endian
  --spheres N            samples along an axis of the generated spheres; default 256
  --quick                small pictures, few frames
  --interactive          a window with a slider for the isovalue instead of pictures; needs a display
  --screenshot FILE      draw that window once, save it as FILE (PNG), and end
  --help                 show this text
)";
}
