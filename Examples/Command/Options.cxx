// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Options.h"

#include "Program/Quoted.h"
#include "Program/UserError.h"

#include <vtkColor.h>
#include <vtkNamedColors.h>
#include <vtkNew.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

namespace
{

using Text = const std::string&;

constexpr double Unbounded = 1e300;

double ParseNumber(Text option, Text text, double least, double most)
{
  double number = 0.0;
  if (!IsNumber(text, number) || number < least || number > most)
  {
    std::ostringstream what;
    what << option << " takes a number";
    if (least > -Unbounded)
    {
      what << " from " << least << " to " << most;
    }
    what << ", not " << Quoted(text) << ".";
    throw UserError(what.str());
  }
  return number;
}

std::vector<std::string> PartsOf(Text option, Text list)
{
  std::vector<std::string> parts;
  std::istringstream in(list + ",");
  for (std::string part; std::getline(in, part, ',');)
  {
    if (part.empty())
    {
      throw UserError(
        option + " takes values with commas between, such as 80,120, not " + Quoted(list) + ".");
    }
    parts.push_back(part);
  }
  return parts;
}

void AddNumbers(Text option, Text list, double least, double most, std::vector<double>& numbers)
{
  for (Text part : PartsOf(option, list))
  {
    numbers.push_back(ParseNumber(option, part, least, most));
  }
}

// A name of HTML, or #rrggbb.
Rgb ParseColor(Text option, Text text)
{
  vtkNew<vtkNamedColors> named;
  const bool isHex = text.size() == 7 && text[0] == '#' &&
    text.find_first_not_of("0123456789abcdefABCDEF", 1) == std::string::npos;
  if (!isHex && !named->ColorExists(text))
  {
    throw UserError(option + " takes colours by name or as #rrggbb, such as ivory,#4080ff, not " +
      Quoted(text) + ".");
  }
  const vtkColor3ub color = isHex ? named->HTMLColorToRGB(text) : named->GetColor3ub(text);
  return { color[0] / 255.0, color[1] / 255.0, color[2] / 255.0 };
}

// The place of a word of a choice.
int ParseWord(Text option, Text text, Row::Which choice)
{
  const std::vector<const char*>& words = AllSettings()[choice].Words;
  const auto at =
    std::find_if(words.begin(), words.end(), [&](const char* word) { return text == word; });
  if (at == words.end())
  {
    std::string list;
    for (const char* word : words)
    {
      list += (list.empty() ? "" : ", ") + std::string(word);
    }
    throw UserError(option + " takes one of " + list + ", not " + Quoted(text) + ".");
  }
  return static_cast<int>(at - words.begin());
}

void ParseClip(Text option, Text text, Options& options)
{
  const std::size_t axis = text.find_first_not_of("+-");
  const std::string rest = axis == std::string::npos ? "" : text.substr(axis);
  if (axis > 1 || rest.empty() || rest[0] < 'x' || rest[0] > 'z' ||
    (rest.size() > 1 && (rest[1] != '=' || rest.size() == 2)))
  {
    throw UserError(
      option + " takes an axis and a place, such as x=40, -z=12.5 or y, not " + Quoted(text) + ".");
  }
  options.IsClipFlipped = text[0] == '-';
  options.ClipAxis = static_cast<std::size_t>(rest[0] - 'x');
  if (rest.size() > 2)
  {
    options.ClipAt = ParseNumber(option, rest.substr(2), -Unbounded, Unbounded);
  }
}

void ParseSamples(Text option, Text text, Options& options)
{
  options.Samples = ParseCount(option, text, 64);
  const int side = static_cast<int>(std::lround(std::sqrt(options.Samples)));
  if (side * side != options.Samples)
  {
    throw UserError(option + " takes a square number: 1, 4, 9, 16, 25, 36, 49 or 64.");
  }
}

void AddLooks(CommandLine& line, Options& options)
{
  const auto addChoice = [&](const char* option, Row::Which choice)
  {
    line.AddSetting(option,
      [&options, choice](Text name, Text value)
      { options.Choices.emplace_back(choice, ParseWord(name, value, choice)); });
  };
  const auto addSwitch = [&](const char* option, Row::Which choice, int word)
  {
    line.AddSwitch(
      option, [&options, choice, word] { options.Choices.emplace_back(choice, word); });
  };
  line.AddSetting("--iso",
    [&options](Text name, Text value)
    { AddNumbers(name, value, -Unbounded, Unbounded, options.Isovalues); });
  line.AddSetting("--opacity",
    [&options](Text name, Text value) { AddNumbers(name, value, 0.0, 1.0, options.Opacities); });
  line.AddSetting("--color",
    [&options](Text name, Text value)
    {
      for (Text part : PartsOf(name, value))
      {
        options.Colors.push_back(ParseColor(name, part));
      }
    });
  line.AddSetting("--color-by", [&options](Text, Text value) { options.ColorBy = value; });
  addChoice("--color-map", Row::ColorMap);
  line.AddSetting("--preset",
    [&options](Text name, Text value)
    {
      options.Choices.emplace_back(Row::Drawing, Drawing::Composite);
      options.Preset = ParseWord(name, value, Row::Preset);
    });
  line.AddSetting("--shift",
    [&options](Text name, Text value)
    { options.Shift = ParseNumber(name, value, -Unbounded, Unbounded); });
  line.AddSetting("--window",
    [&options](Text name, Text value)
    { options.Window = ParseNumber(name, value, 1e-300, Unbounded); });
  line.AddSetting("--level",
    [&options](Text name, Text value)
    { options.Level = ParseNumber(name, value, -Unbounded, Unbounded); });
  addChoice("--draw", Row::Drawing);
  addSwitch("--maximum", Row::Drawing, Drawing::Maximum);
  addSwitch("--minimum", Row::Drawing, Drawing::Minimum);
  addChoice("--palette", Row::Palette);
  addChoice("--material", Row::Material);
  addChoice("--light", Row::Light);
  addSwitch("--occlusion", Row::Occlusion, 1);
  addSwitch("--shadows", Row::Shadows, 1);
  addChoice("--cut", Row::Cut);
  addSwitch("--parallel", Row::Projection, 1);
  addSwitch("--outline", Row::Outline, 1);
  addSwitch("--axes", Row::Axes, 1);
  addSwitch("--scale-bar", Row::ScaleBar, 1);
  addSwitch("--color-bar", Row::ColorBar, 1);
  line.AddSetting("--background",
    [&options](Text name, Text value)
    {
      const bool isNone = value == "none";
      options.Choices.emplace_back(isNone ? Row::Transparency : Row::Background,
        isNone ? 1 : ParseWord(name, value, Row::Background));
    });
}

void AddViews(CommandLine& line, Options& options)
{
  line.AddSetting("--azimuth",
    [&options](Text name, Text value)
    { options.Azimuth = ParseNumber(name, value, -360.0, 360.0); });
  line.AddSetting("--elevation",
    [&options](Text name, Text value)
    { options.Elevation = ParseNumber(name, value, -89.0, 89.0); });
  line.AddSetting("--zoom",
    [&options](Text name, Text value) { options.Zoom = ParseNumber(name, value, 0.01, 100.0); });
  line.AddSetting("--clip", [&options](Text name, Text value) { ParseClip(name, value, options); });
  line.AddSetting(
    "--samples", [&options](Text name, Text value) { ParseSamples(name, value, options); });
  line.AddSetting("--film",
    [&options](Text name, Text value)
    {
      if (value != "turn" && value != "sweep")
      {
        throw UserError(name + " takes one of turn, sweep, not " + Quoted(value) + ".");
      }
      options.Motion = value == "turn" ? FilmMotion::TurnAround : FilmMotion::Sweep;
    });
  line.AddSetting("--frames",
    [&options](Text name, Text value) { options.Frames = ParseCount(name, value, 100000); });
  line.AddSetting(
    "--rate", [&options](Text name, Text value) { options.Rate = ParseCount(name, value, 240); });
  for (const char* option : { "-o", "--output" })
  {
    line.AddSetting(option, [&options](Text, Text value) { options.Output = value; });
  }
}

void AddSharing(CommandLine& line, SharedView& share)
{
  const auto addText = [&](const char* option, std::string& text)
  { line.AddSetting(option, [&text](Text, Text value) { text = value; }); };
  addText("--share", share.Path);
  addText("--title", share.Title);
  addText("--caption", share.Caption);
  addText("--citation", share.Citation);
  addText("--units", share.Units);
  line.AddSetting("--range",
    [&share](Text name, Text value)
    {
      std::vector<double> ends;
      AddNumbers(name, value, -Unbounded, Unbounded, ends);
      if (ends.size() != 2 || !(ends[0] <= ends[1]))
      {
        throw UserError(name + " takes the lowest and the highest isovalue, such as 50,200, not " +
          Quoted(value) + ".");
      }
      share.Range = { ends[0], ends[1] };
    });
  line.AddSetting("--tolerance",
    [&share](Text name, Text value) { share.Tolerance = ParseNumber(name, value, 0.02, 10.0); });
  line.AddSetting(
    "--views", [&share](Text name, Text value) { share.Views = ParseCount(name, value, 64); });
}

// What is shared is one view, for all isovalues.
void CheckSharing(const Options& options)
{
  const SharedView& share = options.Share;
  const bool hasTexts = !share.Title.empty() || !share.Caption.empty() || !share.Citation.empty() ||
    !share.Units.empty();
  if (share.Path.empty() &&
    (hasTexts || share.Range || share.Views != 1 || share.Tolerance != SharedView().Tolerance))
  {
    throw UserError("--title, --caption, --citation, --units, --range, --tolerance and --views are "
                    "those of a shared view; give --share FILE.html.");
  }
  if (!share.Path.empty() && (options.Motion || !options.Output.empty() || options.Samples > 1))
  {
    throw UserError("--share writes a view instead of a picture or film; leave out --output, "
                    "--film and --samples.");
  }
  const std::set<std::size_t> leftOut = { Row::Occlusion, Row::Shadows, Row::Cut, Row::Outline,
    Row::Axes, Row::ScaleBar, Row::ColorBar };
  const bool wantsMore = options.ThresholdMode || !options.ColorBy.empty() ||
    std::any_of(options.Choices.begin(), options.Choices.end(),
      [&](const auto& made) { return leftOut.count(made.first) > 0; });
  if (!share.Path.empty() && wantsMore)
  {
    throw UserError(
      "A shared view has surfaces in the colours of their isovalues, by plain light, and nothing "
      "beside them; leave out --threshold, --color-by, --occlusion, --shadows, --cut, --outline, "
      "--axes, --scale-bar and --color-bar.");
  }
}

// What can be known before a volume is read.
void Check(const Options& options)
{
  const std::size_t surfaces = std::max<std::size_t>(options.Isovalues.size(), 1);
  if (options.Opacities.size() > surfaces || options.Colors.size() > surfaces)
  {
    throw UserError(
      "There are more opacities or colours than isovalues; give each isovalue one, or "
      "fewer, of which the last one goes on.");
  }
  const auto hasWord = [&](Row::Which choice) // but the first
  {
    return std::any_of(options.Choices.begin(), options.Choices.end(),
      [&](const auto& made) { return made.first == choice && made.second != 0; });
  };
  if (hasWord(Row::Drawing) && !options.Isovalues.empty())
  {
    throw UserError(
      "Isovalues are those of surfaces, and no surfaces are drawn; leave out --iso, or "
      "--preset, --maximum, --minimum and --draw.");
  }
  if (!options.ColorBy.empty() && !options.Colors.empty())
  {
    throw UserError("Surfaces have the colours of --color or of --color-by; give one of them.");
  }
  const std::vector<double>& isovalues = options.Isovalues;
  if (std::set<double>(isovalues.begin(), isovalues.end()).size() < isovalues.size())
  {
    throw UserError("An isovalue is given twice; give each one once.");
  }
  if (!options.Motion && (options.Frames || options.Rate))
  {
    throw UserError("--frames and --rate are those of a film; give --film turn or --film sweep.");
  }
  if (!options.Preset && options.Shift != 0.0)
  {
    throw UserError("--shift moves a preset; name one by --preset.");
  }
  if (options.Window.has_value() != options.Level.has_value())
  {
    throw UserError("--window and --level belong together; give both, or none.");
  }
  if (hasWord(Row::Cut) && !options.ClipAxis)
  {
    throw UserError("--cut shows samples where --clip cuts; give --clip, too.");
  }
}

}

Options ParseOptions(int argc, char* argv[])
{
  Options options;
  CommandLine line(options);
  AddLooks(line, options);
  AddViews(line, options);
  AddSharing(line, options.Share);
  line.Parse({ argv + 1, argv + argc });
  if (options.Isovalue)
  {
    options.Isovalues.insert(options.Isovalues.begin(), *options.Isovalue);
  }
  Check(options);
  CheckSharing(options);
  options.Share.Width = options.Width;
  options.Share.Height = options.Height;
  return options;
}

std::string HelpText()
{
  return std::string(
           R"(Draw isosurfaces or a blended volume of a file, without a window.

usage: temporal-coherence [VOLUME [ISOVALUE] | FILE.session] [OPTIONS]
                          [-o PICTURE.png | --share FILE.html]

)") +
    VolumeHelp + R"(FILE.session is one that the Explorer saved.

  -o, --output FILE      where the picture goes (.png); default: the volume's name, here. A film: a
                         directory for numbered pictures, or .ogv where VTK writes films
  --size WxH | N         pixels of a picture; default 1024

 surfaces
  --iso V[,V...]         isovalues; also more than once
  --opacity O[,O...]     of each isovalue, 0 to 1; the last one goes on
  --color C[,C...]       of each isovalue: a name (ivory, tomato) or #rrggbb
  --palette NAME         colours over the values instead: tissue ivory steel ember viridis cool-warm
  --color-by ARRAY       colours of another array, for example Temp; of vectors V:length or V:2 (the
                         second component)
  --color-map NAME       colours over that array's values, of those of --palette; default cool-warm
  --material NAME        satin matt glossy flat
  --light NAME           studio head side rim
  --occlusion            ambient occlusion: hollows are darker; takes seconds, see-through
                         surfaces take up to a minute
  --shadows              of surfaces on one another

 blended volumes
  --preset NAME          "ct bone", "ct soft tissue", "ct vessels" (Hounsfield units), or mr
  --shift V              moves the preset over the values
  --maximum, --minimum   the largest or the smallest value of each ray, in grey
  --window W --level L   how many values lie from black to white, and the middle one
  --draw NAME            surfaces composite maximum minimum average additive labels

 view
  --azimuth D            degrees around the volume
  --elevation D          degrees up
  --zoom F               times as large
  --parallel             without perspective
  --clip [-]AXIS[=V]     what lies beyond a plane across an axis is seen (-: what lies before it),
                         for example x=40 or -z; default: in the middle
  --cut NAME             what is seen on that plane: nothing, "grey values", colours
  --background NAME      dark grey white, or none for a transparent picture
  --outline --axes --scale-bar --color-bar
                         what is seen beside the volume; these and --cut need a display
  --samples N            rays a pixel: 1 4 9 16 25 36 49 64; edges have 16 at least; default 1

 films
  --film turn | sweep    around the volume, or through all isovalues
  --frames N             default 120
  --rate N               frames a second of .ogv; default 25

 sharing
  --share FILE           writes the view for every isovalue, to be dragged in a browser: a page
                         (.html), a view file (.tcview), or a Cinema database (.cdb, a folder)
  --title, --caption, --citation, --units TEXT
                         what is told beside it
  --range LOW,HIGH       isovalues that are written; default: those of most surfaces
  --tolerance V          largest error in voxels, 0.02 to 10; default 0.1
  --views N              views around the volume, 1 to 64; default 1

 files
)" + CommonOptionsHelp +
    "  --help                 show this text\n";
}
