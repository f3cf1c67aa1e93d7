// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Runs/Shrink.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace Fuzz
{
namespace
{

using RunBytes = std::vector<std::uint8_t>;

/// True if a run fails, or crashes, in a process of its own.
bool FailsApart(const RunBytes& bytes, const std::function<bool(const RunBytes&)>& fails)
{
  const pid_t child = fork();
  if (child == 0)
  {
    const int nowhere = open("/dev/null", O_WRONLY);
    dup2(nowhere, STDOUT_FILENO);
    dup2(nowhere, STDERR_FILENO);
    std::_Exit(fails(bytes) ? EXIT_FAILURE : EXIT_SUCCESS);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return status != 0;
}

}

std::vector<std::uint8_t> Shrink(
  std::vector<std::uint8_t> bytes, const std::function<bool(const RunBytes&)>& fails)
{
  const auto accept = [&](const RunBytes& next)
  {
    const bool isShrunk = next != bytes && FailsApart(next, fails);
    if (isShrunk)
    {
      bytes = next;
    }
    return isShrunk;
  };
  bool isShrunk = true;
  while (isShrunk)
  {
    isShrunk = false;
    for (std::size_t length = bytes.size() / 2; length >= 1; length /= 2)
    {
      // From the end on, so that what comes before keeps its meaning.
      for (std::size_t at = bytes.size(); at >= length; at -= std::min(at, length))
      {
        RunBytes without = bytes;
        const auto begin = without.begin() + static_cast<std::ptrdiff_t>(at - length);
        without.erase(begin, begin + static_cast<std::ptrdiff_t>(length));
        if (accept(without))
        {
          isShrunk = true;
        }
        else
        {
          RunBytes dull = bytes;
          std::fill_n(
            dull.begin() + static_cast<std::ptrdiff_t>(at - length), length, std::uint8_t(0));
          isShrunk = accept(dull) || isShrunk;
        }
        at = std::min(at, bytes.size());
        if (at < length || at == 0)
        {
          break;
        }
      }
    }
  }
  return bytes;
}

}
