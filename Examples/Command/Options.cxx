// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Options.h"

#include "Files/Reading.h"
#include "Program/Quoted.h"
#include "Program/UserError.h"

#include <vtkColor.h>
#include <vtkNamedColors.h>
#include <vtkNew.h>
#include <vtkTemporalCoherencePresets.h>
#include <vtkType.h>

#include <algorithm>
#include <limits>
#include <sstream>

namespace
{

using Text = const std::string&;

constexpr std::size_t MostSurfaces = 64;
constexpr int MostPixels = 16384; // along a side, with all samples
constexpr double MostElevation = 89.0;

double ParseNumber(Text option, Text text, double least, double most, Text what)
{
  double number = 0.0;
  if (!IsNumber(text, number) || number < least || number > most)
  {
    throw UserError(option + " takes " + what + ", not " + Quoted(text) + ".");
  }
  return number;
}

double ParseNumber(Text option, Text text)
{
  return ParseNumber(option, text, VTK_DOUBLE_MIN, VTK_DOUBLE_MAX, "a number");
}

// What stands between commas; also the nothing behind the last one.
std::vector<std::string> PartsOf(Text list)
{
  std::vector<std::string> parts(1);
  for (const char character : list)
  {
    if (character == ',')
    {
      parts.emplace_back();
    }
    else
    {
      parts.back() += character;
    }
  }
  return parts;
}

void AddNumbers(
  Text option, Text list, double least, double most, Text what, std::vector<double>& numbers)
{
  for (const std::string& part : PartsOf(list))
  {
    numbers.push_back(ParseNumber(option, part, least, most, what));
  }
}

Rgb ParseColor(Text option, Text text)
{
  vtkNew<vtkNamedColors> names;
  const bool isNumber = text.size() == 7 && text[0] == '#' &&
    text.find_first_not_of("0123456789abcdefABCDEF", 1) == std::string::npos;
  if (!isNumber && (text.empty() || text[0] == '#' || !names->ColorExists(text)))
  {
    throw UserError(option +
      " takes names of colours, for example tomato or white, or #rrggbb, not " + Quoted(text) +
      ".");
  }
  if (!isNumber)
  {
    const vtkColor3d color = names->GetColor3d(text);
    return { color[0], color[1], color[2] };
  }
  const unsigned long all = std::stoul(text.substr(1), nullptr, 16);
  Rgb color;
  for (std::size_t i = 0; i < 3; ++i)
  {
    color[i] = static_cast<double>((all >> (16 - 8 * i)) & 255) / 255.0;
  }
  return color;
}

std::string ParsePreset(Text option, Text text)
{
  std::string name = LowerCase(text), names;
  std::replace(name.begin(), name.end(), '-', ' ');
  for (int i = 0; i < vtkTemporalCoherencePresets::GetNumberOfPresets(); ++i)
  {
    const std::string known = vtkTemporalCoherencePresets::GetPresetName(i);
    if (name == known)
    {
      return known;
    }
    names += (names.empty() ? "\"" : ", \"") + known + "\"";
  }
  throw UserError(option + " takes one of " + names + ", not " + Quoted(text) + ".");
}

Options::Cut ParseClip(Text option, Text text)
{
  Options::Cut clip;
  std::string number = text;
  if (!number.empty() && number[0] != '+' && number[0] != '-')
  {
    number.insert(0, "+");
  }
  const bool hasAxis =
    number.size() > 3 && number[1] >= 'x' && number[1] <= 'z' && number[2] == '=';
  clip.Axis = number.substr(0, 2);
  number.erase(0, 3);
  clip.IsShare = !number.empty() && number.back() == '%';
  if (clip.IsShare)
  {
    number.pop_back();
  }
  if (!hasAxis || !IsNumber(number, clip.Value))
  {
    throw UserError(option +
      " takes an axis and where it is cut, for example +x=12.5, which hides "
      "what lies beyond x = 12.5, or -z=50%, which hides the lower half, not " +
      Quoted(text) + ".");
  }
  clip.Value *= clip.IsShare ? 0.01 : 1.0;
  return clip;
}

void SetDrawing(Options& options, const std::string& option, const std::string& drawing)
{
  if (!options.DrawsSurfaces() && options.Drawing != drawing)
  {
    throw UserError("A picture has one of --preset, --maximum, --minimum and --average; leave " +
      option + " out, or the other one.");
  }
  options.Drawing = drawing;
}

void AddLook(CommandLine& line, Options& options)
{
  Options& o = options;
  const auto addIsovalues = [&o](Text option, Text value)
  {
    AddNumbers(option, value, VTK_DOUBLE_MIN, VTK_DOUBLE_MAX, "isovalues, with commas between them",
      o.Isovalues);
  };
  line.AddSetting("--iso", addIsovalues);
  line.AddSetting("--isovalue", addIsovalues);
  line.AddSetting("--opacity",
    [&o](Text option, Text value)
    {
      AddNumbers(option, value, 0.001, 1.0, "numbers from 0.001 to 1, with commas between them",
        o.Opacities);
    });
  line.AddSetting("--color",
    [&o](Text option, Text value)
    {
      for (const std::string& part : PartsOf(value))
      {
        o.Colors.push_back(ParseColor(option, part));
      }
    });
  line.AddSetting("--preset",
    [&o](Text option, Text value)
    {
      o.Preset = ParsePreset(option, value);
      SetDrawing(o, option, "composite");
    });
  line.AddSetting(
    "--shift", [&o](Text option, Text value) { o.Shift = ParseNumber(option, value); });
  for (const char* drawing : { "maximum", "minimum", "average" })
  {
    const std::string option = std::string("--") + drawing;
    line.AddSwitch(option, [&o, option, drawing] { SetDrawing(o, option, drawing); });
  }
  line.AddSetting("--window",
    [&o](Text option, Text value)
    {
      o.Window = ParseNumber(
        option, value, std::numeric_limits<double>::min(), VTK_DOUBLE_MAX, "a number above 0");
    });
  line.AddSetting(
    "--level", [&o](Text option, Text value) { o.Level = ParseNumber(option, value); });
  line.AddSwitch("--occlusion", [&o] { o.HasOcclusion = true; });
  line.AddSwitch("--shadows", [&o] { o.HasShadows = true; });
}

void AddView(CommandLine& line, Options& options)
{
  Options& o = options;
  line.AddSetting(
    "--azimuth", [&o](Text option, Text value) { o.Azimuth = ParseNumber(option, value); });
  line.AddSetting("--elevation",
    [&o](Text option, Text value)
    {
      o.Elevation =
        ParseNumber(option, value, -MostElevation, MostElevation, "degrees from -89 to 89");
    });
  line.AddSetting("--zoom",
    [&o](Text option, Text value)
    { o.Zoom = ParseNumber(option, value, 0.01, 1000.0, "a factor from 0.01 to 1000"); });
  line.AddSwitch("--parallel", [&o] { o.IsParallel = true; });
  line.AddSetting("--clip", [&o](Text option, Text value) { o.Clip = ParseClip(option, value); });
  line.AddSetting("--background",
    [&o](Text option, Text value)
    {
      o.IsTransparent = value == "transparent";
      if (!o.IsTransparent)
      {
        o.Background = ParseColor(option, value);
      }
    });
}

void AddOutput(CommandLine& line, Options& options)
{
  Options& o = options;
  line.AddSetting(
    "--samples", [&o](Text option, Text value) { o.Samples = ParseCount(option, value, 16); });
  line.AddSetting("--film",
    [&o](Text option, Text value)
    {
      if (value != "turn" && value != "sweep")
      {
        throw UserError(option +
          " takes turn, once around the volume, or sweep, through its "
          "isovalues, not " +
          Quoted(value) + ".");
      }
      o.Film = value;
    });
  line.AddSetting(
    "--frames", [&o](Text option, Text value) { o.Frames = ParseCount(option, value, 100000); });
  line.AddSetting(
    "--rate", [&o](Text option, Text value) { o.Rate = ParseCount(option, value, 120); });
  const auto setOutput = [&o](Text, Text value) { o.Output = value; };
  line.AddSetting("-o", setOutput);
  line.AddSetting("--output", setOutput);
  line.AddSwitch("--version", [&o] { o.WantsVersion = true; });
}

void RequireOneForEach(
  const std::string& option, const char* what, std::size_t count, const Options& options)
{
  const std::size_t isovalues = std::max<std::size_t>(options.Isovalues.size(), 1);
  if (count > 1 && count != isovalues)
  {
    throw UserError(option + " has " + std::to_string(count) + " " + what + ", and there " +
      (isovalues == 1 ? "is 1 isovalue" : "are " + std::to_string(isovalues) + " isovalues") +
      "; give one for all, or one for each isovalue of --iso.");
  }
}

void CheckSurfaces(const Options& options)
{
  if (options.Isovalues.size() > MostSurfaces)
  {
    throw UserError("There are " + std::to_string(options.Isovalues.size()) +
      " isovalues; give at most " + std::to_string(MostSurfaces) + ".");
  }
  std::vector<double> sorted = options.Isovalues;
  std::sort(sorted.begin(), sorted.end());
  const auto same = std::adjacent_find(sorted.begin(), sorted.end());
  if (same != sorted.end())
  {
    std::ostringstream what;
    what << "The isovalue " << *same << " is given twice; give each one once.";
    throw UserError(what.str());
  }
  if (options.Film == "sweep")
  {
    if (options.Isovalues.size() == 1 || options.Isovalues.size() > 2 ||
      options.Opacities.size() > 1 || options.Colors.size() > 1)
    {
      throw UserError("--film sweep shows one surface, whose isovalue goes from one value to "
                      "another: give --iso FROM,TO, or none, and one opacity and colour at most.");
    }
    return;
  }
  RequireOneForEach("--opacity", "opacities", options.Opacities.size(), options);
  RequireOneForEach("--color", "colours", options.Colors.size(), options);
}

// Each option has an effect, or is refused.
void CheckLook(const Options& options)
{
  const bool isSurface = options.DrawsSurfaces();
  const std::pair<const char*, bool> ofSurfaces[] = { { "--iso", !options.Isovalues.empty() },
    { "--opacity", !options.Opacities.empty() }, { "--color", !options.Colors.empty() },
    { "--threshold", options.ThresholdMode }, { "--occlusion", options.HasOcclusion },
    { "--shadows", options.HasShadows }, { "--film sweep", options.Film == "sweep" } };
  for (const auto& [option, isGiven] : ofSurfaces)
  {
    if (isGiven && !isSurface)
    {
      throw UserError(std::string(option) + " is for surfaces, and --" +
        (options.Preset.empty() ? options.Drawing : "preset") +
        " draws none; leave one of the two out.");
    }
  }
  if (options.Shift && options.Preset.empty())
  {
    throw UserError("--shift moves a preset over the values; give --preset, too.");
  }
  if ((options.Window || options.Level) && (isSurface || !options.Preset.empty()))
  {
    throw UserError("--window and --level are the greys of a projection; give --maximum, --minimum "
                    "or --average, too.");
  }
}

void CheckPicture(const Options& options)
{
  if (!options.IsFilm() && (options.Frames || options.Rate))
  {
    throw UserError(
      "--frames and --rate are those of a film; give --film turn or --film sweep, too.");
  }
  if (options.Samples * std::max(options.Width, options.Height) > MostPixels)
  {
    throw UserError("--samples " + std::to_string(options.Samples) + " of " +
      std::to_string(options.Width) + " x " + std::to_string(options.Height) +
      " pixels are too many rays; choose fewer samples, or a smaller --size.");
  }
}

}

Options ParseOptions(int argc, char* argv[])
{
  Options options;
  CommandLine line(options);
  AddLook(line, options);
  AddView(line, options);
  AddOutput(line, options);
  bool isGenerated = false;
  line.AddSetting("--spheres",
    [&](Text option, Text value)
    {
      options.Source.Spheres = ParseCount(option, value, 2048);
      isGenerated = true;
    });
  line.Parse({ argv + 1, argv + argc });
  if (options.Help || options.WantsVersion)
  {
    return options;
  }
  if (options.Isovalue) // behind the file
  {
    options.Isovalues.insert(options.Isovalues.begin(), *options.Isovalue);
  }
  if (options.Source.Path.empty() && !isGenerated)
  {
    throw UserError("Name the file of a volume, or give --spheres 256 for a generated one; --help "
                    "tells what is read.");
  }
  CheckLook(options);
  CheckSurfaces(options);
  CheckPicture(options);
  return options;
}

std::string HelpText()
{
  return std::string(
           R"(Draw a volume, by rays on the CPU, into a picture or a film. It needs no window.

usage: temporal-coherence FILE [ISOVALUE] [OPTIONS] [-o PICTURE.png]

FILE is an image (.vti .vtk .mhd .mha .nii .nii.gz .slc), a grid (.vtu .vts .vtr .vtm .vth .vtk and
the parallel .pvti .pvtu .pvts .pvtr; Exodus .ex2 .exo .e, .cgns and PLOT3D .xyz, xyz.bin where VTK
reads them), a directory with a series of DICOM files, or, with --raw, a file of bare samples.

Surfaces, which are drawn if nothing else is asked for:
  --iso V,V,...          isovalues; default: one, chosen from the histogram
  --opacity O,O,...      from 0 to 1, one for all surfaces or one for each; default: 1, but 0.3 for
                         all but the highest of several isovalues
  --color C,C,...        names (tomato) or #rrggbb, one for all surfaces or one for each
  --occlusion            ambient occlusion: hollows are darker
  --shadows              surfaces cast shadows on each other
Blended volumes, of images and rectilinear grids:
  --preset NAME          see-through: "ct bone", "ct soft tissue", "ct vessels" (Hounsfield units),
                         or "mr" (any unit)
  --shift V              moves the preset up by so much
  --maximum, --minimum, --average
                         of the values along each ray, in grey
  --window W --level L   the greys: how many values lie from black to white, and the one between
The view:
  --azimuth A            degrees that the viewer walks around the volume; default 0
  --elevation E          degrees above the level, -89 to 89; default 6
  --zoom Z               larger than what fits the picture; default 1
  --parallel             without perspective
  --clip AXIS=V          hides what lies beyond, of +x, -x, +y, -y, +z or -z: +x=12.5; with % a share
                         of the volume: -z=50%
The picture:
  -o, --output NAME      PICTURE.png, or for a film FILM.ogv, where VTK can write it, or a directory
                         for numbered pictures; default: named as FILE, in the current directory
  --size WxH | N         pixels, width x height or a square's side; default 1024
  --background COLOR     a name or #rrggbb, or transparent; default: dark
  --samples N            N x N rays in each pixel, besides those at edges; default 1
  --film turn | sweep    once around the volume, or through the isovalues, from the first of --iso to
                         the second
  --frames N, --rate R   pictures of the film, and how many a second; default 100 and 25
The volume:
)") +
    CommonOptionsHelp + R"(  --version              show the version
  --help                 show this text
)";
}
