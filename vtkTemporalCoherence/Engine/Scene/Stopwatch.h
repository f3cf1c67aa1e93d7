// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_Stopwatch_h
#define TemporalCoherence_Stopwatch_h

#include <chrono>

namespace TemporalCoherence
{

/// Adds its lifetime to a number of seconds.
class Stopwatch
{
public:
  explicit Stopwatch(double& seconds)
    : Seconds(seconds)
    , Begin(std::chrono::steady_clock::now())
  {
  }
  ~Stopwatch()
  {
    const auto now = std::chrono::steady_clock::now();
    this->Seconds += std::chrono::duration<double>(now - this->Begin).count();
  }
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;

private:
  double& Seconds;
  std::chrono::steady_clock::time_point Begin;
};

}

#endif
