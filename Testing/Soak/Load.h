// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Soak_Load_h
#define Soak_Load_h

#include "Checks/Expect.h"

#include <string>

/// Something that is done again and again and must not cost memory for good.
class Load
{
public:
  virtual ~Load() = default;

  /// Do it once more. What goes wrong is told by Expect().
  virtual void DoOnce() = 0;

  /// One line that tells what was reached.
  virtual std::string Describe() const = 0;

  /// True if what has to be reached in so many rounds was.
  virtual bool HasReachedAll() const { return true; }
};

#endif
