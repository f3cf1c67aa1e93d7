// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_Progress_h
#define TemporalCoherence_Progress_h

#include <functional>

namespace TemporalCoherence
{

/// Called with the share of some work that is done, from 0 to 1; returns false to stop it. Null:
/// nobody wants to know.
using ReportProgress = std::function<bool(double)>;

/// Progress in one part of some work, as progress of the whole.
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
