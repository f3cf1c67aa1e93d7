// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "RefusedMemory.h"

#include <cstdlib>
#include <limits>
#include <new>

namespace
{

constexpr std::int64_t All = std::numeric_limits<std::int64_t>::max();

thread_local std::int64_t AllowedCalls = All;

}

RefusedMemory::RefusedMemory(std::int64_t allowed)
{
  AllowedCalls = allowed;
}

RefusedMemory::~RefusedMemory()
{
  AllowedCalls = All;
}

// The program's own, which those for arrays call. All of them, as a sanitizer has others.

void* operator new(std::size_t bytes, const std::nothrow_t&) noexcept
{
  void* const memory = AllowedCalls > 0 ? std::malloc(bytes > 0 ? bytes : 1) : nullptr;
  AllowedCalls -= memory && AllowedCalls < All;
  return memory;
}

void* operator new(std::size_t bytes)
{
  void* const memory = operator new(bytes, std::nothrow);
  if (!memory)
  {
    throw std::bad_alloc();
  }
  return memory;
}

void operator delete(void* memory) noexcept
{
  std::free(memory);
}

void operator delete(void* memory, std::size_t) noexcept
{
  std::free(memory);
}
