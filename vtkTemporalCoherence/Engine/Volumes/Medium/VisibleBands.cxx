// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Volumes/Medium/VisibleBands.h"

#include <cmath>
#include <cstddef>
#include <limits>

namespace TemporalCoherence
{
namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();

}

std::vector<ValueBand> OpaqueBands(const TransferFunction& transfer)
{
  const std::vector<glm::dvec4>& nodes = transfer.Nodes;
  const std::size_t last = nodes.size() - 1;
  const double step = (transfer.Range.y - transfer.Range.x) / static_cast<double>(last);
  const auto valueAt = [&](std::size_t node)
  { return transfer.Range.x + static_cast<double>(node) * step; };
  std::vector<ValueBand> bands;
  for (std::size_t node = 0; node <= last; ++node)
  {
    if (nodes[node].w > 0.0)
    {
      // Opacity extends from a node to both of its neighbours.
      const double low = node == 0 ? -Infinity : std::nextafter(valueAt(node - 1), -Infinity);
      const double high = node == last ? Infinity : std::nextafter(valueAt(node + 1), Infinity);
      if (!bands.empty() && low <= bands.back().High)
      {
        bands.back().High = high;
      }
      else
      {
        bands.push_back({ low, high });
      }
    }
  }
  return bands;
}

std::optional<std::vector<ValueBand>> VisibleBands(const Blending& blending)
{
  if (blending.Looks.size() != 1 || !blending.Others.empty())
  {
    return std::nullopt;
  }
  switch (blending.Mode)
  {
    case BlendMode::Composite:
    case BlendMode::Additive: // elsewhere its picture is black
      return OpaqueBands(blending.Looks.front().Transfer);
    case BlendMode::Average:
      return std::vector<ValueBand>{ { blending.AverageRange.x,
        std::nextafter(blending.AverageRange.y, Infinity) } };
    case BlendMode::Maximum:
    case BlendMode::Minimum:
    {
      const ValueBand seen = VisibleExtremes(blending);
      if (seen == ValueBand{ -Infinity, Infinity })
      {
        return std::nullopt;
      }
      return seen.Low <= seen.High ? std::vector<ValueBand>{ seen } : std::vector<ValueBand>();
    }
    default:
      return std::nullopt;
  }
}

ValueBand VisibleExtremes(const Blending& blending)
{
  if (blending.Looks.size() != 1)
  {
    return { -Infinity, Infinity };
  }
  const std::vector<ValueBand> bands = OpaqueBands(blending.Looks.front().Transfer);
  if (bands.empty())
  {
    return { Infinity, -Infinity };
  }
  // In a maximum, a larger value replaces a smaller one even if it is transparent.
  return blending.Mode == BlendMode::Maximum ? ValueBand{ bands.front().Low, Infinity }
                                             : ValueBand{ -Infinity, bands.back().High };
}

}
