// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// The fuzzer that is guided by coverage: libFuzzer makes the bytes.

#include "Runs/Report.h"
#include "Runs/Run.h"
#include "World/Story.h"

#include <vtkSMPTools.h>

#include <cstdlib>
#include <exception>

extern "C" int LLVMFuzzerInitialize(int*, char***)
{
  vtkSMPTools::SetBackend("Sequential");
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  static Fuzz::Tally tally;
  const std::vector<std::uint8_t> bytes(data, data + size);
  Fuzz::Report::Begin(bytes, "FILE", tally);
  try
  {
    Fuzz::Run(bytes, tally);
  }
  catch (const std::exception& failure)
  {
    Fuzz::Report::TellFailure(failure.what());
    std::abort(); // libFuzzer writes the bytes to a file
  }
  return 0;
}
