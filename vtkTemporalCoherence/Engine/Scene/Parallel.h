// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_Parallel_h
#define TemporalCoherence_Parallel_h

#include "Bricks/SampleUse.h"

#include <vtkSMPTools.h>

#include <cstdint>

namespace TemporalCoherence
{

/// Call `work(begin, end)` for ranges that make up [0, count), in parallel and in any order. Ranges
/// have at least min(grain, count) numbers. The work must not throw, and its result must not depend
/// on the order. Each range is a SampleUse.
template <typename Work>
void ParallelForRanges(std::int64_t count, std::int64_t grain, const Work& work)
{
  if (count > 0)
  {
    vtkSMPTools::For(0, count, grain,
      [&work](vtkIdType begin, vtkIdType end)
      {
        const SampleUse use;
        work(static_cast<std::int64_t>(begin), static_cast<std::int64_t>(end));
      });
  }
}

/// Call `work(i)` for each i in [0, count), in parallel.
template <typename Work>
void ParallelFor(std::int64_t count, std::int64_t grain, const Work& work)
{
  ParallelForRanges(count, grain,
    [&work](std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t i = begin; i < end; ++i)
      {
        work(i);
      }
    });
}

}

#endif
