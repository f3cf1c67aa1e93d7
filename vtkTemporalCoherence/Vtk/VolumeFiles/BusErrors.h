// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_BusErrors_h
#define TemporalCoherence_BusErrors_h

#include <cstddef>

namespace TemporalCoherence
{

/// A range of addresses that is guarded against bus errors. Reading a mapped file raises the signal
/// SIGBUS if the file became shorter or its disk fails, which ends the program by default. The
/// first guard installs a handler. A fault in a guarded range marks the range as broken, and the
/// range reads as zero from the fault's page to its end. The earlier handler gets other faults.
///
/// The system itself does not raise the signal: write() from a broken range fails with EFAULT.
class GuardedRange
{
public:
  GuardedRange() = default;
  ~GuardedRange() { this->Release(); }
  GuardedRange(const GuardedRange&) = delete;
  GuardedRange& operator=(const GuardedRange&) = delete;

  /// Guard a range. To be called before it is read.
  /// \param begin the first address of a mapping
  /// \param bytes of the mapping
  /// \return false if the range cannot be guarded: too many are, or the system has no such signals
  bool Guard(const void* begin, std::size_t bytes);

  /// To be called after the last reading, but before the addresses are unmapped.
  void Release();

  /// True once a fault occurred in the range. Thread-safe.
  bool IsBroken() const;

private:
  int Slot = -1; ///< in the list that the handler searches
};

}

#endif
