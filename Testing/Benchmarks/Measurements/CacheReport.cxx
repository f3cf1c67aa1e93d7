// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CacheReport.h"

#include "Measuring.h"

#include <cstddef>
#include <functional>

namespace CacheReport
{
namespace
{

using namespace CacheFrames;

double SpeedUp(const Result& result, const Summary& summary)
{
  return Measuring::Ratio(result.Summaries.front().Medians[FrameMs], summary.Medians[FrameMs]);
}

bool AreOfSameVolume(const Result& a, const Result& b)
{
  return a.Volume.Name == b.Volume.Name && a.Volume.Isovalue == b.Volume.Isovalue;
}

/// A row for each volume and cached variant, a column for each motion. The results of a volume
/// follow each other, and all volumes have the same motions.
void PrintMotions(const std::vector<Result>& results,
  const std::function<std::string(const Result&, const Summary&)>& cellOf)
{
  std::vector<std::string> head = { "volume", "isovalue", "accuracy" };
  for (const Result& result : results)
  {
    if (AreOfSameVolume(result, results.front()))
    {
      head.push_back(result.Motion);
    }
  }
  const std::size_t motions = head.size() - 3;
  const MarkdownTable table(head);
  for (std::size_t first = 0; first < results.size(); first += motions)
  {
    const Result& volume = results[first];
    for (std::size_t v = 1; v < volume.Summaries.size(); ++v)
    {
      std::vector<std::string> cells = { volume.Volume.Name, Plain(volume.Volume.Isovalue),
        volume.Summaries[v].Variant };
      for (std::size_t s = 0; s < motions; ++s)
      {
        const Result& result = results[first + s];
        cells.push_back(cellOf(result, result.Summaries[v]));
      }
      table.Row(cells);
    }
  }
}

}

void PrintRatios(const std::vector<Result>& results)
{
  PrintMotions(results,
    [](const Result& result, const Summary& summary)
    { return Fixed(SpeedUp(result, summary), 2); });
}

void PrintDifferences(const std::vector<Result>& results)
{
  PrintMotions(results,
    [](const Result&, const Summary& summary)
    {
      return Fixed(summary.Medians[DifferentPixels], 4) + " / " +
        Fixed(summary.WorstDifferentPixels, 4);
    });
}

void PrintDetails(const std::vector<Result>& results, const std::string& motion)
{
  const MarkdownTable table({ "volume", "isovalue", "frames", "ms", "cold / ms", "query", "trace",
    "shade", "hit %", "miss %", "possible %", "samples a ray", "a traced ray",
    "different % (median / worst)", "from cache %" });
  for (const Result& result : results)
  {
    if (result.Motion != motion)
    {
      continue;
    }
    for (const Summary& summary : result.Summaries)
    {
      const Measures& m = summary.Medians;
      table.Row(
        { result.Volume.Name, Plain(result.Volume.Isovalue), summary.Variant, Fixed(m[FrameMs], 1),
          Fixed(SpeedUp(result, summary), 2), Fixed(m[QueryMs], 1), Fixed(m[TraceMs], 1),
          Fixed(m[ShadeMs], 1), Fixed(m[DefiniteHits], 1), Fixed(m[DefiniteMisses], 1),
          Fixed(m[PossibleHits], 1), Fixed(m[SamplesPerRay], 2), Fixed(m[SamplesPerTracedRay], 1),
          Fixed(m[DifferentPixels], 4) + " / " + Fixed(summary.WorstDifferentPixels, 4),
          Fixed(summary.FramesFromCache, 0) });
    }
  }
}

void AddTo(JsonWriter& json, const std::vector<Result>& results)
{
  json.OpenList("motions");
  for (const Result& result : results)
  {
    for (const Summary& summary : result.Summaries)
    {
      json.OpenObject();
      json.Add("volume", result.Volume.Name);
      json.Add("isovalue", result.Volume.Isovalue);
      json.Add("motion", result.Motion);
      json.Add("frames", summary.Variant);
      json.Add("coldByThis", SpeedUp(result, summary));
      for (std::size_t i = 0; i < NumberOfQuantities; ++i)
      {
        json.Add(NameOf(static_cast<Quantity>(i)), summary.Medians[i]);
      }
      json.Add("worstDifferentPixelsPercent", summary.WorstDifferentPixels);
      json.Add("framesFromCachePercent", summary.FramesFromCache);
      json.Close();
    }
  }
  json.Close();
}

}
