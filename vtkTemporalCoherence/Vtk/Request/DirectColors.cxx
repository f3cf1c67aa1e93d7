// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Request/DirectColors.h"

#include <cassert>
#include <limits>

namespace TemporalCoherence
{
namespace
{

/// The values whose shares are 0 and 1.
glm::dvec2 SharesOf(ScalarType type, const glm::dvec2& ofData)
{
  switch (type)
  {
    case ScalarType::Int8:
      return { 0.0, std::numeric_limits<std::int8_t>::max() };
    case ScalarType::UInt8:
      return { 0.0, std::numeric_limits<std::uint8_t>::max() };
    case ScalarType::Int16:
      return { 0.0, std::numeric_limits<std::int16_t>::max() };
    case ScalarType::UInt16:
      return { 0.0, std::numeric_limits<std::uint16_t>::max() };
    case ScalarType::Float32:
      return { 0.0, 1.0 };
    default:
      return ofData;
  }
}

/// Maps a value linearly from the range of the data to the range of shares.
double Stretched(double value, const glm::dvec2& ofData, const glm::dvec2& shares)
{
  return shares.x + (value - ofData.x) / (ofData.y - ofData.x) * (shares.y - shares.x);
}

}

void ShowDirectColors(ScalarType type, Blending& volume)
{
  assert(volume.Use == ComponentUse::RgbOpacity);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const std::vector<glm::dvec2> ofData = volume.ScalarRanges;
  for (glm::dvec2& range : volume.ScalarRanges)
  {
    range = SharesOf(type, range);
  }

  // A range without width has a single value and cannot be stretched.
  const glm::dvec2 &opacities = ofData.back(), &first = ofData.front();
  glm::dvec2& transfer = volume.Looks.front().Transfer.Range;
  if (opacities.x < opacities.y)
  {
    const glm::dvec2& shares = volume.ScalarRanges.back();
    transfer = { Stretched(transfer.x, opacities, shares),
      Stretched(transfer.y, opacities, shares) };
  }
  glm::dvec2& averaged = volume.AverageRange;
  if (first.x < first.y)
  {
    const glm::dvec2& shares = volume.ScalarRanges.front();
    averaged = { Stretched(averaged.x, first, shares), Stretched(averaged.y, first, shares) };
  }
  else if (averaged.x <= first.x && first.x <= averaged.y)
  {
    averaged = { -infinity, infinity };
  }
  else
  {
    averaged = { infinity, infinity };
  }
}

}
