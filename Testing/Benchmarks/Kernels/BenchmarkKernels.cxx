// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Times single kernels of the engine for each kind of vectors that this machine has, on one thread,
// by Google Benchmark, whose options apply.

#include "KernelBenchmarks.h"

#include <vtkSMPTools.h>

int main(int argc, char* argv[])
{
  vtkSMPTools::SetBackend("Sequential");
  KernelBenchmarks::RegisterCells();
  KernelBenchmarks::RegisterCrossings();
  KernelBenchmarks::RegisterShading();
  KernelBenchmarks::RegisterImages();
  KernelBenchmarks::RegisterTiles();
  KernelBenchmarks::RegisterStructures();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv))
  {
    return 1;
  }
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
