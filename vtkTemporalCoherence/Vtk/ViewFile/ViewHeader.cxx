// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ViewFile/ViewHeader.h"

#include "ViewFile/ViewHeaderParts.h"

#include <nlohmann/json.hpp>

namespace TemporalCoherence
{
namespace
{

constexpr const char* FormatName = "vtkTemporalCoherence view";
constexpr const char* DirectionNames[NumberOfDirections] = { "rising", "falling" };

constexpr std::size_t MostViews = 64;
constexpr int LargestSide = 16384;
constexpr std::int64_t MostPixels = std::int64_t(1) << 26; // of all views
/// The largest ratio of unpacked to packed bytes that deflate reaches.
constexpr std::uint64_t MostPacked = 1032;
constexpr std::uint64_t LeastBytesOfKnot = 6;

Json SectionAsJson(const FileSection& section)
{
  return { { "offset", section.Offset }, { "bytes", section.Bytes },
    { "unpacked", section.Unpacked } };
}

Json ChunkAsJson(const ChunkSection& chunk)
{
  Json json = SectionAsJson(chunk);
  json["direction"] = DirectionNames[static_cast<std::size_t>(chunk.Direction)];
  json["first"] = chunk.Rows.First;
  json["rows"] = chunk.Rows.Count;
  json["knots"] = chunk.Knots;
  return json;
}

Json ViewAsJson(const ViewEntry& view)
{
  Json json = GeometryAsJson(view.Geometry);
  json["range"] = { view.Range.Low, view.Range.High };
  json["progress"] = { { "largest", view.Grid.LargestProgress }, { "margin", KnotGrid::Margin },
    { "step", view.Grid.ProgressStep } };
  json["distanceStep"] = view.Grid.DistanceStep;
  json["normalSteps"] = view.NormalSteps;
  json["knots"] = { { DirectionNames[0], view.Knots[0] }, { DirectionNames[1], view.Knots[1] } };
  json["chunks"] = Json::array();
  for (const ChunkSection& chunk : view.Chunks)
  {
    json["chunks"].push_back(ChunkAsJson(chunk));
  }
  if (view.Entries)
  {
    json["entries"] = SectionAsJson(*view.Entries);
  }
  if (view.Unknown)
  {
    json["unknown"] = SectionAsJson(*view.Unknown);
  }
  return json;
}

/// \param bytes of all sections
void ReadSection(const Json& json, std::uint64_t bytes, FileSection& section)
{
  section.Offset = LargeNumber(json.at("offset"));
  section.Bytes = LargeNumber(json.at("bytes"));
  section.Unpacked = LargeNumber(json.at("unpacked"));
  Require(section.Offset <= bytes && section.Bytes <= bytes - section.Offset,
    "the file ends before a section does");
  Require(section.Unpacked >= 1 && section.Unpacked <= MostPacked * section.Bytes,
    "a section cannot be as large as it says");
}

/// Sections of planes have a known size.
std::optional<FileSection> ReadPlane(
  const Json& view, const char* name, std::uint64_t bytes, std::uint64_t unpacked)
{
  if (!view.contains(name))
  {
    return std::nullopt;
  }
  FileSection section;
  ReadSection(view.at(name), bytes, section);
  Require(section.Unpacked == unpacked, "a section has another size than its view");
  return section;
}

ChunkSection ReadChunk(const Json& json, std::uint64_t bytes, int height)
{
  ChunkSection chunk;
  ReadSection(json, bytes, chunk);
  const std::string direction = json.at("direction").get<std::string>();
  Require(direction == DirectionNames[0] || direction == DirectionNames[1],
    "a direction is neither rising nor falling");
  chunk.Direction =
    direction == DirectionNames[0] ? ValueDirection::Rising : ValueDirection::Falling;
  chunk.Rows.First = WholeNumber(json.at("first"), 0, height - 1);
  chunk.Rows.Count = WholeNumber(json.at("rows"), 1, height - chunk.Rows.First);
  chunk.Knots = LargeNumber(json.at("knots"));
  Require(chunk.Knots <= chunk.Unpacked / LeastBytesOfKnot, "a chunk is too small for its knots");
  return chunk;
}

/// Chunks of a direction follow by rows, and hold all of its knots.
void CheckChunks(const ViewEntry& view)
{
  std::array<std::uint64_t, NumberOfDirections> knots{};
  std::array<int, NumberOfDirections> next{};
  for (const ChunkSection& chunk : view.Chunks)
  {
    const auto direction = static_cast<std::size_t>(chunk.Direction);
    Require(chunk.Rows.First >= next[direction], "chunks overlap, or are not in order");
    next[direction] = chunk.Rows.First + chunk.Rows.Count;
    knots[direction] += chunk.Knots;
  }
  Require(knots == view.Knots, "chunks do not hold the knots of their view");
}

ViewEntry ReadView(const Json& json, std::uint64_t bytes)
{
  ViewEntry view;
  ReadGeometry(json, LargestSide, view.Geometry);
  view.Range = { Finite(json.at("range").at(0)), Finite(json.at("range").at(1)) };
  Require(view.Range.Low <= view.Range.High, "a range ends before it begins");
  const Json& progress = json.at("progress");
  view.Grid.LargestProgress =
    static_cast<std::uint16_t>(WholeNumber(progress.at("largest"), 1, 65535));
  view.Grid.ProgressStep = Finite(progress.at("step"));
  view.Grid.DistanceStep = Finite(json.at("distanceStep"));
  Require(view.Grid.ProgressStep > 0.0 && view.Grid.DistanceStep > 0.0, "a step is not above 0");
  Require(Finite(progress.at("margin")) == KnotGrid::Margin, "the margin of progress is unknown");
  view.NormalSteps = WholeNumber(json.at("normalSteps"), 1, 127);
  for (std::size_t direction = 0; direction < NumberOfDirections; ++direction)
  {
    view.Knots[direction] = LargeNumber(json.at("knots").at(DirectionNames[direction]));
    Require(view.Knots[direction] <= std::numeric_limits<std::uint32_t>::max(),
      "a view has too many knots");
  }
  const glm::ivec2 size = view.Geometry.Rays.Size;
  for (const Json& chunk : json.at("chunks"))
  {
    view.Chunks.push_back(ReadChunk(chunk, bytes, size.y));
  }
  CheckChunks(view);
  const std::uint64_t pixels =
    static_cast<std::uint64_t>(size.x) * static_cast<std::uint64_t>(size.y);
  view.Entries = ReadPlane(json, "entries", bytes, 2 * pixels);
  view.Unknown = ReadPlane(json, "unknown", bytes, (pixels + 7) / 8);
  return view;
}

/// Bytes of all sections of a view.
std::uint64_t BytesOf(const ViewEntry& view)
{
  std::uint64_t bytes =
    (view.Entries ? view.Entries->Bytes : 0) + (view.Unknown ? view.Unknown->Bytes : 0);
  for (const ChunkSection& chunk : view.Chunks)
  {
    bytes += chunk.Bytes;
  }
  return bytes;
}

}

std::string TextOf(const ViewHeader& header)
{
  Json json = DescriptionAsJson(header.Description);
  json["format"] = FormatName;
  json["version"] = ViewFileVersion;
  json["views"] = Json::array();
  for (const ViewEntry& view : header.Views)
  {
    json["views"].push_back(ViewAsJson(view));
  }
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string ReadHeader(const std::string& text, std::uint64_t bytes, ViewHeader& header)
try
{
  const Json json = Json::parse(text);
  Require(json.at("format") == FormatName && json.at("version") == ViewFileVersion,
    "it has another format or version");
  ReadDescription(json, header.Description);
  const Json& views = json.at("views");
  Require(views.is_array() && !views.empty() && views.size() <= MostViews,
    "it has no view, or more than 64");
  std::int64_t pixels = 0;
  std::uint64_t used = 0;
  header.Views.clear();
  for (const Json& view : views)
  {
    header.Views.push_back(ReadView(view, bytes));
    const glm::ivec2 size = header.Views.back().Geometry.Rays.Size;
    pixels += static_cast<std::int64_t>(size.x) * size.y;
    Require(pixels <= MostPixels, "its views have too many pixels");
    used += BytesOf(header.Views.back());
    Require(used <= bytes, "sections overlap");
  }
  return {};
}
catch (const WrongHeader& wrong)
{
  return wrong.what();
}
catch (const Json::exception& wrong)
{
  return wrong.what();
}

}
