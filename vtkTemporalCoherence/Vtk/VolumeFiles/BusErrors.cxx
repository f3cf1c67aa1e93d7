// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VolumeFiles/BusErrors.h"

#ifdef _WIN32

namespace TemporalCoherence
{

bool GuardedRange::Guard(const void* /*begin*/, std::size_t /*bytes*/)
{
  return false;
}

void GuardedRange::Release() {}

bool GuardedRange::IsBroken() const
{
  return false;
}

}

#else

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <mutex>

#include <sys/mman.h>
#include <unistd.h>

#ifndef MAP_ANONYMOUS
#define MAP_ANONYMOUS MAP_ANON
#endif

namespace TemporalCoherence
{
namespace
{

/// A signal handler may neither lock nor allocate: the list has a fixed size and atomic members.
struct Range
{
  std::atomic<std::uintptr_t> Begin{ 0 };
  std::atomic<std::uintptr_t> End{ 0 }; ///< 0: the slot is free
  std::atomic<bool> Broken{ false };
};

static_assert(std::atomic<std::uintptr_t>::is_always_lock_free, "the signal handler reads these");
static_assert(std::atomic<bool>::is_always_lock_free, "the signal handler writes these");

constexpr int NumberOfSlots = 512;
Range Slots[NumberOfSlots];
std::mutex SlotMutex; // for those who change the list, not for the handler
bool HasHandler = false;
struct sigaction Previous;
std::uintptr_t PageSize = 4096;

/// True if a range holds an address. The end is read twice, as the slot may change meanwhile.
bool Holds(const Range& range, std::uintptr_t address, std::uintptr_t& end)
{
  end = range.End.load();
  const std::uintptr_t begin = range.Begin.load();
  return address >= begin && address < end && range.End.load() == end;
}

/// Replace the rest of a guarded range by zeros. If the file became shorter, that is the part that
/// is lost; and mappings stay few, whatever the order of faults.
bool Repair(std::uintptr_t address)
{
  for (Range& range : Slots)
  {
    std::uintptr_t end = 0;
    if (Holds(range, address, end))
    {
      range.Broken.store(true);
      const std::uintptr_t page = address & ~(PageSize - 1);
      return ::mmap(reinterpret_cast<void*>(page), end - page, PROT_READ | PROT_WRITE,
               MAP_FIXED | MAP_PRIVATE | MAP_ANONYMOUS, -1, 0) != MAP_FAILED;
    }
  }
  return false;
}

/// Call the handler that the program had before ours, or act as the system does by default.
void CallPrevious(int signal, siginfo_t* about, void* context)
{
  const bool isFault = about->si_code > 0;
  if (Previous.sa_handler != SIG_DFL && Previous.sa_handler != SIG_IGN)
  {
    if ((Previous.sa_flags & SA_SIGINFO) != 0)
    {
      Previous.sa_sigaction(signal, about, context);
    }
    else
    {
      Previous.sa_handler(signal);
    }
    return;
  }
  if (Previous.sa_handler == SIG_IGN && !isFault)
  {
    return;
  }
  // The default ends the program: a fault occurs again after the return, other signals are sent
  // again. No fault can be ignored.
  std::signal(signal, SIG_DFL);
  if (!isFault)
  {
    ::raise(signal);
  }
}

void OnBusError(int signal, siginfo_t* about, void* context)
{
  const int oldErrno = errno;
  // A signal that a program sent has no address. Its code is not positive.
  const bool isRepaired =
    about->si_code > 0 && Repair(reinterpret_cast<std::uintptr_t>(about->si_addr));
  errno = oldErrno;
  if (!isRepaired)
  {
    CallPrevious(signal, about, context);
  }
}

/// Only once: a handler that was installed after ours may call ours.
bool InstallHandler()
{
  if (!HasHandler)
  {
    PageSize = static_cast<std::uintptr_t>(::sysconf(_SC_PAGESIZE));
    struct sigaction action = {};
    action.sa_sigaction = OnBusError;
    action.sa_flags = SA_SIGINFO | SA_ONSTACK;
    sigemptyset(&action.sa_mask);
    // Before ours is there, as a fault may occur at once.
    HasHandler =
      ::sigaction(SIGBUS, nullptr, &Previous) == 0 && ::sigaction(SIGBUS, &action, nullptr) == 0;
  }
  return HasHandler;
}

}

bool GuardedRange::Guard(const void* begin, std::size_t bytes)
{
  const std::lock_guard<std::mutex> lock(SlotMutex);
  if (this->Slot >= 0 || bytes == 0 || !InstallHandler())
  {
    return false;
  }
  for (int slot = 0; slot < NumberOfSlots; ++slot)
  {
    Range& range = Slots[slot];
    if (range.End.load() == 0)
    {
      range.Broken.store(false);
      range.Begin.store(reinterpret_cast<std::uintptr_t>(begin));
      range.End.store(reinterpret_cast<std::uintptr_t>(begin) + bytes);
      this->Slot = slot;
      return true;
    }
  }
  return false;
}

void GuardedRange::Release()
{
  if (this->Slot >= 0)
  {
    const std::lock_guard<std::mutex> lock(SlotMutex);
    Slots[this->Slot].End.store(0);
    this->Slot = -1;
  }
}

bool GuardedRange::IsBroken() const
{
  return this->Slot >= 0 && Slots[this->Slot].Broken.load();
}

}

#endif
