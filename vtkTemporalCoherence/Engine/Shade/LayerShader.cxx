// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Shade/LayerShader.h"

#include "Shade/HitOpacities.h"
#include "Shade/HitValues.h"

#include <algorithm>
#include <array>

namespace TemporalCoherence
{

void LayerShader::TakeHits(
  const TileHits& found, const PixelCentres& centres, std::size_t first, HitList& hits) const
{
  const LayerBatch& layers = found.Layers;
  const std::size_t count =
    std::min(layers.Total - first, static_cast<std::size_t>(RayBatch::Capacity));
  hits.Rays.Count = count;
  std::copy_n(layers.Surface.begin() + first, count, hits.Surface.begin());
  std::copy_n(layers.Kind.begin() + first, count, hits.Kind.begin());
  std::copy_n(layers.Cell.begin() + first, count, hits.Cell.begin());
  std::copy_n(layers.Distance.begin() + first, count, hits.Rays.T.begin());
  const auto take = [&](const auto& from, auto& to)
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      to[i] = from[layers.Ray[first + i]];
    }
  };
  take(found.Rays.Pixel, hits.Pixel);
  if (this->Key.View.Parallel)
  {
    take(centres.X, hits.X);
    take(centres.Y, hits.Y);
    FindHitRays(this->Key.View, hits);
    return;
  }
  hits.Rays.Eye = this->Key.View.Origin;
  for (std::size_t a = 0; a < 3; ++a)
  {
    take(found.World[a], hits.Rays.Own[a]);
    FillLastVector(count, hits.Rays.Own[a]);
  }
  FillLastVector(count, hits.Rays.T);
}

void LayerShader::Shade(std::int64_t tile, HitList& hits, ShadedLayer* shaded) const
{
  const Surfaces& surfaces = this->Key.Isosurfaces();
  std::array<RayBatch::Array<double>, 3> gradients;
  ComputeNormals(this->Source, hits, surfaces.ByGradient.Nodes.empty() ? nullptr : &gradients);
  FindHitValues(this->Key, hits);
  RayBatch::Array<float> opacities;
  FindHitOpacities(surfaces, hits, gradients, opacities);
  ArrivingLight arriving;
  if (this->Light)
  {
    this->Light->Find(tile, hits, false, arriving);
  }
  ShadingKernels::PhongSums sums;
  SumLight(this->Key.Appearance, hits, this->Light ? &arriving : nullptr, sums);
  for (std::size_t i = 0; i < hits.Rays.Count; ++i)
  {
    shaded[i] = { { sums.Sum[0][i], sums.Sum[1][i], sums.Sum[2][i] }, hits.Normal[i],
      opacities[i] };
  }
}

}
