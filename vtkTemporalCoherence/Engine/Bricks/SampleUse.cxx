// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Bricks/SampleUse.h"

#include <algorithm>

namespace TemporalCoherence
{
namespace
{

std::atomic<std::uint64_t> Clock{ 1 };

}

std::atomic<SampleUse::Thread*> SampleUse::Threads{ nullptr };

/// Takes an entry of the list for a thread, and gives it back when the thread ends. Entries are
/// never freed: the list grows to the largest number of threads at one time.
struct SampleUse::Holder
{
  Holder()
  {
    for (Thread* entry = Threads.load(); entry; entry = entry->Next)
    {
      bool isTaken = false;
      if (entry->IsTaken.compare_exchange_strong(isTaken, true))
      {
        this->Entry = entry;
        return;
      }
    }
    this->Entry = new Thread;
    this->Entry->Next = Threads.load();
    while (!Threads.compare_exchange_weak(this->Entry->Next, this->Entry))
    {
    }
  }
  ~Holder()
  {
    this->Entry->Time.store(Nothing);
    this->Entry->Depth = 0;
    this->Entry->HasMissed = false;
    this->Entry->IsTaken.store(false);
  }
  Holder(const Holder&) = delete;
  Holder& operator=(const Holder&) = delete;

  Thread* Entry;
};

SampleUse::Thread& SampleUse::Own()
{
  thread_local const Holder holder;
  return *holder.Entry;
}

std::uint64_t SampleUse::BeginHere()
{
  const std::uint64_t time = ++Clock;
  Own().Time.store(time);
  return time;
}

SampleUse::SampleUse()
{
  Thread& own = Own();
  if (own.Depth++ == 0)
  {
    own.HasMissed = false;
    BeginHere();
  }
}

SampleUse::~SampleUse()
{
  Thread& own = Own();
  if (--own.Depth == 0)
  {
    own.Time.store(Nothing);
  }
}

void SampleUse::Renew()
{
  Thread& own = Own();
  if (own.Depth == 1)
  {
    own.HasMissed = false;
    BeginHere();
  }
}

void SampleUse::End()
{
  Thread& own = Own();
  if (own.Depth == 0)
  {
    own.Time.store(Nothing);
  }
}

std::uint64_t SampleUse::Now()
{
  return Clock.load();
}

std::uint64_t SampleUse::Oldest()
{
  // Stretches that begin after this line get later times.
  std::uint64_t oldest = Clock.load();
  for (const Thread* entry = Threads.load(); entry; entry = entry->Next)
  {
    oldest = std::min(oldest, entry->Time.load());
  }
  return oldest;
}

}
