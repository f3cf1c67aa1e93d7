// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_EachTarget_h
#define Testing_EachTarget_h

#include "Checks/VectorTarget.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>

/// Runs a check on one kind of vectors after the other.
class EachTarget : public ::testing::Test
{
protected:
  template <typename Check>
  void ForEachTarget(const Check& check)
  {
    for (const std::int64_t target : VectorTarget::All())
    {
      const VectorTarget chosen(target);
      check(hwy::TargetName(target));
    }
  }
};

/// True if the first `count` elements are the same to the last bit.
template <typename T>
bool AreIdentical(const T& a, const T& b, int count)
{
  return !std::memcmp(a.data(), b.data(), static_cast<std::size_t>(count) * sizeof(a[0]));
}

#endif
