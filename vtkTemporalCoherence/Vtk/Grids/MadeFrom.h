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

/// What something was made from, to be compared: arrays by their addresses and times, and numbers.
/// An address may dangle. But no two objects of a process have the same address and time.
///
/// The numbers of an array are also compared by where they lie and how many there are: an array
/// that grows or shrinks moves them, and its time stays the same.
class MadeFrom
{
public:
  /// \param object may be null
  /// \param time   if others than the object tell that it may have changed
  void Add(vtkObject* object, vtkMTimeType time = 0);

  /// The same of an array.
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
