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
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <sstream>
#include <vector>

namespace
{

namespace fs = std::filesystem;

const char* const FirstLine = "# vtkTemporalCoherence Explorer session 1";
const char* const Suffix = ".session";

std::string Trimmed(const std::string& text)
{
  const std::size_t begin = text.find_first_not_of(" \t\r");
  const std::size_t end = text.find_last_not_of(" \t\r");
  return begin == std::string::npos ? "" : text.substr(begin, end - begin + 1);
}

template <typename Numbers>
std::string Join(const Numbers& numbers)
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

// One finite number for each of those there are; std::invalid_argument otherwise.
template <typename Numbers>
void Parse(const std::string& text, Numbers& numbers)
{
  std::istringstream in(text);
  for (double& number : numbers)
  {
    std::string word;
    if (!(in >> word) || !IsNumber(word, number))
    {
      throw std::invalid_argument(text);
    }
  }
  std::string rest;
  if (in >> rest)
  {
    throw std::invalid_argument(text);
  }
}

double ParseNumber(const std::string& text)
{
  std::array<double, 1> number{};
  Parse(text, number);
  return number[0];
}

CameraState& CameraOf(Session& session)
{
  if (!session.Camera)
  {
    session.Camera.emplace();
  }
  return *session.Camera;
}

using Taker = std::function<void(Session& session, const std::string& value)>;
using Text = const std::string&;

std::map<std::string, Taker> Takers()
{
  std::map<std::string, Taker> takers = {
    { "volume", [](Session& s, Text v) { s.Source.Path = v; } },
    { "spheres", [](Session& s, Text v) { s.Source.Spheres = ParseCount("spheres", v, 2048); } },
    { "raw", [](Session& s, Text v) { s.Source.Raw = ParseRaw(v); } },
    { "big-endian", [](Session& s, Text v) { s.Source.BigEndian = v == "on"; } },
    { "array", [](Session& s, Text v) { s.Source.Array = v; } },
    { "time-step",
      [](Session& s, Text v) { s.Source.TimeStep = ParseCount("time-step", v, INT_MAX); } },
    { "isovalue", [](Session& s, Text v) { s.Isovalue = ParseNumber(v); } },
    { "camera-position", [](Session& s, Text v) { Parse(v, CameraOf(s).Position); } },
    { "camera-focal-point", [](Session& s, Text v) { Parse(v, CameraOf(s).FocalPoint); } },
    { "camera-view-up", [](Session& s, Text v) { Parse(v, CameraOf(s).ViewUp); } },
    { "camera-view-angle", [](Session& s, Text v) { CameraOf(s).ViewAngle = ParseNumber(v); } },
  };
  for (const Choice& choice : AllChoices())
  {
    takers[choice.Name] = [&choice](Session& session, Text value)
    {
      const auto at = std::find(choice.Values.begin(), choice.Values.end(), value);
      if (at == choice.Values.end())
      {
        throw std::invalid_argument(value);
      }
      session.Choices[choice.What] = static_cast<int>(at - choice.Values.begin());
    };
  }
  return takers;
}

void TakeLine(const std::string& line, const std::map<std::string, Taker>& takers, Session& session)
{
  const std::size_t equals = line.find('=');
  const auto taker =
    equals == std::string::npos ? takers.end() : takers.find(Trimmed(line.substr(0, equals)));
  if (taker == takers.end())
  {
    throw std::invalid_argument(line);
  }
  taker->second(session, Trimmed(line.substr(equals + 1)));
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
  const std::size_t length = std::strlen(Suffix);
  return path.size() > length && path.compare(path.size() - length, length, Suffix) == 0;
}

void WriteSession(const Session& session, const std::string& path)
{
  std::ofstream file(path);
  file << FirstLine << '\n';
  const VolumeSource& source = session.Source;
  if (source.Path.empty())
  {
    file << "spheres = " << source.Spheres << '\n';
  }
  else
  {
    file << "volume = " << fs::absolute(source.Path).lexically_normal().string() << '\n';
  }
  if (source.Raw)
  {
    file << "raw = " << RawAsText(*source.Raw) << '\n'
         << "big-endian = " << (source.BigEndian ? "on" : "off") << '\n';
  }
  if (!source.Array.empty())
  {
    file << "array = " << source.Array << '\n';
  }
  if (source.TimeStep > 1)
  {
    file << "time-step = " << source.TimeStep << '\n';
  }
  if (session.Isovalue)
  {
    file << "isovalue = " << Join(std::array<double, 1>{ *session.Isovalue }) << '\n';
  }
  if (session.Camera)
  {
    file << "camera-position = " << Join(session.Camera->Position) << '\n'
         << "camera-focal-point = " << Join(session.Camera->FocalPoint) << '\n'
         << "camera-view-up = " << Join(session.Camera->ViewUp) << '\n'
         << "camera-view-angle = " << Join(std::array<double, 1>{ session.Camera->ViewAngle })
         << '\n';
  }
  for (const Choice& choice : AllChoices())
  {
    file << choice.Name << " = " << session.Choices.TextOf(choice.What) << '\n';
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
  const std::map<std::string, Taker> takers = Takers();
  for (int number = 2; std::getline(file, line); ++number)
  {
    line = Trimmed(line);
    if (line.empty() || line[0] == '#')
    {
      continue;
    }
    try
    {
      TakeLine(line, takers, session);
    }
    catch (const std::exception&)
    {
      throw UserError("Line " + std::to_string(number) + " of the session " + Quoted(path) +
        " cannot be understood: " + Quoted(line) + "; correct it or take it out.");
    }
  }
  if (session.Camera && !IsUsable(*session.Camera))
  {
    throw UserError("The camera of the session " + Quoted(path) +
      " looks nowhere; correct its lines, or take them out to see all of the volume.");
  }
  return session;
}
