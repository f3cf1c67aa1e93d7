// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Sanitized_h
#define Testing_Sanitized_h

// Clang tells of sanitizers by features, GCC by names.
#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer) ||                         \
  __has_feature(memory_sanitizer)
#define TESTING_HAS_OTHER_MEMORY
#endif
#elif defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define TESTING_HAS_OTHER_MEMORY
#endif

/// True if a sanitizer manages memory. It reserves terabytes of addresses, so that no limit can be
/// set, and too large an allocation ends the program instead of throwing std::bad_alloc.
#ifdef TESTING_HAS_OTHER_MEMORY
constexpr bool IsMemorySanitized = true;
#else
constexpr bool IsMemorySanitized = false;
#endif

#endif
