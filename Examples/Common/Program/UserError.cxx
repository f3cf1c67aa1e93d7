// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Program/UserError.h"

#include "Program/Quoted.h"

#include <cstdio>
#include <exception>
#include <new>

std::string SentenceOf(const std::exception& failure)
{
  if (dynamic_cast<const UserError*>(&failure))
  {
    return Printable(failure.what());
  }
  if (dynamic_cast<const std::bad_alloc*>(&failure))
  {
    return "There is not enough memory for this; choose a smaller volume or picture.";
  }
  return Printable(failure.what()) + "; choose a smaller volume or picture.";
}

int RunProgram(const char* name, const std::function<void()>& program)
{
  try
  {
    program();
  }
  catch (const std::exception& failure)
  {
    std::fflush(stdout);
    std::fprintf(stderr, "%s: %s\n", name, SentenceOf(failure).c_str());
    return 1;
  }
  return 0;
}
