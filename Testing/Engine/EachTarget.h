// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_EachTarget_h
#define Testing_EachTarget_h

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <cstdint>
#include <cstring>

/// Runs the rest of a scope on one kind of vectors after the other.
class EachTarget : public ::testing::Test
{
protected:
  ~EachTarget() override { Choose(0); }

  template <typename Check>
  void ForEachTarget(const Check& check)
  {
    const std::int64_t all = hwy::SupportedTargets();
    for (int bit = 0; bit < 63; ++bit)
    {
      const std::int64_t target = std::int64_t(1) << bit;
      if (all & target)
      {
        Choose(target);
        check(hwy::TargetName(target));
      }
    }
    Choose(0);
  }

private:
  /// \param target 0: whatever the machine has
  static void Choose(std::int64_t target)
  {
    hwy::SetSupportedTargetsForTest(target);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
  }
};

/// True if the first `count` elements are the same to the last bit.
template <typename T>
bool AreIdentical(const T& a, const T& b, int count)
{
  return !std::memcmp(a.data(), b.data(), static_cast<std::size_t>(count) * sizeof(a[0]));
}

#endif
