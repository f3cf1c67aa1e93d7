// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Shade/RecoloredLayers.h"

namespace TemporalCoherence
{

RecoloredLayers::RecoloredLayers(
  const PixelRect& part, int width, std::uint64_t merged, std::vector<LayerHit>& layers)
  : Layers(layers)
{
  const PlaceFinder places(part, width);
  for (std::size_t i = 0; i < layers.size(); ++i)
  {
    const std::size_t place = places.Find(layers[i].Pixel);
    if (merged >> place & 1u)
    {
      this->Positions[this->Count[place]++][place] = static_cast<std::uint16_t>(i);
    }
  }
}

void RecoloredLayers::Keep(std::size_t place, const LayerHit& hit)
{
  std::uint8_t& now = this->Now[place];
  bool isKept = false;
  if (now + 1 < this->Count[place])
  {
    const LayerHit& next = this->Layers[this->Positions[now + std::size_t(1)][place]];
    isKept = hit.Depth == next.Depth && hit.Isovalue == next.Isovalue && hit.Kind == next.Kind;
    now = static_cast<std::uint8_t>(now + isKept);
  }
  this->Layers[this->Positions[now][place]].Color = hit.Color;
  ++this->Taken;
  this->MergedHere += !isKept;
}

}
