// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_ImpatientWork_h
#define TemporalCoherence_ImpatientWork_h

namespace TemporalCoherence
{

/// Work of a thread for which BrickCache::GiveUpAt counts. All other work waits for bricks.
class ImpatientWork
{
public:
  ImpatientWork();
  ~ImpatientWork();
  ImpatientWork(const ImpatientWork&) = delete;
  ImpatientWork& operator=(const ImpatientWork&) = delete;

  /// True if this thread does such work now.
  static bool IsHere();
};

}

#endif
