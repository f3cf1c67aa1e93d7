// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_VectorTarget_h
#define Testing_VectorTarget_h

#include <hwy/targets.h>

#include <cstdint>
#include <vector>

/// During its lifetime, all kernels of the process run on one kind of vectors.
class VectorTarget
{
public:
  explicit VectorTarget(std::int64_t target) { Choose(target); }
  ~VectorTarget() { Choose(0); }
  VectorTarget(const VectorTarget&) = delete;
  void operator=(const VectorTarget&) = delete;

  /// The kinds that kernels are compiled for and this machine has, the widest first and the
  /// reference, which has no vectors, last.
  static std::vector<std::int64_t> All() { return hwy::SupportedAndGeneratedTargets(); }

private:
  /// \param target 0: the best of the machine
  static void Choose(std::int64_t target)
  {
    hwy::SetSupportedTargetsForTest(target);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
  }
};

#endif
