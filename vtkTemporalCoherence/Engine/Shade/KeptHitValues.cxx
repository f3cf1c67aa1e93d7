// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Shade/KeptHitValues.h"

#include "Scene/Tiles.h"
#include "Shade/HitValues.h"
#include "Shade/Shader.h"

#include <algorithm>
#include <cstddef>
#include <new>

namespace TemporalCoherence
{

bool KeptHitValues::Begin(const FrameKey& key, bool areHitsOfLast)
{
  const auto& byArray = key.Appearance.ByArray;
  if (!areHitsOfLast || !byArray || key.Isosurfaces().IsTranslucent())
  {
    *this = {};
    return false;
  }
  if (!this->Of || !this->Of->IsSame(*byArray->Values))
  {
    *this = {};
    this->Of = byArray->Values;
    return false;
  }
  const auto tiles = static_cast<std::size_t>(NumberOfTiles(key.View.Size));
  try
  {
    this->Values.resize(tiles * RayBatch::Capacity);
    this->AreKnown.resize(tiles, 0);
  }
  catch (const std::bad_alloc&)
  {
    *this = {}; // the frame does without
    return false;
  }
  return true;
}

void KeptHitValues::Find(const FrameKey& key, std::int64_t tile, HitList& hits)
{
  const auto place = static_cast<std::size_t>(tile);
  double* const kept = &this->Values[place * RayBatch::Capacity];
  if (this->AreKnown[place])
  {
    std::copy_n(kept, hits.Rays.Count, hits.Values.begin());
    return;
  }
  FindHitValues(key, hits);
  std::copy_n(hits.Values.begin(), hits.Rays.Count, kept);
  this->AreKnown[place] = 1;
}

}
