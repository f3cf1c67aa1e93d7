// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Checks/ProcessMemory.h"

#include <fstream>
#include <limits>
#include <string>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace ProcessMemory
{
namespace
{

/// A line such as "VmRSS:   1234 kB".
double ReadStatus(const std::string& name)
{
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;)
  {
    double kibibytes = 0.0;
    if (word == name && status >> kibibytes)
    {
      return 1024.0 * kibibytes;
    }
    status.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
  }
  return std::numeric_limits<double>::quiet_NaN();
}

}

double Resident()
{
#ifdef __GLIBC__
  malloc_trim(0);
#endif
  return ReadStatus("VmRSS:");
}

double Peak()
{
  return ReadStatus("VmHWM:");
}

bool ResetPeak()
{
  std::ofstream file("/proc/self/clear_refs");
  file << "5\n";
  return static_cast<bool>(file.flush());
}

}
