// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_MeshSteps_h
#define TemporalCoherence_MeshSteps_h

#include "Scene/Parallel.h"
#include "Scene/Progress.h"

#include <algorithm>
#include <cstdint>

namespace TemporalCoherence
{

/// Call `work(i)` for each i in [0, count), in parallel. If somebody observes progress, the calling
/// thread asks now and then whether to go on.
/// \return false if it was stopped
template <typename Work>
bool InSteps(std::int64_t count, const ReportProgress& progress, const Work& work)
{
  constexpr std::int64_t MostSteps = 16;
  const std::int64_t steps = progress ? std::min(count, MostSteps) : 1;
  for (std::int64_t step = 0; step < steps; ++step)
  {
    if (progress && !progress(static_cast<double>(step) / static_cast<double>(steps)))
    {
      return false;
    }
    const std::int64_t begin = count * step / steps, end = count * (step + 1) / steps;
    ParallelFor(end - begin, 1, [&](std::int64_t i) { work(begin + i); });
  }
  return true;
}

}

#endif
