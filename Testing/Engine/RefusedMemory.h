// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_RefusedMemory_h
#define Testing_RefusedMemory_h

#include <cstdint>

/// As long as one of these lives, the operator new of the thread throws std::bad_alloc after some
/// calls. (Memory of a higher alignment than usual is not counted.)
class RefusedMemory
{
public:
  /// \param allowed calls before the first one that throws
  explicit RefusedMemory(std::int64_t allowed);
  ~RefusedMemory();

  RefusedMemory(const RefusedMemory&) = delete;
  RefusedMemory& operator=(const RefusedMemory&) = delete;
};

#endif
