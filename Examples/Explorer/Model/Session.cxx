// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Model/Session.h"

#include "Program/CommandLine.h"
#include "Program/Quoted.h"
#include "Program/UserError.h"

#include <vtkVector.h>
#include <vtkVectorOperators.h>

#include <algorithm>
#include <climits>
#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>

namespace
{

namespace fs = std::filesystem;

const std::string FirstLine = "# vtkTemporalCoherence Explorer session 1";
const std::string Suffix = ".session";

using Text = const std::string&;
using Numbers = std::vector<double>;

std::string Trimmed(Text text)
{
  const std::size_t begin = text.find_first_not_of(" \t\r");
  const std::size_t end = text.find_last_not_of(" \t\r");
  return begin == std::string::npos ? "" : text.substr(begin, end - begin + 1);
}

template <typename Range>
std::string Join(const Range& numbers)
{
  std::ostringstream text;
  text.precision(17);
  const char* separator = "";
  for (const double number : numbers)
  {
    text << separator << number;
    separator = " ";
  }
  return text.str();
}

// Finite numbers, as many as one of the counts; std::invalid_argument otherwise.
Numbers Parse(Text text, std::initializer_list<std::size_t> counts)
{
  std::istringstream in(text);
  Numbers numbers;
  double number = 0.0;
  for (std::string word; in >> word; numbers.push_back(number))
  {
    if (!IsNumber(word, number))
    {
      throw std::invalid_argument(text);
    }
  }
  if (std::find(counts.begin(), counts.end(), numbers.size()) == counts.end())
  {
    throw std::invalid_argument(text);
  }
  return numbers;
}

template <std::size_t Count>
std::array<double, Count> ParseArray(Text text)
{
  const Numbers numbers = Parse(text, { Count });
  std::array<double, Count> array;
  std::copy(numbers.begin(), numbers.end(), array.begin());
  return array;
}

// Rows of numbers, with a semicolon between.
template <typename Row, typename Write>
std::string JoinRows(const std::vector<Row>& rows, const Write& write)
{
  std::string text;
  for (const Row& row : rows)
  {
    Numbers numbers = write(row);
    if (row.Color)
    {
      numbers.insert(numbers.end(), row.Color->begin(), row.Color->end());
    }
    text += (text.empty() ? "" : " ; ") + Join(numbers);
  }
  return text;
}

template <typename Row, typename Read>
std::vector<Row> ParseRows(Text text, std::size_t count, const Read& read)
{
  std::vector<Row> rows;
  std::istringstream in(text);
  for (std::string part; std::getline(in, part, ';');)
  {
    const Numbers numbers = Parse(part, { count, count + 3 });
    rows.push_back(read(numbers));
    if (numbers.size() > count)
    {
      rows.back().Color = { numbers[count], numbers[count + 1], numbers[count + 2] };
    }
  }
  return rows;
}

CameraState& CameraOf(Session& session)
{
  return session.Camera ? *session.Camera : session.Camera.emplace();
}

// A line of the file: what is written, empty for none, and how it is read.
struct Field
{
  std::string Key;
  std::function<std::string(const Session&)> Write;
  std::function<void(Session&, Text)> Read;
};

// What version 0.1 has, too.
std::vector<Field> FirstFields()
{
  using S = Session;
  using C = const Session;
  const auto ofCamera = [](C& s, const auto& part)
  { return s.Camera ? Join(part(*s.Camera)) : std::string(); };
  return {
    { "spheres", [](C& s) { return s.Source.Path.empty() ? std::to_string(s.Source.Spheres) : ""; },
      [](S& s, Text v) { s.Source.Spheres = ParseCount("spheres", v, 2048); } },
    { "volume",
      [](C& s) {
        return s.Source.Path.empty() ? "" : fs::absolute(s.Source.Path).lexically_normal().string();
      },
      [](S& s, Text v) { s.Source.Path = v; } },
    { "raw", [](C& s) { return s.Source.Raw ? RawAsText(*s.Source.Raw) : ""; },
      [](S& s, Text v) { s.Source.Raw = ParseRaw(v); } },
    { "big-endian", [](C& s) { return !s.Source.Raw   ? ""
                                 : s.Source.BigEndian ? "on"
                                                      : "off"; },
      [](S& s, Text v) { s.Source.BigEndian = v == "on"; } },
    { "array", [](C& s) { return s.Source.Array; }, [](S& s, Text v) { s.Source.Array = v; } },
    { "time-step",
      [](C& s) { return s.Source.TimeStep > 1 ? std::to_string(s.Source.TimeStep) : ""; },
      [](S& s, Text v) { s.Source.TimeStep = ParseCount("time-step", v, INT_MAX); } },
    { "isovalue", [](C& s) { return s.Isovalue ? Join(Numbers{ *s.Isovalue }) : ""; },
      [](S& s, Text v) { s.Isovalue = Parse(v, { 1 })[0]; } },
    { "camera-position",
      [=](C& s) { return ofCamera(s, [](const CameraState& c) { return c.Position; }); },
      [](S& s, Text v) { CameraOf(s).Position = ParseArray<3>(v); } },
    { "camera-focal-point",
      [=](C& s) { return ofCamera(s, [](const CameraState& c) { return c.FocalPoint; }); },
      [](S& s, Text v) { CameraOf(s).FocalPoint = ParseArray<3>(v); } },
    { "camera-view-up",
      [=](C& s) { return ofCamera(s, [](const CameraState& c) { return c.ViewUp; }); },
      [](S& s, Text v) { CameraOf(s).ViewUp = ParseArray<3>(v); } },
    { "camera-view-angle",
      [=](C& s)
      { return ofCamera(s, [](const CameraState& c) { return Numbers{ c.ViewAngle }; }); },
      [](S& s, Text v) { CameraOf(s).ViewAngle = Parse(v, { 1 })[0]; } },
  };
}

Field FieldOf(const Choice& choice)
{
  return { choice.Name,
    [&choice](const Session& s) { return s.Settings.Choices.TextOf(choice.What); },
    [&choice](Session& s, Text v)
    {
      const auto at = std::find(choice.Values.begin(), choice.Values.end(), v);
      if (at == choice.Values.end())
      {
        throw std::invalid_argument(v);
      }
      s.Settings.Choices[choice.What] = static_cast<int>(at - choice.Values.begin());
    } };
}

bool IsPlain(const Look& look)
{
  const auto& surfaces = look.Surfaces;
  return surfaces.empty() ||
    (surfaces.size() == 1 && surfaces[0].Opacity == 1.0 && surfaces[0].IsVisible &&
      !surfaces[0].Color);
}

std::vector<Field> LaterFields()
{
  using S = Session;
  using C = const Session;
  return {
    { "component", [](C& s) { return s.Component ? std::to_string(s.Component) : ""; },
      [](S& s, Text v) { s.Component = v == "-1" ? -1 : ParseCount("component", v, 4095); } },
    { "surfaces",
      [](C& s)
      {
        return IsPlain(s.Settings)
          ? ""
          : JoinRows(s.Settings.Surfaces,
              [](const Surface& row) {
                return Numbers{ row.Isovalue, row.Opacity, row.IsVisible ? 1.0 : 0.0 };
              });
      },
      [](S& s, Text v)
      {
        s.Settings.Surfaces = ParseRows<Surface>(v, 3,
          [](const Numbers& row) {
            return Surface{ row[0], row[1], row[2] != 0.0 };
          });
      } },
    { "opacity",
      [](C& s)
      {
        return JoinRows(s.Settings.Nodes,
          [](const Node& row) {
            return Numbers{ row.Value, row.Opacity };
          });
      },
      [](S& s, Text v)
      {
        s.Settings.Nodes = ParseRows<Node>(v, 2,
          [](const Numbers& row) {
            return Node{ row[0], row[1] };
          });
      } },
    { "density",
      [](C& s) { return s.Settings.Density != 1.0 ? Join(Numbers{ s.Settings.Density }) : ""; },
      [](S& s, Text v) { s.Settings.Density = std::clamp(Parse(v, { 1 })[0], 1e-3, 1e3); } },
    { "clip",
      [](C& s)
      {
        return s.Settings.Clip ? Join(s.Settings.Clip->Origin) + " " + Join(s.Settings.Clip->Normal)
                               : "";
      },
      [](S& s, Text v)
      {
        const Numbers n = Parse(v, { 6 });
        s.Settings.Clip = Plane{ { n[0], n[1], n[2] }, { n[3], n[4], n[5] } };
      } },
    { "crop", [](C& s) { return s.Settings.Crop ? Join(*s.Settings.Crop) : ""; },
      [](S& s, Text v) { s.Settings.Crop = ParseArray<6>(v); } },
    { "shading", [](C& s) { return s.Settings.Shading ? Join(*s.Settings.Shading) : ""; },
      [](S& s, Text v) { s.Settings.Shading = ParseArray<4>(v); } },
  };
}

std::vector<Field> AllFields()
{
  std::vector<Field> fields = FirstFields();
  for (const Choice& choice : AllChoices())
  {
    fields.push_back(FieldOf(choice));
  }
  const std::vector<Field> later = LaterFields();
  fields.insert(fields.end(), later.begin(), later.end());
  return fields;
}

void TakeLine(Text line, const std::vector<Field>& fields, Session& session)
{
  const std::size_t equals = line.find('=');
  const std::string key = equals == std::string::npos ? "" : Trimmed(line.substr(0, equals));
  const auto field = std::find_if(
    fields.begin(), fields.end(), [&key](const Field& other) { return other.Key == key; });
  if (field == fields.end())
  {
    throw std::invalid_argument(line);
  }
  field->Read(session, Trimmed(line.substr(equals + 1)));
}

// A view without a direction would draw nothing, nor would one from where numbers end.
bool IsUsable(const CameraState& camera)
{
  constexpr double Farthest = 1e15, Nearest = 1e-9;
  const vtkVector3d position(camera.Position.data()), focus(camera.FocalPoint.data()),
    up(camera.ViewUp.data());
  const vtkVector3d direction = focus - position;
  const double distance = direction.Norm();
  return position.Norm() < Farthest && focus.Norm() < Farthest && up.Norm() < Farthest &&
    up.Norm() > 1.0 / Farthest && distance > 1.0 / Farthest &&
    distance > Nearest * (position.Norm() + focus.Norm()) &&
    direction.Cross(up).Norm() > Nearest * distance * up.Norm() && camera.ViewAngle > 1e-5 &&
    camera.ViewAngle < 179.0;
}

}

bool IsSessionName(const std::string& path)
{
  return path.size() > Suffix.size() &&
    path.compare(path.size() - Suffix.size(), Suffix.size(), Suffix) == 0;
}

void WriteSession(const Session& session, const std::string& path)
{
  std::ofstream file(path);
  file << FirstLine << '\n';
  for (const Field& field : AllFields())
  {
    const std::string text = field.Write(session);
    file << (text.empty() ? "" : field.Key + " = " + text + "\n");
  }
  file.close();
  if (!file)
  {
    throw UserError("The session " + Quoted(path) +
      " could not be written; name a file in a directory that you may write in with --session.");
  }
}

Session ReadSession(const std::string& path)
{
  // Others may never end.
  std::error_code error;
  const bool isFile = fs::is_regular_file(path, error);
  std::ifstream file(isFile ? path : "");
  std::string line;
  if (!file)
  {
    throw UserError("There is no session " + Quoted(path) + " that can be read; check the path.");
  }
  if (!std::getline(file, line) || Trimmed(line) != FirstLine)
  {
    throw UserError(Quoted(path) + " is no session of this program: its first line is not " +
      Quoted(FirstLine) + "; open one that the Explorer saved.");
  }
  Session session;
  const std::vector<Field> fields = AllFields();
  for (int number = 2; std::getline(file, line); ++number)
  {
    line = Trimmed(line);
    if (line.empty() || line[0] == '#')
    {
      continue;
    }
    try
    {
      TakeLine(line, fields, session);
    }
    catch (const std::exception&)
    {
      throw UserError("Line " + std::to_string(number) + " of the session " + Quoted(path) +
        " cannot be understood: " + Quoted(line) + "; correct it or take it out.");
    }
  }
  if (!session.Isovalue && !session.Settings.Surfaces.empty())
  {
    session.Isovalue = session.Settings.Surfaces[0].Isovalue;
  }
  if (session.Camera && !IsUsable(*session.Camera))
  {
    throw UserError("The camera of the session " + Quoted(path) +
      " looks nowhere; correct its lines, or take them out to see all of the volume.");
  }
  return session;
}
