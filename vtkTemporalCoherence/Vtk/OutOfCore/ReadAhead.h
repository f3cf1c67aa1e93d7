// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_ReadAhead_h
#define TemporalCoherence_ReadAhead_h

#include "Bricks/BrickCache.h"

#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

namespace TemporalCoherence
{

/// Reads bricks before they are needed, in a thread of its own. What a moving camera uncovers, and
/// where a surface moves, lies beside what the last frame had to wait for.
class ReadAhead
{
public:
  explicit ReadAhead(std::shared_ptr<const BrickCache> bricks);
  ~ReadAhead();
  ReadAhead(const ReadAhead&) = delete;
  ReadAhead& operator=(const ReadAhead&) = delete;

  /// Read these bricks, in this order. Forget earlier wishes.
  void Want(std::vector<std::int64_t> bricks);

private:
  void Work();

  std::shared_ptr<const BrickCache> Bricks;
  std::mutex Guard; ///< of what follows
  std::condition_variable HasWork;
  std::vector<std::int64_t> Wanted; ///< the next one is the last
  std::uint64_t Wish = 0;           ///< number of calls of Want
  bool IsOver = false;
  std::thread Thread; ///< begins with the first wanted brick
};

}

#endif
