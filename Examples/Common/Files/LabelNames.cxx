// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/LabelNames.h"

#include "Files/Reading.h"
#include "Program/Quoted.h"
#include "Program/UserError.h"

#include <vtk_jsoncpp.h>

#include <algorithm>
#include <climits>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace
{

constexpr std::size_t MostNames = 65536;
constexpr std::uintmax_t MostBytes = 1 << 24;

using Names = std::vector<LabelName>;

bool IsLabel(double number)
{
  return number >= 0.0 && number <= INT_MAX && number == static_cast<int>(number);
}

// A colour of numbers up to 1, or up to 255.
std::array<double, 3> ColorOf(std::array<double, 3> color, bool isOf255)
{
  for (double& channel : color)
  {
    channel = std::clamp(channel / (isOf255 ? 255.0 : 1.0), 0.0, 1.0);
  }
  return color;
}

// "1 255 0 0 1 1 1 "Liver"": ITK-SNAP's number, colour, opacity, visibility twice, and name.
bool TakeSnap(const std::string& line, Names& names)
{
  std::istringstream in(line);
  double label = 0.0, opacity = 0.0, isVisible = 0.0, isMesh = 0.0;
  std::array<double, 3> color{};
  std::string name;
  if (!(in >> label >> color[0] >> color[1] >> color[2] >> opacity >> isVisible >> isMesh) ||
    !IsLabel(label) || !std::getline(in, name))
  {
    return false;
  }
  const std::size_t first = name.find('"'), last = name.rfind('"');
  if (first == std::string::npos || last == first)
  {
    return false;
  }
  names.push_back({ static_cast<int>(label), Printable(name.substr(first + 1, last - first - 1)),
    ColorOf(color, true), isVisible != 0.0 ? std::clamp(opacity, 0.0, 1.0) : 0.0 });
  return true;
}

// "1 Liver_lobe 221 130 101 255": Slicer's number, name, colour and opacity.
bool TakeSlicer(const std::string& line, Names& names)
{
  std::istringstream in(line);
  double label = 0.0, opacity = 0.0;
  std::array<double, 3> color{};
  std::string name;
  if (!(in >> label >> name >> color[0] >> color[1] >> color[2] >> opacity) || !IsLabel(label))
  {
    return false;
  }
  std::replace(name.begin(), name.end(), '_', ' ');
  names.push_back({ static_cast<int>(label), Printable(name), ColorOf(color, true),
    std::clamp(opacity / 255.0, 0.0, 1.0) });
  return true;
}

// A number, also one written as text.
std::optional<int> LabelOf(const Json::Value& value)
{
  char* end = nullptr;
  const std::string text = value.isString() ? value.asString() : "";
  const double number = value.isNumeric() ? value.asDouble() : std::strtod(text.c_str(), &end);
  const bool isNumber = value.isNumeric() || (!text.empty() && *end == '\0');
  return isNumber && IsLabel(number) ? std::optional<int>(static_cast<int>(number)) : std::nullopt;
}

bool TakeEntry(const Json::Value& entry, Names& names)
{
  if (!entry.isObject())
  {
    return false;
  }
  const auto label = LabelOf(entry.get("value", entry.get("label", Json::Value())));
  const Json::Value& name = entry["name"];
  if (!label || !name.isString())
  {
    return false;
  }
  LabelName made{ *label, Printable(name.asString()), std::nullopt, std::nullopt };
  const Json::Value& color = entry["color"];
  if (color.isArray() && color.size() >= 3)
  {
    std::array<double, 3> numbers{};
    for (unsigned int i = 0; i < 3; ++i)
    {
      if (!color[i].isNumeric())
      {
        return false;
      }
      numbers[i] = color[i].asDouble();
    }
    made.Color = ColorOf(numbers, *std::max_element(numbers.begin(), numbers.end()) > 1.0);
  }
  names.push_back(made);
  return true;
}

bool TakeJson(const Json::Value& root, bool mayBeOther, Names& names)
{
  if (root.isArray())
  {
    return std::all_of(
      root.begin(), root.end(), [&](const Json::Value& entry) { return TakeEntry(entry, names); });
  }
  if (!root.isObject())
  {
    return false;
  }
  if (root.isMember("labels"))
  {
    return TakeJson(root["labels"], false, names);
  }
  for (const std::string& key : root.getMemberNames())
  {
    const Json::Value& value = root[key];
    const std::optional<int> ofKey = LabelOf(Json::Value(key)), ofValue = LabelOf(value);
    if (ofKey && value.isString())
    {
      names.push_back({ *ofKey, Printable(value.asString()), std::nullopt, std::nullopt });
    }
    else if (ofValue && !mayBeOther)
    {
      names.push_back({ *ofValue, Printable(key), std::nullopt, std::nullopt });
    }
    else
    {
      return false;
    }
  }
  return true;
}

bool TakeLines(std::istream& file, Names& names)
{
  for (std::string line; std::getline(file, line);)
  {
    const std::size_t first = line.find_first_not_of(" \t\r");
    if (first != std::string::npos && line[first] != '#' && !TakeSnap(line, names) &&
      !TakeSlicer(line, names))
    {
      return false;
    }
  }
  return true;
}

bool TakeFile(std::istream& file, bool isJson, bool mayBeOther, Names& names)
{
  if (!isJson)
  {
    return TakeLines(file, names);
  }
  Json::CharReaderBuilder builder;
  builder["collectComments"] = false;
  builder["stackLimit"] = 64;
  Json::Value root;
  std::string errors;
  return Json::parseFromStream(builder, file, &root, &errors) && TakeJson(root, mayBeOther, names);
}

// Some tables have another number where others have opacities: nobody names what is all hidden.
void ShowAny(Names& names)
{
  if (std::all_of(
        names.begin(), names.end(), [](const LabelName& each) { return each.Opacity == 0.0; }))
  {
    for (LabelName& each : names)
    {
      each.Opacity = 1.0;
    }
  }
}

}

std::vector<LabelName> ReadLabelNames(const std::string& path, bool mayBeOther)
{
  std::error_code error;
  const bool isFile = std::filesystem::is_regular_file(path, error) &&
    std::filesystem::file_size(path, error) <= MostBytes;
  std::ifstream file(isFile ? path : "");
  std::vector<LabelName> names;
  bool isRead = false;
  try
  {
    isRead = file && TakeFile(file, EndsWith(LowerCase(path), ".json"), mayBeOther, names);
  }
  catch (const Json::Exception&)
  {
  }
  if (!isRead || names.empty() || names.size() > MostNames)
  {
    throw UserError(Quoted(path) +
      " tells no names of labels; choose a label description of ITK-SNAP, a colour table of "
      "Slicer, or JSON such as {\"1\": \"liver\"}.");
  }
  ShowAny(names);
  return names;
}

std::string LabelNamesBeside(const std::string& volume)
{
  std::filesystem::path stem = volume;
  if (LowerCase(stem.extension().string()) == ".gz")
  {
    stem.replace_extension();
  }
  std::error_code error;
  for (const char* const suffix : { ".label", ".ctbl", ".txt", ".json" })
  {
    stem.replace_extension(suffix);
    if (!volume.empty() && std::filesystem::is_regular_file(stem, error))
    {
      return stem.string();
    }
  }
  return "";
}
