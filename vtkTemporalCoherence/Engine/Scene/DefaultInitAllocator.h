// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_DefaultInitAllocator_h
#define TemporalCoherence_DefaultInitAllocator_h

#include <memory>
#include <new>
#include <utility>

namespace TemporalCoherence
{

/// Default-initialises elements: numbers get no value. So the threads that fill a vector are the
/// first to touch its memory.
template <typename T>
struct DefaultInitAllocator : std::allocator<T>
{
  template <typename U>
  struct rebind
  {
    using other = DefaultInitAllocator<U>;
  };
  template <typename U>
  void construct(U* place) const
  {
    ::new (static_cast<void*>(place)) U;
  }
  template <typename U, typename... Arguments>
  void construct(U* place, Arguments&&... arguments) const
  {
    ::new (static_cast<void*>(place)) U(std::forward<Arguments>(arguments)...);
  }
};

}

#endif
