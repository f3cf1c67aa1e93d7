// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Render/SavedColors.h"

#include <algorithm>
#include <cstddef>

namespace TemporalCoherence
{
namespace
{

/// Copy the pixels of a rectangle from one plane to another.
template <typename Colors>
void CopyPixels(const PixelRect& part, int width, const Colors& from, Colors& to)
{
  for (int row = 0; row < part.Size.y; ++row)
  {
    const std::ptrdiff_t first =
      static_cast<std::ptrdiff_t>(part.First.y + row) * width + part.First.x;
    std::copy_n(from.begin() + first, part.Size.x, to.begin() + first);
  }
}

}

SavedColors::SavedColors(Frame& picture)
  : Picture(picture)
  , Colors(picture.Colors.size())
  , OfLayers(picture.Layers.size())
  , IsSaved(picture.ClearTiles.size(), std::uint8_t(0))
{
}

SavedColors::~SavedColors()
{
  for (std::size_t tile = 0; tile < this->IsSaved.size(); ++tile)
  {
    if (this->IsSaved[tile])
    {
      const PixelRect part = PixelsOfTile(this->Picture.Size, static_cast<std::int64_t>(tile));
      CopyPixels(part, this->Picture.Size.x, this->Colors, this->Picture.Colors);
      for (std::size_t i = 0; tile < this->OfLayers.size() && i < this->OfLayers[tile].size(); ++i)
      {
        this->Picture.Layers[tile][i].Color = this->OfLayers[tile][i];
      }
    }
  }
}

void SavedColors::Save(std::int64_t tile, const PixelRect& part)
{
  const auto place = static_cast<std::size_t>(tile);
  if (this->Picture.ClearTiles[place])
  {
    return; // nothing will be written
  }
  if (place < this->OfLayers.size())
  {
    const std::vector<LayerHit>& layers = this->Picture.Layers[place];
    this->OfLayers[place].resize(layers.size());
    std::transform(layers.begin(), layers.end(), this->OfLayers[place].begin(),
      [](const LayerHit& layer) { return layer.Color; });
  }
  CopyPixels(part, this->Picture.Size.x, this->Picture.Colors, this->Colors);
  this->IsSaved[place] = 1;
}

}
