// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "UserError.h"

#include <cstdio>
#include <exception>

int RunProgram(const char* name, const std::function<void()>& program)
{
  try
  {
    program();
  }
  catch (const UserError& mistake)
  {
    std::fflush(stdout);
    std::fprintf(stderr, "%s: %s\n", name, mistake.what());
    return 1;
  }
  catch (const std::exception& failure)
  {
    std::fflush(stdout);
    std::fprintf(stderr, "%s: %s; try a smaller --size or volume.\n", name, failure.what());
    return 1;
  }
  return 0;
}
