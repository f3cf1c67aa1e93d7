// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// The mapper beside VTK's other ways to an isosurface, in the same run and view.

#include "Display.h"
#include "Measuring.h"
#include "PeerFrames.h"
#include "Scenario.h"

#include <algorithm>
#include <iostream>
#include <string>
#include <vector>

namespace
{

constexpr int UsualFrames = 12;

void AddTo(JsonWriter& json, const PeerFrames::Times& times, const PeerFrames::Times& ours)
{
  json.OpenObject();
  json.Add("who", times.Who);
  json.Add("pixels", times.Size);
  json.Add("drawnPercent", times.PercentDrawn);
  json.Add("newViewMs", times.NewView);
  json.Add("newViewByOurs", Measuring::Ratio(times.NewView, ours.NewView));
  json.Add("newIsovalueMs", times.NewIsovalue);
  json.Add("newIsovalueByOurs", Measuring::Ratio(times.NewIsovalue, ours.NewIsovalue));
  json.Close();
}

/// All that was measured of one volume.
struct Result
{
  Volumes::Sample Volume;
  std::vector<PeerFrames::Times> Peers;
};

/// The times of one way to draw pictures of a size, "new view / new isovalue".
std::string CellOf(const Result& result, const std::string& who, int size)
{
  const auto found = std::find_if(result.Peers.begin(), result.Peers.end(),
    [&](const PeerFrames::Times& t) { return t.Who == who && t.Size == size; });
  return found == result.Peers.end()
    ? "-"
    : Fixed(found->NewView, 1) + " / " + Fixed(found->NewIsovalue, 1);
}

/// A row for each volume, a column for each way to draw pictures of the full size.
void PrintRows(const std::vector<Result>& results, int size)
{
  std::cout << "\nThe same, a row for each volume: new view / new isovalue\n\n";
  std::vector<std::string> names;
  for (const PeerFrames::Times& t : results.front().Peers)
  {
    names.insert(names.end(), t.Size == size ? 1 : 0, t.Who);
  }
  std::vector<std::string> head = { "volume", "isovalue", "hit" };
  head.insert(head.end(), names.begin(), names.end());
  const MarkdownTable table(head);
  for (const Result& result : results)
  {
    std::vector<std::string> row = { result.Volume.Name, Plain(result.Volume.Isovalue),
      Fixed(result.Peers.front().PercentDrawn, 0) + " %" };
    for (const std::string& name : names)
    {
      row.push_back(CellOf(result, name, size));
    }
    table.Row(row);
  }
}

bool Run(const Settings& settings, JsonWriter& json)
{
  const bool hasWindow = HasDisplayOrTell("Peers that draw in a window are");
  const int frames = settings.FramesOr(UsualFrames);
  std::cout
    << "Medians in ms; new view: ours is a cold frame, polygons are only drawn; new "
       "isovalue: ours is looked up, but for the first; / ours: by the line of ours before\n\n";
  const MarkdownTable table({ "volume", "isovalue", "who", "pixels", "drawn %", "new view",
    "/ ours", "new isovalue", "/ ours" });
  std::vector<Result> results;
  const auto measure = [&](const Volumes::Sample& volume, Stage& stage)
  {
    json.OpenList("peers");
    PeerFrames::Times ours;
    results.push_back({ volume, PeerFrames::Measure(stage, frames, hasWindow) });
    for (const PeerFrames::Times& t : results.back().Peers)
    {
      ours = t.IsOurs ? t : ours;
      table.Row(
        { volume.Name, Plain(volume.Isovalue), t.Who, Plain(t.Size), Fixed(t.PercentDrawn, 0),
          Fixed(t.NewView, 1), Fixed(Measuring::Ratio(t.NewView, ours.NewView), 2),
          Fixed(t.NewIsovalue, 1), Fixed(Measuring::Ratio(t.NewIsovalue, ours.NewIsovalue), 2) });
      AddTo(json, t, ours);
    }
    json.Close();
  };
  const bool isMeasured = ReportVolumes(settings, ManyVolumes(), json, measure);
  if (isMeasured)
  {
    PrintRows(results, settings.Size);
  }
  return isMeasured;
}

}

Scenario Scenarios::Peers()
{
  return { "peers", "polygons and VTK's other volume mappers beside this one", Run };
}
