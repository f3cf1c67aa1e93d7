// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Report.h"

#include "Files/Volume.h"

#include <algorithm>
#include <cstdio>
#include <iterator>

namespace
{

// The frames of one row of the table.
struct Row
{
  std::string Change;
  std::string Route;
  std::vector<FrameRecord> Frames;
};

std::vector<Row> Grouped(const std::vector<FrameRecord>& records)
{
  std::vector<Row> rows;
  for (const FrameRecord& record : records)
  {
    auto row = std::find_if(rows.begin(), rows.end(),
      [&](const Row& r) { return r.Change == record.Change && r.Route == record.Route; });
    if (row == rows.end())
    {
      row = rows.insert(rows.end(), Row{ record.Change, record.Route, {} });
    }
    row->Frames.push_back(record);
  }
  return rows;
}

std::vector<double> Sorted(const std::vector<FrameRecord>& frames, double FrameRecord::*time)
{
  std::vector<double> values;
  for (const FrameRecord& frame : frames)
  {
    values.push_back(frame.*time);
  }
  std::sort(values.begin(), values.end());
  return values;
}

double Median(const std::vector<FrameRecord>& frames, double FrameRecord::*time)
{
  const std::vector<double> values = Sorted(frames, time);
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

double MedianMs(const std::vector<FrameRecord>& records, const std::string& change)
{
  std::vector<FrameRecord> frames;
  std::copy_if(records.begin(), records.end(), std::back_inserter(frames),
    [&](const FrameRecord& record) { return record.Change == change; });
  return Median(frames, &FrameRecord::WallMs);
}

}

void PrintMemory(const Volume& volume)
{
  if (!volume.Bricks)
  {
    return;
  }
  if (volume.Bricks->GetIsMapped())
  {
    std::printf("Samples: mapped from the file; they take no memory of the program.\n");
    return;
  }
  const auto inMiB = [](vtkTypeInt64 bytes) { return static_cast<double>(bytes) / (1 << 20); };
  std::printf("Samples: %.0f MiB in memory, of at most %.0f MiB.\n",
    inMiB(volume.Bricks->GetMemoryInUse()), inMiB(volume.Bricks->GetMemoryLimit()));
}

void PrintTable(const std::vector<FrameRecord>& records)
{
  std::printf("\n%-10s %-13s %6s %10s %8s %8s %9s %9s %12s\n", "change", "route", "frames",
    "median ms", "min", "max", "trace ms", "shade ms", "rays/s");
  for (const Row& row : Grouped(records))
  {
    const std::vector<double> wall = Sorted(row.Frames, &FrameRecord::WallMs);
    const double median = Median(row.Frames, &FrameRecord::WallMs);
    const double rays = static_cast<double>(row.Frames.front().Rays);
    std::printf("%-10s %-13s %6zu %10.1f %8.1f %8.1f %9.1f %9.1f %10.1f M\n", row.Change.c_str(),
      row.Route.c_str(), row.Frames.size(), median, wall.front(), wall.back(),
      Median(row.Frames, &FrameRecord::TraceMs), Median(row.Frames, &FrameRecord::ShadeMs),
      1e-3 * rays / median);
  }
}

void PrintGain(const std::vector<FrameRecord>& records, const Extraction& extraction)
{
  const double without = MedianMs(records, WithoutReuse);
  const double orbit = MedianMs(records, "orbit");
  std::printf("\nA moved camera takes %.1f ms, as without re-use (%.1f x): every view is exact.\n",
    orbit, without / orbit);
  std::printf("Gained by re-use, against %.1f ms without:", without);
  for (const char* change : { "threshold", "colour", "repeat" })
  {
    std::printf(" %s %.1f x%s", change, without / MedianMs(records, change),
      change == std::string("repeat") ? ".\n" : ",");
  }
  if (extraction.Filter.empty())
  {
    std::printf("A new threshold is in the picture after %.1f ms; triangles are not extracted: the "
                "volume is read as\nit is needed.\n",
      MedianMs(records, "threshold"));
    return;
  }
  std::printf("A new threshold is in the picture after %.1f ms; %s takes %.1f ms for the "
              "extraction alone of\nthe %lld triangles at isovalue %g, which are then still to be "
              "drawn.\n",
    MedianMs(records, "threshold"), extraction.Filter.c_str(), extraction.Ms,
    static_cast<long long>(extraction.Triangles), extraction.Isovalue);
}
