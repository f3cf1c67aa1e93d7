// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Shade/Light/LightTracer.h"

#include "Lattice/RayPieces.h"
#include "Scene/LayerBatch.h"
#include "Shade/HitOpacities.h"
#include "Shade/HitValues.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace TemporalCoherence
{
namespace
{

/// Where rays begin, per shortest edge of a cell.
constexpr double FirstStep = 1e-3;

/// A direction component smaller than this share of the largest one is raised to it, keeping its
/// sign, so that its inverse is finite.
constexpr double SmallestShare = 1e-15;

}

LightTracer::LightTracer(
  const FrameKey& key, const NormalSource& source, std::shared_ptr<const SurfaceTracer> tracer)
  : Key(key)
  , Source(source)
  , Tracer(std::move(tracer))
  , Clipper(key.Region, key.Transform)
  , Alphas(AlphasOf(key.Isosurfaces()))
  , Begin(FirstStep * key.Samples.Shape->VoxelSizeIn(key.Transform).Shortest)
{
}

void LightTracer::SetUp(const LightRays& rays, RayBatch& batch) const
{
  const glm::dmat4& toIndex = this->Key.Transform.IndexFromWorld;
  batch.Count = static_cast<int>(rays.Count);
  batch.PerDepth.fill(0.0); // of no view
  for (std::size_t i = 0; i < rays.Count; ++i)
  {
    batch.Begin[i] = this->Begin;
    batch.End[i] = rays.Length[i];
  }
  for (int a = 0; a < 3; ++a)
  {
    const auto axis = static_cast<std::size_t>(a);
    const double x = toIndex[0][a], y = toIndex[1][a], z = toIndex[2][a], w = toIndex[3][a];
    const double last = this->Key.Samples.Dimensions[a] - 1;
    // Directions are of unit length in the world.
    const double least = SmallestShare * (std::abs(x) + std::abs(y) + std::abs(z));
    for (std::size_t i = 0; i < rays.Count; ++i)
    {
      const double origin =
        x * rays.Origin[0][i] + y * rays.Origin[1][i] + z * rays.Origin[2][i] + w;
      double direction =
        x * rays.Direction[0][i] + y * rays.Direction[1][i] + z * rays.Direction[2][i];
      direction = std::abs(direction) < least ? std::copysign(least, direction) : direction;
      const double inverse = 1.0 / direction;
      const double one = -origin * inverse, other = (last - origin) * inverse;
      batch.Begin[i] = std::max(batch.Begin[i], std::min(one, other));
      batch.End[i] = std::min(batch.End[i], std::max(one, other));
      batch.Origin[axis][i] = origin;
      batch.Direction[axis][i] = direction;
      batch.Inverse[axis][i] = inverse;
    }
  }
  batch.WalkBegin = batch.Begin;
  batch.WalkEnd = batch.End;
  if (!this->Clipper.IsWhole())
  {
    this->Clipper.Narrow(batch);
  }
  for (std::size_t a = 0; a < 3; ++a)
  {
    FillLastVector(rays.Count, batch.Origin[a]);
    FillLastVector(rays.Count, batch.Direction[a]);
    FillLastVector(rays.Count, batch.Inverse[a]);
  }
  FillLastVector(rays.Count, batch.Begin);
  FillLastVector(rays.Count, batch.End);
  FillLastVector(rays.Count, batch.WalkBegin);
  FillLastVector(rays.Count, batch.WalkEnd);
}

std::int64_t LightTracer::Trace(const LightRays& rays, RayBatch::Array<float>& passed) const
{
  RayBatch batch;
  this->SetUp(rays, batch);
  return this->Key.Isosurfaces().IsTranslucent() ? this->TraceLayers(rays, batch, passed)
                                                 : this->TraceOpaque(batch, passed);
}

std::int64_t LightTracer::TraceOpaque(const RayBatch& batch, RayBatch::Array<float>& passed) const
{
  std::int64_t cells = 0;
  std::uint64_t blocked = 0;
  if (this->Clipper.HasPieces())
  {
    // A later piece may begin inside a solid, far from any surface: only Trace finds its cap.
    HitBatch hits;
    hits.Clear(batch.Count);
    FindInPieces(this->Clipper, batch, hits,
      [this](const RayBatch& part, HitBatch& found) { this->Tracer->Trace(part, found); });
    cells = hits.CellsRead;
    for (std::size_t i = 0; i < static_cast<std::size_t>(batch.Count); ++i)
    {
      blocked |= static_cast<std::uint64_t>(hits.Kind[i] != HitKind::None) << i;
    }
  }
  else
  {
    blocked = this->Tracer->FindBlocked(batch, cells);
  }
  for (std::size_t i = 0; i < static_cast<std::size_t>(batch.Count); ++i)
  {
    passed[i] = (blocked >> i & 1u) != 0 ? 0.0f : 1.0f;
  }
  return cells;
}

void LightTracer::FindOpacities(HitList& hits, RayBatch::Array<float>& opacities) const
{
  const Surfaces& surfaces = this->Key.Isosurfaces();
  std::array<RayBatch::Array<double>, 3> gradients;
  if (!surfaces.ByGradient.Nodes.empty())
  {
    ComputeNormals(this->Source, hits, &gradients);
  }
  if (surfaces.ByArray)
  {
    FindHitValues(this->Key, hits);
  }
  FindHitOpacities(surfaces, hits, gradients, opacities);
}

std::int64_t LightTracer::TraceLayers(
  const LightRays& rays, const RayBatch& batch, RayBatch::Array<float>& passed) const
{
  std::fill_n(passed.begin(), rays.Count, 1.0f);
  LayerBatch layers;
  layers.Begin(rays.Count, this->Alphas);
  std::int64_t cells = 0;
  do
  {
    FindLayersWithin(this->Clipper, *this->Tracer, batch, layers);
    cells += layers.CellsRead;
    for (std::size_t first = 0; first < layers.Total; first += RayBatch::Capacity)
    {
      HitList hits;
      const std::size_t count =
        std::min(layers.Total - first, static_cast<std::size_t>(RayBatch::Capacity));
      hits.Rays.Count = count;
      hits.Rays.AreApart = true;
      for (std::size_t i = 0; i < count; ++i)
      {
        const std::size_t ray = layers.Ray[first + i];
        hits.Surface[i] = layers.Surface[first + i];
        hits.Kind[i] = layers.Kind[first + i];
        hits.Cell[i] = layers.Cell[first + i];
        hits.Rays.T[i] = layers.Distance[first + i];
        for (std::size_t a = 0; a < 3; ++a)
        {
          hits.Rays.Begin[a][i] = rays.Origin[a][ray];
          hits.Rays.Own[a][i] = rays.Direction[a][ray];
        }
      }
      FillLastVector(count, hits.Rays.T);
      for (std::size_t a = 0; a < 3; ++a)
      {
        FillLastVector(count, hits.Rays.Begin[a]);
        FillLastVector(count, hits.Rays.Own[a]);
      }
      RayBatch::Array<float> opacities;
      this->FindOpacities(hits, opacities);
      for (std::size_t i = 0; i < count; ++i)
      {
        float& ofRay = passed[layers.Ray[first + i]];
        ofRay = PassedBehind(ofRay, opacities[i]);
      }
    }
  } while (layers.BeginNext(rays.Count, passed));
  return cells;
}

}
