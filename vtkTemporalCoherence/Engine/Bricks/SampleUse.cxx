// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Bricks/SampleUse.h"

namespace TemporalCoherence
{

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
    Forget(*this->Entry);
    this->Entry->Depth = 0;
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

void SampleUse::List(Thread& own, const void* cache, std::int64_t brick)
{
  const std::lock_guard<std::mutex> lock(own.Guard);
  own.Listed.emplace_back(cache, brick);
}

/// End a stretch.
void SampleUse::Forget(Thread& own)
{
  own.HasMissed = false;
  if (!own.Listed.empty())
  {
    ++own.Stretch;
    const std::lock_guard<std::mutex> lock(own.Guard);
    own.Listed.clear();
  }
}

SampleUse::SampleUse()
{
  Thread& own = Own();
  if (own.Depth++ == 0)
  {
    Forget(own);
  }
}

SampleUse::~SampleUse()
{
  Thread& own = Own();
  if (--own.Depth == 0)
  {
    Forget(own);
  }
}

void SampleUse::Renew()
{
  Thread& own = Own();
  if (own.Depth == 1)
  {
    Forget(own);
  }
}

void SampleUse::End()
{
  Thread& own = Own();
  if (own.Depth == 0)
  {
    Forget(own);
  }
}

std::vector<std::int64_t> SampleUse::HeldOf(const void* cache)
{
  std::vector<std::int64_t> held;
  for (Thread* entry = Threads.load(); entry; entry = entry->Next)
  {
    const std::lock_guard<std::mutex> lock(entry->Guard);
    for (const auto& [of, brick] : entry->Listed)
    {
      if (of == cache)
      {
        held.push_back(brick);
      }
    }
  }
  return held;
}

}
