// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Segments of rays through cells.

#include "KernelBenchmarks.h"
#include "KernelScene.h"
#include "Lattice/KernelsCrossing.h"
#include "Lattice/KernelsRange.h"
#include "Scene/Difference.h"

namespace
{

using namespace TemporalCoherence;

/// The segments through the cells in which the rays of full tiles meet the surface.
template <typename T>
std::vector<SegmentBatch<RealOf<T>>> SegmentsOf(const KernelScene<T>& scene)
{
  const Difference<T> fromIsovalue(KernelScene<T>::Isovalue, scene.Scene.FiniteRange);
  const TypedField<T> samples(scene.Key.Samples);
  std::vector<SegmentBatch<RealOf<T>>> batches;
  for (const auto& tile : scene.FullTiles)
  {
    SegmentBatch<RealOf<T>> batch;
    for (std::size_t ray = 0; ray < RayBatch::Capacity; ++ray)
    {
      glm::ivec3 cell;
      for (int a = 0; a < 3; ++a)
      {
        const auto axis = static_cast<std::size_t>(a);
        const double at =
          tile.Rays.Origin[axis][ray] + tile.Hits.Depth[ray] * tile.Rays.Direction[axis][ray];
        cell[a] = std::clamp(static_cast<int>(at), 0, samples.Dimensions[a] - 2);
      }
      std::array<RealOf<T>, 8> corners;
      for (int corner = 0; corner < 8; ++corner)
      {
        const glm::ivec3 sample = cell + glm::ivec3(corner & 1, corner >> 1 & 1, corner >> 2);
        corners[static_cast<std::size_t>(corner)] = fromIsovalue(*samples.At(sample));
      }
      AppendSegment(tile.Rays, ray, cell, corners, batch);
    }
    batches.push_back(batch);
  }
  return batches;
}

template <typename T>
void RegisterFor(const std::string& type)
{
  using Batch = SegmentBatch<RealOf<T>>;
  KernelBenchmarks::ForEachTarget("FindCrossings/" + type,
    [](benchmark::State& state)
    {
      auto batches = SegmentsOf(SceneOf<T>());
      KernelBenchmarks::RunOnTiles(
        state, batches, [](Batch& batch) { FindCrossings(batch, false); });
    });
  KernelBenchmarks::ForEachTarget("FindNearestCrossings/" + type,
    [](benchmark::State& state)
    {
      auto batches = SegmentsOf(SceneOf<T>());
      KernelBenchmarks::RunOnTiles(
        state, batches, [](Batch& batch) { FindNearestCrossings(batch); });
    });
  KernelBenchmarks::ForEachTarget("FindRanges/" + type,
    [](benchmark::State& state)
    {
      auto batches = SegmentsOf(SceneOf<T>());
      RangeBatch<RealOf<T>> ranges;
      KernelBenchmarks::RunOnTiles(
        state, batches, [&](Batch& batch) { FindRanges(batch, ranges); });
    });
}

}

void KernelBenchmarks::RegisterCrossings()
{
  RegisterFor<std::uint8_t>("bytes");
  RegisterFor<float>("floats");
}
