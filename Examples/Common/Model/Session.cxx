// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Model/Session.h"

#include "Program/CommandLine.h"
#include "Program/Quoted.h"
#include "Program/UserError.h"

#include <vtkMath.h>
#include <vtkVector.h>

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

std::string Trimmed(const std::string& text)
{
  const std::size_t begin = text.find_first_not_of(" \t\r");
  const std::size_t end = text.find_last_not_of(" \t\r");
  return begin == std::string::npos ? "" : text.substr(begin, end - begin + 1);
}

void Expect(bool isUnderstood)
{
  if (!isUnderstood)
  {
    throw std::invalid_argument("line");
  }
}

// What a line says: values are taken from its text or, if there is none yet, put into it.
class Line
{
public:
  Line() { this->Text.precision(17); }
  explicit Line(const std::string& text)
    : IsRead(true)
    , Text(text)
  {
  }

  void Take(double& number)
  {
    std::string word;
    if (this->IsRead)
    {
      Expect(this->Text >> word && IsNumber(word, number));
      return;
    }
    this->Text << (this->Text.tellp() > 0 ? " " : "") << number;
  }
  void Take(int& number, int least, int most)
  {
    double value = number;
    this->Take(value);
    number = static_cast<int>(std::clamp(value, 1.0 * least, 1.0 * most));
    Expect(number == value);
  }
  void Take(std::string& text) // to the end
  {
    if (this->IsRead)
    {
      std::getline(this->Text >> std::ws, text);
      return;
    }
    this->Text << text;
  }
  void Take(double& index, const std::vector<const char*>& words)
  {
    std::string word = words[static_cast<std::size_t>(index)];
    this->Take(word);
    word = word == "bounded" ? "exact" : word; // an accuracy of versions 0.1 and 0.2
    word = word == "crossing" ? "open" : word; // a surface of these versions
    const auto at = std::find(words.begin(), words.end(), word);
    Expect(at != words.end());
    index = static_cast<double>(at - words.begin());
  }
  void Take(bool& isOn)
  {
    double index = isOn;
    this->Take(index, { "off", "on" });
    isOn = index != 0.0;
  }
  void Take(RawLayout& raw)
  {
    std::string text = this->IsRead ? "" : RawAsText(raw);
    this->Take(text);
    raw = this->IsRead ? ParseRaw(text) : raw;
  }
  template <std::size_t Count>
  void Take(std::array<double, Count>& numbers)
  {
    for (double& number : numbers)
    {
      this->Take(number);
    }
  }
  // A line that there is only if what it says is set.
  template <typename Value>
  void Take(std::optional<Value>& value)
  {
    value = this->IsRead ? Value{} : value;
    if (value)
    {
      this->Take(*value);
    }
  }
  template <typename Flag, typename... Values>
  void TakeIf(Flag& isSet, Values&... values)
  {
    isSet = this->IsRead ? Flag{ 1 } : isSet;
    if (isSet)
    {
      (this->Take(values), ...);
    }
  }
  // What is off or 0 as a rule has a line only if it is not.
  void TakeUnlessOff(bool& isOn)
  {
    if (this->IsRead || isOn)
    {
      this->Take(isOn);
    }
  }
  void TakeUnlessZero(int& number)
  {
    if (this->IsRead || number != 0)
    {
      this->Take(number, 0, INT_MAX);
    }
  }
  void Take(std::vector<Marker>& markers, bool areSurfaces)
  {
    this->TakeRows(markers, [=](Line& row, Marker& marker) { row.Take(marker, areSurfaces); });
  }
  // The component alone: the name has a line of its own.
  void Take(ArrayColor& color)
  {
    if (this->IsRead || !color.Name.empty())
    {
      this->Take(color.Component, -1, 4095);
    }
  }
  void Take(std::vector<LabelLook>& labels)
  {
    this->TakeRows(labels,
      [](Line& row, LabelLook& label)
      {
        double isVisible = label.IsVisible ? 1.0 : 0.0;
        row.Take(label.Label, INT_MIN, INT_MAX);
        row.Take(label.Opacity);
        row.Take(isVisible);
        row.Take(label.Color);
        label.IsVisible = isVisible != 0.0;
        std::replace(label.Name.begin(), label.Name.end(), ';', ',');
        if (!row.IsRead)
        {
          row.Text << ' ';
        }
        row.Take(label.Name);
        label.Name = Trimmed(label.Name);
      });
  }

  void End() { Expect(!this->HasMore()); }
  std::string Written() const { return this->Text.str(); }
  const bool IsRead = false;

private:
  // A row of words each, with a semicolon between.
  template <typename Item, typename TakeItem>
  void TakeRows(std::vector<Item>& items, const TakeItem& take)
  {
    std::string rows;
    for (Item& item : items)
    {
      Line row;
      take(row, item);
      rows += (rows.empty() ? "" : " ; ") + row.Text.str();
    }
    this->Take(rows);
    items.resize(this->IsRead ? 0 : items.size());
    std::istringstream parts(this->IsRead ? rows : "");
    for (std::string part; std::getline(parts, part, ';');)
    {
      Line row(part);
      take(row, items.emplace_back());
      row.End();
    }
  }
  bool HasMore() { return !(this->Text >> std::ws).eof(); }
  void Take(Marker& marker, bool isSurface)
  {
    double isVisible = marker.IsVisible ? 1.0 : 0.0;
    this->Take(marker.Value);
    this->Take(marker.Opacity);
    if (isSurface)
    {
      this->Take(isVisible);
      marker.IsVisible = isVisible != 0.0;
    }
    if (!this->IsRead || this->HasMore())
    {
      this->Take(marker.Color);
    }
  }

  std::stringstream Text;
};

struct Field
{
  std::string Key;
  std::function<void(Line&)> Take;
};

// All rows of a name.
void TakeSettings(Line& line, const std::string& name, Look& look)
{
  double isAlways = 1.0;
  for (const Setting& setting : AllSettings())
  {
    if (setting.Name == name && setting.IsChoice())
    {
      line.Take(look.Values[setting.Place()], setting.Words);
    }
    else if (setting.Name == name)
    {
      line.TakeIf(setting.Switch < Row::Count ? look.Values[setting.Switch] : isAlways,
        look.Values[setting.Place()]);
    }
  }
}

// The lines of a file about this session.
std::vector<Field> FieldsOf(Session& session)
{
  VolumeSource& source = session.Source;
  Look& look = session.Settings;
  CameraState& camera = session.Camera;
  bool& hasCamera = session.HasCamera;
  std::vector<Field> fields = {
    { "spheres", [&](Line& line) { line.Take(source.Spheres, 1, 2048); } },
    { "volume", [&](Line& line) { line.Take(source.Path); } },
    { "raw", [&](Line& line) { line.Take(source.Raw); } },
    { "big-endian", [&](Line& line) { line.Take(source.BigEndian); } },
    { "array", [&](Line& line) { line.Take(source.Array); } },
    { "time-step", [&](Line& line) { line.Take(source.TimeStep, 1, INT_MAX); } },
    { "large", [&](Line& line) { line.TakeUnlessOff(source.IsLarge); } },
    { "resolution", [&](Line& line) { line.TakeUnlessZero(source.Level); } },
    { "channel", [&](Line& line) { line.TakeUnlessZero(source.Channel); } },
    { "memory", [&](Line& line) { line.TakeUnlessZero(source.MemoryMiB); } },
    { "isovalue", [&](Line& line) { line.Take(session.Isovalue); } },
    { "camera-position", [&](Line& line) { line.TakeIf(hasCamera, camera.Position); } },
    { "camera-focal-point", [&](Line& line) { line.TakeIf(hasCamera, camera.FocalPoint); } },
    { "camera-view-up", [&](Line& line) { line.TakeIf(hasCamera, camera.ViewUp); } },
    { "camera-view-angle", [&](Line& line) { line.TakeIf(hasCamera, camera.ViewAngle); } },
    { "camera-parallel-scale", [&](Line& line) { line.TakeIf(hasCamera, camera.ParallelScale); } },
    { "component", [&](Line& line) { line.Take(session.Component, -1, 4095); } },
    { "surfaces", [&](Line& line) { line.Take(look.Surfaces, true); } },
    { "opacity", [&](Line& line) { line.Take(look.Nodes, false); } },
    { "greys", [&](Line& line) { line.Take(look.Greys, false); } },
    { "labels", [&](Line& line) { line.Take(look.Labels); } },
    { "color-by", [&](Line& line) { line.Take(look.ColorBy.Name); } },
    { "color-by-component", [&](Line& line) { line.Take(look.ColorBy); } },
    { "clip",
      [&](Line& line)
      { line.TakeIf(look.Values[Row::Clipping], look.Clip.Origin, look.Clip.Normal); } },
  };
  for (const Setting& setting : AllSettings())
  {
    if (*setting.Name && setting.Name != fields.back().Key)
    {
      fields.push_back(
        { setting.Name, [&](Line& line) { TakeSettings(line, setting.Name, look); } });
    }
  }
  return fields;
}

void TakeLine(const std::string& text, const std::vector<Field>& fields)
{
  const std::size_t equals = std::min(text.find('='), text.size());
  const std::string key = Trimmed(text.substr(0, equals));
  const auto field = std::find_if(
    fields.begin(), fields.end(), [&key](const Field& other) { return other.Key == key; });
  Expect(field != fields.end());
  Line line(Trimmed(text.substr(equals + 1)));
  field->Take(line);
  line.End();
}

// Where a session lies, for paths that start there.
fs::path DirectoryOf(const std::string& session)
{
  return fs::absolute(session).lexically_normal().parent_path();
}

}

bool IsUsable(const CameraState& camera)
{
  constexpr double Farthest = 1e15, Nearest = 1e-9;
  const vtkVector3d position(camera.Position.data()), focus(camera.FocalPoint.data()),
    up(camera.ViewUp.data());
  vtkVector3d direction;
  vtkMath::Subtract(focus, position, direction);
  const double distance = direction.Norm();
  return position.Norm() < Farthest && focus.Norm() < Farthest && up.Norm() < Farthest &&
    up.Norm() > 1.0 / Farthest && distance > 1.0 / Farthest &&
    distance > Nearest * (position.Norm() + focus.Norm()) &&
    direction.Cross(up).Norm() > Nearest * distance * up.Norm() && camera.ViewAngle > 1e-5 &&
    camera.ViewAngle < 179.0 && camera.ParallelScale > 1.0 / Farthest &&
    camera.ParallelScale < Farthest;
}

bool IsSessionName(const std::string& path)
{
  return path.size() > Suffix.size() &&
    path.compare(path.size() - Suffix.size(), Suffix.size(), Suffix) == 0;
}

void WriteSession(Session session, const std::string& path)
{
  std::string& volume = session.Source.Path;
  if (!volume.empty())
  {
    // So that both may be moved together. There is no such way from one drive to another.
    const fs::path whole = fs::absolute(volume).lexically_normal();
    const fs::path way = whole.lexically_relative(DirectoryOf(path));
    volume = (way.empty() ? whole : way).generic_string();
  }
  std::ofstream file(path);
  file << FirstLine << '\n';
  for (const Field& field : FieldsOf(session))
  {
    Line line;
    field.Take(line);
    file << (line.Written().empty() ? "" : field.Key + " = " + line.Written() + "\n");
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
  session.Settings = Look::Before();
  const std::vector<Field> fields = FieldsOf(session);
  for (int number = 2; std::getline(file, line); ++number)
  {
    line = Trimmed(line);
    try
    {
      if (!line.empty() && line[0] != '#')
      {
        TakeLine(line, fields);
      }
    }
    catch (const std::exception&)
    {
      throw UserError("Line " + std::to_string(number) + " of the session " + Quoted(path) +
        " cannot be understood: " + Quoted(line) + "; correct it or take it out.");
    }
  }
  if (std::string& volume = session.Source.Path; !volume.empty())
  {
    // People write sessions that begin where the program runs.
    const fs::path beside = (DirectoryOf(path) / volume).lexically_normal();
    volume = fs::exists(beside, error) || !fs::exists(volume, error) ? beside.string() : volume;
  }
  if (!session.Isovalue && !session.Settings.Surfaces.empty())
  {
    session.Isovalue = session.Settings.Surfaces[0].Value;
  }
  if (session.HasCamera && !IsUsable(session.Camera))
  {
    throw UserError("The camera of the session " + Quoted(path) +
      " looks nowhere; correct its lines, or take them out to see all of the volume.");
  }
  return session;
}
