// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Benchmarks_KernelBenchmarks_h
#define Benchmarks_KernelBenchmarks_h

#include "Checks/VectorTarget.h"

#include <benchmark/benchmark.h>

#include <string>

/// Benchmarks of single kernels, registered group by group. Items are rays, segments, hits or
/// pixels of a tile; of structures, samples.
namespace KernelBenchmarks
{

void RegisterCells();
void RegisterCrossings();
void RegisterImages();
void RegisterShading();
void RegisterStructures();
void RegisterTiles();

/// Register a benchmark for each kind of vectors, as name/kind.
template <typename Run>
void ForEachTarget(const std::string& name, const Run& run)
{
  for (const std::int64_t target : VectorTarget::All())
  {
    benchmark::RegisterBenchmark((name + "/" + hwy::TargetName(target)).c_str(),
      [run, target](benchmark::State& state)
      {
        const VectorTarget chosen(target);
        run(state);
      });
  }
}

/// Time a kernel on one tile after the other, so that no branch is learnt by heart.
/// \param tiles  not empty
/// \param kernel called with a tile, of 64 items
template <typename Tiles, typename Kernel>
void RunOnTiles(benchmark::State& state, Tiles& tiles, const Kernel& kernel)
{
  constexpr std::int64_t itemsInTile = 64;
  std::size_t next = 0;
  for (auto _ : state)
  {
    kernel(tiles[next]);
    benchmark::ClobberMemory();
    next = next + 1 < tiles.size() ? next + 1 : 0;
  }
  state.SetItemsProcessed(itemsInTile * static_cast<std::int64_t>(state.iterations()));
}

}

#endif
