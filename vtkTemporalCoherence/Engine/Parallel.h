// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_Parallel_h
#define TemporalCoherence_Parallel_h

#include <vtkSMPTools.h>

#include <cstdint>

namespace TemporalCoherence
{

/// Call `work(i)` for each i in [0, count), in parallel and in no order, `grain` neighbouring ones
/// at a time. The work must not throw and must not depend on the order.
template <typename Work>
void ParallelFor(std::int64_t count, std::int64_t grain, const Work& work)
{
  if (count <= 0)
  {
    return;
  }
  vtkSMPTools::For(0, count, grain,
    [&work](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        work(static_cast<std::int64_t>(i));
      }
    });
}

}

#endif
