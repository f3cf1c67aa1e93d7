// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Program/Memory.h"

#ifdef _WIN32
#define NOMINMAX
#include <windows.h>

double MemoryOfMachine()
{
  MEMORYSTATUSEX status = {};
  status.dwLength = sizeof(status);
  GlobalMemoryStatusEx(&status);
  return static_cast<double>(status.ullTotalPhys);
}

#else
#include <unistd.h>

double MemoryOfMachine()
{
  return static_cast<double>(sysconf(_SC_PAGESIZE)) * static_cast<double>(sysconf(_SC_PHYS_PAGES));
}

#endif
