// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Program/CommandLine.h"

#include "Program/Quoted.h"
#include "Program/UserError.h"

#include <vtkType.h>

#include <cerrno>
#include <climits>
#include <cmath>
#include <cstdlib>
#include <sstream>

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

double ParseIsovalue(const std::string& text)
{
  double value = 0.0;
  if (!IsNumber(text, value))
  {
    throw UserError("The isovalue is a number in the unit of the volume's samples, not " +
      Quoted(text) + "; leave it out to have one chosen.");
  }
  return value;
}

void ParseSize(const std::string& text, CommonOptions& options)
{
  const int most = 16384;
  const std::vector<std::string> parts = Split(text, 'x');
  const bool isPair = parts.size() == 2 && text.back() != 'x';
  if (!(parts.size() == 1 || isPair) || !IsCount(parts.front(), most, options.Width) ||
    !IsCount(parts.back(), most, options.Height) || text.back() == 'x')
  {
    throw UserError("--size takes pixels as WIDTHxHEIGHT or as one number, each from 1 to " +
      std::to_string(most) + ", for example 1024x768, not " + Quoted(text) + ".");
  }
}

std::string ParseAxis(const std::string& option, const std::string& text)
{
  const std::string axis = text.size() == 1 ? "+" + text : text;
  if (axis.size() != 2 || (axis[0] != '+' && axis[0] != '-') || axis[1] < 'x' || axis[1] > 'z')
  {
    throw UserError(option + " takes one of +x, -x, +y, -y, +z, -z, not " + Quoted(text) + ".");
  }
  return axis;
}

constexpr int MostLevel = 63;
constexpr int MostMiB = 1 << 30;

// A whole number from 0.
int ParseIndex(const std::string& option, const std::string& text, int most)
{
  int count = 0;
  if (text != "0" && !IsCount(text, most, count))
  {
    throw UserError(option + " takes a whole number from 0 to " + std::to_string(most) + ", not " +
      Quoted(text) + ".");
  }
  return count;
}

bool IsOption(const std::string& argument)
{
  double number = 0.0;
  return argument.size() > 1 && argument[0] == '-' && !IsNumber(argument, number);
}

}

bool IsNumber(const std::string& text, double& number)
{
  char* end = nullptr;
  number = std::strtod(text.c_str(), &end);
  return !text.empty() && *end == '\0' && std::isfinite(number);
}

int ParseCount(const std::string& option, const std::string& text, int most)
{
  int count = 0;
  if (!IsCount(text, most, count))
  {
    throw UserError(option + " takes a whole number from 1 to " + std::to_string(most) + ", not " +
      Quoted(text) + ".");
  }
  return count;
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
                    "not " +
      Quoted(text) + ".");
  }
  layout.ScalarType = ScalarTypes().at(parts[3]);
  return layout;
}

std::string RawAsText(const RawLayout& layout)
{
  std::ostringstream text;
  text.precision(17);
  for (const int n : layout.Dimensions)
  {
    text << n << ',';
  }
  for (const auto& [name, type] : ScalarTypes())
  {
    text << (type == layout.ScalarType ? name : "");
  }
  for (const double spacing : layout.Spacing)
  {
    text << ',' << spacing;
  }
  return text.str();
}

CommandLine::CommandLine(CommonOptions& options)
  : Options(options)
{
  using Text = const std::string&;
  CommonOptions& o = this->Options;
  this->Switches = { { "--help", [&o] { o.Help = true; } }, { "-h", [&o] { o.Help = true; } },
    { "--big-endian", [&o] { o.Source.BigEndian = true; } },
    { "--large", [&o] { o.Source.IsLarge = true; } },
    { "--threshold", [&o] { o.ThresholdMode = true; } } };
  this->Settings = { { "--size", [&o](Text, Text value) { ParseSize(value, o); } },
    { "--spheres",
      [&o](Text name, Text value) { o.Source.Spheres = ParseCount(name, value, 2048); } },
    { "--isovalue", [&o](Text, Text value) { o.Isovalue = ParseIsovalue(value); } },
    { "--array", [&o](Text, Text value) { o.Source.Array = value; } },
    { "--time-step",
      [&o](Text name, Text value) { o.Source.TimeStep = ParseCount(name, value, INT_MAX); } },
    { "--raw", [&o](Text, Text value) { o.Source.Raw = ParseRaw(value); } },
    { "--resolution",
      [&o](Text name, Text value) { o.Source.Level = ParseIndex(name, value, MostLevel); } },
    { "--channel",
      [&o](Text name, Text value) { o.Source.Channel = ParseIndex(name, value, INT_MAX); } },
    { "--memory",
      [&o](Text name, Text value) { o.Source.MemoryMiB = ParseCount(name, value, MostMiB); } },
    { "--from", [&o](Text name, Text value) { o.From = ParseAxis(name, value); } },
    { "--up", [&o](Text name, Text value) { o.Up = ParseAxis(name, value); } } };
}

void CommandLine::AddSwitch(const std::string& option, const Switch& action)
{
  this->Switches[option] = action;
}

void CommandLine::AddSetting(const std::string& option, const Setting& action)
{
  this->Settings[option] = action;
}

void CommandLine::TakePositional(const std::string& argument, int position)
{
  if (argument.empty())
  {
    throw UserError("An argument is empty; name a volume, or leave it out for generated spheres.");
  }
  if (position == 0)
  {
    this->Options.Source.Path = argument;
  }
  else if (position == 1)
  {
    this->Options.Isovalue = ParseIsovalue(argument);
  }
  else
  {
    throw UserError("There is no use for " + Quoted(argument) +
      ": a volume and an isovalue are all that is taken without an option; see --help.");
  }
}

void CommandLine::Parse(const std::vector<std::string>& arguments)
{
  int positionals = 0;
  for (std::size_t i = 0; i < arguments.size(); ++i)
  {
    const std::string& argument = arguments[i];
    if (!IsOption(argument))
    {
      this->TakePositional(argument, positionals++);
    }
    else if (this->Switches.count(argument) == 1)
    {
      this->Switches.at(argument)();
    }
    else if (this->Settings.count(argument) == 1)
    {
      const std::string value = ++i < arguments.size() ? arguments[i] : "";
      if (value.empty() || value.compare(0, 2, "--") == 0)
      {
        throw UserError(argument + " needs a value after it; see --help.");
      }
      this->Settings.at(argument)(argument, value);
    }
    else
    {
      throw UserError("There is no option " + Quoted(argument) + "; --help lists those there are.");
    }
  }
  const CommonOptions& o = this->Options;
  if (o.Source.Raw && o.Source.Path.empty())
  {
    throw UserError("--raw tells what a file of bare samples holds; name that file, too.");
  }
  if (!o.From.empty() && o.From[1] == o.Up[1])
  {
    throw UserError(
      "--from " + o.From + " and --up " + o.Up + " lie on one axis; choose two axes.");
  }
}

const char* const VolumeHelp =
  R"(VOLUME is an image (.vti .vtk .mhd .mha .nii .nii.gz .nrrd .nhdr .slc), a stack of slices (.tif .png:
pages of a file, or files with numbers), a grid (.vtu .vts .vtr .vtm .vth .vtk and the parallel .pvti
.pvtu .pvts .pvtr; Exodus .ex2 .exo .e, .cgns and PLOT3D .xyz, xyz.bin where VTK reads them), a list
of time steps (.pvd .series), a directory with a series of DICOM files or of pictures, or, with --raw,
a file of bare samples. Without VOLUME four spheres are generated.
VOLUME may be larger than memory. A folder of OME-Zarr and a file of HDF5 (.ims .h5 .hdf5) are read as
they are needed; so are raw samples without compression (.mhd .mha .nrrd .nhdr .vti, --raw) and stacks
that would take more than a quarter of the machine's memory. The first opening reads all once, and
keeps a file of its value ranges beside the volume.
ISOVALUE is chosen from the volume's histogram if it is not given.
)";

const char* const CommonOptionsHelp =
  R"(  --isovalue V           as ISOVALUE
  --threshold            solid where the value is at least the isovalue, capped where the volume
                         ends; default: a surface where the value passes the isovalue
  --from AXIS            where the viewer stands: +x -x +y -y +z -z; default: +y for NIfTI and
                         DICOM, -y otherwise
  --up AXIS              which way is up in the picture; default +z
  --array NAME           which array of numbers, of points or cells; default: that of the image; of
                         a grid, the first one that holds ISOVALUE, or whose values differ
  --time-step N          which time step of a file that has several; default 1
  --raw NX,NY,NZ,TYPE[,SX,SY,SZ]
                         samples, type (uchar char ushort short uint int float double) and spacing
                         of a raw file, for example 256,256,110,uchar,1,1,2
  --big-endian           byte order of the raw file; default little endian
  --large                reads raw samples and stacks as they are needed, whatever their size
  --resolution N, --channel N
                         which level of resolution (0: the finest) and which channel (from 0) of
                         Zarr and HDF5; default 0
  --memory MIB           memory that samples may take that are read as needed; default 1536. Raw
                         files are mapped, and take none
  --spheres N            samples along an axis of the generated spheres; default 256
)";
