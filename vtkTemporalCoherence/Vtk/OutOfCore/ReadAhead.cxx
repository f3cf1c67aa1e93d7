// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OutOfCore/ReadAhead.h"

#include <algorithm>
#include <new>
#include <system_error>
#include <utility>

namespace TemporalCoherence
{

ReadAhead::ReadAhead(std::shared_ptr<const BrickCache> bricks)
  : Bricks(std::move(bricks))
{
}

ReadAhead::~ReadAhead()
{
  {
    const std::lock_guard<std::mutex> lock(this->Guard);
    this->IsOver = true;
  }
  this->HasWork.notify_all();
  if (this->Thread.joinable())
  {
    this->Thread.join();
  }
}

void ReadAhead::Want(std::vector<std::int64_t> bricks)
{
  const std::lock_guard<std::mutex> lock(this->Guard);
  std::reverse(bricks.begin(), bricks.end());
  this->Wanted = std::move(bricks);
  ++this->Wish;
  if (this->Wanted.empty())
  {
    return;
  }
  try
  {
    if (!this->Thread.joinable())
    {
      this->Thread = std::thread([this]() { this->Work(); });
    }
  }
  catch (const std::system_error&)
  {
    this->Wanted.clear(); // no thread: frames wait for what they need
  }
  this->HasWork.notify_all();
}

void ReadAhead::Work()
{
  std::unique_lock<std::mutex> lock(this->Guard);
  while (!this->IsOver)
  {
    if (this->Wanted.empty())
    {
      this->HasWork.wait(lock);
      continue;
    }
    const std::int64_t brick = this->Wanted.back();
    const std::uint64_t wish = this->Wish;
    this->Wanted.pop_back();
    lock.unlock();
    bool hasRoom = false;
    try
    {
      hasRoom = this->Bricks->ReadAhead(brick);
    }
    catch (const std::bad_alloc&)
    {
    }
    lock.lock();
    if (!hasRoom && this->Wish == wish)
    {
      this->Wanted.clear();
    }
  }
}

}
