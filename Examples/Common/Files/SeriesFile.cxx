// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/SeriesFile.h"

#include "Files/FileCheck.h"
#include "Files/Reading.h"
#include "Program/Quoted.h"
#include "Program/Silence.h"

#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkXMLParser.h>
#include <vtk_jsoncpp.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <sstream>

namespace
{

namespace fs = std::filesystem;

constexpr std::uintmax_t MostBytes = 16 << 20; // of a list

struct Entry
{
  double Time = 0.0;
  std::string File;
};

// Takes elements as they come. A tree of them could be deeper than the memory of calls.
class PvdParser : public vtkXMLParser
{
public:
  static PvdParser* New() { VTK_STANDARD_NEW_BODY(PvdParser); }
  bool IsCollection = false;
  int Depth = 0;
  std::vector<Entry> Entries;
  std::string BadTime;

protected:
  void StartElement(const char* name, const char** attributes) override
  {
    ++this->Depth;
    this->IsCollection = this->IsCollection || std::string(name) == "Collection";
    if (std::string(name) != "DataSet")
    {
      return;
    }
    Entry entry;
    for (; attributes[0]; attributes += 2)
    {
      const std::string key = attributes[0], value = attributes[1];
      std::istringstream in(value);
      if (key == "timestep" && !(in >> entry.Time && (in >> std::ws).eof()))
      {
        this->BadTime = value;
      }
      entry.File = key == "file" ? value : entry.File;
    }
    this->Entries.push_back(entry);
  }
  void EndElement(const char*) override { --this->Depth; }
};

std::vector<Entry> EntriesOfPvd(const std::string& path, const std::string& text)
{
  vtkNew<PvdParser> parser;
  constexpr std::size_t Chunk = 1 << 16;
  constexpr int MostDepth = 100; // deeper ones take long, and much memory
  bool isXml = parser->InitializeParser() != 0;
  for (std::size_t at = 0; at < text.size() && isXml; at += Chunk)
  {
    const std::size_t size = std::min(Chunk, text.size() - at);
    isXml = parser->ParseChunk(text.data() + at, static_cast<unsigned int>(size)) != 0 &&
      parser->Depth <= MostDepth;
  }
  isXml = parser->CleanupParser() != 0 && isXml;
  if (!isXml || !parser->IsCollection)
  {
    throw Damaged(path, "it is no whole XML with a Collection");
  }
  if (!parser->BadTime.empty())
  {
    throw Damaged(path, "it has " + Quoted(parser->BadTime) + " as a time");
  }
  return parser->Entries;
}

std::vector<Entry> EntriesOfJson(const std::string& path, const std::string& text)
{
  const std::unique_ptr<Json::CharReader> reader(Json::CharReaderBuilder().newCharReader());
  Json::Value root;
  bool isJson = false;
  try
  {
    isJson = reader->parse(text.data(), text.data() + text.size(), &root, nullptr);
  }
  catch (const std::exception&)
  {
    // It is too deep.
  }
  if (!isJson || !root.isObject() || !root["files"].isArray())
  {
    throw Damaged(path, "it is no whole JSON with a list of \"files\"");
  }
  std::vector<Entry> entries;
  for (const Json::Value& one : root["files"])
  {
    if (!one.isObject() || !one["name"].isString() ||
      !(one["time"].isNull() || one["time"].isNumeric()))
    {
      throw Damaged(path, "one of its files has no name, or a time that is no number");
    }
    const double index = static_cast<double>(entries.size());
    entries.push_back(
      { one["time"].isNull() ? index : one["time"].asDouble(), one["name"].asString() });
  }
  return entries;
}

}

bool IsSeriesName(const std::string& path)
{
  const std::string name = LowerCase(path);
  return EndsWith(name, ".pvd") || EndsWith(name, ".series");
}

std::vector<SeriesStep> ReadSeriesFile(const std::string& path)
{
  const Silence silence;
  if (SizeOf(path) > MostBytes)
  {
    throw Damaged(path, "it is too long for a list of files");
  }
  const bool isPvd = EndsWith(LowerCase(path), ".pvd");
  const std::string text = BytesOf(path);
  std::vector<Entry> entries = isPvd ? EntriesOfPvd(path, text) : EntriesOfJson(path, text);
  if (entries.empty())
  {
    throw Damaged(path, "it names no files");
  }
  for (const Entry& entry : entries)
  {
    if (entry.File.empty() || !std::isfinite(entry.Time))
    {
      throw Damaged(path, "one of its files has no name, or no finite time");
    }
    if (IsSeriesName(entry.File))
    {
      throw UserError(Quoted(path) + " names " + Quoted(entry.File) +
        ", another list of time steps; name the files of that list instead.");
    }
  }
  std::stable_sort(
    entries.begin(), entries.end(), [](const Entry& a, const Entry& b) { return a.Time < b.Time; });
  std::vector<SeriesStep> steps;
  for (const Entry& entry : entries)
  {
    // Parts of one time are only in .pvd.
    if (steps.empty() || !isPvd || steps.back().Time < entry.Time)
    {
      steps.push_back({ entry.Time, {} });
    }
    steps.back().Files.push_back((fs::path(path).parent_path() / entry.File).string());
  }
  return steps;
}
