// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_MadeFrom_h
#define TemporalCoherence_MadeFrom_h

#include "vtkTemporalCoherenceCompatibility.h"

#include <vtkType.h>

#include <utility>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;
class vtkObject;
VTK_ABI_NAMESPACE_END

namespace TemporalCoherence
{

/// A comparable record of inputs: arrays by their addresses and times, and numbers. Addresses may
/// dangle, but a pair of address and time identifies one object in a process.
///
/// Address and size of an array's memory are compared, too: an array that grows or shrinks moves
/// its numbers, but keeps its time.
class MadeFrom
{
public:
  /// \param object may be null
  /// \param time   a later modification time from another object, if any
  void Add(vtkObject* object, vtkMTimeType time = 0);

  /// Take note of an array.
  void Add(vtkDataArray* array, vtkMTimeType time = 0);

  void Add(double number) { this->Numbers.push_back(number); }

  bool operator==(const MadeFrom& other) const
  {
    return this->Objects == other.Objects && this->Places == other.Places &&
      this->Numbers == other.Numbers;
  }
  bool operator!=(const MadeFrom& other) const { return !(*this == other); }

private:
  std::vector<std::pair<const vtkObject*, vtkMTimeType>> Objects;
  std::vector<const void*> Places;
  std::vector<double> Numbers;
};

}

#endif
