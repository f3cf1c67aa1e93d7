// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Structures of the data, and of the data and an isovalue.

#include "KernelBenchmarks.h"
#include "KernelScene.h"

namespace
{

using namespace TemporalCoherence;

/// Time the building of a structure from all samples of a scene.
template <typename T, typename Build>
void RunOnSamples(benchmark::State& state, const Build& build)
{
  const KernelScene<T>& scene = SceneOf<T>();
  for (auto _ : state)
  {
    build(scene);
    benchmark::ClobberMemory();
  }
  const auto samples = static_cast<std::int64_t>(scene.Waves.Samples.size());
  const auto builds = static_cast<std::int64_t>(state.iterations());
  state.SetItemsProcessed(builds * samples);
  state.SetBytesProcessed(builds * samples * static_cast<std::int64_t>(sizeof(T)));
}

template <typename T>
void RegisterFor(const std::string& type)
{
  KernelBenchmarks::ForEachTarget("BuildPyramid/" + type,
    [](benchmark::State& state)
    {
      RunOnSamples<T>(state,
        [](const KernelScene<T>& scene)
        {
          ValueRangePyramid pyramid;
          pyramid.Build(scene.Key.Samples);
        });
    });
  // Of this there is one kind.
  benchmark::RegisterBenchmark(("BuildActiveCells/" + type).c_str(),
    [](benchmark::State& state)
    {
      RunOnSamples<T>(state,
        [](const KernelScene<T>& scene)
        {
          ActiveCells active;
          active.Build(scene.Key.Samples, scene.Pyramid, scene.Key.Isosurfaces());
        });
    });
}

}

void KernelBenchmarks::RegisterStructures()
{
  RegisterFor<std::uint8_t>("bytes");
  RegisterFor<std::int16_t>("shorts");
  RegisterFor<float>("floats");
}
