// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "IsomapReport.h"

#include "Measuring.h"

#include <functional>
#include <iostream>

namespace IsomapReport
{
namespace
{

using IsomapMaps::Map;
using Measuring::Ratio;
using Cells = std::vector<std::string>;

Cells Row(const Result& result, const Cells& cells)
{
  Cells row = { result.Volume.Name, Plain(result.Volume.Isovalue) };
  row.insert(row.end(), cells.begin(), cells.end());
  return row;
}

/// A row for each volume, a column for each of its maps.
void PrintMaps(const std::vector<Result>& results, std::vector<Map> Result::*maps,
  const std::function<std::string(const Map&)>& nameOf,
  const std::function<std::string(const Map&)>& cellOf)
{
  Cells head = { "volume", "isovalue" };
  for (const Map& map : results.front().*maps)
  {
    head.push_back(nameOf(map));
  }
  const MarkdownTable table(head);
  for (const Result& result : results)
  {
    Cells cells;
    for (const Map& map : result.*maps)
    {
      cells.push_back(map.IsBuilt ? cellOf(map) : "too large");
    }
    table.Row(Row(result, cells));
  }
}

void AddTo(JsonWriter& json, const IsomapFrames::Times& times)
{
  json.OpenObject("frames");
  json.Add("coldMs", times.Cold);
  json.Add("plainColdMs", times.Plain);
  json.Add("firstStepUpMs", times.FirstUp);
  json.Add("firstStepDownMs", times.FirstDown);
  json.Add("lookupMs", times.Lookup);
  json.Add("lookupTraceMs", times.LookupTrace);
  json.Add("lookupShadeMs", times.LookupShade);
  json.Add("bytesAPixel", times.BytesAPixel);
  json.Close();
}

}

void PrintFrames(const std::vector<Result>& results)
{
  const MarkdownTable table({ "volume", "isovalue", "cold", "plain cold", "first up", "first down",
    "look-up", "(trace + shade)", "cold / look-up", "plain / look-up", "first up / cold",
    "first down / cold", "bytes a pixel" });
  for (const Result& result : results)
  {
    const IsomapFrames::Times& t = result.Frames;
    table.Row(Row(result,
      { Fixed(t.Cold, 1), Fixed(t.Plain, 0), Fixed(t.FirstUp, 1), Fixed(t.FirstDown, 1),
        Fixed(t.Lookup, 1), Fixed(t.LookupTrace, 1) + " + " + Fixed(t.LookupShade, 1),
        Fixed(Ratio(t.Cold, t.Lookup), 2), Fixed(Ratio(t.Plain, t.Lookup), 1),
        Fixed(Ratio(t.FirstUp, t.Cold), 2), Fixed(Ratio(t.FirstDown, t.Cold), 2),
        Fixed(t.BytesAPixel, 1) }));
  }
}

void PrintWholeMaps(const std::vector<Result>& results)
{
  const MarkdownTable table({ "volume", "isovalue", "cold", "build", "build / cold",
    "bytes a pixel", "knots a pixel", "look-up", "cold of the same", "cold / look-up" });
  for (const Result& result : results)
  {
    const Map& m = result.Widths.back();
    table.Row(Row(result,
      { Fixed(m.ColdMs, 1), m.IsBuilt ? Fixed(m.BuildMs, 0) : "too large",
        Fixed(Ratio(m.BuildMs, m.ColdMs), 1), Fixed(m.BytesAPixel, 1), Fixed(m.KnotsAPixel, 2),
        Fixed(m.LookupMs, 1), Fixed(m.LookupColdMs, 1),
        Fixed(Ratio(m.LookupColdMs, m.LookupMs), 2) }));
  }
}

void PrintWidths(const std::vector<Result>& results)
{
  std::cout << "Maps by their share of the range: build time by a cold frame's / bytes a pixel\n\n";
  PrintMaps(
    results, &Result::Widths, [](const Map& m) { return Plain(100.0 * m.Width) + " %"; },
    [](const Map& m)
    { return Fixed(Ratio(m.BuildMs, m.ColdMs), 2) + " / " + Fixed(m.BytesAPixel, 1); });
  std::cout << '\n';
}

void PrintTolerances(const std::vector<Result>& results)
{
  std::cout << "Whole maps by tolerance: bytes a pixel / farthest surface, in voxels\n\n";
  PrintMaps(
    results, &Result::Tolerances, [](const Map& m) { return Plain(m.Tolerance); },
    [](const Map& m) { return Fixed(m.BytesAPixel, 1) + " / " + Fixed(m.VoxelsApart, 3); });
  std::cout << '\n';
}

void AddTo(JsonWriter& json, const std::string& name, const std::vector<Map>& maps)
{
  json.OpenList(name);
  for (const Map& map : maps)
  {
    json.OpenObject();
    json.Add("shareOfRange", map.Width);
    json.Add("toleranceVoxels", map.Tolerance);
    json.Add("isBuilt", map.IsBuilt ? 1.0 : 0.0);
    json.Add("coldMs", map.ColdMs);
    json.Add("buildMs", map.BuildMs);
    json.Add("bytesAPixel", map.BytesAPixel);
    json.Add("knotsAPixel", map.KnotsAPixel);
    json.Add("lookupMs", map.LookupMs);
    json.Add("lookupColdMs", map.LookupColdMs);
    json.Add("voxelsApart", map.VoxelsApart);
    json.Add("differentPixelsPercent", map.PercentDifferent);
    json.Close();
  }
  json.Close();
}

void AddTo(JsonWriter& json, const std::vector<Result>& results)
{
  json.OpenList("volumes");
  for (const Result& result : results)
  {
    json.OpenObject();
    json.Add("volume", result.Volume.Name);
    json.Add("isovalue", result.Volume.Isovalue);
    AddTo(json, result.Frames);
    AddTo(json, "widths", result.Widths);
    AddTo(json, "tolerances", result.Tolerances);
    json.Close();
  }
  json.Close();
}

}
