// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_Progress_h
#define TemporalCoherence_Progress_h

#include <functional>

namespace TemporalCoherence
{

/// Called with the finished share of some work, from 0 to 1. Returns false to stop the work. May be
/// null.
using ReportProgress = std::function<bool(double)>;

/// Maps the progress of one part of some work to progress of the whole.
inline ReportProgress PartOf(const ReportProgress& whole, double begin, double end)
{
  if (!whole)
  {
    return {};
  }
  return [whole, begin, end](double progress) { return whole(begin + progress * (end - begin)); };
}

}

#endif
