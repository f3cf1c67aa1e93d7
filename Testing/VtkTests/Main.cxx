// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TestDriver.h"

/// The test, whose own name the compiler is told to replace by this.
int RunTest(int argc, char* argv[]);

int main(int argc, char* argv[])
{
  return DriveTest(argc, argv, RunTest);
}
