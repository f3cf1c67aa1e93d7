// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_MadeFrom_h
#define TemporalCoherence_MadeFrom_h

#include <vtkObject.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace TemporalCoherence
{

/// What something was made from, to be compared: arrays by their addresses and times, and numbers.
/// An address may dangle. But no two objects of a process have the same address and time.
class MadeFrom
{
public:
  /// \param array may be null
  /// \param time  if others than the array tell that it may have changed
  void Add(vtkObject* array, vtkMTimeType time = 0)
  {
    this->Arrays.emplace_back(array, array ? std::max(time, array->GetMTime()) : 0);
  }

  void Add(double number) { this->Numbers.push_back(number); }

  bool operator==(const MadeFrom& other) const
  {
    return this->Arrays == other.Arrays && this->Numbers == other.Numbers;
  }
  bool operator!=(const MadeFrom& other) const { return !(*this == other); }

private:
  std::vector<std::pair<const vtkObject*, vtkMTimeType>> Arrays;
  std::vector<double> Numbers;
};

}

#endif
