// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "IsomapMaps.h"

#include "IsomapFrames.h"
#include "Measuring.h"

#include <algorithm>
#include <array>

namespace IsomapMaps
{
namespace
{

constexpr std::array<double, 7> Widths = { 0.001, 0.003, 0.01, 0.03, 0.1, 0.3, 1.0 };
constexpr std::array<double, 7> Tolerances = { 0.0, 0.05, 0.1, 0.25, 0.5, 1.0, 2.0 };
/// Isovalues looked up: in the middles of as many parts of the band.
constexpr int NumberOfLookups = 9;

/// A band around the stage's isovalue, moved to where there are values.
std::array<double, 2> BandOf(const Stage& stage, double width)
{
  const double low = std::clamp(stage.Isovalue() - stage.ShareOfRange(0.5 * width),
    stage.IsovalueAt(0.0), stage.IsovalueAt(1.0 - width));
  return { low, low + stage.ShareOfRange(width) };
}

/// Look isovalues of the band up and compare them with cold frames.
void MeasureLookups(Stage& stage, const std::array<double, 2>& band, Drawer& drawer, Map& map)
{
  Drawer cold(stage);
  std::vector<double> times, coldTimes;
  for (int i = 0; i < NumberOfLookups; ++i)
  {
    stage.SetIsovalue(band[0] + (i + 0.5) / NumberOfLookups * (band[1] - band[0]));
    coldTimes.push_back(cold.DrawCold(stage));
    times.push_back(drawer.Draw(stage));
    if (drawer.Route() != "IsomapLookup")
    {
      throw Measuring::Failure("An isovalue of an isomap's band is not looked up but made by " +
        drawer.Route() + ": mend the engine.");
    }
    map.VoxelsApart = std::max(map.VoxelsApart, VoxelsApart(drawer, cold, stage));
    map.PercentDifferent = std::max(map.PercentDifferent, PercentDifferent(drawer, cold, stage));
  }
  map.LookupMs = Measuring::Median(times);
  map.LookupColdMs = Measuring::Median(coldTimes);
}

Map Measure(Stage& stage, double width, double tolerance)
{
  Map map;
  map.Width = width;
  map.Tolerance = tolerance;
  const double isovalue = stage.Isovalue();
  const std::array<double, 2> band = BandOf(stage, width);
  Drawer drawer(stage);
  drawer.Mapper->SetIsomapRange(band[0], band[1]);
  drawer.Mapper->SetIsomapTolerance(tolerance);
  drawer.Mapper->SetIsomapMemoryLimit(LargeMemoryLimit);
  // The first makes the structures of the data too.
  drawer.Draw(stage);
  map.ColdMs =
    Measuring::Median({ drawer.DrawCold(stage), drawer.DrawCold(stage), drawer.DrawCold(stage) });
  map.BuildMs = Measuring::TimeOf(
    [&] { map.IsBuilt = drawer.Mapper->BuildIsomap(stage.Renderer, stage.Volume); });
  if (map.IsBuilt)
  {
    map.BytesAPixel = IsomapFrames::BytesAPixel(drawer, stage);
    map.KnotsAPixel = IsomapFrames::KnotsAPixel(drawer, stage);
    MeasureLookups(stage, band, drawer, map);
    stage.SetIsovalue(isovalue);
  }
  else
  {
    map.BuildMs = 0.0;
  }
  return map;
}

}

std::vector<Map> MeasureWidths(Stage& stage)
{
  std::vector<Map> maps;
  for (const double width : Widths)
  {
    maps.push_back(Measure(stage, width, 0.0));
  }
  return maps;
}

std::vector<Map> MeasureTolerances(Stage& stage)
{
  std::vector<Map> maps;
  for (const double tolerance : Tolerances)
  {
    maps.push_back(Measure(stage, 1.0, tolerance));
  }
  return maps;
}

}
