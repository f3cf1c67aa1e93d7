// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ThreadFrames.h"

#include "Measuring.h"

#include <vtkSMPTools.h>

namespace ThreadFrames
{
namespace
{

constexpr const char* NoThreads = "Sequential";
constexpr const char* PlainThreads = "STDThread";

/// While this lives, work is done by a backend and so many threads.
class ThreadLimit
{
public:
  ThreadLimit(const char* backend, int threads)
    : Before(vtkSMPTools::GetBackend())
  {
    if (!vtkSMPTools::SetBackend(backend))
    {
      throw Measuring::Failure(std::string("This VTK has no backend ") + backend +
        " to count threads by: leave the scenario threads out.");
    }
    vtkSMPTools::Initialize(threads);
  }
  ~ThreadLimit()
  {
    vtkSMPTools::Initialize(0);
    vtkSMPTools::SetBackend(this->Before.c_str());
  }
  ThreadLimit(const ThreadLimit&) = delete;
  void operator=(const ThreadLimit&) = delete;

private:
  std::string Before;
};

/// Powers of two, and all.
std::vector<int> CountsUpTo(int all)
{
  std::vector<int> counts;
  for (int threads = 1; threads < all; threads *= 2)
  {
    counts.push_back(threads);
  }
  counts.push_back(all);
  return counts;
}

}

std::vector<Times> Measure(Stage& stage, int frames)
{
  const std::string usual = vtkSMPTools::GetBackend();
  const int all = vtkSMPTools::GetEstimatedNumberOfThreads();
  std::vector<Times> times;
  for (const int threads : CountsUpTo(all))
  {
    const char* backend = threads == 1 ? NoThreads : PlainThreads;
    const ThreadLimit limit(backend, threads);
    times.push_back({ backend, threads, TypicalFrames::Measure(stage, frames) });
  }
  if (usual != times.back().Backend)
  {
    times.push_back({ usual, all, TypicalFrames::Measure(stage, frames) });
  }
  return times;
}

void AddTo(JsonWriter& json, const std::vector<Times>& all)
{
  json.OpenList("threads");
  for (const Times& times : all)
  {
    json.OpenObject();
    json.Add("by", times.Backend);
    json.Add("threads", times.Threads);
    TypicalFrames::AddTo(json, times.Frames);
    json.Close();
  }
  json.Close();
}

}
