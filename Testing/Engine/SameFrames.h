// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_SameFrames_h
#define Testing_SameFrames_h

#include "Scene/Frame.h"

#include <algorithm>
#include <cstring>

/// True if two planes of a frame are the same to the last bit: NaN is NaN, and 0 is not -0.
template <typename P>
bool IsSamePlane(const P& a, const P& b)
{
  return a.size() == b.size() && !std::memcmp(a.data(), b.data(), a.size() * sizeof(a[0]));
}

/// True if two frames show the same: all planes are equal except answers and those that only later
/// frames use.
inline bool ShowTheSame(const TemporalCoherence::Frame& a, const TemporalCoherence::Frame& b)
{
  return a.Size == b.Size && IsSamePlane(a.Depth, b.Depth) && IsSamePlane(a.Normals, b.Normals) &&
    IsSamePlane(a.Isovalues, b.Isovalues) && IsSamePlane(a.Kinds, b.Kinds) &&
    IsSamePlane(a.Colors, b.Colors);
}

/// True if two frames keep the same layers, in the same order.
inline bool HaveTheSameLayers(const TemporalCoherence::Frame& a, const TemporalCoherence::Frame& b)
{
  using TemporalCoherence::LayerHit;
  const auto isSameHit = [](const LayerHit& x, const LayerHit& y)
  {
    return x.Depth == y.Depth && x.Pixel == y.Pixel && x.Isovalue == y.Isovalue &&
      x.Kind == y.Kind && x.Color == y.Color;
  };
  using TemporalCoherence::LayersBehind;
  const auto areMergedAlike = [](const LayersBehind& x, const LayersBehind& y)
  { return x.Merged == y.Merged; };
  return a.LayersOfPixel == b.LayersOfPixel &&
    (a.Layers.empty() ||
      std::equal(
        a.Behind.begin(), a.Behind.end(), b.Behind.begin(), b.Behind.end(), areMergedAlike)) &&
    std::equal(a.Layers.begin(), a.Layers.end(), b.Layers.begin(), b.Layers.end(),
      [&](const std::vector<LayerHit>& x, const std::vector<LayerHit>& y)
      { return std::equal(x.begin(), x.end(), y.begin(), y.end(), isSameHit); });
}

#endif
