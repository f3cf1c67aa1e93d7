// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_LayerShader_h
#define TemporalCoherence_LayerShader_h

#include "Scene/FrameKey.h"
#include "Scene/LayerBatch.h"
#include "Scene/TileHits.h"
#include "Shade/LayerCanvas.h"
#include "Shade/Light/SurfaceLight.h"
#include "Shade/Shader.h"

#include <cstddef>
#include <cstdint>

namespace TemporalCoherence
{

/// Normalised device coordinates of the pixels of a tile, row by row.
struct PixelCentres
{
  void Find(const View& view, const PixelRect& part)
  {
    std::size_t place = 0;
    for (int y = 0; y < part.Size.y; ++y)
    {
      const double ofRow = view.PixelCentre(0, part.First.y + y).y;
      for (int x = 0; x < part.Size.x; ++x, ++place)
      {
        // All rows have the same columns.
        this->X[place] =
          y == 0 ? view.PixelCentre(part.First.x + x, 0).x : this->X[static_cast<std::size_t>(x)];
        this->Y[place] = ofRow;
      }
    }
  }

  /// Append a surface to the next batch.
  /// \param place of its pixel
  void Append(const LayerHit& hit, std::size_t place, HitList& hits) const
  {
    const std::size_t at = hits.Rays.Count++;
    hits.Pixel[at] = hit.Pixel;
    hits.Surface[at] = hit.Isovalue;
    hits.Kind[at] = hit.Kind;
    hits.Cell[at] = hit.Cell;
    hits.X[at] = this->X[place];
    hits.Y[at] = this->Y[place];
    hits.Rays.T[at] = hit.Depth;
  }

  RayBatch::Array<double> X, Y;
};

/// Shades layers: finds their colours, normals and opacities.
class LayerShader
{
public:
  /// The arguments must outlive it.
  /// \param light that reaches the surfaces; null: all of it does
  LayerShader(const FrameKey& key, const NormalSource& source, SurfaceLight* light)
    : Key(key)
    , Source(source)
    , Light(light)
  {
  }

  /// Take found layers in the order of the search, in which layers of one cell lie together.
  /// \param centres of the tile; only read in a parallel view
  /// \param first   number of the first layer
  /// \param hits    gets as many layers as fit
  void TakeHits(
    const TileHits& found, const PixelCentres& centres, std::size_t first, HitList& hits) const;

  /// Shade surfaces whose points are known.
  /// \param shaded result: one for each surface
  void Shade(std::int64_t tile, HitList& hits, ShadedLayer* shaded) const;

private:
  const FrameKey& Key;
  const NormalSource& Source;
  SurfaceLight* Light;
};

}

#endif
