// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
// A viewer of isosurfaces and blended volumes: see --help.
#include "Window/Program.h"

int main(int argc, char* argv[])
{
  return RunExplorer(argc, argv);
}
